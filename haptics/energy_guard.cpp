// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/energy_guard.h"

#include <algorithm>

namespace esm {

bool EnergyGuard::account(const Eigen::Vector3d& force, const Eigen::Vector3d& motion, double stored,
                          double share, double dt) noexcept
{
  const double work = force.dot(motion);
  m_work += work;
  m_balance = std::max(0.0, m_balance + work + share * (stored - m_stored) - kLeak * dt);
  m_stored = stored;
  m_generated = std::max(0.0, m_balance - share * stored);
  return m_generated <= kTrip;
}

Eigen::Vector3d EnergyGuard::damping(const Eigen::Vector3d& velocity) const noexcept
{
  const double excess = m_generated - kFree, squared = velocity.squaredNorm();
  if (excess <= 0.0 || squared < 1e-12) return Eigen::Vector3d::Zero();
  return -std::min(m_mostDamping, excess / (kDampTime * squared)) * velocity;
}

} // namespace esm
