// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/quality/linear_net.h"

namespace esm {

/// A force on a round patch of the surface, cos^2 from its middle, `place`, to its rim, by the nodes' share
/// of the surface; on a net of lines, or if the patch holds no free node, on the nearest node. The sum is
/// `force`. 3 x N [N].
Eigen::Matrix3Xd pokePatch(const SpringNet& net, const Eigen::Vector3d& place, const Eigen::Vector3d& force,
                           double radius);

struct Dent {
  double depth = 0.0;    ///< mean over the patch, weighted as the force [m]
  Index node = kNoIndex; ///< the middle of the patch
};
/// Pokes about a dozen places, far from each other, against the surface (on a net of lines along x), one by
/// one.
/// @param linear factored by this function. @return the deepest dent; infinite if nothing resists.
Dent deepestDent(const SpringNet& net, LinearNet& linear, double poke, double radius,
                 WorkControl* control = nullptr);

} // namespace esm
