// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/geometry/mesh_defects.h"
#include "core/geometry/mesh_report.h"
#include "core/geometry/repair/remesh.h"
#include "core/geometry/repair/repair.h"
#include "tests/core/geometry/shapes.h"
#include "tests/core/net/meshes.h"

#include <gmock/gmock.h>

namespace {

using namespace esm;
using namespace esm::test;

RepairReport fill(Mesh& mesh, Index edges, double length = 0.0)
{
  RepairOptions options;
  options.fillHolesUpTo = edges;
  options.fillHolesLength = length;
  RepairReport report;
  EXPECT_TRUE(repairMesh(mesh, options, report));
  return report;
}

/// The sphere without the triangles that lie above z = 0.9.
Mesh openSphere(Index n)
{
  const Mesh whole = sphere(n);
  return without(whole, [&](Index t) {
    double z = 0.0;
    for (int k = 0; k < 3; ++k) z += whole.position(2, whole.triangles(k, t)) / 3.0;
    return z > 0.9;
  });
}

// The cap above z = 0.9 has the volume pi h^2 (3 - h) / 3 with h = 0.1, 0.7 % of the sphere; a patch of least
// area over its rim is nearly flat. The sphere of 8 x 20^2 triangles itself lacks 0.5 %.
TEST(FillHoles, anOpenSphereIsClosedWithItsVolume)
{
  Mesh mesh = openSphere(20);
  const RepairReport report = fill(mesh, 100);
  EXPECT_EQ(report.filledHoles, 1);
  EXPECT_EQ(eulerCharacteristic(mesh), 2);
  const MeshDefects defects = findDefects(mesh);
  EXPECT_TRUE(defects.parts[0].isClosed || defects.parts.size() > 1);
  EXPECT_TRUE(defects.turnedFaces.empty());
  EXPECT_TRUE(defects.boundaryLoops.empty());
  EXPECT_EQ(examine(mesh).nonManifoldEdges, 0);
  EXPECT_NEAR(volumeOf(mesh), 4.0 / 3.0 * M_PI, 0.02 * 4.0 / 3.0 * M_PI);
}

// Springs of the patch are as long as those of the rim, and no vertex is a hub.
TEST(FillHoles, thePatchIsAsDenseAsItsRim)
{
  Mesh mesh = openSphere(20);
  const Index old = mesh.triangleCount();
  fill(mesh, 100);
  Mesh patch = without(mesh, [&](Index t) { return t < old; });
  EXPECT_GT(patch.triangleCount(), 100);
  const EdgeLengths lengths = edgeLengths(patch);
  EXPECT_LE(lengths.longest, 5.0 * lengths.shortest);
  std::vector<int> valence(static_cast<std::size_t>(mesh.vertexCount()), 0);
  for (Eigen::Index i = 0; i < mesh.triangles.size(); ++i)
    ++valence[static_cast<std::size_t>(mesh.triangles.data()[i])];
  EXPECT_LE(*std::max_element(valence.begin(), valence.end()), 10);
}

TEST(FillHoles, holesLargerThanWishedStayOpen)
{
  Mesh mesh = tube(12, 3, 2.0);
  EXPECT_EQ(fill(mesh, 11).filledHoles, 0);
  EXPECT_EQ(fill(mesh, 12, 6.0).filledHoles, 0); // the rim is 6.2 long
  EXPECT_EQ(fill(mesh, 12, 6.3).filledHoles, 2);
  EXPECT_EQ(eulerCharacteristic(mesh), 2);
}

TEST(FillHoles, theRimOfATriangleOnItsOwnIsNoHole)
{
  Mesh mesh = makeMesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  EXPECT_EQ(fill(mesh, 10).filledHoles, 0);
  EXPECT_EQ(mesh.triangleCount(), 1);
}

TEST(FillHoles, touchingHolesAreFilledOneByOne)
{
  Mesh mesh = without(grid(4), [](Index t) { return t / 2 == 1 * 4 + 1 || t / 2 == 2 * 4 + 2; });
  EXPECT_EQ(fill(mesh, 4).filledHoles, 2);
  EXPECT_NEAR(areaOf(mesh), 1.0, 1e-12);
  EXPECT_EQ(examine(mesh).nonManifoldEdges, 0);
  EXPECT_EQ(eulerCharacteristic(mesh), 1); // a disk again
}

// Both diagonals of this hole are edges already, at the other side of a thin body: only a new vertex closes
// it.
TEST(FillHoles, noEdgeIsMadeTwice)
{
  Mesh mesh =
    makeMesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}}, {{0, 2, 1}, {0, 3, 2}}, {});
  append(mesh, Mesh{});
  // Hole 0 1 2 3 of the square itself: the diagonal 0-2 is there; 1-3 is not.
  EXPECT_EQ(fill(mesh, 4).filledHoles, 1);
  EXPECT_EQ(examine(mesh).nonManifoldEdges, 0);
  EXPECT_EQ(examine(mesh).boundaryEdges, 0);
}

// 300 edges are more than what is triangulated in one piece.
TEST(FillHoles, aLargeRoundHoleIsFilledFlat)
{
  Mesh mesh = tube(300, 1, 0.02);
  EXPECT_EQ(fill(mesh, 300).filledHoles, 2);
  EXPECT_NEAR(areaOf(mesh), 2.0 * M_PI + 0.02 * 2.0 * M_PI, 0.01);
  EXPECT_EQ(examine(mesh).nonManifoldEdges, 0);
  EXPECT_EQ(eulerCharacteristic(mesh), 2);
}

} // namespace
