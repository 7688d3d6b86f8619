// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/mesh.h"

#include <cstdint>
#include <vector>

namespace esm {

/// What shall stay of a mesh; all of it at first.
struct Kept {
  std::vector<std::uint8_t> vertices, triangles, segments, tetrahedra;
  explicit Kept(const Mesh& mesh);
};

/// Takes away what is not kept, and elements whose vertices are not. The rest keeps its order.
/// @param vertexOf original vertex -> vertex of `mesh`; led on through this renumbering.
void keepOnly(Mesh& mesh, const Kept& kept, std::vector<Index>& vertexOf);

} // namespace esm
