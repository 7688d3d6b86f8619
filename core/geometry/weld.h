// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/work_control.h"
#include "core/geometry/mesh.h"

#include <vector>

namespace esm {

/// Joins vertices at the same place, as unwelded STL needs. Vertices keep the order of their first
/// appearance; triangles, segments, tetrahedra and diagonals are renumbered, none is removed.
/// @param tolerance [file unit]; 0 joins bit-equal positions only (-0 equals 0). Above 0, a vertex
///        joins the first earlier kept vertex within `tolerance` (Euclidean). Vertices with a
///        non-finite coordinate join nothing.
/// @param control may be null; once it is cancelled the mesh and the map are of no use, ask stopWanted().
/// @return old-to-new map: result[old vertex] = new vertex, all of them valid.
std::vector<Index> weldVertices(Mesh& mesh, double tolerance = 0.0, WorkControl* control = nullptr);

} // namespace esm
