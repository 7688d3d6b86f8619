// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/mesh.h"

#include <vector>

namespace esm::support {

/// What springs a cell of tissue may have, each as its vector from end to end, and whether it lies in an inner or
/// outer side of the cell. A cell is a prism between two triangles of a wall; springs that reach into the
/// neighbour count too.
struct CellSprings {
  Eigen::Matrix3Xd way;                ///< 3 x m [m]
  std::vector<std::uint8_t> isInLayer; ///< m
};

/// How much of the cell's tissue each spring stands for: w = section length / volume, so that
///
///     k = E section / length,   sum of w n n n n = isotropic tensor of E = 1 and Poisson's ratio 1/4
///
/// for the springs' directions n, as near as springs can. What pulls at a spring net stretches it by E in each
/// direction if that tensor is isotropic; central forces then have Poisson's ratio 1/4 and G = 0.4 E (tissue of
/// ratio 0.33 to 0.45: 0.376 to 0.345 E). A third of the stretch along the layer lies in the layers' own springs,
/// so that a wall bends as a solid of its thickness (of sheets that carry all it would bend three times too
/// hardly). By least squares with a bound from below, so that no spring is without tissue; then all are scaled until a
/// pull along the layer, free across, meets 0.84 E in the mean over its directions (of the compliance): nets of such
/// cells yield less to loads that vary from cell to cell than to an even strain.
struct CellShares {
  Eigen::ArrayXd share; ///< m, > 0 [1]
  double error = 0.0;   ///< of the tensor, relative, Frobenius [1]
};
/// @param normal of the layer, unit. @pre the ways have length and there are some
CellShares shareCell(const CellSprings& springs, const Eigen::Vector3d& normal);

} // namespace esm::support
