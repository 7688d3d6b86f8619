// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/rest/region_driver.h"

#include "core/dynamics/system/frame.h"

#include <algorithm>
#include <cmath>

namespace esm {
RegionDriver::RegionDriver(SolverSettings settings, Body& body, std::vector<Index> names)
  : m_settings(std::move(settings)),
    m_body(body),
    m_driver(m_settings, std::move(names)),
    m_policy(m_driver.policy()),
    m_on(m_settings.skipResting && !(m_settings.fixedStep > 0.0))
{}

StepReport RegionDriver::advance(double interval, const Budget& budget)
{
  MotionState& motion = m_body.motion;
  m_interruption = Interruption(budget.isSpent);
  if (!m_on) {
    m_allMoved = true;
    m_body.system.interruption = &m_interruption;
    StepReport report =
      m_driver.advance(m_body.system, motion, interval, budget.steps, workLeft(motion.time + interval));
    m_body.system.interruption = nullptr;
    m_work += m_driver.workDone(m_body.system, report);
    motion.endFrame();
    report.nodesAwake = static_cast<std::int64_t>(motion.x.size());
    return report;
  }
  StepReport report;
  m_limitText.clear();
  const double begin = motion.time, end = begin + interval;
  while (end - motion.time > 1e-9 * interval) {
    const double target = stretchEnd(end, interval);
    wakeForLoads(target == m_body.system.nextEvent(motion.time));
    if (m_mode == Mode::Rest)
      pass(target);
    else if (!stretch(target, budget, report))
      break;
  }
  motion.endFrame();
  if (m_mode == Mode::Part) static_cast<EnergySums&>(m_partMotion) = motion;
  report.simulatedTime = motion.time - begin;
  report.largestForce = largestTension(report.largestForce);
  report.nodesAwake = static_cast<std::int64_t>(m_region.awake().size());
  return report;
}

void RegionDriver::closeLoss()
{
  if (m_mode == Mode::Rest) return;
  const bool isPart = m_mode == Mode::Part;
  MotionState& moving = isPart ? m_partMotion : m_body.motion;
  moving.loss += m_driver.closeLoss(isPart ? m_partSystem : m_body.system, moving);
  m_body.motion.loss = moving.loss;
}

void RegionDriver::setAccuracy(double tolerance, double effort)
{
  m_settings.tolerance = tolerance;
  m_settings.effort = effort;
  m_driver.setAccuracy(m_driverHasWhole ? m_body.system : m_partSystem, tolerance, effort);
}

/// Where the next stretch ends: at an event of the loads (StepDriver sees to them itself when it has the
/// whole net), after a frame, or between two looks at nodes that seem to rest.
double RegionDriver::stretchEnd(double end, double interval) const noexcept
{
  const double begin = m_body.motion.time;
  double target = end;
  if (m_mode != Mode::Whole) {
    const double event = m_body.system.nextEvent(begin);
    target = std::abs(event - end) <= 1e-9 * interval ? event : std::min(event, end);
  }
  if (m_mode == Mode::Rest) return target;
  const double parts = std::ceil((target - begin) / kFrame - 0.5);
  if (parts > 1.0) target = begin + (target - begin) / parts;
  if (m_driver.takesBlocks()) return target; // a step of its own for the glance would cost as much again
  const bool someRest = 4 * m_watch.firstSlowCount() > m_region.awake().size();
  if (someRest && target - begin > m_policy.rest.lookGap)
    target = begin + m_policy.rest.glance * (target - begin);
  return target;
}

bool RegionDriver::stretch(double target, const Budget& budget, StepReport& report)
{
  const std::int64_t left = budget.steps > 0 ? budget.steps - report.steps : 0;
  if (budget.steps > 0 && left <= 0) {
    report.stepLimit = true;
    m_limitText = "the work limit of " + std::to_string(budget.steps) +
                  " steps was reached before the end of the interval; allow more steps or a larger tolerance";
    return false;
  }
  const bool isWhole = m_mode == Mode::Whole;
  System& system = isWhole ? m_body.system : m_partSystem;
  system.interruption = &m_interruption;
  const bool good = isWhole ? stretchWhole(target, left, report) : stretchPart(target, left, report);
  if (good) look(report);
  m_body.system.interruption = m_partSystem.interruption = nullptr;
  return good;
}

/// What checks have let pass is within the tolerance, however much they suspect.
double RegionDriver::livingError() const noexcept
{
  const ErrorScale& scale = m_driver.errorScale();
  const double most = m_driver.isRough() ? scale.spent : m_settings.tolerance * scale.displacement;
  return std::min(scale.spent, most) + scale.beyond;
}

/// Everything sleeps.
void RegionDriver::pass(double target)
{
  MotionState& motion = m_body.motion;
  ErrorScale scale = m_driver.errorScale();
  scale.squareOverTime += scale.displacement * scale.displacement * (target - motion.time);
  m_driver.setErrorScale(scale);
  takeOver(target);
}

/// Moves the time of the body to `target`, which may be an event.
void RegionDriver::takeOver(double target)
{
  const bool isEvent = target == m_body.system.nextEvent(m_body.motion.time);
  m_body.motion.time = target;
  if (!isEvent) return;
  m_body.system.enter(m_body.motion, true); // the part has counted the work
  m_bodiesAreKnown = false;
  watchLoads();
}

bool RegionDriver::stretchWhole(double target, std::int64_t maxSteps, StepReport& report)
{
  MotionState& motion = m_body.motion;
  const double event = m_body.system.nextEvent(motion.time);
  const StepReport whole =
    m_driver.advance(m_body.system, motion, target - motion.time, maxSteps, workLeft(target));
  m_work += m_driver.workDone(m_body.system, whole);
  report.add(whole);
  m_settling.countWork(whole.springsEvaluated);
  m_allMoved = true;
  if (motion.time >= event) {
    watchLoads();
    m_bodiesAreKnown = false;
  }
  return report.good();
}

bool RegionDriver::stretchPart(double target, std::int64_t maxSteps, StepReport& report)
{
  MotionState& motion = m_body.motion;
  const ErrorScale scale = m_driver.errorScale();
  const StepReport part =
    m_driver.advance(m_partSystem, m_partMotion, target - motion.time, maxSteps, workLeft(target));
  m_work += m_driver.workDone(m_partSystem, part);
  report.add(part);
  if (part.good()) m_partMotion.time = target; // no rounding
  const double allowed = budget(), missed = missedMotion(nullptr);
  if (part.good() && missed > allowed && grow(true)) { // too late: once more with a larger part
    report.rejectedSteps += part.steps;
    m_driver.setErrorScale(scale);
    gather(); // what is thrown away has lost nothing
    applyChange();
    return true;
  }
  m_settling.countWork(part.springsEvaluated);
  scatter();
  m_moved.insert(m_moved.end(), m_region.awake().begin(), m_region.awake().end());
  m_allMoved = m_allMoved || m_moved.size() > 2 * motion.x.size();
  takeOver(m_partMotion.time);
  if (part.good() && missed > m_policy.rest.growsAt * allowed) grow(false);
  applyChange();
  return part.good();
}

/// After a stretch: who has come to rest?
void RegionDriver::look(StepReport& report)
{
  const MotionState& motion = m_body.motion;
  const std::vector<Index>& awake = m_region.awake();
  const ErrorScale& scale = m_driver.errorScale();
  const SettlingBudget missable{budget(), undisturbed(), std::max(fadingTime(scale), creepingTime(scale))};
  const double limit =
    std::sqrt(m_policy.rest.slowShare * missable.squareAt(missable.fading) / std::max(m_playedCount, 1.0));
  if (!m_watch.lookIsDue(motion.time)) {
    m_watch.glance(awake, motion, limit);
    return;
  }
  m_watch.look(awake, motion, limit);
  m_watch.pin(m_loads.moving());
  keepBodiesAwake();
  const std::size_t all = awake.size();
  if (m_watch.calmCount() == all || settles(report)) {
    letSleep(std::vector<Index>(awake));
  } else if (isDivisible()) {
    // Somebody who stays awake has to watch over those who only are slow.
    const bool watched = m_watch.slowCount() < all;
    const std::size_t count = watched ? m_watch.slowCount() : m_watch.calmCount();
    if (count * (m_mode == Mode::Whole ? 2 : 4) < all) return;
    const std::size_t least = (all + 4) / 5;
    const std::vector<Index> sleepers = wholeBodies(
      m_region.inside(watched ? m_watch.slow() : m_watch.calm(), std::max(4, edgeDepth()), least));
    if (sleepers.size() >= least) letSleep(sleepers);
  }
  applyChange();
}

/// Whether all that moves could be brought to rest at once.
bool RegionDriver::settles(StepReport& report)
{
  if (isMoved()) return false;
  for (std::size_t body = 0; body < bodies().count(); ++body)
    if (movesAsOne(body)) return false;
  const ErrorScale& scale = m_driver.errorScale();
  const double erring = scale.spent * scale.spent * static_cast<double>(m_body.motion.x.size());
  const SettlingBudget missable{settlingBudget(), undisturbed(), fadingTime(scale), dampersPower(scale),
                                erring};
  return settleWithin(missable, report);
}

bool RegionDriver::settleWithin(const SettlingBudget& missable, StepReport& report)
{
  const bool isPart = m_mode == Mode::Part;
  bodies().begin(m_body.system, m_body.motion);
  if (!m_settling.settleIfDue(isPart ? m_partSystem : m_body.system, isPart ? m_partMotion : m_body.motion,
                              missable, m_settings.effort, report))
    return false;
  if (isPart) scatter();
  bodies().keep(m_body.system, m_body.motion, 0.0); // a place that is found by iterations may be beside it
  return true;
}

/// By loads or tools.
bool RegionDriver::isMoved() const
{
  const std::vector<ToolSpring>& tools = m_body.system.tools();
  return !m_loads.moving().empty() || std::any_of(tools.begin(), tools.end(), [](const ToolSpring& tool) {
    return !tool.targetVelocity.isZero();
  });
}

/// How long the net has been left alone or, where the end is known, the time over which budget() will be the
/// mean that is allowed [s]; 0 while something moves it.
double RegionDriver::undisturbed() const
{
  if (isMoved()) return 0.0;
  const double time = m_body.motion.time, end = m_driver.knownEnd(time);
  const ErrorScale& scale = m_driver.errorScale();
  const double since = std::min(scale.calm, time - m_stirred), mean = meanSquare();
  if (!std::isfinite(end) || !(mean > 0.0)) return since;
  const double now = scale.displacement * scale.displacement;
  return std::max(since, (scale.squareOverTime + now * (end - time)) / mean);
}

/// Up to `end` or, where it is later and known, that of the motion [spring evaluations].
double RegionDriver::workLeft(double end) const noexcept
{
  if (!(m_settings.workLimit > 0.0)) return StepDriver::kInfinity;
  const double springs = std::max<double>(static_cast<double>(m_body.system.forces().activeSprings()), 1.0);
  const double frames = std::max({m_settings.duration, end, kFrame}) / kFrame;
  return m_settings.workLimit * springs * frames - m_work;
}

FastestMode RegionDriver::fastestMode()
{
  if (m_mode == Mode::Whole) return m_driver.fastestMode(m_body.system, m_body.motion);
  StepBound bound; // asked for rarely: not worth the room of a whole net in between
  bound.prepare(m_driver.asksForDecay());
  return bound.compute(m_body.system, m_body.motion.x, m_body.motion.v);
}

void RegionDriver::clearMoved() noexcept
{
  m_moved.clear();
  m_allMoved = false;
}

} // namespace esm
