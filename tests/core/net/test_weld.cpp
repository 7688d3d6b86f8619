// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/geometry/mesh_report.h"
#include "core/geometry/weld.h"
#include "tests/core/net/meshes.h"

#include <gmock/gmock.h>

#include <random>

namespace {

using namespace esm;
using namespace esm::test;
using ::testing::ElementsAre;

/// Each triangle with corners of its own, as an STL stores it.
Mesh unwelded(const Mesh& mesh)
{
  Mesh loose;
  loose.position.resize(3, 3 * mesh.triangleCount());
  loose.triangles.resize(3, mesh.triangleCount());
  for (Index i = 0; i < 3 * mesh.triangleCount(); ++i) {
    loose.position.col(i) = mesh.position.col(mesh.triangles(i % 3, i / 3));
    loose.triangles(i % 3, i / 3) = i;
  }
  return loose;
}

TEST(Weld, mapLeadsFromOldToNewAndKeepsTheOrderOfFirstAppearance)
{
  Mesh mesh =
    makeMesh({{5, 0, 0}, {1, 0, 0}, {5, 0, 0}, {2, 0, 0}, {1, 0, 0}}, {{0, 1, 3}, {2, 3, 4}}, {{2, 4}});
  const std::vector<Index> newOf = weldVertices(mesh);
  EXPECT_THAT(newOf, ElementsAre(0, 1, 0, 2, 1));
  ASSERT_EQ(mesh.vertexCount(), 3);
  EXPECT_EQ(mesh.position.col(0).x(), 5);
  EXPECT_EQ(mesh.position.col(1).x(), 1);
  EXPECT_EQ(mesh.position.col(2).x(), 2);
  EXPECT_EQ(mesh.triangles.col(1), (Eigen::Matrix<Index, 3, 1>(0, 2, 1)));
  EXPECT_EQ(mesh.segments.col(0), (Eigen::Matrix<Index, 2, 1>(0, 1)));
}

TEST(Weld, minusZeroEqualsZeroAndTheNextNumberDoesNot)
{
  const double next = std::nextafter(1.0, 2.0);
  Mesh mesh = makeMesh({{0.0, 1, -0.0}, {-0.0, 1, 0.0}, {0.0, next, 0.0}}, {{0, 1, 2}});
  EXPECT_THAT(weldVertices(mesh), ElementsAre(0, 0, 1));
}

TEST(Weld, nonFiniteVerticesJoinNothing)
{
  for (const double tolerance : {0.0, 10.0}) {
    Mesh mesh =
      makeMesh({{kNaN, 0, 0}, {kNaN, 0, 0}, {kInfinity, 0, 0}, {kInfinity, 0, 0}, {0, 0, 0}}, {{0, 1, 4}});
    EXPECT_THAT(weldVertices(mesh, tolerance), ElementsAre(0, 1, 2, 3, 4));
  }
}

TEST(Weld, looseCubeBecomesTheCube)
{
  Mesh mesh = unwelded(cube());
  weldVertices(mesh);
  const MeshReport report = examine(mesh);
  EXPECT_EQ(report.nodes, 8);
  EXPECT_EQ(report.springs, 18);
  EXPECT_EQ(report.boundaryEdges, 0);
}

TEST(Weld, aVertexJoinsTheFirstKeptOneWithinTheToleranceNotTheNearest)
{
  // 0.9 lies within 1 of both 0 and 1.1; 0 came first. 2.5 is within reach of none that was kept.
  Mesh mesh = makeMesh({{0, 0, 0}, {1.1, 0, 0}, {0.9, 0, 0}, {2.5, 0, 0}}, {{0, 1, 3}});
  EXPECT_THAT(weldVertices(mesh, 1.0), ElementsAre(0, 1, 0, 2));
}

TEST(Weld, theToleranceIsADistanceNotABox)
{
  Mesh mesh = makeMesh({{0, 0, 0}, {0.8, 0.8, 0}, {0.7, 0.7, 0}}, {{0, 1, 2}});
  EXPECT_THAT(weldVertices(mesh, 1.0), ElementsAre(0, 1, 0)); // 1.13 apart, 0.99 apart
}

TEST(Weld, toleranceWeldEqualsTheDefinitionTriedPairByPair)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(-3.0, 3.0);
  for (const double tolerance : {1e-3, 0.3, 1.0, 50.0}) {
    std::vector<std::array<double, 3>> points(400);
    for (auto& point : points)
      for (double& x : point) x = std::round(coordinate(random) * 10) / 10; // many at cell borders
    Mesh mesh = makeMesh(points, {});
    std::vector<Index> kept, expected;
    for (Index i = 0; i < mesh.vertexCount(); ++i) {
      const auto near = std::find_if(kept.begin(), kept.end(), [&](Index k) {
        return (mesh.position.col(k) - mesh.position.col(i)).norm() <= tolerance;
      });
      expected.push_back(static_cast<Index>(near - kept.begin()));
      if (near == kept.end()) kept.push_back(i);
    }
    EXPECT_EQ(weldVertices(mesh, tolerance), expected) << tolerance;
  }
}

TEST(Weld, absurdTolerancesJoinAllOrOnlyEqualOnes)
{
  for (const double huge : {1e300, kInfinity}) {
    Mesh mesh = makeMesh({{0, 0, 0}, {1, 0, 0}, {-1e10, 2, 0}}, {{0, 1, 2}});
    EXPECT_THAT(weldVertices(mesh, huge), ElementsAre(0, 0, 0));
  }
  for (const double none : {-1.0, kNaN, 1e-320}) {
    Mesh mesh = makeMesh({{0, 0, 0}, {1, 0, 0}, {1, 0, 0}}, {{0, 1, 2}});
    EXPECT_THAT(weldVertices(mesh, none), ElementsAre(0, 1, 1));
  }
}

TEST(Weld, anEmptyMeshStaysEmpty)
{
  Mesh mesh;
  EXPECT_TRUE(weldVertices(mesh).empty());
  EXPECT_EQ(mesh.vertexCount(), 0);
}

} // namespace
