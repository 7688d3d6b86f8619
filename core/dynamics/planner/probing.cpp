// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/planner/probing.h"

#include <algorithm>
#include <cmath>

namespace esm {

/// What second order errs in the phase of waves is an offset at once, and fades with them before it adds up where
/// dampers are strong: in tubes that had been let go errors of `chebyshev` added up over 0.04 to 0.16 s, where their
/// growth foretold 0.14 to 0.44. What lies along the motion, slow modes that run late, does add up: of tubes that
/// swing in one mode 15 of 96 runs missed their tolerance when it counted for less. Not in an event's own
/// waves, nor while nodes wait for their release: what is off then becomes another motion's error.
double addingUp(const StepControl& control, const CheckEnds& ends, Method method, const NodeArray& otherX,
                const NodeArray& otherV, const MotionState& state)
{
  const ErrorGauge& gauge = control.gauge;
  const double offset = control.methods.traits(method).offset;
  const bool isSteady =
    gauge.scale().calm > control.policy.choice.latestOnset && !gauge.awaitsRelease(control.start.time);
  if (!(offset > 0.0) || !control.bound.isDamped() || !isSteady || ends.look.steps == 0) return 1.0;
  const double along = gauge.alongMotion(*control.system, otherX, otherV, state);
  return 1.0 - offset * (1.0 - std::min(along / control.policy.checks.along, 1.0));
}

double swing(StepControl& control, double distance, const NodeArray& otherV, const MotionState& state)
{
  control.system->solverWork += control.policy.checks.swingCost * control.springs();
  return control.gauge.swing(*control.system, distance, otherV, state);
}

std::optional<Method> Probing::probe(const MotionState& state, double allowed, StepReport& report)
{
  for (int i = 0; i < m_control.policy.probes.most; ++i)
    if (const std::optional<Method> proven = probeBest(state, allowed, report)) return proven;
  return probeNext(state, allowed, report);
}

/// One that could be far cheaper.
std::optional<Method> Probing::probeBest(const MotionState& state, double allowed, StepReport& report)
{
  const Policy& policy = m_control.policy;
  const int settled = m_control.rhythm.share() <= policy.probes.farTooGood ? policy.choice.settling : 1;
  if (m_control.choice.settled > settled) return std::nullopt;
  const std::optional<Weighing::Proposal> proposal =
    m_control.weigh([&](Weighing weighing) { return weighing.worthAProbe(m_control.choice.method); });
  if (!proposal || !tryOut(proposal->method, proposal->step, state, allowed, report)) return std::nullopt;
  return proposal->method;
}

/// The method that would be chosen now, if on a guess only, at the step that the guess allows: for that a
/// look costs less than its own check would, and far less than one that fails.
std::optional<Method> Probing::probeNext(const MotionState& state, double allowed, StepReport& report)
{
  if (m_control.choice.settled > 1 || m_control.isImplicit()) return std::nullopt;
  const Method present = m_control.choice.method;
  double stable = 0.0;
  const Method next = m_control.weigh([&](Weighing weighing) {
    const Method cheapest = weighing.cheapestExplicit(present, m_control.policy.choice.patience);
    stable = weighing.stableStep(cheapest);
    return cheapest;
  });
  if (next == present || m_control.methods.traits(next).role != MethodRole::Explicit) return std::nullopt;
  const double step =
    std::min({stable, m_control.known.of(next).accurateStep, state.time - m_control.start.time});
  return tryOut(next, step, state, allowed, report) ? std::optional(next) : std::nullopt;
}

/// From the start of the stretch to the kept end `state` by another method, which stops where the check has looked.
/// @param early  gets how far it was off there [m]; 0 where nobody has looked
StepResult Probing::run(Integrator& integrator, const MotionState& state, std::int64_t steps, double& early,
                        StepReport& report)
{
  System& system = *m_control.system;
  const CheckEnds::Look& look = m_ends.look;
  integrator.restart();
  m_state = m_control.start; // same size: no allocation
  early = 0.0;
  if (look.steps > 0 && steps >= m_control.policy.checks.leastStepsForLook) {
    const double count = static_cast<double>(steps);
    const auto first = static_cast<std::int64_t>(std::ceil(count * look.share));
    const StepResult result = Stepper::runInPieces(integrator, system, m_state, look.time, first, report);
    if (result != StepResult::Done) return result;
    early = m_control.gauge.distance(look.x, m_state);
    steps = static_cast<std::int64_t>(std::ceil(count * (1.0 - look.share)));
  }
  return Stepper::runInPieces(integrator, system, m_state, state.time, steps, report);
}

/// The stretch once more by another method, with steps of about this size [s]. @return whether it errs little
/// enough.
bool Probing::tryOut(Method method, double step, const MotionState& state, double allowed, StepReport& report)
{
  const double begin = m_control.start.time, length = state.time - begin;
  MethodKnowledge& known = m_control.known.of(method);
  const double count = wholeSteps(length, step);
  if (length / count == known.probedStep) return false; // it would err as much as before
  if (m_control.isTooDear(count * m_control.methods.stepCost(method, step))) return false;
  known.probedStep = length / count;
  m_control.methods.layOut(method);
  const std::int64_t stepsBefore = report.steps;
  double early = 0.0;
  const StepResult result =
    run(m_control.methods.at(method), state, static_cast<std::int64_t>(count), early, report);
  report.rejectedSteps += report.steps - stepsBefore;
  report.steps = stepsBefore;
  double share = std::numeric_limits<double>::infinity();
  if (result == StepResult::Done) { // else it was unstable, which tells nothing of its accuracy
    const double late = m_control.gauge.distance(m_state.x, state);
    const double counted = m_control.gauge.growing(begin, length, early, late, m_ends.look.share) *
                           addingUp(m_control, m_ends, method, m_state.x, m_state.v, state);
    const double most = m_control.weigh([&](Weighing weighing) {
      return allowed * weighing.spendable(method) / weighing.spendable(m_control.choice.method);
    });
    share = counted * swing(m_control, late, m_state.v, state) / most;
    m_control.known.learnProbe(method, m_control.methods, {share, length / count});
  }
  const bool isProven = share <= 1.0;
  m_control.known.endProbe(method, isProven);
  return isProven;
}

} // namespace esm
