// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>

namespace esm {

/// The box around those of the points (3 x N) that are finite; empty if none is.
inline Eigen::AlignedBox3d boxOf(const Eigen::Ref<const Eigen::Matrix3Xd>& points)
{
  Eigen::AlignedBox3d box;
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    if (points.col(i).allFinite()) box.extend(points.col(i));
  return box;
}

/// The extent of a net or any other set of points: the diagonal of its box, in the points' unit; 0 without any.
inline double extentOf(const Eigen::Ref<const Eigen::Matrix3Xd>& points)
{
  const Eigen::AlignedBox3d box = boxOf(points);
  return box.isEmpty() ? 0.0 : box.diagonal().norm();
}

} // namespace esm
