// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/viewport/picker.h"
#include "tests/app/viewport/sample_nets.h"

#include <gtest/gtest.h>

using namespace esm;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

Camera fromTheFront()
{
  Camera camera;
  camera.setViewport(800, 600);
  camera.setScene(Vector3d::Zero(), 0.05);
  camera.setPose(Vector3d::Zero(), 0.2, 0.0, 0.0); // eye at y = -0.2
  return camera;
}

} // namespace

TEST(HitTriangle, GivesTheDistanceFromEitherSide)
{
  const Vector3d a(0, 0, 1), b(1, 0, 1), c(0, 1, 1);
  const Vector3d inside(0.2, 0.3, 0.0);
  EXPECT_NEAR(*hitTriangle({inside, Vector3d::UnitZ()}, a, b, c), 1.0, 1e-15);
  EXPECT_NEAR(*hitTriangle({inside, Vector3d::UnitZ()}, a, c, b), 1.0, 1e-15);
  EXPECT_FALSE(hitTriangle({inside, -Vector3d::UnitZ()}, a, b, c)) << "behind the start";
  EXPECT_FALSE(hitTriangle({Vector3d(0.6, 0.6, 0.0), Vector3d::UnitZ()}, a, b, c)) << "beside";
  EXPECT_FALSE(hitTriangle({Vector3d(-1, 0, 1), Vector3d::UnitX()}, a, b, c)) << "in its plane";
}

// Front pole (-y) and back pole (+y) of a sphere share a pixel: only the front one is meant.
TEST(PickNode, TheBackOfASphereIsNotPicked)
{
  const auto net = samples::sphere(3, 0.04);
  EXPECT_EQ(pickNode(fromTheFront(), net->restPosition, net->triangles, {400, 300}, 12.0), 3);
}

// Every node that faces the eye can be picked at its own pixel, none that looks away.
TEST(PickNode, EachNodeOfTheFrontAndNoneOfTheBack)
{
  const auto net = samples::sphere(2, 0.04);
  const Camera camera = fromTheFront();
  for (Index i = 0; i < net->nodeCount(); ++i) {
    const Vector3d at = net->restPosition.col(i);
    const double facing = at.normalized().dot((camera.eye() - at).normalized());
    const Index picked = pickNode(camera, net->restPosition, net->triangles, camera.project(at).pixel, 12.0);
    if (facing > 0.2) {
      EXPECT_EQ(picked, i);
    } else if (facing < -0.2) {
      EXPECT_NE(picked, i);
    }
  }
}

TEST(PickNode, BesideTheSurfaceOnlyWithinTheRadius)
{
  const auto net = samples::sphere(0, 0.04); // an octahedron
  const Camera camera = fromTheFront();
  const Vector2d top = camera.project(Vector3d(0.0, 0.0, 0.04)).pixel;
  const Index node = pickNode(camera, net->restPosition, net->triangles, top, 12.0);
  ASSERT_NE(node, kNoIndex);
  EXPECT_EQ(pickNode(camera, net->restPosition, net->triangles, top + Vector2d(0.0, -11.5), 12.0), node);
  EXPECT_EQ(pickNode(camera, net->restPosition, net->triangles, top + Vector2d(0.0, -12.5), 12.0), kNoIndex);
}

// A coarse mesh, or one that is near: no node is within the radius where a hand takes hold of the surface.
TEST(PickNode, AnywhereOnATriangleItsNearestCorner)
{
  const auto net = samples::sphere(0, 0.04);
  const Camera camera = fromTheFront();
  int held = 0;
  for (Eigen::Index t = 0; t < net->triangles.cols(); ++t) {
    const auto corner = [&](int i) -> Vector3d { return net->restPosition.col(net->triangles(i, t)); };
    for (int i = 0; i < 3; ++i) {
      const Vector3d at = 0.5 * corner(i) + 0.25 * (corner((i + 1) % 3) + corner((i + 2) % 3));
      if (at.y() > -0.005) continue; // of the back
      EXPECT_EQ(pickNode(camera, net->restPosition, net->triangles, camera.project(at).pixel, 12.0),
                net->triangles(i, t));
      ++held;
    }
  }
  EXPECT_EQ(held, 12);
}

// Without a surface nothing hides, but a node in front still goes before one far behind it, even if the click
// was a little nearer to that one.
TEST(PickNode, BareSpringsPreferTheFront)
{
  Eigen::Matrix3Xd position(3, 2);
  position.col(0) = Vector3d(0.0, 0.04, 0.0);    // behind, in the middle
  position.col(1) = Vector3d(0.001, -0.04, 0.0); // in front, a few pixels beside
  EXPECT_EQ(pickNode(fromTheFront(), position, TriangleMatrix(3, 0), {400, 300}, 12.0), 1);
}

// Every spring that faces the eye can be picked at its own middle, none that looks away: a surface's own edge
// does not hide it.
TEST(PickSpring, EachSpringOfTheFrontAndNoneOfTheBack)
{
  const auto net = samples::sphere(1, 0.04);
  const Camera camera = fromTheFront();
  int front = 0;
  for (Index s = 0; s < net->springCount(); ++s) {
    const Vector3d at =
      0.5 * (net->restPosition.col(net->ends(0, s)) + net->restPosition.col(net->ends(1, s)));
    const double facing = at.normalized().dot((camera.eye() - at).normalized());
    const Index picked =
      pickSpring(camera, net->restPosition, net->ends, net->triangles, camera.project(at).pixel, 12.0);
    if (facing > 0.3) {
      EXPECT_EQ(picked, s);
      ++front;
    } else if (facing < -0.3) {
      EXPECT_NE(picked, s);
    }
  }
  EXPECT_GT(front, 5);
}

// Tiles of the screen only save work: each node of the box is found exactly if no triangle at all hides it.
TEST(NodesInBox, FindsWhatPickingFindsNodeByNode)
{
  const auto net = samples::sphere(3, 0.04);
  const Camera camera = fromTheFront();
  const Eigen::AlignedBox2d box(Vector2d(310, 210), Vector2d(520, 370));
  const std::vector<Index> found = nodesInBox(camera, net->restPosition, net->triangles, box);
  std::vector<Index> expected;
  for (Index i = 0; i < net->nodeCount(); ++i) {
    const Vector2d pixel = camera.project(net->restPosition.col(i)).pixel;
    if (box.contains(pixel) && pickNode(camera, net->restPosition, net->triangles, pixel, 0.01) == i)
      expected.push_back(i);
  }
  EXPECT_GT(expected.size(), 10u);
  EXPECT_EQ(found, expected);
  for (const Index node : found) EXPECT_LT(net->restPosition(1, node), 0.0) << "on the side that is seen";
}

TEST(NodesInBox, WithoutASurfaceNothingHides)
{
  const auto net = samples::sphere(2, 0.04);
  const Eigen::AlignedBox2d all(Vector2d(0, 0), Vector2d(800, 600));
  const auto found = nodesInBox(fromTheFront(), net->restPosition, TriangleMatrix(3, 0), all);
  EXPECT_EQ(found.size(), static_cast<std::size_t>(net->nodeCount()));
  EXPECT_TRUE(nodesInBox(fromTheFront(), net->restPosition, net->triangles, {}).empty());
}

// The eye is inside: triangles that reach behind it can hide too, and nothing breaks.
TEST(NodesInBox, FromWithinTheNet)
{
  const auto net = samples::sphere(2, 0.3);
  const Eigen::AlignedBox2d all(Vector2d(0, 0), Vector2d(800, 600));
  const auto found = nodesInBox(fromTheFront(), net->restPosition, net->triangles, all);
  EXPECT_GT(found.size(), 3u);
  for (const Index node : found) EXPECT_GT(net->restPosition(1, node), -0.2);
}
