// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/runtime/frame_clock.h"

#include <gtest/gtest.h>

namespace esm {

namespace {

constexpr double kPeriod = 0.02; // [s]

/// Runs frames that take `work` each and wake up `delay` late; returns the time of the last one's start.
double run(FrameClock& clock, int frames, double work, double delay = 0.0)
{
  double now = clock.deadline(), begin = now;
  for (int i = 0; i < frames; ++i) {
    now = begin = std::max(now, clock.deadline() + delay);
    now += work;
    clock.endFrame(now, kPeriod, work);
  }
  return begin;
}

} // namespace

// Waking up 1 ms late 1000 times must not add up to a second.
TEST(FrameClock, SmallDelaysDoNotAddUp)
{
  FrameClock clock(kPeriod);
  clock.start(100.0);
  EXPECT_NEAR(run(clock, 1001, 0.005, 0.001), 100.0 + 1000 * kPeriod + 0.001, 1e-9);
  EXPECT_NEAR(clock.realTimeFactor(), 1.0, 1e-3);
  EXPECT_NEAR(clock.frameCost(), 0.25, 1e-9);
}

// Frames of four periods' work: time runs at a quarter, and once the load is gone the next frames come at
// their pace, not in a burst that makes up for the debt.
TEST(FrameClock, OverloadSlowsTimeAndLeavesNoDebt)
{
  FrameClock clock(kPeriod);
  clock.start(0.0);
  run(clock, 200, 4 * kPeriod);
  EXPECT_NEAR(clock.realTimeFactor(), 0.25, 1e-3);
  EXPECT_NEAR(clock.frameCost(), 4.0, 1e-9);
  const double before = clock.deadline();
  EXPECT_NEAR(run(clock, 51, 0.001) - before, 50 * kPeriod, 1e-9);
}

// One hiccup shorter than a period is made up for at once.
TEST(FrameClock, AFrameThatIsALittleLateIsMadeUpFor)
{
  FrameClock clock(kPeriod);
  clock.start(0.0);
  run(clock, 10, 0.001);
  run(clock, 1, 1.5 * kPeriod);
  EXPECT_NEAR(run(clock, 10, 0.001), 20 * kPeriod, 1e-9);
}

TEST(FrameClock, ThePaceIsRightFromTheFirstFrameOn)
{
  FrameClock clock(kPeriod);
  clock.start(0.0);
  run(clock, 1, 0.001);
  EXPECT_NEAR(clock.realTimeFactor(), 1.0, 1e-9);
  clock.start(50.0);
  run(clock, 1, 5 * kPeriod);
  EXPECT_NEAR(clock.realTimeFactor(), 0.2, 1e-9);
}

} // namespace esm
