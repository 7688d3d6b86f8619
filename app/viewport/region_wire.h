// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/ellipsoid.h"

#include <vector>

namespace esm {

/// Appends the wireframe of an ellipsoid as GL_LINES, x y z per end, relative to `origin` [m]: its three
/// principal ellipses, two parallels and two further meridians. Adds nothing for a non-finite ellipsoid.
void appendRegionWire(const Ellipsoid& ellipsoid, const Eigen::Vector3d& origin, std::vector<float>& lines);

/// The three principal ellipses in dashes: the shell where the weight begins to fall.
void appendRegionShell(const Ellipsoid& ellipsoid, const Eigen::Vector3d& origin, std::vector<float>& lines);

/// Spines that stand outward on the principal ellipses: the region is what lies outside.
void appendRegionSpines(const Ellipsoid& ellipsoid, const Eigen::Vector3d& origin, std::vector<float>& lines);

} // namespace esm
