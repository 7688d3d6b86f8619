// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/force_limiter.h"

#include "servo_bench.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace esm {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

} // namespace

TEST(ForceLimiter, RisesAtTheSlewRateAndKeepsTheDirection)
{
  ForceLimiter limiter; // 1 N per tick
  const Eigen::Vector3d wish(0.0, 3.0, 4.0);
  for (int i = 1; i <= 4; ++i) EXPECT_NEAR(limiter.limit(wish, 100.0, kTick).norm(), i, 1e-12);
  EXPECT_NEAR(limiter.force().normalized().dot(wish.normalized()), 1.0, 1e-12);
  EXPECT_EQ(limiter.limit(wish, 100.0, kTick), wish);
}

TEST(ForceLimiter, ShortensAForceAboveTheLimitWithoutTurningIt)
{
  ForceLimiter limiter(1e9);
  const Eigen::Vector3d force = limiter.limit({30.0, 0.0, 40.0}, 5.0, kTick);
  EXPECT_TRUE(force.isApprox(Eigen::Vector3d(3.0, 0.0, 4.0), 1e-12));
}

// From the largest force it takes limit / slew = 5 ticks, and then zero is zero to the last bit.
TEST(ForceLimiter, FallsToExactlyZero)
{
  ForceLimiter limiter;
  for (int i = 0; i < 10; ++i) limiter.limit({3.0, 4.0, 0.1}, 5.0, kTick);
  int ticks = 0;
  while (!limiter.force().isZero(0.0)) {
    limiter.limit(Eigen::Vector3d::Zero(), 5.0, kTick);
    ASSERT_LE(++ticks, 5);
  }
  EXPECT_EQ(ticks, 5);
}

TEST(ForceLimiter, WhatIsNoNumberCountsAsZero)
{
  ForceLimiter limiter;
  limiter.limit({1.0, 0.0, 0.0}, 5.0, kTick);
  EXPECT_TRUE(limiter.limit({kNaN, 1.0, 0.0}, 5.0, kTick).isZero(0.0));
  EXPECT_TRUE(limiter.limit({kInfinity, 0.0, 0.0}, 5.0, kTick).isZero(0.0));
  EXPECT_TRUE(limiter.limit({1.0, 0.0, 0.0}, kNaN, kTick).isZero(0.0));
  EXPECT_TRUE(limiter.limit({1.0, 0.0, 0.0}, -3.0, kTick).isZero(0.0));
  // The square of 1e300 is infinite, the number is not.
  EXPECT_NEAR(limiter.limit({1e300, 0.0, 0.0}, 5.0, kTick).x(), 1.0, 1e-12);
}

// Sizes from 1e-3 to 1e300 N, with NaN and infinity among them. 1e-12 covers the rounding of one sum.
TEST(ForceLimiter, AMillionRandomWishesNeverPassTheLimitOrTheSlewRate)
{
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(-1.0, 1.0), decade(-3.0, 3.0);
  ForceLimiter limiter;
  Eigen::Vector3d last = Eigen::Vector3d::Zero();
  double largest = 0.0, fastest = 0.0;
  for (int i = 0; i < 1000000; ++i) {
    Eigen::Vector3d wish(unit(random), unit(random), unit(random));
    wish *= i % 5 == 0 ? 1e300 : std::pow(10.0, decade(random));
    if (i % 101 == 0) wish[i % 3] = i % 2 == 0 ? kNaN : -kInfinity;
    const Eigen::Vector3d& force = limiter.limit(wish, 5.0, kTick);
    ASSERT_TRUE(force.allFinite());
    largest = std::max(largest, force.norm());
    fastest = std::max(fastest, (force - last).norm());
    last = force;
  }
  EXPECT_LE(largest, 5.0 + 1e-12);
  EXPECT_GT(largest, 4.0); // the limit was put to the test
  EXPECT_LE(fastest, 1.0 + 1e-12);
}

} // namespace esm
