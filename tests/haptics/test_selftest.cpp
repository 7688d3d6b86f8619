// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/selftest/selftest.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <limits>

namespace esm {

namespace {

/// Each figure of docs/HAPTIC_SAFETY.md is in its range, and is printed, in range or not.
void expectGood(const std::vector<SelftestRow>& rows)
{
  for (const SelftestRow& row : rows) {
    std::printf("%s  %-76s %12.5g %-6s (%g ... %g)\n", row.id.c_str(), row.what.c_str(), row.figure,
                row.unit.c_str(), row.least, row.most);
    EXPECT_TRUE(row.good()) << row.id << " " << row.what << ": " << row.figure << " " << row.unit;
  }
}

} // namespace

TEST(Selftest, KinematicsAndPacketsAreExact)
{
  expectGood(selftestKinematics());
}

TEST(Selftest, WallsSwingWhereTheorySaysAndNeverUnderTheCap)
{
  expectGood(selftestWalls());
}

TEST(Selftest, TheHandGetsNoEnergyThatItHadNotPutIn)
{
  expectGood(selftestEnergy());
}

TEST(Selftest, ASlowSimulationIsFeltAsTheTissueItIs)
{
  expectGood(selftestTissue());
}

TEST(Selftest, AMadSimulationNeverPassesTheLimits)
{
  expectGood(selftestLimits());
}

// A figure that is no number is not good, whatever its range.
TEST(Selftest, WhatIsNoNumberIsNotGood)
{
  SelftestRow row;
  row.figure = std::numeric_limits<double>::quiet_NaN();
  row.least = -1e300;
  row.most = 1e300;
  EXPECT_FALSE(row.good());
}

} // namespace esm
