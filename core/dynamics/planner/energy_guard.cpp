// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/planner/energy_guard.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace esm {

void EnergyGuard::lookForFreeNodes(const System& system) noexcept
{
  m_isLedAllOver = true;
  for (std::size_t node = 0; node < system.nodeCount() && m_isLedAllOver; ++node)
    m_isLedAllOver = !system.isFree(node);
}

void EnergyGuard::beginStretch() noexcept
{
  m_start.reset();
  m_growth = m_grown;
}

EnergyBalance EnergyGuard::balance(const System& system, const MotionState& start, const MotionState& state)
{
  if (!m_start)
    m_start = Energies{system.kineticEnergy(start.v), system.elasticEnergy(start.x),
                       system.forces().gravityEnergy(start.x.data())};
  const auto& [kinetic, elastic, high] = *m_start;
  const double fallen = high - system.forces().gravityEnergy(state.x.data());
  const double work = state.work - start.work;
  const double gained =
    system.kineticEnergy(state.v) - kinetic + system.elasticEnergy(state.x) - elastic - fallen - work;
  return {gained, state.heat - start.heat, kinetic + std::abs(elastic) + std::abs(work) + std::abs(fallen),
          std::abs(high)};
}

bool EnergyGuard::hasAppeared(const System& system, const EnergyBalance& balance, double extent,
                              double share) noexcept
{
  if (m_isLedAllOver) return false;
  // Of sums with rounding errors; and what nobody can see.
  const double least = m_policy->energy.rounding * (balance.high + system.totalMass() * extent * extent);
  const double sum = std::max(m_grown, 0.0) + balance.gained; // what came slowly is no better
  if (!(sum <= share * balance.turnedOver + least)) return true;
  m_growth = sum;
  return false;
}

bool EnergyGuard::hasQuickened(const System& system, const MotionState& start,
                               const MotionState& state) const noexcept
{
  return system.kineticEnergy(state.v) > m_policy->energy.quickened * system.kineticEnergy(start.v);
}

/// Two runs that both damp waves away do not tell: a sheet of a thousand times its stiffness erred ten times a
/// tolerance of 1e-2, and each check saw a thirtieth of its budget. What tells is energy that is gone without work
/// and heat. The waves were faster than the steps, so no larger than this; there, ten times smaller. Where dampers
/// take such waves, it is less than what checks see.
double EnergyGuard::lostWaves(const System& system, const EnergyBalance& balance, double step) noexcept
{
  const double rounding = // of so many errors
    std::numeric_limits<double>::epsilon() * std::sqrt(static_cast<double>(system.forces().activeSprings()));
  const double lost = -balance.heat - balance.gained - rounding * (balance.turnedOver + balance.high);
  return step * std::sqrt(std::max(lost, 0.0) / system.totalMass());
}

} // namespace esm
