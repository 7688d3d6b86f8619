// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/runtime/frame_clock.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace esm {

namespace {

constexpr double kPeriod = 0.02; // [s]

/// A wall clock of our own and the frames that run by it.
class FrameClockTest : public testing::Test {
protected:
  void start(double time)
  {
    now = time;
    clock.start(now);
  }
  /// Runs frames that take `work` each and wake up `delay` late; returns when the last one began [s].
  double run(int frames, double work, double delay = 0.0)
  {
    double begin = now;
    for (int i = 0; i < frames; ++i) {
      begin = std::max(now, clock.deadline() + delay);
      now = begin + work;
      clock.endFrame(now, kPeriod, work);
    }
    return begin;
  }

  FrameClock clock{kPeriod};
  double now = 0.0;
};

} // namespace

// Waking up 1 ms late 1000 times must not add up to a second.
TEST_F(FrameClockTest, SmallDelaysDoNotAddUp)
{
  start(100.0);
  EXPECT_NEAR(run(1001, 0.005, 0.001), 100.0 + 1000 * kPeriod + 0.001, 1e-9);
  EXPECT_NEAR(clock.realTimeFactor(), 1.0, 1e-3);
  EXPECT_NEAR(clock.frameCost(), 0.25, 1e-9);
}

// Frames of four periods' work: time runs at a quarter, and once the load is gone the next frames come at
// their pace, not in a burst that makes up for the debt.
TEST_F(FrameClockTest, OverloadSlowsTimeAndLeavesNoDebt)
{
  start(0.0);
  run(200, 4 * kPeriod);
  EXPECT_NEAR(clock.realTimeFactor(), 0.25, 1e-3);
  EXPECT_NEAR(clock.frameCost(), 4.0, 1e-9);
  const double first = run(1, 0.001);
  EXPECT_NEAR(run(50, 0.001) - first, 50 * kPeriod, kPeriod + 1e-9); // the first one may still be caught up
}

// One hiccup shorter than a period is made up for at once.
TEST_F(FrameClockTest, AFrameThatIsALittleLateIsMadeUpFor)
{
  start(0.0);
  run(10, 0.001);
  run(1, 1.5 * kPeriod);
  EXPECT_NEAR(run(10, 0.001), 20 * kPeriod, 1e-9);
}

TEST_F(FrameClockTest, ThePaceIsRightFromTheFirstFrameOn)
{
  start(0.0);
  run(1, 0.001);
  EXPECT_NEAR(clock.realTimeFactor(), 1.0, 1e-9);
  start(50.0);
  run(1, 5 * kPeriod);
  EXPECT_NEAR(clock.realTimeFactor(), 0.2, 1e-9);
}

} // namespace esm
