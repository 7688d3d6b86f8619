// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace esm {

/// A place and a power of two that bring a mesh to coordinates around 1, so that squares and products of
/// lengths stay far from the ends of double.
struct Frame {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double scale = 1.0;
  double diagonal = 0.0; ///< of the box around all finite points, in the frame

  explicit Frame(const Eigen::Matrix3Xd& position)
  {
    Eigen::Vector3d low = Eigen::Vector3d::Zero(), high = low;
    bool any = false;
    for (Eigen::Index i = 0; i < position.cols(); ++i) {
      const Eigen::Vector3d p = position.col(i);
      if (!p.allFinite()) continue;
      low = any ? low.cwiseMin(p) : p;
      high = any ? high.cwiseMax(p) : p;
      any = true;
    }
    centre = 0.5 * low + 0.5 * high;
    const double size = (0.5 * high - 0.5 * low).maxCoeff();
    if (size > 0.0) scale = std::ldexp(1.0, std::clamp(-std::ilogb(size), -1000, 1000));
    diagonal = (in(high)-in(low)).norm();
  }
  Eigen::Vector3d in(const Eigen::Vector3d& p) const { return (p - centre) * scale; }
  Eigen::Vector3d out(const Eigen::Vector3d& p) const { return p / scale + centre; }
};

} // namespace esm
