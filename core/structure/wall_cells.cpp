// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/structure/wall_cells.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

namespace esm::support {

namespace {

constexpr int kComponents = 15;           ///< of a tensor of fourth order that is symmetric in all indices
constexpr double kTensorTrace = 6.0;      ///< of the isotropic one of E = 1
constexpr double kBendingWeight = 1.0;    ///< of the layers' share, against that of isotropy
constexpr double kLayerShare = 1.0 / 3.0; ///< of the stretch along the layers that lies in them
constexpr double kEvenWeight = 0.2;       ///< of even shares
/// A net of cells as wide as the wall is stiffer than an even strain tells: what is left to E, chosen by hand with
/// all cases of the tube of bench/fem in view.
constexpr double kCellYield = 0.84;
constexpr double kLeastCellShare = 0.1; ///< of an even share

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

/// The z >= 0 of least z^T M z / 2 - q^T z, M positive definite: the active sets of Lawson and Hanson (1974), which end
/// at the one answer whatever the order.
Eigen::VectorXd notNegative(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right)
{
  const Eigen::Index count = right.size();
  const double tiny = 1e-12 * right.cwiseAbs().maxCoeff();
  Eigen::VectorXd z = Eigen::VectorXd::Zero(count);
  std::vector<std::uint8_t> isIn(static_cast<std::size_t>(count), 0);
  for (Eigen::Index round = 0; round < 3 * count; ++round) {
    const Eigen::VectorXd slope = right - matrix * z;
    Eigen::Index best = -1;
    for (Eigen::Index i = 0; i < count; ++i)
      if (!isIn[static_cast<std::size_t>(i)] && slope[i] > tiny && (best < 0 || slope[i] > slope[best]))
        best = i;
    if (best < 0) break;
    isIn[static_cast<std::size_t>(best)] = 1;
    for (;;) {
      std::vector<Eigen::Index> in;
      for (Eigen::Index i = 0; i < count; ++i)
        if (isIn[static_cast<std::size_t>(i)]) in.push_back(i);
      const Eigen::VectorXd solved = Eigen::MatrixXd(matrix(in, in)).ldlt().solve(Eigen::VectorXd(right(in)));
      double way = 1.0; // as far as all stay above 0
      for (std::size_t k = 0; k < in.size(); ++k)
        if (const double to = solved[static_cast<Eigen::Index>(k)]; to <= 0.0)
          way = std::min(way, z[in[k]] / (z[in[k]] - to));
      for (std::size_t k = 0; k < in.size(); ++k)
        z[in[k]] += way * (solved[static_cast<Eigen::Index>(k)] - z[in[k]]);
      if (way == 1.0) break;
      for (const Eigen::Index i : in)
        if (!(z[i] > tiny)) {
          z[i] = 0.0;
          isIn[static_cast<std::size_t>(i)] = 0;
        }
    }
  }
  return z;
}

/// Strain per stress of a pull along the layer, free across it: the mean over the layer's directions, where the
/// springs hold these shares of a tissue of E = 1.
double meanComplianceInPlane(const CellSprings& springs, const Eigen::VectorXd& share,
                             const Eigen::Vector3d& normal)
{
  const Eigen::Vector3d u = normal.unitOrthogonal(), v = normal.cross(u);
  Eigen::Matrix<double, 6, 6> stiffness = Eigen::Matrix<double, 6, 6>::Zero();
  for (Eigen::Index s = 0; s < share.size(); ++s) {
    const Eigen::Vector3d way = springs.way.col(s).normalized();
    const double x = way.dot(u), y = way.dot(v), z = way.dot(normal);
    Eigen::Matrix<double, 6, 1> stretch;
    stretch << x * x, y * y, z * z, y * z, z * x, x * y;
    stiffness += share[s] * stretch * stretch.transpose();
  }
  stiffness.diagonal().array() += 1e-6; // what no spring resists
  const Eigen::Matrix<double, 6, 6> compliance = stiffness.inverse();
  return (3.0 * (compliance(0, 0) + compliance(1, 1)) + 2.0 * compliance(0, 1) + compliance(5, 5)) / 8.0;
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

  const Eigen::VectorXd least = Eigen::VectorXd::Constant(count, kLeastCellShare * even);
  const Eigen::VectorXd share = least + notNegative(normalMatrix, normalRight - normalMatrix * least);
  CellShares shares;
  const Tensor made = rows.topRows(kComponents) * share;
  const double scale = kCellYield * meanComplianceInPlane(springs, share, normal);
  shares.share = scale * share.array();
  shares.error = (scale * made - wanted).norm() / wanted.norm();
  return shares;
}

} // namespace esm::support
