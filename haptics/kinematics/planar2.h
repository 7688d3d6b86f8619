// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <algorithm>

namespace esm {

/// A stick or a wheel: one or two axes over a stroke each, nothing along z.
struct Planar2 {
  Eigen::Vector2d stroke{0.10, 0.10}; ///< way of the grip from end to end [m]; 0: no such axis
  double forceAtFull = 1.0;           ///< at 100 % command [N]

  /// @param axes -1 ... 1 each; y grows away from the user as joysticks count towards him.
  Eigen::Vector3d position(const Eigen::Vector2d& axes) const noexcept
  {
    return {0.5 * stroke.x() * axes.x(), -0.5 * stroke.y() * axes.y(), 0.0};
  }
  Eigen::Vector2d axes(const Eigen::Vector3d& position) const noexcept
  {
    return {stroke.x() > 0.0 ? 2.0 * position.x() / stroke.x() : 0.0,
            stroke.y() > 0.0 ? -2.0 * position.y() / stroke.y() : 0.0};
  }
  /// Share of full force along each axis; one factor for both keeps the direction.
  Eigen::Vector2d command(const Eigen::Vector3d& force) const noexcept
  {
    if (!force.allFinite() || !(forceAtFull > 0.0)) return Eigen::Vector2d::Zero();
    Eigen::Vector2d share(stroke.x() > 0.0 ? force.x() : 0.0, stroke.y() > 0.0 ? -force.y() : 0.0);
    share /= std::max(forceAtFull, share.cwiseAbs().maxCoeff());
    return share;
  }
};

} // namespace esm
