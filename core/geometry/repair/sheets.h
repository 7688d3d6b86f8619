// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/work_control.h"
#include "core/geometry/mesh.h"
#include "core/geometry/repair/half_edge_mesh.h"

#include <cstdint>
#include <vector>

namespace esm {

/// The triangles of a mesh cut into manifold sheets: apart along edges with more than two triangles and where
/// neighbours cannot agree on a side, and with one copy of a vertex per fan of triangles. Cut edges are rigid
/// and the copies keep their places, so that putting copies together again restores the mesh there.
struct Sheets {
  HalfEdgeMesh surface;      ///< its first vertices are those of the mesh, then copies
  std::vector<Index> origin; ///< by vertex of the surface: the mesh's
};

/// Triangles stay in their order, and are turned until neighbours agree.
/// @param isPinned  V: must stay where they are.
/// @param control  may be null; once it is cancelled the sheets are not whole: ask stopWanted().
/// @pre no triangle has equal corners or comes twice.
Sheets cutToSheets(const Mesh& mesh, const std::vector<std::uint8_t>& isPinned,
                   WorkControl* control = nullptr);

/// Marks borders and creases (more than 40 degrees between the normals) as curves, and the corners where
/// curves end, meet or turn sharply as fixed. Creases that are only roughness at this edge length (stairs of
/// voxels, noise) are passed over. @return whether creases were found and passed over
/// @param control  as in cutToSheets().
bool markCurves(HalfEdgeMesh& surface, double edgeLength, WorkControl* control = nullptr);

} // namespace esm
