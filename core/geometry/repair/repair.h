// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/base/work_control.h"
#include "core/geometry/mesh.h"

#include <string>
#include <vector>

namespace esm {

/// What to repair in a mesh before it becomes a net. The default changes nothing. Each line is one option of
/// the import dialog; repairMesh() carries them out in the order in which they stand here. Lengths are in the
/// unit of the mesh.
struct RepairOptions {
  /// Take away degenerate triangles, later duplicates of triangles and segments, and vertices that nothing
  /// uses.
  bool removeUseless = false;
  /// Split the edges on whose middle a vertex of another triangle lies, so that springs connect there.
  bool closeTJunctions = false;
  double tJunctionTolerance = 0.0; ///< how near a vertex must be to the edge; 0: 1e-5 of the box's diagonal
  /// Take away connected parts with fewer elements (triangles + segments + tetrahedra) than this; 0: none.
  Index dropPartsBelow = 0;
  /// The same with a share of the largest part's elements, 0 ... 1.
  double dropPartsShare = 0.0;
  /// Close the holes of at most so many edges; 0: none. The patch gets vertices of its own, as dense as the
  /// rim, so that its springs are as long as their neighbours.
  Index fillHolesUpTo = 0;
  double fillHolesLength = 0.0; ///< ... or with a rim of at most this length; 0: whatever fillHolesUpTo says
  /// Turn triangles until neighbours agree, and closed parts until they look outwards (positive volume).
  bool unifyOrientation = false;
  /// Make a new surface net of about, and never more than, so many triangles, nearly equilateral and of
  /// nearly equal size; 0: as it is. Ends of segments and corners of tetrahedra stay where they are.
  Index triangles = 0;
  /// ... or one of about this edge length, coarser or finer; 0: as it is. Not together with `triangles`.
  double edgeLength = 0.0;

  bool operator==(const RepairOptions&) const = default;
  bool doesNothing() const { return *this == RepairOptions{}; }
};

/// What repairMesh() has changed.
struct RepairReport {
  Index nonFiniteVertices = 0; ///< left out with all that stood on them
  Index degenerateFaces = 0, duplicateFaces = 0, isolatedVertices = 0; ///< removed
  Index uselessSegments = 0;  ///< removed: of no length, or there twice
  Index closedTJunctions = 0; ///< vertices now tied to the edge they lay on
  Index droppedParts = 0, droppedElements = 0;
  Index filledHoles = 0, patchTriangles = 0;
  Index turnedFaces = 0;                  ///< so that neighbours agree, or that closed parts look outwards
  Index unorientable = 0;                 ///< edges over which neighbours cannot agree (Moebius strips)
  Index remeshedFrom = 0, remeshedTo = 0; ///< triangles before and after; 0 and 0 if not remeshed
  double shortestEdge = 0.0, longestEdge = 0.0; ///< of the triangles after remeshing
  /// Old vertex -> new one; kNoIndex for those taken away. New vertices come after all kept ones.
  std::vector<Index> vertexOf;
  std::vector<std::string> notes; ///< what was changed and what could not be, one sentence each
};

/// Repairs `mesh` as wished. Segments and tetrahedra are kept and renumbered. Whatever stands on a non-finite
/// vertex is left out first (and said), if there is anything to do at all.
/// Equal input gives equal bits; repairing again changes nothing more.
/// @pre indices in range.
/// Errors, each of which leaves `mesh` as it was: InvalidValue for impossible options, EmptyResult if nothing
/// would be left, Cancelled within 100 ms. @note Any thread, no state.
Status repairMesh(Mesh& mesh, const RepairOptions& options, RepairReport& report,
                  WorkControl* control = nullptr);

} // namespace esm
