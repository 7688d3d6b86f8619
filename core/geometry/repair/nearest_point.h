// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/mesh.h"

#include <Eigen/Core>

#include <cstdint>
#include <limits>
#include <vector>

namespace esm {

/// The point of a triangle next to `p`; of a line or a point, if the triangle is none.
Eigen::Vector3d nearestOnTriangle(const Eigen::Vector3d& p, const Eigen::Vector3d& a,
                                  const Eigen::Vector3d& b, const Eigen::Vector3d& c);

/// Triangle numbers in the order of a space-filling curve through their middles, so that what is near in
/// space is near in memory.
std::vector<Index> spatialOrder(const Eigen::Matrix3Xd& position, const TriangleMatrix& triangles);

/// Finds the point of a surface that is nearest to a point in space. A tree of boxes without pointers: leaves
/// are a few triangles each, in spatial order, and box i holds boxes 2i + 1 and 2i + 2. Quick to build (0.1 s
/// for a million triangles), which matters more here than the last per cent of the queries. Deterministic.
class NearestPoint {
public:
  /// @param position, triangles  stay alive and unchanged as long as this.
  NearestPoint(const Eigen::Matrix3Xd& position, const TriangleMatrix& triangles);

  /// @param normal  if not zero, triangles that look the other way do not count: the far wall of a thin sheet
  ///                is not the surface that is meant. If no triangle is left, `p` itself.
  Eigen::Vector3d find(const Eigen::Vector3d& p, const Eigen::Vector3d& normal) const;

private:
  struct Box {
    Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity()), high = -low;
  };
  double squaredDistance(const Box& box, const Eigen::Vector3d& p) const;

  const Eigen::Matrix3Xd& m_position;
  const TriangleMatrix& m_triangles;
  std::vector<Index> m_order;
  std::vector<Box> m_boxes;
  Index m_firstLeaf = 0;
};

} // namespace esm
