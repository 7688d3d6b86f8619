// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// What is done for four at a time against what one at a time gives, bit for bit: the sums are the same, in
// the same order.
#include "core/geometry/distance.h"
#include "core/geometry/four_at_a_time.h"
#include "core/geometry/triangle_shape.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

namespace esm {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// Triangles over random vertices, the last one among them; some have equal corners, or three in a line.
Mesh randomMesh(unsigned seed, Index vertices, Index triangles)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-1.0, 1.0);
  std::uniform_int_distribution<Index> vertex(0, vertices - 1);
  Mesh mesh;
  mesh.position.resize(3, vertices);
  for (double& value : mesh.position.reshaped()) value = place(random);
  for (Index v = 2; v < vertices; v += 7) // a third of a line, with the rounding that this brings
    mesh.position.col(v) = (mesh.position.col(v - 1) + 2.0 * mesh.position.col(v - 2)) / 3.0;
  mesh.triangles.resize(3, triangles);
  for (Index t = 0; t < triangles; ++t) {
    for (Index& corner : mesh.triangles.col(t)) corner = vertex(random);
    if (t % 5 == 0) mesh.triangles(t % 3, t) = mesh.triangles((t + 1) % 3, t);
    if (const Index v = vertex(random); t % 6 == 0 && v % 7 == 2) mesh.triangles.col(t) << v - 2, v, v - 1;
  }
  return mesh;
}

Index countOneByOne(const Mesh& mesh)
{
  Index count = 0;
  for (Index t = 0; t < mesh.triangleCount(); ++t) count += isDegenerate(mesh, t);
  return count;
}

/// Each corner to the next one.
SegmentMatrix sidesOf(const Mesh& mesh)
{
  SegmentMatrix ends(2, 3 * mesh.triangleCount());
  for (Index t = 0; t < mesh.triangleCount(); ++t)
    for (Index k = 0; k < 3; ++k) ends.col(3 * t + k) << mesh.triangles(k, t), mesh.triangles((k + 1) % 3, t);
  return ends;
}

TEST(FourAtATime, CountsTheDegenerateTrianglesThatOneAtATimeFinds)
{
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Mesh mesh = randomMesh(seed, seed < 10 ? 40 : 4000, 1000 + static_cast<Index>(seed));
    const Index expected = countOneByOne(mesh);
    ASSERT_GT(expected, 200); // every fifth has equal corners
    EXPECT_EQ(countDegenerate(mesh, 0, mesh.triangleCount()), expected) << "seed " << seed;
    Index inParts = 0; // most of them without the last vertex
    for (Index t = 0; t < mesh.triangleCount(); t += 10)
      inParts += countDegenerate(mesh, t, std::min(t + 10, mesh.triangleCount()));
    EXPECT_EQ(inParts, expected) << "seed " << seed;
  }
}

TEST(FourAtATime, EqualCornersAreDegenerateWhereverTheyAre)
{
  for (const double value : {kNan, std::numeric_limits<double>::infinity(), 1e200, 1e-200, 0.0}) {
    Mesh mesh = randomMesh(1, 4000, 400);
    for (Index v = 0; v < mesh.vertexCount(); v += 3) mesh.position(v % 3, v) = value;
    EXPECT_EQ(countDegenerate(mesh, 0, mesh.triangleCount()), countOneByOne(mesh)) << value;
  }
}

TEST(FourAtATime, LengthsHaveTheBitsOfDistance)
{
  for (unsigned seed = 0; seed < 10; ++seed) {
    Mesh mesh = randomMesh(seed, seed < 5 ? 40 : 4000, 501);
    for (Index t = 0; t < mesh.triangleCount(); t += 5) mesh.triangles.col(t) << 0, 1, 3; // no equal ends
    const SegmentMatrix ends = sidesOf(mesh);
    const auto count = static_cast<Index>(ends.cols());
    Eigen::ArrayXd length = Eigen::ArrayXd::Constant(count, kNan);
    bool isUsual = true, isSaidUsual = true;
    for (Index e = 0; e < count; e += 30)
      isSaidUsual &= measureUsual(mesh.position, ends, e, std::min(e + 30, count), length);
    for (Index e = 0; e < count; ++e) {
      const Eigen::Vector3d a = mesh.position.col(ends(0, e)), b = mesh.position.col(ends(1, e));
      isUsual = isUsual && isUsualSquare((b - a).squaredNorm());
      ASSERT_EQ(length[e], distance(a, b)) << "seed " << seed << ", edge " << e;
    }
    EXPECT_EQ(isSaidUsual, isUsual);
  }
}

TEST(FourAtATime, SaysWhereALengthIsNoUsualOne)
{
  const Mesh plain = randomMesh(3, 4000, 400);
  SegmentMatrix ends(2, 64);
  for (Index e = 0; e < 64; ++e) ends.col(e) << 3 * e, 3 * e + 1;
  Eigen::ArrayXd length(64);
  ASSERT_TRUE(measureUsual(plain.position, ends, 0, 64, length));
  for (const double value : {kNan, std::numeric_limits<double>::infinity(), 1e200})
    for (const Index edge : {0, 3, 30, 63}) {
      Mesh mesh = plain;
      mesh.position(edge % 3, ends(1, edge)) = value;
      EXPECT_FALSE(measureUsual(mesh.position, ends, 0, 64, length)) << value << " at edge " << edge;
    }
  ends(1, 17) = ends(0, 17); // of no length
  EXPECT_FALSE(measureUsual(plain.position, ends, 0, 64, length));
}

} // namespace
} // namespace esm
