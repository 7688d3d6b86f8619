// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace esm {

/// Positions and velocities at one instant. Plain data.
struct NetState {
  Eigen::Matrix3Xd position; ///< 3 x N [m]
  Eigen::Matrix3Xd velocity; ///< 3 x N [m/s]
  double time = 0.0;         ///< [s]
};

} // namespace esm
