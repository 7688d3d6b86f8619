// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/mesh.h"
#include "core/geometry/repair/repair.h"

#include <vector>

namespace esm {

// Repairs that only take away or turn. Each says in the report what it did and leads `vertexOf` on
// (original vertex -> vertex of `mesh`). Once `control` (may be null) is cancelled, what they leave is of no
// use: ask stopWanted().

/// Non-finite vertices and all that stands on them.
void leaveOutNonFinite(Mesh& mesh, RepairReport& report, std::vector<Index>& vertexOf);

/// Degenerate triangles, later duplicates of triangles and segments, unused vertices.
void removeUseless(Mesh& mesh, RepairReport& report, std::vector<Index>& vertexOf, WorkControl* control);

/// Parts with fewer than `below` elements, or less than `share` of the largest part's.
void dropSmallParts(Mesh& mesh, Index below, double share, RepairReport& report,
                    std::vector<Index>& vertexOf);

/// Neighbours agree, closed parts look outwards.
void unifyOrientation(Mesh& mesh, RepairReport& report, WorkControl* control);

} // namespace esm
