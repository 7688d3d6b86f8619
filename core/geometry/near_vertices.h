// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/work_control.h"
#include "core/geometry/edge_table.h"
#include "core/geometry/mesh.h"

namespace esm {

/// Vertices that would join others if float32 were a little finer: seams between placed copies of a part,
/// which their transforms round apart.
struct NearVertices {
  Index count = 0;        ///< that a weld with this tolerance would join to others
  double tolerance = 0.0; ///< in the mesh's unit; small beside its edges
};

enum class NearWhere {
  Open,      ///< on borders and lines, which costs next to nothing where surfaces are closed
  Everywhere ///< closed parts may meet, too
};

/// @param edges listEdges(mesh) of the welded mesh
NearVertices findNearVertices(const Mesh& mesh, const EdgeList& edges, NearWhere where,
                              WorkControl* control = nullptr);

} // namespace esm
