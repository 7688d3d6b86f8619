// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// A run that was written down is done again to the bit: every scene of the bench, led by a hand, changed in
// motion, asleep, broken off, on one and two threads.
#include "bench/scenes.h"
#include "core/dynamics/simulation.h"
#include "tests/core/dynamics/skip_nets.h"
#include "tests/support/side_by_side.h"

#include <gtest/gtest.h>

#include <string>

namespace esm::test {
namespace {

constexpr double kFrame = 1.0 / 60.0;

struct Recorded {
  MotionLog log;
  NetState end;
};

/// A hand that comes, leads and goes; a patch; another accuracy. @param isBrokenOff  by a budget, every third frame
Recorded lead(const SpringNet& net, const Loads& loads, const SolverSettings& settings, int frames,
              bool isBrokenOff)
{
  Recorded recorded;
  auto simulation = Simulation::create(net, loads, settings);
  EXPECT_TRUE(simulation);
  simulation->record(&recorded.log);
  for (int frame = 0; frame < frames; ++frame) {
    if (frame >= frames / 4 && frame < frames / 2) {
      ToolSpring hand;
      hand.node = net.nodeCount() / 2;
      hand.target = net.restPosition.col(hand.node) + Eigen::Vector3d(0, 0, 1e-4 * (frame - frames / 4));
      hand.targetVelocity = {0, 0, 1e-4 / kFrame};
      hand.stiffness = 3.0 * net.stiffness.mean();
      hand.moves = frame % 2 == 0;
      simulation->setTools({&hand, 1});
    }
    if (frame == frames / 2) simulation->setTools({});
    if (frame == frames / 3) {
      ParameterPatch patch;
      for (Index s = 0; s < net.springCount(); s += 7)
        patch.springs.push_back({s, net.law[static_cast<std::size_t>(s)], 1.2 * net.stiffness[s],
                                 net.viscosity[s], net.lawParameter[s]});
      EXPECT_TRUE(simulation->setParameters(patch));
    }
    if (frame == frames / 2 + 1) {
      EXPECT_TRUE(simulation->setAccuracy(2.0 * settings.tolerance, settings.effort));
    }
    int left = 3;
    Budget budget;
    if (isBrokenOff && frame % 3 == 1) budget.isSpent = [&] { return left-- <= 0; };
    simulation->advance(kFrame, budget);
  }
  recorded.end = simulation->state();
  return recorded;
}

/// @return what came out otherwise
std::string replayed(const SpringNet& net, const Loads& loads, SolverSettings settings, int threads,
                     const Recorded& recorded)
{
  settings.threads = threads;
  auto simulation = Simulation::create(net, loads, settings);
  EXPECT_TRUE(simulation);
  for (const LogEntry& entry : recorded.log) {
    const Result<std::string> difference = simulation->replay(entry);
    if (!difference) return difference.error().detail;
    if (!difference->empty()) return *difference;
  }
  EXPECT_EQ(simulation->state().time, recorded.end.time);
  return simulation->state().position == recorded.end.position &&
             simulation->state().velocity == recorded.end.velocity
           ? ""
           : "the ends differ";
}

std::int64_t keptSteps(const MotionLog& log)
{
  std::int64_t steps = 0;
  for (const LogEntry& entry : log)
    if (const auto* advance = std::get_if<logged::Advance>(&entry))
      for (const auto& part : advance->parts)
        for (const Stretch& stretch : part.stretches) steps += stretch.steps;
  return steps;
}

class Replay : public testing::TestWithParam<const char*> {};

TEST_P(Replay, EverySceneOfTheBenchEqualsItself)
{
  auto scene = bench::makeScene(GetParam());
  ASSERT_TRUE(scene);
  for (const bool inTime : {false, true}) {
    SolverSettings settings = settingsOf(1e-2, true);
    settings.keepsTime = inTime;
    if (inTime) settings.effort = 20.0 * static_cast<double>(scene->net.springCount());
    const Recorded recorded = lead(scene->net, scene->loads, settings, 24, inTime);
    EXPECT_GT(keptSteps(recorded.log), 0);
    for (const int threads : {1, 2})
      EXPECT_EQ(replayed(scene->net, scene->loads, settings, threads, recorded), "")
        << GetParam() << " on " << threads << (inTime ? " in time" : "");
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Replay,
                         testing::Values("tube", "uterus", "sheet:size=0.2", "stiff", "organ100k:size=0.03"),
                         [](const auto& scene) {
                           const std::string name = scene.param;
                           return name.substr(0, name.find(':'));
                         });

// Two organs of which one sleeps, and a budget that ends while the other moves.
TEST(MotionLog, IslandsAndSleepAreWrittenDown)
{
  const SpringNet moving = beddedSheet(24), resting = beddedSheet(10);
  const test::Scene scene = sideBySide({{moving, {}}, {resting, {}}});
  const SolverSettings settings = settingsOf(1e-3, true);
  for (const bool isBrokenOff : {false, true}) {
    const Recorded recorded = lead(scene.net, scene.loads, settings, 40, isBrokenOff);
    for (const int threads : {1, 2})
      EXPECT_EQ(replayed(scene.net, scene.loads, settings, threads, recorded), "") << threads;
  }
}

// Stretches follow each other without gaps or overlaps while the net is awake, though checks take many back.
TEST(MotionLog, StretchesAreThoseThatWereKept)
{
  auto scene = bench::makeScene("tube");
  ASSERT_TRUE(scene);
  SolverSettings settings = settingsOf(1e-4, false);
  const Recorded recorded = lead(scene->net, scene->loads, settings, 30, false);
  double time = 0.0;
  for (const LogEntry& entry : recorded.log)
    if (const auto* advance = std::get_if<logged::Advance>(&entry)) {
      for (const Stretch& stretch : advance->parts.at(0).stretches) {
        EXPECT_EQ(stretch.begin, time);
        EXPECT_GT(stretch.end, stretch.begin);
        time = stretch.end;
      }
      EXPECT_EQ(time, advance->time);
    }
  EXPECT_NEAR(time, 30 * kFrame, 1e-12);
}

// A net that is softer by a hair, and steps that were written down wrongly.
TEST(MotionLog, ADifferenceIsSaidWithItsPlace)
{
  auto scene = bench::makeScene("tube");
  ASSERT_TRUE(scene);
  const SolverSettings settings = settingsOf(1e-2, true);
  Recorded recorded = lead(scene->net, scene->loads, settings, 12, false);
  SpringNet other = scene->net;
  other.stiffness *= 1.0 + 1e-12;
  const std::string differs = replayed(other, scene->loads, settings, 1, recorded);
  EXPECT_NE(differs.find("though the steps are the same"), std::string::npos) << differs;
  for (LogEntry& entry : recorded.log)
    if (auto* advance = std::get_if<logged::Advance>(&entry);
        advance && !advance->parts[0].stretches.empty()) {
      advance->parts[0].stretches[0].steps += 1;
      break;
    }
  const std::string said = replayed(scene->net, scene->loads, settings, 1, recorded);
  EXPECT_NE(said.find("part 1 took"), std::string::npos) << said;
  EXPECT_NE(said.find("the log says"), std::string::npos) << said;
}

TEST(MotionLog, EntriesOfAnotherNetAreRefused)
{
  auto simulation = Simulation::create(beddedSheet(5), {}, settingsOf(1e-2, true));
  ASSERT_TRUE(simulation);
  ToolSpring hand;
  hand.node = 25;
  EXPECT_FALSE(simulation->replay(logged::Tools{{hand}}));
  logged::Advance advance;
  advance.interval = kFrame;
  advance.parts.resize(2);
  EXPECT_FALSE(simulation->replay(advance));
  ParameterPatch patch;
  patch.nodes.push_back({99, 1.0, 0.0});
  EXPECT_FALSE(simulation->replay(logged::Patch{patch}));
}

} // namespace
} // namespace esm::test
