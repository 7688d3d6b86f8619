// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/geometry/triangle_tree.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

/// Triangles and boxes are larger by this share, so that no ray slips through between two triangles.
constexpr double kMargin = 1e-9;

std::vector<Eigen::AlignedBox3d> boxesOf(const Eigen::Matrix3Xd& position, const TriangleMatrix& triangles)
{
  std::vector<Eigen::AlignedBox3d> boxes(static_cast<std::size_t>(triangles.cols()));
  for (Index t = 0; t < static_cast<Index>(triangles.cols()); ++t)
    for (int k = 0; k < 3; ++k) boxes[at(t)].extend(position.col(triangles(k, t)));
  return boxes;
}

} // namespace

TriangleTree::TriangleTree(const Eigen::Matrix3Xd& position, const TriangleMatrix& triangles,
                           WorkControl* control)
  : m_tree(boxesOf(position, triangles), kMargin, [control] { return stopWanted(control); }),
    m_corner(3, 3 * triangles.cols())
{
  for (Index i = 0; i < static_cast<Index>(triangles.cols()); ++i)
    for (int k = 0; k < 3; ++k) m_corner.col(3 * i + k) = position.col(triangles(k, m_tree.order()[at(i)]));
}

bool TriangleTree::meetsBox(const BoxTree::Node& node, const Eigen::Vector3d& origin,
                            const Eigen::Vector3d& inverse, double from, double to) noexcept
{
  for (int axis = 0; axis < 3; ++axis) {
    if (!std::isfinite(inverse[axis])) { // the ray runs along the box's sides
      if (!(origin[axis] >= node.box.min()[axis] && origin[axis] <= node.box.max()[axis])) return false;
      continue;
    }
    const double a = (node.box.min()[axis] - origin[axis]) * inverse[axis],
                 b = (node.box.max()[axis] - origin[axis]) * inverse[axis];
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
  }
  return from <= to;
}

/// Möller and Trumbore (1997).
double TriangleTree::meet(Index i, const Eigen::Vector3d& origin,
                          const Eigen::Vector3d& direction) const noexcept
{
  const Eigen::Vector3d a = m_corner.col(3 * i), u = m_corner.col(3 * i + 1) - a,
                        v = m_corner.col(3 * i + 2) - a;
  const Eigen::Vector3d p = direction.cross(v);
  const double determinant = u.dot(p);
  if (determinant == 0.0) return -1.0;
  const Eigen::Vector3d away = origin - a;
  const double s = away.dot(p) / determinant;
  if (!(s >= -kMargin && s <= 1.0 + kMargin)) return -1.0;
  const Eigen::Vector3d q = away.cross(u);
  const double t = direction.dot(q) / determinant;
  if (!(t >= -kMargin && s + t <= 1.0 + kMargin)) return -1.0;
  return v.dot(q) / determinant;
}

} // namespace esm
