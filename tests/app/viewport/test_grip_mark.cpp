// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/viewport/grip_mark.h"
#include "app/viewport/scene_model.h"
#include "core/contact/node_patch.h"
#include "tests/app/viewport/sample_nets.h"

#include <gtest/gtest.h>

#include <map>

using namespace esm;

namespace {

Eigen::Vector3d placeOf(const GripMark::Place& place, const Eigen::Matrix3Xd& position)
{
  return position.col(place.from) + place.share * (position.col(place.to) - position.col(place.from));
}

double lengthOf(const GripMark::Outline& outline, const Eigen::Matrix3Xd& position)
{
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < outline.size(); i += 2)
    sum += (placeOf(outline[i], position) - placeOf(outline[i + 1], position)).norm();
  return sum;
}

} // namespace

// The rim lies on the surface at the radius, is closed, and as long as the circle that a ball cuts out of a sphere;
// it follows the radius.
TEST(GripMark, TheOutlineIsARingAtTheRadius)
{
  const auto net = samples::sphere(5, 0.05);
  const Eigen::Matrix3Xd& position = net->restPosition;
  GripMark mark;
  mark.setNet(net);
  EXPECT_TRUE(mark.outline(position, 4).empty()) << "one node alone";
  for (const double radius : {0.008, 0.02}) {
    EXPECT_TRUE(mark.setRadius(radius));
    EXPECT_FALSE(mark.setRadius(radius));
    const GripMark::Outline outline = mark.outline(position, 4);
    ASSERT_GT(outline.size(), 20u);
    std::map<std::pair<Index, Index>, int> met; // each edge that is cut ends two pieces
    for (const GripMark::Place& place : outline) {
      EXPECT_NEAR((placeOf(place, position) - position.col(4)).norm(), radius, 2e-4);
      ++met[std::minmax(place.from, place.to)];
    }
    for (const auto& [edge, count] : met) EXPECT_EQ(count, 2);
    const double across = radius * std::sqrt(1.0 - std::pow(radius / 0.1, 2)); // of the circle
    EXPECT_NEAR(lengthOf(outline, position), 2.0 * M_PI * across, 0.02 * M_PI * across);
  }
}

// What lies near but does not hang together with the node there is no part: the opposite wall of a thin organ.
TEST(GripMark, TheOutlineStaysOnTheNodesOwnWall)
{
  const auto net = samples::ball(5, [](const Eigen::Vector3d& u) -> Eigen::Vector3d {
    return {0.05 * u.x(), 0.05 * u.y(), 0.002 * u.z()};
  });
  GripMark mark;
  mark.setNet(net);
  mark.setRadius(0.01);
  const GripMark::Outline outline = mark.outline(net->restPosition, 4);
  ASSERT_FALSE(outline.empty());
  for (const GripMark::Place& place : outline) EXPECT_GT(placeOf(place, net->restPosition).z(), 0.0);
}

// While it holds, the rim is material and goes with the tissue; the shares are those of the hold, whatever radius
// is chosen for the next one.
TEST(GripMark, WhatIsHeldKeepsItsSharesAndItsRim)
{
  const auto net = samples::sphere(4, 0.05);
  SceneModel model;
  model.setNet(net, 7);
  model.setGripRadius(0.01);
  PatchFinder finder(*net);
  std::vector<PatchNode> patch;
  finder.find(net->restPosition, 4, 0.01, patch);
  SimSnapshot snapshot = samples::restSnapshot(*net, 7, 2);
  snapshot.grabbedNode = 4;
  for (const PatchNode& one : patch) snapshot.heldNodes.push_back(one.node);
  for (const PatchNode& one : patch)
    snapshot.position.col(one.node).z() += 0.03 * one.share; // it has moved already
  ASSERT_TRUE(model.setSnapshot(snapshot));
  ASSERT_EQ(model.grip().heldShares().size(), patch.size());
  for (std::size_t i = 0; i < patch.size(); ++i)
    EXPECT_NEAR(model.grip().heldShares()[i], std::max(patch[i].share, 0.02), 1e-12);
  const GripMark::Outline before = model.grip().heldOutline();
  ASSERT_FALSE(before.empty());
  for (const GripMark::Place& place : before) EXPECT_GT(placeOf(place, model.position()).z(), 0.055);
  model.setGripRadius(0.02);
  snapshot.sequence = 3;
  snapshot.position.row(2).array() += 0.01;
  ASSERT_TRUE(model.setSnapshot(snapshot));
  EXPECT_EQ(model.grip().heldOutline().size(), before.size());
  snapshot.sequence = 4;
  snapshot.grabbedNode = kNoIndex;
  model.setSnapshot(snapshot);
  EXPECT_TRUE(model.grip().heldOutline().empty());
  EXPECT_EQ(model.grip().heldNode(), kNoIndex);
}
