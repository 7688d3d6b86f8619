// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/types.h"

#include <Eigen/Core>

#include <array>
#include <functional>
#include <vector>

namespace esm {

/// Triangles over a closed loop of points in space, of the least area, and among those of equal area with the
/// shortest diagonals, so that no point becomes a hub (Barequet and Sharir, Filling gaps in the boundary of a
/// polyhedron, 1995). O(n^3); loops of more than 200 points are first cut in two at short diagonals.
/// @param isAllowed  whether places i and j of the loop, not neighbours in it, may be joined.
/// @return places in the loop, in its direction; empty if there is no triangulation with allowed diagonals
/// only.
std::vector<std::array<Index, 3>> triangulateLoop(const std::vector<Eigen::Vector3d>& points,
                                                  const std::function<bool(Index, Index)>& isAllowed);

} // namespace esm
