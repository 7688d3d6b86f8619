// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/mesh.h"

#include <vector>

namespace esm {

/// Which vertices hang together by triangles, segments and tetrahedra with different corners.
struct MeshParts {
  Index count = 0;
  std::vector<Index> ofVertex; ///< V; parts are numbered by their first vertex; kNoIndex: isolated
  std::vector<Index> elements; ///< per part: triangles + segments + tetrahedra
};

/// O(V + F). @pre indices in range
MeshParts findParts(const Mesh& mesh);

} // namespace esm
