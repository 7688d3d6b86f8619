// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// What supports lend while Descent moves the net, entry by entry.
#include "core/dynamics/system/energy_sums.h"

#include <gtest/gtest.h>

#include <random>

namespace esm::test {
namespace {

TEST(SupportLoan, IsPaidBackBeforeAnythingIsLost)
{
  EnergySums sums;
  sums.loan.lend(5.0, 1.0);
  sums.settle(3.0, 0.0, 3.0);
  EXPECT_EQ(sums.loss, 0.0);
  EXPECT_EQ(sums.loan.owed(), 2.0);
  sums.settle(2.5, 0.0, 0.5);
  EXPECT_EQ(sums.loss, 0.5);
  EXPECT_FALSE(sums.loan.isOpen());
  sums.endFrame();
  EXPECT_EQ(sums.work, 0.0);
}

TEST(SupportLoan, HeatOfItIsWorkAndSoIsWhatIsLeft)
{
  EnergySums sums;
  sums.loan.lend(5.0, 0.0);
  sums.settle(0.0, 2.0, 3.0);
  EXPECT_EQ(sums.work, 2.0);
  sums.endFrame();
  EXPECT_EQ(sums.work, 5.0);
  EXPECT_EQ(sums.loss, 0.0);
  EXPECT_FALSE(sums.loan.isOpen());
  sums.settle(0.0, 7.0, 1.0); // nothing is lent now
  EXPECT_EQ(sums.work, 5.0);
}

// The same step loses most of it: heat is made of no more than what that leaves.
TEST(SupportLoan, WhatIsLostCannotBecomeHeat)
{
  EnergySums sums;
  sums.loan.lend(10.0, 6.0);
  sums.settle(8.0, 4.0, 4.0); // 16 J before; 2 of 4 J of heat are of the net's own
  EXPECT_EQ(sums.work, 2.0);
  EXPECT_EQ(sums.loan.owed(), 0.0);
  EXPECT_EQ(6.0 + sums.work - 4.0 - sums.loss, 4.0);
}

// A jump that stretches springs to 1e57 J, of which millijoules are left when the frame ends: sums of such
// numbers know them to 1e41 J, the net knows them better.
TEST(SupportLoan, RoundingOfAJumpIsNoWorkAndNoLoss)
{
  for (const double rounding : {-1e41, 0.0, 1e41}) {
    EnergySums sums;
    sums.loan.lend(1e57, 3e-3);
    sums.settle(0.7e57, 0.0, 0.3e57);
    sums.settle(0.3e57 + rounding, 0.0, 2e-3);
    sums.endFrame();
    EXPECT_GE(sums.work, 0.0) << rounding;
    EXPECT_LE(sums.work, 2e-3) << rounding;
    EXPECT_GE(sums.loss, 0.0) << rounding;
    EXPECT_LE(sums.loss, 3e-3) << rounding;
  }
}

// Whatever comes in whatever order, the sums tell what the net has.
TEST(SupportLoan, NothingIsLeftOver)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> amount(0.0, 1.0);
  for (int run = 0; run < 200; ++run) {
    EnergySums sums;
    const double start = 10.0;
    double now = start, moved = 0.0;
    for (int step = 0; step < 30; ++step) {
      const double put = amount(random) < 0.3 ? 5.0 * amount(random) : 0.0;
      const double heat = amount(random) * 0.3 * (now + put);
      const double lost = put > 0.0 ? 0.0 : amount(random) * (now - heat);
      if (put > 0.0) sums.loan.lend(put, now);
      now += put - heat - lost;
      moved += put + heat + lost;
      sums.heat += heat;
      sums.settle(lost, heat, now);
      if (amount(random) < 0.2) sums.endFrame();
    }
    sums.endFrame();
    EXPECT_GE(sums.loss, 0.0);
    // Eps of a sum of a hundred numbers, no larger than what has moved.
    EXPECT_NEAR(start + sums.work - sums.heat - sums.loss, now, 1e-13 * (start + moved)) << run;
  }
}

} // namespace
} // namespace esm::test
