// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/geometry/mesh_defects.h"
#include "core/geometry/mesh_report.h"
#include "core/geometry/repair/remesh.h"
#include "core/geometry/repair/repair.h"
#include "core/geometry/weld.h"
#include "tests/core/geometry/shapes.h"
#include "tests/core/net/meshes.h"

#include <gmock/gmock.h>

namespace {

using namespace esm;
using namespace esm::test;

RepairReport remesh(Mesh& mesh, Index triangles, double edgeLength = 0.0)
{
  RepairOptions options;
  options.triangles = triangles;
  options.edgeLength = edgeLength;
  RepairReport report;
  const Status status = repairMesh(mesh, options, report);
  EXPECT_TRUE(status) << (status ? "" : status.error().detail);
  return report;
}

void expectGoodNet(const Mesh& mesh)
{
  const EdgeLengths lengths = edgeLengths(mesh);
  EXPECT_GT(lengths.shortest, 0.0);
  EXPECT_LE(lengths.longest, 5.0 * lengths.shortest);
  const MeshReport report = examine(mesh);
  EXPECT_EQ(report.nonManifoldEdges, 0);
  EXPECT_EQ(report.degenerateFaces, 0);
  EXPECT_EQ(report.duplicateFaces, 0);
  EXPECT_TRUE(findDefects(mesh).turnedFaces.empty());
}

// New vertices lie on the old triangles, which lie up to h^2 / 8 under the sphere; those of the net do the
// same with its own edges.
TEST(Remesh, aSphereKeepsItsRadius)
{
  Mesh mesh = sphere(40); // 12,800 triangles, edges up to 0.06
  const RepairReport report = remesh(mesh, 1000);
  EXPECT_LE(mesh.triangleCount(), 1000);
  EXPECT_GE(mesh.triangleCount(), 900);
  EXPECT_EQ(report.remeshedTo, mesh.triangleCount());
  for (Index v = 0; v < mesh.vertexCount(); ++v) EXPECT_NEAR(mesh.position.col(v).norm(), 1.0, 0.0006);
  EXPECT_EQ(eulerCharacteristic(mesh), 2);
  EXPECT_NEAR(volumeOf(mesh), 4.0 / 3.0 * M_PI, 0.02 * 4.0);
  expectGoodNet(mesh);
}

TEST(Remesh, aTorusKeepsItsHole)
{
  Mesh mesh = torus(120, 60);
  const double volume = volumeOf(mesh);
  remesh(mesh, 1500);
  EXPECT_EQ(eulerCharacteristic(mesh), 0);
  // A regular 16-gon, as the net goes round the tube, has 2.6 % less area than its circle.
  EXPECT_NEAR(volumeOf(mesh), volume, 0.026 * std::abs(volume));
  expectGoodNet(mesh);
}

TEST(Remesh, anOpenTubeKeepsItsRims)
{
  Mesh mesh = tube(100, 60, 3.0);
  remesh(mesh, 0, 0.25);
  const MeshDefects defects = findDefects(mesh);
  ASSERT_EQ(defects.boundaryLoops.size(), 2u);
  for (const BoundaryLoop& loop : defects.boundaryLoops) {
    const double z = mesh.position(2, loop.vertices[0]);
    EXPECT_NEAR(std::abs(z - 1.5), 1.5, 1e-12);
    for (const Index v : loop.vertices) {
      EXPECT_NEAR(mesh.position(2, v), z, 1e-12);
      EXPECT_NEAR(mesh.position.col(v).head<2>().norm(), 1.0, 0.001); // the chords of the old rim
    }
    EXPECT_NEAR(loop.length, 2.0 * M_PI, 0.05);
  }
  EXPECT_EQ(eulerCharacteristic(mesh), 0);
  expectGoodNet(mesh);
}

// A cube is flat sides and straight edges: all of them are exact, and so is the volume.
TEST(Remesh, aCubeKeepsItsEdges)
{
  for (const double length : {0.25, 0.05}) {
    Mesh mesh = cubeOf(10);
    remesh(mesh, 0, length);
    EXPECT_NEAR(volumeOf(mesh), 1.0, 1e-9);
    EXPECT_NEAR(areaOf(mesh), 6.0, 1e-9);
    EXPECT_NEAR(edgeLengths(mesh).mean, length, 0.2 * length);
    expectGoodNet(mesh);
  }
}

TEST(Remesh, aCoarseMeshGetsFiner)
{
  Mesh mesh = cube();
  remesh(mesh, 3000);
  EXPECT_LE(mesh.triangleCount(), 3000);
  EXPECT_GE(mesh.triangleCount(), 2550);
  EXPECT_NEAR(volumeOf(mesh), 1.0, 1e-9);
  expectGoodNet(mesh);
}

TEST(Remesh, endsOfLinesStayToTheBit)
{
  Mesh mesh = sphere(30);
  const Eigen::Vector3d first = mesh.position.col(17), second = mesh.position.col(1000);
  mesh.segments.resize(2, 1);
  mesh.segments << 17, 1000;
  const RepairReport report = remesh(mesh, 800);
  EXPECT_EQ(mesh.position.col(mesh.segments(0, 0)), first);
  EXPECT_EQ(mesh.position.col(mesh.segments(1, 0)), second);
  EXPECT_EQ(report.vertexOf[17], mesh.segments(0, 0));
  EXPECT_EQ(examine(mesh).components, 1);
  expectGoodNet(mesh);
}

// Three walls that meet in one line: its edges stay as they are, and none is added.
TEST(Remesh, wallsThatMeetInALineStayJoined)
{
  Mesh mesh;
  for (const double angle : {0.0, 2.0, 4.0}) {
    Mesh wall = grid(12);
    const Eigen::RowVectorXd x = wall.position.row(0);
    wall.position.row(2) = wall.position.row(1);
    wall.position.row(0) = std::cos(angle) * x;
    wall.position.row(1) = std::sin(angle) * x;
    append(mesh, wall);
  }
  RepairOptions options;
  options.removeUseless = true;
  RepairReport ignored;
  ASSERT_TRUE(repairMesh(mesh, options, ignored));
  // Join what lies on the line x = y = 0.
  for (Eigen::Index i = 0; i < mesh.triangles.size(); ++i) {
    Index& v = mesh.triangles.data()[i];
    if (mesh.position.col(v).head<2>().isZero()) v %= 13 * 13;
  }
  ASSERT_EQ(examine(mesh).nonManifoldEdges, 12);
  remesh(mesh, 300);
  EXPECT_EQ(examine(mesh).nonManifoldEdges, 12);
  EXPECT_EQ(examine(mesh).components, 1);
  EXPECT_NEAR(areaOf(mesh), 3.0, 1e-9);
}

// Voxel stairs: 90-degree creases everywhere, one voxel apart. They are roughness for a net ten times
// coarser.
TEST(Remesh, stairsOfVoxelsAreNoCreases)
{
  constexpr Index kSize = 24;
  const auto isIn = [](Index x, Index y, Index z) {
    const Eigen::Vector3d p(x + 0.5, y + 0.5, z + 0.5);
    return (p.array() - 0.5 * kSize).matrix().norm() < 0.45 * kSize;
  };
  Mesh mesh;
  std::vector<Eigen::Vector3d> points;
  for (Index x = 0; x < kSize; ++x)
    for (Index y = 0; y < kSize; ++y)
      for (Index z = 0; z < kSize; ++z)
        for (int side = 0; isIn(x, y, z) && side < 6; ++side) {
          Eigen::Matrix<Index, 3, 1> next(x, y, z);
          next[side % 3] += side < 3 ? -1 : 1;
          if (isIn(next[0], next[1], next[2])) continue;
          Eigen::Vector3d corner(x, y, z), u = Eigen::Vector3d::Unit((side + 1) % 3),
                                           v = Eigen::Vector3d::Unit((side + 2) % 3);
          if (side >= 3)
            corner[side % 3] += 1.0;
          else
            std::swap(u, v);
          for (const Eigen::Vector3d& p :
               {corner, Eigen::Vector3d(corner + u), Eigen::Vector3d(corner + u + v), corner,
                Eigen::Vector3d(corner + u + v), Eigen::Vector3d(corner + v)})
            points.push_back(p);
        }
  mesh.position =
    Eigen::Map<Eigen::Matrix3Xd>(points.front().data(), 3, static_cast<Eigen::Index>(points.size()));
  mesh.triangles.resize(3, mesh.position.cols() / 3);
  for (Eigen::Index i = 0; i < mesh.triangles.size(); ++i) mesh.triangles.data()[i] = static_cast<Index>(i);
  weldVertices(mesh);
  remesh(mesh, 400);
  EXPECT_LE(mesh.triangleCount(), 400);
  for (Index v = 0; v < mesh.vertexCount(); ++v) // within a voxel's diagonal of the ball
    EXPECT_NEAR((mesh.position.col(v).array() - 0.5 * kSize).matrix().norm(), 0.45 * kSize, 1.8);
  EXPECT_EQ(examine(mesh).nonManifoldEdges, 0);
}

TEST(Remesh, equalInputGivesEqualBits)
{
  Mesh first = torus(60, 30), second = first;
  remesh(first, 700);
  remesh(second, 700);
  EXPECT_TRUE(sameBits(first, second));
}

TEST(Remesh, sizesFarFromOneAreFine)
{
  for (const double scale : {1e-150, 1e150}) {
    Mesh mesh = sphere(12);
    mesh.position *= scale;
    remesh(mesh, 300);
    EXPECT_LE(mesh.triangleCount(), 300);
    for (Index v = 0; v < mesh.vertexCount(); ++v)
      EXPECT_NEAR(mesh.position.col(v).stableNorm() / scale, 1.0, 0.01);
  }
}

} // namespace
