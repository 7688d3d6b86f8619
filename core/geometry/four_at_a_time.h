// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/mesh.h"

namespace esm {

// What an import asks of every edge and every triangle, with four of them in the lanes of a register: a third
// of the time of one after the other, and the same bits.

/// Sets length[e] = distance() of the ends of edges first <= e < last, as long as they are what nearly all
/// are: finite, above zero, and no extreme.
/// @return whether all were
bool measureUsual(const Eigen::Matrix3Xd& position, const SegmentMatrix& ends, Index first, Index last,
                  Eigen::ArrayXd& length) noexcept;

/// How many triangles first <= t < last isDegenerate().
Index countDegenerate(const Mesh& mesh, Index first, Index last) noexcept;

} // namespace esm
