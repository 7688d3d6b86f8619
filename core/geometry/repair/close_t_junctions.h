// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/mesh.h"
#include "core/geometry/repair/repair.h"

namespace esm {

/// Splits each edge on whose middle a vertex lies: triangles and segments over it go through the vertex. No
/// vertex comes up or moves. @param tolerance as in RepairOptions.
/// Error: Cancelled (mesh may have changed).
Status closeTJunctions(Mesh& mesh, double tolerance, RepairReport& report, WorkControl* control);

} // namespace esm
