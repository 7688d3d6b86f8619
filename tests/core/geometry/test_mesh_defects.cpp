// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/geometry/mesh_defects.h"
#include "core/geometry/mesh_report.h"
#include "tests/core/geometry/shapes.h"
#include "tests/core/net/meshes.h"

#include <gmock/gmock.h>

namespace {

using namespace esm;
using namespace esm::test;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using ::testing::UnorderedElementsAre;

TEST(MeshDefects, aClosedCubeHasNone)
{
  const MeshDefects defects = findDefects(cube());
  ASSERT_THAT(defects.parts, SizeIs(1));
  EXPECT_TRUE(defects.parts[0].isClosed);
  EXPECT_FALSE(defects.parts[0].isInsideOut);
  EXPECT_NEAR(defects.parts[0].volume, 1.0, 1e-14); // rounding of twelve products
  EXPECT_EQ(defects.parts[0].boxMax, Eigen::Vector3d::Ones());
  EXPECT_THAT(defects.boundaryLoops, IsEmpty());
  EXPECT_THAT(defects.nonManifoldVertices, IsEmpty());
  EXPECT_THAT(defects.degenerateFaces, IsEmpty());
  EXPECT_THAT(defects.turnedFaces, IsEmpty());
  EXPECT_THAT(defects.tJunctions, IsEmpty());
}

TEST(MeshDefects, aTubeHasTwoRims)
{
  const MeshDefects defects = findDefects(tube(12, 3, 2.0));
  ASSERT_THAT(defects.boundaryLoops, SizeIs(2));
  for (const BoundaryLoop& loop : defects.boundaryLoops) {
    EXPECT_TRUE(loop.isClosed);
    EXPECT_THAT(loop.vertices, SizeIs(12));
    EXPECT_NEAR(loop.length, 24.0 * std::sin(M_PI / 12.0), 1e-13); // twelve chords of the unit circle
  }
  EXPECT_FALSE(defects.parts[0].isClosed);
}

TEST(MeshDefects, twoHolesThatTouchAreTwoLoops)
{
  // Two squares of a grid, diagonal to each other, are missing: their rims share a vertex.
  const Mesh mesh = without(grid(4), [](Index t) { return t / 2 == 1 * 4 + 1 || t / 2 == 2 * 4 + 2; });
  const MeshDefects defects = findDefects(mesh);
  std::vector<Index> sizes;
  for (const BoundaryLoop& loop : defects.boundaryLoops) sizes.push_back(loop.edges());
  EXPECT_THAT(sizes, UnorderedElementsAre(4, 4, 16));
  EXPECT_THAT(defects.nonManifoldVertices, ElementsAre(2 * 5 + 2));
}

TEST(MeshDefects, turnedFacesAndInsideOutPartsAreNamed)
{
  Mesh mesh = cube();
  std::swap(mesh.triangles(0, 5), mesh.triangles(1, 5));
  Mesh other = cube();
  other.triangles.row(0).swap(other.triangles.row(1));
  append(mesh, other, {3, 0, 0});
  const MeshDefects defects = findDefects(mesh);
  EXPECT_THAT(defects.turnedFaces, ElementsAre(5));
  ASSERT_THAT(defects.parts, SizeIs(2));
  EXPECT_FALSE(defects.parts[0].isInsideOut);
  EXPECT_TRUE(defects.parts[1].isInsideOut);
  EXPECT_NEAR(defects.parts[1].volume, -1.0, 1e-14);
}

TEST(MeshDefects, twoConesTipToTipMeetInANonManifoldVertex)
{
  Mesh mesh = makeMesh({{0, 0, 0}, {1, 0, 1}, {-1, 1, 1}, {-1, -1, 1}, {1, 0, -1}, {-1, 1, -1}, {-1, -1, -1}},
                       {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {0, 4, 5}, {0, 5, 6}, {0, 6, 4}});
  EXPECT_THAT(findDefects(mesh).nonManifoldVertices, ElementsAre(0));
}

TEST(MeshDefects, aMoebiusStripCannotBeOriented)
{
  std::vector<std::array<double, 3>> vertices;
  for (int i = 0; i < 5; ++i) vertices.push_back({std::cos(1.2 * i), std::sin(1.2 * i), 0.1 * i * i});
  std::vector<std::array<Index, 3>> triangles;
  for (Index i = 0; i < 5; ++i) triangles.push_back({i, (i + 1) % 5, (i + 2) % 5});
  const MeshDefects defects = findDefects(makeMesh(vertices, triangles));
  EXPECT_EQ(defects.unorientableEdges.cols(), 1);
  EXPECT_THAT(defects.boundaryLoops, SizeIs(1)); // its one border
}

TEST(MeshDefects, brokenFacesAndVerticesAreNamed)
{
  const Mesh mesh = makeMesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {kNaN, 0, 0}, {2, 0, 0}, {9, 9, 9}},
                             {{0, 1, 2}, {0, 1, 3}, {2, 1, 0}, {0, 1, 4}, {1, 1, 2}});
  const MeshDefects defects = findDefects(mesh);
  EXPECT_THAT(defects.duplicateFaces, ElementsAre(2));
  EXPECT_THAT(defects.degenerateFaces, ElementsAre(3, 4)); // on a line; two equal corners
  EXPECT_THAT(defects.facesOnNonFinite, ElementsAre(1));
  EXPECT_THAT(defects.nonFiniteVertices, ElementsAre(3));
  EXPECT_THAT(defects.isolatedVertices, ElementsAre(5));
}

// The lists are the counts of the report, on meshes of random triangles with everything wrong.
TEST(MeshDefects, listsAgreeWithTheReport)
{
  std::mt19937_64 random(3);
  for (int round = 0; round < 60; ++round) {
    Mesh mesh;
    const Index vertices = 4 + static_cast<Index>(random() % 20),
                triangles = static_cast<Index>(random() % 40);
    mesh.position.resize(3, vertices);
    for (Eigen::Index i = 0; i < mesh.position.size(); ++i)
      mesh.position.data()[i] = random() % 40 == 0 ? kNaN : std::floor(4 * uniform(random));
    mesh.triangles.resize(3, triangles);
    for (Eigen::Index i = 0; i < mesh.triangles.size(); ++i)
      mesh.triangles.data()[i] = static_cast<Index>(random() % static_cast<unsigned>(vertices));
    mesh.segments.resize(2, 3);
    for (Eigen::Index i = 0; i < mesh.segments.size(); ++i)
      mesh.segments.data()[i] = static_cast<Index>(random() % static_cast<unsigned>(vertices));
    const MeshReport report = examine(mesh);
    const MeshDefects defects = findDefects(mesh);
    EXPECT_EQ(report.components, static_cast<Index>(defects.parts.size()));
    EXPECT_EQ(report.isolatedVertices, static_cast<Index>(defects.isolatedVertices.size()));
    EXPECT_EQ(report.nonManifoldEdges, static_cast<Index>(defects.nonManifoldEdges.cols()));
    EXPECT_EQ(report.degenerateFaces, static_cast<Index>(defects.degenerateFaces.size()));
    EXPECT_EQ(report.duplicateFaces, static_cast<Index>(defects.duplicateFaces.size()));
    EXPECT_EQ(report.nonFiniteVertices, static_cast<Index>(defects.nonFiniteVertices.size()));
    Index border = 0;
    for (const BoundaryLoop& loop : defects.boundaryLoops) border += loop.edges();
    EXPECT_EQ(report.boundaryEdges, border);
  }
}

} // namespace
