// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// Stretches whose tolerance is given up: by damped steps that gain no energy, whose error is told.
#include "core/dynamics/planner/step_driver.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace esm {
namespace {

constexpr double kMostDescentSteps = 16.0; ///< of one stretch
constexpr double kMostBlocks = 4.0;        ///< the same of steps by blocks

} // namespace

/// By a method that gains no energy and errs as it may; what was learned of the present one stays.
StepDriver::Run StepDriver::runRoughly(Method method, System& system, MotionState& state, double end,
                                       std::int64_t steps, StepReport& report)
{
  state.loss += closeLoss(system, state);
  layOut(method, system);
  const Method other = std::exchange(m_method, method);
  m_candidates[method].integrator->takeLocalError(); // of what was broken off
  const Run result = run(system, state, end, steps, report);
  m_method = other;
  if (m_candidates[m_method].prepared) current().restart();
  m_untilCheck = 0;
  m_checkGap = 1;
  if (result == Run::Done) {
    report.rough = true;
    m_roughLocal = m_gauge.rmsOfWhole(m_candidates[method].integrator->takeLocalError());
    keep(system, state, expectedError(state), roughError());
  }
  return result;
}

/// What always succeeds.
bool StepDriver::stretchRoughly(System& system, MotionState& state, double end, StepReport& report)
{
  const Run result = mayTakeBlocks(system) ? stretchByBlocks(system, state, end, report)
                                           : stretchByDescent(system, state, end, report);
  if (result != Run::Done) return giveUp(system, result, report), false;
  if (m_descents > 0 && --m_descents == 0) reconsider(system);
  return true;
}

/// A few damped steps that gain no energy.
StepDriver::Run StepDriver::stretchByDescent(System& system, MotionState& state, double end,
                                             StepReport& report)
{
  const double length = end - state.time;
  system.workLimit = m_mostWork;
  layOut(m_descent, system);
  const double stepCost = m_candidates[m_descent].integrator->stepCost(system, length);
  const double affordable = 0.5 * effort(system) * length / kFrame / stepCost;
  const auto steps = static_cast<std::int64_t>(std::clamp(affordable, 1.0, kMostDescentSteps));
  const Run result = runRoughly(m_descent, system, state, end, steps, report);
  sayRough(m_descent,
           "; as no step was both good and affordable, it takes damped steps that gain no energy: lower the "
           "stiffness or the loads, raise the masses, or allow more effort");
  return result;
}

/// One such step, or some where the effort pays for them, with as many sweeps as it pays for: what keeps time.
/// Now and then it is checked by twice as many steps, so that its error can be told.
StepDriver::Run StepDriver::stretchByBlocks(System& system, MotionState& state, double end,
                                            StepReport& report)
{
  constexpr double kLeastPasses = 12.0; // a matrix, two looks and some sweeps
  const double springs = static_cast<double>(system.forces().activeSprings());
  const double affordable = std::max(effort(system) * (end - state.time) / kFrame, kLeastPasses * springs);
  layOut(m_blocks, system);
  const double stepCost = m_candidates[m_blocks].integrator->stepCost(system, end - state.time);
  const bool wasBrokenOff = m_descents > 0; // what the effort pays for takes too long
  const double most = wasBrokenOff ? 1.0 : kMostBlocks;
  const auto steps = static_cast<std::int64_t>(std::clamp(0.5 * affordable / stepCost, 1.0, most));
  state.loss += closeLoss(system, state);
  const double lost = state.loss;
  const bool wasRough = report.rough;
  const ErrorScale scale = m_gauge.scale();
  const auto run = [&](int finer) {
    system.workLimit = std::min(m_mostWork, system.workDone() + finer * affordable);
    return runRoughly(m_blocks, system, state, end, finer * steps, report);
  };
  const Run result = run(1);
  --m_untilRoughCheck;
  // What shorter steps have told is not true of longer ones.
  if (2 * steps <= m_checkedSteps && m_untilRoughCheck <= kRoughCheckGap - kLeastRoughGap)
    m_untilRoughCheck = 0;
  if (result == Run::Done && m_untilRoughCheck <= 0 && !system.isInterrupted()) {
    const MotionState coarse = state;
    const ErrorScale coarseScale = m_gauge.scale();
    const double local = m_roughLocal;
    const std::vector<Stretch> stretches = m_stretches ? *m_stretches : std::vector<Stretch>();
    m_checkedSteps = steps;
    state = m_start; // same size: no allocation
    state.loss = lost;
    m_gauge.setScale(scale);
    if (run(2) == Run::Done && !system.isInterrupted()) {
      learnRough(2.0 * m_gauge.distance(coarse.x, state), local);
      m_gauge.setScale(scale);
      keep(system, state, expectedError(state), roughError());
      report.rejectedSteps += steps;
      m_roughCheckGap = kRoughCheckGap;
      if (isLedByBlocks() && !areBlocksWithin()) { // where plain steps can be paid for, they err less
        m_blocksSuffice = false;
        weighLeastCost(system);
      }
    } else { // that was for nothing: who keeps no time without checks gets none with them
      m_roughCheckGap = std::min(2 * m_roughCheckGap, kMostRoughGap);
      state = coarse;
      if (m_stretches) *m_stretches = stretches;
      m_gauge.setScale(coarseScale);
      report.rejectedSteps += 2 * steps;
    }
    m_untilRoughCheck = m_roughCheckGap;
  }
  report.rough = wasRough || !areBlocksWithin();
  sayRough(m_blocks, "; to keep time, it takes a few damped steps for each frame, whose error is told");
  return result;
}

/// What of the local errors of such a step is left at its end, as a check has found. What is more than they say comes from
/// sweeps that were too few, and lives on in the steps that follow.
/// @param error  of the step, @param local  the same by the step itself [m]
void StepDriver::learnRough(double error, double local) noexcept
{
  const double found = error / local;
  if (!std::isfinite(found) || !(found > 0.0)) return;
  m_roughOverLocal = std::min(found, 1.0);
  m_unsweptOverLocal = std::max(found - 1.0, 0.0);
  m_unswept = std::max(error - local, 0.0);
}

double StepDriver::roughError() const noexcept
{
  return m_roughOverLocal * m_roughLocal + std::min(m_unsweptOverLocal * m_roughLocal, m_unswept);
}

} // namespace esm
