// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/geometry/mesh_defects.h"
#include "core/geometry/mesh_report.h"
#include "core/geometry/repair/repair.h"
#include "tests/core/geometry/shapes.h"
#include "tests/core/net/meshes.h"

#include <gmock/gmock.h>

namespace {

using namespace esm;
using namespace esm::test;
using ::testing::SizeIs;

/// A coarse square below a row of n fine ones; they share only the two ends of their common side.
Mesh coarseBelowFine(Index n)
{
  Mesh mesh = grid(n);
  append(mesh, makeMesh({{0, 0, 0}, {1, 0, 0}, {1, -1, 0}, {0, -1, 0}}, {{0, 2, 1}, {0, 3, 2}}));
  const Index first = mesh.vertexCount() - 4; // its corners (0, 0) and (1, 0) are those of the grid
  for (Eigen::Index i = 0; i < mesh.triangles.size(); ++i) {
    Index& v = mesh.triangles.data()[i];
    if (v == first) v = 0;
    if (v == first + 1) v = n * (n + 1);
  }
  return mesh;
}

TEST(TJunctions, verticesOnTheCoarseSideAreFound)
{
  const MeshDefects defects = findDefects(coarseBelowFine(5));
  ASSERT_THAT(defects.tJunctions, SizeIs(4));
  for (int i = 0; i < 4; ++i)
    EXPECT_NEAR(defects.tJunctions[static_cast<std::size_t>(i)].along, 0.2 * (i + 1), 1e-12);
}

// Closing them changes no place and no area, and afterwards the square has one border all round.
TEST(TJunctions, closingJoinsTheSheetsAndKeepsArea)
{
  Mesh mesh = coarseBelowFine(5);
  const double area = areaOf(mesh);
  RepairOptions options;
  options.closeTJunctions = true;
  RepairReport report;
  ASSERT_TRUE(repairMesh(mesh, options, report));
  EXPECT_EQ(report.closedTJunctions, 4);
  EXPECT_NEAR(areaOf(mesh), area, 1e-14);
  const MeshDefects after = findDefects(mesh);
  EXPECT_THAT(after.tJunctions, SizeIs(0));
  EXPECT_THAT(after.boundaryLoops, SizeIs(1));
  EXPECT_THAT(after.degenerateFaces, SizeIs(0));
  EXPECT_EQ(examine(mesh).nonManifoldEdges, 0);
  EXPECT_THAT(after.turnedFaces, SizeIs(0)); // the new triangles look where the old ones did
}

TEST(TJunctions, aTriangleWithVerticesOnAllSidesIsCutWell)
{
  // Each side of the big triangle has two loose vertices, of small triangles outside.
  Mesh mesh = makeMesh({{0, 0, 0},
                        {3, 0, 0},
                        {0, 3, 0},
                        {1, 0, 0},
                        {2, 0, 0},
                        {1.5, -1, 0},
                        {2, 1, 0},
                        {1, 2, 0},
                        {3, 3, 0},
                        {0, 2, 0},
                        {0, 1, 0},
                        {-1, 1.5, 0}},
                       {{0, 1, 2}, {3, 5, 4}, {6, 8, 7}, {9, 11, 10}});
  const double area = areaOf(mesh);
  RepairOptions options;
  options.closeTJunctions = true;
  RepairReport report;
  ASSERT_TRUE(repairMesh(mesh, options, report));
  EXPECT_EQ(report.closedTJunctions, 6);
  EXPECT_NEAR(areaOf(mesh), area, 1e-14);
  EXPECT_EQ(mesh.triangleCount(), 3 + 7); // nine points on the rim make seven triangles
  EXPECT_EQ(examine(mesh).components, 1);
}

TEST(TJunctions, aStrutThatEndsOnASideIsTiedToIt)
{
  Mesh mesh = makeMesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.5, 0, 0}, {0.5, 0, 1}}, {{0, 1, 2}}, {{3, 4}});
  RepairOptions options;
  options.closeTJunctions = true;
  RepairReport report;
  ASSERT_TRUE(repairMesh(mesh, options, report));
  EXPECT_EQ(mesh.triangleCount(), 2);
  EXPECT_EQ(examine(mesh).components, 1);
}

TEST(TJunctions, linesThatMeetInTheMiddleOfALineAreTied)
{
  Mesh mesh = makeMesh({{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {1, 1, 0}}, {}, {{0, 1}, {2, 3}});
  RepairOptions options;
  options.closeTJunctions = true;
  RepairReport report;
  ASSERT_TRUE(repairMesh(mesh, options, report));
  EXPECT_EQ(mesh.segmentCount(), 3);
  EXPECT_EQ(examine(mesh).components, 1);
}

TEST(TJunctions, theToleranceIsKept)
{
  Mesh mesh = coarseBelowFine(2);
  mesh.position(1, 3) = 0.01; // the vertex in the middle of the common side, lifted
  RepairOptions options;
  options.closeTJunctions = true;
  RepairReport report;
  options.tJunctionTolerance = 0.009;
  ASSERT_TRUE(repairMesh(mesh, options, report));
  EXPECT_EQ(report.closedTJunctions, 0);
  options.tJunctionTolerance = 0.011;
  ASSERT_TRUE(repairMesh(mesh, options, report));
  EXPECT_EQ(report.closedTJunctions, 1);
}

} // namespace
