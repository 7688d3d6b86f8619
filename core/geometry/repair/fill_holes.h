// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/mesh.h"
#include "core/geometry/repair/repair.h"

namespace esm {

/// Lays a patch over each hole of at most `mostEdges` edges whose rim is no longer than `longest` (0: any).
/// The patch begins as the triangulation of least area, gets vertices as dense as the rim's and is drawn
/// tight like a soap film. It makes no edge that is there already. Vertices and triangles are added at the
/// end. Error: Cancelled (mesh may have changed).
Status fillHoles(Mesh& mesh, Index mostEdges, double longest, RepairReport& report, WorkControl* control);

} // namespace esm
