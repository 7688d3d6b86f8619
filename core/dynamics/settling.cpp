// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/settling.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace esm {
namespace {

constexpr double kInertia = 1e-2; ///< share of the mass in the stiffness, 1/(10 s)^2 [1/s^2]
/// Of the forces, that may be left at the goal: the net is nearly linear on its way there, or it is not near.
constexpr double kLeft = 0.5;

/// Of the mean square over the nodes, that a single one may miss: nobody shall see one spot stop at a blow.
constexpr double kMostLocal = 25.0;

double squareSum(const NodeArray& a) noexcept
{
  double sum = 0.0;
  for (const Lanes& value : a) sum += dot(value, value);
  return sum;
}

} // namespace

/// Forces on nodes at x that stand still, into m_force; 0 where a support holds. @return their norm [N].
double Settling::forcesAt(System& system, double time, NodeArray& x)
{
  m_still.assign(x.size(), Lanes{0, 0, 0, 0});
  system.evaluate(time, x, m_still, m_force);
  for (std::size_t i = 0; i < x.size(); ++i)
    if (!system.isFree(i)) m_force[i] = Lanes{0, 0, 0, 0};
  return std::sqrt(squareSum(m_force));
}

void Settling::layOut(const System& system)
{
  m_matrix.prepare(system);
  m_isLaidOut = true;
}

double Settling::settle(System& system, MotionState& motion, double mostSquare, StepReport& report)
{
  constexpr double kUnknown = std::numeric_limits<double>::infinity();
  const std::int64_t springsBefore = system.springsEvaluated;
  const auto count = [&] { report.springsEvaluated += system.springsEvaluated - springsBefore; };
  m_force.resize(motion.x.size());
  m_matrix.constraintsChanged(system);
  m_goal = motion.x;
  const double force = forcesAt(system, motion.time, m_goal);
  ++report.factorizations;
  count();
  if (!m_matrix.factor(system, motion.x, m_still, {kInertia, 0.0, 1.0}, false) ||
      m_matrix.negativePivots() > 0)
    return kUnknown;
  m_swing.resize(motion.x.size());
  for (std::size_t i = 0; i < m_swing.size(); ++i) m_swing[i] = motion.v[i] * system.mass()[i];
  m_matrix.solve(m_swing);
  m_way = m_force;
  m_matrix.solve(m_way);
  double missed = squareSum(m_way) + std::sqrt(squareSum(motion.v) * squareSum(m_swing)), local = 0.0;
  for (std::size_t i = 0; i < m_way.size(); ++i)
    local = std::max(local, dot(m_way[i], m_way[i]) +
                              std::sqrt(dot(motion.v[i], motion.v[i]) * dot(m_swing[i], m_swing[i])));
  missed = std::max(missed, local / kMostLocal * static_cast<double>(m_way.size()));
  if (!(missed <= mostSquare)) return std::isfinite(missed) ? missed / mostSquare : kUnknown;
  for (std::size_t i = 0; i < m_goal.size(); ++i) m_goal[i] += m_way[i];
  if (!(forcesAt(system, motion.time, m_goal) <= kLeft * force)) return kUnknown;
  const double loads = system.loadPower(motion.time, m_way); // over the way: their work
  motion.work += loads;
  motion.heat +=
    system.kineticEnergy(motion.v) + system.storedEnergy(motion.x) - system.storedEnergy(m_goal) + loads;
  motion.x.swap(m_goal);
  motion.v.swap(m_still);
  return missed / mostSquare;
}

} // namespace esm
