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

// A frame that hangs for a second: known within 100 ms, by the times alone, while nothing has ended yet.
TEST_F(FrameClockTest, AFrameThatHangsIsKnownBeforeItEnds)
{
  start(0.0);
  run(100, 0.005);
  const double due = clock.deadline();
  EXPECT_FALSE(clock.paceAt(due).isSlow());
  EXPECT_EQ(clock.paceAt(due).lag, 0.0);
  double factor = clock.paceAt(due + kPeriod).realTimeFactor;
  EXPECT_FALSE(clock.paceAt(due + kPeriod).isSlow());
  for (int i = 1; i <= 50; ++i) {
    const Pace pace = clock.paceAt(due + (1 + i) * kPeriod);
    EXPECT_NEAR(pace.lag, i * kPeriod, 1e-9);
    EXPECT_NEAR(pace.frameTime, (1 + i) * kPeriod, 1e-9);
    EXPECT_LT(pace.realTimeFactor, factor);
    EXPECT_TRUE(pace.isSlow() || i < 2) << i; // 40 ms
    factor = pace.realTimeFactor;
  }
  EXPECT_LT(factor, 0.2);
  // And what is said is no worse than what is true once it ends.
  const double end = due + 51 * kPeriod;
  const Pace before = clock.paceAt(end);
  clock.endFrame(end, kPeriod, 1.0);
  EXPECT_NEAR(clock.paceAt(end).realTimeFactor, before.realTimeFactor, 1e-12);
  EXPECT_NEAR(clock.paceAt(end).lag, before.lag, 1e-12);
  EXPECT_EQ(clock.paceAt(end).frameTime, 0.0);
}

// A step of a second, asked for in frames of 50 ms that each come back with nothing: the same as one that hangs.
TEST_F(FrameClockTest, FramesThatGetNowhereAreOneThatHangs)
{
  start(0.0);
  run(100, 0.005);
  FrameClock hanging = clock;
  const double due = clock.deadline();
  for (int i = 1; i <= 20; ++i) {
    now = due + 0.05 * i;
    clock.endFrame(now, 0.0, 0.05);
    EXPECT_EQ(clock.paceAt(now).realTimeFactor, hanging.paceAt(now).realTimeFactor);
    EXPECT_NEAR(clock.paceAt(now).lag, std::max(0.0, 0.05 * i - kPeriod), 1e-9);
    EXPECT_NEAR(clock.paceAt(now).frameTime, 0.05 * i, 1e-9);
    EXPECT_LE(clock.deadline(), now); // the next one starts at once
  }
  clock.endFrame(now, kPeriod, 0.0);
  hanging.endFrame(now, kPeriod, 1.0);
  EXPECT_EQ(clock.realTimeFactor(), hanging.realTimeFactor());
  EXPECT_NEAR(clock.frameCost(), hanging.frameCost(), 1e-9);
}

// Frames of four periods each, one after the other: three periods behind at each end, and no less between.
TEST_F(FrameClockTest, TheLagOfSlowMotionIsSteady)
{
  start(0.0);
  run(20, 4 * kPeriod);
  EXPECT_NEAR(clock.paceAt(now).lag, 3 * kPeriod, 1e-9);
  EXPECT_NEAR(clock.paceAt(now + 2 * kPeriod).lag, 3 * kPeriod, 1e-9);
  EXPECT_NEAR(clock.paceAt(now + 5 * kPeriod).lag, 4 * kPeriod, 1e-9);
  run(2, 0.001); // in time again: nothing is owed
  EXPECT_NEAR(clock.paceAt(now).lag, 0.0, 1e-9);
}

// A frame that ends on the grid but has moved the net by a quarter of it is three quarters behind.
TEST_F(FrameClockTest, AFrameBrokenOffIsBehind)
{
  start(0.0);
  clock.endFrame(kPeriod, 0.25 * kPeriod, kPeriod);
  EXPECT_NEAR(clock.paceAt(kPeriod).lag, 0.75 * kPeriod, 1e-12);
}

// Before the first frame has ended nothing is known but how long it takes.
TEST_F(FrameClockTest, TheFirstFrameCountsFromTheStart)
{
  start(0.0);
  run(20, 10 * kPeriod); // of another run
  start(50.0);
  EXPECT_NEAR(clock.paceAt(50.0).realTimeFactor, 1.0, 1e-12);
  EXPECT_EQ(clock.paceAt(50.0).lag, 0.0);
  EXPECT_NEAR(clock.paceAt(50.0 + 5 * kPeriod).realTimeFactor, 0.2, 1e-12);
}

} // namespace esm
