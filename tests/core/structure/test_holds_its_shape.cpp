// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/simulation.h"
#include "core/geometry/distance.h"
#include "core/quality/poke.h"
#include "core/quality/quality.h"
#include "core/structure/material.h"
#include "core/structure/support.h"
#include "tests/core/structure/bodies.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace esm {
namespace {

using test::bodyOf;
using test::kFittedSolid;
using test::kFittedWall;
using test::organMesh;
using test::tubeMesh;
using test::volumeWithin;
using Interior = SupportOptions::Interior;

void fixEnds(SpringNet& net, int axis, bool both)
{
  const double low = net.restPosition.row(axis).minCoeff(), high = net.restPosition.row(axis).maxCoeff();
  for (Index node = 0; node < net.nodeCount(); ++node) {
    const double share = (net.restPosition(axis, node) - low) / (high - low);
    if (share < 0.05 || (both && share > 0.95)) net.fixed[static_cast<std::size_t>(node)] = 1;
  }
}

Index nearestNode(const SpringNet& net, const Eigen::Vector3d& place)
{
  return nearestOf(net.restPosition, place);
}

struct Story {
  double leastVolume = 1.0, mostVolume = 1.0; ///< over the volume at rest, from start to end
  double depth = 0.0;                         ///< of the poke [m]
  double left = 0.0, speed = 0.0; ///< at the end: distance from where gravity alone had it, velocity
};

/// Gravity from the start; from 1.5 s on a poke of 0.1 N along -y that rises for 0.2 s and is taken away
/// at 2.5 s; then `rest` seconds.
Story live(const SpringNet& net, Index node, double rest)
{
  Loads loads;
  loads.gravity = {0, 0, -9.81};
  const Eigen::Matrix3Xd poke = pokePatch(net, net.restPosition.col(node), {0, -0.1, 0}, 0.008);
  for (Index i = 0; i < net.nodeCount(); ++i) {
    if (poke.col(i).isZero(0.0)) continue;
    NodalForce force{{i}, {{1.5, 1.7, 2.5, 2.5}, Eigen::Matrix3Xd::Zero(3, 4)}};
    force.force.value.col(1) = force.force.value.col(2) = poke.col(i);
    loads.forces.push_back(force);
  }
  auto simulation = Simulation::create(net, loads, {});
  Story story;
  if (!simulation) {
    ADD_FAILURE() << simulation.error().detail;
    return story;
  }
  const double whole = volumeWithin(net.triangles, net.restPosition);
  Eigen::Matrix3Xd hanging;
  const int frames = static_cast<int>(60.0 * (2.5 + rest));
  for (int frame = 1; frame <= frames; ++frame) {
    if (!simulation->advance(1.0 / 60.0).good()) {
      ADD_FAILURE() << simulation->why();
      return story;
    }
    const Eigen::Matrix3Xd& now = simulation->state().position;
    const double volume = volumeWithin(net.triangles, now) / whole;
    story.leastVolume = std::min(story.leastVolume, volume);
    story.mostVolume = std::max(story.mostVolume, volume);
    if (frame == 90) hanging = now;
    if (frame == 149) story.depth = (now.col(node) - hanging.col(node)).norm();
  }
  story.left = (simulation->state().position - hanging).colwise().norm().maxCoeff();
  story.speed = simulation->state().velocity.colwise().norm().maxCoeff();
  std::printf("  volume %.4f to %.4f, poke %.2f mm, left %.4f mm, speed %.1e m/s\n", story.leastVolume,
              story.mostVolume, 1e3 * story.depth, 1e3 * story.left, story.speed);
  return story;
}

void expectHolds(const Story& story)
{
  EXPECT_GT(story.leastVolume, 0.9);
  EXPECT_LT(story.mostVolume, 1.1);
  EXPECT_GT(story.depth, 2e-4); // the poke was felt
  EXPECT_LT(story.left, 0.05 * story.depth);
  EXPECT_LT(story.speed, 0.01);
}

bool warns(const SpringNet& net)
{
  const auto report = judgeNet(net);
  return report && !report->carriesLoad();
}

TEST(HoldsItsShape, ATubeWithStrutsUnderGravityAndAPoke)
{
  const Mesh mesh = tubeMesh(0.008, 0.05, 12, 14);
  SpringNet net = bodyOf(mesh, Interior::Struts, kFittedWall);
  fixEnds(net, 2, true);
  EXPECT_FALSE(warns(net));
  expectHolds(live(net, nearestNode(net, {0, 0.008, 0.025}), 1.5));
}

TEST(HoldsItsShape, AClosedOrganWithStrutsUnderGravityAndAPoke)
{
  const Mesh mesh = organMesh({0.03, 0.02, 0.018}, 5);
  SpringNet net = bodyOf(mesh, Interior::Struts, kFittedSolid);
  fixEnds(net, 2, false);
  EXPECT_FALSE(warns(net));
  expectHolds(live(net, nearestNode(net, {0, 0.02, 0}), 2.5));
}

// The same bodies without anything inside: the report warns before, and rightly so: they lose more than a
// tenth of their volume.
TEST(HoldsItsShape, WithoutStrutsTheReportWarnsAndTheBodiesCollapse)
{
  SpringNet tube = bodyOf(tubeMesh(0.008, 0.05, 12, 14), Interior::None, kFittedWall);
  fixEnds(tube, 2, true);
  EXPECT_TRUE(warns(tube));
  EXPECT_LT(live(tube, nearestNode(tube, {0, 0.008, 0.025}), 0.0).leastVolume, 0.9);
  SpringNet organ = bodyOf(organMesh({0.03, 0.02, 0.018}, 5), Interior::None, {});
  fixEnds(organ, 2, false);
  EXPECT_TRUE(warns(organ));
  EXPECT_LT(live(organ, nearestNode(organ, {0, 0.02, 0}), 0.0).leastVolume, 0.9);
}

} // namespace
} // namespace esm
