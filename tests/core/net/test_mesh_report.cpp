// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/geometry/mesh_report.h"
#include "tests/core/net/meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <set>

namespace {

using namespace esm;
using namespace esm::test;

TEST(MeshReport, closedCubeHasNoDefect)
{
  const Mesh mesh = cube();
  const MeshReport report = examine(mesh);
  EXPECT_EQ(report.nodes, 8);
  EXPECT_EQ(report.springs, 18);
  EXPECT_EQ(report.triangles, 12);
  EXPECT_EQ(report.segments, 0);
  EXPECT_EQ(report.components, 1);
  EXPECT_EQ(report.isolatedVertices, 0);
  EXPECT_EQ(report.boundaryEdges, 0);
  EXPECT_EQ(report.nonManifoldEdges, 0);
  EXPECT_EQ(report.degenerateFaces, 0);
  EXPECT_EQ(report.duplicateFaces, 0);
  EXPECT_EQ(report.boxMin, Eigen::Vector3d::Zero());
  EXPECT_EQ(report.boxMax, Eigen::Vector3d::Ones());
  // Rounding of 18 terms.
  EXPECT_NEAR(sumRestLength(mesh, listEdges(mesh)), 12 + 6 * std::sqrt(2.0), 1e-13);
  EXPECT_TRUE(report.finite);
}

TEST(MeshReport, moebiusStripHasOneBorderAlthoughItCannotBeOriented)
{
  // Five triangles in a ring: t = (i, i+1, i+2) mod 5, the smallest Moebius strip.
  std::vector<std::array<double, 3>> vertices;
  for (int i = 0; i < 5; ++i) vertices.push_back({std::cos(1.2 * i), std::sin(1.2 * i), 0.1 * i * i});
  std::vector<std::array<Index, 3>> triangles;
  for (Index i = 0; i < 5; ++i) triangles.push_back({i, (i + 1) % 5, (i + 2) % 5});
  const MeshReport report = examine(makeMesh(vertices, triangles));
  EXPECT_EQ(report.springs, 10);      // each of the five vertices with each other
  EXPECT_EQ(report.boundaryEdges, 5); // the edges (i, i+2); (i, i+1) lie between two triangles
  EXPECT_EQ(report.nonManifoldEdges, 0);
}

TEST(MeshReport, threePagesOfABookMeetInOneNonManifoldEdge)
{
  const MeshReport report = examine(
    makeMesh({{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}}, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}));
  EXPECT_EQ(report.nonManifoldEdges, 1);
  EXPECT_EQ(report.boundaryEdges, 6);
  EXPECT_EQ(report.springs, 7);
}

TEST(MeshReport, aFaceAgainInAnyOrderIsADuplicate)
{
  const MeshReport report = examine(
    makeMesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2}, {2, 1, 0}, {1, 2, 0}, {0, 1, 3}}));
  EXPECT_EQ(report.duplicateFaces, 2);
  EXPECT_EQ(report.springs, 5);
  EXPECT_EQ(report.nonManifoldEdges, 3); // 0-1 is used by four triangles, 1-2 and 2-0 by three
}

TEST(MeshReport, degenerateFacesAreCountedButANeedleIsNone)
{
  const Mesh mesh = makeMesh(
    {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0.1, 0.2, 0.3}, {0.2, 0.4, 0.6}, {0.3, 0.6, 0.9}, {1, 1e-9, 0}},
    {{0, 1, 2}, {3, 4, 5}, {0, 0, 1}, {0, 2, 6}});
  const MeshReport report = examine(mesh);
  EXPECT_EQ(report.degenerateFaces, 3); // on a line, on a line up to rounding, two equal corners
  EXPECT_EQ(report.triangles, 4);
}

TEST(MeshReport, aTriangleThatUsesAnEdgeTwiceIsStillOneTriangle)
{
  const MeshReport report = examine(makeMesh({{0, 0, 0}, {1, 0, 0}}, {{0, 0, 1}}));
  EXPECT_EQ(report.springs, 1);
  EXPECT_EQ(report.boundaryEdges, 1);
}

TEST(MeshReport, segmentsAreSpringsOnceAndConnect)
{
  const MeshReport report =
    examine(makeMesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 0, 0}, {6, 0, 0}, {9, 9, 9}}, {{0, 1, 2}},
                     {{1, 0}, {3, 4}, {4, 3}, {3, 3}}));
  EXPECT_EQ(report.springs, 4); // 1-0 is an edge of the triangle, 4-3 comes twice, 3-3 has no length
  EXPECT_EQ(report.segments, 4);
  EXPECT_EQ(report.components, 2);
  EXPECT_EQ(report.isolatedVertices, 1);
  EXPECT_EQ(report.boundaryEdges, 3); // lines are no borders
}

TEST(MeshReport, nonFiniteVerticesAreCountedAndKeptOutOfSums)
{
  const Mesh mesh = makeMesh({{0, 0, 0}, {3, 4, 0}, {kNaN, 0, 0}, {0, kInfinity, 7}}, {{0, 1, 2}}, {{0, 3}});
  const MeshReport report = examine(mesh);
  EXPECT_EQ(report.nonFiniteVertices, 2);
  EXPECT_FALSE(report.finite);
  EXPECT_EQ(sumRestLength(mesh, listEdges(mesh)), 5);
  EXPECT_EQ(report.boxMax, Eigen::Vector3d(3, 4, 0));
}

TEST(MeshReport, aHubWithManySpokesIsFoundLikeAFewEdges)
{
  // One bucket holds all spokes, each of them twice: more than plain search would like.
  constexpr Index kRim = 5000;
  std::vector<std::array<double, 3>> vertices{{0, 0, 0}};
  std::vector<std::array<Index, 3>> triangles;
  for (Index i = 0; i < kRim; ++i) {
    vertices.push_back({std::cos(0.001 * i), std::sin(0.001 * i), 1});
    triangles.push_back({0, i + 1, (i + 1) % kRim + 1});
  }
  const MeshReport report = examine(makeMesh(vertices, triangles));
  EXPECT_EQ(report.springs, 2 * kRim);
  EXPECT_EQ(report.boundaryEdges, kRim);
}

/// Triangles over few vertices, so that they meet, repeat and degenerate.
Mesh crowd(std::mt19937& random, int triangles)
{
  Mesh mesh;
  mesh.position = Eigen::Matrix3Xd::Random(3, 9);
  mesh.triangles.resize(3, triangles);
  for (Index& vertex : mesh.triangles.reshaped()) vertex = static_cast<Index>(random() % 9);
  return mesh;
}

TEST(MeshReport, repeatedAndUnusedAreWhatACountByHandFinds)
{
  std::mt19937 random(7);
  for (int round = 0; round < 2000; ++round) {
    const Mesh mesh = crowd(random, 1 + round % 12);
    std::set<std::array<Index, 3>> known;
    std::set<Index> used;
    std::vector<Index> repeated;
    for (Index t = 0; t < mesh.triangleCount(); ++t) {
      std::array<Index, 3> corners{mesh.triangles(0, t), mesh.triangles(1, t), mesh.triangles(2, t)};
      std::sort(corners.begin(), corners.end());
      if (!known.insert(corners).second) repeated.push_back(t);
      if (corners[0] != corners[2]) used.insert(corners.begin(), corners.end());
    }
    const EdgeTable edges = findEdges(mesh);
    EXPECT_EQ(edges.repeated, repeated);
    EXPECT_EQ(examine(mesh, edges).isolatedVertices, 9 - static_cast<Index>(used.size()));
  }
}

// More users than the count of an edge can hold, and more edges up from a vertex than its bucket has room
// for.
TEST(MeshReport, aBookOfManyPagesKeepsItsSpine)
{
  constexpr Index kPages = 600;
  std::vector<std::array<double, 3>> vertices{{0, 0, 0}, {0, 0, 1}};
  std::vector<std::array<Index, 3>> triangles;
  for (Index i = 0; i < kPages; ++i) {
    vertices.push_back({std::cos(0.01 * i), std::sin(0.01 * i), 0});
    triangles.push_back({1, 0, i + 2});
  }
  triangles.push_back({kPages, 0, 1}); // the page before the last once more
  const Mesh mesh = makeMesh(vertices, triangles);
  const EdgeTable edges = findEdges(mesh);
  EXPECT_EQ(edges.ends.cols(), 1 + 2 * kPages);
  EXPECT_EQ(edges.triangleCount[0], EdgeList::kMany);
  EXPECT_EQ((edges.triangleCount == 1).count(), 2 * (kPages - 1));
  EXPECT_EQ(edges.repeated, std::vector<Index>{kPages});
  EXPECT_EQ(edges.edgeOfSide[3 * kPages],
            edges.edgeOfSide[3 * (kPages - 2) + 1]); // from 0 to the page's corner
  EXPECT_EQ(listEdges(mesh).ends, edges.ends);
}

TEST(MeshReport, anEmptyMeshHasZeroOfEverything)
{
  const MeshReport report = examine(Mesh{});
  EXPECT_EQ(report.nodes, 0);
  EXPECT_EQ(report.springs, 0);
  EXPECT_EQ(report.boxMin, Eigen::Vector3d::Zero());
}

} // namespace
