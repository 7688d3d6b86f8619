// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/types.h"

#include <Eigen/Core>

#include <cmath>

namespace esm {

/// The rare case of distance(), kept out of the loops that call it.
[[gnu::noinline, gnu::cold]] inline double scaledNorm(const Eigen::Vector3d& v)
{
  return v.stableNorm();
}

/// Between them the root of a square is a length above zero to the last bit. Squares leave the range of
/// double beyond about 1e154 and below 1e-154.
inline constexpr double kLeastUsualSquare = 1e-280, kMostUsualSquare = 1e280;

inline bool isUsualSquare(double squared)
{
  return squared > kLeastUsualSquare && squared < kMostUsualSquare;
}

/// Euclidean distance. Where squares leave the range of double the slower scaled norm answers, so that no
/// spring is taken for zero long or infinitely long.
inline double distance(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  const Eigen::Vector3d between = b - a;
  const double squared = between.squaredNorm();
  return isUsualSquare(squared) ? std::sqrt(squared) : scaledNorm(between);
}

/// The column of `places` that is nearest to a place. @pre there is one
inline Index nearestOf(const Eigen::Matrix3Xd& places, const Eigen::Vector3d& place)
{
  Eigen::Index nearest = 0;
  (places.colwise() - place).colwise().squaredNorm().minCoeff(&nearest);
  return static_cast<Index>(nearest);
}

} // namespace esm
