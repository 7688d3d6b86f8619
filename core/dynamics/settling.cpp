// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/settling.h"

#include "core/dynamics/frame.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace esm {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::infinity();
constexpr double kInertia = 1e-2; ///< share of the mass in the stiffness, 1/(10 s)^2 [1/s^2]
/// Of the forces, that may be left at the goal: the net is nearly linear on its way there, or it is not near.
constexpr double kLeft = 0.5;
/// Further steps with the same factor, each of which must be that much shorter than the one before: forces
/// along stiff springs hardly fall with the first one, which knows them at the start only, and vanish with
/// the second.
constexpr int kMostCorrections = 3;

/// Of the mean square over the nodes, that a single one may miss: nobody shall see one spot stop at a blow.
constexpr double kMostLocal = 25.0;
constexpr std::size_t kMostNodes = 10000; ///< a factor of 150 MB in a solid
constexpr double kNear = 5.0; ///< speeds with which nets of usual frequencies are as near as they must be
constexpr double kLayoutCost = 1500.0; ///< spring evaluations per node, measured
constexpr double kLongestLayout = 4.0; ///< frames
constexpr double kPatience = 3.0;
constexpr int kLongestWait = 32; ///< looks
constexpr int kWaitUnknown = 4;  ///< the same after an attempt that told no distance: the net bends too much
/// Of the time in which amplitudes fade to what may be missed: no attempt before. They are not known to fade
/// faster than that, and a swing that is slow where it turns is no nearer to its end.
constexpr double kLeastWait = 0.4;
constexpr int kGlances = 16;          ///< iterations of each bound
constexpr double kGlanceCost = 40.0;  ///< force passes, with all of them
constexpr double kFarEnough = 16.0;   ///< share of what may be missed, that a bound need not go beyond
constexpr double kMostSquares = 16.0; ///< see SettlingBudget

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
  return square * std::min(gain, kMostSquares);
}

/// Forces on nodes at x that stand still, into m_force; 0 where a support holds. @return their norm [N].
double Settling::forcesAt(System& system, double time, NodeArray& x, StepReport& report)
{
  const std::int64_t before = system.springsEvaluated;
  m_still.assign(x.size(), Lanes{0, 0, 0, 0});
  m_force.resize(x.size());
  system.evaluate(time, x, m_still, m_force);
  report.springsEvaluated += system.springsEvaluated - before;
  for (std::size_t i = 0; i < x.size(); ++i)
    if (!system.isFree(i)) m_force[i] = Lanes{0, 0, 0, 0};
  return std::sqrt(sumOfSquares(m_force));
}

void Settling::layOut(const System& system)
{
  m_matrix.prepare(system);
  m_isLaidOut = true;
}

void Settling::begin() noexcept
{
  forget();
  m_dueSpeed = m_dueTime = m_work = m_workAtGlance = 0.0;
  m_looksLeft = 0;
}

/// By what is known so far: what a factor costs is so once it is laid out.
bool Settling::isAffordable(const System& system, double effort) const noexcept
{
  const double passes = kGlanceCost * static_cast<double>(system.forces().activeSprings());
  if (kPatience * passes > m_work - m_workAtGlance) return false;
  if (m_isLaidOut) return attemptCost() <= std::min(m_work / kPatience, effort);
  return kLayoutCost * static_cast<double>(system.nodeCount()) <= std::min(m_work, kLongestLayout * effort);
}

double Settling::attemptCost() const noexcept
{
  return m_matrix.factorCost() + 2.0 * m_matrix.solveCost();
}

bool Settling::settleIfDue(System& system, MotionState& motion, double speed, const SettlingBudget& budget,
                           double effort, StepReport& report)
{
  const double most = budget.squareAt(budget.fading);
  const double within = std::sqrt(most / static_cast<double>(motion.x.size()));
  if (motion.x.size() > kMostNodes) return false;
  if (speed * kFrame > kNear * within) {
    m_dueSpeed = std::numeric_limits<double>::infinity();
    return false;
  }
  if (m_looksLeft > 0 && (motion.time < m_dueTime || speed > m_dueSpeed)) {
    --m_looksLeft;
    return false;
  }
  if (!isAffordable(system, effort)) return false;
  m_looksLeft = kLongestWait;
  m_workAtGlance = m_work;
  double missed = glance(system, motion, budget, report);
  if (missed <= 1.0) {
    if (!m_isLaidOut) {
      layOut(system);
      if (attemptCost() > std::min(m_work, effort)) return false;
    }
    missed = settle(system, motion, budget, report);
    m_work = m_workAtGlance = 0.0;
  }
  if (!std::isfinite(missed)) { // nothing to go by
    m_looksLeft = kWaitUnknown;
    m_dueSpeed = 0.0;
    return false;
  }
  const double times = std::sqrt(std::max(missed, 1.0)); // of the amplitude that may be missed
  m_dueSpeed = 0.9 * speed / times;
  m_dueTime = motion.time + kLeastWait * budget.fading * std::log(times);
  return missed <= 1.0;
}

double Settling::glance(System& system, MotionState& motion, const SettlingBudget& budget, StepReport& report)
{
  if (!system.forces().pressure().isEmpty()) return 0.0;
  m_bound.prepare(system, motion.x, kInertia);
  const double speed = sumOfSquares(motion.v), enough = kFarEnough * budget.squareAt(budget.fading);
  m_way.resize(motion.x.size());
  scaleNodes(m_way.size(), system.mass().data(), motion.v.data(), m_way.data());
  const double momentum = std::sqrt(sumOfSquares(m_way));
  double missed = 0.0;
  if (momentum > 0.0) {
    const double perEnergy = std::sqrt(speed) / momentum; // |v| |y| >= |v|/|M v| (M v).y
    missed = perEnergy * m_bound.below(system, m_way, enough / perEnergy, kGlances);
  }
  if (missed <= enough && !m_bound.metNegative()) {
    const double force = forcesAt(system, motion.time, motion.x, report);
    if (force > 0.0)
      missed += std::pow(m_bound.below(system, m_force, force * std::sqrt(enough), kGlances) / force, 2);
  }
  return m_bound.metNegative() ? kUnknown : shareOf(missed, speed, budget);
}

/// What is missed over what may be, by m_way and m_swing.
double Settling::shareOfWay(const MotionState& motion, const SettlingBudget& budget) const noexcept
{
  const double speed = sumOfSquares(motion.v);
  double missed = sumOfSquares(m_way) + std::sqrt(speed * sumOfSquares(m_swing)), local = 0.0;
  for (std::size_t i = 0; i < m_way.size(); ++i)
    local = std::max(local, dot(m_way[i], m_way[i]) +
                              std::sqrt(dot(motion.v[i], motion.v[i]) * dot(m_swing[i], m_swing[i])));
  missed = std::max(missed, local / kMostLocal * static_cast<double>(m_way.size()));
  return shareOf(missed, speed, budget);
}

double Settling::settle(System& system, MotionState& motion, const SettlingBudget& budget, StepReport& report)
{
  m_matrix.constraintsChanged(system);
  m_goal = motion.x;
  const double force = forcesAt(system, motion.time, m_goal, report);
  ++report.factorizations;
  if (!m_matrix.factor(system, motion.x, m_still, {kInertia, 0.0, 1.0}, false) ||
      m_matrix.negativePivots() > 0)
    return kUnknown;
  m_swing.resize(motion.x.size());
  for (std::size_t i = 0; i < m_swing.size(); ++i) m_swing[i] = motion.v[i] * system.mass()[i];
  m_matrix.solve(m_swing);
  m_way.assign(motion.x.size(), Lanes{0, 0, 0, 0});
  double share = 0.0, last = kUnknown; // of the way so far; length of its last step
  for (int corrections = 0;; ++corrections) {
    m_matrix.solve(m_force);
    const double length = std::sqrt(sumOfSquares(m_force));
    if (!(length <= kLeft * last)) return kUnknown;
    last = length;
    for (std::size_t i = 0; i < m_goal.size(); ++i) {
      m_goal[i] += m_force[i];
      m_way[i] += m_force[i];
    }
    share = shareOfWay(motion, budget);
    if (!(share <= 1.0)) return std::isfinite(share) ? share : kUnknown;
    if (forcesAt(system, motion.time, m_goal, report) <= kLeft * force) break;
    if (corrections == kMostCorrections) return kUnknown;
  }
  const double loads = system.loadPower(motion.time, m_way); // over the way: their work
  motion.work += loads;
  motion.heat +=
    system.kineticEnergy(motion.v) + system.storedEnergy(motion.x) - system.storedEnergy(m_goal) + loads;
  motion.x.swap(m_goal);
  motion.v.swap(m_still);
  return share;
}

} // namespace esm
