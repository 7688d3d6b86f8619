// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/edge_table.h"
#include "core/geometry/mesh.h"

#include <vector>

namespace esm {

/// A border of the surface: edges with one triangle, one after the other.
struct BoundaryLoop {
  std::vector<Index> vertices; ///< in order; the first is not repeated at the end
  double length = 0.0;         ///< [unit]
  bool isClosed = true;        ///< else the border ends at an edge with many triangles
  Index edges() const { return static_cast<Index>(vertices.size()) - (isClosed ? 0 : 1); }
};

/// The borders of the surface; each border edge is in one of them. A border that comes back to a vertex is
/// two loops, so that no vertex is twice in one. Loops run as their triangles do, the surface at their left,
/// as far as these agree. O(V + F). @pre `edges` are those of `mesh`
std::vector<BoundaryLoop> findBoundaryLoops(const Mesh& mesh, const EdgeTable& edges);

} // namespace esm
