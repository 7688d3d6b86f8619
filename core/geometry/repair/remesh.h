// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/base/work_control.h"
#include "core/geometry/mesh.h"
#include "core/geometry/repair/repair.h"

#include <vector>

namespace esm {

/// Lengths of the edges of the triangles, longest and shortest; 0 and 0 without triangles.
struct EdgeLengths {
  double shortest = 0.0, longest = 0.0, mean = 0.0;
  /// What a net wants: the shortest spring sets the time step.
  bool areAlike() const { return longest <= kMostUnlike * shortest; }
  static constexpr double kMostUnlike = 5.0;
};
EdgeLengths edgeLengths(const Mesh& mesh);

/// Replaces the triangles by nearly equilateral ones of nearly equal size: collapses edges until they are
/// about as long as wished, then improves the net on the original surface (class Remesher). Borders, creases
/// of more than 40 degrees, ends of segments and corners of tetrahedra are kept; non-manifold edges stay as
/// they are and no new ones come up. Meshes that are so already stay as they are.
/// @param triangles   at most so many, or 0 if
/// @param edgeLength  [unit of mesh] is given.
/// @pre no triangle has equal corners or comes twice; all vertices are finite.
/// Errors (mesh may have changed): InvalidValue if far too many triangles would come of it, Cancelled.
/// Memory: about 350 bytes per triangle.
Status remeshSurface(Mesh& mesh, Index triangles, double edgeLength, RepairReport& report,
                     std::vector<Index>& vertexOf, WorkControl* control);

} // namespace esm
