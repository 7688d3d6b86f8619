// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/tissue/tissue_model.h"
#include "tests/core/tissue/test_nets.h"

#include <cmath>

namespace esm {
namespace {

constexpr double kWidth = 0.04, kStrain = 0.01;
const double kHeight = kWidth * std::sqrt(3.0) / 2.0;

/// A flat sheet of n x n cells, every other row moved by half a cell, so that inner triangles are
/// equilateral; the sides are closed by half triangles.
Mesh equilateralSheet(int n)
{
  std::vector<Eigen::Vector3d> points;
  std::vector<std::array<Index, 3>> faces;
  std::vector<Index> rowStart;
  for (int row = 0; row <= n; ++row) {
    rowStart.push_back(static_cast<Index>(points.size()));
    const double y = kHeight * row / n, cell = kWidth / n;
    if (row % 2 == 1) points.emplace_back(0.0, y, 0.0);
    for (int i = 0; i < n + (row % 2 == 0 ? 1 : 0); ++i)
      points.emplace_back((i + 0.5 * (row % 2)) * cell, y, 0.0);
    if (row % 2 == 1) points.emplace_back(kWidth, y, 0.0);
  }
  for (int row = 0; row < n; ++row) {
    // The even row has n + 1 points, the odd one n + 2: a triangle stands on each piece of either.
    const Index even = rowStart[static_cast<std::size_t>(row + row % 2)];
    const Index odd = rowStart[static_cast<std::size_t>(row + 1 - row % 2)];
    for (Index i = 0; i < n; ++i) faces.push_back({even + i, even + i + 1, odd + i + 1});
    for (Index i = 0; i <= n; ++i) faces.push_back({odd + i, odd + i + 1, even + i});
  }
  return test::meshOf(points, faces);
}

/// n x n rectangles, each halved by a diagonal.
Mesh rectangularSheet(int n)
{
  std::vector<Eigen::Vector3d> points;
  std::vector<std::array<Index, 3>> faces;
  for (int row = 0; row <= n; ++row)
    for (int i = 0; i <= n; ++i) points.emplace_back(kWidth * i / n, kHeight * row / n, 0.0);
  for (Index row = 0; row < n; ++row)
    for (Index i = 0; i < n; ++i) {
      const Index a = row * (n + 1) + i, b = a + 1, c = a + n + 1, d = c + 1;
      faces.push_back({a, b, d});
      faces.push_back({a, d, c});
    }
  return test::meshOf(points, faces);
}

/// Force at the upper border when it is moved up by kStrain and may slide sideways, in units of E h w e.
double relativeForce(const Mesh& mesh)
{
  TissueModel model = defaultTissue();
  SpringNet net = test::netOf(mesh);
  EXPECT_TRUE(applyTissue(model, net));
  net.anchors = {};
  const Eigen::SparseMatrix<double> stiffness = test::stiffnessMatrix(net);

  const Index nodes = net.nodeCount();
  Eigen::VectorXd moved = Eigen::VectorXd::Zero(3 * nodes);
  std::vector<int> place(static_cast<std::size_t>(3 * nodes), -1); // of the free degrees of freedom
  int free = 0;
  for (Index i = 0; i < nodes; ++i) {
    const double y = net.restPosition(1, i);
    const bool top = y > kHeight * (1 - 1e-9), bottom = y < kHeight * 1e-9;
    if (top) moved[3 * i + 1] = kStrain * kHeight;
    if (i > 0) place[static_cast<std::size_t>(3 * i)] = free++; // node 0 holds the sheet sideways
    if (!top && !bottom) place[static_cast<std::size_t>(3 * i + 1)] = free++;
  }
  std::vector<Eigen::Triplet<double>> entries;
  for (int column = 0; column < stiffness.outerSize(); ++column)
    for (Eigen::SparseMatrix<double>::InnerIterator it(stiffness, column); it; ++it) {
      const int row = place[static_cast<std::size_t>(it.row())],
                col = place[static_cast<std::size_t>(column)];
      if (row >= 0 && col >= 0) entries.emplace_back(row, col, it.value());
    }
  Eigen::SparseMatrix<double> reduced(free, free);
  reduced.setFromTriplets(entries.begin(), entries.end());
  const Eigen::VectorXd load = -(stiffness * moved);
  Eigen::VectorXd right(free);
  for (std::size_t k = 0; k < place.size(); ++k)
    if (place[k] >= 0) right[place[k]] = load[static_cast<Eigen::Index>(k)];
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(reduced);
  EXPECT_EQ(solver.info(), Eigen::Success);
  const Eigen::VectorXd solution = solver.solve(right);
  for (std::size_t k = 0; k < place.size(); ++k)
    if (place[k] >= 0) moved[static_cast<Eigen::Index>(k)] = solution[place[k]];

  const Eigen::VectorXd force = stiffness * moved;
  double total = 0.0;
  for (Index i = 0; i < nodes; ++i)
    if (net.restPosition(1, i) > kHeight * (1 - 1e-9)) total += force[3 * i + 1];
  const double modulus = TissueField::create(model)->base().youngsModulus;
  return total / (modulus * model.thickness * kWidth * kStrain);
}

// Van Gelder's springs on equilateral triangles are an isotropic sheet of Young's modulus E (and Poisson
// ratio 1/3), so the force is E h w e. The half triangles at both sides are too stiff by a share of one
// cell of width, together measured 0.190 of it: 0.2 / n.
TEST(SheetStiffness, OfEquilateralTrianglesIsYoungsModulus)
{
  for (const int n : {8, 16, 32}) EXPECT_NEAR(relativeForce(equilateralSheet(n)), 1.0, 0.2 / n) << n;
}

// Right triangles are not isotropic, but as soft in a fine mesh as in a coarse one; and a sheet that
// may shear freely along its diagonals still answers with E h w e.
TEST(SheetStiffness, OfRightTrianglesDoesNotDependOnTheMesh)
{
  const double coarse = relativeForce(rectangularSheet(8));
  EXPECT_NEAR(relativeForce(rectangularSheet(16)) / coarse, 1.0, 0.03);
  EXPECT_NEAR(relativeForce(rectangularSheet(32)) / coarse, 1.0, 0.03);
  EXPECT_NEAR(coarse, 1.0, 0.25);
}

} // namespace
} // namespace esm
