// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/force_limiter.h"

namespace esm {

const Eigen::Vector3d& ForceLimiter::limit(const Eigen::Vector3d& wish, double most, double tick) noexcept
{
  Eigen::Vector3d goal = Eigen::Vector3d::Zero();
  if (wish.allFinite() && most > 0.0) {
    const double norm = wish.stableNorm(); // squares of huge numbers would overflow
    goal = norm > most ? Eigen::Vector3d(wish * (most / norm)) : wish;
  }
  // Between two vectors within the limit: the way there stays within it too.
  const Eigen::Vector3d change = goal - m_force;
  const double size = change.norm();
  const double step = m_slew * tick;
  if (size <= step * (1.0 + 1e-12)) // the last step may be long by rounding
    m_force = goal;                 // exactly, so that zero is zero
  else
    m_force += change * (step / size);
  return m_force;
}

} // namespace esm
