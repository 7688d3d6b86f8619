// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "meshimport/triangulate.h"

#include "core/net/net_builder.h"
#include "meshimport/polygon_springs.h"

#include <Eigen/Geometry>
#include <gmock/gmock.h>

#include <cmath>
#include <numeric>

namespace {

using namespace esm;

std::vector<Index> cut(const Eigen::Matrix3Xd& outline)
{
  std::vector<Index> corners(static_cast<std::size_t>(outline.cols())), triangles;
  std::iota(corners.begin(), corners.end(), 0);
  triangulate(outline, corners, triangles);
  return triangles;
}

/// Sum of the triangles' areas, each taken positive: equals the polygon's area only if none overlap.
double coveredArea(const Eigen::Matrix3Xd& p, const std::vector<Index>& t)
{
  double area = 0.0;
  for (std::size_t i = 0; i + 2 < t.size(); i += 3)
    area += 0.5 * (p.col(t[i + 1]) - p.col(t[i])).cross(p.col(t[i + 2]) - p.col(t[i])).norm();
  return area;
}

int largestDegree(Index corners, const std::vector<Index>& triangles)
{
  std::vector<int> uses(static_cast<std::size_t>(corners), 0);
  for (const Index corner : triangles) ++uses[static_cast<std::size_t>(corner)];
  return *std::max_element(uses.begin(), uses.end());
}

Eigen::Matrix3Xd regular(Index n)
{
  Eigen::Matrix3Xd outline(3, n);
  for (Index i = 0; i < n; ++i) outline.col(i) << std::cos(2 * M_PI * i / n), std::sin(2 * M_PI * i / n), 1.0;
  return outline;
}

TEST(Triangulate, aQuadIsSplitAlongItsShorterDiagonal)
{
  Eigen::Matrix3Xd kite(3, 4);
  kite << 0, 3, 6, 3, /**/ 0, 1, 0, -1, /**/ 0, 0, 0, 0;
  const std::vector<Index> triangles = cut(kite);
  ASSERT_EQ(triangles.size(), 6u);
  EXPECT_EQ(std::count(triangles.begin(), triangles.end(), 1), 2); // the diagonal 1-3 is in both
  EXPECT_EQ(std::count(triangles.begin(), triangles.end(), 3), 2);
}

TEST(Triangulate, aConcaveQuadIsSplitInsideEvenIfTheOtherDiagonalIsShorter)
{
  Eigen::Matrix3Xd dart(3, 4); // corner 1 points inwards; 0-2 is the shorter diagonal but lies outside
  dart.col(0) << -1, 0, 0;
  dart.col(1) << 0, 1, 0;
  dart.col(2) << 1, 0, 0;
  dart.col(3) << 0, 4, 0;
  const std::vector<Index> triangles = cut(dart);
  EXPECT_NEAR(coveredArea(dart, triangles), 3.0, 1e-12); // half of 2 * (4 - 1)
  EXPECT_EQ(std::count(triangles.begin(), triangles.end(), 1), 2);
}

TEST(Triangulate, aRoundPolygonGetsNoHub)
{
  for (const Index n : {5, 6, 17, 600}) {
    const std::vector<Index> triangles = cut(regular(n));
    EXPECT_EQ(triangles.size(), 3 * static_cast<std::size_t>(n - 2));
    EXPECT_NEAR(coveredArea(regular(n), triangles), 0.5 * n * std::sin(2 * M_PI / n), 1e-9);
    EXPECT_LE(largestDegree(n, triangles), 2 * std::ceil(std::log2(n)) + 1) << n;
  }
}

TEST(Triangulate, aConcaveStarStaysInsideItsOutlineInAnyPlane)
{
  Eigen::Matrix3Xd star = regular(10);
  for (Index i = 1; i < 10; i += 2) star.col(i).head<2>() *= 0.4;
  const double area = 10 * 0.5 * 0.4 * std::sin(M_PI / 5); // ten triangles to the centre
  const Eigen::Quaterniond turn = Eigen::Quaterniond(0.3, -0.5, 0.7, 0.4).normalized();
  const Eigen::Matrix3Xd turned =
    ((turn.toRotationMatrix() * star) * 1e-3).colwise() + Eigen::Vector3d(5, -3, 2);
  EXPECT_NEAR(coveredArea(star, cut(star)), area, 1e-12);
  EXPECT_NEAR(coveredArea(turned, cut(turned)), area * 1e-6, 1e-14); // positions are rounded at 5 * 2^-53
}

TEST(Triangulate, hopelessOutlinesStillGiveNMinusTwoTriangles)
{
  Eigen::Matrix3Xd bowTie(3, 4), line(3, 5), point = Eigen::Matrix3Xd::Zero(3, 6);
  bowTie << 0, 1, 1, 0, /**/ 0, 1, 0, 1, /**/ 0, 0, 0, 0;
  line << 0, 1, 2, 3, 4, /**/ 0, 0, 0, 0, 0, /**/ 0, 0, 0, 0, 0;
  Eigen::Matrix3Xd notANumber = regular(7);
  notANumber(1, 3) = std::nan("");
  EXPECT_EQ(cut(bowTie).size(), 6u);
  EXPECT_EQ(cut(line).size(), 9u);
  EXPECT_EQ(cut(point).size(), 12u);
  EXPECT_EQ(cut(notANumber).size(), 15u);
}

TEST(Triangulate, veryLongOutlinesAreCutInAZigzag)
{
  const Index n = static_cast<Index>(kLongPolygon) + 101;
  const std::vector<Index> triangles = cut(regular(n));
  EXPECT_EQ(triangles.size(), 3 * static_cast<std::size_t>(n - 2));
  EXPECT_LE(largestDegree(n, triangles), 3);
  EXPECT_NEAR(coveredArea(regular(n), triangles), M_PI, 1e-4); // 2 pi^3 / (3 n^2) less than the disc
}

TEST(Triangulate, repeatedCornersCountOnce)
{
  const Eigen::Matrix3Xd p = regular(4);
  std::vector<Index> triangles;
  triangulate(p, std::vector<Index>{0, 0, 1, 2, 2, 0}, triangles);
  EXPECT_THAT(triangles, ::testing::UnorderedElementsAre(0, 1, 2));
}

// A cut through a polygon is no spring, unless a face of its own has its side there: two faces of the quad
// and none else beside its diagonal, or a fin that stands on it.
TEST(PolygonSprings, aCutOnWhichAnotherFaceStandsStays)
{
  for (const bool fin : {false, true}) {
    Mesh mesh;
    mesh.position.resize(3, 5);
    mesh.position << 0, 1, 1, 0, 0.5, 0, 0, 1, 1, 0.5, 0, 0, 0, 0, 1;
    mesh.triangles.resize(3, fin ? 3 : 2);
    mesh.triangles.col(0) << 0, 1, 2;
    mesh.triangles.col(1) << 0, 2, 3;
    if (fin) mesh.triangles.col(2) << 0, 2, 4;
    mesh.diagonals.resize(2, 1);
    mesh.diagonals << 0, 2;
    std::vector<Index> nodeOfVertex;
    Result<SpringNet> net = buildNet(mesh, &nodeOfVertex);
    ASSERT_TRUE(net);
    dropDiagonals(*net, mesh, nodeOfVertex);
    EXPECT_EQ(net->springCount(), fin ? 7 : 4); // outline, and with the fin its three sides
  }
}

} // namespace
