// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/geometry/mesh_report.h"
#include "core/geometry/repair/repair.h"
#include "tests/core/geometry/shapes.h"
#include "tests/core/net/meshes.h"

#include <gmock/gmock.h>

#include <thread>

namespace {

using namespace esm;
using namespace esm::test;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(Repair, theDefaultChangesNothing)
{
  Mesh mesh = makeMesh({{kNaN, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 1, 1}});
  const Mesh before = mesh;
  RepairReport report;
  ASSERT_TRUE(repairMesh(mesh, {}, report));
  EXPECT_TRUE(sameBits(mesh, before));
  EXPECT_THAT(report.notes, IsEmpty());
  EXPECT_THAT(report.vertexOf, ElementsAre(0, 1, 2));
}

TEST(Repair, uselessThingsGoAndTheMapSaysWhereTheRestWent)
{
  Mesh mesh = makeMesh({{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {kNaN, 0, 0}, {5, 5, 5}},
                       {{1, 2, 3}, {3, 2, 1}, {1, 1, 2}, {1, 2, 4}}, {{1, 5}, {5, 1}, {2, 2}});
  RepairOptions options;
  options.removeUseless = true;
  RepairReport report;
  ASSERT_TRUE(repairMesh(mesh, options, report));
  EXPECT_EQ(mesh.triangleCount(), 1);
  EXPECT_EQ(mesh.segmentCount(), 1);
  EXPECT_THAT(report.vertexOf, ElementsAre(kNoIndex, 0, 1, 2, kNoIndex, 3));
  EXPECT_EQ(report.nonFiniteVertices, 1);
  EXPECT_EQ(report.degenerateFaces, 1);
  EXPECT_EQ(report.duplicateFaces, 1);
  EXPECT_EQ(report.isolatedVertices, 1);
  EXPECT_EQ(report.uselessSegments, 2);
  EXPECT_EQ(report.notes.size(), 5u); // one sentence each
}

TEST(Repair, smallPartsGoAndLinesCountAsTheirSegments)
{
  Mesh mesh = sphere(4);           // 128 triangles
  append(mesh, cube(), {5, 0, 0}); // 12
  append(mesh, makeMesh({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}, {}, {{0, 1}, {1, 2}, {2, 3}}),
         {9, 0, 0});
  RepairOptions options;
  RepairReport report;
  Mesh some = mesh;
  options.dropPartsBelow = 4;
  ASSERT_TRUE(repairMesh(some, options, report));
  EXPECT_EQ(report.droppedParts, 1);
  EXPECT_EQ(report.droppedElements, 3);
  EXPECT_EQ(some.triangleCount(), 140);
  some = mesh;
  options = {};
  options.dropPartsShare = 0.1; // 12.8 elements
  ASSERT_TRUE(repairMesh(some, options, report));
  EXPECT_EQ(report.droppedParts, 2);
  EXPECT_EQ(some.triangleCount(), 128);
  options.dropPartsShare = 0.0;
  options.dropPartsBelow = 1000;
  const Status nothingLeft = repairMesh(some, options, report);
  ASSERT_FALSE(nothingLeft);
  EXPECT_EQ(nothingLeft.error().code, ErrorCode::EmptyResult);
  EXPECT_EQ(some.triangleCount(), 128); // as it was
}

// Half of a torus' triangles turned at random: turned back they enclose the volume of the polyhedron again.
TEST(Repair, orientationGivesVolumeBack)
{
  const Mesh whole = torus(40, 20);
  Mesh mesh = whole;
  std::mt19937_64 random(5);
  for (Index t = 0; t < mesh.triangleCount(); ++t)
    if (random() & 1) std::swap(mesh.triangles(0, t), mesh.triangles(1, t));
  RepairOptions options;
  options.unifyOrientation = true;
  RepairReport report;
  ASSERT_TRUE(repairMesh(mesh, options, report));
  EXPECT_NEAR(volumeOf(mesh), std::abs(volumeOf(whole)), 1e-12);
  EXPECT_EQ(areaOf(mesh), areaOf(mesh));
  EXPECT_EQ(eulerCharacteristic(mesh), 0);
  EXPECT_EQ(report.unorientable, 0);
}

TEST(Repair, impossibleWishesAreRefused)
{
  const auto isRefused = [](const auto& change) {
    Mesh mesh = cube();
    RepairOptions options;
    change(options);
    RepairReport report;
    const Status status = repairMesh(mesh, options, report);
    return !status && status.error().code == ErrorCode::InvalidValue && sameBits(mesh, cube());
  };
  EXPECT_TRUE(isRefused([](RepairOptions& o) { o.dropPartsBelow = -1; }));
  EXPECT_TRUE(isRefused([](RepairOptions& o) { o.dropPartsShare = 1.5; }));
  EXPECT_TRUE(isRefused([](RepairOptions& o) { o.tJunctionTolerance = kNaN; }));
  EXPECT_TRUE(isRefused([](RepairOptions& o) { o.fillHolesUpTo = -1; }));
  EXPECT_TRUE(isRefused([](RepairOptions& o) { o.triangles = -5; }));
  EXPECT_TRUE(isRefused([](RepairOptions& o) { o.edgeLength = kInfinity; }));
  EXPECT_TRUE(isRefused([](RepairOptions& o) { o.edgeLength = 1e-6; })); // 10^13 triangles
  EXPECT_TRUE(isRefused([](RepairOptions& o) {
    o.edgeLength = 0.1;
    o.triangles = 100;
  }));
}

// Stopped at any moment, the mesh is as it was.
TEST(Repair, cancelLeavesTheMeshAsItWas)
{
  const Mesh before = sphere(40);
  RepairOptions options;
  options.removeUseless = options.closeTJunctions = options.unifyOrientation = true;
  options.fillHolesUpTo = 100;
  options.triangles = 2000;
  for (const int milliseconds : {0, 1, 2, 4, 8, 12}) {
    Mesh mesh = before;
    WorkControl control;
    if (milliseconds == 0) control.cancelled = true;
    std::jthread owner([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
      control.cancelled = true;
    });
    RepairReport report;
    const Status status = repairMesh(mesh, options, report, &control);
    if (!status) {
      EXPECT_EQ(status.error().code, ErrorCode::Cancelled);
      EXPECT_TRUE(sameBits(mesh, before));
    } else {
      EXPECT_GT(milliseconds, 0) << "was asked to stop before it began";
    }
  }
}

} // namespace
