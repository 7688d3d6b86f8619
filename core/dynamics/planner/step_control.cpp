// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/planner/step_control.h"

#include "core/dynamics/system/frame.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace esm {

void TimeKeeping::flee(int longest) noexcept
{
  refugeTerm = std::clamp(2 * refugeTerm, 1, longest);
  refuge = refugeTerm;
}

StepControl::StepControl(SolverSettings settings, std::vector<Index> nodeNames)
  : policy(settings.policy ? *settings.policy : kPolicy),
    request{std::move(settings)},
    known(policy),
    bound(policy, std::move(nodeNames)),
    gauge(policy),
    energy(policy),
    loss(policy),
    rhythm(policy)
{
  request.firstTolerance = request.settings.tolerance;
  request.firstEffort = request.settings.effort;
  request.isAuto = request.settings.solver == "auto";
  known.resize(methods.count());
  choice.method = MethodSet::find(request.settings.solver).value_or(0);
}

void StepControl::attach(System& to) noexcept
{
  system = &to;
  methods.setSystem(to);
}

Observation StepControl::observe() const
{
  const SolverSettings& settings = request.settings;
  Observation now;
  now.isAuto = request.isAuto;
  now.tolerance = settings.tolerance;
  now.effort = settings.effort;
  now.affordable = effort();
  now.asksForLess = settings.tolerance > request.firstTolerance || settings.effort < request.firstEffort;
  now.springs = springs();
  now.isDamped = bound.isDamped();
  now.fewHoldAll = bound.fewHoldAll();
  now.isByBlocks = time.isByBlocks;
  now.calm = gauge.scale().calm;
  now.isOnset = rhythm.onset() > 0.0;
  now.timeLeft = gauge.knownEnd(start.time) - start.time;
  now.lastingShare = gauge.lastingShare(settings.tolerance, start.time);
  now.typicalShare = gauge.typicalShare();
  now.leastCost = known.leastCost();
  return now;
}

double StepControl::controlledStep(double length)
{
  return weigh([&](Weighing weighing) { return weighing.controlledStep(choice, length); });
}

/// For a frame, that the work limit bears, too. What a tolerance may ask for is told by the former alone: it
/// may be had by other steps for less.
double StepControl::effort() const noexcept
{
  const SolverSettings& settings = request.settings;
  return settings.workLimit > 0.0 ? std::min(settings.effort, settings.workLimit * std::max(springs(), 1.0))
                                  : settings.effort;
}

void StepControl::look(const MotionState& state)
{
  bound.look(*system, state, request.isAuto);
  weighSteps();
}

void StepControl::lookIfDue(const MotionState& state)
{
  if (bound.isOld() && !takesBlocks()) return look(state);
  if (!doesBoundMatter()) return;
  if (bound.lookIfDue(*system, state, request.isAuto, isImplicit())) weighSteps();
}

void StepControl::replaceBound(const MotionState& state, bool now)
{
  if (now) return look(state);
  bound.setOld();
  weighSteps();
}

bool StepControl::doesBoundMatter() const noexcept
{
  return !time.isByBlocks ||
         (!time.isLedByBlocks() && known.leastCost() <= policy.rough.farBeyond * effort());
}

void StepControl::weighSteps()
{
  methods.tune(bound.mode());
  weighEffort();
  weighLeastCost();
}

void StepControl::weighEffort()
{
  weigh([&](Weighing weighing) {
    for (Method method = 0; method < methods.count(); ++method)
      if (methods.traits(method).isExplicit())
        known.of(method).affordableStep = weighing.affordableStep(method);
  });
}

/// What a net that keeps time is moved by depends on what plain steps cost, of which the rest is a multiple. Where a
/// hand leads it, blocks cost less whatever these do, as long as their error is within the tolerance.
void StepControl::weighLeastCost()
{
  const double plain = weigh([](Weighing weighing) { return weighing.plainCost(); });
  const double most = (time.isByBlocks ? policy.rough.back : 1.0) * effort();
  time.isByBlocks = mayTakeBlocks() && (time.isLedByBlocks() || plain > most);
  known.setLeastCost(weigh([](Weighing weighing) { return weighing.leastCost(); }));
}

void StepControl::use(Method method)
{
  choice.method = method;
  known.of(method).isMeasured = false; // a guess that fails says nothing about the others
  current().restart();
  rhythm.anew();
}

void StepControl::choose()
{
  if (request.isAuto) choice = weigh([](Weighing weighing) { return weighing.first(); });
  use(choice.method);
  explain();
}

void StepControl::reconsider(std::optional<Method> proven)
{
  if (!request.isAuto || (--choice.settled > 0 && !proven)) return;
  const Method before = choice.method;
  choice = weigh([&](Weighing weighing) { return weighing.reconsider(choice, proven); });
  if (choice.method == before) return;
  use(choice.method);
  choice.settled = policy.choice.settling;
  if (proven == choice.method) { // it need not prove itself twice
    known.of(choice.method).isMeasured = true;
    rhythm.afterProof();
  }
  explain();
}

void StepControl::explain()
{
  reasons.explain(choice, request.isAuto, methods, bound, methods.limit(methods.plain()));
}

/// A small net's factor costs less than a frame, and implicit steps err less: but not than what a hand leads, which
/// hardly swings.
bool StepControl::mayTakeBlocks() const noexcept
{
  return request.isAuto && request.settings.keepsTime &&
         (time.isLedByBlocks() || system->nodeCount() > policy.rough.fewNodes);
}

void StepControl::beginStretch(const MotionState& state)
{
  start = state; // same size: no allocation
  energy.beginStretch();
}

Run StepControl::run(MotionState& state, double end, std::int64_t steps, StepReport& report)
{
  const Stepper::Runner runner{&current(), MethodSet::nameOf(choice.method), isImplicit()};
  const Run result = stepper.run(runner, *system, state, end, steps, report);
  bound.spend(stepper.takePasses());
  return result;
}

double StepControl::budget(const MotionState& state, double length)
{
  const double counted = rhythm.onset() > 0.0 ? std::max(length, policy.onset.share * kFrame) : length;
  const double share = weigh([&](Weighing weighing) { return weighing.spendable(choice.method); });
  return share * gauge.budget(request.settings.tolerance, state, counted);
}

double StepControl::expectedError(const MotionState& state) const
{
  const double length = state.time - start.time;
  return rhythm.expectedError(length, (state.heat - start.heat) / length);
}

bool StepControl::energyAppeared(const EnergyBalance& balance, double share) noexcept
{
  return energy.hasAppeared(*system, balance, gauge.extent(), share);
}

bool StepControl::isTooDear(double work) const noexcept
{
  return request.isAuto && !(system->workDone() + work <= system->workLimit);
}

double StepControl::closeLoss(const MotionState& state)
{
  return loss.close(*system, state, request.settings.tolerance);
}

void StepControl::bookLoss(MotionState& state, Method method, double step)
{
  if (energy
        .isLedAllOver()) { // nothing can be lost: what the supports have done is what there is, and the heat
    const EnergyBalance balance = energyBalance(state);
    state.work += balance.gained + balance.heat;
    state.loss = start.loss;
    return loss.drop();
  }
  loss.book(*system, start, state, methods.at(method), step, energy, request.settings.tolerance);
}

void StepControl::keep(const MotionState& state, double error, double beyond)
{
  gauge.setScale(gauge.scaleAfter(*system, start, state, error, beyond));
  energy.keepStretch();
}

void StepControl::giveUp(Run failure, StepReport& report)
{
  const SolverSettings& settings = request.settings;
  if (failure == Run::Limit) {
    report.stepLimit = true;
    if (system->isInterrupted()) {
      report.interrupted = true;
      reasons.sayInterrupted(bound);
      // The time was over before the frame was: the next stretches take what always gets on.
      if (request.isAuto && settings.keepsTime && !time.isByBlocks) time.flee(policy.rough.longestDescent);
      return;
    }
    if (stepper.maxSteps() > 0 && report.steps >= stepper.maxSteps())
      reasons.sayStepLimit(stepper.maxSteps(), bound);
    else
      reasons.sayWorkLimit(settings.workLimit, bound);
  } else if (failure == Run::NonFinite) {
    report.nonFinite = true;
    const double own = current().stableStep(bound.mode());
    const double largest = std::isfinite(own) ? own : methods.limit(methods.plain());
    reasons.sayNonFinite(settings.fixedStep > 0.0 ? largest : 0.0, bound);
  } else {
    report.notConverged = true;
    reasons.sayNotConverged(bound);
  }
}

void StepControl::findBodies(const MotionState& state)
{
  energy.lookForFreeNodes(*system);
  stepper.bodies().find(*system);
  stepper.bodies().begin(*system, state);
}

} // namespace esm
