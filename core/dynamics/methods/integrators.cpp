// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/methods/integrator.h"
#include "core/dynamics/solver_settings.h"
#include "core/forces/spring_pass.h"

#include <array>

namespace esm {

#define METHOD(make, ...) std::unique_ptr<Integrator> make();
#include "core/dynamics/methods/methods.inc"
#undef METHOD

std::span<const IntegratorEntry> integratorTable() noexcept
{
  using enum MethodRole;
#define METHOD(make, name, description, ...) IntegratorEntry{name, description, &make, __VA_ARGS__},
  static constexpr std::array table{
#include "core/dynamics/methods/methods.inc"
  };
#undef METHOD
  return table;
}

std::unique_ptr<Integrator> makeIntegrator(std::string_view name)
{
  for (const IntegratorEntry& entry : integratorTable())
    if (entry.name == name) return entry.make();
  return nullptr;
}

StepResult Integrator::run(System& system, MotionState& state, double end, std::int64_t steps,
                           StepReport& report)
{
  const double begin = state.time, h = (end - begin) / static_cast<double>(steps);
  for (std::int64_t i = 1; i <= steps; ++i) {
    const double stepEnd = i == steps ? end : begin + static_cast<double>(i) * h;
    if (system.isExhausted()) return StepResult::NotConverged;
    StepResult result = step(system, state, h, stepEnd, report);
    for (int parts = 4; result == StepResult::NotConverged && parts <= 256 && !system.isExhausted();
         parts *= 4) {
      ++report.rejectedSteps;
      const double from = state.time, part = (stepEnd - from) / parts;
      for (int j = 1; j <= parts; ++j) {
        result = step(system, state, part, j == parts ? stepEnd : from + j * part, report);
        if (result != StepResult::Done) break;
      }
    }
    if (result != StepResult::Done) return result;
  }
  return StepResult::Done;
}

namespace {

/// 0, or NaN if a number is not finite: 0 times infinity is NaN, too.
ESM_CPU_CLONES double probe(std::size_t count, const Lanes* x, const Lanes* v) noexcept
{
  Lanes sum = {0, 0, 0, 0};
  for (std::size_t i = 0; i < count; ++i) sum += x[i] * 0.0 + v[i] * 0.0;
  return sumLanes(sum);
}

} // namespace

bool allFinite(const NodeArray& x, const NodeArray& v) noexcept
{
  return probe(x.size(), x.data(), v.data()) == 0.0;
}

std::vector<SolverInfo> solverNames()
{
  std::vector<SolverInfo> names;
  for (const IntegratorEntry& entry : integratorTable())
    names.push_back({std::string(entry.name), std::string(entry.description)});
  return names;
}

} // namespace esm
