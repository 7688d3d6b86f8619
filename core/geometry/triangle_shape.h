// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/mesh.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace esm {

/// Twice the area, along the normal.
inline Eigen::Vector3d areaVector(const Mesh& mesh, Index triangle)
{
  const Eigen::Vector3d a = mesh.position.col(mesh.triangles(0, triangle));
  const Eigen::Vector3d u = mesh.position.col(mesh.triangles(1, triangle)) - a;
  const Eigen::Vector3d v = mesh.position.col(mesh.triangles(2, triangle)) - a;
  return u.cross(v);
}

inline bool hasEqualCorners(const Mesh& mesh, Index triangle)
{
  const Index* corner = mesh.triangles.data() + 3 * std::ptrdiff_t{triangle};
  return corner[0] == corner[1] || corner[1] == corner[2] || corner[2] == corner[0];
}

/// The largest of three magnitudes, without a branch that nobody could guess.
inline double largestMagnitude(const Eigen::Vector3d& v)
{
  return std::max(std::max(std::abs(v[0]), std::abs(v[1])), std::abs(v[2]));
}

/// What the cross product of two sides may have by rounding, in the product of their largest coordinates.
inline constexpr double kDegenerateShare = 16 * std::numeric_limits<double>::epsilon();

/// Two equal corners, or zero area up to the rounding of the cross product itself; a needle that is thin but
/// real is none.
inline bool isDegenerate(const Mesh& mesh, Index triangle)
{
  if (hasEqualCorners(mesh, triangle)) return true;
  const Eigen::Vector3d a = mesh.position.col(mesh.triangles(0, triangle));
  const Eigen::Vector3d u = mesh.position.col(mesh.triangles(1, triangle)) - a;
  const Eigen::Vector3d v = mesh.position.col(mesh.triangles(2, triangle)) - a;
  const double scale = largestMagnitude(u) * largestMagnitude(v);
  return largestMagnitude(u.cross(v)) <= kDegenerateShare * scale;
}

} // namespace esm
