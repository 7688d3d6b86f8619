// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/base/work_control.h"
#include "core/net/spring_net.h"

namespace esm {

/// Twice the energy of a net and of the body that it stands for, stretched by 1 along its longest axis, both
/// per Young's modulus.
struct TensionTest {
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();
  double measured = 0.0; ///< of the net [m^3]
  double wanted = 0.0;   ///< of the body, the integral of its sections along the axis [m^3]
};

/// The principal direction along which the surface spreads most; where two spread nearly alike, the longest
/// side of the box, so that a cube is not pulled by a corner.
Eigen::Vector3d longestAxis(const SpringNet& net, const Eigen::ArrayXd& dualArea);

/// See setMaterial(). The net's own numbers are not looked at: E is 1 Pa everywhere, with its present scale.
/// @param isSolid the body is what fills SpringNet::volume; else it is the wall.
Result<TensionTest> testTension(const SpringNet& net, double thickness, bool isSolid,
                                WorkControl* control = nullptr);

} // namespace esm
