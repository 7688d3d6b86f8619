// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/geometry/repair/nearest_point.h"
#include "tests/core/geometry/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace {

using namespace esm;
using namespace esm::test;

// The tree finds the very point that looking at every triangle finds.
TEST(NearestPoint, agreesWithLookingAtEveryTriangle)
{
  const Mesh mesh = torus(30, 20);
  const NearestPoint tree(mesh.position, mesh.triangles);
  std::mt19937_64 random(1);
  for (int i = 0; i < 300; ++i) {
    const Eigen::Vector3d p(4 * uniform(random) - 2, 4 * uniform(random) - 2, 2 * uniform(random) - 1);
    double least = 1e9;
    for (Index t = 0; t < mesh.triangleCount(); ++t)
      least = std::min(least, (nearestOnTriangle(p, mesh.position.col(mesh.triangles(0, t)),
                                                 mesh.position.col(mesh.triangles(1, t)),
                                                 mesh.position.col(mesh.triangles(2, t))) -
                               p)
                                .squaredNorm());
    const auto all = [](Index) { return true; };
    const auto found = tree.find(p, 1e9, all);
    EXPECT_EQ(found.squaredDistance, least);
    EXPECT_EQ(tree.find(p, 1e9, all, static_cast<Index>(random() % 1200)).point,
              found.point);                                                  // whatever the hint
    EXPECT_EQ(tree.find(p, 0.5 * std::sqrt(least), all).triangle, kNoIndex); // out of reach
  }
}

TEST(NearestPoint, trianglesWithoutAreaAreLinesAndPoints)
{
  const Eigen::Vector3d a(0, 0, 0), b(1, 0, 0), p(0.25, 1, 0);
  EXPECT_EQ(nearestOnTriangle(p, a, b, b), Eigen::Vector3d(0.25, 0, 0));
  EXPECT_EQ(nearestOnTriangle(p, a, a, a), a);
}

TEST(NearestPoint, nothingIsNearAnEmptySurface)
{
  const Mesh mesh;
  const NearestPoint tree(mesh.position, mesh.triangles);
  EXPECT_EQ(tree.find({1, 2, 3}, 1e9, [](Index) { return true; }).triangle, kNoIndex);
}

} // namespace
