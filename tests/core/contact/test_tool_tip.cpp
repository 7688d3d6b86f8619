// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/contact/tool_tip.h"

#include "core/net/net_builder.h"
#include "core/runtime/sim_runner.h"

#include "tests/core/contact/hanging_chain.h"
#include "tests/support/patch_between.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>

namespace esm {

namespace {

constexpr Index kSide = 11;

/// A sheet of 11 x 11 nodes, 1 cm apart, in the plane z = 0, its normals up, tied to its place.
SpringNet sheet()
{
  Mesh mesh;
  mesh.position.resize(3, kSide * kSide);
  std::vector<Eigen::Matrix<Index, 3, 1>> triangles;
  for (Index i = 0; i < kSide * kSide; ++i) {
    const Index x = i % kSide, y = i / kSide;
    mesh.position.col(i) = Eigen::Vector3d(0.01 * x, 0.01 * y, 0.0);
    if (x + 1 == kSide || y + 1 == kSide) continue;
    triangles.emplace_back(i, i + 1, i + kSide + 1);
    triangles.emplace_back(i, i + kSide + 1, i + kSide);
  }
  SpringNet net;
  std::vector<std::pair<Index, Index>> ends;
  for (Index i = 0; i < kSide * kSide; ++i) {
    if ((i + 1) % kSide != 0) ends.emplace_back(i, i + 1);
    if (i + kSide < kSide * kSide) ends.emplace_back(i, i + kSide);
    if ((i + 1) % kSide != 0 && i + kSide + 1 < kSide * kSide) ends.emplace_back(i, i + kSide + 1);
  }
  resizeNet(net, kSide * kSide, static_cast<Index>(ends.size()));
  net.restPosition = mesh.position;
  net.triangles.resize(3, static_cast<Index>(triangles.size()));
  for (std::size_t t = 0; t < triangles.size(); ++t) net.triangles.col(static_cast<Index>(t)) = triangles[t];
  for (Index s = 0; s < net.springCount(); ++s) {
    const auto [a, b] = ends[static_cast<std::size_t>(s)];
    net.ends.col(s) << a, b;
    net.restLength[s] = (mesh.position.col(a) - mesh.position.col(b)).norm();
  }
  net.stiffness.setConstant(100.0);
  net.viscosity.setConstant(0.3);
  net.mass.setConstant(0.001);
  net.anchors.point = net.restPosition;
  net.anchors.stiffness.setConstant(net.nodeCount(), 10.0);
  net.anchors.viscosity.setConstant(net.nodeCount(), 0.1);
  for (Index i = 0; i < net.nodeCount(); ++i) net.anchors.node.push_back(i);
  return net;
}

constexpr double kRadius = 0.003;

/// Crossings from below less crossings from above on the way to the sky: 0 on the upper side of a sheet,
/// however it is folded.
int netCrossings(const DeformingSurface& surface, Eigen::Vector3d from)
{
  const Eigen::Vector3d sky = from + Eigen::Vector3d::UnitZ();
  int count = 0;
  while (const auto hit = surface.firstHit(from, sky, false)) {
    const Eigen::Vector3d a = surface.corner(hit->triangle, 0);
    const double up = (surface.corner(hit->triangle, 1) - a).cross(surface.corner(hit->triangle, 2) - a).z();
    count += up > 0.0 ? 1 : -1;
    from = surface.pointAt(*hit) + 1e-9 * Eigen::Vector3d::UnitZ();
  }
  return count;
}

/// A tip that has come to `hand` from 2 cm above it.
ToolTip tipAt(const SpringNet& net, const NetState& state, const Eigen::Vector3d& hand)
{
  ToolTip tip(net, kRadius, 5.0);
  tip.moveTo({hand.x(), hand.y(), 0.02}, Eigen::Vector3d::Zero());
  tip.update(state);
  tip.moveTo(hand, Eigen::Vector3d::Zero());
  tip.update(state);
  return tip;
}

} // namespace

TEST(ToolTip, FarFromTheSurfaceThereIsNothing)
{
  const SpringNet net = sheet();
  const NetState state = atRest(net);
  ToolTip tip(net, kRadius, 5.0);
  tip.moveTo({0.05, 0.05, 0.1}, Eigen::Vector3d::Zero());
  tip.update(state);
  EXPECT_FALSE(tip.isNear());
  EXPECT_FALSE(tip.contactModel(state, Eigen::Matrix3d::Identity()).active);
  EXPECT_EQ(tip.proxy(), Eigen::Vector3d(0.05, 0.05, 0.1));
}

// 1 cm above: the servo gets the plane z = r, on which it will push with the stiffness of the place, and
// until then nothing.
TEST(ToolTip, ASurfaceIsAnnouncedBeforeItIsMet)
{
  const SpringNet net = sheet();
  const NetState state = atRest(net);
  ToolTip tip(net, kRadius, 5.0);
  tip.moveTo({0.052, 0.053, 0.01}, Eigen::Vector3d::Zero());
  tip.update(state);
  ASSERT_TRUE(tip.isNear());
  EXPECT_FALSE(tip.touches());
  const ContactModel model = tip.contactModel(state, 0.01 * Eigen::Matrix3d::Identity());
  EXPECT_TRUE(model.active);
  EXPECT_TRUE(model.force.isZero(0.0));
  EXPECT_TRUE(model.normal.isApprox(Eigen::Vector3d::UnitZ(), 1e-12));
  EXPECT_TRUE(model.position.isApprox(Eigen::Vector3d(0.052, 0.053, kRadius), 1e-12));
  EXPECT_GT(model.stiffness(2, 2), 50.0); // the tool's in series with 100 N/m
  EXPECT_NEAR(model.stiffness(0, 0), 0.0, 1e-12);
}

// Pressed 2 mm beyond contact: pushed straight back, and the three springs pull the contact point with the
// same.
TEST(ToolTip, APressedTipIsPushedBackAlongTheNormal)
{
  const SpringNet net = sheet();
  const NetState state = atRest(net);
  ToolTip tip = tipAt(net, state, {0.052, 0.053, kRadius - 0.002});
  ASSERT_TRUE(tip.touches());
  EXPECT_TRUE(tip.proxy().isApprox(Eigen::Vector3d(0.052, 0.053, kRadius), 1e-9));
  const Eigen::Vector3d force = tip.forceOnHand(state);
  EXPECT_GT(force.z(), 0.5);
  EXPECT_NEAR(force.head<2>().norm(), 0.0, 1e-9);
  Eigen::Vector3d onNet = Eigen::Vector3d::Zero();
  for (const ToolSpring& spring : tip.springs(state))
    onNet += spring.stiffness * (spring.target - state.position.col(spring.node));
  EXPECT_TRUE(onNet.isApprox(-force, 1e-9));
  const ContactModel model = tip.contactModel(state, Eigen::Matrix3d::Zero());
  EXPECT_TRUE(model.force.isApprox(force, 1e-9));
}

// On a mesh finer than the ball the push is shared by all that the ball covers, and acts as if at the contact
// point: it is the hand's, and turns nothing about that point. Also on a curved sheet.
TEST(ToolTip, APressOnManyNodesActsAsIfAtTheContactPoint)
{
  for (const double curved : {0.0, 1.0 / 0.03}) {
    SpringNet net = sheet();
    net.restPosition *= 0.15; // edges of 1.5 mm
    const Eigen::Vector3d middle(0.0075, 0.0075, 0.0);
    for (Index i = 0; i < net.nodeCount(); ++i)
      net.restPosition(2, i) = -0.5 * curved * (net.restPosition.col(i) - middle).squaredNorm();
    const NetState state = atRest(net);
    ToolTip tip = tipAt(net, state, {0.0078, 0.0069, kRadius - 0.001});
    ASSERT_TRUE(tip.touches());
    const DeformingSurface surface(net.triangles, net.restPosition);
    const Eigen::Vector3d place = surface.pointAt(*surface.nearest(tip.proxy()));
    const Eigen::Vector3d force = tip.forceOnHand(state);
    Eigen::Vector3d onNet = Eigen::Vector3d::Zero(), torque = Eigen::Vector3d::Zero();
    double most = 0.0;
    const std::span<const ToolSpring> springs = tip.springs(state);
    for (const ToolSpring& spring : springs) {
      const Eigen::Vector3d pull = spring.stiffness * (spring.target - state.position.col(spring.node));
      onNet += pull;
      torque += (state.position.col(spring.node) - place).cross(pull);
      most = std::max(most, pull.norm());
    }
    EXPECT_GT(springs.size(), 30u);
    EXPECT_LT(most, 0.12 * force.norm());
    EXPECT_TRUE(onNet.isApprox(-force, 1e-9));
    // Under the curve the nodes' mean is 0.24 mm below the point; a tenth of the force is drag.
    EXPECT_LT(torque.norm(), (curved > 0.0 ? 6e-5 : 1e-9) * force.norm()) << curved;
  }
}

// 0.1 m in one frame, a hundred times the thickness of a sheet that has none: the proxy stays above.
TEST(ToolTip, AThinSheetIsNotJumpedThrough)
{
  const SpringNet net = sheet();
  const NetState state = atRest(net);
  ToolTip tip = tipAt(net, state, {0.042, 0.053, -0.1});
  ASSERT_TRUE(tip.touches());
  EXPECT_NEAR(tip.proxy().z(), kRadius, 1e-9);
  EXPECT_NEAR(tip.forceOnHand(state).norm(), 5.0, 1e-9); // the limit
  tip.moveTo({0.042, 0.053, 0.01}, Eigen::Vector3d::Zero());
  tip.update(state);
  EXPECT_FALSE(tip.touches());
  EXPECT_TRUE(tip.forceOnHand(state).isZero(0.0));
}

// A hand that comes out fast is without force at once, but keeps its hold of the tissue for a moment: let go
// of within a frame, the light tissue would have come back into the ball by the next one, deeper than it ever
// was.
TEST(ToolTip, TissueComesAfterAHandThatLeavesInsteadOfSnappingBackIntoIt)
{
  const SpringNet net = sheet();
  NetState state = atRest(net);
  ToolTip tip = tipAt(net, state, {0.05, 0.05, kRadius - 0.002});
  ASSERT_TRUE(tip.touches());
  const auto outAfter = [&](double time) {
    state.time = time;
    tip.moveTo({0.05, 0.05, kRadius + 0.002}, Eigen::Vector3d::Zero());
    tip.update(state);
    EXPECT_FALSE(tip.touches());
    EXPECT_TRUE(tip.forceOnHand(state).isZero(0.0));
    return tip.pulls();
  };
  EXPECT_TRUE(outAfter(0.0));
  EXPECT_TRUE(outAfter(0.8 * ToolTip::kFollowTime));
  EXPECT_FALSE(outAfter(1.1 * ToolTip::kFollowTime)); // it stayed behind: the contact is over
}

TEST(ToolTip, AnOpenSheetIsTouchedFromBelowToo)
{
  const SpringNet net = sheet();
  const NetState state = atRest(net);
  ToolTip tip(net, kRadius, 5.0);
  for (const double z : {-0.02, 0.001}) {
    tip.moveTo({0.05, 0.05, z}, Eigen::Vector3d::Zero());
    tip.update(state);
  }
  ASSERT_TRUE(tip.touches());
  EXPECT_NEAR(tip.proxy().z(), -kRadius, 1e-9);
  EXPECT_LT(tip.forceOnHand(state).z(), 0.0);
}

// Pressed 2 mm deep and led along by 3 cm: the contact follows up to the friction cone, so the drag is 0.1 of
// the push.
TEST(ToolTip, ALedTipSlidesAlongWithinItsFrictionCone)
{
  const SpringNet net = sheet();
  const NetState state = atRest(net);
  ToolTip tip = tipAt(net, state, {0.02, 0.053, kRadius - 0.002});
  for (int i = 1; i <= 30; ++i) {
    tip.moveTo({0.02 + 0.001 * i, 0.053, kRadius - 0.002}, Eigen::Vector3d::Zero());
    tip.update(state);
    ASSERT_TRUE(tip.touches());
    const Eigen::Vector3d force = tip.forceOnHand(state);
    ASSERT_LE(force.head<2>().norm(), 1.001 * ToolTip::kFriction * force.z());
  }
  EXPECT_LT(tip.forceOnHand(state).x(), 0.0);
  EXPECT_NEAR(tip.proxy().x(), 0.05, 0.001);
}

// In motion, through the runner: a hand that circles and presses up to 8 mm deep with 1 N, by which the
// sheet does not yet fold into itself (nothing keeps it from that). The proxy is never on its other side, and
// the servo gets a model as long as there is contact.
TEST(ToolTip, TheProxyNeverPassesTheMovingSurface)
{
  TripleBuffer<ToolState> tool;
  TripleBuffer<ContactModel> contact;
  SimRunner runner(60.0, tool, contact);
  const SpringNet net = sheet();
  runner.apply(command::Load{1, net, {}, {}});
  runner.apply(command::Touch{true, kRadius, 1.0});
  runner.apply(command::FollowDevice{true});
  runner.apply(command::Play{});
  SimSnapshot picture;
  int touched = 0;
  for (int frame = 0; frame < 240; ++frame) {
    const double t = frame / 60.0;
    tool.back() = {static_cast<std::uint64_t>(frame) + 1, t,
                   Eigen::Vector3d(0.05 + 0.02 * std::cos(2.0 * t), 0.05 + 0.02 * std::sin(2.0 * t),
                                   0.004 + 0.012 * std::cos(5.0 * t)),
                   Eigen::Vector3d::Zero()};
    tool.publish();
    runner.runFrame();
    runner.draw(picture);
    ASSERT_GT(picture.tipRadius, 0.0);
    const DeformingSurface surface(net.triangles, picture.position);
    ASSERT_EQ(netCrossings(surface, picture.tipPosition), 0) << "frame " << frame;
    if (!picture.tipTouches) continue;
    ++touched;
    const ContactModel& model = contact.latest();
    ASSERT_TRUE(model.active);
    ASSERT_TRUE(model.stiffness.allFinite());
  }
  EXPECT_GT(touched, 50);
  EXPECT_LT(picture.position.row(2).minCoeff(), 0.02);
}

// Other parameters under the tip, or another limit of its force, do not end the contact; it is as stiff as on
// a net that was so from the start. The spring of a tip follows the net's stiffness around it.
TEST(ToolTip, AnEditUnderTheTipKeepsTheContact)
{
  SpringNet soft = sheet(), hard = sheet();
  hard.stiffness *= 4.0;
  hard.anchors.stiffness *= 4.0;
  const auto felt = [&](const SpringNet& first, const SpringNet& then, bool byPatch = false) {
    TripleBuffer<ToolState> tool;
    TripleBuffer<ContactModel> contact;
    SimRunner runner(60.0, tool, contact);
    runner.apply(command::Load{1, first, {}, {}});
    runner.apply(command::Touch{true, kRadius, 5.0});
    runner.apply(command::FollowDevice{true});
    runner.apply(command::Play{});
    for (int frame = 0; frame < 90; ++frame) {
      const double z = 0.006 - 0.001 * std::min(frame, 4); // 1 mm into the sheet
      tool.back() = {
        static_cast<std::uint64_t>(frame) + 1, frame / 60.0, {0.052, 0.053, z}, Eigen::Vector3d::Zero()};
      tool.publish();
      runner.runFrame();
      if (frame != 30) continue;
      EXPECT_TRUE(contact.latest().active);
      if (byPatch)
        runner.apply(command::PatchParameters{
          {std::make_shared<const ParameterPatch>(test::patchBetween(first, then))}});
      else
        runner.apply(command::SetParameters{then});
      runner.apply(command::Touch{true, kRadius, 2.0}); // what the window says of another limit
      EXPECT_TRUE(contact.latest().active);
    }
    EXPECT_TRUE(contact.latest().active);
    EXPECT_EQ(contact.latest().scene, 1u);
    return contact.latest().stiffness(2, 2);
  };
  const double edited = felt(soft, hard), fromTheStart = felt(hard, hard), unedited = felt(soft, soft);
  EXPECT_EQ(felt(soft, hard, true), edited);
  EXPECT_NEAR(edited, fromTheStart, 0.01 * fromTheStart); // it has come to rest to a hundredth
  EXPECT_GT(edited, 2.0 * unedited);
}

} // namespace esm
