// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/mesh.h"

#include <span>
#include <vector>

namespace esm {

/// Cuts a polygon into triangles and appends their corners, three by three, to `out`.
///
/// A fan would give one node of a 600-gon 599 springs; here the ear with the shortest diagonal is clipped
/// first, so springs stay short and no node becomes a hub. Ears are looked for in the polygon's own plane
/// (Newell's normal), so concave polygons stay inside their outline. A quad is split along its shorter
/// inner diagonal. A polygon that has no ear left (it crosses itself) is cut along its shortest diagonals
/// all the same. Consecutive equal corners count once; a triangle is appended as it is.
/// Cost O(n^2); above kLongPolygon corners a zigzag between the two halves of the outline, O(n).
/// @param position 3 x V; corners in range.
void triangulate(const Eigen::Matrix3Xd& position, std::span<const Index> corners, std::vector<Index>& out);

inline constexpr std::size_t kLongPolygon = 1024;

} // namespace esm
