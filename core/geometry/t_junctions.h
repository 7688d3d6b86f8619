// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/work_control.h"
#include "core/geometry/edge_table.h"
#include "core/geometry/mesh.h"

#include <array>
#include <vector>

namespace esm {

/// A vertex on the middle of an edge that does not end in it: the two look joined and are not.
///
///          c
///        / | \        edge a-b belongs to one triangle, its neighbours
///      a---v---b      (a, v, d) and (v, b, e) end at v
struct TJunction {
  Index vertex = kNoIndex;
  Index edge = kNoIndex;                         ///< of the edge table
  std::array<Index, 2> ends{kNoIndex, kNoIndex}; ///< of the edge, smaller vertex first
  double along = 0.0;                            ///< where on the edge, 0 ... 1
  bool operator==(const TJunction&) const = default;
};

/// Vertices on border edges of triangles, by edge and then along it. Only vertices of other edges of borders
/// or of lines count: within a closed surface nothing is loose.
/// @param tolerance [unit of mesh] how far from the edge; from its ends they are further. 0: 1e-5 of the
/// box's
///                  diagonal.
/// @param control  may be null; once it is cancelled the list is of no use.
std::vector<TJunction> findTJunctions(const Mesh& mesh, const EdgeTable& edges, double tolerance,
                                      WorkControl* control = nullptr);

} // namespace esm
