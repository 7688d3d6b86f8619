// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/fuzzy/rule_text.h"
#include "core/geometry/ellipsoid.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace esm {

/// How the weight falls from 1 to 0 over the falloff f, in s = (1 - radius) / f, clamped to [0, 1]:
///
///     Smooth     3 s^2 - 2 s^3               slope at most 3/2 / f, no kink
///     Linear     s                           slope 1 / f, the gentlest, a kink at both ends
///     Smoother   6 s^5 - 15 s^4 + 10 s^3     slope at most 15/8 / f, no jump in curvature either
enum class FalloffProfile : std::uint8_t { Smooth, Linear, Smoother };

/// In [0, 1]; 0 for NaN. @param radius of Ellipsoid::radius(). @param falloff in [0, 1]; 0 is a hard border.
double profileWeight(FalloffProfile profile, double radius, double falloff) noexcept;
/// The most that the weight changes per unit of s: 1.5, 1 or 1.875.
double steepestSlope(FalloffProfile profile) noexcept;

/// A plane in space, for organs that come in pairs.
struct MirrorPlane {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();   ///< [m]
  Eigen::Vector3d normal = Eigen::Vector3d::UnitX(); ///< of any length above 0
  Eigen::Vector3d reflect(const Eigen::Vector3d& p) const;
  bool operator==(const MirrorPlane&) const = default;
};

/// A part of space with tissue of its own.
struct Region {
  std::string name;
  Ellipsoid ellipsoid;
  double falloff = 0.3;                  ///< [0, 1] share of the radius over which the region fades out
  bool enabled = true;                   ///< false: takes no part in the tissue
  std::vector<fuzzy::InputValue> inputs; ///< one per rule base input
  FalloffProfile profile = FalloffProfile::Smooth;
  bool insideOut = false; ///< true: the region is all space but the ellipsoid; weight 1 - w
  /// Present: the region has a twin behind this plane. Both are one region: the weight is the larger one.
  std::optional<MirrorPlane> mirror = {};
  bool locked = false; ///< see region_edit.h; means nothing to the tissue
  bool visible = true; ///< drawn in the window; means nothing to the tissue
  bool operator==(const Region&) const = default;
};

/// The ellipsoid behind the plane.
Ellipsoid mirrored(const Ellipsoid& ellipsoid, const MirrorPlane& plane);

/// A region's shape made ready for many places. Equal shapes give equal weights, bit for bit. Any thread.
class RegionShape {
public:
  explicit RegionShape(const Region& region);
  /// In [0, 1] for every point, 0 where there is none (NaN).
  double weight(const Eigen::Vector3d& point) const noexcept;
  bool operator==(const RegionShape&) const = default;

private:
  /// An ellipsoid as the unit ball seen through `toBall`, with a box around it to pass over what is far.
  struct Ball {
    Eigen::Vector3d centre, halfBox;
    Eigen::Matrix3d toBall;
    bool operator==(const Ball&) const = default;
  };
  static Ball ballOf(const Ellipsoid& ellipsoid);
  double weightIn(const Ball& ball, const Eigen::Vector3d& point) const noexcept;

  Ball m_ball;
  std::optional<Ball> m_twin;
  double m_falloff;
  FalloffProfile m_profile;
  bool m_insideOut;
};

/// The smallest ellipsoid around selected places: axes along their principal directions (PCA), each place
/// weighted by how far out it lies, so that the inner ones of a patch do not blow it up. Places spread evenly
/// over an ellipsoid's surface give that ellipsoid. Directions in which they hardly spread get
/// `leastSemiAxis`.
/// @param places 3 x P [m]. @param leastSemiAxis [m], > 0.
/// @param falloff in [0, 1): the ellipsoid is larger by 1 / (1 - falloff), so that every place has weight 1.
/// Errors: InvalidValue (no place, not finite, parameters out of range).
Result<Ellipsoid> fitEllipsoid(const Eigen::Matrix3Xd& places, double leastSemiAxis, double falloff = 0.0);

} // namespace esm
