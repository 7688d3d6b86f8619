// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace esm {

/// The last stage before the device: whatever comes in, what goes out is finite, no larger than the limit and
/// changes no faster than the slew rate.
///
/// Falling to zero obeys the slew rate too: a force that vanishes at once lets the arm jump, and 5 N at 1
/// N/ms are gone after 5 ms. A limit lowered under the present force is reached at the slew rate as well.
class ForceLimiter {
public:
  static constexpr double kDefaultSlew = 1000.0; ///< [N/s]

  explicit ForceLimiter(double slew = kDefaultSlew) noexcept : m_slew(slew) {}

  /// @param wish [N]; non-finite counts as zero.
  /// @param most largest norm [N].
  /// @param tick time since the last call, the nominal one: late ticks are not made up for [s].
  const Eigen::Vector3d& limit(const Eigen::Vector3d& wish, double most, double tick) noexcept;
  const Eigen::Vector3d& force() const noexcept { return m_force; } ///< given out last [N]

private:
  double m_slew;
  Eigen::Vector3d m_force = Eigen::Vector3d::Zero();
};

} // namespace esm
