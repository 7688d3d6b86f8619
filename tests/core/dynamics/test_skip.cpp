// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// Who rests costs nothing, and what is left out stays within the tolerance.
#include "tests/core/dynamics/skip_nets.h"

#include <algorithm>
#include <cstdint>

namespace esm::test {
// A net without cause to move is not looked at, from the first step on.
TEST(Skip, NetAtRestCostsNothingFromTheStart)
{
  for (const Index side : {10, 60}) {
    Simulation simulation = simulate(beddedSheet(side));
    const StepReport report = simulation.advance(1.0);
    EXPECT_EQ(report.springsEvaluated, 0);
    EXPECT_EQ(report.steps, 0);
    EXPECT_EQ(report.nodesAwake, 0);
    EXPECT_EQ(report.simulatedTime, 1.0);
    EXPECT_EQ(simulation.state().time, 1.0);
  }
}

// A net that was pulled and let go ends where it began and costs nothing from then on. The rest of its
// energy, small as it is, has become heat.
TEST(Skip, SettledNetCostsNothing)
{
  Simulation simulation = simulate(beddedSheet(20));
  const ToolSpring tool = pull(simulation.net(), 210, {1e-3, 0, 2e-3}, 50.0);
  simulation.setTools({&tool, 1});
  const double before = balance(simulation);
  EXPECT_GT(simulation.advance(0.1).springsEvaluated, 0);
  simulation.setTools({});
  simulation.advance(1.0);
  const Eigen::Matrix3Xd settled = simulation.state().position;
  const StepReport report = simulation.advance(1.0);
  EXPECT_EQ(report.springsEvaluated, 0);
  EXPECT_EQ(report.nodesAwake, 0);
  EXPECT_EQ(simulation.state().position, settled);
  EXPECT_TRUE(simulation.state().velocity.isZero(0.0));
  EXPECT_DOUBLE_EQ(simulation.state().time, 2.1);
  // The quadrature of work and heat, which is as good as the tolerance asks, leaves 2e-3.
  EXPECT_NEAR(balance(simulation), before, 5e-3 * simulation.dissipatedEnergy());
}

// Whoever is touched wakes, and moves as if nobody had ever slept. Both runs have the tolerance to spend.
TEST(Skip, TouchedSleeperMovesAsIfAwake)
{
  for (const Index side : {12, 50}) {
    const SpringNet net = beddedSheet(side);
    Simulation skipping = simulate(net, {}, settingsOf(1e-3, true));
    Simulation full = simulate(net, {}, fixedSteps("verlet", 1e-4)); // error below 1e-4
    EXPECT_EQ(skipping.advance(0.1).springsEvaluated, 0);
    EXPECT_GT(full.advance(0.1).springsEvaluated, 0);
    const ToolSpring tool = pull(net, side * side / 2 + side / 2, {2e-4, 0, 5e-4}, 100.0);
    const Frames a = play(skipping, 10, {&tool, 1}), b = play(full, 10, {&tool, 1});
    EXPECT_LT(errorOf(a, b), 1e-3);
    EXPECT_GT(a.report.back().springsEvaluated + a.report.front().springsEvaluated, 0);
  }
}

/// At the end of a frame.
std::int64_t mostAwake(const Frames& frames)
{
  std::int64_t most = 0;
  for (const StepReport& report : frames.report) most = std::max(most, report.nodesAwake);
  return most;
}

// A poke into tissue that is bedded softly moves a few hundred nodes. The others sleep, and the error of all
// keeps the tolerance, with an explicit and an implicit method.
TEST(Skip, FarNodesSleepUnderALocalPoke)
{
  const SpringNet net = beddedSheet(70);
  const ToolSpring tool = pull(net, 70 * 35 + 35, {3e-4, 1e-4, 6e-4}, 200.0);
  Simulation full = simulate(net, {}, fixedSteps("verlet", 1e-4)); // error below 1e-4
  const Frames reference = play(full, 6, {&tool, 1});
  const std::pair<const char*, double> cases[] = {
    {"auto", 1e-1}, {"auto", 1e-2}, {"verlet", 1e-2}, {"implicit", 1e-1}};
  for (const auto& [solver, tolerance] : cases) {
    SCOPED_TRACE(solver);
    Simulation skipping = simulate(net, {}, settingsOf(tolerance, true, solver));
    const Frames frames = play(skipping, 6, {&tool, 1});
    EXPECT_LT(errorOf(frames, reference), tolerance);
    EXPECT_LT(mostAwake(frames), 0.5 * net.nodeCount());
    EXPECT_GT(mostAwake(frames), 100);
    EXPECT_EQ(frames.position.back().col(0), net.restPosition.col(0));
  }
}

/// A sheet that swings as a whole: amplitudes fade in 2m/c = 0.1 s.
SpringNet swingingSheet()
{
  SpringNet net = beddedSheet(110);
  net.mass.setConstant(1e-3);
  net.anchors.viscosity.setConstant(0.02);
  net.initialVelocity = Eigen::Matrix3Xd::Zero(3, net.nodeCount());
  net.initialVelocity.row(2) = net.restPosition.row(0) / net.restPosition.row(0).maxCoeff(); // [m/s]
  return net;
}

// What a motion that fades misses counts in the mean over its length: a net that has long been left alone
// rests sooner than one that has just been touched, and the error keeps the tolerance with both.
TEST(Skip, AFadingMotionSleepsTheSoonerTheLongerItHasBeenLeftAlone)
{
  constexpr int kFrames = 60, kTouch = 30;
  constexpr double kTolerance = 1e-2;
  const SpringNet net = swingingSheet();
  Simulation full = simulate(net, {}, fixedSteps("stoermer", 1e-4)); // error below 1e-6
  const Frames reference = play(full, kFrames);
  const auto framesAwake = [&](double touch) { // of one node in the mean
    Simulation simulation = simulate(net, {}, settingsOf(kTolerance, true));
    Frames frames = play(simulation, kTouch);
    if (touch > 0.0) {
      const ToolSpring tool = pull(net, 0, {0, 0, 0}, touch);
      simulation.setTools({&tool, 1});
      simulation.setTools({});
    }
    const Frames rest = play(simulation, kFrames - kTouch);
    frames.position.insert(frames.position.end(), rest.position.begin() + 1, rest.position.end());
    frames.report.insert(frames.report.end(), rest.report.begin(), rest.report.end());
    EXPECT_LT(errorOf(frames, reference), kTolerance) << touch;
    double sum = 0.0;
    for (const StepReport& report : frames.report) sum += static_cast<double>(report.nodesAwake);
    return sum / net.nodeCount();
  };
  EXPECT_LT(framesAwake(0.0) + 0.5, framesAwake(1e-6));
}

// Errors that fade may be larger for some time where the end of the motion is known, but not where nothing
// holds the displacement either: 1.2 times above the tolerance with that, up to 4 times with other dampers.
TEST(Skip, AMotionThatNothingDrivesKeepsTheToleranceToAKnownEnd)
{
  constexpr int kFrames = 30;
  const SpringNet net = swingingSheet();
  Simulation full = simulate(net, {}, fixedSteps("stoermer", 1e-4)); // error below 1e-6
  const Frames reference = play(full, kFrames);
  for (const double tolerance : {1e-2, 1e-3}) {
    SolverSettings settings = settingsOf(tolerance, true);
    settings.duration = kFrames / 60.0;
    Simulation simulation = simulate(net, {}, settings);
    EXPECT_LT(errorOf(play(simulation, kFrames), reference), tolerance);
  }
}

// Springs evaluated per frame go with the poke, not with the net.
TEST(Skip, CostGoesWithTheMovingPart)
{
  std::int64_t springs[2] = {};
  for (const Index side : {60, 120}) {
    const SpringNet net = beddedSheet(side);
    Simulation simulation = simulate(net, {}, settingsOf(1e-2, true, "verlet"));
    const ToolSpring tool = pull(net, side * (side / 2) + side / 2, {3e-4, 1e-4, 6e-4}, 200.0);
    std::int64_t& sum = springs[side == 60 ? 0 : 1] = 0;
    for (const StepReport& report : play(simulation, 6, {&tool, 1}).report) sum += report.springsEvaluated;
  }
  // A larger net makes the same displacement a smaller RMS, and so the tolerance a little tighter.
  EXPECT_LT(static_cast<double>(springs[1]), 1.3 * static_cast<double>(springs[0]));
}

// What the hand puts in is in the springs, in the motion, or has become heat, whoever slept meanwhile. The
// tolerance is about positions: at 1e-3 the first millisecond of such a jerk may be left to steps that lose
// count of a twentieth of its energy.
TEST(Skip, EnergyIsAccountedFor)
{
  const SpringNet net = beddedSheet(60);
  Simulation simulation = simulate(net, {}, settingsOf(1e-5, true));
  const double before = balance(simulation);
  const ToolSpring tool = pull(net, 60 * 30 + 30, {5e-4, 0, 5e-4}, 200.0);
  play(simulation, 10, {&tool, 1});
  EXPECT_NEAR(balance(simulation), before, 2e-3 * simulation.externalWork());
  simulation.setTools({});
  const double work = simulation.externalWork();
  const Frames frames = play(simulation, 60);
  EXPECT_EQ(frames.report.back().nodesAwake, 0);
  EXPECT_NEAR(balance(simulation), before, 2e-3 * simulation.dissipatedEnergy());
  EXPECT_EQ(simulation.externalWork(), work);
}

// A blow at one end of a long undamped bar arrives at the other, though everybody there slept: the wave wakes
// them. Its speed is 1 spring in sqrt(m/k) = 1 ms, so that after 2 s it has come to node 2,000.
TEST(Skip, WavesWakeWhomTheyReach)
{
  SpringNet net = chain(2500, 0.01, 1000.0);
  net.mass.setConstant(1e-3);
  Loads loads;
  NodalForce blow;
  blow.nodes = {0};
  Eigen::Matrix3Xd force = Eigen::Matrix3Xd::Zero(3, 3);
  force(0, 1) = 0.1;
  blow.force = curve({0.0, 0.05, 0.1}, force);
  loads.forces.push_back(blow);
  Simulation skipping = simulate(net, loads, settingsOf(1e-2, true));
  Simulation full = simulate(net, loads, settingsOf(1e-4, false));
  const Frames a = play(skipping, 126), b = play(full, 126);
  EXPECT_LT(errorOf(a, b), 1e-2);
  const double passed = full.state().position(0, 1900) - net.restPosition(0, 1900);
  EXPECT_GT(passed, 1e-4);
  EXPECT_NEAR(skipping.state().position(0, 1900) - net.restPosition(0, 1900), passed, 0.02 * passed);
  EXPECT_LT(a.report[20].nodesAwake, 1300); // and not before it comes
}

// Two runs give equal bits, also while nodes wake and fall asleep.
TEST(Skip, TwoRunsGiveEqualBits)
{
  const SpringNet net = beddedSheet(60);
  const ToolSpring tool = pull(net, 60 * 30 + 30, {5e-4, 0, 5e-4}, 200.0);
  Simulation first = simulate(net), second = simulate(net);
  const Frames a = play(first, 8, {&tool, 1}), b = play(second, 8, {&tool, 1});
  EXPECT_EQ(a.position.back(), b.position.back());
  EXPECT_EQ(a.report.back().springsEvaluated, b.report.back().springsEvaluated);
}

// Fixed steps are for convergence studies: nobody sleeps, every bit is as without skipping.
TEST(Skip, FixedStepsLeaveNobodyOut)
{
  const SpringNet net = beddedSheet(20);
  SolverSettings settings = fixedSteps("verlet", 5e-5);
  Simulation with = simulate(net, {}, settings);
  settings.skipResting = false;
  Simulation without = simulate(net, {}, settings);
  const ToolSpring tool = pull(net, 210, {5e-4, 0, 5e-4}, 200.0);
  const Frames a = play(with, 5, {&tool, 1}), b = play(without, 5, {&tool, 1});
  EXPECT_EQ(a.position.back(), b.position.back());
  EXPECT_EQ(a.report.back().nodesAwake, net.nodeCount());
}

} // namespace esm::test
