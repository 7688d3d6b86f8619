// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/mesh.h"

#include <limits>
#include <optional>
#include <vector>

namespace esm {

/// A point of a surface: x = w0 p0 + w1 p1 + w2 p2 with the corners of a triangle.
struct SurfacePoint {
  Index triangle = kNoIndex;
  Eigen::Vector3d weight = Eigen::Vector3d::Zero(); ///< >= 0, sum 1
};

/// The triangles of a net in motion in a tree of boxes: which is nearest, which is hit first.
///
/// The tree is built once, by halving at the median; when the surface has moved the boxes are fitted again,
/// which costs far less and stays good as long as neighbours stay neighbours. Equal distances are decided by
/// the smaller index, so equal input gives equal answers.
/// @note One thread at a time; refit() and the queries do not allocate.
class DeformingSurface {
public:
  DeformingSurface() = default;
  /// @param position 3 x V [m]; @pre indices in range
  DeformingSurface(const TriangleMatrix& triangles, const Eigen::Matrix3Xd& position);

  void refit(const Eigen::Matrix3Xd& position) noexcept;

  /// The point of the surface nearest to `point`, if one is nearer than `within` [m].
  std::optional<SurfacePoint> nearest(const Eigen::Vector3d& point,
                                      double within = std::numeric_limits<double>::infinity()) const noexcept;
  /// The first triangle on the way between two points.
  /// @param onlyFront  triangles that are met from behind (their normal along the way) do not count.
  std::optional<SurfacePoint> firstHit(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                       bool onlyFront) const noexcept;
  const TriangleMatrix& triangles() const noexcept { return m_triangles; }
  const Eigen::Matrix3Xd& position() const noexcept { return m_position; }
  Eigen::Vector3d corner(Index triangle, int corner) const noexcept
  {
    return m_position.col(m_triangles(corner, triangle));
  }
  Eigen::Vector3d pointAt(const SurfacePoint& point) const noexcept;

private:
  struct Box {
    Eigen::Vector3d low, high;
    Index first = 0, count = 0; ///< count > 0: triangles m_order[first ...]; else children first, first + 1
  };
  void build(std::size_t box, Index first, Index count, const Eigen::Matrix3Xd& centre);

  TriangleMatrix m_triangles;
  Eigen::Matrix3Xd m_position;
  std::vector<Index> m_order;
  std::vector<Box> m_boxes; ///< parents before children
};

} // namespace esm
