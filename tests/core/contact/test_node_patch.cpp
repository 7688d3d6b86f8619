// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/contact/node_patch.h"

#include "tests/core/contact/hanging_chain.h"
#include "tests/core/tissue/test_nets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace esm {

namespace {

/// A sheet of `side` x `side` nodes in equilateral triangles at `height`, on nodes from `first` on.
void addSheet(Mesh& mesh, Index side, double edge, double height)
{
  const auto first = static_cast<Index>(mesh.position.cols());
  mesh.position.conservativeResize(3, first + side * side);
  for (Index i = 0; i < side * side; ++i) {
    const Index x = i % side, y = i / side;
    mesh.position.col(first + i) = Eigen::Vector3d(edge * (x + 0.5 * (y % 2)), 0.75 * edge * y, height);
    mesh.position(1, first + i) *= std::numbers::sqrt3 / 1.5;
  }
  for (Index y = 0; y + 1 < side; ++y)
    for (Index x = 0; x + 1 < side; ++x) {
      const Index a = first + y * side + x, b = a + side;
      const Index shift = y % 2; // of the row above
      const auto t = mesh.triangles.cols();
      mesh.triangles.conservativeResize(3, t + 2);
      mesh.triangles.col(t) << a, a + 1, b + shift;
      mesh.triangles.col(t + 1) << (shift ? a : a + 1), b + 1, b;
    }
}

Mesh sheet(Index side, double edge)
{
  Mesh mesh;
  mesh.position.resize(3, 0);
  addSheet(mesh, side, edge, 0.0);
  return mesh;
}

std::vector<PatchNode> patchOf(const SpringNet& net, Index node, double radius)
{
  std::vector<PatchNode> nodes;
  PatchFinder(net).find(net.restPosition, node, radius, nodes);
  return nodes;
}

constexpr double kPatchRadius = 0.008;

} // namespace

// Shares times cells are the same on every mesh: the integral of the share over the plane, 1.05 pi radius^2. Sums
// over nodes know it to the second power of the edge over the skirt of 8 mm, 1 % at 4 mm.
TEST(NodePatch, CoversTheSameAreaOnEveryMesh)
{
  for (const double edge : {0.004, 0.002, 0.001}) {
    const Index side = static_cast<Index>(std::lround(0.04 / edge));
    const SpringNet net = test::netOf(sheet(side, edge));
    double area = 0.0;
    const std::vector<PatchNode> patch = patchOf(net, side * (side / 2) + side / 2, kPatchRadius);
    for (const PatchNode& found : patch) area += found.share * found.area;
    EXPECT_NEAR(area / (1.05 * std::numbers::pi * kPatchRadius * kPatchRadius), 1.0, 0.01) << edge;
    EXPECT_EQ(patch.front().node, side * (side / 2) + side / 2);
  }
}

// Two walls 3 mm apart, joined by struts: on the surface the way does not go through.
TEST(NodePatch, LeavesTheOppositeWallAlone)
{
  constexpr Index kSide = 20;
  Mesh mesh = sheet(kSide, 0.002);
  addSheet(mesh, kSide, 0.002, 0.003);
  mesh.segments.resize(2, kSide * kSide);
  for (Index i = 0; i < kSide * kSide; ++i) mesh.segments.col(i) << i, i + kSide * kSide;
  const SpringNet net = test::netOf(mesh);
  const std::vector<PatchNode> patch = patchOf(net, kSide * 10 + 10, kPatchRadius);
  EXPECT_GT(patch.size(), 40u);
  for (const PatchNode& found : patch) EXPECT_LT(found.node, kSide * kSide);
}

// Nodes 1 cm apart without a surface, along their springs: a quarter of the skirt is left there, 3/16 - 2/64.
TEST(NodePatch, FollowsSpringsWhereThereIsNoSurface)
{
  const SpringNet net = chain(5);
  const std::vector<PatchNode> patch = patchOf(net, 2, kPatchRadius);
  ASSERT_EQ(patch.size(), 3u);
  EXPECT_EQ(patch[0].node, 2);
  EXPECT_EQ(patch[0].share, 1.0);
  EXPECT_NEAR(patch[1].share, 0.15625, 1e-9);
  EXPECT_NEAR(patch[1].area, 1e-4, 1e-12) << "the square of an edge";
  EXPECT_NEAR(patch[2].share, 0.15625, 1e-9);
  for (const double radius : {0.0, 0.006, -1.0}) {
    const std::vector<PatchNode> alone = patchOf(net, 2, radius);
    ASSERT_EQ(alone.size(), 1u) << radius;
    EXPECT_EQ(alone[0].share, 1.0);
  }
}

// A deformed net is measured as it is: stretched to twice its length, a chain has fewer nodes in the patch.
TEST(NodePatch, MeasuresTheNetAsItIs)
{
  const SpringNet net = chain(9);
  const Index node = 4;
  std::vector<PatchNode> nodes;
  PatchFinder finder(net);
  finder.find(net.restPosition, node, 0.024, nodes);
  EXPECT_EQ(nodes.size(), 7u);
  const Eigen::Matrix3Xd stretched = 2.0 * net.restPosition;
  finder.find(stretched, node, 0.024, nodes);
  EXPECT_EQ(nodes.size(), 3u);
}

} // namespace esm
