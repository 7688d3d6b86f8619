// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/work_control.h"
#include "core/geometry/mesh.h"

#include <vector>

namespace esm {

/// Two triangles of a mesh that run through each other.
struct SelfIntersection {
  Index first = kNoIndex, second = kNoIndex; ///< triangles, first < second
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
};

struct SelfIntersections {
  std::vector<SelfIntersection> pairs; ///< by first, then second
  bool isComplete = true;              ///< false: there are more, or the time was over
};

/// Triangles without a common vertex that share a point inside: an edge of one passes through the other.
/// Triangles that share a vertex or an edge touch anyway; of these only pairs that fold onto each other would
/// be wrong, and are not looked for. Triangles that lie in one plane do not count. Finds its candidates with
/// a tree of boxes, O((F + n) log F). Deterministic unless the time ends it. Any thread.
/// @param seconds  the longest that it may take; 0: as long as it wants. @param most  pairs that are listed.
/// @param control  may be null; once it is cancelled the list is not whole: ask stopWanted().
SelfIntersections findSelfIntersections(const Mesh& mesh, double seconds, std::size_t most = 10'000,
                                        WorkControl* control = nullptr);

} // namespace esm
