// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/kinematics/delta3.h"
#include "haptics/kinematics/laparoscope4.h"
#include "haptics/kinematics/planar2.h"
#include "haptics/kinematics/serial3r.h"

#include <gtest/gtest.h>

#include <Eigen/SVD>

#include <cmath>
#include <numbers>
#include <random>

namespace esm {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

// The values of the guide, computed there by another program; five digits.
TEST(Delta3, EqualEncodersGiveTheKnownHeights)
{
  const Delta3 falcon;
  const double heights[5] = {0.08961, 0.11075, 0.13460, 0.15686, 0.17360};
  for (int i = 0; i < 5; ++i) {
    Eigen::Vector3d x = Delta3::centre();
    ASSERT_TRUE(falcon.forward(falcon.anglesOfCounts(Eigen::Vector3d::Constant(500.0 * (i - 2))), x));
    EXPECT_NEAR(x.z(), heights[i], 6e-6);
    EXPECT_NEAR(x.head<2>().norm(), 0.0, 1e-9); // by symmetry on the axis
  }
  Eigen::Vector3d angles;
  ASSERT_TRUE(falcon.inverse({0.0, 0.0, 0.11}, angles));
  EXPECT_NEAR(angles.minCoeff() / kDegree, 16.188, 1e-3);
  EXPECT_NEAR(angles.maxCoeff() / kDegree, 16.188, 1e-3);
}

// From a position a fast hand is away from, over all the workspace that is well conditioned.
TEST(Delta3, ForwardUndoesInverse)
{
  const Delta3 falcon;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> side(-0.05, 0.05), height(0.075, 0.165), off(-0.002, 0.002);
  int tried = 0, most = 0;
  while (tried < 5000) {
    const Eigen::Vector3d x(side(random), side(random), height(random));
    Eigen::Vector3d angles;
    Eigen::Matrix3d j;
    if (!falcon.inverse(x, angles) || !falcon.jacobian(x, angles, j)) continue;
    const auto sizes = Eigen::JacobiSVD<Eigen::Matrix3d>(j).singularValues();
    if (sizes[0] > 8.0 * sizes[2]) continue;
    ++tried;
    Eigen::Vector3d found = x + Eigen::Vector3d(off(random), off(random), off(random));
    int iterations = 0;
    ASSERT_TRUE(falcon.forward(angles, found, &iterations));
    EXPECT_LT((found - x).norm(), 1e-9);
    most = std::max(most, iterations);
  }
  EXPECT_LE(most, 5);
}

TEST(Delta3, JacobianIsTheSlopeOfTheInverse)
{
  const Delta3 falcon;
  const Eigen::Vector3d x(0.013, -0.021, 0.118);
  Eigen::Vector3d angles, ahead, behind;
  Eigen::Matrix3d j;
  ASSERT_TRUE(falcon.inverse(x, angles));
  ASSERT_TRUE(falcon.jacobian(x, angles, j));
  for (int i = 0; i < 3; ++i) {
    const double h = 1e-6;
    ASSERT_TRUE(falcon.inverse(x + h * Eigen::Vector3d::Unit(i), ahead));
    ASSERT_TRUE(falcon.inverse(x - h * Eigen::Vector3d::Unit(i), behind));
    EXPECT_LT(((ahead - behind) / (2.0 * h) - j.col(i)).norm(), 1e-6 * j.norm()); // central differences
  }
}

// torque . d theta = force . d x, whatever the force.
TEST(Delta3, TorquesDoTheWorkOfTheForce)
{
  const Delta3 falcon;
  const Eigen::Vector3d x(-0.01, 0.02, 0.1), force(1.0, -2.0, 3.0), way(0.3, 0.1, -0.2);
  Eigen::Vector3d angles, torques;
  Eigen::Matrix3d j;
  ASSERT_TRUE(falcon.inverse(x, angles));
  ASSERT_TRUE(falcon.jacobian(x, angles, j));
  ASSERT_TRUE(falcon.torques(x, angles, force, torques));
  EXPECT_NEAR(torques.dot(j * way), force.dot(way), 1e-12);
}

TEST(Delta3, RefusesWhatIsOutOfReach)
{
  const Delta3 falcon;
  Eigen::Vector3d angles(1.0, 2.0, 3.0), x = Delta3::centre();
  EXPECT_FALSE(falcon.inverse({0.0, 0.0, 1.0}, angles));
  EXPECT_EQ(angles, Eigen::Vector3d(1.0, 2.0, 3.0));
  EXPECT_FALSE(falcon.forward(Eigen::Vector3d::Constant(std::nan("")), x));
  EXPECT_EQ(x, Delta3::centre());
}

TEST(Serial3R, ForwardUndoesInverseAndJacobianIsItsSlope)
{
  const Serial3R arm;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> side(-0.06, 0.06);
  for (int i = 0; i < 500; ++i) {
    const Eigen::Vector3d x(side(random), side(random), side(random));
    Eigen::Vector3d angles;
    ASSERT_TRUE(arm.inverse(x, angles));
    EXPECT_LT((arm.forward(angles) - x).norm(), 1e-12);
    EXPECT_LT((arm.anglesOfCounts(arm.countsOfAngles(angles)) - angles).norm(), 1e-12);
    const Eigen::Matrix3d j = arm.jacobian(angles);
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Vector3d h = 1e-6 * Eigen::Vector3d::Unit(axis);
      EXPECT_LT(((arm.forward(angles + h) - arm.forward(angles - h)) / 2e-6 - j.col(axis)).norm(), 1e-8);
    }
    const Eigen::Vector3d force(1.0, 2.0, -0.5);
    EXPECT_LT((arm.forceOfCurrents(angles, arm.currents(angles, force)) - force).norm(), 1e-9);
  }
}

TEST(Planar2, AForceTooLargeKeepsItsDirection)
{
  const Planar2 stick{{0.1, 0.08}, 2.0};
  const Eigen::Vector2d command = stick.command({6.0, 3.0, 9.0});
  EXPECT_NEAR(command.cwiseAbs().maxCoeff(), 1.0, 1e-12);
  EXPECT_NEAR(command.y() / command.x(), -0.5, 1e-12); // towards the user counts up
  EXPECT_TRUE(stick.command({std::nan(""), 0.0, 0.0}).isZero(0.0));
  EXPECT_LT((stick.axes(stick.position({0.3, -0.7})) - Eigen::Vector2d(0.3, -0.7)).norm(), 1e-12);
}

TEST(Laparoscope4, PoseAndTipAreEachOther)
{
  const Laparoscope4 instrument({0.01, 0.02, 0.15}, 0.3);
  const LaparoscopePose pose{0.3, -0.2, 0.12};
  const LaparoscopePose back = instrument.pose(instrument.tip(pose));
  EXPECT_NEAR(back.yaw, pose.yaw, 1e-12);
  EXPECT_NEAR(back.pitch, pose.pitch, 1e-12);
  EXPECT_NEAR(back.insertion, pose.insertion, 1e-12);
}

// Virtual work, by differences of the tip: yaw, pitch and insertion, with the whole lever beyond the fade.
TEST(Laparoscope4, GeneralisedForcesDoTheWorkOfTheForce)
{
  const Laparoscope4 instrument({0.0, 0.0, 0.15}, 0.3);
  const LaparoscopePose pose{0.3, -0.2, 0.12};
  const Eigen::Vector3d force(1.0, -2.0, 0.5);
  const Eigen::Vector3d found = instrument.generalisedForce(pose, force);
  const auto along = [&](const LaparoscopePose& a, const LaparoscopePose& b) {
    return (instrument.tip(a) - instrument.tip(b)).dot(force) / 2e-6;
  };
  const double h = 1e-6;
  EXPECT_NEAR(found[0],
              along({pose.yaw + h, pose.pitch, pose.insertion}, {pose.yaw - h, pose.pitch, pose.insertion}),
              1e-8);
  EXPECT_NEAR(found[1],
              along({pose.yaw, pose.pitch + h, pose.insertion}, {pose.yaw, pose.pitch - h, pose.insertion}),
              1e-8);
  EXPECT_NEAR(found[2],
              along({pose.yaw, pose.pitch, pose.insertion + h}, {pose.yaw, pose.pitch, pose.insertion - h}),
              1e-8);
}

// The tip goes the other way than the hand, and the hand feels the power that the tip takes.
TEST(Laparoscope4, TheTrocarTurnsTheHandRound)
{
  const Laparoscope4 instrument({0.0, 0.0, 0.15}, 0.3);
  const Eigen::Vector3d handle(0.01, -0.02, 0.30), force(0.5, 1.0, -2.0), way(0.4, 0.2, -0.1);
  EXPECT_LT((instrument.handleOfTip(instrument.tipOfHandle(handle)) - handle).norm(), 1e-12);
  EXPECT_LT(instrument.tipOfHandle(handle).x(), 0.0);
  EXPECT_NEAR(instrument.handleForce(handle, force).dot(way), force.dot(instrument.tipJacobian(handle) * way),
              1e-12);
  // At the pivot no lever is left to make forces huge.
  const Eigen::Vector3d near = instrument.pivot() + Eigen::Vector3d(0.0, 0.0, 1e-4);
  EXPECT_LE(instrument.handleForce(near, {1.0, 0.0, 0.0}).norm(), 1.0);
}

} // namespace
} // namespace esm
