// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/step_driver.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace esm {
namespace {

constexpr double kFrame = 1.0 / 60.0; ///< longest stretch [s]
constexpr double kErrorHorizon = 2.0; ///< motion over which errors add up at least, if nothing damps them [s]
constexpr double kShortestHorizon = 0.1; ///< [s]
constexpr double kMemory = 0.2;          ///< over which the net's damping is averaged [s]
constexpr double kSolveShare = 0.1;      ///< of the budget, for what implicit solvers leave
constexpr double kSafety = 0.8;          ///< share of the tolerance that is spent on purpose
/// Of the step after one check: an error has its zeros, one of them must not decide for long.
constexpr double kMostGrowth = 3.0;
constexpr int kMostAttempts = 24; ///< of one stretch
/// Of a stretch that is done twice, if that is many steps [s].
constexpr double kCheckLength = kFrame / 2.0;
constexpr double kSettlingTime = 0.15;     ///< after the start or an event, in which motion unfolds [s]
constexpr int kLongestCheckGap = 24;       ///< stretches
constexpr double kMostEffort = 3.0;        ///< for one frame, before descent takes over
constexpr double kLeastShare = 1.0 / 8.0;  ///< of it for a stretch, however short
constexpr double kMostDescentSteps = 16.0; ///< of one stretch
constexpr int kLongestDescent = 64;        ///< stretches before something else is tried again
/// Energy may grow by this much in a stretch without cause, in steps whose error nobody measures, or in
/// explicit ones, which stir up the fastest modes a little at their limit.
constexpr double kGrowth = 0.02, kCoarseGrowth = 0.05;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

double sumOfSquares(const NodeArray& a, const NodeArray& b) noexcept
{
  Lanes sum = {0, 0, 0, 0};
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Lanes d = a[i] - b[i];
    sum += d * d;
  }
  return sumLanes(sum);
}

/// RMS over `count` nodes, of which those outside the array have the value 0.
double rms(const NodeArray& a, const NodeArray& b, std::size_t count) noexcept
{
  return std::sqrt(sumOfSquares(a, b) / static_cast<double>(std::max<std::size_t>(count, 1)));
}

double rms(const NodeArray& a, std::size_t count) noexcept
{
  Lanes sum = {0, 0, 0, 0};
  for (const Lanes& value : a) sum += value * value;
  return std::sqrt(sumLanes(sum) / static_cast<double>(std::max<std::size_t>(count, 1)));
}

} // namespace

StepReport StepDriver::advance(System& system, MotionState& state, double interval, std::int64_t maxSteps)
{
  StepReport report;
  m_limitText.clear();
  system.springsEvaluated = 0;
  system.solverWork = 0.0;
  system.workLimit = kInfinity;
  m_maxSteps = maxSteps;
  const double begin = state.time;
  double end = begin + interval;
  while (state.time < end) {
    const double event = system.nextEvent(state.time);
    // An event a rounding error away from the end of the interval is the end.
    if (std::abs(event - end) <= 1e-9 * interval) end = event;
    const double target = std::min(event, end);
    const bool isFixed = m_settings.fixedStep > 0.0;
    const double longest =
      m_untilCheck <= 0 && controlledStep(kFrame) < kCheckLength / 8.0 ? kCheckLength : kFrame;
    const double stretches = isFixed ? 1.0 : std::ceil((target - state.time) / longest * (1.0 - 1e-9));
    const double stretchEnd = stretches > 1.0 ? state.time + (target - state.time) / stretches : target;
    const bool done = isFixed ? stretchFixed(system, state, stretchEnd, report)
                              : stretchControlled(system, state, stretchEnd, report);
    if (!done) break;
    if (state.time != event) continue;
    if (system.enter(state, false)) {
      for (Candidate& candidate : m_candidates)
        if (candidate.prepared) candidate.integrator->constraintsChanged(system);
      m_untilCheck = 0;
      m_checkGap = 1;
      m_calm = 0.0;
      m_stepsSinceBound = std::numeric_limits<std::int64_t>::max() / 2;
    } else {
      current().restart();
      m_untilCheck = 0;
      m_calm = 0.0;
    }
  }
  report.simulatedTime = state.time - begin;
  report.springsEvaluated = system.springsEvaluated;
  report.largestForce = system.forces().largestTension(state.x.data(), state.v.data());
  return report;
}

StepDriver::Run StepDriver::run(System& system, MotionState& state, double end, std::int64_t steps,
                                StepReport& report)
{
  const double begin = state.time, h = (end - begin) / static_cast<double>(steps);
  const std::int64_t allowed = m_maxSteps > 0 ? std::max<std::int64_t>(m_maxSteps - report.steps, 0) : steps;
  const bool isLimited = allowed < steps;
  if (isLimited && allowed == 0) return Run::Limit;
  const double runEnd = isLimited ? begin + static_cast<double>(allowed) * h : end;
  const StepResult result = current().run(system, state, runEnd, std::min(allowed, steps), report);
  if (result == StepResult::NonFinite) return Run::NonFinite;
  if (result == StepResult::NotConverged) return Run::NotConverged;
  if (isLimited) return Run::Limit;
  report.smallestStep = report.smallestStep > 0.0 ? std::min(report.smallestStep, h) : h;
  m_stepsSinceBound += steps;
  return Run::Done;
}

bool StepDriver::stretchFixed(System& system, MotionState& state, double end, StepReport& report)
{
  current().setSolveTolerance(1e-12 * m_extent, false);
  const double steps = std::max(1.0, std::ceil((end - state.time) / m_settings.fixedStep * (1.0 - 1e-9)));
  const Run result = run(system, state, end, static_cast<std::int64_t>(std::min(steps, 1e15)), report);
  if (result != Run::Done) giveUp(result, report);
  return result == Run::Done;
}

/// The step that is both stable and accurate.
double StepDriver::controlledStep(double length) noexcept
{
  // The bound is exact only for a frozen net; stiffening springs get a margin until the next look.
  const double stable = 0.95 * current().stableStep(m_mode);
  return std::min({stable, std::max(m_candidates[m_method].accurateStep, floorStep()), length});
}

bool StepDriver::stretchControlled(System& system, MotionState& state, double end, StepReport& report)
{
  const double length = end - state.time;
  refreshBound(system, state);
  m_start = state;
  m_growth = m_grown;
  if (!m_auto && current().isUncontrolled()) {
    current().setSolveTolerance(1e-9 * m_extent, false);
    const Run result = run(system, state, end, 1, report);
    if (result != Run::Done) return giveUp(result, report), false;
    measure(system, state, length);
    return true;
  }
  if (m_auto) {
    if (m_descents > 0) return stretchByDescent(system, state, end, report);
    const double share = std::max(length / kFrame, kLeastShare);
    system.workLimit =
      system.workDone() + kMostEffort * std::max(m_settings.effort, 2.0 * m_leastCost) * share;
  }
  for (int attempt = 0; attempt < kMostAttempts; ++attempt) {
    const double step = controlledStep(length);
    const double count = std::ceil(length / step * (1.0 - 1e-9));
    if (isTooDear(system, count * current().stepCost(system))) {
      if (!fallBackToLeapfrog(system, length)) break;
      continue;
    }
    if (!(count < 1e12)) return giveUp(Run::NotConverged, report), false;
    const auto steps = static_cast<std::int64_t>(count);
    // An implicit solver measures over the nodes that it has.
    const auto whole = static_cast<double>(m_part.wholeCount), here = static_cast<double>(state.x.size());
    const double budget = budgetFor(m_start, length) * std::sqrt(whole / std::max(here, 1.0));
    // What nobody checks needs no digits beyond what the eye can see.
    const bool unchecked = m_toleranceGivenUp && m_method == m_implicit;
    current().setSolveTolerance(std::max(kSolveShare * budget / count, (unchecked ? 1e-4 : 1e-13) * m_extent),
                                unchecked);
    Run result = run(system, state, end, steps, report);
    if (unchecked && result == Run::Done && energyAppeared(system, state, kGrowth)) { // once more, exactly
      report.rejectedSteps += steps;
      state = m_start;
      current().restart();
      current().setSolveTolerance(std::max(kSolveShare * budget / count, 1e-6 * m_extent), false);
      result = run(system, state, end, steps, report);
      if (result == Run::Done && energyAppeared(system, state, kGrowth)) break;
    }
    if (result == Run::Limit) return stopAtLimit(system, state, report), false;
    if (m_auto && result != Run::Done && (unchecked || system.isExhausted())) break;
    const bool isCheap =
      m_method == m_implicit || count >= 32.0 || m_untilCheck <= 0; // to look at the energy
    if (m_auto && result == Run::Done && !unchecked && isCheap &&
        energyAppeared(system, state, kCoarseGrowth))
      result = Run::NotConverged; // on its way to infinity
    if (result == Run::Done) {
      const bool isDue = !unchecked && checkDue(system, state, rms(state.v, m_part.wholeCount));
      const bool isUnaffordable =
        isTooDear(system, static_cast<double>(2 * steps) * current().stepCost(system));
      if (!isDue || isUnaffordable) { // a step that nobody could afford to check is better than none
        --m_untilCheck;
        report.rough = report.rough || unchecked || m_roughAtCheck || isDue;
        measure(system, state, length);
        if (unchecked) reconsider(system);
        return true;
      }
      m_coarse = state.x;
      m_coarseV = state.v;
      state = m_start;
      current().restart();
      result = run(system, state, end, 2 * steps, report);
      if (result == Run::Limit) return stopAtLimit(system, state, report), false;
    }
    if (result != Run::Done) {
      if (isTooDear(system, 0.0)) break;
      if (!retreat(system, state, result, attempt, report)) return false;
      continue;
    }
    const double ratio = std::ldexp(1.0, current().order()); // of the errors at h and h/2
    const double coarseError = distance(state, length) * ratio / (ratio - 1.0);
    // Kept is the finer run; at the floor step it is kept as it is.
    const double allowed = budgetFor(state, length);
    // Below the floor a rough answer is taken, but not one that runs away: a tenth of all displacement.
    const double rough = 0.1 * std::max(rmsDisplacement(m_start.x), 1e-6 * m_extent);
    const bool atFloor = length / count <= floorStep() && coarseError <= rough;
    const bool sane = !m_auto || !energyAppeared(system, state, kCoarseGrowth);
    // Where another attempt could not be paid for, this one must do.
    const bool isLast = isTooDear(system, 3.0 * count * current().stepCost(system));
    const bool accepted = sane && (coarseError / ratio <= allowed || atFloor || isLast);
    learn(coarseError, allowed, length / count);
    if (accepted) {
      m_roughAtCheck = coarseError / ratio > allowed;
      report.rough = report.rough || m_roughAtCheck;
      if (m_roughAtCheck) sayToleranceGivenUp(system);
      measure(system, state, length);
      reconsider(system);
      return true;
    }
    report.rejectedSteps += 3 * steps;
    state = m_start;
    m_settled = 0;
    reconsider(system);
    current().restart();
  }
  if (!m_auto) return giveUp(Run::NotConverged, report), false;
  report.rejectedSteps += 1;
  state = m_start;
  m_descentTerm = std::clamp(2 * m_descentTerm, 1, kLongestDescent);
  m_descents = m_descentTerm;
  m_growth = m_grown;
  return stretchByDescent(system, state, end, report);
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
  use(m_leapfrog, system);
  m_candidates[m_leapfrog].accurateStep = explicitLimit();
  m_settled = 4;
  explain(system);
  return true;
}

/// What always succeeds: a few damped steps that gain no energy.
bool StepDriver::stretchByDescent(System& system, MotionState& state, double end, StepReport& report)
{
  const double length = end - state.time;
  system.workLimit = kInfinity;
  const Method other = m_method;
  prepare(m_descent, system);
  m_method = m_descent;
  const double affordable = 0.5 * m_settings.effort * length / kFrame / current().stepCost(system);
  const auto steps = static_cast<std::int64_t>(std::clamp(affordable, 1.0, kMostDescentSteps));
  const Run result = run(system, state, end, steps, report);
  m_method = other;
  current().restart();
  sayDescent(system);
  if (result != Run::Done) return giveUp(result, report), false;
  report.rough = true;
  m_untilCheck = 0;
  m_checkGap = 1;
  measure(system, state, length);
  if (--m_descents <= 0) reconsider(system);
  return true;
}

/// Whether the net has more energy than at the start of the stretch without work that explains it, by more
/// than this share of what was there, has been worked and has fallen.
bool StepDriver::energyAppeared(const System& system, const MotionState& state, double share)
{
  const double kinetic = system.kineticEnergy(m_start.v), elastic = system.elasticEnergy(m_start.x);
  const double high = system.forces().gravityEnergy(m_start.x.data());
  const double fallen = high - system.forces().gravityEnergy(state.x.data());
  const double work = state.work - m_start.work;
  const double gained =
    system.kineticEnergy(state.v) - kinetic + system.elasticEnergy(state.x) - elastic - fallen - work;
  // Of sums with rounding errors; and what nobody can see.
  double mass = 0.0;
  for (const double m : system.mass()) mass += m;
  const double least = 1e-12 * (std::abs(high) + mass * m_extent * m_extent);
  const double scale = kinetic + std::abs(elastic) + std::abs(work) + std::abs(fallen);
  const double sum = std::max(m_grown, 0.0) + gained; // what came slowly is no better
  if (!(sum <= share * scale + least)) return true;
  m_growth = sum;
  return false;
}

/// The work limit came in the middle of a stretch that nobody has checked. What has been done is kept, so
/// that limited calls get on too, unless energy came from nowhere: then the start of the stretch is the last
/// good state.
void StepDriver::stopAtLimit(const System& system, MotionState& state, StepReport& report)
{
  if (energyAppeared(system, state, kGrowth)) {
    state = m_start;
    current().restart();
    m_candidates[m_method].accurateStep = 0.25 * controlledStep(kFrame);
    m_untilCheck = 0;
  }
  giveUp(Run::Limit, report);
}

/// After a failed run: back to the start of the stretch with a smaller step. @return false to give up.
bool StepDriver::retreat(System& system, MotionState& state, Run failure, int attempt, StepReport& report)
{
  ++report.rejectedSteps;
  const double tried = controlledStep(kFrame);
  state = m_start;
  if (attempt + 1 >= kMostAttempts) return giveUp(failure, report), false;
  m_candidates[m_method].accurateStep = tried / 4.0;
  m_floorStep = std::min(m_floorStep, tried / 4.0);
  m_untilCheck = 0;
  m_checkGap = 1;
  if (m_auto && m_method != m_implicit && attempt >= 4) {
    use(m_implicit, system);
    m_settled = 64;
    explain(system);
  }
  current().restart();
  return true;
}

bool StepDriver::checkDue(const System&, const MotionState&, double speed) const noexcept
{
  return m_untilCheck <= 0 || !(speed <= 2.0 * m_topSpeed); // twice as fast as ever: look closer
}

/// From the error of steps of size `step` to the step that would just spend the budget. A step whose error is
/// near the budget stays: to follow every wave of the error would mean to check for ever.
void StepDriver::learn(double error, double budget, double step)
{
  const double order = current().order(), share = error / budget;
  const bool isImplicit = !isExplicit(m_candidates[m_method]);
  const double gain = share > 0.0 ? std::pow(1.0 / share, 1.0 / order) : 1e3;
  double& accurate = m_candidates[m_method].accurateStep;
  accurate = step;
  if (!(share <= 1.2) || share < 0.3)
    accurate *= std::clamp(0.9 * gain, isImplicit ? 0.1 : 1e-4, kMostGrowth);
  if (!(share <= 1.2)) {
    m_checkGap = std::max(1, m_checkGap / 4);
  } else {
    m_checkGap = std::min(2 * m_checkGap, m_calm < kSettlingTime ? 2 : kLongestCheckGap);
  }
  m_untilCheck = m_checkGap;
  if (isImplicit) return;
  // Motion that is easier or harder for this method is so for the others. Methods of low order err in slower
  // motion, which changes less: they gain no more than this one.
  Candidate& here = m_candidates[m_method];
  const double estimate = step * std::min(0.9 * gain, 1e3);
  const double change = here.estimate > 0.0 ? estimate / here.estimate : 1.0;
  here.estimate = estimate;
  for (Candidate& other : m_candidates)
    if (&other != &here && isExplicit(other) && (here.isMeasured || !other.isMeasured))
      other.accurateStep *=
        std::clamp(std::pow(change, std::min(1.0, order / other.integrator->order())), 0.2, 5.0);
  here.isMeasured = true;
}

/// Error that a stretch may add [m], RMS over nodes.
double StepDriver::budgetFor(const MotionState& state, double length) const noexcept
{
  double scale = std::max(m_displacement, rmsDisplacement(state.x));
  if (state.time > 0.0) scale = std::max(scale, std::sqrt(m_squareOverTime / state.time));
  // In the first moments the displacement is not yet what the motion will make of it.
  if (state.time < 6.0 * kFrame)
    scale = std::max(scale, std::max(m_speed, rms(state.v, m_part.wholeCount)) * 6.0 * kFrame);
  return kSafety * m_settings.tolerance * std::max(scale, 1e-6 * m_extent) *
         std::min(1.0, length / errorHorizon(state.time));
}

double StepDriver::rmsDisplacement(const NodeArray& x) const noexcept
{
  const double sum = sumOfSquares(x, m_rest) + m_part.squareElsewhere;
  return std::sqrt(sum / static_cast<double>(std::max<std::size_t>(m_part.wholeCount, 1)));
}

/// How far apart the two runs of a stretch are [m]. In a stretch that is short against a slow oscillation an
/// error shows in the velocity first: its amplitude will be the velocity's error times the motion's own time.
/// Where the velocities part faster than that, fast waves do it, which show in the positions at once.
double StepDriver::distance(const MotionState& state, double length) const noexcept
{
  constexpr double kSlowest = 0.08; ///< [s]
  const double x = rms(m_coarse, state.x, m_part.wholeCount);
  const double v = rms(m_coarseV, state.v, m_part.wholeCount);
  if (!(x > 0.0) || !(m_recentPath > 0.0)) return x;
  const double time = std::min(m_displacement * std::sqrt(kMemory / m_recentPath), kSlowest);
  const double slow = 2.0 / (length * v / x); // 1 where a constant acceleration parts the runs
  return x * std::max(1.0, time * (v / x) * std::min(1.0, slow * slow));
}

/// How long an error lives [s]. It fades as the motion itself does. Amplitudes of what oscillates fade by the
/// rate heat / (4 kinetic energy); slow modes, where errors gather, by a quarter of that. What creeps fades
/// in the time that it takes to its goal, displacement over speed. Both are averaged over the last fifth of a
/// second. Without damping errors add up from the start on.
double StepDriver::errorHorizon(double time) const noexcept
{
  const double longest = std::max(kErrorHorizon, time);
  if (!(m_recentHeat > 0.0) || !(m_recentPath > 0.0)) return longest;
  const double creeping = 2.0 * m_displacement * std::sqrt(kMemory / m_recentPath);
  return std::clamp(std::max(16.0 * m_recentKinetic / m_recentHeat, creeping), kShortestHorizon, longest);
}

void StepDriver::measure(const System& system, const MotionState& state, double length) noexcept
{
  m_calm += length;
  m_grown = m_growth;
  const double fade = std::exp(-length / kMemory);
  m_recentHeat = fade * m_recentHeat + std::max(state.heat - m_start.heat, 0.0);
  m_recentKinetic = fade * m_recentKinetic + system.kineticEnergy(state.v) * length;
  m_displacement = rmsDisplacement(state.x);
  m_squareOverTime += m_displacement * m_displacement * length;
  m_speed = rms(state.v, m_part.wholeCount);
  m_topSpeed = std::max(m_topSpeed, m_speed);
  m_recentPath = fade * m_recentPath + m_speed * m_speed * length;
}

void StepDriver::setBound(const System& system, const MotionState& state)
{
  m_mode = m_bound.compute(system, state.x, state.v);
  m_stepsSinceBound = 0;
  for (Candidate& candidate : m_candidates) candidate.integrator->tune(system, m_mode);
  weighLeastCost(system);
}

void StepDriver::refreshBound(const System& system, const MotionState& state)
{
  const std::int64_t patience = m_method == m_implicit ? 32 : system.forces().isNonlinear() ? 128 : 512;
  if (m_stepsSinceBound >= patience) setBound(system, state);
}

FastestMode StepDriver::fastestMode(const System& system, const MotionState& state)
{
  return m_bound.compute(system, state.x, state.v);
}

double StepDriver::explicitStep(const FastestMode& mode) const noexcept
{
  const auto& integrator = m_candidates[m_method].integrator;
  const double own = integrator->stableStep(mode);
  return std::isfinite(own) ? own : m_candidates[m_leapfrog].integrator->stableStep(mode);
}

} // namespace esm
