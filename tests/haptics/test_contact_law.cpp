// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/contact_law.h"

#include "servo_bench.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace esm {

namespace {

const Eigen::Vector3d kOrigin = Eigen::Vector3d::Zero();

/// A law with a device of b = 3 N s/m, no delay, T = 1 ms, driven in steps of a tick.
class ContactLawTest : public testing::Test {
protected:
  bool send(ContactModel model)
  {
    model.sequence = ++sequence;
    return law.take(model, now);
  }
  Eigen::Vector3d tick(const Eigen::Vector3d& position = kOrigin, const Eigen::Vector3d& velocity = kOrigin)
  {
    now += kTick;
    return law.force(now, kTick, position, velocity);
  }
  Eigen::Vector3d settle(const ContactModel& model)
  {
    Eigen::Vector3d force = kOrigin;
    for (int i = 0; i < 60; ++i) {
      send(model);
      force = tick();
    }
    return force;
  }

  ContactLaw law{DeviceProfile{}};
  double now = 0.0;
  std::uint64_t sequence = 0;
};

} // namespace

TEST_F(ContactLawTest, EvaluatesTheModelAtTheHand)
{
  ContactModel model = springTo({0.01, 0.0, 0.0}, 200.0);
  model.force = {0.0, 1.0, 0.0};
  model.viscosity = 2.0 * Eigen::Matrix3d::Identity();
  settle(model);
  // F = F0 - K (x - p) - C v = (0, 1, 0) - 200 (0.01, 0, 0) - 2 (0, 0, 0.1)
  const Eigen::Vector3d force = tick({0.02, 0.0, 0.0}, {0.0, 0.0, 0.1});
  EXPECT_TRUE(force.isApprox(Eigen::Vector3d(-2.0, 1.0, -0.2), 1e-9)) << force.transpose();
}

// 50 ms at 1 ms: the force comes in 50 equal steps.
TEST_F(ContactLawTest, AContactFadesIn)
{
  send(constantForce({1.0, 0.0, 0.0}));
  EXPECT_NEAR(tick().x(), 0.02, 1e-12);
  for (int i = 0; i < 24; ++i) tick();
  EXPECT_NEAR(law.presence(), 0.5, 1e-9);
}

// A quarter of 16 ms = 4 ticks; a step of 1 N comes in parts of a quarter (the interval is smoothed, hence 20
// %).
TEST_F(ContactLawTest, ANewModelTakesOverWithinAQuarterOfAFrame)
{
  for (int frame = 0; frame < 20; ++frame) {
    send(constantForce({1.0, 0.0, 0.0}));
    for (int i = 0; i < 16; ++i) tick();
  }
  send(constantForce({2.0, 0.0, 0.0}));
  double last = 1.0, largestStep = 0.0;
  for (int i = 0; i < 5; ++i) {
    const double force = tick().x();
    largestStep = std::max(largestStep, force - last);
    last = force;
  }
  EXPECT_NEAR(last, 2.0, 1e-9);
  EXPECT_NEAR(largestStep, 0.25, 0.05);
}

// Another edition, or another scale, comes on a straight line over 100 ms, however many models come
// meanwhile.
TEST_F(ContactLawTest, AnEditTakesATenthOfASecond)
{
  settle(constantForce({1.0, 0.0, 0.0}));
  ContactModel edited = constantForce({3.0, 0.0, 0.0});
  edited.edition = 1;
  for (int i = 1; i <= 100; ++i) {
    if (i % 16 == 1) send(edited);
    ASSERT_NEAR(tick().x(), 1.0 + 2.0 * i / 100.0, 1e-9) << i;
  }
  for (int i = 1; i <= 100; ++i) {
    edited.sequence = ++sequence;
    law.take(edited, now, 2.0);
    ASSERT_NEAR(tick().x(), 3.0 + 3.0 * i / 100.0, 1e-9) << i;
  }
}

// What ended fades out before another contact is taken, be it there at once.
TEST_F(ContactLawTest, AnotherContactWaitsUntilTheEndedOneHasFaded)
{
  settle(constantForce({1.0, 0.0, 0.0}));
  send(ContactModel{});
  tick();
  for (int i = 2; i <= 49; ++i) {
    send(constantForce({-1.0, 0.0, 0.0}));
    ASSERT_NEAR(tick().x(), 1.0 - i / 50.0, 1e-9);
    ASSERT_EQ(law.scene(), 1u); // the same tissue all the while
  }
  for (int i = 0; i < 3; ++i) {
    send(constantForce({-1.0, 0.0, 0.0}));
    EXPECT_LE(std::abs(tick().x()), 0.05);
  }
  EXPECT_LT(tick().x(), 0.0);
}

// A force without springs behind it; one with springs is held, see test_late_answers.cpp.
TEST_F(ContactLawTest, WithoutNewModelsForATenthOfASecondItFadesWithinFiftyMilliseconds)
{
  settle(constantForce({1.0, 0.0, 0.0}));
  for (int i = 0; i < 98; ++i) EXPECT_NEAR(tick().x(), 1.0, 1e-9);
  EXPECT_FALSE(law.stale());
  for (int i = 0; i < 53; ++i) tick(); // 0.1 s are over after 2 or 3 of them, by rounding
  EXPECT_TRUE(law.stale());
  EXPECT_TRUE(tick().isZero(0.0));
  for (int answer = 0; answer < 5; ++answer) { // the first one is late
    send(constantForce({1.0, 0.0, 0.0}));
    ASSERT_TRUE(tick().isZero(0.0));
  }
  send(constantForce({1.0, 0.0, 0.0}));
  EXPECT_NEAR(tick().x(), 0.02, 1e-9); // and comes back as a new contact does
}

TEST_F(ContactLawTest, AnEndedContactFades)
{
  settle(constantForce({1.0, 0.0, 0.0}));
  send(ContactModel{});
  EXPECT_NEAR(tick().x(), 0.98, 1e-9);
  for (int i = 0; i < 50; ++i) tick();
  EXPECT_TRUE(tick().isZero(0.0));
}

// 0.5 * 2 (b + B) / (T + 2 tau) = 3 / 0.001 = 3000 N/m without, 5000 with B = 2, but never above the maker's.
TEST_F(ContactLawTest, StiffnessIsCappedToWhatStaysStable)
{
  EXPECT_NEAR(law.stiffnessCap(0.0), 3000.0, 1e-6);
  DeviceProfile profile;
  profile.delay = 0.001;
  EXPECT_NEAR(ContactLaw(profile).stiffnessCap(0.0), 1000.0, 1e-6);
  profile.maxStiffness = 700.0;
  EXPECT_NEAR(ContactLaw(profile).stiffnessCap(2.0), 700.0, 1e-6);

  ContactModel wall = springTo(kOrigin, 0.0);
  wall.stiffness = Eigen::Vector3d(1e6, 100.0, -50.0).asDiagonal();
  settle(wall);
  const Eigen::Vector3d force = tick({0.001, 0.001, 0.001});
  // The stiff axis is capped, the soft one kept, the negative one (it would push the hand away) dropped.
  EXPECT_TRUE(force.isApprox(Eigen::Vector3d(-3.0, -0.1, 0.0), 1e-6)) << force.transpose();
}

// A position of 4 ms ago counts at once: 0.5 * 2 b / (T + 2 tau) = 3 / (0.001 + 0.008) = 333 N/m.
TEST_F(ContactLawTest, AStalePositionLowersTheCapAtOnce)
{
  now += kTick;
  law.force(now, kTick, kOrigin, kOrigin, 0.004);
  EXPECT_NEAR(law.stiffnessCap(0.0), 3.0 / 0.009, 1.0);
}

// What is touched drags with friction times push at most, and pulls not at all.
TEST_F(ContactLawTest, ATouchedSurfaceDragsWithinItsFriction)
{
  ContactModel model = constantForce({3.0, 0.0, 2.0});
  model.normal = Eigen::Vector3d::UnitZ();
  model.friction = 0.5;
  EXPECT_TRUE(settle(model).isApprox(Eigen::Vector3d(1.0, 0.0, 2.0), 1e-9));
  model.force = {0.3, 0.0, 2.0}; // within the cone
  EXPECT_TRUE(settle(model).isApprox(model.force, 1e-9));
  model.force = {0.3, 0.0, -2.0};
  EXPECT_TRUE(settle(model).isZero(0.0));
}

TEST_F(ContactLawTest, AModelThatIsNoNumberIsRefusedAndLeavesNoTrace)
{
  settle(constantForce({1.0, 0.0, 0.0}));
  ContactModel bad = constantForce({1.0, 0.0, 0.0});
  bad.stiffness(1, 2) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(send(bad));
  EXPECT_FALSE(send(constantForce({1e300, 0.0, 0.0})));
  EXPECT_NEAR(tick().x(), 1.0, 1e-9);
  EXPECT_TRUE(send(constantForce({1.0, 0.0, 0.0})));
  EXPECT_NEAR(tick().x(), 1.0, 1e-9);
}

} // namespace esm
