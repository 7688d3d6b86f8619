// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/work_control.h"
#include "core/geometry/mesh.h"

#include <cstdint>
#include <vector>

namespace esm {

/// The unique edges of a mesh: first those of the triangles in the order of their first appearance
/// (corners 0-1, 1-2, 2-0 of triangle 0, then triangle 1, ...), then the segments that are no edge yet,
/// then the edges of tetrahedra that are none yet.
/// Ends with a == b make no edge. Duplicate and degenerate triangles count like all others.
struct EdgeList {
  static constexpr std::uint8_t kMany = 255;                   ///< so many and more
  SegmentMatrix ends;                                          ///< 2 x E, smaller vertex first
  Index surfaceEdges = 0;                                      ///< so many at the front belong to triangles
  Eigen::Array<std::uint8_t, Eigen::Dynamic, 1> triangleCount; ///< E, how many triangles use the edge
  std::vector<Index> thin;     ///< triangles with two or three equal corners; ascending
  std::vector<Index> repeated; ///< triangles over the vertices of an earlier one, in any order; ascending
};

/// The same with the way from triangles to edges.
struct EdgeTable : EdgeList {
  std::vector<Index> edgeOfSide; ///< 3 F: the edge of side c of triangle t at 3 t + c, or kNoIndex
};

/// Sides of triangles, segments and sides of tetrahedra together stay below this.
inline constexpr std::int64_t kMostSides = std::int64_t{1} << 30;

/// O(V + F). @pre indices in range
/// @param control may be null; once it is cancelled the table is empty, ask stopWanted().
EdgeList listEdges(const Mesh& mesh, WorkControl* control = nullptr);
EdgeTable findEdges(const Mesh& mesh, WorkControl* control = nullptr);

} // namespace esm
