// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "servo_bench.h"
#include "tests/support/allocation_counter.h"

#include <gtest/gtest.h>

#include <limits>

namespace esm {

namespace {

const Eigen::Vector3d kPush(1.0, 0.0, 0.0); // [N]

/// Ticks with a fresh model each, as from a very fast simulation.
void tickUnder(ServoBench& bench, const ContactModel& model, int count)
{
  for (int i = 0; i < count; ++i) {
    bench.send(model);
    bench.tick();
  }
}

/// Armed, faded in, 1 N on the device.
void bringUp(ServoBench& bench)
{
  bench.armWithoutForce();
  tickUnder(bench, constantForce(kPush), 400); // armTime 0.3 s
  ASSERT_EQ(bench.status().state, DeviceState::Active);
  ASSERT_NEAR(bench.force().x(), 1.0, 1e-9);
}

} // namespace

TEST(ServoLoop, BeforeArmingTheForceIsExactlyZero)
{
  ServoBench bench(firmlyHeld(), handAlong([](double) { return Eigen::Vector3d(Eigen::Vector3d::Zero()); }));
  for (int i = 0; i < 500; ++i) {
    tickUnder(bench, constantForce({50.0, -3.0, 2.0}), 1);
    ASSERT_TRUE(bench.force().isZero(0.0));
  }
  EXPECT_EQ(bench.status().state, DeviceState::Idle);
}

TEST(ServoLoop, ArmingFadesTheForceInOverItsTime)
{
  ServoBench bench(firmlyHeld(), handAlong([](double) { return Eigen::Vector3d(Eigen::Vector3d::Zero()); }));
  bench.armWithoutForce();
  tickUnder(bench, constantForce(kPush), 149); // the 50th quiet tick was the first of the 300
  EXPECT_EQ(bench.status().state, DeviceState::Arming);
  // Half of 0.3 s; the hand moves a little, and what damps it while the force rises is part of the force.
  EXPECT_NEAR(bench.force().x(), 0.5, 0.02);
  tickUnder(bench, constantForce(kPush), 151);
  EXPECT_EQ(bench.status().state, DeviceState::Active);
  EXPECT_NEAR(bench.force().x(), 1.0, 1e-9);
}

// A10 as real devices have it: 50 ticks of waiting, then 2 s from nothing to all of the force. A hand that
// moves meanwhile is damped besides, by 0.2 of the device's 20 N s/m.
TEST(ServoLoop, ARealDeviceFadesInOverTwoSecondsAndIsDampedMeanwhile)
{
  SimulatedDeviceSettings settings = firmlyHeld();
  settings.armTime = DeviceProfile{}.armTime;
  ASSERT_EQ(settings.armTime, 2.0);
  ServoBench bench(settings, handAlong([](double t) { return Eigen::Vector3d(0.0, 0.05 * t, 0.0); }));
  bench.order(ForceOrder::Arm);
  tickUnder(bench, constantForce(kPush), 500); // 1 N is too much to begin with: it waits
  EXPECT_TRUE(bench.force().isZero(0.0));
  EXPECT_EQ(bench.status().reason, ServoReason::ForceTooLarge);
  bench.order(ForceOrder::Disarm); // else the 50 ticks would count from where the waiting force has faded
  bench.armWithoutForce();
  for (int tick = 1; tick < 2000; ++tick) {
    tickUnder(bench, constantForce(kPush), 1);
    // The 50th quiet tick was the first of the 2,000; damping takes away, and what the hand gives way to the
    // push is too slow for more than 1 mN of it.
    ASSERT_LE(bench.force().x(), (tick + 1) / 2000.0 + 1e-12) << "after " << tick << " ms";
    if (tick > 50) { // of the contact's own fading in
      ASSERT_GE(bench.force().x(), (tick + 1) / 2000.0 - 1e-3) << "after " << tick << " ms";
    }
    if (tick == 1000) {
      EXPECT_NEAR(bench.force().y(), -0.2 * 20.0 * 0.05, 0.02); // the hand goes 0.05 m/s
      EXPECT_EQ(bench.status().state, DeviceState::Arming);
    }
  }
  tickUnder(bench, constantForce(kPush), 2);
  EXPECT_EQ(bench.status().state, DeviceState::Active);
  EXPECT_NEAR(bench.force().x(), 1.0, 1e-9);
}

TEST(ServoLoop, DisarmingFadesToExactlyZero)
{
  ServoBench bench(firmlyHeld(), handAlong([](double) { return Eigen::Vector3d(Eigen::Vector3d::Zero()); }));
  bringUp(bench);
  bench.order(ForceOrder::Disarm);
  tickUnder(bench, constantForce(kPush), 25);
  EXPECT_EQ(bench.status().state, DeviceState::Fading);
  EXPECT_NEAR(bench.force().x(), 0.5, 1e-6);
  tickUnder(bench, constantForce(kPush), 26);
  EXPECT_EQ(bench.status().state, DeviceState::Idle);
  EXPECT_TRUE(bench.force().isZero(0.0));
}

// 5 N at 1 N/ms: nothing is left after 5 ticks, and nothing but arm() brings it back.
TEST(ServoLoop, AfterAnEmergencyStopTheForceIsGoneWithinFiveTicksAndStaysAway)
{
  ServoBench bench(firmlyHeld(), handAlong([](double) { return Eigen::Vector3d(Eigen::Vector3d::Zero()); }));
  bench.armWithoutForce();
  tickUnder(bench, constantForce({80.0, 0.0, 0.0}), 400);
  ASSERT_NEAR(bench.force().norm(), 5.0, 1e-9);
  bench.order(ForceOrder::Stop);
  bench.order(ForceOrder::Disarm); // must not soften the stop
  tickUnder(bench, constantForce({80.0, 0.0, 0.0}), 5);
  for (int i = 0; i < 1000; ++i) {
    ASSERT_TRUE(bench.force().isZero(0.0));
    tickUnder(bench, constantForce({80.0, 0.0, 0.0}), 1);
  }
  EXPECT_EQ(bench.status().state, DeviceState::Fault);
  EXPECT_EQ(bench.status().reason, ServoReason::EmergencyStop);
  bench.armWithoutForce();
  tickUnder(bench, constantForce({80.0, 0.0, 0.0}), 400);
  EXPECT_NEAR(bench.force().norm(), 5.0, 1e-9);
}

TEST(ServoLoop, ASilentSimulationIsNotAWall)
{
  ServoBench bench(firmlyHeld(), handAlong([](double) { return Eigen::Vector3d(Eigen::Vector3d::Zero()); }));
  bringUp(bench);
  bench.tick(99);
  EXPECT_NEAR(bench.force().x(), 1.0, 1e-9);
  bench.tick(21);
  EXPECT_EQ(bench.status().state, DeviceState::Fading);
  bench.tick(33);
  EXPECT_TRUE(bench.force().isZero(0.0));
  EXPECT_EQ(bench.status().reason, ServoReason::StaleModel);
}

TEST(ServoLoop, AModelThatIsNoNumberIsAFaultUntilRearmed)
{
  ServoBench bench(firmlyHeld(), handAlong([](double) { return Eigen::Vector3d(Eigen::Vector3d::Zero()); }));
  bringUp(bench);
  bench.send(constantForce(Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN())));
  bench.tick();
  EXPECT_EQ(bench.status().state, DeviceState::Fault);
  EXPECT_EQ(bench.status().reason, ServoReason::BadModel);
  tickUnder(bench, constantForce(kPush), 100);
  EXPECT_TRUE(bench.force().isZero(0.0));
  bringUp(bench);
}

TEST(ServoLoop, ADeviceThatDoesNotReplyIsAFaultAfterTwentyMilliseconds)
{
  ServoBench bench(firmlyHeld(), handAlong([](double) { return Eigen::Vector3d(Eigen::Vector3d::Zero()); }));
  bringUp(bench);
  bench.device.setLink(DeviceLink::NoReply);
  tickUnder(bench, constantForce(kPush), 19);
  EXPECT_EQ(bench.status().state, DeviceState::Active);
  tickUnder(bench, constantForce(kPush), 3);
  EXPECT_EQ(bench.status().reason, ServoReason::NoReply);
  tickUnder(bench, constantForce(kPush), 2);
  EXPECT_TRUE(bench.force().isZero(0.0));
}

TEST(ServoLoop, AnUnpluggedDeviceIsAbsentAndCannotBeArmed)
{
  ServoBench bench(firmlyHeld(), handAlong([](double) { return Eigen::Vector3d(Eigen::Vector3d::Zero()); }));
  bringUp(bench);
  bench.device.setLink(DeviceLink::Lost);
  tickUnder(bench, constantForce(kPush), 3);
  EXPECT_EQ(bench.status().state, DeviceState::Absent);
  bench.order(ForceOrder::Arm);
  tickUnder(bench, constantForce(kPush), 3);
  EXPECT_EQ(bench.status().state, DeviceState::Absent);
}

TEST(ServoLoop, ADeviceThatDoesNotKnowItsPositionGetsNoForce)
{
  ServoBench bench(firmlyHeld(), handAlong([](double) { return Eigen::Vector3d(Eigen::Vector3d::Zero()); }));
  bench.device.setLink(DeviceLink::NeedsHome);
  bench.order(ForceOrder::Arm);
  for (int i = 0; i < 500; ++i) {
    tickUnder(bench, constantForce(kPush), 1);
    ASSERT_TRUE(bench.force().isZero(0.0));
  }
  EXPECT_EQ(bench.status().reason, ServoReason::NeedsHome);
  bench.device.setLink(DeviceLink::Ready); // and does not begin by itself once it is known
  tickUnder(bench, constantForce(kPush), 500);
  EXPECT_TRUE(bench.force().isZero(0.0));
}

TEST(ServoLoop, TheSmallerOfUserAndProfileLimitsTheForce)
{
  ServoBench bench(firmlyHeld(), handAlong([](double) { return Eigen::Vector3d(Eigen::Vector3d::Zero()); }));
  bench.armWithoutForce();
  for (const auto& [user, expected] : {std::pair{2.0, 2.0}, {50.0, 5.0}, {-1.0, 0.0}}) {
    bench.loop.core().setForceLimit(user);
    tickUnder(bench, constantForce({80.0, 0.0, 0.0}), 400);
    EXPECT_NEAR(bench.force().norm(), expected, 1e-9);
    EXPECT_EQ(bench.status().forceLimit, expected);
  }
  bench.loop.core().setForceLimit(std::numeric_limits<double>::quiet_NaN()); // no change
  tickUnder(bench, constantForce({80.0, 0.0, 0.0}), 1);
  EXPECT_EQ(bench.status().forceLimit, 0.0);
}

TEST(ServoLoop, TheSimulationLearnsWhereTheHandIs)
{
  // At 0.05 m/s along x.
  ServoBench bench({}, handAlong([](double t) { return Eigen::Vector3d(0.05 * t, 0.0, 0.0); }));
  bench.tick(1000);
  const ToolState& tool = bench.tool.latest();
  EXPECT_EQ(tool.sequence, 1000u);
  EXPECT_EQ(tool.position, bench.device.position());
  // Once the hand pulls with the friction's 0.3 N and the damping's 0.15 N the device keeps its pace.
  EXPECT_NEAR(tool.velocity.x(), 0.05, 1e-4);
}

// Woken 3.4 ms late: that tick and the three it slept through count, and the next comes on the old grid.
TEST(ServoLoop, LateTicksAreCountedAndMissedOnesDropped)
{
  ServoBench bench(firmlyHeld(), handAlong([](double) { return Eigen::Vector3d(Eigen::Vector3d::Zero()); }));
  bench.tick(10);
  EXPECT_EQ(bench.status().lateTicks, 0u);
  bench.clock.delayNextWake(0.0034);
  bench.tick();
  EXPECT_EQ(bench.status().lateTicks, 4u);
  EXPECT_NEAR(bench.status().worstLateness, 0.0034, 1e-9);
  EXPECT_EQ(bench.status().ticks, 11u);
  bench.tick();
  EXPECT_NEAR(bench.now(), 0.015, 1e-9);
  EXPECT_EQ(bench.status().lateTicks, 4u);
  bench.tick(2000);
  EXPECT_NEAR(bench.status().rate, 1000.0, 1.0);
  EXPECT_EQ(bench.status().worstLateness, 0.0); // of the last second
}

// A late tick must not be an occasion to jump: one nominal tick's worth is all it may change.
TEST(ServoLoop, ALateTickDoesNotEarnALargerStep)
{
  ServoBench bench(firmlyHeld(), handAlong([](double) { return Eigen::Vector3d(Eigen::Vector3d::Zero()); }));
  bench.armWithoutForce();
  tickUnder(bench, constantForce(Eigen::Vector3d::Zero()), 400);
  bench.clock.delayNextWake(0.02);
  tickUnder(bench, constantForce({4.0, 0.0, 0.0}), 1);
  EXPECT_LE(bench.force().norm(), 1.0 + 1e-12);
}

TEST(ServoLoop, EndsWithZeroForce)
{
  ServoBench bench(firmlyHeld(), handAlong([](double) { return Eigen::Vector3d(Eigen::Vector3d::Zero()); }));
  bringUp(bench);
  bench.loop.finish();
  EXPECT_TRUE(bench.force().isZero(0.0));
}

TEST(ServoLoop, ATickAllocatesNothing)
{
  ServoBench bench(firmlyHeld(), handAlong([](double) { return Eigen::Vector3d(Eigen::Vector3d::Zero()); }));
  bringUp(bench);
  const std::uint64_t before = test::allocationsOfThisThread();
  tickUnder(bench, springTo({0.001, 0.0, 0.0}, 500.0), 1000);
  bench.order(ForceOrder::Stop);
  tickUnder(bench, constantForce(Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN())), 10);
  EXPECT_EQ(test::allocationsOfThisThread(), before);
  auto counted = std::make_unique<int>(1); // the counter does count
  EXPECT_EQ(test::allocationsOfThisThread(), before + 1);
}

} // namespace esm
