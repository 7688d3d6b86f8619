// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace esm {

/// The point of a triangle nearest to `point` (Ericson, Real-Time Collision Detection, 5.1.5). A triangle
/// without area answers with a point of its edges.
Eigen::Vector3d nearestWeights(const Eigen::Vector3d& point, const Eigen::Vector3d& a,
                               const Eigen::Vector3d& b, const Eigen::Vector3d& c);

} // namespace esm
