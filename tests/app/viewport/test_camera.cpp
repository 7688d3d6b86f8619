// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/viewport/camera.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include <cmath>
#include <numbers>

using namespace esm;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

Camera sample(bool orthographic)
{
  Camera camera;
  camera.setViewport(800, 600);
  camera.setScene({0.01, 0.0, 0.02}, 0.06);
  camera.setPose({0.01, 0.02, 0.03}, 0.3, 0.7, 0.5);
  camera.setOrthographic(orthographic);
  return camera;
}

/// The same with a legend over its right edge.
Camera covered(bool orthographic)
{
  Camera camera = sample(orthographic);
  camera.setCovered(120);
  return camera;
}

class CameraModes : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(PerspectiveAndParallel, CameraModes, testing::Bool());

} // namespace

// A pixel and a plane give the point back: rounding of doubles only.
TEST_P(CameraModes, ProjectAndUnprojectAreInverse)
{
  for (const Camera& camera : {sample(GetParam()), covered(GetParam())})
    for (const Vector3d& point :
         {Vector3d(0.05, -0.01, 0.02), Vector3d(0.0, 0.0, 0.0), Vector3d(-0.03, 0.04, 0.08)}) {
      const ScreenPoint at = camera.project(point);
      EXPECT_LT((camera.onPlane(at.pixel, point) - point).norm(), 1e-14);
      const Ray ray = camera.rayThrough(at.pixel);
      EXPECT_LT((point - ray.origin).cross(ray.direction).norm(), 1e-14) << "the pixel's ray meets the point";
    }
}

// What is computed for the mouse is what the GPU draws: project() equals the matrices.
TEST_P(CameraModes, MatricesAgreeWithProject)
{
  for (const Camera& camera : {sample(GetParam()), covered(GetParam())}) {
    const Vector3d point(0.04, -0.02, 0.05);
    const Eigen::Vector4d clip = camera.projection() * camera.view() * point.homogeneous();
    const Vector2d pixel((clip.x() / clip.w() + 1.0) * 400.0, (1.0 - clip.y() / clip.w()) * 300.0);
    EXPECT_LT((camera.project(point).pixel - pixel).norm(), 1e-9);
    EXPECT_GT(clip.z(), -clip.w());
    EXPECT_LT(clip.z(), clip.w());
  }
}

// What a legend covers is not counted: the target is in the middle of the rest, and a fitted box stays
// within.
TEST_P(CameraModes, WhatIsShownKeepsClearOfTheCoveredEdge)
{
  Eigen::Matrix3Xd ends(3, 2);
  ends << -0.2, 0.2, 0, 0, 0, 0; // as long as the picture is wide
  for (const double right : {0.0, 120.0, 200.0}) {
    Camera camera = sample(GetParam());
    camera.setCovered(right);
    camera.setDirection(0.0, 0.0);
    camera.fit(ends);
    const double clear = 800.0 - right;
    EXPECT_NEAR(camera.project(camera.target()).pixel.x(), clear / 2.0, 1e-9);
    const double left = camera.project(ends.col(0)).pixel.x(), far = camera.project(ends.col(1)).pixel.x();
    EXPECT_GT(left, 0.0);
    EXPECT_LT(far, clear);
    EXPECT_GT(far - left, 0.75 * clear);
  }
}

TEST(Camera, ALegendNeverTakesMoreThanTwoFifths)
{
  Camera camera = sample(false);
  camera.setCovered(2000.0);
  EXPECT_EQ(camera.middle().x(), 0.3 * camera.width());
  EXPECT_TRUE(camera.projection().allFinite());
}

TEST(Camera, TheTargetIsInTheMiddle)
{
  const Camera camera = sample(false);
  EXPECT_LT((camera.project(camera.target()).pixel - Vector2d(400, 300)).norm(), 1e-9);
  EXPECT_NEAR(camera.project(camera.target()).depth, 0.3, 1e-15);
}

// z up, x to the right, seen from the front; from the right, y goes to the right; from the top, y goes up.
TEST(Camera, NamedViewsLookAlongTheAxes)
{
  Camera camera;
  const double quarter = std::numbers::pi / 2.0;
  camera.setDirection(0.0, 0.0);
  EXPECT_LT((camera.backward() - Vector3d(0, -1, 0)).norm(), 1e-15);
  EXPECT_LT((camera.right() - Vector3d(1, 0, 0)).norm(), 1e-15);
  EXPECT_LT((camera.up() - Vector3d(0, 0, 1)).norm(), 1e-15);
  camera.setDirection(quarter, 0.0);
  EXPECT_LT((camera.backward() - Vector3d(1, 0, 0)).norm(), 1e-15);
  EXPECT_LT((camera.right() - Vector3d(0, 1, 0)).norm(), 1e-15);
  camera.setDirection(0.0, quarter);
  EXPECT_LT((camera.backward() - Vector3d(0, 0, 1)).norm(), 1e-15);
  EXPECT_LT((camera.up() - Vector3d(0, 1, 0)).norm(), 1e-15);
}

TEST(Camera, OrbitKeepsTargetAndDistance)
{
  Camera camera = sample(false);
  const Vector3d target = camera.target(), eye = camera.eye();
  camera.orbit(120.0, -45.0);
  EXPECT_EQ(camera.target(), target);
  EXPECT_EQ(camera.distance(), 0.3);
  EXPECT_GT((camera.eye() - eye).norm(), 0.05);
  camera.orbit(0.0, 1e6); // never over the pole
  EXPECT_DOUBLE_EQ(camera.elevation(), std::numbers::pi / 2.0);
}

TEST(Camera, PanMovesTheTargetPlaneWithTheMouse)
{
  Camera camera = sample(false);
  const Vector3d point = camera.target();
  camera.pan(30.0, -12.0);
  EXPECT_LT((camera.project(point).pixel - Vector2d(430, 288)).norm(), 1e-9);
}

TEST_P(CameraModes, ZoomKeepsWhatIsUnderTheCursor)
{
  Camera camera = sample(GetParam());
  const Vector2d cursor(610.0, 140.0);
  const Vector3d point = camera.onPlane(cursor, camera.target());
  camera.zoomAt(cursor, 0.5);
  EXPECT_NEAR(camera.distance(), 0.15, 1e-15);
  EXPECT_LT((camera.project(point).pixel - cursor).norm(), 1e-9);
}

TEST(Camera, ZoomStaysWithinTheScene)
{
  Camera camera = sample(false);
  for (int i = 0; i < 200; ++i) camera.zoomAt({400, 300}, 0.5);
  EXPECT_GT(camera.distance(), 0.0);
  for (int i = 0; i < 200; ++i) camera.zoomAt({400, 300}, 2.0);
  EXPECT_LT(camera.distance(), 100.0);
  EXPECT_TRUE(camera.projection().allFinite());
}

// Every point is inside the picture, and not all far inside: they are shown as large as the margin lets them.
TEST_P(CameraModes, FitShowsTheWholeBox)
{
  const Eigen::AlignedBox3d box(Vector3d(-0.05, 0.1, 0.0), Vector3d(0.02, 0.13, 0.04));
  Eigen::Matrix3Xd corners(3, 8);
  for (int i = 0; i < 8; ++i) corners.col(i) = box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i));
  for (const Vector2d& size : {Vector2d(800, 600), Vector2d(300, 900), Vector2d(1500, 200)}) {
    Camera camera = sample(GetParam());
    camera.setViewport(size.x(), size.y());
    camera.fit(corners);
    double reach = 0.0; // largest share of half the picture
    for (Eigen::Index i = 0; i < corners.cols(); ++i) {
      const Vector2d fromMiddle = camera.project(corners.col(i)).pixel - 0.5 * size;
      reach = std::max(reach, fromMiddle.cwiseQuotient(0.5 * size).cwiseAbs().maxCoeff());
    }
    EXPECT_LT(reach, 0.9);
    EXPECT_GT(reach, 0.5);
  }
}

TEST(Camera, NonFiniteOrImpossiblePosesAreIgnored)
{
  Camera camera = sample(false);
  camera.setPose({NAN, 0, 0}, -1.0, NAN, INFINITY);
  EXPECT_EQ(camera.target(), Vector3d(0.01, 0.02, 0.03));
  EXPECT_EQ(camera.distance(), 0.3);
  EXPECT_EQ(camera.azimuth(), 0.7);
  EXPECT_EQ(camera.elevation(), 0.5);
}

TEST(Camera, WhatIsBehindTheEyeHasNoPixel)
{
  const Camera camera = sample(false);
  EXPECT_TRUE(std::isnan(camera.project(camera.eye() + 0.1 * camera.backward()).pixel.x()));
}
