// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>

namespace esm {

/// A solid ellipsoid in space.
struct Ellipsoid {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();             ///< [m]
  Eigen::Vector3d semiAxes = Eigen::Vector3d::Constant(0.01);   ///< [m], all > 0
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity(); ///< unit; body axes to world axes

  bool operator==(const Ellipsoid&) const = default;
  /// Distance from the centre in units of the surface: 0 at the centre, 1 on the surface.
  double radius(const Eigen::Vector3d& point) const
  {
    const Eigen::Vector3d local = rotation.conjugate() * (point - centre);
    return local.cwiseQuotient(semiAxes).norm();
  }
};

/// 1 where `radius` <= 1 - falloff, 0 where `radius` >= 1, between them a cubic with flat ends
/// (smoothstep), so that stiffness has no visible seam. falloff in [0, 1]; 0 is a hard border.
inline double falloffWeight(double radius, double falloff)
{
  if (radius >= 1.0) return 0.0;
  if (radius <= 1.0 - falloff) return 1.0;
  const double s = std::clamp((1.0 - radius) / falloff, 0.0, 1.0);
  return s * s * (3.0 - 2.0 * s);
}

} // namespace esm
