// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/runtime/static_compliance.h"
#include "core/runtime/tool_grip.h"

#include "hanging_chain.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include <limits>

namespace esm {

TEST(ToolGrip, PullsNearNodesLikeASpring)
{
  const SpringNet net = chain(3);
  const NetState state = atRest(net);
  const ToolGrip grip(net, 1, net.restPosition.col(1) + Eigen::Vector3d(0.0, 0.001, 0.0), 5.0);
  // Three times the two springs of 100 N/m at the node.
  EXPECT_NEAR(grip.stiffness(), 600.0, 1e-9);
  EXPECT_TRUE(grip.forceOnHand(state).isApprox(Eigen::Vector3d(0.0, -0.6, 0.0), 1e-9));
}

TEST(ToolGrip, FarHandsPullWithTheLimitAndTheSpringOnlySoftens)
{
  const SpringNet net = chain(3);
  const NetState state = atRest(net);
  for (const double distance : {0.009, 0.02, 0.1, 3.0, 1e6}) {
    const ToolGrip grip(net, 1, net.restPosition.col(1) + Eigen::Vector3d(0.0, 0.0, distance), 5.0);
    const ToolSpring spring = grip.spring(state);
    EXPECT_LE(spring.stiffness, grip.stiffness());
    const double pull = spring.stiffness * (spring.target - net.restPosition.col(1)).norm();
    EXPECT_NEAR(pull, 5.0, 1e-6) << distance << " m";
    EXPECT_NEAR(grip.forceOnHand(state).z(), -5.0, 1e-6);
    // Up to an octave closer than the hand, never beyond it.
    EXPECT_LE((spring.target - net.restPosition.col(1)).norm(), distance * (1.0 + 1e-12));
    EXPECT_GE((spring.target - net.restPosition.col(1)).norm(), 0.5 * distance * (1.0 - 1e-12));
  }
}

TEST(ToolGrip, FastNodesDoNotPushTheForceOverTheLimit)
{
  const SpringNet net = chain(3);
  NetState state = atRest(net);
  state.velocity.col(1) = Eigen::Vector3d(100.0, 0.0, 0.0);
  const ToolGrip grip(net, 1, net.restPosition.col(1), 2.0);
  EXPECT_NEAR(grip.forceOnHand(state).norm(), 2.0, 1e-12);
}

// The force of the model at its own position is the grip's force, whatever the hand's speed.
TEST(ToolGrip, TheContactModelAgreesWithTheForceAtTheHand)
{
  const SpringNet net = chain(3);
  NetState state = atRest(net);
  state.velocity.col(1) = Eigen::Vector3d(0.01, 0.02, 0.0);
  ToolGrip grip(net, 1, Eigen::Vector3d::Zero(), 5.0);
  const Eigen::Vector3d handVelocity(0.1, -0.2, 0.05);
  grip.moveTo(net.restPosition.col(1) + Eigen::Vector3d(0.001, 0.002, 0.0), handVelocity);
  const ContactModel model = grip.contactModel(state, 0.005 * Eigen::Matrix3d::Identity());
  EXPECT_TRUE(model.active);
  EXPECT_EQ(model.position, grip.target());
  EXPECT_TRUE((model.force - model.viscosity * handVelocity).isApprox(grip.forceOnHand(state), 1e-9));
}

// 600 N/m of the tool before a compliance of 1/200 m/N along x, and none across.
TEST(ToolGrip, TheHandFeelsToolAndNetInSeries)
{
  const SpringNet net = chain(3);
  const ToolGrip grip(net, 1, net.restPosition.col(1), 5.0);
  const Eigen::Matrix3d compliance = Eigen::Vector3d(1.0 / 200.0, 0.0, 0.0).asDiagonal();
  const Eigen::Matrix3d expected = Eigen::Vector3d(600.0 * 200.0 / 800.0, 600.0, 600.0).asDiagonal();
  EXPECT_TRUE(grip.contactModel(atRest(net), compliance).stiffness.isApprox(expected, 1e-9));
}

// Whatever compliance comes, near and far.
TEST(ToolGrip, TheStiffnessIsSymmetricAndNeverNegative)
{
  const SpringNet net = chain(4);
  const NetState state = atRest(net);
  for (int seed = 0; seed < 50; ++seed) {
    std::srand(static_cast<unsigned>(seed));
    const Eigen::Matrix3d root = 0.1 * Eigen::Matrix3d::Random();
    const ToolGrip grip(net, 2, state.position.col(2) + 0.02 * Eigen::Vector3d::Random(), 5.0);
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
  const Eigen::Vector3d nowhere = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  ToolGrip grip(net, 1, nowhere, std::numeric_limits<double>::infinity());
  EXPECT_EQ(grip.target(), net.restPosition.col(1));
  grip.moveTo(nowhere, Eigen::Vector3d::Zero());
  grip.moveTo(Eigen::Vector3d::Zero(), nowhere);
  EXPECT_EQ(grip.target(), net.restPosition.col(1));
  EXPECT_TRUE(grip.forceOnHand(atRest(net)).allFinite());
}

} // namespace esm
