// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/geometry/edge_table.h"

#include "core/base/assert.h"
#include "core/geometry/first_appearance.h"

#include <cstdint>
#include <limits>
#include <utility>

namespace esm {

namespace {

/// Triangle sides first, then segments; the bucket is the smaller vertex, the rest the larger one.
std::pair<Index, Index> sideKey(const Mesh& mesh, Index side)
{
  const Index sides = 3 * mesh.triangleCount();
  const Index* corner = mesh.triangles.data();
  Index a, b;
  if (side < sides) {
    const Index last = side % 3 == 2 ? side - 2 : side + 1;
    a = corner[side];
    b = corner[last];
  } else {
    a = mesh.segments(0, side - sides);
    b = mesh.segments(1, side - sides);
  }
  if (a == b) return {kNoIndex, 0};
  return {std::min(a, b), std::max(a, b)};
}

/// Each triangle once per edge, even if two of its sides are the same edge (corners a a b).
void countTriangles(EdgeTable& table)
{
  table.triangleCount.assign(static_cast<std::size_t>(table.ends.cols()), 0);
  const std::vector<Index>& edge = table.edgeOfSide;
  for (std::size_t t = 0; t + 2 < edge.size(); t += 3) {
    for (std::size_t c = 0; c < 3; ++c) {
      const Index e = edge[t + c];
      const bool counted = (c > 0 && e == edge[t]) || (c > 1 && e == edge[t + 1]);
      if (e != kNoIndex && !counted) ++table.triangleCount[static_cast<std::size_t>(e)];
    }
  }
}

} // namespace

EdgeTable findEdges(const Mesh& mesh, WorkControl* control)
{
  ESM_ASSERT(3 * std::int64_t{mesh.triangleCount()} + mesh.segmentCount() <=
             std::numeric_limits<Index>::max());
  const Index sides = 3 * mesh.triangleCount();
  const Index all = sides + mesh.segmentCount();
  std::vector<Index> edgeOf = firstAppearances<Index>(
    all, mesh.vertexCount(), [&](Index side) { return sideKey(mesh, side); }, control);
  if (stopWanted(control)) return {};

  Index edges = 0;
  for (Index side = 0; side < all; ++side)
    if (edgeOf[static_cast<std::size_t>(side)] == side) ++edges;

  EdgeTable table;
  table.ends.resize(2, edges);
  edges = 0;
  for (Index side = 0; side < all; ++side) {
    Index& edge = edgeOf[static_cast<std::size_t>(side)];
    if (edge == side) { // the first of its kind gets the next number, later ones follow it
      const auto [a, b] = sideKey(mesh, side);
      table.ends.col(edges) << a, b;
      edge = edges++;
    } else if (edge != kNoIndex) {
      edge = edgeOf[static_cast<std::size_t>(edge)];
    }
    if (side < sides) table.surfaceEdges = edges;
  }
  edgeOf.resize(static_cast<std::size_t>(sides));
  table.edgeOfSide = std::move(edgeOf);
  countTriangles(table);
  return table;
}

std::vector<Index> firstSameTriangle(const TriangleMatrix& triangles, Index vertexCount, WorkControl* control)
{
  const Index count = static_cast<Index>(triangles.cols());
  return firstAppearances<std::uint64_t>(
    count, vertexCount,
    [&](Index t) {
      const Index* corner = triangles.data() + 3 * std::ptrdiff_t{t};
      const auto [low, high] = std::minmax({corner[0], corner[1], corner[2]});
      // The middle one is what the sum has left; 64 bits, for the sum of three may pass 2^31.
      const std::int64_t middle = std::int64_t{corner[0]} + corner[1] + corner[2] - low - high;
      const std::uint64_t rest =
        (static_cast<std::uint64_t>(middle) << 32) | static_cast<std::uint64_t>(high);
      return std::pair{low, rest};
    },
    control);
}

} // namespace esm
