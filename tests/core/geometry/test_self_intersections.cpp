// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/geometry/self_intersections.h"
#include "tests/core/geometry/shapes.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <random>

namespace esm {
namespace {

Mesh meshOf(const std::vector<Eigen::Vector3d>& places, const std::vector<Eigen::Vector3i>& triangles)
{
  Mesh mesh;
  mesh.position.resize(3, static_cast<Eigen::Index>(places.size()));
  for (std::size_t i = 0; i < places.size(); ++i) mesh.position.col(static_cast<Eigen::Index>(i)) = places[i];
  mesh.triangles.resize(3, static_cast<Eigen::Index>(triangles.size()));
  for (std::size_t t = 0; t < triangles.size(); ++t)
    mesh.triangles.col(static_cast<Eigen::Index>(t)) = triangles[t];
  return mesh;
}

/// A flat grid of n x n squares of side 1 in the plane z = 0, turned by `turn` about the origin.
Mesh sheet(int n, const Eigen::Matrix3d& turn, const Eigen::Vector3d& shift)
{
  std::vector<Eigen::Vector3d> places;
  std::vector<Eigen::Vector3i> triangles;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) places.emplace_back(turn * Eigen::Vector3d(i, j, 0) + shift);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const int a = i * (n + 1) + j, b = a + n + 1;
      triangles.emplace_back(a, b, a + 1);
      triangles.emplace_back(b, b + 1, a + 1);
    }
  return meshOf(places, triangles);
}

Mesh both(const Mesh& one, const Mesh& two)
{
  Mesh mesh = one;
  mesh.position.conservativeResize(Eigen::NoChange, one.vertexCount() + two.vertexCount());
  mesh.position.rightCols(two.vertexCount()) = two.position;
  mesh.triangles.conservativeResize(Eigen::NoChange, one.triangleCount() + two.triangleCount());
  mesh.triangles.rightCols(two.triangleCount()) = two.triangles.array() + one.vertexCount();
  return mesh;
}

TEST(SelfIntersections, TwoTrianglesThroughEachOther)
{
  const Mesh mesh = meshOf({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0.5, 0.5, -1}, {0.5, 0.5, 1}, {3, 3, 0.2}},
                           {{0, 1, 2}, {3, 4, 5}});
  const SelfIntersections found = findSelfIntersections(mesh, 0.0);
  ASSERT_EQ(found.pairs.size(), 1u);
  EXPECT_EQ(found.pairs[0].first, 0);
  EXPECT_EQ(found.pairs[0].second, 1);
  EXPECT_TRUE(found.isComplete);
  EXPECT_LT(std::abs(found.pairs[0].place.z()), 1e-12); // on the line that they share, in the first's plane
}

// Neighbours touch, and that is no fault; nor are two sheets that lie side by side or one over the other.
TEST(SelfIntersections, SoundSurfacesHaveNone)
{
  const Mesh flat = sheet(12, Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero());
  EXPECT_TRUE(findSelfIntersections(flat, 0.0).pairs.empty());
  EXPECT_TRUE(findSelfIntersections(both(flat, sheet(12, Eigen::Matrix3d::Identity(), {0.3, 0.2, 1e-9})), 0.0)
                .pairs.empty());
}

// Random triangles: the tree finds what all pairs, tested one by one in meshes of two, say.
TEST(SelfIntersections, TheTreeFindsWhatAllPairsSay)
{
  std::mt19937 random(3);
  const auto number = [&] { return static_cast<double>(random()) / 4294967296.0; };
  std::vector<Eigen::Vector3d> places;
  std::vector<Eigen::Vector3i> triangles;
  for (int t = 0; t < 120; ++t) {
    const Eigen::Vector3d middle(number(), number(), number());
    for (int k = 0; k < 3; ++k)
      places.emplace_back(middle + 0.45 * Eigen::Vector3d(number() - 0.5, number() - 0.5, number() - 0.5));
    triangles.emplace_back(3 * t, 3 * t + 1, 3 * t + 2);
  }
  const Mesh mesh = meshOf(places, triangles);
  std::vector<std::pair<Index, Index>> expected, found;
  for (int a = 0; a < 120; ++a)
    for (int b = a + 1; b < 120; ++b) {
      Mesh two = mesh;
      two.triangles.resize(3, 2);
      two.triangles << mesh.triangles.col(a), mesh.triangles.col(b);
      if (!findSelfIntersections(two, 0.0).pairs.empty()) expected.emplace_back(a, b);
    }
  for (const SelfIntersection& pair : findSelfIntersections(mesh, 0.0).pairs)
    found.emplace_back(pair.first, pair.second);
  EXPECT_GT(expected.size(), 50u);
  EXPECT_EQ(found, expected);
}

// Two sheets that cross at an oblique angle: every place lies on both planes; the list can be limited, which
// it says, as it does when it is stopped.
TEST(SelfIntersections, PlacesLieOnBothSheetsAndTheListCanBeLimited)
{
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.9, Eigen::Vector3d(1, 0.3, 0).normalized()).matrix();
  const Eigen::Vector3d shift(0.21, 3.77, -2.9);
  const Mesh mesh =
    both(sheet(10, Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero()), sheet(10, turn, shift));
  const SelfIntersections found = findSelfIntersections(mesh, 0.0);
  EXPECT_GT(found.pairs.size(), 15u);
  for (const SelfIntersection& pair : found.pairs) {
    EXPECT_LT(pair.first, 200);
    EXPECT_GE(pair.second, 200);
    EXPECT_LT(std::abs(pair.place.z()), 1e-12);
    EXPECT_LT(std::abs((turn.transpose() * (pair.place - shift)).z()), 1e-12);
  }
  const SelfIntersections some = findSelfIntersections(mesh, 0.0, 5);
  EXPECT_EQ(some.pairs.size(), 5u);
  EXPECT_FALSE(some.isComplete);
  WorkControl stop;
  stop.cancelled = true;
  EXPECT_FALSE(findSelfIntersections(mesh, 0.0, 10'000, &stop).isComplete);
}

// Whatever lies nowhere or has no area takes no part.
TEST(SelfIntersections, BrokenTrianglesTakeNoPart)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Mesh mesh = meshOf({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {nan, 0.5, -1}, {0.5, 0.5, 1}, {3, 3, 0.2}},
                           {{0, 1, 2}, {3, 4, 5}, {4, 4, 5}});
  EXPECT_TRUE(findSelfIntersections(mesh, 0.0).pairs.empty());
}

} // namespace
} // namespace esm
