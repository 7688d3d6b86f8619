// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/contact/tool_grip.h"

#include "tests/core/contact/hanging_chain.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include <limits>

namespace esm {

namespace {

// 200 N/m hold the middle node of chain(3); a node that is held alone is held with twice that.
constexpr double kMiddle = 400.0;

Eigen::Vector3d pullOf(std::span<const ToolSpring> springs, const NetState& state)
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const ToolSpring& spring : springs)
    sum += spring.stiffness * (spring.target - state.position.col(spring.node));
  return sum;
}

/// The middle node of chain(3) alone.
ToolGrip gripOn(const SpringNet& net, const Eigen::Vector3d& apart, double maxForce = 5.0)
{
  return {net, net.restPosition, 1, 0.0, net.restPosition.col(1) + apart, maxForce};
}

} // namespace

TEST(ToolGrip, PullsNearNodesLikeASpring)
{
  const SpringNet net = chain(3);
  const ToolGrip grip = gripOn(net, {0.0, 0.001, 0.0});
  EXPECT_NEAR(grip.stiffness(), kMiddle, 1e-9);
  EXPECT_TRUE(grip.forceOnHand(atRest(net)).isApprox(Eigen::Vector3d(0.0, -0.001 * kMiddle, 0.0), 1e-9));
}

// A hand that closes and stays pulls at nothing, however the net lies; one that moves leads each node alike.
TEST(ToolGrip, KeepsThePatchAsItWasTaken)
{
  const SpringNet net = chain(7);
  NetState state = atRest(net);
  state.position += 0.001 * Eigen::Matrix3Xd::Random(3, 7);
  ToolGrip grip(net, state.position, 3, 0.012, state.position.col(3), 5.0);
  ASSERT_EQ(grip.springs(state).size(), 3u);
  EXPECT_TRUE(grip.forceOnHand(state).isZero(1e-12));
  const Eigen::Vector3d way(0.001, 0.002, -0.001);
  grip.moveTo(state.position.col(3) + way, Eigen::Vector3d::Zero());
  for (const ToolSpring& spring : grip.springs(state))
    EXPECT_TRUE((spring.target - state.position.col(spring.node)).isApprox(way, 1e-9));
  EXPECT_TRUE(grip.forceOnHand(state).isApprox(-grip.stiffness() * way, 1e-9));
  double weights = 0.0;
  for (const double weight : grip.point().weight) weights += weight;
  EXPECT_NEAR(weights, 1.0, 1e-12);
  EXPECT_EQ(grip.point().node.front(), 3);
}

// What is fixed beside the place does not hold the hand back.
TEST(ToolGrip, FixedNodesAreLeftOut)
{
  const SpringNet net = chain(3); // the first one is fixed
  const ToolGrip grip(net, net.restPosition, 1, 0.012, net.restPosition.col(1), 5.0);
  EXPECT_EQ(grip.point().node, (std::vector<Index>{1, 2}));
  const ToolGrip onFixed(net, net.restPosition, 0, 0.0, net.restPosition.col(0), 5.0);
  EXPECT_EQ(onFixed.point().node, std::vector<Index>{0});
}

// Where a frame was broken off the hand is as far as it has come; where it ended, exactly at its place.
TEST(ToolGrip, ALedHandIsWhereTimeHasBroughtIt)
{
  const SpringNet net = chain(3);
  ToolGrip grip = gripOn(net, {0, 0, 0});
  const Eigen::Vector3d begin = grip.target(), goal = begin + Eigen::Vector3d(1e-4, 2e-4, 0.0);
  grip.leadTo(goal, 0.1);
  for (const ToolSpring& spring : grip.springs(atRest(net))) {
    EXPECT_TRUE(spring.isLed());
    EXPECT_EQ(spring.target, begin) << "from where it is";
    EXPECT_TRUE(spring.targetVelocity.isApprox((goal - begin) / 0.1, 1e-12));
  }
  grip.endLead(0.025);
  EXPECT_TRUE(grip.target().isApprox(begin + 0.25 * (goal - begin), 1e-12));
  grip.leadTo(goal, 0.1);
  grip.endLead(0.1);
  EXPECT_EQ(grip.target(), goal);
  grip.leadTo(goal, 0.1);
  for (const ToolSpring& spring : grip.springs(atRest(net))) EXPECT_FALSE(spring.isLed()) << "a hand at rest";
  grip.leadTo({0.0, std::nan(""), 0.0}, 0.1);
  grip.endLead(0.1);
  EXPECT_EQ(grip.target(), goal);
}

TEST(ToolGrip, FarHandsPullWithTheLimitAndTheSpringsOnlySoften)
{
  const SpringNet net = chain(7);
  const NetState state = atRest(net);
  const Eigen::Vector3d node = net.restPosition.col(3);
  for (const double distance : {0.1, 0.2, 1.0, 3.0, 1e6}) {
    ToolGrip grip(net, state.position, 3, 0.012, node + Eigen::Vector3d(0.0, 0.0, distance), 5.0);
    const std::span<const ToolSpring> springs = grip.springs(state);
    double stiffness = 0.0;
    for (const ToolSpring& spring : springs) {
      stiffness += spring.stiffness;
      // Up to an octave closer than the hand, never beyond it.
      const double way = (spring.target - state.position.col(spring.node)).norm();
      EXPECT_LE(way, distance * (1.0 + 1e-12));
      EXPECT_GE(way, 0.5 * distance * (1.0 - 1e-12));
    }
    EXPECT_LE(stiffness, grip.stiffness());
    EXPECT_NEAR(pullOf(springs, state).norm(), 5.0, 1e-6) << distance << " m";
    EXPECT_NEAR(grip.forceOnHand(state).z(), -5.0, 1e-6);
  }
}

TEST(ToolGrip, FastNodesDoNotPushTheForceOverTheLimit)
{
  const SpringNet net = chain(3);
  NetState state = atRest(net);
  state.velocity.col(1) = Eigen::Vector3d(100.0, 0.0, 0.0);
  EXPECT_NEAR(gripOn(net, Eigen::Vector3d::Zero(), 2.0).forceOnHand(state).norm(), 2.0, 1e-12);
}

// Tissue that would turn or stretch under the hand bears no more than the limit for it, though these forces add
// up to nothing.
TEST(ToolGrip, ThePatchKeepsItsShapeWithNoMoreThanTheLimit)
{
  const SpringNet net = chain(7);
  NetState state = atRest(net);
  ToolGrip grip(net, state.position, 3, 0.012, net.restPosition.col(3), 0.5);
  state.position.col(2) += Eigen::Vector3d(0.0, 0.1, 0.0);
  state.position.col(4) -= Eigen::Vector3d(0.0, 0.1, 0.0);
  double all = 0.0;
  for (const ToolSpring& spring : grip.springs(state))
    all += spring.stiffness * (spring.target - state.position.col(spring.node)).norm();
  EXPECT_NEAR(all, 0.5, 1e-9);
  EXPECT_TRUE(pullOf(grip.springs(state), state).isZero(1e-9));
}

// At the limit the springs' ends go with the tissue only when their force has changed by 2 % of the limit: what
// creeps by less may come to rest. Less than the limit it may be meanwhile, more never.
TEST(ToolGrip, AtTheLimitTissueMayComeToRest)
{
  const SpringNet net = chain(3);
  NetState state = atRest(net);
  ToolGrip grip = gripOn(net, {0.09, 0.0, 0.0}, 5.0);
  const Eigen::Vector3d before = grip.springs(state)[0].target;
  state.position(0, 1) += 0.0005; // of the 50 mm that it takes for 5 N at a quarter of the stiffness
  EXPECT_EQ(grip.springs(state)[0].target, before);
  state.position(0, 1) -= 0.001; // would pull with more
  EXPECT_NEAR(pullOf(grip.springs(state), state).norm(), 5.0, 1e-9);
  const Eigen::Vector3d drawn = grip.springs(state)[0].target;
  state.position(0, 1) += 0.002;
  EXPECT_NE(grip.springs(state)[0].target, drawn);
  EXPECT_NEAR(pullOf(grip.springs(state), state).norm(), 5.0, 1e-9);
}

// The force of the model at its own position is the grip's force, whatever the hand's speed.
TEST(ToolGrip, TheContactModelAgreesWithTheForceAtTheHand)
{
  const SpringNet net = chain(5);
  NetState state = atRest(net);
  state.velocity.col(2) = Eigen::Vector3d(0.01, 0.02, 0.0);
  ToolGrip grip(net, state.position, 2, kGripRadius, Eigen::Vector3d::Zero(), 5.0);
  const Eigen::Vector3d handVelocity(0.1, -0.2, 0.05);
  grip.moveTo(net.restPosition.col(2) + Eigen::Vector3d(0.001, 0.002, 0.0), handVelocity);
  const ContactModel model = grip.contactModel(state, 0.005 * Eigen::Matrix3d::Identity());
  EXPECT_TRUE(model.active);
  EXPECT_EQ(model.position, grip.target());
  EXPECT_TRUE((model.force - model.viscosity * handVelocity).isApprox(grip.forceOnHand(state), 1e-9));
}

// The tool before a compliance of 1/200 m/N along x, and none across.
TEST(ToolGrip, TheHandFeelsToolAndNetInSeries)
{
  const SpringNet net = chain(3);
  const Eigen::Matrix3d compliance = Eigen::Vector3d(1.0 / 200.0, 0.0, 0.0).asDiagonal();
  const Eigen::Matrix3d expected =
    Eigen::Vector3d(kMiddle * 200.0 / (kMiddle + 200.0), kMiddle, kMiddle).asDiagonal();
  const ContactModel model = gripOn(net, Eigen::Vector3d::Zero()).contactModel(atRest(net), compliance);
  EXPECT_TRUE(model.stiffness.isApprox(expected, 1e-9));
}

// Whatever compliance comes, near and far.
TEST(ToolGrip, TheStiffnessIsSymmetricAndNeverNegative)
{
  const SpringNet net = chain(6);
  const NetState state = atRest(net);
  for (int seed = 0; seed < 50; ++seed) {
    std::srand(static_cast<unsigned>(seed));
    const Eigen::Matrix3d root = 0.1 * Eigen::Matrix3d::Random();
    const Eigen::Vector3d target = state.position.col(2) + 0.05 * Eigen::Vector3d::Random();
    const ToolGrip grip(net, state.position, 2, 0.012, target, 5.0);
    const Eigen::Matrix3d stiffness = grip.contactModel(state, root * root.transpose()).stiffness;
    EXPECT_TRUE(stiffness.isApprox(stiffness.transpose(), 1e-12));
    const double least = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(stiffness).eigenvalues()[0];
    EXPECT_GE(least, -1e-9 * stiffness.norm()) << "seed " << seed;
    EXPECT_LE(stiffness.norm(), 2.0 * grip.stiffness());
  }
}

TEST(ToolGrip, TargetsThatAreNoNumbersAreIgnored)
{
  const SpringNet net = chain(3);
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const Eigen::Vector3d nowhere = Eigen::Vector3d::Constant(kNan);
  ToolGrip grip(net, net.restPosition, 1, kNan, nowhere, std::numeric_limits<double>::infinity());
  EXPECT_EQ(grip.target(), net.restPosition.col(1));
  grip.moveTo(nowhere, Eigen::Vector3d::Zero());
  grip.moveTo(Eigen::Vector3d::Zero(), nowhere);
  EXPECT_EQ(grip.target(), net.restPosition.col(1));
  EXPECT_TRUE(grip.forceOnHand(atRest(net)).allFinite());
}

// Loose nodes, which nothing holds, are held as well.
TEST(ToolGrip, LooseNodesAreLedToo)
{
  SpringNet net = chain(3);
  net.stiffness.setZero();
  EXPECT_NEAR(gripOn(net, Eigen::Vector3d::Zero()).stiffness(), 20.0, 1e-9);
}

} // namespace esm
