// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// The part of StepDriver that lets a method run, within the limits of work, and leaves free bodies where they
// belong.
#include "core/dynamics/planner/step_driver.h"

#include <algorithm>
#include <cmath>

namespace esm {

double StepDriver::workDone(const System& system, const StepReport& report) const noexcept
{
  const auto springs = static_cast<double>(std::max<std::int64_t>(system.forces().activeSprings(), 1));
  return std::max(system.workDone(), static_cast<double>(report.steps) * springs);
}

/// How many steps of this length the limits of work leave.
std::int64_t StepDriver::stepsLeft(const System& system, double step, const StepReport& report)
{
  constexpr double kMany = 1e15;
  const double springs = static_cast<double>(std::max<std::int64_t>(system.forces().activeSprings(), 1));
  const double work = m_mostWork - workDone(system, report);
  const double left = std::floor(work / std::max(current().stepCost(system, step), springs));
  const auto steps = static_cast<std::int64_t>(std::clamp(left, 0.0, kMany));
  return m_maxSteps > 0 ? std::clamp<std::int64_t>(m_maxSteps - report.steps, 0, steps) : steps;
}

/// A run that may be called away goes in pieces, each of which ends in a good state.
StepResult StepDriver::runInPieces(Integrator& method, System& system, MotionState& state, double end,
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
StepResult StepDriver::runInFrames(System& system, MotionState& state, double end, std::int64_t steps,
                                   StepReport& report)
{
  const double begin = state.time, h = (end - begin) / static_cast<double>(steps), limit = system.workLimit;
  StepResult result = StepResult::Done;
  for (std::int64_t i = 1; i <= steps && result == StepResult::Done; ++i) {
    const double stepEnd = i < steps ? begin + static_cast<double>(i) * h : end;
    system.workLimit = system.shareOfWork(limit, steps - i + 1);
    m_bodies.enterFrame(system, state, stepEnd);
    result = current().run(system, state, stepEnd, 1, report);
    system.workLimit = limit;
    m_bodies.leaveFrame(system, state);
    m_bodies.keep(system, state, h);
  }
  return result;
}

/// A run that begins where others did takes their place: they were taken back.
void StepDriver::note(double begin, double end, std::int64_t steps)
{
  while (!m_stretches->empty() && m_stretches->back().begin >= begin) m_stretches->pop_back();
  m_stretches->push_back({begin, end, steps, std::string(integratorTable()[m_method].name)});
}

StepDriver::Run StepDriver::run(System& system, MotionState& state, double end, std::int64_t steps,
                                StepReport& report)
{
  const double begin = state.time, h = (end - begin) / static_cast<double>(steps);
  const std::int64_t allowed = stepsLeft(system, h, report);
  const bool isLimited = allowed < steps;
  if (isLimited && allowed == 0) return Run::Limit;
  const double runEnd = isLimited ? begin + static_cast<double>(allowed) * h : end;
  const bool isInFrame = current().brakesBodies() && !m_bodies.isEmpty();
  const std::int64_t count = std::min(allowed, steps);
  const StepResult result = isInFrame ? runInFrames(system, state, runEnd, count, report)
                                      : runInPieces(current(), system, state, runEnd, count, report);
  if (m_bodies.keep(system, state, state.time - begin)) current().restart();
  if (result == StepResult::NonFinite) return Run::NonFinite;
  if (result == StepResult::NotConverged)
    return workDone(system, report) < m_mostWork && !system.isInterrupted() ? Run::NotConverged : Run::Limit;
  if (m_stretches) note(begin, runEnd, count);
  if (isLimited) return run(system, state, end, steps - allowed, report); // what they cost was a guess
  report.smallestStep = report.smallestStep > 0.0 ? std::min(report.smallestStep, h) : h;
  m_sinceBound += static_cast<double>(steps) * passesOf(system, h);
  return Run::Done;
}

} // namespace esm
