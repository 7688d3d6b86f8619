// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/mesh.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
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

  struct Found {
    Index triangle = kNoIndex; ///< kNoIndex: there is none
    Eigen::Vector3d point;     ///< of the triangle; the point that was asked for, if there is none
    double squaredDistance = 0.0;
  };
  /// The nearest point on triangles for which `accept(triangle)` is true, within `reach`.
  /// @param hint  a triangle that may be near, or kNoIndex: for speed only.
  template <class Accept>
  Found find(const Eigen::Vector3d& p, double reach, const Accept& accept, Index hint = kNoIndex) const;
  Eigen::Vector3d areaVector(Index triangle) const;

private:
  static constexpr Index kWidth = 8, kLeafSize = 4;
  /// Eight boxes side by side, axis by axis; rounded outwards. Absent ones are infinitely far.
  struct Boxes {
    std::array<std::array<float, kWidth>, 3> low, high;
  };
  std::array<float, kWidth> squaredDistances(const Boxes& boxes, const Eigen::Vector3f& p) const;
  template <class Accept>
  void lookAt(Index triangle, const Eigen::Vector3d& p, const Accept& accept, Found& found) const;

  const Eigen::Matrix3Xd& m_position;
  const TriangleMatrix& m_triangles;
  std::vector<Boxes> m_boxes;      ///< the lowest level first
  std::vector<Index> m_levelStart; ///< in m_boxes
};

template <class Accept>
void NearestPoint::lookAt(Index t, const Eigen::Vector3d& p, const Accept& accept, Found& found) const
{
  const Eigen::Vector3d point =
    nearestOnTriangle(p, m_position.col(m_triangles(0, t)), m_position.col(m_triangles(1, t)),
                      m_position.col(m_triangles(2, t)));
  const double squared = (point - p).squaredNorm();
  // Equal distances go to the first triangle, whatever the hint was.
  const bool isNearer =
    squared < found.squaredDistance ||
    (squared == found.squaredDistance && (found.triangle == kNoIndex || t < found.triangle));
  if (isNearer && accept(t)) found = {t, point, squared};
}

template <class Accept>
NearestPoint::Found NearestPoint::find(const Eigen::Vector3d& p, double reach, const Accept& accept,
                                       Index hint) const
{
  struct Entry {
    float squared;
    Index level, group; ///< what lies in this place: eight boxes of the level, or (-1) a few triangles
  };
  Found found{kNoIndex, p, reach * reach};
  if (hint != kNoIndex) lookAt(hint, p, accept, found);
  std::array<Entry, 12 * kWidth> stack; // at most 11 levels of eight
  std::size_t depth = 0;
  if (!m_levelStart.empty()) stack[depth++] = {0.0f, static_cast<Index>(m_levelStart.size()) - 1, 0};
  const Eigen::Vector3f rounded = p.cast<float>();
  while (depth > 0) {
    const Entry entry = stack[--depth];
    if (static_cast<double>(entry.squared) > found.squaredDistance) continue;
    if (entry.level < 0) {
      const Index end = std::min((entry.group + 1) * kLeafSize, static_cast<Index>(m_triangles.cols()));
      for (Index t = entry.group * kLeafSize; t < end; ++t) lookAt(t, p, accept, found);
      continue;
    }
    const Index start = m_levelStart[static_cast<std::size_t>(entry.level)];
    const auto squared = squaredDistances(m_boxes[static_cast<std::size_t>(start + entry.group)], rounded);
    const std::size_t bottom = depth;
    for (std::size_t k = 0; k < squared.size(); ++k) {
      if (!(static_cast<double>(squared[k]) <= found.squaredDistance) || std::isinf(squared[k])) continue;
      std::size_t place = depth++; // the nearest one ends on top
      for (; place > bottom && stack[place - 1].squared < squared[k]; --place)
        stack[place] = stack[place - 1];
      stack[place] = {squared[k], entry.level - 1, entry.group * kWidth + static_cast<Index>(k)};
    }
  }
  return found;
}

} // namespace esm
