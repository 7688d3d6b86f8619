// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/tissue/region.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

/// Principal directions, the widest first, right-handed, each with its largest component above zero, so that
/// equal selections give equal rotations.
Eigen::Matrix3d principalAxes(const Eigen::Matrix3d& covariance, Eigen::Vector3d& deviations)
{
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  const Eigen::Matrix3d& rising = solver.eigenvectors();
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

/// Direction, centre and shape of weighted places.
struct Principal {
  Eigen::Vector3d centre;
  Eigen::Matrix3d axes;
  Eigen::Vector3d shape; ///< deviations, those of flat directions a hundredth of the widest [m]
  int directions = 0;    ///< in which the places spread
};

Principal principalOf(const Eigen::Matrix3Xd& places, const Eigen::VectorXd& weights)
{
  Principal found;
  found.centre = places * weights;
  const Eigen::Matrix3Xd arms = places.colwise() - found.centre;
  Eigen::Vector3d deviations;
  found.axes = principalAxes(arms * weights.asDiagonal() * arms.transpose(), deviations);
  // A direction without spread would make every place infinitely far.
  const double least = 0.01 * deviations[0];
  found.shape = deviations.cwiseMax(least);
  found.directions = static_cast<int>((deviations.array() > least).count());
  return found;
}

/// Weights with which the places' own principal directions are those of the smallest ellipsoid around them:
/// inner places of a patch count for nothing. Places on an ellipsoid keep equal weights.
/// Source: Khachiyan, Math. Oper. Res. 21 (1996) 307-320, with the steps away of Todd & Yildirim 2007.
Eigen::VectorXd outerWeights(const Eigen::Matrix3Xd& places)
{
  const Eigen::Index count = places.cols();
  Eigen::VectorXd weights = Eigen::VectorXd::Constant(count, 1.0 / static_cast<double>(count));
  const Principal plain = principalOf(places, weights);
  const int n = plain.directions + 1;
  if (count <= n || plain.directions == 0) return weights;
  Eigen::MatrixXd lifted(n, count);
  lifted.topRows(n - 1) =
    (plain.shape.cwiseInverse().asDiagonal() * plain.axes.transpose() * (places.colwise() - plain.centre))
      .topRows(n - 1);
  lifted.row(n - 1).setOnes();
  constexpr double kClose = 1e-3; // of the volume's exponent: nobody sees more
  constexpr int kMostSteps = 2000;
  for (int step = 0; step < kMostSteps; ++step) {
    const Eigen::MatrixXd moments = lifted * weights.asDiagonal() * lifted.transpose();
    const Eigen::VectorXd reach =
      lifted.cwiseProduct(moments.ldlt().solve(lifted)).colwise().sum().transpose(); // mean n
    Eigen::Index out = 0, in = 0;
    const double most = reach.maxCoeff(&out);
    const double least = (weights.array() > 0.0).select(reach.array(), most).minCoeff(&in);
    if (!std::isfinite(most) || (most <= (1.0 + kClose) * n && least >= (1.0 - kClose) * n)) break;
    const bool away = n - least > most - n;
    const Eigen::Index place = away ? in : out;
    double share = (reach[place] - n) / (n * (reach[place] - 1.0));
    if (away) share = std::max(share, -weights[place] / (1.0 - weights[place]));
    weights *= 1.0 - share;
    weights[place] = std::max(weights[place] + share, 0.0);
  }
  return weights / weights.sum();
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

  const Principal outer = principalOf(places, outerWeights(places));
  const Eigen::Matrix3Xd arms = places.colwise() - outer.centre;
  Eigen::Vector3d semiAxes = Eigen::Vector3d::Zero();
  if (outer.shape[0] > 0.0) {
    const Eigen::Matrix3d toShape = outer.shape.cwiseInverse().asDiagonal() * outer.axes.transpose();
    semiAxes = outer.shape * (toShape * arms).colwise().norm().maxCoeff();
  }
  // A hair larger, so that rounding leaves no selected place outside.
  semiAxes *= (1.0 + 1e-9) / (1.0 - falloff);
  return Ellipsoid{outer.centre, semiAxes.cwiseMax(leastSemiAxis),
                   Eigen::Quaterniond(outer.axes).normalized()};
}

} // namespace esm
