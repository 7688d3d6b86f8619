// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/planner/step_driver.h"

#include "core/dynamics/system/diagonal.h"
#include "core/dynamics/system/frame.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace esm {
namespace {

/// A length that positions are small or large against [m]: the net's diagonal, or how far its anchors pull.
double extentOf(const System& system, const NodeArray& x)
{
  double square = squareOfDiagonal(x);
  for (const ForceModel::Anchor& anchor : system.forces().anchors()) {
    const Lanes reach = anchor.point - x[static_cast<std::size_t>(anchor.node)];
    square = std::max(square, dot(reach, reach));
  }
  return square > 0.0 && std::isfinite(square) ? std::sqrt(square) : 1.0;
}

} // namespace

StepDriver::StepDriver(SolverSettings settings, std::vector<Index> names)
  : m_control(std::move(settings), std::move(names)), m_controlled(m_control), m_rough(m_control)
{}

void StepDriver::begin(System& system, const MotionState& state)
{
  StepControl& control = m_control;
  control.attach(system);
  control.bound.setPlaces({});
  control.beginStretch(state);
  if (system.nodeCount() <= System::kLarge) m_controlled.begin(state);
  const bool isDriven = !system.schedule().isEmpty() || !system.tools().empty();
  control.gauge.begin(state.x, extentOf(system, state.x), control.request.settings.duration, isDriven);
  const Lanes weight = system.nodeCount() > 0 ? system.forces().weight(0) : Lanes{0, 0, 0, 0};
  const bool staysPushed = !system.tools().empty() || dot(weight, weight) > 0.0;
  control.gauge.expectQuiet(staysPushed ? kInfinity : system.schedule().endOfBlows());
  if (control.request.isAuto)
    control.choice.method = control.methods.plain(); // a run after reset() is like the first
  parametersChanged(system, state);
  // What a look at the bound needs of a large net is a quarter of all its memory, and it may never move.
  if (system.nodeCount() > System::kLarge) control.bound.freeRoom();
}

void StepDriver::parametersChanged(System& system, const MotionState& state)
{
  StepControl& control = m_control;
  control.attach(system);
  control.methods.dropLayouts();
  control.rhythm.reset(state.time);
  control.time.refuge = control.time.refugeTerm = 0;
  control.energy.forget();
  control.rhythm.setOnset(0.0);
  control.choice = {control.choice.method};
  control.findBodies(state);
  control.bound.prepare(asksForDecay());
  control.loss.prepare(system);
  control.look(state);
  control.known.guessAll(control.methods,
                         control.weigh([](Weighing weighing) { return weighing.expectation(); }));
  control.choose();
}

void StepDriver::restart(System& system, const MotionState& state)
{
  m_control.attach(system);
  m_control.methods.restart();
  m_control.findBodies(state);
}

void StepDriver::toolsChanged(System& system, const MotionState& state, bool sameNodes)
{
  StepControl& control = m_control;
  control.attach(system);
  control.loss.drop(); // under other forces
  if (!system.tools().empty()) {
    control.gauge.markDriven();
    control.gauge.expectQuiet(kInfinity);
  }
  m_rough.followHand();
  if (sameNodes) return control.methods.toolsMoved(); // a moving hand: the checks go on in their rhythm
  control.methods.restart();
  control.findBodies(state);
  control.replaceBound(state, control.doesBoundMatter());
  control.rhythm.anew();
}

void StepDriver::partChanged(System& system, const MotionState& state, NetPart part)
{
  StepControl& control = m_control;
  control.attach(system);
  control.gauge.setPart(part.rest, part.wholeCount, part.squareElsewhere);
  control.bound.setPlaces(std::move(part.nodes));
  control.rhythm.setOnset(0.0);
  control.energy.forget(); // what a larger part had gained could be more than all that this one has
  control.methods.dropLayouts();
  control.findBodies(state);
  control.bound.prepare(asksForDecay());
  control.loss.prepare(system);
  control.replaceBound(state, !control.time.isByBlocks);
  control.weigh([&](Weighing weighing) {
    weighing.giveUpTolerance(control.choice,
                             control.choice.isToleranceGivenUp && weighing.isToleranceTooDear());
  });
  if (!control.time.isByBlocks)
    control.methods.layOut(control.choice.method); // nothing is, after another cut
  control.explain();
}

void StepDriver::setAccuracy(System& system, double tolerance, double effort)
{
  StepControl& control = m_control;
  control.attach(system);
  const double change = tolerance / control.request.settings.tolerance;
  control.request.settings.tolerance = tolerance;
  control.request.settings.effort = effort;
  if (control.request.settings.keepsTime) control.weighLeastCost();
  control.rhythm.setOnset(0.0);
  control.weighEffort();
  control.known.rescale(control.methods, change);
  control.rhythm.anew();
  control.rhythm.setRough(false);
  control.choice.settled = 0;
  const Method present = control.choice.method;
  const bool competes = control.request.isAuto && control.methods.traits(present).competes();
  if (competes && !control.weigh([&](Weighing weighing) { return weighing.isPayable(present); })) {
    control.use(control.weigh([&](Weighing weighing) { return weighing.cheapestExplicit(present, 1.0); }));
    control.explain();
  }
  if (!control.choice.isToleranceGivenUp) return;
  control.weigh([&](Weighing weighing) {
    control.choice.isToleranceGivenUp = false; // the floor is of the former effort
    weighing.giveUpTolerance(control.choice, weighing.isToleranceTooDear());
  });
  control.explain();
}

bool StepDriver::asksForDecay() const noexcept
{
  const MethodSet& methods = m_control.methods;
  if (!m_control.request.isAuto) return methods.at(m_control.choice.method).asksForDecay();
  for (Method method = 0; method < methods.count(); ++method)
    if (methods.traits(method).competes() && methods.at(method).asksForDecay()) return true;
  return false;
}

StepReport StepDriver::advance(System& system, MotionState& state, double interval, std::int64_t maxSteps,
                               double mostWork)
{
  StepControl& control = m_control;
  control.attach(system);
  StepReport report;
  control.reasons.beginCall();
  system.springsEvaluated = 0;
  system.solverWork = 0.0;
  system.workLimit = mostWork;
  control.stepper.beginCall(maxSteps, mostWork);
  const double begin = state.time;
  double end = begin + interval;
  while (state.time < end) {
    control.gauge.expectRelease(system.schedule().nextRelease());
    const double event = system.nextEvent(state.time);
    // An event a rounding error away from the end of the interval is the end.
    if (std::abs(event - end) <= 1e-9 * interval) end = event;
    const double target = std::min(event, end);
    if (control.stepper.isSpent(system, report)) {
      control.giveUp(Run::Limit, report);
      break;
    }
    m_controlled.continueOnset();
    const bool isFixed = control.request.settings.fixedStep > 0.0;
    const bool isByBlocks = takesBlocks() && control.mayTakeBlocks(); // these have checks of their own
    const double longest = isFixed ? kInfinity : m_controlled.longest(isByBlocks);
    const double stretches = isFixed ? 1.0 : wholeSteps(target - state.time, longest);
    const double stretchEnd = stretches > 1.0 ? state.time + (target - state.time) / stretches : target;
    const double workBefore = system.workDone();
    const bool done = isFixed ? stretchFixed(state, stretchEnd, report) : stretch(state, stretchEnd, report);
    m_controlled.spendOnset(system.workDone() - workBefore);
    if (!done) break;
    if (state.time == event) enterEvent(state);
  }
  report.simulatedTime = state.time - begin;
  report.springsEvaluated = system.springsEvaluated;
  report.largestForce = system.forces().largestTension(state.x.data(), state.v.data(), system.workers());
  return report;
}

void StepDriver::enterEvent(MotionState& state)
{
  StepControl& control = m_control;
  if (control.system->enter(state, false)) {
    control.methods.constraintsChanged();
    control.findBodies(state);
    control.rhythm.oftenFromNow();
    control.bound.hurry();
  } else {
    control.methods.restart(control.choice.method);
    control.stepper.bodies().enter(*control.system, state.time);
  }
  control.rhythm.atOnce();
  control.gauge.markEvent();
}

bool StepDriver::stretchFixed(MotionState& state, double end, StepReport& report)
{
  StepControl& control = m_control;
  const Method method = control.choice.method;
  control.methods.layOut(method); // before it is told anything
  control.lookIfDue(state);       // stages and predictions keep to what is stable now
  control.current().setSolveTolerance(control.policy.steps.solveFixed * control.gauge.extent(), false);
  const double length = end - state.time;
  const double steps = std::max(1.0, wholeSteps(length, control.request.settings.fixedStep));
  control.beginStretch(state);
  const Run result = control.run(state, end, static_cast<std::int64_t>(std::min(steps, 1e15)), report);
  if (result != Run::Done) return control.giveUp(result, report), false;
  control.bookLoss(state, method, length / steps);
  return true;
}

/// By a method that takes one step whatever the tolerance, and that nobody controls.
bool StepDriver::stretchAlone(MotionState& state, double end, StepReport& report)
{
  StepControl& control = m_control;
  control.methods.layOut(control.choice.method);
  control.current().setSolveTolerance(control.policy.steps.solveAlone * control.gauge.extent(), false);
  const Run result = control.run(state, end, 1, report);
  if (result != Run::Done) return control.giveUp(result, report), false;
  report.rough = report.rough || control.current().brakesBodies(); // nobody has measured its error
  control.keep(state, control.expectedError(state));
  return true;
}

bool StepDriver::stretch(MotionState& state, double end, StepReport& report)
{
  StepControl& control = m_control;
  control.lookIfDue(state);
  m_controlled.rememberBeforeOnset();
  control.beginStretch(state);
  control.rhythm.setLocalError(0.0);
  if (!control.request.isAuto && control.current().isUncontrolled()) return stretchAlone(state, end, report);
  if (control.request.isAuto && takesBlocks()) return m_rough.stretch(state, end, report);
  const ControlledSteps::Outcome outcome = m_controlled.stretch(state, end, report);
  if (outcome != ControlledSteps::Outcome::NoneIsGood) return outcome == ControlledSteps::Outcome::Done;
  control.time.flee(control.policy.rough.longestDescent);
  control.energy.takeBack();
  return m_rough.stretch(state, end, report);
}

double StepDriver::closeLoss(System& system, const MotionState& state)
{
  m_control.attach(system);
  return m_control.closeLoss(state);
}

FastestMode StepDriver::fastestMode(const System& system, const MotionState& state) const
{
  return m_control.bound.ask(system, state);
}

double StepDriver::explicitStep(const FastestMode& mode) const noexcept
{
  const MethodSet& methods = m_control.methods;
  const double own = methods.at(m_control.choice.method).stableStep(mode);
  return std::isfinite(own) ? own : methods.at(methods.plain()).stableStep(mode);
}

} // namespace esm
