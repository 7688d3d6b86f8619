// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/planner/controlled_steps.h"

#include "core/dynamics/system/frame.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace esm {

void ControlledSteps::begin(const MotionState& state)
{
  m_ends.x = m_ends.v = m_ends.look.x = state.x;
  m_probing.makeRoom(state);
}

double ControlledSteps::longestCheck()
{
  return esm::longestCheck(m_control.policy, m_control.observe(), m_control.known, m_control.methods,
                           m_control.choice);
}

double ControlledSteps::longest(bool isByBlocks)
{
  if (m_control.rhythm.onset() > 0.0) return m_control.rhythm.onset();
  return m_control.rhythm.isDue() && !isByBlocks ? longestCheck() : kFrame;
}

/// What is known before the first stretches after an event.
void ControlledSteps::rememberBeforeOnset()
{
  if (m_control.rhythm.onset() > 0.0 || m_control.gauge.scale().calm > m_control.policy.choice.latestOnset)
    return;
  m_onset.method = m_control.choice.method;
  for (Method method = 0; method < m_onset.known.size(); ++method)
    m_onset.known[method] = m_control.known.of(method);
}

/// Doubles its length, looks at each, and ends the onset with what had been measured
/// before. If that was nothing, other methods are given the benefit of the guess again: what they seemed to
/// err in the onset kept tubes on a dear method for good, three hundred times below what it might err.
void ControlledSteps::continueOnset()
{
  StepControl& control = m_control;
  if (control.rhythm.onset() <= 0.0) return;
  control.rhythm.setOnset(control.policy.onset.growth * control.rhythm.onset());
  control.rhythm.atOnce();
  if (control.rhythm.onset() < kFrame) return;
  control.rhythm.setOnset(0.0);
  if (control.isImplicit()) return;
  control.choice.settled = 0;
  const Method present = control.choice.method;
  if (!m_onset.known[m_onset.method].isMeasured) { // what failed was a guess
    const Expectation expected = control.weigh([](Weighing weighing) { return weighing.expectation(); });
    for (Method method = 0; method < control.methods.count(); ++method)
      if (method != present && control.methods.traits(method).role == MethodRole::Explicit)
        control.known.guessAtLeast(method, control.methods, expected);
    return;
  }
  for (Method method = 0; method < control.methods.count(); ++method)
    static_cast<KnownSteps&>(control.known.of(method)) = m_onset.known[method];
  control.rhythm.oftenFromNow();
  if (present == m_onset.method) return;
  control.use(m_onset.method);
  control.known.of(m_onset.method).isMeasured = true; // see above
  control.explain();
}

/// What `auto` may spend on the stretch.
void ControlledSteps::limitWork(double length)
{
  const Policy::Steps& policy = m_control.policy.steps;
  const double usual = policy.mostEffort * std::max(m_control.effort(), 2.0 * m_control.known.leastCost()) *
                       std::max(length / kFrame, policy.leastShare);
  if (m_control.rhythm.onset() <= 0.0) m_onset.affordable = usual; // it may begin here
  System& system = *m_control.system;
  system.workLimit =
    std::min(m_control.stepper.mostWork(), system.workDone() + std::clamp(m_onset.affordable, 0.0, usual));
}

ControlledSteps::Outcome ControlledSteps::stretch(MotionState& state, double end, StepReport& report)
{
  StepControl& control = m_control;
  double length = end - state.time;
  if (control.request.isAuto) limitWork(length);
  Run failure = Run::NotConverged;
  for (int attempt = 0; attempt < control.policy.steps.mostAttempts; ++attempt) {
    control.methods.layOut(control.choice.method); // who is chosen has no room before he runs
    const Plan planned = plan(control.policy, control.observe(), control.known, control.methods,
                              control.choice, length, control.rhythm.isDue(), attempt == 0);
    if (control.isTooDear(planned.work)) {
      if (!fallBackToPlain(length)) break;
      continue;
    }
    if (!(planned.count < control.policy.steps.mostSteps)) break;
    const double workBefore = control.system->workDone();
    Trial trial = tryOnce(planned, state, end, report);
    Verdict verdict = judge(control.policy, trial);
    if (verdict == Verdict::Again) {
      m_ends.coarseWork = control.system->workDone() - workBefore;
      trial = check(planned, state, end, report);
      verdict = judge(control.policy, trial);
    }
    switch (verdict) {
    case Verdict::Stop:
      stopAtLimit(state, report);
      return Outcome::Failed;
    case Verdict::KeepUnseen:
    case Verdict::KeepUnaffordable:
      keepUnchecked(planned, verdict, state, report);
      return Outcome::Done;
    case Verdict::Keep:
    case Verdict::KeepRough:
      keepChecked(planned, verdict, trial, state, report);
      return Outcome::Done;
    case Verdict::Shorter:
    case Verdict::Smaller:
      state = control.start;
      length = retry(verdict, planned, length, report);
      if (length < (1.0 - 1e-9) * (end - control.start.time))
        end = control.start.time + length; // no rest of rounding
      control.current().restart();
      continue;
    case Verdict::Retreat:
      failure = trial.result;
      retreat(state, attempt, length, report);
      continue;
    case Verdict::Again:
    case Verdict::Descend:
      break;
    }
    failure = trial.result == Run::Done ? Run::NotConverged : trial.result;
    break;
  }
  state = control.start;
  if (control.request.isAuto) {
    report.rejectedSteps += 1;
    return Outcome::NoneIsGood;
  }
  control.giveUp(failure, report);
  return Outcome::Failed;
}

/// The first run of a check keeps on its way where it was after an even number of steps, so that the
/// second run comes by at the same time.
Run ControlledSteps::runFirst(const Plan& plan, MotionState& state, double end, StepReport& report)
{
  const Policy::Checks& policy = m_control.policy.checks;
  CheckEnds::Look& look = m_ends.look;
  look.steps = 0; // a check that comes unforeseen has no look
  if (!plan.isChecked || plan.steps < policy.leastStepsForLook || state.x.size() < ErrorGauge::kFewNodes)
    return m_control.run(state, end, plan.steps, report);
  const double begin = state.time;
  const std::int64_t early = plan.steps / (2 * policy.lookShare) * 2;
  look.share = static_cast<double>(early) / static_cast<double>(plan.steps);
  look.time = begin + (end - begin) * look.share;
  const Run result = m_control.run(state, look.time, early, report);
  if (result != Run::Done) return result;
  look.steps = early;
  look.x = state.x;
  return m_control.run(state, end, plan.steps - early, report);
}

/// The second run: what is kept.
Run ControlledSteps::runAgain(const Plan& plan, MotionState& state, double end, StepReport& report)
{
  CheckEnds::Look& look = m_ends.look;
  if (look.steps == 0) return m_control.run(state, end, plan.finer, report);
  const double finer = m_control.policy.checks.finer;
  const auto early = static_cast<std::int64_t>(std::llround(finer * static_cast<double>(look.steps)));
  const Run result = m_control.run(state, look.time, early, report);
  if (result != Run::Done) return result;
  look.error = m_control.gauge.distance(look.x, state);
  return m_control.run(state, end, plan.finer - early, report);
}

/// Steps that nobody checks, once more and exactly, as they have gained energy.
Run ControlledSteps::repeatExactly(const Plan& plan, double solve, MotionState& state, double end,
                                   StepReport& report)
{
  StepControl& control = m_control;
  report.rejectedSteps += plan.steps;
  state = control.start;
  control.current().restart();
  control.current().setSolveTolerance(
    std::max(solve, control.policy.steps.repeatedSolve * control.gauge.extent()), false);
  const Run result = control.run(state, end, plan.steps, report);
  const bool isBad = result == Run::Done && control.energyAppeared(state, control.policy.energy.growth);
  return isBad ? Run::NotConverged : result;
}

Trial ControlledSteps::tryOnce(const Plan& plan, MotionState& state, double end, StepReport& report)
{
  StepControl& control = m_control;
  const Policy::Steps& policy = control.policy.steps;
  const double extent = control.gauge.extent();
  // An implicit solver measures over the nodes that it has.
  const double budget = control.gauge.budget(control.request.settings.tolerance, control.start, plan.length) *
                        control.gauge.shareOfWhole(state.x.size());
  const double solve = policy.solveShare * budget / plan.count;
  // What nobody checks needs no digits beyond what the eye can see.
  control.current().setSolveTolerance(
    std::max(solve, (plan.isUnchecked ? policy.coarseSolve : policy.exactSolve) * extent), plan.isUnchecked);
  if (plan.isChecked) control.current().mark(state.time);
  control.current().takeLocalError(); // of probes, and runs that failed
  Trial trial;
  trial.isAuto = control.request.isAuto;
  trial.isUnchecked = plan.isUnchecked;
  trial.result = runFirst(plan, state, end, report);
  control.rhythm.setLocalError(control.current().takeLocalError());
  if (plan.isUnchecked && trial.result == Run::Done &&
      control.energyAppeared(state, control.policy.energy.growth))
    trial.result = repeatExactly(plan, solve, state, end, report);
  if (trial.result != Run::Done && !plan.isUnchecked) // whoever asks may have to answer a clock
    trial.isExhausted = trial.isAuto && control.system->isExhausted();
  if (trial.result == Run::Done) {
    const bool isCheap = control.isImplicit() || plan.count >= policy.fewSteps || control.rhythm.isDue();
    trial.hasGained = trial.isAuto && !plan.isUnchecked &&
                      (isCheap || control.energy.hasQuickened(*control.system, control.start, state)) &&
                      control.energyAppeared(state, control.policy.energy.coarseGrowth);
    trial.isDue = !trial.hasGained && !plan.isUnchecked && isCheckDue(state);
    const double steps = static_cast<double>(2 * plan.steps);
    trial.isCheckPayable =
      trial.isDue && !control.isTooDear(steps * control.methods.stepCost(control.choice.method, plan.step));
  }
  trial.isOverdrawn = control.isTooDear(0.0);
  return trial;
}

/// In due time; or where the motion is twice as fast as ever, or has waves that err more than may be: errors
/// come from the fast waves that feed the dampers.
bool ControlledSteps::isCheckDue(const MotionState& state)
{
  const Policy::Checks& policy = m_control.policy.checks;
  const ErrorGauge& gauge = m_control.gauge;
  if (m_control.rhythm.isDue() || !(gauge.speedOf(state.v) <= policy.twiceAsFast * gauge.scale().topSpeed))
    return true;
  return m_control.expectedError(state) >
         policy.suspicious * m_control.budget(state, state.time - m_control.start.time);
}

/// The stretch is done again with finer steps: what the distance of the two ends tells.
Trial ControlledSteps::check(const Plan& plan, MotionState& state, double end, StepReport& report)
{
  StepControl& control = m_control;
  const double workBefore = control.system->workDone();
  m_ends.x = state.x;
  m_ends.v = state.v;
  m_ends.heat = state.heat - control.start.heat;
  state = control.start;
  control.current().rewind(state.time);
  Trial trial;
  trial.isSecond = true;
  trial.isAuto = control.request.isAuto;
  trial.result = runAgain(plan, state, end, report);
  m_ends.finerWork = control.system->workDone() - workBefore;
  trial.isOverdrawn = control.isTooDear(0.0);
  if (trial.result == Run::Done) learn(plan, state, trial);
  return trial;
}

/// What the first of a check's two runs has erred, as far as that goes on to count [m]; the second one ends
/// at `state`.
/// @param ratio  of the errors of the two
double ControlledSteps::errorOfFirst(const MotionState& state, double ratio)
{
  StepControl& control = m_control;
  const double apart = control.gauge.distance(m_ends.x, state), length = state.time - control.start.time;
  control.gauge.prepareSwing(*control.system, state);
  control.system->solverWork += control.policy.checks.prepareSwingCost * control.springs();
  if (m_ends.look.steps > 0)
    control.rhythm.setGrowing(
      control.gauge.growing(control.start.time, length, m_ends.look.error, apart, m_ends.look.share));
  const double counted =
    control.rhythm.growing() * addingUp(control, m_ends, control.choice.method, m_ends.x, m_ends.v, state);
  return counted * swing(control, apart, m_ends.v, state) * ratio / (ratio - 1.0);
}

/// Where every node is held or led, all steps end at the same places, and only the heat tells how coarse they are: what
/// the first of a check's runs erred of it, over what the tolerance allows. The velocities of staggered steps are older
/// than the places, so that this is of first order.
double ControlledSteps::shareOfHeat(const MotionState& state, double finer)
{
  const EnergyBalance balance = m_control.energyBalance(state);
  const double apart = std::abs(balance.heat - m_ends.heat) * finer / (finer - 1.0);
  if (apart <= m_control.policy.energy.rounding * balance.turnedOver) return 0.0;
  return apart / (m_control.request.settings.tolerance * balance.heat);
}

/// From the error of the steps to the accurate one, for the method and for those like it; and all that judge() asks.
void ControlledSteps::learn(const Plan& plan, const MotionState& state, Trial& trial)
{
  StepControl& control = m_control;
  const Policy::Checks& policy = control.policy.checks;
  const Method method = control.choice.method;
  const MethodTraits& traits = control.methods.traits(method);
  const double length = state.time - control.start.time;
  const double count = static_cast<double>(plan.steps), finer = static_cast<double>(plan.finer);
  const double ratio = std::pow(finer / count, traits.order); // of the errors
  const bool dampsWaves = !traits.isExplicit();
  const EnergyBalance balance = trial.isAuto || dampsWaves ? control.energyBalance(state) : EnergyBalance{};
  const double lost = dampsWaves ? EnergyGuard::lostWaves(*control.system, balance, length / finer) : 0.0;
  trial.count = plan.count;
  trial.step = length / count;
  trial.coarseError = std::max(errorOfFirst(state, ratio), lost);
  control.gauge.guessLifetime(*control.system, control.start, state);
  control.rhythm.learnOverLocal(trial.coarseError, length);
  trial.allowed = control.budget(state, length);
  const bool isLed = control.energy.isLedAllOver();
  if (isLed) trial.coarseError = trial.allowed * shareOfHeat(state, finer / count);
  trial.error = trial.coarseError / (isLed ? finer / count : ratio);
  trial.unspent = isLed ? 0.0 : control.gauge.unspent(control.request.settings.tolerance, state);
  trial.mostRough =
    policy.roughAtFloor * std::max(control.gauge.displacementOf(control.start.x), control.gauge.floor());
  trial.floorStep = control.weigh([&](Weighing weighing) { return weighing.floorStep(control.choice); });
  trial.isSane = !trial.isAuto || !control.energyAppeared(balance, control.policy.energy.coarseGrowth);
  // Where another attempt could not be paid for, this one must do.
  trial.isLast = control.isTooDear(policy.lastAttempt * count * control.methods.stepCost(method, trial.step));

  const double error = plan.isFromAbove ? trial.error : trial.coarseError;
  const double step = plan.isFromAbove ? length / finer : trial.step;
  trial.share = error / trial.allowed;
  const bool isFirst =
    control.gauge.scale().calm <= control.policy.choice.latestOnset && control.rhythm.onset() <= 0.0;
  const bool affordsMore =
    2.0 * control.known.leastCost() <= control.request.settings.effort; // else it is for plain steps
  trial.mayBeginOnset = trial.isAuto && isFirst && affordsMore;

  MethodKnowledge& known = control.known.of(method);
  control.known.learnOwn(method, control.methods, {trial.share, step});
  CheckRhythm::Found found;
  found.share = trial.share;
  found.error = std::min(error, trial.allowed); // the next step will not err more
  found.length = length;
  found.power = (state.heat - control.start.heat) / length;
  found.isHeld = trial.isAuto && !dampsWaves && control.controlledStep(kFrame) > policy.held * step;
  found.grows = policy.held * control.controlledStep(Stepper::kInfinity) > step;
  found.timeLeft = control.gauge.knownEnd(state.time) - state.time;
  control.rhythm.learn(found);
  if (isLed) control.rhythm.atOnce(); // nothing but checks sees what becomes of the heat between them
  if (!known.isMeasured && known.accurateStep < policy.promisedTooMuch * step) control.choice.settled = 0;
  control.known.learnOthers(method, control.methods, {trial.share, step});
  control.known.learnCost(method, control.methods, trial.step, m_ends.coarseWork, m_ends.finerWork);
}

void ControlledSteps::keepChecked(const Plan& plan, Verdict verdict, const Trial& trial, MotionState& state,
                                  StepReport& report)
{
  StepControl& control = m_control;
  const Method method = control.choice.method;
  const bool isRough = verdict == Verdict::KeepRough;
  control.rhythm.setRough(isRough);
  report.rough = report.rough || isRough;
  if (isRough) {
    control.explain();
    control.reasons.add("; the tolerance would cost too many steps and may not hold");
  }
  control.known.passCheck(control.rhythm.passCheck(control.start.time));
  std::optional<Method> proven;
  if (trial.isAuto && control.rhythm.onset() <= 0.0 &&
      trial.error <= control.policy.probes.shareToCompare * trial.allowed)
    proven = m_probing.probe(state, trial.allowed, report);
  control.keep(state, trial.error);
  control.reconsider(proven);
  control.bookLoss(state, method, plan.length / static_cast<double>(plan.finer));
}

/// The next step is larger where a check could not be paid for, until one can: else a wrong guess would hold for good.
void ControlledSteps::keepUnchecked(const Plan& plan, Verdict verdict, MotionState& state, StepReport& report)
{
  StepControl& control = m_control;
  const bool isDue = verdict == Verdict::KeepUnaffordable;
  if (isDue)
    control.known.of(control.choice.method).accurateStep = control.policy.checks.freshGrowth * plan.step;
  control.rhythm.pass();
  report.rough = report.rough || plan.isUnchecked || control.rhythm.isRough() || isDue;
  control.bookLoss(state, control.choice.method, plan.length / plan.count);
  control.keep(state, control.expectedError(state));
  if (plan.isUnchecked) control.reconsider();
}

/// After a check that failed. @return length of the next attempt [s]
double ControlledSteps::retry(Verdict verdict, const Plan& plan, double length, StepReport& report)
{
  StepControl& control = m_control;
  report.rejectedSteps += plan.steps + plan.finer;
  if (verdict == Verdict::Shorter) {
    length = length / control.policy.onset.parts;
    control.rhythm.setOnset(length);
  }
  control.choice.settled = 0;
  control.reconsider();
  return std::min(length, longestCheck()); // another method may take far more steps
}

/// Where a dearer method was on its way: plain steps at their limit, if these can be paid for.
bool ControlledSteps::fallBackToPlain(double length)
{
  StepControl& control = m_control;
  const Method plain = control.methods.plain();
  if (!control.request.isAuto || control.choice.method == plain || control.isImplicit()) return false;
  if (control.isTooDear(control.known.leastCost() * length / kFrame)) return false;
  control.use(plain);
  control.known.of(plain).accurateStep = control.methods.limit(plain);
  control.choice.settled = control.policy.choice.settlingAfterFallBack;
  control.explain();
  return true;
}

/// The work limit came in the middle of a stretch that nobody has checked. What has been done is kept, so
/// that limited calls get on too, unless energy came from nowhere: then the start of the stretch is the last
/// good state.
void ControlledSteps::stopAtLimit(MotionState& state, StepReport& report)
{
  StepControl& control = m_control;
  if (control.energyAppeared(state, control.policy.energy.growth)) {
    state = control.start;
    control.current().restart();
    control.known.of(control.choice.method).accurateStep =
      control.policy.steps.afterFailure * control.controlledStep(kFrame);
    control.rhythm.atOnce();
  }
  control.giveUp(Run::Limit, report);
}

/// After a failed run: back to the start of the stretch with a smaller step.
void ControlledSteps::retreat(MotionState& state, int attempt, double length, StepReport& report)
{
  StepControl& control = m_control;
  const Policy& policy = control.policy;
  ++report.rejectedSteps;
  const double tried = control.controlledStep(kFrame);
  state = control.start;
  const Method method = control.choice.method;
  MethodKnowledge& known = control.known.of(method);
  control.known.learnFailure(method, control.methods, tried);
  if (control.request.isAuto && known.affordableStep > known.accurateStep) { // there the effort would hold it
    if (fallBackToPlain(length)) {
      known.accurateStep = policy.steps.mostShrinking * tried;
      return;
    }
    known.affordableStep = known.accurateStep;
  }
  control.choice.floorStep = std::min(control.choice.floorStep, policy.steps.afterFailure * tried);
  control.rhythm.anew();
  if (control.request.isAuto && !control.isImplicit() && attempt >= policy.steps.attemptsUntilImplicit) {
    control.use(control.methods.implicit());
    control.choice.settled = policy.choice.settlingAfterRetreat;
    control.explain();
  }
  control.current().restart();
}

} // namespace esm
