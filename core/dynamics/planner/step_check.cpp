// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
// The part of StepDriver that measures errors: a stretch is done twice, and what the distance of the ends
// teaches.
#include "core/dynamics/planner/step_driver.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace esm {
namespace {

/// Of the step after one check: an error has its zeros, one of them must not decide for long.
constexpr double kMostGrowth = 3.0, kMostErrorGrowth = 30.0;
/// The look at the two runs of a check comes after about a quarter of the steps, if there are so many, and so
/// many nodes: the errors of a few modes add up, whatever one look may say.
constexpr std::int64_t kLookShare = 4, kLeastStepsForLook = 8;
constexpr double kPrepareSwing = 3.0, kSwing = 4.0; ///< of ErrorGauge [spring evaluations per spring]
/// Of the budget, see isKept().
constexpr double kLeastShareKept = 0.6, kMostShareKept = 1.2;
/// Of the budget: an error that, grown with the power of the dampers since the last check, asks for the next.
constexpr double kSuspicious = 1.5;
/// Of what no stretch has spent: a check that finds more than its share takes it from there, and smaller
/// steps from then on. To do the stretch again would cost more than such an error does.
constexpr double kOnce = 0.1;
/// Of the work of a check's first run: a second one below was cheaper. And how the largest cheap step grows
/// back with each check that does not say so.
constexpr double kCheaper = 0.9, kEase = 1.15;
constexpr double kMostTransfer = 1.5;  ///< of what one method learned to others of lower order
constexpr double kSettlingTime = 0.15; ///< after the start or an event, in which motion unfolds [s]
constexpr int kLongestCheckGap = 24;   ///< stretches
constexpr int kLongestRoughGap = 8;    ///< the same while the error is beyond what the effort can mend
/// A method that errs less than this share of the budget is not checked again if a known end is no further
/// off than this many gaps: nothing that a check can still say would save what it costs.
constexpr double kSureShare = 0.5, kGapsBeforeEnd = 2.0;
/// A shorter stretch tells little of those to come: parts of an onset, and what an event or a growing part of
/// the net cuts short.
constexpr double kLeastProof = kFrame / 4.0;
constexpr double kShareToCompare = 0.5; ///< of the budget, that the end may be off with which others compare
constexpr int kProbes = 2, kLongestProbeGap = 4; ///< checks
/// Stretches that count as one more check to a method that waits for its next probe: where checks are rare, a
/// probe costs little, and motion has faded by then.
constexpr double kWaitedPerCheck = 6.0;
constexpr double kFarTooGood = 0.2; ///< of the budget: who errs less need not settle before others are probed
/// Of the budget: an error after an event that tells of waves which die out soon; and the number of steps,
/// and of parts, that make cutting the stretch worth while.
constexpr double kOnsetError = 20.0, kOnsetParts = 16.0;
constexpr double kOnsetShare = 1.0 / 16.0; ///< of a frame: what each part may err as much as

/// To the step that would just spend the budget, of which the present one spends this share. Errors of high
/// order rise steeply with what the waves do until the next check, and room for that costs little there.
double stepGain(double share, double order)
{
  const double room = order > 3.0 ? 0.82 : 0.9;
  return share > 0.0 ? std::min(room * std::pow(share, -1.0 / order), 1e3) : 1e3;
}

/// A step whose error is near the budget stays: to follow every wave of the error would mean to check for
/// ever.
bool isKept(double share)
{
  return share >= kLeastShareKept && share <= kMostShareKept;
}

} // namespace

/// The first run of a check: on its way it keeps where it was after an even number of steps, so that the
/// second run comes by at the same time.
StepDriver::Run StepDriver::runWithLook(System& system, MotionState& state, double end, std::int64_t steps,
                                        StepReport& report)
{
  m_look.steps = 0;
  if (steps < kLeastStepsForLook || state.x.size() < ErrorGauge::kFewNodes)
    return run(system, state, end, steps, report);
  const double begin = state.time;
  const std::int64_t early = steps / (2 * kLookShare) * 2;
  m_look.share = static_cast<double>(early) / static_cast<double>(steps);
  m_look.time = begin + (end - begin) * m_look.share;
  const Run result = run(system, state, m_look.time, early, report);
  if (result != Run::Done) return result;
  m_look.steps = early;
  m_look.x = state.x;
  return run(system, state, end, steps - early, report);
}

/// The second run of a check, with kFiner times the steps: what is kept.
StepDriver::Run StepDriver::runAgain(System& system, MotionState& state, double end, std::int64_t steps,
                                     StepReport& report)
{
  if (m_look.steps == 0) return run(system, state, end, steps, report);
  const auto early = static_cast<std::int64_t>(std::llround(kFiner * static_cast<double>(m_look.steps)));
  const Run result = run(system, state, m_look.time, early, report);
  if (result != Run::Done) return result;
  m_look.error = m_gauge.distance(m_look.x, state);
  return run(system, state, end, steps - early, report);
}

/// In due time; or where the motion is twice as fast as ever, or has waves that err more than may be: errors
/// come from the fast waves that feed the dampers.
bool StepDriver::checkDue(const MotionState& state) const noexcept
{
  if (m_untilCheck <= 0 || !(m_gauge.speedOf(state.v) <= 2.0 * m_gauge.scale().topSpeed)) return true;
  return expectedError(state) > kSuspicious * budget(state, state.time - m_start.time);
}

/// Error that the stretch up to here has added if what its steps err by themselves tells what has changed
/// since the last check, or the dampers where no method of next order is at hand [m].
double StepDriver::expectedError(const MotionState& state) const noexcept
{
  if (m_localError > 0.0 && m_errorOverLocal > 0.0) return m_errorOverLocal * m_localError;
  const double length = state.time - m_start.time, power = (state.heat - m_start.heat) / length;
  const double grown = m_checkedPower > 0.0 ? std::sqrt(std::max(power, 0.0) / m_checkedPower) : 1.0;
  return m_checkedError * length * grown;
}

/// Error that a stretch may add [m]. The parts of an onset share what one stretch would have.
double StepDriver::budget(const MotionState& state, double length) const noexcept
{
  const double counted = m_onset.longest > 0.0 ? std::max(length, kOnsetShare * kFrame) : length;
  return spendable(m_candidates[m_method]) * m_gauge.budget(m_settings.tolerance, state, counted);
}

/// ErrorGauge::swing(), counted as work.
double StepDriver::swing(System& system, double distance, const NodeArray& otherV, const MotionState& state)
{
  system.solverWork += kSwing * static_cast<double>(system.forces().activeSprings());
  return m_gauge.swing(system, distance, otherV, state);
}

/// The part that adds up of an error which a look has seen grow within a stretch. What second order errs in
/// the phase of waves is an offset at once, and fades with them before it adds up where dampers are strong:
/// in tubes that had been let go errors of `chebyshev` added up over 0.04 to 0.16 s, where their growth
/// foretold 0.14 to 0.44. What lies along the motion, slow modes that run late, does add up: of tubes that
/// swing in one mode 15 of 96 runs missed their tolerance when it counted for less. Not in an event's own
/// waves, nor while nodes wait for their release: what is off then becomes another motion's error.
double StepDriver::addingUp(const Candidate& candidate, const System& system, const NodeArray& otherX,
                            const NodeArray& otherV, const MotionState& state) const noexcept
{
  constexpr double kAlong = 0.4; // and more: nothing is an offset
  const bool isSteady = m_gauge.scale().calm > kLatestOnset && !m_gauge.awaitsRelease(m_start.time);
  if (!(candidate.offset > 0.0) || !isDamped() || !isSteady || m_look.steps == 0) return 1.0;
  const double along = m_gauge.alongMotion(system, otherX, otherV, state);
  return 1.0 - candidate.offset * (1.0 - std::min(along / kAlong, 1.0));
}

/// What the first of a check's two runs has erred, as far as that goes on to count [m]; the second one ends
/// at `state`.
/// @param ratio  of the errors of the two
double StepDriver::errorOfFirst(System& system, const MotionState& state, double ratio)
{
  const double apart = m_gauge.distance(m_coarse, state), length = state.time - m_start.time;
  m_gauge.prepareSwing(system, state);
  system.solverWork += kPrepareSwing * static_cast<double>(system.forces().activeSprings());
  if (m_look.steps > 0) m_growing = m_gauge.growing(m_start.time, length, m_look.error, apart, m_look.share);
  const double counted = m_growing * addingUp(m_candidates[m_method], system, m_coarse, m_coarseV, state);
  return counted * swing(system, apart, m_coarseV, state) * ratio / (ratio - 1.0);
}

/// After a stretch. Of a method that does not find by itself what it loses: a look costs a fiftieth of the
/// work since the last one, whatever stretches lie between. While supports have lent something the balance
/// tells: beside a jump's energy no quadrature sees what is left of it.
void StepDriver::bookLoss(const System& system, MotionState& state, Method method, double step)
{
  constexpr double kLook = 250.0; // force passes
  Integrator& integrator = *m_candidates[method].integrator;
  if (state.loan.isOpen() && !integrator.keepsLoan()) {
    m_unseen.isOpen = false; // Descent has closed what was before
    const EnergyBalance balance = energyBalance(system, state);
    const double lost = (state.restored - m_start.restored) - balance.gained - balance.heat;
    state.loss = m_start.loss + std::min(lost, 0.0);
    state.settle(std::max(lost, 0.0), balance.heat,
                 system.kineticEnergy(state.v) + std::max(system.elasticEnergy(state.x), 0.0));
    return;
  }
  if (integrator.findsLoss()) {
    state.loss += closeLoss(system, m_start);
    return;
  }
  if (!m_unseen.isOpen) m_unseen.start = m_start; // same size: no allocation
  m_unseen.isOpen = true;
  const double springs = std::max(static_cast<double>(system.forces().activeSprings()), 1.0);
  m_unseen.passes += (state.time - m_start.time) / step * integrator.stepCost(system, step) / springs;
  if (m_unseen.passes >= kLook) state.loss += closeLoss(system, state);
}

double StepDriver::closeLoss(const System& system, const MotionState& state)
{
  constexpr double kPrecision = 0.01; // of the tolerance
  const MotionState& start = m_unseen.start;
  const bool isBehind = start.x.size() == state.x.size() && start.time < state.time;
  if (!std::exchange(m_unseen.isOpen, false) || !isBehind) return 0.0;
  m_unseen.passes = 0.0;
  m_loss.restart();
  const double given = (state.work - start.work) + (state.restored - start.restored);
  return m_loss.find(system, start, state.x, state.v, given, state.heat - start.heat,
                     std::min(kPrecision * m_settings.tolerance, 0.5));
}

/// How large the waves may have been that implicit steps of this length have damped away since the start of
/// the stretch [m]. Two runs that both do so do not tell: a sheet of a thousand times its stiffness erred ten
/// times a tolerance of 1e-2, and each check saw a thirtieth of its budget. What tells is energy that is gone
/// without work and heat. The waves were faster than the steps, so no larger than this; there, ten times
/// smaller. Where dampers take such waves, it is less than what checks see.
double StepDriver::lostWaves(const System& system, const EnergyBalance& balance, double step) noexcept
{
  const double rounding = // of so many errors
    std::numeric_limits<double>::epsilon() * std::sqrt(static_cast<double>(system.forces().activeSprings()));
  const double lost = -balance.heat - balance.gained - rounding * (balance.turnedOver + balance.high);
  return step * std::sqrt(std::max(lost, 0.0) / system.totalMass());
}

/// After a stretch has been done in `steps` and again in `finer` steps: whether the second run may be kept;
/// if so it is. Both ways the error is learned from.
bool StepDriver::accept(System& system, const MotionState& state, std::int64_t steps, std::int64_t finer,
                        StepReport& report)
{
  const double length = state.time - m_start.time, count = static_cast<double>(steps);
  const double ratio = std::pow(static_cast<double>(finer) / count, current().order()); // of the errors
  const bool dampsWaves = !isExplicit(m_candidates[m_method]);
  const EnergyBalance balance = m_auto || dampsWaves ? energyBalance(system, state) : EnergyBalance{};
  const double lost = dampsWaves ? lostWaves(system, balance, length / static_cast<double>(finer)) : 0.0;
  const double coarseError = std::max(errorOfFirst(system, state, ratio), lost), error = coarseError / ratio;
  m_gauge.guessLifetime(system, m_start, state);
  learnOverLocal(coarseError, length);
  const double allowed = budget(state, length);
  const bool isFine = error <= std::max(allowed, kOnce * m_gauge.unspent(m_settings.tolerance, state));
  // Below the floor a rough answer is taken, but not one that runs away: a tenth of all displacement.
  const double rough = 0.1 * std::max(m_gauge.displacementOf(m_start.x), m_gauge.floor());
  const bool atFloor = length / count <= floorStep() && coarseError <= rough;
  const bool sane = !m_auto || !energyAppeared(system, balance, kCoarseGrowth);
  // Where another attempt could not be paid for, this one must do.
  const bool isLast = isTooDear(system, 3.0 * count * current().stepCost(system, length / count));
  if (m_checksFromAbove)
    learn(state, error, allowed, length / static_cast<double>(finer));
  else
    learn(state, coarseError, allowed, length / count);
  learnCost(length / count);
  if (!sane || !(isFine || atFloor || isLast)) return false;
  m_roughAtCheck = !isFine;
  report.rough = report.rough || m_roughAtCheck;
  if (m_roughAtCheck) sayToleranceGivenUp();
  const double since = (m_start.time - m_checkedTime) / kFrame; // stretches
  const double waited = std::clamp(since / kWaitedPerCheck, 1.0, static_cast<double>(kLongestProbeGap));
  m_checkedTime = m_start.time;
  for (Candidate& candidate : m_candidates) {
    candidate.untilProbe -= static_cast<int>(waited);
    candidate.probedStep = 0.0;
  }
  std::optional<Method> proven;
  if (m_auto && m_onset.longest <= 0.0 && error <= kShareToCompare * allowed)
    proven = probeOthers(system, state, allowed, report);
  keep(system, state, error);
  reconsider(system, proven);
  return true;
}

/// After a check, by the end that it has kept. @return a method that errs little enough there and costs less.
std::optional<StepDriver::Method> StepDriver::probeOthers(System& system, const MotionState& state,
                                                          double allowed, StepReport& report)
{
  for (int i = 0; i < kProbes; ++i)
    if (const std::optional<Method> proven = probe(system, state, allowed, report)) return proven;
  return probeNext(system, state, allowed, report);
}

/// After a check: does another method that could be far cheaper err little enough? It takes the same stretch
/// once, and the kept end tells its error: a change on a mere guess would cost more than such a look.
std::optional<StepDriver::Method> StepDriver::probe(System& system, const MotionState& state, double allowed,
                                                    StepReport& report)
{
  double step = 0.0;
  const int settled = m_checkedShare <= kFarTooGood ? kSettling : 1;
  if (m_settled > settled) return std::nullopt;
  const std::optional<Method> method = worthAProbe(system, step);
  return method && tryOut(*method, step, system, state, allowed, report) ? method : std::nullopt;
}

/// The method that would be chosen now, if on a guess only, at the step that the guess allows: for that a
/// look costs less than its own check would, and far less than one that fails.
std::optional<StepDriver::Method> StepDriver::probeNext(System& system, const MotionState& state,
                                                        double allowed, StepReport& report)
{
  if (m_settled > 1 || m_method == m_implicit) return std::nullopt;
  const Method next = cheapestExplicit(system, patience());
  const Candidate& candidate = m_candidates[next];
  if (next == m_method || candidate.role != MethodRole::Explicit) return std::nullopt;
  const double step = std::min({stableStep(candidate), candidate.accurateStep, state.time - m_start.time});
  return tryOut(next, step, system, state, allowed, report) ? std::optional(next) : std::nullopt;
}

/// m_start to the kept end `state` by another method, which stops where the check has looked.
/// @param early  gets how far it was off there [m]; 0 where nobody has looked
StepResult StepDriver::runProbe(Integrator& integrator, System& system, const MotionState& state,
                                std::int64_t steps, double& early, StepReport& report)
{
  integrator.restart();
  m_probe = m_start; // same size: no allocation
  early = 0.0;
  if (m_look.steps > 0 && steps >= kLeastStepsForLook) {
    const double count = static_cast<double>(steps);
    const StepResult result = runInPieces(integrator, system, m_probe, m_look.time,
                                          static_cast<std::int64_t>(std::ceil(count * m_look.share)), report);
    if (result != StepResult::Done) return result;
    early = m_gauge.distance(m_look.x, m_probe);
    steps = static_cast<std::int64_t>(std::ceil(count * (1.0 - m_look.share)));
  }
  return runInPieces(integrator, system, m_probe, state.time, steps, report);
}

/// The stretch once more by another method, with steps of about this size [s]. @return whether it errs little
/// enough.
bool StepDriver::tryOut(Method method, double step, System& system, const MotionState& state, double allowed,
                        StepReport& report)
{
  const double length = state.time - m_start.time;
  Candidate& candidate = m_candidates[method];
  const double count = std::ceil(length / step * (1.0 - 1e-9));
  if (length / count == candidate.probedStep) return false; // it would err as much as before
  if (isTooDear(system, count * candidate.integrator->stepCost(system, step))) return false;
  candidate.probedStep = length / count;
  layOut(method, system);
  const std::int64_t stepsBefore = report.steps;
  double early = 0.0;
  const StepResult result =
    runProbe(*candidate.integrator, system, state, static_cast<std::int64_t>(count), early, report);
  report.rejectedSteps += report.steps - stepsBefore;
  report.steps = stepsBefore;
  double share = kInfinity;
  if (result == StepResult::Done) { // else it was unstable, which tells nothing of its accuracy
    const double late = m_gauge.distance(m_probe.x, state);
    const double counted = m_gauge.growing(m_start.time, length, early, late, m_look.share) *
                           addingUp(candidate, system, m_probe.x, m_probe.v, state);
    const double most = allowed * spendable(candidate) / spendable(m_candidates[m_method]);
    share = counted * swing(system, late, m_probe.v, state) / most;
    const double gain = stepGain(share, candidate.integrator->order());
    candidate.accurateStep = length / count;
    candidate.estimate = candidate.accurateStep * gain;
    if (!isKept(share)) candidate.accurateStep *= std::clamp(gain, kMostShrinking, kMostGrowth);
    candidate.isMeasured = true;
    tellTwins(method);
  }
  if (share <= 1.0) {
    candidate.untilProbe = 0;
    candidate.probeGap = 1;
    return true;
  }
  candidate.untilProbe = candidate.probeGap;
  candidate.probeGap = std::min(2 * candidate.probeGap, kLongestProbeGap);
  return false;
}

/// What is known before the first stretches after an event.
void StepDriver::rememberBeforeOnset()
{
  if (m_onset.longest > 0.0 || m_gauge.scale().calm > kLatestOnset) return;
  m_onset.method = m_method;
  std::copy(m_candidates.begin(), m_candidates.end(), m_onset.known.begin());
}

/// After a check that failed.
/// @return length of the next attempt, of which `count` steps would have made the present one [s]
double StepDriver::beginOnset(double length, double count) noexcept
{
  const bool isFirst = m_gauge.scale().calm <= kLatestOnset && m_onset.longest <= 0.0;
  const bool affordsMore = 2.0 * m_leastCost <= m_settings.effort; // else it is for plain steps only
  if (!m_auto || !isFirst || !(m_checkedShare > kOnsetError) || count < kOnsetParts || !affordsMore)
    return length;
  m_onset.longest = length / kOnsetParts;
  return m_onset.longest;
}

/// Before each stretch: doubles its length, looks at each, and ends the onset with what had been measured
/// before. If that was nothing, other methods are given the benefit of the guess again: what they seemed to
/// err in the onset kept tubes on a dear method for good, three hundred times below what it might err.
void StepDriver::continueOnset()
{
  if (m_onset.longest <= 0.0) return;
  m_onset.longest *= 2.0;
  m_untilCheck = 0;
  if (m_onset.longest < kFrame) return;
  m_onset.longest = 0.0;
  if (m_method == m_implicit) return;
  m_settled = 0;
  if (!m_onset.known[m_onset.method].isMeasured) { // what failed was a guess
    for (Method method = 0; method < m_candidates.size(); ++method)
      if (method != m_method && m_candidates[method].role == MethodRole::Explicit)
        guessStepAtLeast(m_candidates[method]);
    return;
  }
  for (Method method = 0; method < m_candidates.size(); ++method)
    static_cast<Knowledge&>(m_candidates[method]) = m_onset.known[method];
  m_checkGap = 1;
  if (m_method == m_onset.method) return;
  use(m_onset.method);
  m_candidates[m_method].isMeasured = true; // see above
  explain();
}

/// What of the local errors of a check's first run is left at its end. Fast waves lose most of theirs on the
/// way: in nets with stiffness over six decades a fiftieth to a fifth is left, the least where a part of them
/// snaps through. So one check moves what is known by half of the way, in logarithms.
void StepDriver::learnOverLocal(double error, double length) noexcept
{
  const bool isFirst = !(m_errorOverLocal > 0.0);
  const double found = error / m_localError;
  if (!(found > 0.0) || !std::isfinite(found) || (length < kLeastProof && !isFirst)) return;
  m_errorOverLocal = isFirst ? found : std::sqrt(found * m_errorOverLocal);
}

/// Larger implicit steps are not always cheaper: Newton's method takes more iterations for them and more
/// factors, until it fails. A check has run with `step` and with smaller ones, and tells which cost less.
void StepDriver::learnCost(double step) noexcept
{
  Candidate& here = m_candidates[m_method];
  if (isExplicit(here)) return;
  if (m_finerWork < kCheaper * m_coarseWork)
    here.cheapStep = step / kFiner;
  else
    here.cheapStep *= kEase;
}

/// From the error of steps of size `step` to the accurate one, for the method and for those like it.
void StepDriver::learn(const MotionState& state, double error, double budget, double step)
{
  const double order = current().order(), share = m_checkedShare = error / budget;
  const double mostGrowth = std::min(kMostGrowth, std::pow(kMostErrorGrowth, 1.0 / order));
  const bool isImplicit = !isExplicit(m_candidates[m_method]);
  const double gain = stepGain(share, order);
  double& accurate = m_candidates[m_method].accurateStep;
  accurate = step;
  if (!isKept(share)) accurate *= std::clamp(gain, isImplicit ? 0.1 : kMostShrinking, mostGrowth);
  const double length = state.time - m_start.time;
  m_checkedError = std::min(error, budget) / length; // the next step will not err more
  m_checkedPower = (state.heat - m_start.heat) / length;
  bool grows = false;
  if (!(share <= kMostShareKept)) { // what the effort keeps from shrinking gains nothing by checks
    const bool isHeld = m_auto && !isImplicit && controlledStep(kFrame) > 0.8 * step;
    m_checkGap = isHeld ? std::min(2 * m_checkGap, kLongestRoughGap) : std::max(1, m_checkGap / 4);
  } else { // motion that unfolds is looked at soon where no damper tells of it, a step that has grown at once
    grows = 0.8 * controlledStep(kInfinity) > step;
    const bool unfolds = m_gauge.scale().calm < kSettlingTime && !(m_checkedPower > 0.0);
    const int wider = length < kLeastProof ? m_checkGap : 2 * m_checkGap;
    m_checkGap = std::min(wider, grows || unfolds ? 2 : kLongestCheckGap);
  }
  m_untilCheck = grows ? 1 : m_checkGap;
  const double left = std::ceil((knownEnd(state.time) - state.time) / kFrame); // stretches
  if (share <= kSureShare && left <= kGapsBeforeEnd * m_untilCheck) m_untilCheck = static_cast<int>(left) + 1;
  if (!m_candidates[m_method].isMeasured && accurate < 0.7 * step) m_settled = 0; // it promised too much
  if (isImplicit) return;
  // Motion that is easier or harder for this method is so for the others. Methods of low order err in slower
  // motion, which changes less: they gain little more than this one, although their order promises it.
  Candidate& here = m_candidates[m_method];
  const double estimate = step * gain;
  const double change = here.estimate > 0.0 ? estimate / here.estimate : 1.0;
  here.estimate = estimate;
  for (Candidate& other : m_candidates)
    if (&other != &here && isExplicit(other) && (here.isMeasured || !other.isMeasured))
      other.accurateStep *= std::clamp(
        std::pow(change, std::min(change > 1.0 ? kMostTransfer : 1.0, order / other.integrator->order())),
        0.2, mostGrowth);
  // Local steps only coarsen what velocity Verlet does: at their step no other explicit method errs more.
  if (here.role == MethodRole::Local)
    for (Candidate& other : m_candidates)
      if (isExplicit(other)) other.accurateStep = std::max(other.accurateStep, accurate);
  here.isMeasured = true;
  tellTwins(m_method);
}

} // namespace esm
