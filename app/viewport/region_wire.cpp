// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/viewport/region_wire.h"

#include <cmath>
#include <numbers>

namespace esm {

void appendRegionWire(const Ellipsoid& ellipsoid, const Eigen::Vector3d& origin, std::vector<float>& lines)
{
  if (!ellipsoid.centre.allFinite() || !ellipsoid.semiAxes.allFinite() ||
      !ellipsoid.rotation.coeffs().allFinite())
    return;
  constexpr int kSegments = 64;
  // A circle on the unit sphere: centre + cos(t) u + sin(t) v.
  const auto circle = [&](const Eigen::Vector3d& centre, const Eigen::Vector3d& u, const Eigen::Vector3d& v) {
    const auto append = [&](int i) {
      const double t = 2.0 * std::numbers::pi * i / kSegments;
      const Eigen::Vector3d unit = centre + std::cos(t) * u + std::sin(t) * v;
      const Eigen::Vector3d world =
        ellipsoid.centre + ellipsoid.rotation * ellipsoid.semiAxes.cwiseProduct(unit) - origin;
      for (int c = 0; c < 3; ++c) lines.push_back(static_cast<float>(world(c)));
    };
    for (int i = 0; i < kSegments; ++i) {
      append(i);
      append(i + 1);
    }
  };
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), y = Eigen::Vector3d::UnitY(),
                        z = Eigen::Vector3d::UnitZ(), zero = Eigen::Vector3d::Zero();
  circle(zero, x, y);
  circle(zero, x, z);
  circle(zero, y, z);
  const double half = std::sqrt(0.5);
  circle(zero, half * (x + y), z);
  circle(zero, half * (x - y), z);
  circle(half * z, half * x, half * y);
  circle(-half * z, half * x, half * y);
}

} // namespace esm
