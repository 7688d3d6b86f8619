// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/methods/integrator.h"
#include "core/dynamics/solver_settings.h"
#include "core/forces/spring_pass.h"

#include <array>

namespace esm {

std::span<const IntegratorEntry> integratorTable() noexcept
{
  using enum MethodRole;
  static constexpr std::array table{
    IntegratorEntry{
      "leapfrog",
      "leapfrog (staggered symplectic Euler), explicit, one force pass per step and short viscous "
      "ones where viscosity would limit it; second order",
      &makeLeapfrog, Explicit, 4e-2},
    IntegratorEntry{"chebyshev", "the same with more viscous stages: second order in viscosity too",
                    &makeChebyshev, Explicit, 1e-2, 0.5, 0.0, "stoermer3"},
    IntegratorEntry{"stoermer3", "the same by Stoermer's rule of third order, which keeps waves in phase",
                    &makeStoermer3, Explicit, 3e-3, 0.7, 3e-4},
    IntegratorEntry{"verlet",
                    "velocity Verlet: second order in viscosity too, explicit, one force pass per step",
                    &makeVerlet, Explicit, 1.5e-3},
    IntegratorEntry{
      "stoermer",
      "Stoermer's multistep method: fourth order, explicit, one force pass per step, and viscous "
      "forces once more where they would limit it",
      &makeStoermer, Explicit, 2e-5},
    IntegratorEntry{"rk4", "classical Runge-Kutta: fourth order, explicit, four force passes per step",
                    &makeRungeKutta4, ExplicitByName, 1e-4},
    IntegratorEntry{"dopri5",
                    "Dormand-Prince: fifth order, explicit, six force passes per step; small errors",
                    &makeDormandPrince, ExplicitByName, 1e-5},
    IntegratorEntry{"implicit",
                    "TR-BDF2: second order, implicit with sparse Cholesky, stable at any step; stiff nets",
                    &makeImplicit, Implicit},
    IntegratorEntry{
      "lie", "linearised implicit Euler (Baraff and Witkin): one linear system a step, first order, bounded",
      &makeLinearized, ByName},
    IntegratorEntry{
      "descent",
      "implicit Euler by descent on its incremental potential: gains no energy, whatever net and step",
      &makeDescent, ByName},
    IntegratorEntry{"block-descent",
                    "the same without a factor: every node descends by its own block, in conjugate "
                    "directions; a frame at a time, for the hand",
                    &makeBlockDescent, ByName},
    IntegratorEntry{
      "multirate",
      "velocity Verlet with each spring at its own rate: nets with a few stiff springs or light nodes",
      &makeMultirate, Local, 1e-3},
    IntegratorEntry{"wavefront",
                    "the propagation of 1999: from the greatest force outward layer by layer, first order",
                    &makeWavefront, ByName},
    IntegratorEntry{"relax",
                    "to the energy minimum in each interval, then on in time: no inertia, slow hands only",
                    &makeRelax, ByName},
  };
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
