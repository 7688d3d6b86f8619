// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/geometry/triangle_tree.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace esm {

namespace {

constexpr Index kTrianglesPerLeaf = 4;
/// Triangles and boxes are larger by this share, so that no ray slips through between two triangles.
constexpr double kMargin = 1e-9;

} // namespace

TriangleTree::TriangleTree(const Eigen::Matrix3Xd& position, const TriangleMatrix& triangles,
                           WorkControl* control)
  : m_order(static_cast<std::size_t>(triangles.cols())), m_corner(3, 3 * triangles.cols())
{
  const auto count = static_cast<Index>(triangles.cols());
  if (count == 0) return;
  Eigen::Matrix3Xd centre(3, count);
  for (Index t = 0; t < count; ++t)
    centre.col(t) =
      (position.col(triangles(0, t)) + position.col(triangles(1, t)) + position.col(triangles(2, t))) / 3.0;
  std::iota(m_order.begin(), m_order.end(), 0);
  m_corner.setZero();
  // Corners in the order of the file for now, for the boxes; in the tree's order at the end.
  for (Index t = 0; t < count; ++t)
    for (int k = 0; k < 3; ++k) m_corner.col(3 * t + k) = position.col(triangles(k, t));
  m_nodes.reserve(static_cast<std::size_t>(count));
  m_nodes.emplace_back();
  split(0, 0, count, centre, control);
  const Eigen::Matrix3Xd byFile = m_corner;
  for (Index i = 0; i < count; ++i)
    m_corner.middleCols<3>(3 * i) = byFile.middleCols<3>(3 * m_order[static_cast<std::size_t>(i)]);
}

void TriangleTree::split(Index node, Index first, Index count, const Eigen::Matrix3Xd& centre,
                         WorkControl* control)
{
  Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (Index i = first; i < first + count; ++i) {
    const Index t = m_order[static_cast<std::size_t>(i)];
    for (int k = 0; k < 3; ++k) {
      low = low.cwiseMin(m_corner.col(3 * t + k));
      high = high.cwiseMax(m_corner.col(3 * t + k));
    }
  }
  const double margin = kMargin * (high - low).maxCoeff();
  Node& here = m_nodes[static_cast<std::size_t>(node)];
  here.low = low.array() - margin;
  here.high = high.array() + margin;
  if (count <= kTrianglesPerLeaf || stopWanted(control)) {
    here.first = first;
    here.count = count;
    return;
  }
  int axis = 0;
  (high - low).maxCoeff(&axis);
  const auto begin = m_order.begin() + first, middle = begin + count / 2;
  std::nth_element(begin, middle, begin + count, [&](Index a, Index b) {
    return centre(axis, a) != centre(axis, b) ? centre(axis, a) < centre(axis, b) : a < b;
  });
  const auto child = static_cast<Index>(m_nodes.size());
  here.first = child;
  here.count = 0;
  m_nodes.resize(m_nodes.size() + 2);
  split(child, first, count / 2, centre, control);
  split(child + 1, first + count / 2, count - count / 2, centre, control);
}

bool TriangleTree::meetsBox(const Node& node, const Eigen::Vector3d& origin, const Eigen::Vector3d& inverse,
                            double from, double to) noexcept
{
  for (int axis = 0; axis < 3; ++axis) {
    if (!std::isfinite(inverse[axis])) { // the ray runs along the box's sides
      if (!(origin[axis] >= node.low[axis] && origin[axis] <= node.high[axis])) return false;
      continue;
    }
    const double a = (node.low[axis] - origin[axis]) * inverse[axis],
                 b = (node.high[axis] - origin[axis]) * inverse[axis];
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
