// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/geometry/extent.h"
#include "core/geometry/triangle_tree.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <random>

namespace {

using namespace esm;

/// Nearest meeting by solving a + u (b - a) + v (c - a) = origin + t direction for every triangle.
RayHit nearestOfAll(const Eigen::Matrix3Xd& position, const TriangleMatrix& triangles,
                    const Eigen::Vector3d& origin, const Eigen::Vector3d& direction)
{
  RayHit nearest{kNoIndex, std::numeric_limits<double>::infinity()};
  for (Index t = 0; t < static_cast<Index>(triangles.cols()); ++t) {
    const Eigen::Vector3d a = position.col(triangles(0, t));
    Eigen::Matrix3d system;
    system << position.col(triangles(1, t)) - a, position.col(triangles(2, t)) - a, -direction;
    const Eigen::Vector3d uvt = system.inverse() * (origin - a);
    if (uvt[0] >= 0.0 && uvt[1] >= 0.0 && uvt[0] + uvt[1] <= 1.0 && uvt[2] >= 0.0 &&
        uvt[2] < nearest.distance)
      nearest = {t, uvt[2]};
  }
  return nearest;
}

// 200 triangles of a fifth of the box's size, 500 rays into the box: about every second one meets something. Two ways
// to solve a system of three equations differ by rounding, 1e-16 times its condition of up to 1e4 or so.
TEST(TriangleTree, FindsWhatASearchThroughAllFinds)
{
  std::mt19937 random(11);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  const auto point = [&] { return Eigen::Vector3d(number(random), number(random), number(random)); };
  constexpr Index kTriangles = 200;
  Eigen::Matrix3Xd position(3, 3 * kTriangles);
  TriangleMatrix triangles(3, kTriangles);
  for (Index t = 0; t < kTriangles; ++t) {
    const Eigen::Vector3d middle = point();
    for (Index k = 0; k < 3; ++k) {
      position.col(3 * t + k) = middle + 0.2 * point();
      triangles(k, t) = 3 * t + k;
    }
  }
  const TriangleTree tree(position, triangles);
  int met = 0;
  for (int ray = 0; ray < 500; ++ray) {
    const Eigen::Vector3d origin = 2.0 * point(), direction = (point() - origin).normalized();
    const RayHit expected = nearestOfAll(position, triangles, origin, direction);
    const RayHit hit = tree.firstHit(origin, direction, 0.0, std::numeric_limits<double>::infinity(),
                                     [](Index) { return false; });
    ASSERT_EQ(hit.triangle, expected.triangle) << "ray " << ray;
    if (hit.triangle == kNoIndex) continue;
    EXPECT_NEAR(hit.distance, expected.distance, 1e-10);
    ++met;
  }
  EXPECT_GT(met, 100);
}

// What is not finite has no place.
TEST(Extent, IsTheDiagonalOfTheBoxAroundThePoints)
{
  Eigen::Matrix3Xd points(3, 4);
  points << 1, 4, 2, std::numeric_limits<double>::infinity(), //
    0, 0, 4, 0,                                               //
    -1, 11, 3, 0;
  EXPECT_EQ(boxOf(points).min(), Eigen::Vector3d(1, 0, -1));
  EXPECT_EQ(boxOf(points).max(), Eigen::Vector3d(4, 4, 11));
  EXPECT_DOUBLE_EQ(extentOf(points), 13.0); // 3, 4, 12
  EXPECT_EQ(extentOf(Eigen::Matrix3Xd(3, 0)), 0.0);
}

} // namespace
