// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/energy_guard.h"

#include "servo_bench.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

Eigen::Vector3d along(double x)
{
  return {x, 0.0, 0.0};
}

} // namespace

// A spring of 300 N/m that is pressed by 15 mm holds 34 mJ, more than the trip; given back slowly, in forces
// that are exact at the middle of each step, nothing of it counts as generated.
TEST(EnergyGuard, ASpringMayGiveBackWhatWasPutIn)
{
  EnergyGuard guard(20.0);
  double x = 0.0, largest = 0.0;
  for (int i = 1; i <= 2000; ++i) {
    const double next = -0.0075 * (1.0 - std::cos(0.00314159 * i));
    const double middle = -300.0 * 0.5 * (x + next);
    ASSERT_TRUE(guard.account(along(middle), along(next - x), 150.0 * next * next, 1.0, kTick));
    largest = std::max(largest, guard.generated());
    x = next;
  }
  EXPECT_LT(largest, 1e-6);
  EXPECT_NEAR(guard.work(), 0.0, 1e-5);
}

TEST(EnergyGuard, AForceWithoutASpringTripsWhenItHasGivenTwentyMillijoules)
{
  EnergyGuard guard(20.0);
  int ticks = 0;
  while (guard.account(along(1.0), along(0.0001), 0.0, 1.0, kTick)) ASSERT_LT(++ticks, 1000);
  // 0.1 mJ per tick less the leak of 1 uJ: 20 mJ after 202 ticks.
  EXPECT_NEAR(ticks, 202, 2);
}

// A tissue that tightens by itself under a hand that holds still has given it nothing yet.
TEST(EnergyGuard, SpringsThatTightenUnderAStillHandAreNotGenerated)
{
  EnergyGuard guard(20.0);
  for (int i = 0; i < 1000; ++i)
    ASSERT_TRUE(guard.account(along(0.005 * i), along(0.0), 1e-7 * i * i, 1.0, kTick));
  EXPECT_EQ(guard.generated(), 0.0);
}

// A tissue that moves by itself may do half a milliwatt of work on a hand for ever: in 100 s that is 50 mJ,
// more than twice the trip.
TEST(EnergyGuard, ForgivesWhatIsSlow)
{
  EnergyGuard guard(20.0);
  for (int i = 0; i < 100000; ++i)
    ASSERT_TRUE(guard.account({0.5, 0.0, 0.0}, {1e-6, 0.0, 0.0}, 0.0, 1.0, 0.001)) << i;
  EXPECT_LT(guard.generated(), 1e-6);
  EXPECT_NEAR(guard.work(), 0.05, 1e-9);
}

TEST(EnergyGuard, DampingOpposesTheMotionAndStaysWithinTheDevices)
{
  EnergyGuard guard(20.0);
  guard.account(along(1.0), along(0.01), 0.0, 1.0, kTick);
  ASSERT_GT(guard.generated(), 0.009);
  EXPECT_NEAR(guard.damping(along(0.001)).x(), -0.02, 1e-12); // 20 N s/m at 1 mm/s
  EXPECT_LT(guard.damping(along(0.5)).x(), 0.0);
  EXPECT_GT(guard.damping(along(0.5)).x(), -10.0);
  EXPECT_TRUE(guard.damping(along(0.0)).isZero(0.0));
}

// A simulation that pushes the hand wherever it goes: negative damping of 60 N s/m, more than hand,
// device and the guard's own damping take out. From the moment that the hand has got 20 mJ more than it gave
// (and than the leak forgives), the force is gone within 100 ms, and a fault keeps it away.
TEST(EnergyGuard, ALoopThatDrivesTheHandIsSwitchedOff)
{
  ServoBench bench({},
                   handAlong([](double t) { return Eigen::Vector3d(0.002 * std::sin(12.0 * t), 0.0, 0.0); }));
  bench.armWithoutForce();
  double got = 0.0, most = 0.0, when = -1.0;
  Eigen::Vector3d last = bench.device.position();
  for (int i = 0; i < 5000; ++i) {
    bench.send(constantForce(60.0 * bench.device.velocity()));
    const Eigen::Vector3d force = bench.force();
    bench.tick();
    got += force.dot(bench.device.position() - last) - EnergyGuard::kLeak * kTick;
    last = bench.device.position();
    most = std::max(most, got);
    if (when < 0.0 && got > EnergyGuard::kTrip) when = bench.now();
    if (when > 0.0 && bench.now() > when + 0.1) {
      ASSERT_TRUE(bench.force().isZero(0.0)) << bench.now() - when << " s after 20 mJ";
    }
  }
  EXPECT_GT(most, 0.01); // it was driven
  EXPECT_EQ(bench.status().reason, ServoReason::EnergyTooHigh);
  RecordProperty("energy_given_millijoule", std::to_string(1000.0 * most));
}

} // namespace esm
