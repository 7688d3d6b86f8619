// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/planner/stepper.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace esm {

void Stepper::beginCall(std::int64_t maxSteps, double mostWork) noexcept
{
  m_maxSteps = maxSteps;
  m_mostWork = mostWork;
}

double Stepper::workDone(const System& system, const StepReport& report) noexcept
{
  const auto springs = static_cast<double>(std::max<std::int64_t>(system.forces().activeSprings(), 1));
  return std::max(system.workDone(), static_cast<double>(report.steps) * springs);
}

bool Stepper::isSpent(const System& system, const StepReport& report) const noexcept
{
  return !(workDone(system, report) < m_mostWork) || system.isInterrupted();
}

double Stepper::takePasses() noexcept
{
  return std::exchange(m_passes, 0.0);
}

/// How many steps of this length the limits of work leave.
std::int64_t Stepper::stepsLeft(Integrator& method, const System& system, double step,
                                const StepReport& report) const
{
  constexpr double kMany = 1e15;
  const double springs = static_cast<double>(std::max<std::int64_t>(system.forces().activeSprings(), 1));
  const double work = m_mostWork - workDone(system, report);
  const double left = std::floor(work / std::max(method.stepCost(system, step), springs));
  const auto steps = static_cast<std::int64_t>(std::clamp(left, 0.0, kMany));
  return m_maxSteps > 0 ? std::clamp<std::int64_t>(m_maxSteps - report.steps, 0, steps) : steps;
}

StepResult Stepper::runInPieces(Integrator& method, System& system, MotionState& state, double end,
                                std::int64_t steps, StepReport& report)
{
  if (!system.mayBeInterrupted()) return method.run(system, state, end, steps, report);
  const double begin = state.time, h = (end - begin) / static_cast<double>(steps);
  const double piece = std::floor(Budget::kPiece / std::max(method.stepCost(system, h), 1.0));
  for (std::int64_t done = 0; done < steps;) {
    if (system.isInterrupted()) return StepResult::NotConverged;
    const std::int64_t more = std::min(steps - done, static_cast<std::int64_t>(std::max(piece, 1.0)));
    done += more;
    const double pieceEnd = done == steps ? end : begin + static_cast<double>(done) * h;
    if (const StepResult result = method.run(system, state, pieceEnd, more, report);
        result != StepResult::Done)
      return result;
  }
  return StepResult::Done;
}

/// Descents damp only what their frames of reference leave them.
StepResult Stepper::runInFrames(Integrator& method, System& system, MotionState& state, double end,
                                std::int64_t steps, StepReport& report)
{
  const double begin = state.time, h = (end - begin) / static_cast<double>(steps), limit = system.workLimit;
  StepResult result = StepResult::Done;
  for (std::int64_t i = 1; i <= steps && result == StepResult::Done; ++i) {
    const double stepEnd = i < steps ? begin + static_cast<double>(i) * h : end;
    system.workLimit = system.shareOfWork(limit, steps - i + 1);
    m_bodies.enterFrame(system, state, stepEnd);
    result = method.run(system, state, stepEnd, 1, report);
    system.workLimit = limit;
    m_bodies.leaveFrame(system, state);
    m_bodies.keep(system, state, h);
  }
  return result;
}

/// A run that begins where others did takes their place: they were taken back.
void Stepper::note(double begin, double end, std::int64_t steps, std::string_view method)
{
  while (!m_stretches->empty() && m_stretches->back().begin >= begin) m_stretches->pop_back();
  m_stretches->push_back({begin, end, steps, std::string(method)});
}

Run Stepper::run(const Runner& runner, System& system, MotionState& state, double end, std::int64_t steps,
                 StepReport& report)
{
  Integrator& method = *runner.integrator;
  const double begin = state.time, h = (end - begin) / static_cast<double>(steps);
  const std::int64_t allowed = stepsLeft(method, system, h, report);
  const bool isLimited = allowed < steps;
  if (isLimited && allowed == 0) return Run::Limit;
  const double runEnd = isLimited ? begin + static_cast<double>(allowed) * h : end;
  const bool isInFrame = method.brakesBodies() && !m_bodies.isEmpty();
  const std::int64_t count = std::min(allowed, steps);
  const StepResult result = isInFrame ? runInFrames(method, system, state, runEnd, count, report)
                                      : runInPieces(method, system, state, runEnd, count, report);
  if (m_bodies.keep(system, state, state.time - begin)) method.restart();
  if (result == StepResult::NonFinite) return Run::NonFinite;
  if (result == StepResult::NotConverged) return isSpent(system, report) ? Run::Limit : Run::NotConverged;
  if (m_stretches) note(begin, runEnd, count, runner.name);
  if (isLimited)
    return run(runner, system, state, end, steps - allowed, report); // what they cost was a guess
  report.smallestStep = report.smallestStep > 0.0 ? std::min(report.smallestStep, h) : h;
  const double passes =
    runner.isImplicit ? 1.0 : method.stepCost(system, h) / std::max(system.forces().passCost(), 1.0);
  m_passes += static_cast<double>(steps) * passes;
  return Run::Done;
}

} // namespace esm
