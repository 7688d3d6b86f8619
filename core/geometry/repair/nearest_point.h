// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/mesh.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace esm {

/// The point of a triangle next to `p`; of a line or a point, if the triangle is none.
Eigen::Vector3d nearestOnTriangle(const Eigen::Vector3d& p, const Eigen::Vector3d& a,
                                  const Eigen::Vector3d& b, const Eigen::Vector3d& c);

/// Triangle numbers in the order of a space-filling curve through their middles, so that what is near in
/// space is near in memory.
std::vector<Index> spatialOrder(const Eigen::Matrix3Xd& position, const TriangleMatrix& triangles);

/// Finds the point of a surface that is nearest to a point in space. Eight triangles in a row share a box,
/// eight boxes in a row the next larger one, and so on to a single box; no pointers, and few places in memory
/// to look at. Quick to build, which matters here as much as the queries. Deterministic.
class NearestPoint {
public:
  /// @param position, triangles  stay alive and unchanged as long as this; coordinates around 1. Any order of
  ///        the triangles is right, the spatial one is quick.
  NearestPoint(const Eigen::Matrix3Xd& position, const TriangleMatrix& triangles);

  /// @param normal  if not zero, triangles that look the other way do not count: the far wall of a thin sheet
  ///                is not the surface that is meant. If no triangle is left, `p` itself.
  /// @param hint    a triangle that may be near, or kNoIndex; then the one that was found. Speed only.
  Eigen::Vector3d find(const Eigen::Vector3d& p, const Eigen::Vector3d& normal, Index& hint) const;

private:
  static constexpr Index kWidth = 8, kLeafSize = 4;
  /// Eight boxes side by side, axis by axis; rounded outwards. Absent ones are infinitely far.
  struct Boxes {
    std::array<std::array<float, kWidth>, 3> low, high;
  };
  struct Search;
  void lookAt(Index triangle, Search& search) const;

  const Eigen::Matrix3Xd& m_position;
  const TriangleMatrix& m_triangles;
  std::vector<Boxes> m_boxes;      ///< the lowest level first
  std::vector<Index> m_levelStart; ///< in m_boxes
};

} // namespace esm
