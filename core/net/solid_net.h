// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/mesh.h"
#include "core/net/spring_net.h"

#include <vector>

namespace esm {

/// The mesh with its tetrahedra written as what a net is made of: their edges as segments, and, if the mesh
/// has no triangles, their faces that no other shares as the surface, normals outwards. Indices in range.
Mesh withoutTetrahedra(const Mesh& mesh);

/// Gives the springs over tetrahedra's edges their section and the nodes their volume (Van Gelder 1998):
///
///     section = sum of volumes / L, so that k = E sum of volumes / L^2       volume = sum of volumes / 4
///
/// These springs count as edges, not as lines. @param nodeOf node of each vertex, kNoIndex for none.
void addSolidShares(const Eigen::Matrix3Xd& position, const TetrahedronMatrix& tetrahedra,
                    const std::vector<Index>& nodeOf, SpringNet& net);

/// Whether edges have sections of their own, as tetrahedra give them.
bool isSolidNet(const SpringNet& net);

} // namespace esm
