// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// How much a stretch may err, and what becomes of it.
#include "core/dynamics/planner/error_gauge.h"
#include "tests/support/nets.h"
#include "tests/support/physics.h"

#include <cmath>
#include <limits>

namespace esm::test {
namespace {

constexpr double kStretch = 1.0 / 120.0;

/// A node that stands 1 m from where it was.
struct Displaced {
  SpringNet net = chain(2);
  System system{net, {}};
  MotionState state = startOf(net);
  ErrorGauge gauge;

  explicit Displaced(double duration)
  {
    gauge.begin(state.x, 1.0, duration);
    for (Lanes& x : state.x) x[1] += 1.0;
  }
};

/// Errors over the displacement of a motion whose errors fade in `life` and which spends in each stretch what
/// it may.
struct Spent {
  double mean = 0.0, peak = 0.0;
};

Spent spend(double life, double duration, double tolerance)
{
  Displaced motion(duration);
  ErrorScale scale;
  scale.displacement = 1.0;
  scale.recentPath = 1e12; // nothing creeps
  scale.recentKinetic = scale.latestKinetic = life / 8.0;
  scale.recentHeat = scale.latestHeat = std::isfinite(life) ? 1.0 : 0.0;
  Spent result;
  const auto count = std::lround(duration / kStretch);
  for (long i = 1; i <= count; ++i) {
    motion.state.time = static_cast<double>(i) * kStretch;
    scale.squareOverTime = motion.state.time;
    motion.gauge.setScale(scale);
    scale.spent =
      scale.spent * std::exp(-kStretch / life) + motion.gauge.budget(tolerance, motion.state, kStretch);
    scale.spentSquare += scale.spent * scale.spent * kStretch;
    result.peak = std::max(result.peak, scale.spent);
  }
  result.mean = std::sqrt(scale.spentSquare / duration);
  return result;
}

} // namespace

// What a net errs while it is held lives on when it is let go, and its displacement, by which errors are
// measured, does not: until then a fifth of the tolerance has to do. Six of seven sheets with all of it ended
// above.
TEST(ErrorGauge, BeforeNodesAreLetGoLessMayBeSpent)
{
  Displaced motion(2.0), released(2.0);
  released.gauge.expectRelease(1.0);
  for (const double time : {0.1, 0.5, 0.99}) {
    motion.state.time = released.state.time = time;
    const double all = motion.gauge.unspent(1e-3, motion.state);
    ASSERT_GT(all, 0.0);
    EXPECT_LE(released.gauge.unspent(1e-3, released.state), 0.2 * all) << time;
    EXPECT_LE(released.gauge.budget(1e-3, released.state, kStretch),
              0.2 * motion.gauge.budget(1e-3, motion.state, kStretch))
      << time;
  }
  released.gauge.expectRelease(std::numeric_limits<double>::infinity()); // it has been
  EXPECT_EQ(released.gauge.unspent(1e-3, released.state), motion.gauge.unspent(1e-3, motion.state));
}

// Four fifths of the tolerance are spent on purpose, in the mean over the time that is looked at. What lives
// long spends at least half in the mean; what dies soon is bound by its peak, which comes before much of it
// was there.
TEST(ErrorGauge, SpendsTheToleranceInTheMeanAndNoMore)
{
  constexpr double kForever = std::numeric_limits<double>::infinity();
  for (const double duration : {0.5, 1.0, 2.0})
    for (const double life : {0.1, 0.3, 1.0, 10.0, kForever}) {
      const Spent spent = spend(life, duration, 1e-3);
      EXPECT_LE(spent.mean, 1e-3) << life << " s of " << duration;
      EXPECT_LE(spent.peak, 2e-3) << life << " s of " << duration;
      EXPECT_GE(spent.mean, life >= duration ? 0.5e-3 : 0.0) << life << " s of " << duration;
      EXPECT_GE(spent.peak, 0.5e-3) << life << " s of " << duration;
    }
}

// What has been struck swings out, and its displacement with it: the mean up to the end, by which the error is
// measured, is a fraction of what was there when most was spent. The errors fade as the motion does.
TEST(ErrorGauge, AfterABlowTheMeanOfAFadingMotionIsSpent)
{
  for (const double duration : {0.3, 1.0, 3.0})
    for (const double life : {0.1, 0.2, 0.5}) {
      Displaced motion(duration);
      motion.gauge.expectQuiet(0.005);
      ErrorScale scale;
      scale.recentPath = 1e12; // nothing creeps
      scale.recentKinetic = scale.latestKinetic = life / 8.0;
      scale.recentHeat = scale.latestHeat = 1.0;
      const auto count = std::lround(duration / kStretch);
      for (long i = 1; i <= count; ++i) {
        motion.state.time = static_cast<double>(i) * kStretch;
        scale.displacement = std::exp(-motion.state.time / life);
        for (Lanes& x : motion.state.x) x[1] = scale.displacement;
        motion.gauge.setScale(scale);
        scale.spent =
          scale.spent * std::exp(-kStretch / life) + motion.gauge.budget(1e-3, motion.state, kStretch);
        scale.spentSquare += scale.spent * scale.spent * kStretch;
        scale.squareOverTime += scale.displacement * scale.displacement * kStretch;
      }
      EXPECT_LE(std::sqrt(scale.spentSquare), 1e-3 * std::sqrt(scale.squareOverTime))
        << life << " s of " << duration;
    }
}

// An error that is over in a twentieth of the run may be half as large again for that time as one that lives
// for a tenth of it and more: the mean is about the same.
TEST(ErrorGauge, WhatIsSoonOverMayErrMore)
{
  const Spent soon = spend(0.1, 2.0, 1e-3), late = spend(0.3, 2.0, 1e-3);
  EXPECT_GT(soon.peak, 1.3 * late.peak);
  EXPECT_NEAR(soon.mean, late.mean, 0.1e-3);
}

// Where nobody knows the end, two seconds are reckoned with; but once, at the very start, all may be spent.
TEST(ErrorGauge, ReckonsWithTwoSecondsWhereTheEndIsUnknown)
{
  Displaced unknown(0.0), known(2.0);
  EXPECT_EQ(unknown.gauge.budget(1e-3, unknown.state, kStretch), 0.8e-3);
  EXPECT_LT(known.gauge.budget(1e-3, known.state, kStretch), 0.1e-3);
  unknown.state.time = known.state.time = kStretch;
  const double most = known.gauge.budget(1e-3, known.state, kStretch);
  EXPECT_LE(unknown.gauge.budget(1e-3, unknown.state, kStretch), most);
}

// A motion whose amplitude fades as exp(-t/T) while it errs at a rate in proportion: each mode runs late by a
// time that grows evenly, so the error is t times the rate of now, however large the first ones were. It is
// taken to fade at three quarters of that, never faster.
TEST(ErrorGauge, WhatHasBeenSpentFadesWithTheMotion)
{
  const double fade = 0.2;
  Displaced motion(0.0);
  ErrorScale scale;
  scale.displacement = 1.0;
  scale.recentPath = 1e12;
  double spent = 0.0, now = 0.0;
  for (int i = 1; i <= 120; ++i) {
    // of an oscillator, kinetic energy and heat in a time dt: E/2 dt and 2 E/T dt
    scale.recentKinetic = scale.latestKinetic = 0.5;
    scale.recentHeat = scale.latestHeat = 2.0 / fade;
    scale.spent = spent;
    MotionState end = motion.state;
    end.time = i * kStretch;
    now = 1e-6 * std::exp(-end.time / fade);
    motion.gauge.setScale(scale);
    spent = motion.gauge.scaleAfter(motion.system, motion.state, end, now).spent;
    motion.state.time = end.time;
  }
  EXPECT_GE(spent, 120 * now);
  EXPECT_LE(spent, 2.5 * 120 * now); // t = 5 T, and (exp(t/(4 T)) - 1)/(t/(4 T)) is 2.0
}

// At a steady speed v a way of v t takes the time t; the gauge reckons with twice that, for what slows down.
TEST(ErrorGauge, KnowsHowLongACreepTakes)
{
  constexpr double kSpeed = 3e-3, kTime = 0.4, kMemory = 0.2;
  ErrorScale scale;
  EXPECT_TRUE(std::isinf(creepingTime(scale))); // at rest, and never moved
  scale.displacement = kSpeed * kTime;
  EXPECT_TRUE(std::isinf(creepingTime(scale)));
  scale.recentPath = kSpeed * kSpeed * kMemory;
  EXPECT_NEAR(creepingTime(scale), 2.0 * kTime, 1e-12);
}

// Where nothing is damped no error dies.
TEST(ErrorGauge, ErrorsOfUndampedMotionStay)
{
  Displaced motion(0.0);
  ErrorScale scale;
  scale.spent = 1e-3;
  motion.gauge.setScale(scale);
  MotionState end = motion.state;
  end.time += 0.5;
  EXPECT_EQ(motion.gauge.scaleAfter(motion.system, motion.state, end, 0.0).spent, 1e-3);
}

// A motion that runs late is behind along its velocity, one with too large an amplitude ahead along its
// displacement; what is off across both is neither.
TEST(ErrorGauge, TellsWhatLiesAlongTheMotion)
{
  Displaced motion(1.0); // along y
  for (Lanes& v : motion.state.v) v[0] = 2.0;
  motion.gauge.prepareSwing(motion.system, motion.state);
  const auto along = [&](double dx, double dy, double dz) {
    NodeArray x = motion.state.x;
    for (Lanes& place : x) place += Lanes{dx, dy, dz, 0};
    return motion.gauge.alongMotion(motion.system, x, motion.state.v, motion.state);
  };
  EXPECT_DOUBLE_EQ(along(-0.01, 0, 0), 1.0);
  EXPECT_DOUBLE_EQ(along(0, 0.01, 0), 1.0);
  EXPECT_DOUBLE_EQ(along(0, 0, 0.01), 0.0);
  EXPECT_DOUBLE_EQ(along(0.03, 0, 0.04), 0.6);
  EXPECT_DOUBLE_EQ(along(0, 0, 0), 0.0); // no difference, no number that is none
}

TEST(ErrorGauge, AwaitsAReleaseBeforeTheEndOnly)
{
  Displaced motion(1.0);
  EXPECT_FALSE(motion.gauge.awaitsRelease(0.5));
  motion.gauge.expectRelease(0.8);
  EXPECT_TRUE(motion.gauge.awaitsRelease(0.5));
  motion.gauge.expectRelease(1.2);
  EXPECT_FALSE(motion.gauge.awaitsRelease(0.5));
}

// Two runs of an oscillator of frequency w that are apart by (d, v): d^2 + (v/w)^2 is the same all the time,
// however the difference swings; of a light node and of a heavy one. The inertia over 0.08 s makes 2e-4 of
// it.
TEST(ErrorGauge, SeesADifferenceWhicheverWayItSwings)
{
  for (const double mass : {1e-3, 1.0}) {
    SpringNet net = chain(2);
    net.fixed[0] = 1;
    net.restLength.setConstant(1.0);
    net.mass.setConstant(mass);
    const double rate = 1.0 / std::sqrt(mass) * 600.0;
    net.stiffness.setConstant(mass * rate * rate);
    System system(net, {});
    MotionState state;
    state.x = {Lanes{0, 0, 0, 0}, Lanes{1, 0, 0, 0}};
    state.v.assign(2, Lanes{0, 0, 0, 0});
    system.enter(state, true);
    ErrorGauge gauge;
    gauge.begin(state.x, 1.0, 1.0);
    gauge.prepareSwing(system, state);
    for (const double phase : {0.0, 0.4, 1.1, 1.5708, 2.5}) {
      NodeArray x = state.x, v = state.v;
      x[1][0] += 1e-6 * std::cos(phase);
      v[1][0] += 1e-6 * rate * std::sin(phase);
      EXPECT_NEAR(gauge.swing(system, gauge.distance(x, state), v, state), 1e-6 / std::sqrt(2.0), 2e-10)
        << mass << " " << phase; // one of two nodes
    }
  }
}

// An error that grows evenly counts in full; one that swings or walks at random counts less, the more
// stretches there are for it to lose itself in, but more than sixty walks would leave of it.
TEST(ErrorGauge, TellsWhatGrowsFromWhatSwings)
{
  Displaced motion(0.5);
  const auto growing = [&](double early) { return motion.gauge.growing(0.0, kStretch, early, 1.0, 0.25); };
  EXPECT_DOUBLE_EQ(growing(0.25), 1.0);
  EXPECT_DOUBLE_EQ(growing(0.1), 1.0);
  EXPECT_LT(growing(0.3), 1.0);
  EXPECT_DOUBLE_EQ(growing(0.5), growing(1.0));
  EXPECT_GT(growing(1.0), std::sqrt(1.0 / 60.0));
  EXPECT_DOUBLE_EQ(motion.gauge.growing(0.5 - kStretch, kStretch, 1.0, 1.0, 0.25), 1.0); // it is the last
}

/// Of a net of which all nodes or only ten move; its whole tolerance of 1 is spent.
ErrorGauge spentGauge(Index nodes, bool isPart, bool isDriven = true)
{
  ErrorGauge gauge;
  gauge.begin(NodeArray(static_cast<std::size_t>(nodes)), 1.0, 0.5, isDriven);
  NodeArray part(10);
  if (isPart) gauge.setPart(part, static_cast<std::size_t>(nodes), 0.0);
  ErrorScale scale;
  scale.displacement = scale.spent = 1.0;
  scale.calm = 1.0; // no event is near
  gauge.setScale(scale);
  return gauge;
}

// The more nodes move, the more waves errors spread over: the more of an error that swings is believed to be
// lost, and the more may be spent where all is. Of a small moving part no more than of a small net.
TEST(ErrorGauge, BelievesThatErrorsOfManyNodesAreLost)
{
  const auto growing = [](Index nodes, bool isPart = false) {
    return spentGauge(nodes, isPart).growing(0.0, kStretch, 1.0, 1.0, 0.25);
  };
  EXPECT_EQ(growing(2000), growing(10));
  EXPECT_LT(growing(5000), growing(2000));
  EXPECT_LT(growing(10000), growing(5000));
  EXPECT_GT(growing(100000), 1.0 / 60.0);
  EXPECT_EQ(growing(100000, true), growing(10));
  // In the first frame after an event there are few stretches, and the first err the most.
  ErrorGauge fresh = spentGauge(100000, false);
  fresh.markEvent();
  EXPECT_EQ(fresh.growing(0.0, kStretch, 1.0, 1.0, 0.25), growing(10));

  const auto budget = [](Index nodes, bool isPart = false) {
    MotionState state;
    state.x.resize(isPart ? 10 : static_cast<std::size_t>(nodes));
    state.v.resize(state.x.size());
    state.time = 0.25;
    return spentGauge(nodes, isPart).budget(1.0, state, kStretch);
  };
  EXPECT_NEAR(budget(10), 0.8 / 60.0, 1e-12); // an even share of the run
  EXPECT_EQ(budget(2000), budget(10));
  EXPECT_GT(budget(3000), budget(10));
  EXPECT_NEAR(budget(100000), 2.0 * budget(10), 1e-12);
  EXPECT_EQ(budget(100000, true), budget(10));
}

// Small nets are guessed alike; from 2,500 nodes on a guess halves with eight times the nodes.
TEST(ErrorGauge, GuessesLessOfLargeNets)
{
  const auto shareOf = [](std::size_t nodes) {
    ErrorGauge gauge;
    gauge.begin(NodeArray(nodes), 1.0, 1.0);
    return gauge.typicalShare();
  };
  EXPECT_EQ(shareOf(0), 1.0);
  EXPECT_EQ(shareOf(2500), 1.0);
  EXPECT_DOUBLE_EQ(shareOf(20'000), 0.5);
  EXPECT_DOUBLE_EQ(shareOf(160'000), 0.25);
}

// Where nothing drives a motion the displacement fades as errors do, so that these may be no larger for some
// time, nor spread; and where it begins at once nothing yet tells what of them will be lost.
TEST(ErrorGauge, WhatNothingDrivesMayErrNoMoreForSomeTime)
{
  const auto budget = [](Index nodes, bool isDriven) {
    ErrorGauge gauge = spentGauge(nodes, false, isDriven);
    ErrorScale scale = gauge.scale();
    scale.spent = 0.5; // and little of the mean square
    scale.recentKinetic = scale.latestKinetic = 0.05 / 8.0;
    scale.recentHeat = scale.latestHeat = 1.0;
    scale.recentPath = 1e12; // it fades in 0.05 s, nothing creeps
    gauge.setScale(scale);
    MotionState state;
    state.x.resize(static_cast<std::size_t>(nodes));
    state.v.resize(state.x.size());
    state.time = 0.05;
    return gauge.budget(1.0, state, kStretch);
  };
  EXPECT_LT(budget(10, false), 0.8 * budget(10, true));
  EXPECT_NEAR(budget(100000, false), budget(10, false), 1e-12);
  const auto growing = [](double time, bool isDriven) {
    return spentGauge(100000, false, isDriven).growing(time, kStretch, 1.0, 1.0, 0.25);
  };
  EXPECT_EQ(growing(0.0, false), 1.0);
  EXPECT_LT(growing(0.0, true), 0.5);
  EXPECT_EQ(growing(0.1, false), growing(0.1, true));
  ErrorGauge gauge = spentGauge(100000, false, false);
  gauge.markDriven();
  EXPECT_EQ(gauge.growing(0.0, kStretch, 1.0, 1.0, 0.25), growing(0.0, true));
}

} // namespace esm::test
