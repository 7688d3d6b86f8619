// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/types.h"
#include "core/base/work_control.h"
#include "core/geometry/box_tree.h"
#include "core/geometry/mesh.h"

#include <cmath>
#include <limits>

namespace esm {

/// Where a ray meets a triangle.
struct RayHit {
  Index triangle = kNoIndex; ///< kNoIndex: it meets none
  double distance = 0.0;     ///< along the ray, in lengths of its direction
};

/// Along no axis and no diagonal, so that a ray in it meets edges by accident only; for crossings().
inline const Eigen::Vector3d kObliqueDirection = Eigen::Vector3d(0.5377, 0.7236, 0.4321).normalized();

/// Finds what a ray meets among many triangles: a tree of boxes. Holds copies, so that the mesh may go away. Deterministic; any thread.
class TriangleTree {
public:
  /// @param position 3 x V. @param triangles 3 x F, indices in range.
  /// @param control may be null; once it is cancelled the tree is not whole: ask stopWanted().
  TriangleTree(const Eigen::Matrix3Xd& position, const TriangleMatrix& triangles,
               WorkControl* control = nullptr);

  /// The nearest meeting with `from` <= distance < `to` of the ray origin + distance direction, from either
  /// side of a triangle. Triangles for which `skip(triangle)` is true do not count.
  template <class Skip>
  RayHit firstHit(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction, double from, double to,
                  const Skip& skip) const
  {
    RayHit hit{kNoIndex, to};
    const Eigen::Vector3d inverse = direction.cwiseInverse();
    Index stack[64];
    int depth = 0;
    if (!m_tree.nodes().empty()) stack[depth++] = 0;
    while (depth > 0) {
      const BoxTree::Node& node = m_tree.nodes()[at(stack[--depth])];
      if (!meetsBox(node, origin, inverse, from, hit.distance)) continue;
      if (node.count == 0) {
        stack[depth++] = node.first;
        stack[depth++] = node.first + 1;
        continue;
      }
      for (Index i = node.first; i < node.first + node.count; ++i) {
        const double distance = meet(i, origin, direction);
        const Index triangle = m_tree.order()[at(i)];
        const bool nearer = distance >= from && (distance < hit.distance ||
                                                 (distance == hit.distance && triangle < hit.triangle));
        if (nearer && !skip(triangle)) hit = {triangle, distance};
      }
    }
    if (hit.triangle == kNoIndex) hit.distance = 0.0;
    return hit;
  }
  /// How often the ray meets a triangle beyond its origin: odd inside a closed surface. Meetings at the same
  /// distance (on an edge) count once.
  template <class Skip>
  int crossings(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction, const Skip& skip) const
  {
    constexpr double kFar = std::numeric_limits<double>::infinity();
    int count = 0;
    for (RayHit hit = firstHit(origin, direction, 0.0, kFar, skip); hit.triangle != kNoIndex; ++count)
      hit = firstHit(origin, direction, std::nextafter(hit.distance, kFar), kFar, skip);
    return count;
  }

private:
  static bool meetsBox(const BoxTree::Node& node, const Eigen::Vector3d& origin,
                       const Eigen::Vector3d& inverse, double from, double to) noexcept;
  /// Distance of the meeting with the i-th triangle in the tree's order; < 0 or NaN: none beyond the origin.
  double meet(Index i, const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) const noexcept;

  BoxTree m_tree;
  Eigen::Matrix3Xd m_corner; ///< 3 x 3F: corners by the tree's order
};

} // namespace esm
