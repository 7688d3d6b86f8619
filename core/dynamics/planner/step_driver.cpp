// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/planner/step_driver.h"

#include "core/dynamics/methods/stiff_nodes.h"

#include <algorithm>
#include <cmath>

namespace esm {
namespace {

constexpr double kSolveShare = 0.1; ///< of the budget, for what implicit solvers leave
/// Of an implicit step that found no solution: larger ones are not tried soon.
constexpr double kSmallerThanFailed = 0.6;
constexpr int kMostAttempts = 24;              ///< of one stretch
constexpr double kMostEffort = 3.0;            ///< for one frame, before descent takes over
constexpr double kLeastShare = 1.0 / 8.0;      ///< of it for a stretch, however short
constexpr double kLeastOnsetShare = 1.0 / 8.0; ///< of that, when the others of an onset have used up theirs
constexpr double kGrowth = 0.02; ///< of energy, like kCoarseGrowth, in steps whose error nobody measures

/// The largest of what limits steps.
double relativeChange(const FastestMode& before, const FastestMode& after)
{
  const auto change = [](double from, double to, double whole) {
    return whole > 0.0 ? std::abs(to - from) / whole : 0.0;
  };
  const double stiffness = std::max(before.stiffness, after.stiffness),
               damping = std::max(before.damping, after.damping);
  return std::max(
    {change(before.stiffness, after.stiffness, stiffness), change(before.undamped, after.undamped, stiffness),
     change(before.damping, after.damping, damping), change(before.decay, after.decay, damping),
     change(before.leastDamping, after.leastDamping, std::max(before.leastDamping, after.leastDamping))});
}

} // namespace

StepReport StepDriver::advance(System& system, MotionState& state, double interval, std::int64_t maxSteps,
                               double mostWork)
{
  StepReport report;
  m_limitText.clear();
  system.springsEvaluated = 0;
  system.solverWork = 0.0;
  system.workLimit = mostWork;
  m_maxSteps = maxSteps;
  m_mostWork = mostWork;
  const double begin = state.time;
  double end = begin + interval;
  while (state.time < end) {
    m_gauge.expectRelease(system.schedule().nextRelease());
    const double event = system.nextEvent(state.time);
    // An event a rounding error away from the end of the interval is the end.
    if (std::abs(event - end) <= 1e-9 * interval) end = event;
    const double target = std::min(event, end);
    const bool isFixed = m_settings.fixedStep > 0.0;
    if (!(workDone(system, report) < m_mostWork) || system.isInterrupted()) {
      giveUp(system, Run::Limit, report);
      break;
    }
    continueOnset();
    const bool byBlocks = takesBlocks() && mayTakeBlocks(system); // these have checks of their own
    const double longest = m_onset.longest > 0.0            ? m_onset.longest
                           : m_untilCheck <= 0 && !byBlocks ? longestCheck()
                                                            : kFrame;
    const double stretches = isFixed ? 1.0 : std::ceil((target - state.time) / longest * (1.0 - 1e-9));
    const double stretchEnd = stretches > 1.0 ? state.time + (target - state.time) / stretches : target;
    const double workBefore = system.workDone();
    const bool done = isFixed ? stretchFixed(system, state, stretchEnd, report)
                              : stretchControlled(system, state, stretchEnd, report);
    m_onset.affordable -= system.workDone() - workBefore;
    if (!done) break;
    if (state.time != event) continue;
    if (system.enter(state, false)) {
      for (Candidate& candidate : m_candidates)
        if (candidate.prepared) candidate.integrator->constraintsChanged(system);
      findBodies(system, state);
      m_checkGap = 1;
      m_sinceBound = kInfinity;
    } else {
      if (m_candidates[m_method].prepared) current().restart();
      m_bodies.enter(system, state.time);
    }
    m_untilCheck = 0;
    m_gauge.markEvent();
  }
  report.simulatedTime = state.time - begin;
  report.springsEvaluated = system.springsEvaluated;
  report.largestForce = system.forces().largestTension(state.x.data(), state.v.data(), system.workers());
  return report;
}

bool StepDriver::stretchFixed(System& system, MotionState& state, double end, StepReport& report)
{
  layOut(m_method, system);    // before it is told anything
  refreshBound(system, state); // stages and predictions keep to what is stable now
  current().setSolveTolerance(1e-12 * m_gauge.extent(), false);
  const double steps = std::max(1.0, std::ceil((end - state.time) / m_settings.fixedStep * (1.0 - 1e-9)));
  m_start = state; // same size: no allocation
  m_startEnergies.reset();
  const double length = end - state.time;
  const Run result = run(system, state, end, static_cast<std::int64_t>(std::min(steps, 1e15)), report);
  if (result != Run::Done)
    giveUp(system, result, report);
  else
    bookLoss(system, state, m_method, length / steps);
  return result == Run::Done;
}

/// The step that is stable, accurate, and not larger than is cheap.
double StepDriver::controlledStep(double length) noexcept
{
  const Candidate& candidate = m_candidates[m_method];
  const double wanted = std::min(candidate.accurateStep, candidate.cheapStep);
  return std::min({stableStep(candidate), std::max(wanted, floorStep()), length});
}

/// Of a stretch that is checked [s].
double StepDriver::longestCheck() noexcept
{
  return controlledStep(kFrame) < checkLength() / 8.0 ? checkLength() : kFrame;
}

/// Whether a check may compare this step with a larger one instead of a smaller one, for less than half the
/// work beyond that of the stretch. Not the first check of a method, which may need the smaller one; not
/// below fourth order, where errors at half of the limit are not yet of their order (with such checks half of
/// the tubes took 2 % more at 1e-2); nor where dampers are weak (sheets took 4 % more at 1e-6).
bool StepDriver::hasRoomAbove(double step) const noexcept
{
  constexpr double kEnoughOrder = 4.0;
  const Candidate& candidate = m_candidates[m_method];
  return isExplicit(candidate) && candidate.isMeasured && candidate.integrator->order() >= kEnoughOrder &&
         isDamped() && m_onset.longest <= 0.0 && step == candidate.accurateStep &&
         kFiner * step <= stableStep(candidate);
}

bool StepDriver::stretchControlled(System& system, MotionState& state, double end, StepReport& report)
{
  double length = end - state.time;
  refreshBound(system, state);
  rememberBeforeOnset();
  m_start = state;
  m_startEnergies.reset();
  m_growth = m_grown;
  m_localError = 0.0;
  if (!m_auto && current().isUncontrolled()) {
    layOut(m_method, system);
    current().setSolveTolerance(1e-9 * m_gauge.extent(), false);
    const Run result = run(system, state, end, 1, report);
    if (result != Run::Done) return giveUp(system, result, report), false;
    report.rough = report.rough || current().brakesBodies(); // nobody has measured its error
    keep(system, state, expectedError(state));
    return true;
  }
  if (m_auto) {
    if (takesBlocks()) return stretchRoughly(system, state, end, report);
    const double usual =
      kMostEffort * std::max(effort(system), 2.0 * m_leastCost) * std::max(length / kFrame, kLeastShare);
    if (m_onset.longest <= 0.0) m_onset.affordable = usual; // it may begin here
    system.workLimit = std::min(
      m_mostWork, system.workDone() + std::clamp(m_onset.affordable, kLeastOnsetShare * usual, usual));
  }
  Run failure = Run::NotConverged;
  for (int attempt = 0; attempt < kMostAttempts; ++attempt) {
    layOut(m_method, system); // who is chosen has no room before he runs
    const double step = controlledStep(length);
    const double count = std::ceil(length / step * (1.0 - 1e-9));
    if (isTooDear(system, count * current().stepCost(system, step))) {
      if (!fallBackToLeapfrog(system, length)) break;
      continue;
    }
    if (!(count < 1e12)) break;
    // What nobody checks needs no digits beyond what the eye can see.
    const bool unchecked = m_toleranceGivenUp && m_method == m_implicit;
    const bool isPlanned = !unchecked && m_untilCheck <= 0;
    m_checksFromAbove = isPlanned && attempt == 0 && hasRoomAbove(step);
    const auto steps = static_cast<std::int64_t>(m_checksFromAbove ? std::ceil(count / kFiner) : count);
    const auto finer = static_cast<std::int64_t>(m_checksFromAbove ? count : std::ceil(kFiner * count));
    // An implicit solver measures over the nodes that it has.
    const double budget =
      m_gauge.budget(m_settings.tolerance, m_start, length) * m_gauge.shareOfWhole(state.x.size());
    current().setSolveTolerance(
      std::max(kSolveShare * budget / count, (unchecked ? 1e-4 : 1e-13) * m_gauge.extent()), unchecked);
    // A check that comes unforeseen has no look.
    m_look.steps = 0;
    const double workBefore = system.workDone();
    if (isPlanned) current().mark(state.time);
    current().takeLocalError(); // of probes, and runs that failed
    Run result =
      isPlanned ? runWithLook(system, state, end, steps, report) : run(system, state, end, steps, report);
    m_localError = current().takeLocalError();
    if (unchecked && result == Run::Done &&
        energyAppeared(system, energyBalance(system, state), kGrowth)) { // once more, exactly
      report.rejectedSteps += steps;
      state = m_start;
      current().restart();
      current().setSolveTolerance(std::max(kSolveShare * budget / count, 1e-6 * m_gauge.extent()), false);
      result = run(system, state, end, steps, report);
      if (result == Run::Done && energyAppeared(system, energyBalance(system, state), kGrowth)) break;
    }
    if (result == Run::Limit) return stopAtLimit(system, state, report), false;
    if (m_auto && result != Run::Done && (unchecked || system.isExhausted())) break;
    const bool isCheap =
      m_method == m_implicit || count >= 32.0 || m_untilCheck <= 0; // to look at the energy
    if (m_auto && result == Run::Done && !unchecked && (isCheap || hasQuickened(system, state)) &&
        energyAppeared(system, energyBalance(system, state), kCoarseGrowth))
      result = Run::NotConverged; // on its way to infinity
    if (result == Run::Done) {
      const bool isDue = !unchecked && checkDue(state);
      // A step that nobody could afford to check is better than none.
      if (!isDue || isTooDear(system, static_cast<double>(2 * steps) * current().stepCost(system, step))) {
        // The next one is larger, until a check can be paid for: else a wrong guess would hold for good.
        if (isDue) m_candidates[m_method].accurateStep = 2.0 * step;
        --m_untilCheck;
        report.rough = report.rough || unchecked || m_roughAtCheck || isDue;
        bookLoss(system, state, m_method, length / count);
        keep(system, state, expectedError(state));
        if (unchecked) reconsider(system);
        return true;
      }
      m_coarse = state.x;
      m_coarseV = state.v;
      state = m_start;
      current().rewind(state.time);
      m_coarseWork = system.workDone() - workBefore;
      result = runAgain(system, state, end, finer, report);
      m_finerWork = system.workDone() - workBefore - m_coarseWork;
      if (result == Run::Limit) return stopAtLimit(system, state, report), false;
    }
    if (result != Run::Done) {
      failure = result;
      if (isTooDear(system, 0.0)) break;
      retreat(system, state, attempt, length, report);
      continue;
    }
    const Method method = m_method;
    if (accept(system, state, steps, finer, report)) {
      bookLoss(system, state, method, length / static_cast<double>(finer));
      return true;
    }
    report.rejectedSteps += steps + finer;
    length = beginOnset(length, count);
    state = m_start;
    m_settled = 0;
    reconsider(system);
    length = std::min(length, longestCheck()); // another method may take far more steps
    if (length < (1.0 - 1e-9) * (end - m_start.time)) end = m_start.time + length; // no rest of rounding
    current().restart();
  }
  if (!m_auto) {
    state = m_start;
    return giveUp(system, failure, report), false;
  }
  report.rejectedSteps += 1;
  state = m_start;
  m_descentTerm = std::clamp(2 * m_descentTerm, 1, kLongestDescent);
  m_descents = m_descentTerm;
  m_growth = m_grown;
  return stretchRoughly(system, state, end, report);
}

/// Whether this much work more is beyond what `auto` may spend on the stretch.
bool StepDriver::isTooDear(const System& system, double work) const noexcept
{
  return m_auto && !(system.workDone() + work <= system.workLimit);
}

/// Where a dearer method was on its way: plain steps at their limit, if these can be paid for.
bool StepDriver::fallBackToLeapfrog(System& system, double length)
{
  if (!m_auto || m_method == m_leapfrog || m_method == m_implicit) return false;
  if (isTooDear(system, m_leastCost * length / kFrame)) return false;
  use(m_leapfrog);
  m_candidates[m_leapfrog].accurateStep = explicitLimit();
  m_settled = 4;
  explain();
  return true;
}

StepDriver::EnergyBalance StepDriver::energyBalance(const System& system, const MotionState& state)
{
  if (!m_startEnergies)
    m_startEnergies = Energies{system.kineticEnergy(m_start.v), system.elasticEnergy(m_start.x),
                               system.forces().gravityEnergy(m_start.x.data())};
  const auto& [kinetic, elastic, high] = *m_startEnergies;
  const double fallen = high - system.forces().gravityEnergy(state.x.data());
  const double work = state.work - m_start.work;
  const double gained =
    system.kineticEnergy(state.v) - kinetic + system.elasticEnergy(state.x) - elastic - fallen - work;
  return {gained, state.heat - m_start.heat, kinetic + std::abs(elastic) + std::abs(work) + std::abs(fallen),
          std::abs(high)};
}

/// Whether the net has more energy than at the start of the stretch without work that explains it, by more
/// than this share of what was there, has been worked and has fallen.
bool StepDriver::energyAppeared(const System& system, const EnergyBalance& balance, double share) noexcept
{
  // Of sums with rounding errors; and what nobody can see.
  const double least = 1e-12 * (balance.high + system.totalMass() * m_gauge.extent() * m_gauge.extent());
  const double sum = std::max(m_grown, 0.0) + balance.gained; // what came slowly is no better
  if (!(sum <= share * balance.turnedOver + least)) return true;
  m_growth = sum;
  return false;
}

/// Whether the net is so much faster than at the start of the stretch that its energy is worth two passes: a
/// few large steps may have missed how stiff it has become.
bool StepDriver::hasQuickened(const System& system, const MotionState& state) const noexcept
{
  return system.kineticEnergy(state.v) > 2.0 * system.kineticEnergy(m_start.v);
}

/// The work limit came in the middle of a stretch that nobody has checked. What has been done is kept, so
/// that limited calls get on too, unless energy came from nowhere: then the start of the stretch is the last
/// good state.
void StepDriver::stopAtLimit(const System& system, MotionState& state, StepReport& report)
{
  if (energyAppeared(system, energyBalance(system, state), kGrowth)) {
    state = m_start;
    current().restart();
    m_candidates[m_method].accurateStep = 0.25 * controlledStep(kFrame);
    m_untilCheck = 0;
  }
  giveUp(system, Run::Limit, report);
}

/// After a failed run: back to the start of the stretch with a smaller step.
void StepDriver::retreat(System& system, MotionState& state, int attempt, double length, StepReport& report)
{
  ++report.rejectedSteps;
  const double tried = controlledStep(kFrame);
  state = m_start;
  Candidate& candidate = m_candidates[m_method];
  candidate.accurateStep = tried / 4.0;
  if (!isExplicit(candidate)) candidate.cheapStep = kSmallerThanFailed * tried;
  if (m_auto && candidate.affordableStep > candidate.accurateStep) { // there the effort would hold it
    if (fallBackToLeapfrog(system, length)) {
      candidate.accurateStep = kMostShrinking * tried;
      return;
    }
    candidate.affordableStep = candidate.accurateStep;
  }
  m_floorStep = std::min(m_floorStep, tried / 4.0);
  m_untilCheck = 0;
  m_checkGap = 1;
  if (m_auto && m_method != m_implicit && attempt >= 4) {
    use(m_implicit);
    m_settled = 64;
    explain();
  }
  current().restart();
}

/// The stretch is done.
/// @param error  that it has added [m]
/// @param beyond  see ErrorGauge
void StepDriver::keep(const System& system, const MotionState& state, double error, double beyond) noexcept
{
  m_gauge.setScale(m_gauge.scaleAfter(system, m_start, state, error, beyond));
  m_grown = m_growth;
}

void StepDriver::setBound(const System& system, const MotionState& state)
{
  m_mode = m_bound.compute(system, state.x, state.v);
  m_boundIsOld = false;
  m_stiffest = {};
  if (m_mode.node != kNoIndex)
    m_stiffest = {nameOf(m_mode.node), system.mass()[static_cast<std::size_t>(m_mode.node)]};
  m_sinceBound = 0.0;
  m_boundPatience = 1.0;
  m_fewHoldAll = m_auto && !StiffNodes::find(system).empty();
  weighSteps(system);
}

/// By the bound at hand.
void StepDriver::weighSteps(const System& system)
{
  for (Candidate& candidate : m_candidates) {
    candidate.integrator->tune(system, m_mode);
    weighEffort(system, candidate);
  }
  weighLeastCost(system);
}

/// After a change. Who keeps time goes on by blocks, until the usual look at the bound tells more.
void StepDriver::replaceBound(const System& system, const MotionState& state, bool now)
{
  if (now) return setBound(system, state);
  m_boundIsOld = true;
  weighSteps(system);
}

/// Whether a look could change anything: not while blocks take what a hand leads, nor where plain steps would cost so
/// much more than they may that no motion brings them back.
bool StepDriver::boundMatters(const System& system) const noexcept
{
  constexpr double kFarBeyond = 4.0; // a net that is stretched until its stiffness is sixteenfold
  return !m_byBlocks || (!isLedByBlocks() && m_leastCost <= kFarBeyond * effort(system));
}

/// A look at the bound costs up to thirty passes, and where struts make many pairs of springs as much again. It
/// follows what stiffens within some frames, and what turns and bends; where it finds nothing new it comes less often.
void StepDriver::refreshBound(const System& system, const MotionState& state)
{
  constexpr double kNew = 0.01;    // a larger change of the limits
  constexpr double kLongest = 4.0; // of the usual patience
  const double patience = m_method == m_implicit ? 32.0 : system.forces().isNonlinear() ? 384.0 : 768.0;
  if (m_boundIsOld && !takesBlocks()) return setBound(system, state);
  if (m_sinceBound < m_boundPatience * patience || !boundMatters(system)) return;
  const FastestMode before = m_mode;
  const double longer = std::min(2.0 * m_boundPatience, kLongest);
  setBound(system, state);
  if (relativeChange(before, m_mode) <= kNew) m_boundPatience = longer;
}

FastestMode StepDriver::fastestMode(const System& system, const MotionState& state)
{
  StepBound bound =
    m_bound; // each look changes how the next one looks: a question must not change the motion
  return bound.compute(system, state.x, state.v);
}

double StepDriver::explicitStep(const FastestMode& mode) const noexcept
{
  const auto& integrator = m_candidates[m_method].integrator;
  const double own = integrator->stableStep(mode);
  return std::isfinite(own) ? own : m_candidates[m_leapfrog].integrator->stableStep(mode);
}

} // namespace esm
