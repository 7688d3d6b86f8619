// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/geometry/mesh_defects.h"
#include "core/geometry/mesh_report.h"
#include "core/geometry/repair/repair.h"
#include "core/geometry/weld.h"
#include "tests/core/geometry/shapes.h"
#include "tests/core/net/meshes.h"

#include <gmock/gmock.h>

namespace {

using namespace esm;
using namespace esm::test;

/// One of the good shapes with a handful of damages.
Mesh brokenMesh(std::mt19937_64& random)
{
  const auto below = [&](Index n) { return static_cast<Index>(random() % static_cast<std::uint64_t>(n)); };
  Mesh mesh;
  switch (below(5)) {
  case 0:
    mesh = sphere(2 + below(6));
    break;
  case 1:
    mesh = torus(3 + below(12), 3 + below(8));
    break;
  case 2:
    mesh = tube(3 + below(12), 1 + below(5), 2.0);
    break;
  case 3:
    mesh = grid(1 + below(8));
    break;
  default:
    mesh = cubeOf(1 + below(4));
    break;
  }
  const Index damages = below(8);
  for (Index i = 0; i < damages && mesh.triangleCount() > 2; ++i) {
    const Index t = below(mesh.triangleCount()), v = below(mesh.vertexCount());
    switch (below(9)) {
    case 0:
      mesh.position(below(3), v) = below(2) ? kNaN : kInfinity;
      break;
    case 1:
      mesh.triangles(below(3), t) = v;
      break; // any corner: spikes, non-manifold edges, degenerate faces
    case 2:
      std::swap(mesh.triangles(0, t), mesh.triangles(1, t));
      break;
    case 3:
      mesh = without(mesh, [&](Index other) { return other == t || other == t + 1; });
      break;
    case 4:
      append(mesh, without(mesh, [&](Index other) { return other != t; }));
      break; // a double, unwelded
    case 5:
      append(mesh, cube(), {0.3, 0.1, 0.2});
      break;
    case 6:
      weldVertices(mesh, 0.3);
      break;
    case 7:
      mesh.position.col(v) = mesh.position.col(below(mesh.vertexCount())).eval();
      break;
    default:
      mesh.segments.conservativeResize(Eigen::NoChange, mesh.segmentCount() + 1);
      mesh.segments.col(mesh.segmentCount() - 1) << v, below(mesh.vertexCount());
    }
  }
  return mesh;
}

RepairOptions someOptions(std::mt19937_64& random, bool mayRemesh)
{
  RepairOptions options;
  options.removeUseless = random() & 1;
  options.closeTJunctions = random() & 1;
  options.dropPartsBelow = random() % 3 == 0 ? 3 : 0;
  options.fillHolesUpTo = random() & 1 ? 12 : 0;
  options.unifyOrientation = random() & 1;
  if (mayRemesh && random() & 1)
    options.triangles = 40 + static_cast<Index>(random() % 300);
  else if (mayRemesh)
    options.edgeLength = 0.1 + uniform(random);
  return options;
}

/// Whether the indices are in range and no coordinate is bad that was not so before.
void expectSound(const Mesh& mesh, bool isFinite)
{
  const auto check = [&](const auto& elements) {
    for (Eigen::Index i = 0; i < elements.size(); ++i) {
      ASSERT_GE(elements.data()[i], 0);
      ASSERT_LT(elements.data()[i], mesh.vertexCount());
    }
  };
  check(mesh.triangles);
  check(mesh.segments);
  if (isFinite) {
    EXPECT_TRUE(mesh.position.allFinite());
  }
}

// Whatever is wrong with a mesh, repairs end, with sound numbers; and they make no new non-manifold edge.
TEST(BrokenMeshes, areRepairedWithoutHarm)
{
  std::mt19937_64 random(11);
  for (int round = 0; round < 150; ++round) {
    SCOPED_TRACE(round);
    const Mesh before = brokenMesh(random);
    const RepairOptions options = someOptions(random, true);
    Mesh mesh = before;
    RepairReport report;
    const Status status = repairMesh(mesh, options, report);
    if (!status) {
      EXPECT_TRUE(sameBits(mesh, before));
      continue;
    }
    expectSound(mesh, !options.doesNothing());
    ASSERT_EQ(report.vertexOf.size(), static_cast<std::size_t>(before.vertexCount()));
    for (const Index v : report.vertexOf) EXPECT_LT(v, mesh.vertexCount());
    if (!options.closeTJunctions) { // two sheets tied along the same points meet in more than two triangles
      EXPECT_LE(examine(mesh).nonManifoldEdges, examine(before).nonManifoldEdges);
    }
    findDefects(mesh);
  }
}

TEST(BrokenMeshes, repairedTwiceIsRepairedOnce)
{
  std::mt19937_64 random(12);
  for (int round = 0; round < 150; ++round) {
    SCOPED_TRACE(round);
    Mesh mesh = brokenMesh(random);
    const RepairOptions options = someOptions(random, false);
    RepairReport report;
    if (!repairMesh(mesh, options, report)) continue;
    Mesh again = mesh;
    ASSERT_TRUE(repairMesh(again, options, report));
    EXPECT_TRUE(sameBits(again, mesh)) << ::testing::PrintToString(report.notes);
  }
}

TEST(BrokenMeshes, aRemeshedNetIsLeftAsItIs)
{
  for (const Index triangles : {500, 900}) {
    Mesh mesh = torus(80, 40);
    RepairOptions options;
    options.triangles = triangles;
    RepairReport report;
    ASSERT_TRUE(repairMesh(mesh, options, report));
    Mesh again = mesh;
    ASSERT_TRUE(repairMesh(again, options, report));
    EXPECT_TRUE(sameBits(again, mesh));
    EXPECT_EQ(report.remeshedTo, 0);
  }
}

TEST(BrokenMeshes, aThousandPartsAreOneThousand)
{
  Mesh mesh;
  mesh.position.resize(3, 0);
  const Mesh one = cube();
  mesh.position.resize(3, 8 * 1000);
  mesh.triangles.resize(3, 12 * 1000);
  for (Index i = 0; i < 1000; ++i) {
    mesh.position.middleCols(8 * i, 8) = one.position.colwise() + Eigen::Vector3d(2.0 * i, 0, 0);
    mesh.triangles.middleCols(12 * i, 12) = (one.triangles.array() + 8 * i).matrix();
  }
  EXPECT_EQ(findDefects(mesh).parts.size(), 1000u);
  RepairOptions options;
  options.triangles = 4000; // fewer than a closed part of each may have while it keeps its corners
  RepairReport report;
  ASSERT_TRUE(repairMesh(mesh, options, report));
  EXPECT_EQ(examine(mesh).components, 1000);
  EXPECT_EQ(examine(mesh).nonManifoldEdges, 0);
}

} // namespace
