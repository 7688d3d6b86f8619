// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/runtime/sim_thread.h"

#include "tests/core/contact/hanging_chain.h"

#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <thread>

namespace esm {

namespace {

using namespace std::chrono_literals;

/// Waits for a picture with `property`, 20 s at most: the machine may be busy, nothing here is about speed.
bool waitFor(SimThread& simulation, const std::function<bool(const SimSnapshot&)>& property)
{
  for (int i = 0; i < 10000; ++i) {
    if (property(simulation.latest())) return true;
    std::this_thread::sleep_for(2ms);
  }
  return false;
}

Loads gravity()
{
  Loads loads;
  loads.gravity = {0.0, 0.0, -9.81};
  return loads;
}

} // namespace

TEST(SimThread, StartsIdle)
{
  SimThread simulation;
  EXPECT_EQ(simulation.latest().stability, Stability::Idle);
  EXPECT_EQ(simulation.latest().generation, 0u);
}

TEST(SimThread, TimeAndSequenceRiseWhilePlaying)
{
  SimThread simulation(200.0);
  simulation.load(chain(6), gravity(), {});
  simulation.play();
  double time = 0.0;
  std::uint64_t sequence = 0;
  while (time < 0.3) {
    const SimSnapshot& picture = simulation.latest();
    ASSERT_GE(picture.sequence, sequence);
    ASSERT_GE(picture.time, time);
    ASSERT_TRUE(picture.position.allFinite());
    time = picture.time;
    sequence = picture.sequence;
    std::this_thread::sleep_for(1ms);
  }
  EXPECT_GT(simulation.latest().realTimeFactor, 0.0);
}

// Simulated time never runs ahead of the wall's (a frame early at most, and the pictures come after the
// fact).
TEST(SimThread, NeverRunsAheadOfTheWallClock)
{
  SimThread simulation(100.0);
  simulation.load(chain(3), {}, {});
  const auto begin = std::chrono::steady_clock::now();
  simulation.play();
  ASSERT_TRUE(waitFor(simulation, [](const SimSnapshot& p) { return p.time > 0.25; }));
  const double time = simulation.latest().time;
  const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  EXPECT_LE(time, wall + 0.011);
}

TEST(SimThread, PausingReallyPauses)
{
  SimThread simulation(200.0);
  simulation.load(chain(6), gravity(), {});
  simulation.play();
  ASSERT_TRUE(waitFor(simulation, [](const SimSnapshot& p) { return p.time > 0.05; }));
  simulation.pause();
  ASSERT_TRUE(waitFor(simulation, [](const SimSnapshot& p) { return !p.playing; }));
  const std::uint64_t sequence = simulation.latest().sequence;
  const double time = simulation.latest().time;
  std::this_thread::sleep_for(50ms);
  EXPECT_EQ(simulation.latest().sequence, sequence); // not even a picture: it sleeps
  EXPECT_EQ(simulation.latest().time, time);
  EXPECT_EQ(simulation.latest().realTimeFactor, 0.0);
}

// Ten single steps, ordered at once, are ten frames; the reset that follows them comes after them.
TEST(SimThread, CommandsTakeEffectInOrder)
{
  SimThread simulation(100.0);
  simulation.load(chain(6), gravity(), {});
  simulation.stepOnce();
  ASSERT_TRUE(waitFor(simulation, [](const SimSnapshot& p) { return p.time > 0.0; }));
  EXPECT_NEAR(simulation.latest().time, 0.01, 1e-12);
  simulation.play();
  simulation.pause();
  simulation.reset();
  simulation.setFrameRate(50.0);
  simulation.stepOnce();
  ASSERT_TRUE(waitFor(simulation, [](const SimSnapshot& p) { return std::abs(p.time - 0.02) < 1e-12; }));
  EXPECT_FALSE(simulation.latest().playing);
}

TEST(SimThread, GenerationsTellThePicturesOfTwoNetsApart)
{
  SimThread simulation(200.0);
  const std::uint64_t first = simulation.load(chain(6), gravity(), {});
  simulation.play();
  ASSERT_TRUE(
    waitFor(simulation, [&](const SimSnapshot& p) { return p.generation == first && p.time > 0.0; }));
  const std::uint64_t second = simulation.load(chain(9), gravity(), {});
  EXPECT_GT(second, first);
  ASSERT_TRUE(waitFor(simulation, [&](const SimSnapshot& p) {
    EXPECT_EQ(p.position.cols(), p.generation == first ? 6 : 9);
    return p.generation == second;
  }));
  EXPECT_EQ(simulation.latest().time, 0.0);
  EXPECT_FALSE(simulation.latest().playing);
}

TEST(SimThread, ARefusedNetLeavesTheFormerOneAndSaysWhy)
{
  SimThread simulation(200.0);
  const std::uint64_t first = simulation.load(chain(6), gravity(), {});
  simulation.play();
  SpringNet bad = chain(4);
  bad.mass[2] = -1.0;
  simulation.load(bad, {}, {});
  ASSERT_TRUE(
    waitFor(simulation, [](const SimSnapshot& p) { return p.message.find("mass") != std::string::npos; }));
  EXPECT_EQ(simulation.latest().generation, first);
  const double time = simulation.latest().time;
  EXPECT_TRUE(waitFor(simulation, [&](const SimSnapshot& p) { return p.time > time; }));
}

TEST(SimThread, AGrabbedNodeMovesTowardsTheHand)
{
  SimThread simulation(120.0);
  simulation.load(chain(6), {}, {});
  simulation.play();
  simulation.grab(5, {0.05, 0.02, 0.0}, 2.0);
  EXPECT_TRUE(waitFor(simulation, [](const SimSnapshot& p) {
    EXPECT_LE(p.toolForce.norm(), 2.0 + 1e-9);
    return p.grabbedNode == 5 && p.position(1, 5) > 0.01;
  }));
  simulation.release();
  EXPECT_TRUE(waitFor(simulation, [](const SimSnapshot& p) { return p.grabbedNode == kNoIndex; }));
}

// Three threads: this one orders, the servo's writes tools and reads models, the simulation's is in between.
// Under the thread sanitizer this is the test of all hand-overs.
TEST(SimThread, HandsOverBetweenThreeThreads)
{
  SimThread simulation(500.0);
  simulation.load(chain(12), gravity(), {});
  simulation.followDevice(true);
  simulation.grab(11, {0.11, 0.0, 0.0});
  simulation.play();
  std::atomic<std::uint64_t> models{0};
  std::jthread servo([&](const std::stop_token& stop) {
    ToolState hand;
    while (!stop.stop_requested()) {
      ++hand.sequence;
      hand.position = {0.11, 0.01, 0.0001 * static_cast<double>(hand.sequence % 100)};
      simulation.toolInput().back() = hand;
      simulation.toolInput().publish();
      const ContactModel& model = simulation.contactOutput().latest();
      EXPECT_TRUE(model.force.allFinite());
      if (model.active) models = model.sequence;
      std::this_thread::sleep_for(100us);
    }
  });
  EXPECT_TRUE(waitFor(simulation, [&](const SimSnapshot&) { return models > 20; }));
}

TEST(SimThread, TheDestructorJoinsInTheMidstOfWork)
{
  for (int i = 0; i < 5; ++i) {
    SimThread simulation(1000.0);
    // A fixed step of 1 us: hopelessly slow, in slow motion.
    simulation.load(chain(100), gravity(), {"verlet", 1e-3, 1e-6, 1});
    simulation.play();
    for (int k = 0; k < 100; ++k) simulation.moveGrab({0.1, 0.001 * k, 0.0});
    if (i == 0) continue; // as soon as it can
    ASSERT_TRUE(waitFor(simulation, [](const SimSnapshot& p) { return p.time > 0.0; }));
  }
}

// A net that is too large moves in slow motion and says so, and still obeys.
TEST(SimThread, AnOverloadedSimulationIsSlowButObeys)
{
  SimThread simulation(60.0);
  simulation.load(chain(400), gravity(), {"verlet", 1e-3, 1e-7, 1});
  simulation.play();
  EXPECT_TRUE(waitFor(simulation, [](const SimSnapshot& p) { return p.stability == Stability::Slow; }));
  EXPECT_LT(simulation.latest().realTimeFactor, 0.95);
  simulation.pause();
  EXPECT_TRUE(waitFor(simulation, [](const SimSnapshot& p) { return !p.playing; }));
}

// Whoever reads the last picture a second after its frame was due learns that none has come: the reader's time
// is invented, the picture is that of a real thread.
TEST(SimThread, APictureThatIsOldSaysSoWhenItIsRead)
{
  SimThread simulation(60.0);
  simulation.load(chain(6), gravity(), {});
  simulation.play();
  ASSERT_TRUE(waitFor(simulation, [](const SimSnapshot& p) { return p.playing && p.time > 0.0; }));
  SimSnapshot picture = simulation.latest();
  const double due = picture.clock.deadline();
  const double before = picture.realTimeFactor;
  readClock(picture, due + 0.1);
  EXPECT_EQ(picture.stability, Stability::Slow);
  EXPECT_NEAR(picture.lag, 0.1 - 1.0 / 60.0, 1e-9);
  EXPECT_NEAR(picture.frameTime, 0.1, 1e-9);
  const double after = picture.realTimeFactor;
  EXPECT_LT(after, before);
  readClock(picture, due + 1.0);
  EXPECT_NEAR(picture.lag, 1.0 - 1.0 / 60.0, 1e-9);
  EXPECT_LT(picture.realTimeFactor, 0.5 * after);

  simulation.pause();
  ASSERT_TRUE(waitFor(simulation, [](const SimSnapshot& p) { return !p.playing; }));
  picture = simulation.latest();
  const Stability stability = picture.stability;
  readClock(picture, due + 1000.0); // paused, for as long as it likes
  EXPECT_EQ(picture.stability, stability);
  EXPECT_EQ(picture.realTimeFactor, 0.0);
  EXPECT_EQ(picture.lag, 0.0);
  EXPECT_EQ(picture.frameTime, 0.0);
}

// What has stopped or is not there is not slow.
TEST(SimThread, TheClockChangesNoWorseWord)
{
  for (const Stability word : {Stability::Idle, Stability::Stopped}) {
    SimSnapshot picture;
    picture.playing = true;
    picture.clock = FrameClock(0.02);
    picture.stability = word;
    readClock(picture, 1000.0);
    EXPECT_EQ(picture.stability, word);
  }
}

} // namespace esm
