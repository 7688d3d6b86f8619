// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/rest/settling.h"

#include "core/dynamics/planner/policy.h"
#include "core/dynamics/system/frame.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace esm {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::infinity();

/// Mean square over what is left of the motion, if that ended now.
/// @param way, swing  sums of squares: how far the goal is, and how far the velocities carry a net beyond it
double missedOf(double way, double swing) noexcept
{
  return std::max(way, 0.5 * (way + swing));
}

/// What is missed over what may be; a net that creeps takes amplitude over speed to its goal, if that is
/// longer than it takes to fade. Rises with what is missed.
/// @param missed, speed  sums of squares over the nodes
double shareOf(double missed, double speed, const SettlingBudget& budget) noexcept
{
  const double creeping = speed > 0.0 ? std::sqrt(missed / speed) : std::numeric_limits<double>::infinity();
  return missed / budget.squareAt(std::max(budget.fading, creeping));
}

} // namespace

double SettlingBudget::squareAt(double fadingTime) const noexcept
{
  const double gain = since > 0.0 ? 1.0 + 2.0 * since / fadingTime : 1.0;
  return square * std::min(gain, kPolicy.settling.mostSquares);
}

void Settling::begin() noexcept
{
  forget();
  m_isNear = false;
  m_dueSpeed = m_dueTime = m_work = m_workAtGlance = 0.0;
  m_looksLeft = 0;
}

void Settling::forget() noexcept
{
  m_equilibrium.forget();
}

double Settling::patience() const noexcept
{
  return m_isNear ? 1.0 : m_policy->settling.patience;
}

bool Settling::mayGlance(const System& system) const noexcept
{
  const double cost = m_policy->settling.glanceCost * static_cast<double>(system.forces().activeSprings());
  return patience() * cost <= m_work - m_workAtGlance;
}

/// By what is known so far: what a factor costs is so once it is laid out.
bool Settling::mayAttempt(const System& system, double effort) const noexcept
{
  if (!m_equilibrium.takesFactor(system) || m_equilibrium.isLaidOut())
    return attemptCost(system) <= std::min(m_work / patience(), effort);
  return m_equilibrium.layoutCost(system) <= std::min(m_work, m_policy->settling.longestTry * effort);
}

double Settling::attemptCost(const System& system) const noexcept
{
  return m_equilibrium.solveCost(system) + (m_equilibrium.isKnown() ? 0.0 : m_equilibrium.stepCost(system));
}

/// Whether settle() is worth what it costs, by what has been learned.
bool Settling::isDue(const System& system, const MotionState& motion, double speed, double effort)
{
  if (m_looksLeft > 0 && (motion.time < m_dueTime || speed > m_dueSpeed)) {
    --m_looksLeft;
    return false;
  }
  if (!mayGlance(system) || !mayAttempt(system, effort)) return false;
  m_looksLeft = m_policy->settling.longestWait;
  m_workAtGlance = m_work;
  return true;
}

bool Settling::settleIfDue(System& system, MotionState& motion, const SettlingBudget& budget, double effort,
                           StepReport& report)
{
  const double speed = std::sqrt(sumOfSquares(motion.v) / static_cast<double>(motion.x.size())); // RMS
  const double most = budget.squareAt(budget.fading);
  const double within = std::sqrt(most / static_cast<double>(motion.x.size()));
  if (speed * kFrame > m_policy->settling.near * within) {
    m_dueSpeed = std::numeric_limits<double>::infinity();
    return false;
  }
  double missed = 0.0;
  if (m_equilibrium.holds(system, motion.time, report)) {
    missed = shareOfWay(motion, budget, nullptr);
    if (missed <= 1.0 && !mayAttempt(system, effort)) return false;
  } else {
    if (!isDue(system, motion, speed, effort)) return false;
    missed = glance(system, motion, budget, report);
  }
  if (missed <= 1.0) missed = attempt(system, motion, budget, effort, report);
  const double times = std::sqrt(std::max(missed, 1.0)); // of the amplitude that may be missed
  m_isNear = times < m_policy->settling.nearlyThere;
  if (!std::isfinite(missed)) { // nothing to go by
    m_looksLeft = m_policy->settling.waitUnknown;
    m_dueSpeed = 0.0;
    return false;
  }
  m_dueSpeed = m_isNear ? std::numeric_limits<double>::infinity() : m_policy->settling.slower * speed / times;
  m_dueTime = motion.time + m_policy->settling.leastWait * budget.fading * std::log(times);
  return missed <= 1.0;
}

/// settle(); once more by a factor where gradients take too long, as soon as that is worth it.
double Settling::attempt(System& system, MotionState& motion, const SettlingBudget& budget, double effort,
                         StepReport& report)
{
  double missed = kUnknown;
  m_affordable = m_policy->settling.search * std::min(m_work, effort);
  if (!m_equilibrium.takesFactor(system)) {
    const double springs = std::max(static_cast<double>(system.forces().activeSprings()), 1.0);
    const bool mayTakeFactor = std::isfinite(m_equilibrium.layoutCost(system));
    const double most = mayTakeFactor ? m_policy->settling.fewIterations : m_policy->balance.iterations;
    m_iterations = // of each of two solutions
      static_cast<int>(std::clamp(0.5 * m_policy->settling.longestTry * effort / springs,
                                  static_cast<double>(m_policy->settling.fewIterations), most));
    missed = settle(system, motion, budget, report);
    if (m_equilibrium.takesFactor(system)) return attempt(system, motion, budget, effort, report);
  } else {
    if (!mayAttempt(system, effort)) return kUnknown;
    m_equilibrium.layOut(system);
    if (attemptCost(system) <= std::min(m_work, effort)) missed = settle(system, motion, budget, report);
  }
  m_work = m_workAtGlance = 0.0;
  return missed;
}

double Settling::glance(System& system, MotionState& motion, const SettlingBudget& budget, StepReport& report)
{
  if (!system.forces().pressure().isEmpty()) return 0.0;
  m_glances.prepare(system, motion.x, m_policy->balance.inertia);
  const double speed = sumOfSquares(motion.v),
               enough = m_policy->settling.farEnough * budget.squareAt(budget.fading);
  m_way.resize(motion.x.size());
  scaleNodes(m_way.size(), system.mass().data(), motion.v.data(), m_way.data());
  const double momentum = std::sqrt(sumOfSquares(m_way));
  double way = 0.0, swing = 0.0;
  if (momentum > 0.0) {
    const double perEnergy = std::sqrt(speed) / momentum; // |v| |y| >= |v|/|M v| (M v).y
    swing = perEnergy * m_glances.below(system, m_way, 2.0 * enough / perEnergy, m_policy->settling.glances);
  }
  if (missedOf(way, swing) <= enough && !m_glances.metNegative()) {
    const double force = m_equilibrium.forcesAt(system, motion.time, motion.x, m_force, report);
    if (force > 0.0)
      way = std::pow(
        m_glances.below(system, m_force, force * std::sqrt(enough), m_policy->settling.glances) / force, 2);
  }
  return m_glances.metNegative() ? kUnknown : shareOf(missedOf(way, swing), speed, budget);
}

/// What is missed over what may be, by the way to the equilibrium, into m_way, and what the velocities carry
/// the net beyond it; null: nothing, a bound from below.
double Settling::shareOfWay(const MotionState& motion, const SettlingBudget& budget, const NodeArray* swing)
{
  const std::size_t nodes = motion.x.size();
  m_way.resize(nodes);
  double way = 0.0, local = 0.0;
  for (std::size_t i = 0; i < nodes; ++i) {
    m_way[i] = m_equilibrium.place()[i] - motion.x[i];
    const double here = dot(m_way[i], m_way[i]);
    way += here;
    const double beyond =
      swing ? std::sqrt(dot(motion.v[i], motion.v[i]) * dot((*swing)[i], (*swing)[i])) : 0.0;
    local = std::max(local, here + beyond);
  }
  const double speed = sumOfSquares(motion.v);
  const double missed = missedOf(way, swing ? std::sqrt(speed * sumOfSquares(*swing)) : 0.0);
  const double share = shareOf(
    std::max(missed, local / m_policy->settling.mostLocal * static_cast<double>(nodes)) + budget.erring,
    speed, budget);
  return std::isfinite(share) ? share : kUnknown;
}

Equilibrium::Aim Settling::aimOf(const SettlingBudget& budget) const noexcept
{
  return {m_policy->settling.forGood * budget.square,
          m_policy->settling.farEnough * budget.squareAt(budget.fading), m_affordable, m_iterations};
}

double Settling::settle(System& system, MotionState& motion, const SettlingBudget& budget, StepReport& report)
{
  if (!m_equilibrium.holds(system, motion.time, report)) {
    const double way = m_equilibrium.find(system, motion, aimOf(budget), report);
    if (!m_equilibrium.isKnown())
      return std::isfinite(way) ? shareOf(way, sumOfSquares(motion.v), budget) : kUnknown;
  }
  double share = shareOfWay(motion, budget, nullptr);
  if (!(share <= 1.0)) return share;
  m_swing.resize(motion.x.size());
  scaleNodes(m_swing.size(), system.mass().data(), motion.v.data(), m_swing.data());
  if (!m_equilibrium.solve(system, m_swing)) return kUnknown;
  share = shareOfWay(motion, budget, &m_swing);
  if (!(share <= 1.0)) return share;
  const double loads = system.loadPower(motion.time, m_way); // over the way: their work
  const double energy = system.kineticEnergy(motion.v) + system.storedEnergy(motion.x) -
                        system.storedEnergy(m_equilibrium.place()) + loads;
  if (!(energy >= 0.0)) { // it is on its way to another one
    m_equilibrium.drop();
    return kUnknown;
  }
  if (budget.power > 0.0) {
    SettlingBudget whole = budget;
    whole.fading = std::max(budget.fading, m_policy->settling.slowestFade * 2.0 * energy / budget.power);
    share = shareOfWay(motion, whole, &m_swing);
    if (!(share <= 1.0)) return share;
  }
  motion.work += loads;
  motion.heat += energy;
  motion.x = m_equilibrium.place(); // same size: no allocation
  motion.v.assign(motion.v.size(), Lanes{0, 0, 0, 0});
  return share;
}

} // namespace esm
