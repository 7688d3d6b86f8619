// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/mesh.h"
#include "core/net/spring_net.h"

#include <vector>

namespace esm {

/// Gives a repaired mesh the diagonals of the one it was made from; those whose vertices are gone go too.
/// @param vertexOf vertex of `original` -> vertex of `mesh`, or kNoIndex
void followDiagonals(Mesh& mesh, const Mesh& original, const std::vector<Index>& vertexOf);

/// Takes out of a net the springs that are nothing but cuts through polygons: those over which there is no
/// line and no side of a triangle besides the two that each cut has made. Nodes and triangles stay.
/// @param nodeOfVertex as buildNet() gave it for `mesh`
void dropDiagonals(SpringNet& net, const Mesh& mesh, const std::vector<Index>& nodeOfVertex);

} // namespace esm
