// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/contact/press_area.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <functional>

namespace esm {

namespace {

constexpr double kPressed = 0.006;

/// A square sheet of 6 x 6 cm about the origin, its corners lifted by `height`.
Mesh sheetOf(double edge, const std::function<double(double, double)>& height)
{
  const auto side = static_cast<Index>(std::lround(0.06 / edge)) + 1;
  Mesh mesh;
  mesh.position.resize(3, side * side);
  mesh.triangles.resize(3, 2 * (side - 1) * (side - 1));
  Index triangle = 0;
  for (Index i = 0; i < side * side; ++i) {
    const Index column = i % side, row = i / side;
    const double x = edge * column - 0.03, y = edge * row - 0.03;
    mesh.position.col(i) = Eigen::Vector3d(x, y, height(x, y));
    if (column + 1 == side || row + 1 == side) continue;
    mesh.triangles.col(triangle++) << i, i + 1, i + side + 1;
    mesh.triangles.col(triangle++) << i, i + side + 1, i + side;
  }
  return mesh;
}

double flat(double, double)
{
  return 0.0;
}

/// A dome of 2 cm.
double dome(double x, double y)
{
  return std::sqrt(0.02 * 0.02 - std::min(0.00035, x * x + y * y));
}

struct Found {
  PressedArea area;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  double square = 0.0; ///< mean square distance from the point, across the normal [m^2]
};

Found foundAt(const Mesh& mesh, const Eigen::Vector3d& place,
              const Eigen::Vector3d& normal = Eigen::Vector3d::UnitZ())
{
  PressAreaFinder finder(mesh.triangles, mesh.position, findEdges(mesh), kPressed);
  const DeformingSurface surface(mesh.triangles, mesh.position);
  const auto hit = surface.nearest(place);
  EXPECT_TRUE(hit);
  Found found;
  finder.find(*hit, normal, found.area);
  const NodeCombination& nodes = found.area.nodes;
  const Eigen::Vector3d at = surface.pointAt(*hit);
  double sum = 0.0;
  for (std::size_t i = 0; i < nodes.node.size(); ++i) {
    EXPECT_GE(nodes.weight[i], 0.0);
    sum += nodes.weight[i];
    const Eigen::Vector3d node = mesh.position.col(nodes.node[i]);
    found.mean += nodes.weight[i] * node;
    found.square += nodes.weight[i] * (node - at).cross(normal).squaredNorm();
  }
  EXPECT_NEAR(sum, 1.0, 1e-12);
  // Pressed as if at the point itself: nothing is turned.
  EXPECT_LT((found.mean - at).cross(normal).norm(), 1e-9);
  EXPECT_NEAR(found.area.rise, normal.dot(at - found.mean), 1e-9);
  return found;
}

} // namespace

// Hertz's pressure has its mean square at 0.4 of the radius squared. What the triangles add is taken off, as far as
// it can be; on edges of 4 mm the nodes that share it lie up to a sixth off.
TEST(PressArea, IsAsWideOnEveryMesh)
{
  for (const Eigen::Vector3d& place : {Eigen::Vector3d(0.0, 0.0, 0.0), Eigen::Vector3d(0.0013, 0.0021, 0.0)})
    for (const auto& [edge, tolerance] :
         {std::pair(0.004, 0.16), std::pair(0.002, 0.03), std::pair(0.001, 0.01)})
      EXPECT_NEAR(foundAt(sheetOf(edge, flat), place).square / (0.4 * kPressed * kPressed), 1.0, tolerance)
        << edge;
}

// Of a load that is smooth, each node on a fine mesh takes its part by its cell.
TEST(PressArea, SharesTheForceSmoothly)
{
  constexpr double kEdge = 0.001;
  const Mesh mesh = sheetOf(kEdge, flat);
  const Found found = foundAt(mesh, {0.0003, 0.0004, 0.0});
  const NodeCombination& nodes = found.area.nodes;
  for (std::size_t i = 0; i < nodes.node.size(); ++i) {
    const double away =
      (mesh.position.col(nodes.node[i]) - Eigen::Vector3d(0.0003, 0.0004, 0.0)).norm() / kPressed;
    if (away > 0.7) continue;
    const double hertz =
      1.5 * std::sqrt(1.0 - away * away) / (3.14159265 * kPressed * kPressed) * kEdge * kEdge;
    EXPECT_NEAR(nodes.weight[i] / hertz, 1.0, 0.08) << away; // 0.03 of it by the narrower radius
  }
}

// Where the mesh is coarser, the ball presses on a point of a triangle, as its corners share it.
TEST(PressArea, OnLargeTrianglesItIsAPoint)
{
  const Mesh mesh = sheetOf(0.03, flat);
  const Eigen::Vector3d place(0.012, 0.007, 0.0);
  const DeformingSurface surface(mesh.triangles, mesh.position);
  const SurfacePoint point = *surface.nearest(place);
  const Found found = foundAt(mesh, place);
  ASSERT_EQ(found.area.nodes.node.size(), 3u);
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(found.area.nodes.node[static_cast<std::size_t>(k)], mesh.triangles(k, point.triangle));
    EXPECT_NEAR(found.area.nodes.weight[static_cast<std::size_t>(k)], point.weight[k], 1e-8);
  }
}

// Curved surfaces too, and at the rim, where there is tissue on one side only, the area shrinks from both.
TEST(PressArea, ItsMeanIsUnderThePointWhereverThatIs)
{
  for (const double edge : {0.004, 0.0015}) {
    const Mesh curved = sheetOf(edge, dome);
    EXPECT_GT(foundAt(curved, {0.0, 0.0, 0.02}).area.rise, 1e-4);
    const Eigen::Vector3d aside(0.009, 0.004, dome(0.009, 0.004));
    foundAt(curved, aside, aside.normalized());
    const Mesh even = sheetOf(edge, flat);
    double last = 0.0;
    for (const double fromRim : {0.0, 0.001, 0.003, 0.008}) {
      const double square = foundAt(even, {0.03 - fromRim, 0.001, 0.0}).square;
      EXPECT_GE(square, last);
      last = square;
    }
  }
}

// What faces another way, or is farther down than the radius, is not pressed: the foot of a cliff is not, but for
// the nodes of the triangles that reach down to it.
TEST(PressArea, StopsWhereTheSurfaceTurnsAway)
{
  const Mesh cliff = sheetOf(0.001, [](double x, double) { return x > 0.0025 ? -0.02 : 0.0; });
  for (const Index node : foundAt(cliff, {0.0, 0.0, 0.0}).area.nodes.node)
    EXPECT_LT(cliff.position(0, node), 0.0035);
  Mesh fold = sheetOf(0.001, flat); // the outer part is turned over and lies under the rest
  for (Index i = 0; i < fold.position.cols(); ++i)
    if (fold.position(0, i) > 0.0025)
      fold.position.col(i) = Eigen::Vector3d(0.005 - fold.position(0, i), fold.position(1, i), -0.0005);
  for (const Index node : foundAt(fold, {0.0, 0.0, 0.0}).area.nodes.node)
    EXPECT_EQ(fold.position(2, node), 0.0);
}

// Sliding over edges and nodes changes the shares no more than the way.
TEST(PressArea, ChangesAsThePointSlides)
{
  for (const double edge : {0.005, 0.002}) {
    const Mesh mesh = sheetOf(edge, dome);
    const DeformingSurface surface(mesh.triangles, mesh.position);
    PressAreaFinder finder(mesh.triangles, mesh.position, findEdges(mesh), kPressed);
    constexpr double kStep = 2e-5;
    Eigen::VectorXd last;
    for (int i = 0; i < 300; ++i) {
      const double x = -0.003 + kStep * i, y = 0.0013 + 0.3 * kStep * i;
      const SurfacePoint point = *surface.nearest({x, y, dome(x, y)});
      PressedArea area;
      finder.find(point, Eigen::Vector3d(x, y, dome(x, y)).normalized(), area);
      Eigen::VectorXd now = Eigen::VectorXd::Zero(mesh.position.cols());
      for (std::size_t k = 0; k < area.nodes.node.size(); ++k)
        now[area.nodes.node[k]] += area.nodes.weight[k];
      if (i > 0) {
        EXPECT_LT((now - last).cwiseAbs().sum(), 6.0 * kStep / edge) << edge << " at " << i;
      }
      last = now;
    }
  }
}

} // namespace esm
