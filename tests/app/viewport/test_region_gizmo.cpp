// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/viewport/region_gizmo.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

using namespace esm;
using Eigen::Vector2d;
using Eigen::Vector3d;
using HandleKind = GizmoHandle::Kind;

namespace {

Camera camera(double azimuth = 0.6, double elevation = 0.4)
{
  Camera camera;
  camera.setViewport(800, 600);
  camera.setScene(Vector3d::Zero(), 0.1);
  camera.setPose(Vector3d::Zero(), 0.4, azimuth, elevation);
  return camera;
}

GizmoShape egg()
{
  GizmoShape shape;
  shape.ellipsoid.centre = {0.01, -0.005, 0.02};
  shape.ellipsoid.semiAxes = {0.05, 0.03, 0.04};
  shape.ellipsoid.rotation =
    Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()) * Eigen::Quaterniond::Identity();
  shape.falloff = 0.4;
  return shape;
}

std::optional<Vector2d> spotOf(const GizmoLayout& layout, const GizmoHandle& handle)
{
  for (const GizmoLayout::Spot& spot : layout.spots)
    if (spot.handle == handle) return spot.pixel;
  return std::nullopt;
}

/// A pixel where exactly that handle is taken.
std::optional<Vector2d> placeOf(const GizmoLayout& layout, const GizmoHandle& handle)
{
  std::vector<Vector2d> places;
  if (const auto spot = spotOf(layout, handle)) places.push_back(*spot);
  for (const auto& arrow : layout.arrows)
    if (arrow.handle == handle) places.push_back(0.5 * (arrow.from + arrow.to));
  for (const auto& ring : layout.rings)
    if (ring.handle == handle) places.insert(places.end(), ring.pixels.begin(), ring.pixels.end());
  for (const Vector2d& place : places)
    if (handleAt(layout, place) == handle) return place;
  return std::nullopt;
}

std::vector<GizmoHandle> allHandles()
{
  std::vector<GizmoHandle> handles{{HandleKind::Move, 0, 1}, {HandleKind::Falloff, 0, 1}};
  for (int axis = 0; axis < 3; ++axis)
    for (const GizmoHandle& handle :
         {GizmoHandle{HandleKind::Slide, axis, 1}, GizmoHandle{HandleKind::Turn, axis, 1},
          GizmoHandle{HandleKind::Stretch, axis, 1}, GizmoHandle{HandleKind::Stretch, axis, -1}})
      handles.push_back(handle);
  return handles;
}

bool sameTurn(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b, double tolerance)
{
  return (a.toRotationMatrix() - b.toRotationMatrix()).norm() <= tolerance;
}

} // namespace

TEST(RegionGizmo, EveryHandleCanBeTakenSomewhere)
{
  const GizmoLayout layout = layoutGizmo(camera(), egg());
  for (const GizmoHandle& handle : allHandles())
    EXPECT_TRUE(placeOf(layout, handle)) << static_cast<int>(handle.kind) << ' ' << handle.axis;
  EXPECT_FALSE(handleAt(layout, Vector2d(3, 3)));
}

// Seen from the front, the y axis points at the eye: its ends lie on the centre and would hide it.
TEST(RegionGizmo, AnAxisThatPointsAtTheEyeHasNoHandles)
{
  GizmoShape ball;
  ball.ellipsoid.semiAxes.setConstant(0.04);
  const GizmoLayout layout = layoutGizmo(camera(0.0, 0.0), ball);
  EXPECT_FALSE(spotOf(layout, {HandleKind::Stretch, 1, 1}));
  EXPECT_EQ(layout.arrows.size(), 2u);
  EXPECT_EQ(handleAt(layout, {400, 300}).kind, HandleKind::Move);
}

TEST(RegionGizmo, NothingIsThereBehindTheEye)
{
  GizmoShape behind = egg();
  behind.ellipsoid.centre = 2.0 * camera().eye();
  EXPECT_FALSE(handleAt(layoutGizmo(camera(), behind), {400, 300}));
  EXPECT_TRUE(layoutGizmo(camera(), behind).spots.empty());
}

// The point of the axis that was under the mouse stays under it, to a pixel (in fact to rounding), for
// perspective and parallel views.
TEST(RegionGizmo, AnArrowMovesAlongItsAxisWithTheMouse)
{
  for (const bool parallel : {false, true}) {
    Camera eye = camera();
    eye.setOrthographic(parallel);
    const GizmoShape start = egg();
    for (int axis = 0; axis < 3; ++axis) {
      const GizmoLayout layout = layoutGizmo(eye, start);
      const GizmoHandle handle{HandleKind::Slide, axis, 1};
      const Vector2d at = *placeOf(layout, handle);
      const Vector3d direction = start.ellipsoid.rotation * Vector3d::Unit(axis);
      const Vector3d taken =
        start.ellipsoid.centre + *wayOnLine(eye, at, start.ellipsoid.centre, direction) * direction;
      const Vector2d along = (eye.project(start.ellipsoid.centre + 0.01 * direction).pixel -
                              eye.project(start.ellipsoid.centre).pixel)
                               .normalized();
      GizmoDrag drag(eye, handle, start, at);
      const GizmoShape moved = drag.to(at + 25.0 * along);
      const Vector3d way = moved.ellipsoid.centre - start.ellipsoid.centre;
      EXPECT_LT(way.cross(direction).norm(), 1e-12) << "along the axis";
      EXPECT_GT(way.dot(direction), 0.0);
      EXPECT_NEAR((eye.project(taken + way).pixel - eye.project(taken).pixel).norm(), 25.0, 1e-6);
      EXPECT_EQ(moved.ellipsoid.semiAxes, start.ellipsoid.semiAxes);
      EXPECT_EQ(moved.falloff, start.falloff);
    }
  }
}

TEST(RegionGizmo, TheCentreFollowsTheMouseInThePlaneOfTheScreen)
{
  const GizmoShape start = egg();
  const Vector2d at = camera().project(start.ellipsoid.centre).pixel + Vector2d(3, -2);
  GizmoDrag drag(camera(), {HandleKind::Move, 0, 1}, start, at);
  EXPECT_LT((drag.to(at).ellipsoid.centre - start.ellipsoid.centre).norm(), 1e-12) << "no jump";
  const Vector3d centre = drag.to(at + Vector2d(40, 30)).ellipsoid.centre;
  EXPECT_NEAR((centre - start.ellipsoid.centre).dot(camera().backward()), 0.0, 1e-12);
  const Vector2d way = camera().project(centre).pixel - camera().project(start.ellipsoid.centre).pixel;
  EXPECT_LT((way - Vector2d(40, 30)).norm(), 1e-6);
}

// Once around in 24 drags of 15 degrees each: the turns add up to none. 1e-12 is rounding.
TEST(RegionGizmo, ATurnOf360DegreesInStepsGivesTheSameEllipsoid)
{
  const GizmoShape start = egg();
  const Camera eye = camera(2.6, 0.6); // sees no ring from its edge
  for (int axis = 0; axis < 3; ++axis) {
    GizmoShape shape = start;
    const Vector3d normal = start.ellipsoid.rotation * Vector3d::Unit(axis);
    const Vector3d arm = 0.06 * normal.unitOrthogonal();
    const double step = std::numbers::pi / 12.0;
    const auto pixel = [&](int i) {
      return eye.project(start.ellipsoid.centre + Eigen::AngleAxisd(i * step, normal) * arm).pixel;
    };
    for (int i = 0; i < 24; ++i) {
      GizmoDrag drag(eye, {HandleKind::Turn, axis, 1}, shape, pixel(i));
      shape = drag.to(pixel(i + 1));
      EXPECT_NEAR(drag.angle(), step, 1e-9);
    }
    EXPECT_TRUE(sameTurn(shape.ellipsoid.rotation, start.ellipsoid.rotation, 1e-12));
    EXPECT_EQ(shape.ellipsoid.centre, start.ellipsoid.centre);
    EXPECT_EQ(shape.ellipsoid.semiAxes, start.ellipsoid.semiAxes);

    GizmoDrag once(eye, {HandleKind::Turn, axis, 1}, start, pixel(0)); // and in one drag of many moves
    for (int i = 1; i <= 24; ++i) once.to(pixel(i));
    EXPECT_TRUE(sameTurn(once.shape().ellipsoid.rotation, start.ellipsoid.rotation, 1e-12));
  }
}

// From the front, the ring about z is a line: a drag to the right turns its near side to the right.
TEST(RegionGizmo, ARingSeenFromItsEdgeStillTurns)
{
  GizmoShape ball;
  ball.ellipsoid.semiAxes = {0.04, 0.03, 0.02};
  const Camera eye = camera(0.0, 0.0);
  GizmoDrag drag(eye, {HandleKind::Turn, 2, 1}, ball, {400, 300});
  const GizmoShape turned = drag.to({420, 300});
  EXPECT_GT(drag.angle(), 0.05);
  const Vector3d near = turned.ellipsoid.rotation * Vector3d(0, -0.03, 0); // looked at the eye before
  EXPECT_GT(near.x(), 0.0);
  EXPECT_NEAR(near.z(), 0.0, 1e-15);
}

TEST(RegionGizmo, TheEndOfAnAxisFollowsTheMouseAndTheCentreStays)
{
  const GizmoShape start = egg();
  const GizmoLayout layout = layoutGizmo(camera(), start);
  for (int axis = 0; axis < 3; ++axis)
    for (const int side : {1, -1}) {
      const GizmoHandle handle{HandleKind::Stretch, axis, side};
      const Vector2d at = *spotOf(layout, handle);
      const Vector2d outward = (at - camera().project(start.ellipsoid.centre).pixel).normalized();
      GizmoDrag drag(camera(), handle, start, at);
      const GizmoShape larger = drag.to(at + 20.0 * outward);
      EXPECT_GT(larger.ellipsoid.semiAxes[axis], start.ellipsoid.semiAxes[axis]);
      EXPECT_EQ(larger.ellipsoid.centre, start.ellipsoid.centre);
      EXPECT_EQ(larger.ellipsoid.semiAxes[(axis + 1) % 3], start.ellipsoid.semiAxes[(axis + 1) % 3]);
      const Vector2d end = *spotOf(layoutGizmo(camera(), larger), handle);
      EXPECT_LT((end - at - 20.0 * outward).norm(), 1e-6);

      const GizmoShape scaled = drag.to(at + 20.0 * outward, true);
      const Vector3d factor = scaled.ellipsoid.semiAxes.cwiseQuotient(start.ellipsoid.semiAxes);
      EXPECT_NEAR(factor.maxCoeff() - factor.minCoeff(), 0.0, 1e-12);
      EXPECT_NEAR(scaled.ellipsoid.semiAxes[axis], larger.ellipsoid.semiAxes[axis], 1e-12);
      EXPECT_EQ(scaled.ellipsoid.centre, start.ellipsoid.centre);
    }
}

TEST(RegionGizmo, TheInnerShellIsDraggedBetweenTheCentreAndTheSurface)
{
  const GizmoShape start = egg();
  const GizmoHandle handle{HandleKind::Falloff, 0, 1};
  const Vector2d at = *spotOf(layoutGizmo(camera(), start), handle);
  const Vector2d centre = camera().project(start.ellipsoid.centre).pixel;
  GizmoDrag drag(camera(), handle, start, at);
  EXPECT_NEAR(drag.to(at).falloff, 0.4, 1e-12);
  EXPECT_EQ(drag.to(centre - (at - centre)).falloff, 1.0);
  EXPECT_EQ(drag.to(at + 3.0 * (at - centre)).falloff, 0.0);
  const Vector2d half = centre + 0.5 * (at - centre);
  const GizmoShape wider = drag.to(half);
  EXPECT_GT(wider.falloff, 0.6);
  EXPECT_LT((*spotOf(layoutGizmo(camera(), wider), handle) - half).norm(), 1e-6);
  EXPECT_EQ(wider.ellipsoid.centre, start.ellipsoid.centre);
}

// Whatever the mouse does, the region stays one that the tissue accepts.
TEST(RegionGizmo, RandomDragsGiveFiniteEllipsoids)
{
  std::mt19937_64 random(7);
  const auto between = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53; // equal on every library
  };
  const std::vector<GizmoHandle> handles = allHandles();
  for (int round = 0; round < 1000; ++round) {
    Camera eye = camera(between(-4.0, 4.0), between(-1.57, 1.57));
    eye.setOrthographic(round % 3 == 0);
    const auto pixel = [&] { return Vector2d(between(-3000, 4000), between(-3000, 4000)); };
    GizmoShape shape = egg();
    if (round % 5 == 0) shape.ellipsoid.semiAxes = {1e-4, 3.0, 1e-3};
    if (round % 7 == 0) shape.ellipsoid.centre = eye.eye();
    for (int drags = 0; drags < 3; ++drags) {
      const std::size_t which = random() % handles.size();
      GizmoDrag drag(eye, handles[which], shape, pixel());
      for (int moves = 0; moves < 3; ++moves) shape = drag.to(pixel(), moves == 1);
      const Ellipsoid& e = shape.ellipsoid;
      ASSERT_TRUE(e.centre.allFinite() && e.semiAxes.allFinite() && e.rotation.coeffs().allFinite());
      ASSERT_GE(e.semiAxes.minCoeff(), GizmoDrag::kLeastSemiAxis * (1.0 - 1e-12));
      ASSERT_NEAR(e.rotation.norm(), 1.0, 1e-12);
      ASSERT_TRUE(shape.falloff >= 0.0 && shape.falloff <= 1.0);
    }
  }
}
