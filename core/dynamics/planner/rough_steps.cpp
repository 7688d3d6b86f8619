// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/planner/rough_steps.h"

#include "core/dynamics/system/frame.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace esm {

bool RoughSteps::stretch(MotionState& state, double end, StepReport& report)
{
  const Run result = m_control.mayTakeBlocks() ? byBlocks(state, end, report) : byDescent(state, end, report);
  if (result != Run::Done) return m_control.giveUp(result, report), false;
  if (m_control.time.refuge > 0 && --m_control.time.refuge == 0) m_control.reconsider();
  return true;
}

void RoughSteps::followHand()
{
  const std::vector<ToolSpring>& tools = m_control.system->tools();
  TimeKeeping& time = m_control.time;
  const auto moves = [](const ToolSpring& tool) { return tool.isLed(); };
  const bool leads = !tools.empty() && (time.handLeads || std::any_of(tools.begin(), tools.end(), moves));
  if (std::exchange(time.handLeads, leads) == leads || !m_control.request.settings.keepsTime) return;
  time.blocksSuffice = m_control.request.settings.tolerance >= m_control.policy.choice.looseTolerance;
  const Policy::Rough& policy = m_control.policy.rough;
  m_untilCheck = m_checkGap > policy.checkGap ? m_checkGap : policy.secondBlock;
  m_control.weighLeastCost();
}

/// By a method that gains no energy and errs as it may; what was learned of the present one stays.
Run RoughSteps::run(Method method, MotionState& state, double end, std::int64_t steps, StepReport& report)
{
  StepControl& control = m_control;
  state.loss += control.closeLoss(state);
  control.methods.layOut(method);
  const Method other = std::exchange(control.choice.method, method);
  control.current().takeLocalError(); // of what was broken off
  const Run result = control.run(state, end, steps, report);
  control.choice.method = other;
  control.methods.restart(other);
  control.rhythm.anew();
  if (result == Run::Done) {
    report.rough = true;
    m_local = control.gauge.rmsOfWhole(control.methods.at(method).takeLocalError());
    control.keep(state, control.expectedError(state), error());
  }
  return result;
}

/// A few damped steps that gain no energy.
Run RoughSteps::byDescent(MotionState& state, double end, StepReport& report)
{
  const Policy::Rough& policy = m_control.policy.rough;
  const double length = end - state.time;
  const Method descent = m_control.methods.descent();
  m_control.system->workLimit = m_control.stepper.mostWork();
  m_control.methods.layOut(descent);
  const double stepCost = m_control.methods.stepCost(descent, length);
  const double affordable = policy.effortOfRun * m_control.effort() * length / kFrame / stepCost;
  const auto steps = static_cast<std::int64_t>(std::clamp(affordable, 1.0, policy.mostDescentSteps));
  const Run result = run(descent, state, end, steps, report);
  say(descent,
      "; as no step was both good and affordable, it takes damped steps that gain no energy: lower the "
      "stiffness or the loads, raise the masses, or allow more effort");
  return result;
}

/// One such step, or some where the effort pays for them, with as many sweeps as it pays for: what keeps time.
/// Now and then it is checked by twice as many steps, so that its error can be told.
Run RoughSteps::byBlocks(MotionState& state, double end, StepReport& report)
{
  StepControl& control = m_control;
  const Policy::Rough& policy = control.policy.rough;
  const Method blocks = control.methods.blocks();
  const double affordable =
    std::max(control.effort() * (end - state.time) / kFrame, policy.leastPasses * control.springs());
  control.methods.layOut(blocks);
  const double stepCost = control.methods.stepCost(blocks, end - state.time);
  const double most =
    control.time.refuge > 0 ? 1.0 : policy.mostBlocks; // what the effort pays for takes too long
  const auto steps =
    static_cast<std::int64_t>(std::clamp(policy.effortOfRun * affordable / stepCost, 1.0, most));
  state.loss += control.closeLoss(state);
  const double lost = state.loss;
  const bool wasRough = report.rough;
  const ErrorScale scale = control.gauge.scale();
  control.system->workLimit = std::min(control.stepper.mostWork(), control.system->workDone() + affordable);
  const Run result = run(blocks, state, end, steps, report);
  --m_untilCheck;
  // What shorter steps have told is not true of longer ones.
  if (2 * steps <= m_checkedSteps && m_untilCheck <= policy.checkGap - policy.leastCheckGap) m_untilCheck = 0;
  if (result == Run::Done && m_untilCheck <= 0 && !control.system->isInterrupted())
    check(steps, affordable, lost, state, end, scale, report);
  report.rough = wasRough || !areBlocksWithin();
  say(blocks, "; to keep time, it takes a few damped steps for each frame, whose error is told");
  return result;
}

/// The stretch once more by twice as many steps, which are kept if there is time for them.
/// @param lost  before it [J] @param scale  before it
void RoughSteps::check(std::int64_t steps, double affordable, double lost, MotionState& state, double end,
                       const ErrorScale& scale, StepReport& report)
{
  StepControl& control = m_control;
  const MotionState coarse = state;
  const ErrorScale coarseScale = control.gauge.scale();
  const double local = m_local;
  const std::vector<Stretch> stretches = control.stepper.recorded();
  m_checkedSteps = steps;
  state = control.start; // same size: no allocation
  state.loss = lost;
  control.gauge.setScale(scale);
  control.system->workLimit =
    std::min(control.stepper.mostWork(), control.system->workDone() + 2.0 * affordable);
  const Run result = run(control.methods.blocks(), state, end, 2 * steps, report);
  if (result != Run::Done || control.system->isInterrupted()) {
    // That was for nothing: who keeps no time without checks gets none with them.
    m_checkGap = m_untilCheck = std::min(2 * m_checkGap, control.policy.rough.mostCheckGap);
    state = coarse;
    control.stepper.putBack(stretches);
    control.gauge.setScale(coarseScale);
    report.rejectedSteps += 2 * steps;
    return;
  }
  m_checkGap = m_untilCheck = control.policy.rough.checkGap;
  learn(control.policy.rough.blocksErr * control.gauge.distance(coarse.x, state), local);
  control.gauge.setScale(scale);
  control.keep(state, control.expectedError(state), error());
  report.rejectedSteps += steps;
  if (control.time.isLedByBlocks() &&
      !areBlocksWithin()) { // where plain steps can be paid for, they err less
    control.time.blocksSuffice = false;
    control.weighLeastCost();
  }
}

/// What of the local errors of such a step is left at its end, as a check has found. What is more than they say comes
/// from sweeps that were too few, and lives on in the steps that follow.
/// @param error  of the step, @param local  the same by the step itself [m]
void RoughSteps::learn(double error, double local) noexcept
{
  const double found = error / local;
  if (!std::isfinite(found) || !(found > 0.0)) return;
  m_overLocal = std::min(found, 1.0);
  m_unsweptOverLocal = std::max(found - 1.0, 0.0);
  m_unswept = std::max(error - local, 0.0);
}

double RoughSteps::error() const noexcept
{
  return m_overLocal * m_local + std::min(m_unsweptOverLocal * m_local, m_unswept);
}

/// Whether what blocks are told to err is no more than may be.
bool RoughSteps::areBlocksWithin() const noexcept
{
  const ErrorScale& scale = m_control.gauge.scale();
  return scale.beyond <= m_control.request.settings.tolerance * scale.displacement;
}

void RoughSteps::say(Method method, const char* why)
{
  m_control.explain();
  m_control.reasons.setName(method);
  m_control.reasons.add(why);
}

} // namespace esm
