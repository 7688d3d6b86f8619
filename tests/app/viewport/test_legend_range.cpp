// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/viewport/legend_range.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace esm;

TEST(LegendRange, RoundNumbersAreOneTwoFive)
{
  EXPECT_DOUBLE_EQ(niceCeil(0.013), 0.02);
  EXPECT_DOUBLE_EQ(niceCeil(0.1 + 0.2), 0.5); // 0.30000000000000004
  EXPECT_DOUBLE_EQ(niceCeil(7.0), 10.0);
  EXPECT_DOUBLE_EQ(niceCeil(100.0), 100.0);
  EXPECT_DOUBLE_EQ(niceFloor(0.013), 0.01);
  EXPECT_DOUBLE_EQ(niceFloor(9.9), 5.0);
  EXPECT_DOUBLE_EQ(niceFloor(1000.0), 1000.0);
  EXPECT_EQ(niceCeil(0.0), 0.0);
  EXPECT_EQ(niceCeil(NAN), 0.0);
}

TEST(LegendRange, StiffnessRangeHoldsAllPositiveValues)
{
  Eigen::ArrayXd values(6);
  values << 130.0, 7.0, 0.0, 900.0, NAN, INFINITY;
  EXPECT_EQ(logRange(values), (ValueRange{5.0, 1000.0, true}));
}

// One value everywhere is neither "soft" nor "hard": it takes a colour from the middle.
TEST(LegendRange, ASingleStiffnessLiesInTheMiddle)
{
  const ValueRange range = logRange(Eigen::ArrayXd::Constant(4, 100.0));
  EXPECT_NEAR(range.share(100.0), 0.5, 0.01);
  EXPECT_EQ(logRange(Eigen::ArrayXd()), (ValueRange{1.0, 10.0, true}));
}

TEST(LegendRange, LogarithmicShareIsEvenPerDecade)
{
  const ValueRange range{1.0, 100.0, true};
  EXPECT_DOUBLE_EQ(range.share(10.0), 0.5);
  EXPECT_TRUE(std::isnan(range.share(0.0)));
  EXPECT_TRUE(std::isnan(range.share(-2.0)));
}

TEST(LegendRange, TicksAreRoundAndInside)
{
  const std::vector<double> linear = legendTicks({0.0, 0.5, false}, 5);
  ASSERT_EQ(linear.size(), 6u);
  EXPECT_NEAR(linear[1], 0.1, 1e-15);
  EXPECT_EQ(legendTicks({5.0, 1000.0, true}, 5), (std::vector<double>{10.0, 100.0, 1000.0}));
  EXPECT_EQ(legendTicks({10.0, 100.0, true}, 5), (std::vector<double>{10.0, 20.0, 50.0, 100.0}));
  const std::vector<double> wide = legendTicks({1e-6, 1e9, true}, 5); // 16 decades, thinned
  EXPECT_LE(wide.size(), 6u);
  EXPECT_GE(wide.size(), 4u);
}

// A net that swings: the largest strain goes up and down 60 times a second, the legend stands still.
TEST(SteadyRange, DoesNotFlickerWhileTheNetSwings)
{
  SteadyRange range(0.01);
  int changes = 0;
  double before = 0.0;
  for (int frame = 0; frame < 600; ++frame) {
    range.add(0.16 * std::abs(std::sin(frame * 0.1)), 1.0 / 60.0);
    if (frame > 30 && range.range().high != before) ++changes;
    before = range.range().high;
  }
  EXPECT_EQ(changes, 0);
  EXPECT_DOUBLE_EQ(before, 0.2);
}

TEST(SteadyRange, GrowsAtOnceAndShrinksSlowly)
{
  SteadyRange range(0.01);
  range.add(0.3, 1.0 / 60.0);
  EXPECT_DOUBLE_EQ(range.range().high, 0.5);
  for (int frame = 0; frame < 60; ++frame) range.add(0.0, 1.0 / 60.0); // one second of rest
  EXPECT_DOUBLE_EQ(range.range().high, 0.5);
  for (int frame = 0; frame < 60 * 60; ++frame) range.add(0.0, 1.0 / 60.0);
  EXPECT_DOUBLE_EQ(range.range().high, 0.01) << "not below the floor";
}

TEST(SteadyRange, IgnoresWhatIsNotFinite)
{
  SteadyRange range(0.01);
  range.add(NAN, 0.1);
  range.add(INFINITY, 0.1);
  EXPECT_DOUBLE_EQ(range.range().high, 0.01);
}
