// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/runtime/quality_ladder.h"

#include "core/runtime/sim_runner.h"
#include "tests/core/contact/hanging_chain.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

namespace esm {

namespace {

using enum QualityMeasure;

constexpr double kFrame = 1.0 / 60.0;

/// Frames of `load` periods each, until `seconds` have passed on the invented wall clock.
int changes(QualityLadder& ladder, double load, double seconds)
{
  int count = 0;
  for (double time = 0.0; time < seconds; time += std::max(load, 1.0) * kFrame)
    count += ladder.endFrame(load * kFrame, kFrame) ? 1 : 0;
  return count;
}

/// All rungs, by frames that are always too dear.
std::vector<QualityState> descend(QualityLadder& ladder)
{
  std::vector<QualityState> states{ladder.state()};
  for (int i = 0; i < 1000; ++i)
    if (ladder.endFrame(3.0 * kFrame, kFrame)) states.push_back(ladder.state());
  return states;
}

QualityLadder started(QualityPlan plan = {})
{
  QualityLadder ladder(std::move(plan));
  ladder.start({});
  return ladder;
}

} // namespace

// The order of the issue: tolerance first, then the solver's effort, then the clock.
TEST(QualityLadder, GivesWayInTheUsersOrder)
{
  QualityLadder ladder = started();
  const std::vector<QualityState> states = descend(ladder);
  ASSERT_EQ(states.size(), 6u);
  const QualityMeasure measures[] = {SlowMotion, Tolerance, Tolerance, Effort, Effort, SlowMotion};
  const double tolerances[] = {0.01, 0.05, 0.2, 0.2, 0.2, 0.2};
  const double efforts[] = {2e6, 2e6, 2e6, 5e5, 1.25e5, 1.25e5};
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(states[i].rung, i);
    EXPECT_EQ(states[i].lastRung, 5u);
    EXPECT_EQ(states[i].measure, measures[i]) << i;
    EXPECT_NEAR(states[i].tolerance, tolerances[i], 1e-12) << i;
    EXPECT_EQ(states[i].effort, efforts[i]) << i;
    EXPECT_EQ(states[i].wantedTolerance, 0.01);
  }
}

TEST(QualityLadder, AnotherOrderAndWhatStandsAfterTheClock)
{
  QualityPlan plan;
  plan.order = {Effort, SlowMotion, Tolerance};
  QualityLadder ladder = started(plan);
  const std::vector<QualityState> states = descend(ladder);
  ASSERT_EQ(states.size(), 4u); // wanted, two of effort, slow motion
  EXPECT_EQ(states[1].measure, Effort);
  EXPECT_EQ(states.back().measure, SlowMotion);
  EXPECT_EQ(states.back().tolerance, 0.01); // the tolerance is never touched
}

TEST(QualityLadder, StopsAtTheLowestAllowedAccuracy)
{
  QualityPlan plan;
  plan.order = {Tolerance};
  plan.coarsest = 0.06; // 0.05 would be followed by a tiny step
  QualityLadder ladder = started(plan);
  const std::vector<QualityState> states = descend(ladder);
  ASSERT_EQ(states.size(), 3u);
  EXPECT_EQ(states[1].tolerance, 0.06);
  EXPECT_EQ(states[2].tolerance, 0.06);
}

// A project that wants less than the preview gives is taken at its word; a coarser limit is no order to
// worsen.
TEST(QualityLadder, ALooserProjectIsNotMadeFiner)
{
  QualityLadder ladder;
  ladder.setPlan({});
  SolverSettings settings;
  settings.tolerance = 0.5;
  settings.effort = 1e5;
  ladder.start(settings);
  EXPECT_EQ(ladder.tolerance(), 0.5);
  EXPECT_EQ(ladder.effort(), 1e5);
  EXPECT_EQ(descend(ladder).back().tolerance, 0.5);
}

// Fixed steps have no accuracy to choose: only the clock is left. Nor does it give way without a plan.
TEST(QualityLadder, FixedStepsAndNoPlanLeaveTheClock)
{
  SolverSettings settings;
  settings.fixedStep = 1e-5;
  QualityLadder ladder((QualityPlan()));
  ladder.start(settings);
  EXPECT_EQ(ladder.state().lastRung, 1u);
  QualityLadder none;
  none.start({});
  EXPECT_EQ(none.state().lastRung, 1u);
  EXPECT_EQ(none.tolerance(), SolverSettings().tolerance);
  EXPECT_EQ(none.effort(), SolverSettings().effort);
}

TEST(QualityLadder, SingleDearFramesDoNotCount)
{
  QualityLadder ladder = started();
  int count = 0;
  for (int frame = 0; frame < 2000; ++frame) // the solver checks its error: three times the cost
    count += ladder.endFrame((frame % 12 == 0 ? 2.4 : 0.8) * kFrame, kFrame) ? 1 : 0;
  EXPECT_EQ(count, 0);
  EXPECT_EQ(ladder.state().rung, 0u);
}

TEST(QualityLadder, BetweenTheLimitsNothingChanges)
{
  QualityLadder ladder = started();
  EXPECT_EQ(changes(ladder, 0.7, 60.0), 0);
  descend(ladder);
  ASSERT_EQ(changes(ladder, 0.7, 60.0), 1); // out of slow motion: it does keep up
  EXPECT_EQ(ladder.state().rung, 4u);
  EXPECT_EQ(changes(ladder, 0.7, 60.0), 0);
}

TEST(QualityLadder, GoesUpAgainWhenItIsLight)
{
  QualityLadder ladder = started();
  descend(ladder);
  EXPECT_EQ(changes(ladder, 0.1, 30.0), 5);
  EXPECT_EQ(ladder.state().rung, 0u);
  EXPECT_EQ(ladder.tolerance(), 0.01);
}

// A scene that is light on rung 1 and heavy on rung 0: it looks up ever more seldom instead of swinging.
TEST(QualityLadder, DoesNotSwing)
{
  QualityLadder ladder = started();
  const auto visits = [&](double seconds) {
    int count = 0;
    for (double time = 0.0; time < seconds;) {
      const double load = ladder.state().rung == 0 ? 1.3 : 0.4;
      time += std::max(load, 1.0) * kFrame;
      count += ladder.endFrame(load * kFrame, kFrame) ? 1 : 0;
    }
    return count;
  };
  EXPECT_LE(visits(60.0), 13); // 1 + 2 + 4 + 8 + 16 + 32 s of patience
  EXPECT_LE(visits(600.0), 22);
  EXPECT_LE(ladder.state().rung, 1u);
  ladder.start({}); // another scene: hope again
  EXPECT_EQ(ladder.state().rung, 0u);
}

// Pulls that are too dear, with rests between: each one makes the next way up no slower while nothing moves, and what
// the last one needed is found again at the first sign, not rung by rung.
TEST(QualityLadder, WhileNothingMovesItIsSoonAsWanted)
{
  QualityLadder ladder = started();
  const auto rest = [&](double seconds) {
    for (double time = 0.0; time < seconds; time += kFrame) ladder.endFrame(0.01 * kFrame, kFrame, true);
  };
  changes(ladder, 3.0, 5.0);
  for (int pull = 0; pull < 10; ++pull) {
    rest(2.5);
    EXPECT_EQ(ladder.state().rung, 3u) << "a rung a second";
    EXPECT_EQ(changes(ladder, 3.0, 0.5), 1) << pull;
    EXPECT_EQ(ladder.state().rung, 5u);
  }
  rest(6.0);
  EXPECT_EQ(ladder.state().rung, 0u);
  // A light motion forgets what others needed: then it is found out anew.
  changes(ladder, 0.6, 4.0);
  EXPECT_EQ(changes(ladder, 3.0, 0.2), 1);
  EXPECT_EQ(ladder.state().rung, 1u);
}

// Whatever the frames cost: no debt builds up, and at the end of the ladder it stays.
TEST(QualityLadder, HopelessScenesReachTheEndSoonAndStay)
{
  QualityLadder ladder = started();
  EXPECT_EQ(changes(ladder, 3.0, 5.0), 5); // 50 ms is the longest frame
  EXPECT_EQ(changes(ladder, 1e6, 1e7), 0);
  EXPECT_EQ(ladder.state().rung, ladder.state().lastRung);
  for (const double odd :
       {std::numeric_limits<double>::quiet_NaN(), -1.0, std::numeric_limits<double>::infinity()})
    EXPECT_FALSE(ladder.endFrame(odd, kFrame));
}

TEST(QualityLadder, TheOrderAsText)
{
  EXPECT_EQ(formatQualityOrder(QualityPlan().order), "tolerance,effort,slow-motion");
  for (const char* text : {"", "effort", "slow-motion,tolerance", "effort,tolerance,slow-motion"}) {
    const auto order = parseQualityOrder(text);
    ASSERT_TRUE(order) << text;
    EXPECT_EQ(formatQualityOrder(*order), text);
  }
  for (const char* text : {"speed", "effort,effort", ",", "tolerance, effort"})
    EXPECT_FALSE(parseQualityOrder(text)) << text;
}

// === On a running net

namespace {

struct LadderRun : testing::Test {
  TripleBuffer<ToolState> tool;
  TripleBuffer<ContactModel> contact;
  SimRunner runner{60.0, tool, contact};
  SimSnapshot picture;

  void load(double stiffness, SolverSettings settings = {}, Index nodes = 6)
  {
    Loads loads;
    loads.gravity = {0.0, 0.0, -9.81};
    runner.apply(command::Load{1, chain(nodes, stiffness), loads, settings});
    runner.apply(command::Play{});
  }
  const SimSnapshot& draw() { return runner.draw(picture), picture; }
};

} // namespace

// A change of accuracy in the midst of motion moves nothing, and the motion goes on: the same chain, 20 times
// coarser from the middle on, ends within the coarse tolerance of the fine one.
TEST_F(LadderRun, AccuracyChangesInTheMidstOfMotion)
{
  runner.apply(command::SetQuality{{}});
  load(100.0);
  for (int i = 0; i < 30; ++i) runner.runFrame();
  const Eigen::Matrix3Xd before = draw().position;
  const Energies energies = draw().energies;
  EXPECT_EQ(draw().stability, Stability::Good);
  for (int i = 0; i < 100 && draw().quality.rung < 2; ++i) runner.keepTime(0.05);
  EXPECT_EQ(draw().quality.tolerance, 0.2);
  EXPECT_EQ(draw().stability, Stability::Rough);
  EXPECT_EQ(draw().position, before);
  EXPECT_EQ(draw().energies.total(), energies.total());
  for (int i = 0; i < 30; ++i) runner.runFrame();
  const Eigen::Matrix3Xd coarse = draw().position;
  EXPECT_NEAR(draw().time, 1.0, 1e-9);

  runner.apply(command::SetQuality{QualityPlan::clockOnly()});
  load(100.0, {"auto", 1e-5});
  for (int i = 0; i < 60; ++i) runner.runFrame();
  EXPECT_EQ(draw().stability, Stability::Good);
  const double moved = (draw().position - chain(6).restPosition).norm();
  EXPECT_LT((draw().position - coarse).norm(), 0.2 * moved);
}

// What is given up must save work: a chain in fast motion at 1e-4 and 0.2.
TEST_F(LadderRun, CoarserIsCheaper)
{
  const auto springs = [&](bool coarse) {
    QualityPlan plan;
    plan.finest = 1e-4;
    runner.apply(command::SetQuality{plan});
    load(1e4, {"auto", 1e-4});
    if (coarse)
      while (draw().quality.rung < draw().quality.lastRung) runner.keepTime(0.05);
    std::int64_t sum = 0;
    for (int i = 0; i < 60; ++i) {
      runner.runFrame();
      sum += draw().report.springsEvaluated;
    }
    return sum;
  };
  EXPECT_LT(2 * springs(true), springs(false));
}

// So stiff that explicit steps of 16 us would be needed: implicit steps keep the wanted tolerance for less,
// and it says so with the place.
TEST_F(LadderRun, TheLightTellsOfStiffness)
{
  load(1e7, {"auto", 1e-1}, 100);
  for (int i = 0; i < 5; ++i) runner.runFrame();
  EXPECT_EQ(draw().stability, Stability::Implicit);
  EXPECT_NE(draw().message.find("node"), std::string::npos) << draw().message;
  EXPECT_NE(draw().message.find("implicit"), std::string::npos) << draw().message;
  // With next to no effort allowed, the tolerance goes too.
  load(1e12, {"auto", 1e-3, 0.0, 1, 1e3});
  for (int i = 0; i < 5; ++i) runner.runFrame();
  EXPECT_EQ(draw().stability, Stability::Rough);
  EXPECT_TRUE(draw().report.rough);
  EXPECT_TRUE(draw().position.allFinite());
  // Asked for by name it is no surprise.
  load(1e9, {"implicit", 1e-3});
  for (int i = 0; i < 5; ++i) runner.runFrame();
  EXPECT_EQ(draw().stability, Stability::Good);
}

// Frames that are broken off are the clock's doing: what the engine says of itself stays.
TEST_F(LadderRun, TheLimitOfASliceIsNoReason)
{
  load(1e8, {"verlet", 1e-3, 1e-7, 1});
  const std::string why = draw().message;
  EXPECT_FALSE(why.empty());
  runner.runFrame([] { return true; });
  EXPECT_LT(draw().time, 1e-5); // 64 steps
  EXPECT_EQ(draw().message, why);
  runner.runFrame([] { return true; });
  EXPECT_EQ(draw().message, why);
}

// Let go after pulls that were too heavy for the machine, and come to rest: as wanted again within some seconds.
TEST_F(LadderRun, AtRestTheQualityComesBack)
{
  runner.apply(command::SetQuality{{}});
  runner.apply(command::Load{1, chain(6, 100.0), {}, {}}); // without weight
  runner.apply(command::Play{});
  const auto rest = [&](int seconds) {
    for (int frame = 0; frame < 60 * seconds; ++frame) {
      runner.runFrame();
      runner.keepTime(1e-4);
    }
  };
  for (int pull = 0; pull < 8; ++pull) {
    for (int frame = 0; frame < 60; ++frame) runner.keepTime(0.05);
    EXPECT_EQ(draw().quality.rung, draw().quality.lastRung);
    rest(4);
  }
  rest(2);
  EXPECT_EQ(draw().report.nodesAwake, 0);
  EXPECT_EQ(draw().quality.rung, 0u);
  EXPECT_EQ(draw().stability, Stability::Good);
}

TEST_F(LadderRun, OnlyPlayingFramesCount)
{
  runner.apply(command::SetQuality{{}});
  load(100.0);
  runner.apply(command::Pause{});
  for (int i = 0; i < 1000; ++i) runner.keepTime(1.0);
  EXPECT_EQ(draw().quality.rung, 0u);
}

} // namespace esm
