// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/work_control.h"
#include "core/geometry/edge_table.h"
#include "core/geometry/mesh.h"

#include <cstdint>
#include <vector>

namespace esm {

/// Triangles that hang together over edges with exactly two of them.
struct SurfacePatch {
  Index firstTriangle = kNoIndex;
  Index triangles = 0;
  bool isClosed = false; ///< every edge has two triangles of the patch
  double volume = 0.0;   ///< enclosed, if closed and with the turned triangles turned; negative: inside out
};

/// Which side of a surface is out, as far as its triangles agree. Triangles with equal corners take no part
/// and belong to no patch.
struct Orientation {
  std::vector<SurfacePatch> patches;  ///< in the order of their first triangles
  std::vector<Index> patchOf;         ///< F, or kNoIndex
  std::vector<std::uint8_t> isTurned; ///< F: differs from most triangles of its patch
  std::vector<Index> unorientable; ///< edges over which neighbours cannot agree: the patch is a Moebius strip
};

/// O(F). @pre `edges` are those of `mesh`
/// @param control  may be null; once it is cancelled the orientation is not whole: ask stopWanted().
Orientation findOrientation(const Mesh& mesh, const EdgeTable& edges, WorkControl* control = nullptr);

} // namespace esm
