// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/tissue/region.h"

#include <Eigen/Eigenvalues>

#include <cmath>

namespace esm {

namespace {

/// Principal directions, the widest first, right-handed, each with its largest component above zero, so that
/// equal selections give equal rotations.
Eigen::Matrix3d principalAxes(const Eigen::Matrix3d& covariance, Eigen::Vector3d& deviations)
{
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  const Eigen::Matrix3d rising = solver.eigenvectors();
  Eigen::Matrix3d axes;
  for (int i = 0; i < 2; ++i) {
    axes.col(i) = rising.col(2 - i);
    Eigen::Index largest = 0;
    axes.col(i).cwiseAbs().maxCoeff(&largest);
    if (axes(largest, i) < 0.0) axes.col(i) *= -1.0;
  }
  axes.col(2) = axes.col(0).cross(axes.col(1));
  deviations = solver.eigenvalues().reverse().cwiseMax(0.0).cwiseSqrt();
  return axes;
}

} // namespace

Result<Ellipsoid> fitEllipsoid(const Eigen::Matrix3Xd& places, double leastSemiAxis, double falloff)
{
  const auto refuse = [](const char* why) {
    return Error{ErrorCode::InvalidValue, std::string("no ellipsoid can be fitted: ") + why};
  };
  if (places.cols() == 0) return refuse("nothing is selected");
  if (!places.allFinite()) return refuse("a place is not finite");
  if (!(std::isfinite(leastSemiAxis) && leastSemiAxis > 0.0))
    return refuse("the least semi-axis must be above 0 m");
  if (!(falloff >= 0.0 && falloff < 1.0)) return refuse("the falloff must be at least 0 and below 1");

  const Eigen::Vector3d centre = places.rowwise().mean();
  const Eigen::Matrix3Xd arms = places.colwise() - centre;
  Eigen::Vector3d deviations;
  const Eigen::Matrix3d axes =
    principalAxes(arms * arms.transpose() / static_cast<double>(places.cols()), deviations);

  // A direction without spread would make every place infinitely far; a hundredth of the widest will do.
  const Eigen::Vector3d shape = deviations.cwiseMax(0.01 * deviations[0]);
  Eigen::Vector3d semiAxes = Eigen::Vector3d::Zero();
  if (shape[0] > 0.0) {
    const Eigen::Matrix3d toShape = shape.cwiseInverse().asDiagonal() * axes.transpose();
    semiAxes = shape * (toShape * arms).colwise().norm().maxCoeff();
  }
  // A hair larger, so that rounding leaves no selected place outside.
  semiAxes *= (1.0 + 1e-9) / (1.0 - falloff);
  return Ellipsoid{centre, semiAxes.cwiseMax(leastSemiAxis), Eigen::Quaterniond(axes).normalized()};
}

} // namespace esm
