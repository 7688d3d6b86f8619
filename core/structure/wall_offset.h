// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/net/outward_surface.h"

#include <string>
#include <vector>

namespace esm::support {

/// The inner side of a wall: each node of the surface goes inwards along a straight line, so that the faces
/// around it lie one thickness deeper. Triangles keep their corners' numbers, so the inner surface is as
/// closed as the outer one, and each triangle and its inner one are the ends of a prism.
struct WallOffset {
  Eigen::Matrix3Xd depth;         ///< 3 x N, from a node to its inner one [m]; 0 off the surface
  std::vector<std::uint8_t> isOn; ///< N, 1 = on the surface
  Index thinned = 0;              ///< nodes where the wall had to stay thinner
  double thinnest = 0.0;          ///< of these, share of the wished thickness; 1 without any
  Index crossing = 0;             ///< triangles of the inner surface that still run through others
};

/// Where the wished thickness has no room, the wall is thinner: at most 0.4 of the way to the opposite wall, no
/// triangle less than a tenth of the outer one, none turned over or running through another; and its thickness
/// changes by at most half of the way along the surface. Independent of the order of nodes and triangles, to
/// rounding. O(F log F).
/// Errors: InvalidValue (a surface without sides; a wall that has room on less than half of the surface),
/// Cancelled.
Result<WallOffset> offsetInwards(const SpringNet& net, const OutwardSurface& surface, double thickness,
                                 WorkControl* control);

} // namespace esm::support
