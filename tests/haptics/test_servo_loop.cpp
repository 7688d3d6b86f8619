// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "servo_bench.h"
#include "tests/support/allocation_counter.h"

#include <gtest/gtest.h>

#include <atomic>
#include <limits>
#include <memory>
#include <thread>

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
  tickUnder(bench, constantForce(kPush), 150);
  EXPECT_EQ(bench.status().state, DeviceState::Arming);
  // Half of 0.3 s; the hand moves a little, and what damps it while the force rises is part of the force.
  EXPECT_NEAR(bench.force().x(), 0.5, 0.02);
  tickUnder(bench, constantForce(kPush), 152);
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
    // Damping takes away, and what the hand gives way to the push is too slow for more than 1 mN of it.
    ASSERT_LE(bench.force().x(), tick / 2000.0 + 1e-12) << "after " << tick << " ms";
    if (tick > 50) { // of the contact's own fading in
      ASSERT_GE(bench.force().x(), tick / 2000.0 - 1e-3) << "after " << tick << " ms";
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

// Tissue that appears around an armed hand is felt as softly as tissue around a hand that arms: after 50
// ticks below 0.2 N in the new scene, then from nothing to all of it within the device's time (0.3 s here).
TEST(ServoLoop, AnotherSceneWaitsAndFadesInAnew)
{
  ServoBench bench(firmlyHeld(), handAlong([](double) { return Eigen::Vector3d(Eigen::Vector3d::Zero()); }));
  bringUp(bench);
  ContactModel other = constantForce(-kPush);
  other.scene = 2;
  tickUnder(bench, other, 25);
  EXPECT_GT(bench.force().x(), 0.0); // the old one first fades out
  tickUnder(bench, other, 27);
  for (int i = 0; i < 500; ++i) {
    tickUnder(bench, other, 1);
    ASSERT_TRUE(bench.force().isZero(0.0)); // 1 N is too much to begin with
  }
  EXPECT_EQ(bench.status().reason, ServoReason::ForceTooLarge);
  ContactModel nothing;
  nothing.scene = 2;
  tickUnder(bench, nothing, 50 + Arming::kSafeTicks);
  for (int tick = 1; tick <= 300; ++tick) {
    tickUnder(bench, other, 1);
    ASSERT_LE(bench.force().norm(), tick / 300.0 + 1e-9);
  }
  tickUnder(bench, other, 2);
  EXPECT_NEAR(bench.force().x(), -1.0, 1e-9);
}

// Armed while there is no tissue: the quiet before it counts for nothing.
TEST(ServoLoop, QuietWithoutAnyTissueIsNoReasonToBegin)
{
  ServoBench bench(firmlyHeld(), handAlong([](double) { return Eigen::Vector3d(Eigen::Vector3d::Zero()); }));
  bench.order(ForceOrder::Arm);
  bench.tick(500); // no model ever came
  EXPECT_EQ(bench.status().reason, ServoReason::NoScene);
  ContactModel paused;
  paused.scene = 0;
  tickUnder(bench, paused, 500);
  EXPECT_EQ(bench.status().reason, ServoReason::NoScene);
  for (int i = 0; i < 500; ++i) {
    tickUnder(bench, constantForce(kPush), 1);
    ASSERT_TRUE(bench.force().isZero(0.0));
  }
  EXPECT_EQ(bench.status().reason, ServoReason::ForceTooLarge);
  tickUnder(bench, {}, 100);
  EXPECT_EQ(bench.status().reason, ServoReason::NoContact);
}

// The same scene after it was silent for longer than 100 ms is as good as another.
TEST(ServoLoop, TissueThatComesBackAfterASilenceWaitsAndFadesInAnew)
{
  ServoBench bench(firmlyHeld(), handAlong([](double) { return Eigen::Vector3d(Eigen::Vector3d::Zero()); }));
  bringUp(bench);
  bench.tick(110);
  EXPECT_EQ(bench.status().reason, ServoReason::StaleModel);
  tickUnder(bench, constantForce(kPush), 55);
  for (int i = 0; i < 500; ++i) {
    tickUnder(bench, constantForce(kPush), 1);
    ASSERT_TRUE(bench.force().isZero(0.0));
  }
}

// A contact that comes out of nothing with more than 0.2 N, long after force was let flow, fades in over the
// device's time; one that begins with less is there after its own 50 ms.
TEST(ServoLoop, AContactThatBeginsWithALargeForceFadesIn)
{
  ServoBench bench(firmlyHeld(), handAlong([](double) { return Eigen::Vector3d(Eigen::Vector3d::Zero()); }));
  bringUp(bench);
  tickUnder(bench, {}, 100);
  for (int tick = 1; tick <= 300; ++tick) {
    tickUnder(bench, constantForce(kPush), 1);
    ASSERT_LE(bench.force().norm(), tick / 300.0 + 1e-9);
  }
  tickUnder(bench, {}, 100);
  tickUnder(bench, constantForce(0.19 * kPush), 51);
  EXPECT_NEAR(bench.force().x(), 0.19, 1e-9);
  tickUnder(bench, constantForce(kPush), 2); // it goes on and grows
  EXPECT_NEAR(bench.force().x(), 1.0, 1e-9);
}

// A hand that is placed elsewhere, as another place for the workspace does, takes no contact with it: what it
// meets there fades in.
TEST(ServoLoop, AHandPlacedElsewhereLeavesItsContactBehind)
{
  class Jumping final : public HapticDevice {
  public:
    Jumping() { m_profile.armTime = 0.3; }
    const DeviceProfile& profile() const noexcept override { return m_profile; }
    DeviceLink read(double, DeviceSample& sample) noexcept override
    {
      sample = now;
      return DeviceLink::Ready;
    }
    bool write(const Eigen::Vector3d& newForce) noexcept override
    {
      force = newForce;
      return true;
    }
    DeviceSample now;
    Eigen::Vector3d force = Eigen::Vector3d::Zero();

  private:
    DeviceProfile m_profile;
  };
  TripleBuffer<ToolState> tool;
  TripleBuffer<ContactModel> contact;
  auto made = std::make_unique<Jumping>();
  Jumping& device = *made;
  ServoLoop loop(std::move(made), std::make_unique<VirtualClock>(), tool, contact);
  std::uint64_t sequence = 0;
  const auto tick = [&](ContactModel model) {
    model.sequence = ++sequence;
    contact.back() = model;
    contact.publish();
    loop.runTicks(1);
  };
  loop.core().orders().give(ForceOrder::Arm);
  for (int i = 0; i < 400; ++i) tick(springTo({0.001, 0.0, 0.0}, 100.0)); // 0.1 N
  ASSERT_NEAR(device.force.x(), 0.1, 1e-9);
  device.now.position.x() = -0.039; // 4 N of the old spring
  ++device.now.epoch;
  for (int i = 1; i <= 300; ++i) {
    tick(springTo({0.001, 0.0, 0.0}, 100.0));
    ASSERT_LE(device.force.norm(), 4.0 * i / 300.0 + 1e-9);
  }
  for (int i = 0; i < 2; ++i) tick(springTo({0.001, 0.0, 0.0}, 100.0));
  EXPECT_NEAR(device.force.x(), 4.0, 1e-9);
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

// What was first is the reason that the user gets, until he arms again; only a device that is gone outdoes
// it.
TEST(ServoLoop, TheFirstFaultIsTheReason)
{
  ServoBench bench(firmlyHeld(), handAlong([](double) { return Eigen::Vector3d(Eigen::Vector3d::Zero()); }));
  bringUp(bench);
  bench.order(ForceOrder::Stop);
  tickUnder(bench, constantForce(kPush), 10);
  bench.device.setLink(DeviceLink::NoReply);
  tickUnder(bench, constantForce(kPush), 50);
  EXPECT_EQ(bench.status().reason, ServoReason::EmergencyStop);
  bench.device.setLink(DeviceLink::Lost);
  tickUnder(bench, constantForce(kPush), 2);
  EXPECT_EQ(bench.status().reason, ServoReason::DeviceLost);
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

// 80 N of a tissue gone mad are cut to the limit before they fade in, not after: else all of the limit would
// be there after a sixteenth of the time.
TEST(ServoLoop, AForceAboveTheLimitFadesInFromTheLimit)
{
  ServoBench bench(firmlyHeld(), handAlong([](double) { return Eigen::Vector3d(Eigen::Vector3d::Zero()); }));
  bench.armWithoutForce();
  for (int tick = 1; tick <= 300; ++tick) {
    tickUnder(bench, constantForce({80.0, 0.0, 0.0}), 1);
    ASSERT_LE(bench.force().norm(), 5.0 * tick / 300.0 + 1e-9) << tick;
  }
}

// A first-order filter of cut-off f forgets a step by exp(-2 pi f t): at 200 Hz a hand's speed is known to
// 2 % after 5 ms (less with the filter's own tick), at 20 Hz half of it would be missing, and damping would
// push where it should brake.
TEST(ServoLoop, TheHandsSpeedIsKnownWithinFiveMilliseconds)
{
  SimulatedDeviceSettings free;
  free.damping = free.coulomb = 0.0;
  ServoBench bench(free);
  bench.tick(10);
  bench.device.setMotion(Eigen::Vector3d::Zero(), {0.1, 0.0, 0.0});
  bench.tick(5);
  EXPECT_NEAR(bench.tool.latest().velocity.x(), 0.1, 0.005);
}

// The filtered speed of a hand that has come to rest halves with each tick, through the numbers that are too
// small for full precision unless it is dropped before; its thread drops such numbers wherever they come
// from.
TEST(ServoLoop, AHandAtRestHasNoSpeed)
{
  SimulatedDeviceSettings settings;
  settings.coulomb = 5.0; // stops at once
  ServoBench bench(settings);
  bench.device.setMotion(Eigen::Vector3d::Zero(), {0.5, 0.0, 0.0});
  bench.tick(100);
  ASSERT_TRUE(bench.device.velocity().isZero(0.0));
  EXPECT_TRUE(bench.tool.latest().velocity.isZero(0.0));
}

TEST(ServoLoop, ItsThreadDropsNumbersTooSmallForFullPrecision)
{
  class Halving final : public HapticDevice {
  public:
    explicit Halving(std::atomic<double>& half) : m_half(half) {}
    const DeviceProfile& profile() const noexcept override { return m_profile; }
    DeviceLink read(double, DeviceSample&) noexcept override
    {
      volatile double least = std::numeric_limits<double>::min();
      m_half = 0.5 * least;
      return DeviceLink::Ready;
    }
    bool write(const Eigen::Vector3d&) noexcept override { return true; }

  private:
    std::atomic<double>& m_half;
    DeviceProfile m_profile;
  };
  std::atomic<double> half{-1.0};
  TripleBuffer<ToolState> tool;
  TripleBuffer<ContactModel> contact;
  ServoLoop loop(std::make_unique<Halving>(half), std::make_unique<SteadyClock>(), tool, contact);
  loop.start();
  while (half < 0.0) std::this_thread::yield();
  loop.finish();
  EXPECT_EQ(half, 0.0);
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

// Nor may the tick that follows a late one closely take a whole one's step: 0.4 ms are 0.4 N at 1 N/ms.
TEST(ServoLoop, AnEarlyTickEarnsOnlyItsPart)
{
  ServoBench bench(firmlyHeld(), handAlong([](double) { return Eigen::Vector3d(Eigen::Vector3d::Zero()); }));
  bench.armWithoutForce();
  tickUnder(bench, constantForce(Eigen::Vector3d::Zero()), 400);
  bench.clock.delayNextWake(0.0006);
  tickUnder(bench, constantForce({4.0, 0.0, 0.0}), 1);
  const double before = bench.force().x();
  bench.order(ForceOrder::Stop); // falls as fast as it may
  tickUnder(bench, constantForce({4.0, 0.0, 0.0}), 1);
  EXPECT_NEAR(before - bench.force().x(), std::min(before, 0.4), 1e-9);
  EXPECT_GT(before, 0.0);
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
