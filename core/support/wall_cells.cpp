// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/support/wall_cells.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace esm::support {

namespace {

constexpr int kComponents = 15;           ///< of a tensor of fourth order that is symmetric in all indices
constexpr double kTensorTrace = 6.0;      ///< of the isotropic one of E = 1
constexpr double kBendingWeight = 1.0;    ///< of the layers' share, against that of isotropy
constexpr double kLayerShare = 1.0 / 3.0; ///< of the stretch along the layers that lies in them
constexpr double kEvenWeight = 0.05;      ///< of even shares
constexpr double kLeastCellShare = 0.1;   ///< of an even share
constexpr int kMostSweeps = 400;

using Tensor = Eigen::Matrix<double, kComponents, 1>;

/// The components x^a y^b z^c, each times the root of how often it stands in the tensor, so that the norm is
/// Frobenius' and does not depend on the axes.
Tensor fourth(const Eigen::Vector3d& n)
{
  constexpr std::array<double, 5> kFactorial = {1, 1, 2, 6, 24};
  Tensor tensor;
  int i = 0;
  for (int a = 0; a <= 4; ++a)
    for (int b = 0; a + b <= 4; ++b) {
      const int c = 4 - a - b;
      const double often =
        24.0 / (kFactorial[static_cast<std::size_t>(a)] * kFactorial[static_cast<std::size_t>(b)] *
                kFactorial[static_cast<std::size_t>(c)]);
      tensor[i++] = std::sqrt(often) * std::pow(n[0], a) * std::pow(n[1], b) * std::pow(n[2], c);
    }
  return tensor;
}

/// Mean of n n n n over all directions in space, and over those in a plane, by quadrature that is exact for it.
Tensor meanInPlane(const Eigen::Vector3d& normal)
{
  const Eigen::Vector3d u = normal.unitOrthogonal(), v = normal.cross(u);
  Tensor sum = Tensor::Zero();
  constexpr int kDirections = 6; // exact up to the fifth harmonic
  for (int i = 0; i < kDirections; ++i) {
    const double angle = std::numbers::pi * i / kDirections;
    sum += fourth(std::cos(angle) * u + std::sin(angle) * v);
  }
  return sum / kDirections;
}

Tensor meanInSpace()
{
  Tensor sum = Tensor::Zero(); // 6 diagonals of the icosahedron: a design of fifth order
  const double g = 0.5 * (1.0 + std::sqrt(5.0));
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {1.0, -1.0}) {
      Eigen::Vector3d n = Eigen::Vector3d::Zero();
      n[axis] = 1.0;
      n[(axis + 1) % 3] = sign * g;
      sum += fourth(n.normalized());
    }
  return sum / 6.0;
}

} // namespace

CellShares shareCell(const CellSprings& springs, const Eigen::Vector3d& normal)
{
  const Eigen::Index count = springs.way.cols();
  const double even = kTensorTrace / static_cast<double>(count);
  const Tensor wanted = kTensorTrace * meanInSpace();
  // Of plane stress at Poisson's ratio 1/4, E/(1 - 1/16) along each axis: a plane tensor has 3/8 of its trace there.
  const Tensor wantedInLayer = kLayerShare * (16.0 / 15.0) / (3.0 / 8.0) * meanInPlane(normal);
  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(2 * kComponents, count);
  for (Eigen::Index s = 0; s < count; ++s) {
    const Tensor tensor = fourth(springs.way.col(s).normalized());
    rows.col(s).head(kComponents) = tensor;
    if (springs.isInLayer[static_cast<std::size_t>(s)])
      rows.col(s).tail(kComponents) = kBendingWeight * tensor;
  }
  Eigen::VectorXd right(2 * kComponents);
  right << wanted, kBendingWeight * wantedInLayer;
  Eigen::MatrixXd normalMatrix = rows.transpose() * rows;
  normalMatrix.diagonal().array() += kEvenWeight * kEvenWeight;
  const Eigen::VectorXd normalRight =
    rows.transpose() * right + Eigen::VectorXd::Constant(count, kEvenWeight * kEvenWeight * even);

  // Coordinate descent with the bound from below: convex, so there is one answer.
  Eigen::VectorXd share = Eigen::VectorXd::Constant(count, even);
  for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
    double change = 0.0;
    for (Eigen::Index s = 0; s < count; ++s) {
      const double slope = normalMatrix.row(s).dot(share) - normalRight[s];
      const double next = std::max(kLeastCellShare * even, share[s] - slope / normalMatrix(s, s));
      change = std::max(change, std::abs(next - share[s]));
      share[s] = next;
    }
    if (change < 1e-12 * kTensorTrace) break;
  }
  share *= kTensorTrace / share.sum();
  CellShares shares;
  shares.share = share.array();
  shares.error = (rows.topRows(kComponents) * share - wanted).norm() / wanted.norm();
  return shares;
}

} // namespace esm::support
