// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// What a hand feels of a simulation that answers too late, irregularly or not at all.
#include "servo_bench.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

namespace esm {

namespace {

constexpr double kBand = 0.1; ///< of the steady force

/// Tissue below z = 0 that stiffens with depth, touched from above or held by the tool.
ContactModel tissueAt(const Eigen::Vector3d& hand, bool held, double stiffness)
{
  constexpr double kStiffens = 0.02; // [m] in which its stiffness doubles twice
  const double depth = held ? -hand.z() : std::max(0.0, -hand.z());
  ContactModel model;
  model.active = true;
  model.position = hand;
  model.force.z() = stiffness * depth * (1.0 + std::abs(depth) / kStiffens);
  model.stiffness = 0.3 * stiffness * Eigen::Matrix3d::Identity();
  model.stiffness(2, 2) = stiffness * (1.0 + 2.0 * std::abs(depth) / kStiffens);
  if (!held) {
    model.normal = Eigen::Vector3d::UnitZ();
    if (depth == 0.0) model.position.z() = 0.0; // where it will be met
  } else {
    model.force.head<2>() = -0.3 * stiffness * hand.head<2>();
  }
  return model;
}

SimulatedDeviceSettings quietHand()
{
  SimulatedDeviceSettings settings = firmlyHeld();
  settings.coulomb = 0.0; // or the device would rest anywhere within its friction
  return settings;
}

/// A hand on tissue whose simulation answers when it is told to, each time for where the hand was when it
/// began, at the answer before.
class LateBench {
public:
  explicit LateBench(std::function<Eigen::Vector3d(double)> path, bool held = false, double stiffness = 60.0)
    : servo(quietHand(), handAlong(std::move(path))), m_held(held), m_stiffness(stiffness)
  {
    servo.order(ForceOrder::Arm);
  }
  void answer()
  {
    ContactModel model = tissueAt(m_seen, m_held, m_stiffness);
    if (!m_held) model.friction = friction;
    servo.send(model);
    m_seen = servo.tool.latest().position;
  }
  /// @param now  whether the first answer comes at once.
  void runAt(
    double rate, double seconds, const std::function<void()>& look = [] {}, bool now = false)
  {
    if (now) m_next = m_time;
    const int ticks = static_cast<int>(std::lround(seconds / kTick));
    for (int i = 0; i < ticks; ++i) {
      if (m_time >= m_next) {
        answer();
        m_next += 1.0 / rate;
      }
      m_time += kTick;
      servo.tick();
      look();
    }
  }
  double push() const { return servo.force().z(); }

  ServoBench servo;
  double friction = 0.2;

private:
  bool m_held;
  double m_stiffness;
  double m_time = 0.0, m_next = 0.0;
  Eigen::Vector3d m_seen = Eigen::Vector3d::Zero();
};

/// Laid on from 2 mm above and kept still from 2 s on.
Eigen::Vector3d laidOn(double t, double depth)
{
  return {0.0, 0.0, 0.002 - (0.002 + depth) * std::clamp(t - 1.0, 0.0, 1.0)};
}

/// Counts how often a force leaves its band.
struct BandWatch {
  explicit BandWatch(double force) : steady(force) {}
  void look(double force)
  {
    const bool is = std::abs(force - steady) > kBand * steady;
    departures += is && !isOut ? 1 : 0;
    isOut = is;
  }
  double steady;
  bool isOut = false;
  int departures = 0;
};

} // namespace

// Throttled to 3, 5, 8 and 15 answers per second after a quick start, the hand and the contact still: the
// force stays within 10 % of what it was, all the time.
TEST(LateAnswers, AStillHandFeelsASteadyForce)
{
  for (const double rate : {3.0, 5.0, 8.0, 15.0})
    for (const double depth : {0.0025, 0.01})
      for (const bool held : {false, true}) {
        LateBench bench([=](double t) { return laidOn(t, depth); }, held);
        bench.runAt(60.0, 4.0);
        BandWatch watch(bench.push());
        ASSERT_GT(watch.steady, 0.1);
        bench.runAt(rate, 10.0, [&] { watch.look(bench.push()); });
        EXPECT_EQ(watch.departures, 0) << rate << " Hz, " << depth << " m, " << held;
        EXPECT_EQ(bench.servo.status().state, DeviceState::Active);
        EXPECT_EQ(bench.servo.status().reason, rate > 10.0 ? ServoReason::Plain : ServoReason::LateModel);
      }
}

// The same where the simulation was late from the start: the contact begins softly, within the device's 0.3 s
// and some answers, and stays.
TEST(LateAnswers, AContactUnderALateSimulationBeginsAndStays)
{
  for (const double rate : {3.0, 5.0, 8.0, 15.0})
    for (const bool held : {false, true}) {
      const auto path = [](double t) {
        return laidOn(std::min(2.0, 1.0 + 0.25 * std::max(0.0, t - 1.0)), 0.01);
      };
      LateBench quick(path, held);
      quick.runAt(60.0, 10.0);
      LateBench bench(path, held);
      bench.runAt(rate, 7.0);
      BandWatch watch(quick.push());
      bench.runAt(rate, 10.0, [&] { watch.look(bench.push()); });
      EXPECT_EQ(watch.departures, 0) << rate << " Hz, " << held;
    }
}

// Between 2 and 20 answers per second, at random: none is later than what a plane is held for.
TEST(LateAnswers, IrregularAnswersDoNotMakeAStillForcePulse)
{
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> rate(2.0, 20.0);
    LateBench bench([](double t) { return laidOn(t, 0.01); }, seed % 2 == 0);
    bench.runAt(60.0, 4.0);
    BandWatch watch(bench.push());
    for (int i = 0; i < 80; ++i)
      bench.runAt(
        0.001, 1.0 / rate(random), [&] { watch.look(bench.push()); }, true);
    EXPECT_EQ(watch.departures, 0) << "seed " << seed;
  }
}

// From half an answer to twenty per second, at random: some take longer than a plane is held. Each departure
// is one fade, down to nothing without a rise, and what comes back has seen five answers in a row, each
// within 100 ms of the one before.
TEST(LateAnswers, BetweenTwoFadesThereAreFiveAnswersInTime)
{
  int fadesOfAll = 0, returnsOfAll = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> octave(-1.0, 4.3);
    LateBench bench([](double t) { return laidOn(t, 0.0025); },
                    seed % 2 == 0); // below 0.2 N: comes by itself
    bench.runAt(60.0, 4.0);
    BandWatch watch(bench.push());
    int inTime = 0, longest = 0, fades = 0, returns = 0;
    double last = bench.push();
    for (int burst = 0; burst < 40; ++burst) {
      const double interval = std::exp2(-octave(random));
      for (int i = 0; i < 8; ++i) {
        bench.runAt(
          0.001, interval,
          [&] {
            const double push = bench.push();
            watch.look(push);
            if (last > 0.0 && push == 0.0) {
              ++fades;
              longest = 0;
            }
            if (last == 0.0 && push > 0.0) {
              ++returns;
              ASSERT_GE(longest, ContactLaw::kTimelyAnswers) << "seed " << seed;
            }
            if (watch.isOut && bench.servo.status().reason == ServoReason::StaleModel) {
              ASSERT_LE(push, last) << "seed " << seed;
            }
            last = push;
          },
          true);
        inTime = interval <= ContactLaw::kLateAfter ? inTime + 1 : 0; // that answer comes with the next tick
        longest = std::max(longest, inTime);
      }
    }
    EXPECT_EQ(watch.departures, fades) << "seed " << seed;
    EXPECT_LE(fades, returns + 1) << "seed " << seed;
    fadesOfAll += fades;
    returnsOfAll += returns;
  }
  EXPECT_GT(fadesOfAll, 20);
  EXPECT_GT(returnsOfAll, 10);
}

// After a silence nothing but five answers in a row in time brings the force back, however many others come.
TEST(LateAnswers, FourInARowAreNotEnough)
{
  LateBench bench([](double t) { return laidOn(t, 0.0025); });
  bench.runAt(60.0, 4.0);
  const double before = bench.push();
  bench.servo.tick(1200);
  ASSERT_EQ(bench.push(), 0.0);
  for (int round = 0; round < 20; ++round) {
    bench.runAt(
      0.001, 0.3, [&] { ASSERT_EQ(bench.push(), 0.0); }, true); // late
    for (int i = 0; i < 4; ++i)
      bench.runAt(
        0.001, 0.09, [&] { ASSERT_EQ(bench.push(), 0.0); }, true);
  }
  EXPECT_EQ(bench.servo.status().reason, ServoReason::StaleModel);
  bench.runAt(
    15.0, 1.0, [] {}, true);
  EXPECT_NEAR(bench.push(), before, 0.01 * before);
  EXPECT_EQ(bench.servo.status().reason, ServoReason::Plain);
}

// No answer any more: the plane holds for a second, fades within 50 ms and stays away.
TEST(LateAnswers, AHungSimulationIsNoWallAfterASecond)
{
  for (const double depth : {0.01, 0.025}) { // 0.9 N and what the limit of 5 N leaves
    LateBench bench([=](double t) { return laidOn(t, depth); }, false, 90.0);
    bench.runAt(60.0, 4.0);
    const double before = bench.push();
    bench.servo.tick(980); // the last answer is up to a frame old
    EXPECT_NEAR(bench.push(), before, 0.001 * before);
    EXPECT_EQ(bench.servo.status().reason, ServoReason::LateModel);
    bench.servo.tick(25);
    EXPECT_EQ(bench.servo.status().state, DeviceState::Fading);
    EXPECT_EQ(bench.servo.status().reason, ServoReason::StaleModel);
    bench.servo.tick(48); // 1.053 s
    for (int i = 0; i < 5000; ++i) {
      ASSERT_EQ(bench.push(), 0.0);
      bench.servo.tick();
    }
  }
}

/// Sinks into tissue that has not answered since 3.5 s.
class SinkingHand {
public:
  explicit SinkingHand(bool held, double way)
    : bench(
        [=](double t) -> Eigen::Vector3d {
          return laidOn(t, 0.01) - Eigen::Vector3d(0.0, 0.0, way * std::clamp((t - 4.0) / 0.4, 0.0, 1.0));
        },
        held)
  {
    bench.runAt(60.0, 4.0);
    model = tissueAt(bench.servo.device.position(), held, 60.0);
  }
  double pushOfPlane() const
  {
    return model.force.z() - model.stiffness(2, 2) * (bench.servo.device.position().z() - model.position.z());
  }
  LateBench bench;
  ContactModel model;
};

// A hand that moves on under a plane that is late feels the plane: F = F0 - K (x - x0), deeper and less deep.
TEST(LateAnswers, AHandThatMovesOnFollowsThePlane)
{
  for (const double way : {0.008, -0.006})
    for (const bool held : {false, true}) {
      SinkingHand hand(held, way);
      for (int i = 0; i < 600; ++i) {
        hand.bench.servo.tick();
        ASSERT_NEAR(hand.bench.push(), hand.pushOfPlane(), 0.01) << held; // where it is a tick later
      }
      EXPECT_GT(std::abs(hand.bench.push() - hand.model.force.z()), 0.2);
    }
}

// Ten millimetres from where it was made for the plane is trusted no longer, whatever it says there.
TEST(LateAnswers, ThePlaneIsTrustedForTenMillimetres)
{
  for (const double way : {0.03, -0.03}) {
    SinkingHand hand(true, way);
    double farthest = 0.0;
    for (int i = 0; i < 500; ++i) {
      hand.bench.servo.tick();
      if (hand.bench.servo.status().reason == ServoReason::StaleModel) break;
      farthest = std::max(farthest, (hand.bench.servo.device.position() - hand.model.position).norm());
    }
    EXPECT_NEAR(farthest, 0.01, 0.0002);
    hand.bench.servo.tick(52);
    EXPECT_EQ(hand.bench.push(), 0.0);
  }
}

// A hand that leaves the surface is free at once, and meets it again where it was.
TEST(LateAnswers, AHandMayLeaveTissueThatIsLate)
{
  LateBench bench([](double t) -> Eigen::Vector3d {
    return laidOn(t, 0.004) +
           Eigen::Vector3d(0.0, 0.0, t < 4.0 ? 0.0 : 0.003 - 0.003 * std::cos(20.0 * (t - 4.0)));
  });
  bench.runAt(60.0, 4.0);
  int free = 0;
  for (int i = 0; i < 900; ++i) {
    bench.servo.tick();
    if (bench.servo.device.position().z() < 0.0005) continue;
    ++free;
    ASSERT_EQ(bench.push(), 0.0);
  }
  EXPECT_GT(free, 100);
  EXPECT_LE(bench.servo.status().generated, EnergyGuard::kFree);
}

// Beyond the trusted way a plane that was not felt yet does not begin.
TEST(LateAnswers, ASurfaceFarFromItsPlaneIsNotBelieved)
{
  LateBench bench(
    [](double t) { return Eigen::Vector3d(0.05 * std::max(0.0, t - 4.0), 0.0, t < 4.4 ? 0.002 : -0.004); });
  bench.runAt(60.0, 4.0);
  for (int i = 0; i < 900; ++i) {
    bench.servo.tick();
    ASSERT_EQ(bench.push(), 0.0);
  }
}

// A drag that grows with the push is no spring: stirred with a hand that presses on the way back only, it
// pumps. What a late plane may give so is a quarter of what trips the guard; without friction it holds on.
TEST(LateAnswers, APlaneThatGivesEnergyIsNotHeld)
{
  for (const double friction : {0.0, 1.0}) {
    LateBench bench(
      [](double t) -> Eigen::Vector3d {
        const double phase = t < 4.0 ? 0.0 : 8.0 * (t - 4.0);
        return laidOn(t, 0.002) +
               Eigen::Vector3d(0.004 * (1.0 - std::cos(phase)), 0.0, 0.0018 * std::sin(phase));
      },
      false, 1400.0);
    bench.friction = friction;
    bench.runAt(60.0, 4.0);
    int held = 0;
    double most = 0.0;
    for (int i = 0; i < 900; ++i) {
      bench.servo.tick();
      held += bench.servo.status().reason == ServoReason::LateModel ? 1 : 0;
      most = std::max(most, bench.servo.status().generated);
    }
    EXPECT_NE(bench.servo.status().state, DeviceState::Fault);
    if (friction == 0.0) {
      EXPECT_GT(held, 790);
    } else {
      EXPECT_LT(held, 685); // a stir takes 785 ms, of which 100 are not late yet
      EXPECT_LT(most, 0.5 * EnergyGuard::kTrip);
    }
  }
}

// A restless hand on tissue that answers when it likes: limit, slew rate and the guard's account hold as ever.
TEST(LateAnswers, WhateverIsLateTheLimitsHold)
{
  int felt = 0, stale = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> octave(-1.0, 6.0), unit(0.0, 1.0);
    const double a = unit(random), b = 3.0 + 9.0 * unit(random), c = unit(random);
    LateBench bench(
      [=](double t) -> Eigen::Vector3d {
        return {0.01 * std::sin(2.1 * t), 0.008 * std::sin(b * c * t),
                -0.008 * a * (1.0 + std::sin(b * t)) + 0.003 * std::cos(1.3 * t) + 0.004};
      },
      seed % 3 == 0, 100.0 + 500.0 * c);
    Eigen::Vector3d last = Eigen::Vector3d::Zero();
    for (int burst = 0; burst < 100; ++burst) {
      const double interval = std::exp2(-octave(random));
      if (burst % 10 == 0) bench.servo.order(ForceOrder::Arm);
      for (double rest = 0.3; rest > 0.0; rest -= interval)
        bench.runAt(
          0.001, interval,
          [&] {
            const Eigen::Vector3d force = bench.servo.force();
            const ServoStatus& status = bench.servo.status();
            ASSERT_TRUE(force.allFinite());
            ASSERT_LE(force.norm(), 5.0 + 1e-12);
            ASSERT_LE((force - last).norm(), 1.0 + 1e-12);
            ASSERT_TRUE(status.generated <= EnergyGuard::kTrip || status.state == DeviceState::Fault);
            last = force;
            felt += force.norm() > 0.1 ? 1 : 0;
            stale += status.reason == ServoReason::StaleModel ? 1 : 0;
          },
          true);
    }
  }
  EXPECT_GT(felt, 20000);
  EXPECT_GT(stale, 20000);
}

} // namespace esm
