// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// The long stability sweep: 10,000 random nets at the window's effort, a thousand in each test, and some at
// the default effort, where the engine pays for the tolerance as long as it can. Limits as in
// test_stress.cpp.
#include "tests/support/stress_run.h"

#include <gtest/gtest.h>

namespace esm::test {

class StressSweep : public ::testing::TestWithParam<std::uint32_t> {};

TEST_P(StressSweep, AThousandNets)
{
  SolverSettings settings;
  settings.tolerance = 1e-2;
  settings.effort = 5e5;
  settings.workLimit = 0.0;
  const std::uint32_t first = GetParam() * 1000;
  const StressSummary summary = sweepStress(first, first + 1000, settings, 0.1, 4.0);
  EXPECT_EQ(summary.badFrames, 0);
  RecordProperty("growth", std::to_string(summary.growth));
  RecordProperty("cost", std::to_string(summary.frameCost));
}

TEST_P(StressSweep, SomeAtTheDefaultEffort)
{
  SolverSettings settings;
  settings.tolerance = 1e-2;
  settings.workLimit = 0.0;
  const std::uint32_t first = 20000 + GetParam() * 10;
  const StressSummary summary = sweepStress(first, first + 10, settings, 0.1, 4.0);
  EXPECT_EQ(summary.badFrames, 0);
}

INSTANTIATE_TEST_SUITE_P(Seeds, StressSweep, ::testing::Range(0u, 10u));

} // namespace esm::test
