// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "servo_bench.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace esm {

namespace {

constexpr double kClamp = 5.0;       // [N]
constexpr double kLowLimit = 3.0;    // [N], the user's
constexpr double kSlewPerTick = 1.0; // [N]
constexpr double kRounding = 1e-12;  // of one sum of numbers near 5

/// Looks at every tick's force as it arrives at the device.
struct ForceWatch {
  void look(const Eigen::Vector3d& force)
  {
    ASSERT_TRUE(force.allFinite());
    largest = std::max(largest, force.norm());
    fastest = std::max(fastest, (force - last).norm());
    last = force;
  }
  void expectWithinLimits() const
  {
    EXPECT_LE(largest, kClamp + kRounding);
    EXPECT_LE(fastest, kSlewPerTick + kRounding);
  }
  Eigen::Vector3d last = Eigen::Vector3d::Zero();
  double largest = 0.0, fastest = 0.0;
};

/// Where a restless hand presses: some centimetres deep into a wall at x = 0, sliding along it.
Eigen::Vector3d restlessHand(double t)
{
  return {-0.012 * (1.0 + std::sin(6.3 * t) + 0.5 * std::sin(17.0 * t + 1.0)),
          0.02 * std::sin(2.1 * t) + 0.004 * std::sin(31.0 * t), 0.015 * std::sin(3.3 * t + 2.0)};
}

/// An elastic half-space below x = 0 as a simulation at 60 Hz sees it: made for where the hand was one frame
/// ago.
class SampledWall {
public:
  explicit SampledWall(double stiffness) : m_stiffness(stiffness) {}
  ContactModel next(const Eigen::Vector3d& hand)
  {
    ContactModel model;
    model.active = true;
    model.position = m_seen;
    if (m_seen.x() < 0.0) {
      model.force.x() = -m_stiffness * m_seen.x();
      model.stiffness(0, 0) = m_stiffness;
    }
    m_seen = hand;
    return model;
  }

private:
  double m_stiffness;
  Eigen::Vector3d m_seen = Eigen::Vector3d::Zero();
};

bool frameBegins(int tick)
{
  return tick % 50 == 0 || tick % 50 == 17 || tick % 50 == 33; // 60 Hz on a grid of 1 ms
}

void expectZeroAfterStop(ServoBench& bench, ForceWatch& watch)
{
  bench.order(ForceOrder::Stop);
  for (int i = 0; i < 100; ++i) {
    bench.send(constantForce({9.0, 9.0, 9.0}));
    bench.tick();
    watch.look(bench.force());
    if (i >= 4) {
      ASSERT_TRUE(bench.force().isZero(0.0)) << i + 1 << " ticks after the stop";
    }
  }
  watch.expectWithinLimits();
}

} // namespace

// 60 s of pressing into a wall of 400 N/m. The hand may only ever put energy in: what it gets back is less
// than it gave before, to 1 mJ.
TEST(Pressing, AMinuteIntoAWallStaysWithinTheLimitsAndGivesNoEnergy)
{
  ServoBench bench({}, handAlong(restlessHand));
  SampledWall wall(400.0);
  ForceWatch watch;
  bench.order(ForceOrder::Arm);
  double leastWork = 0.0;
  for (int tick = 0; tick < 60000; ++tick) {
    if (frameBegins(tick)) bench.send(wall.next(bench.device.position()));
    bench.tick();
    watch.look(bench.force());
    leastWork = std::min(leastWork, bench.device.handWork());
  }
  EXPECT_GT(watch.largest, 1.0); // it was pressed
  EXPECT_GE(leastWork, -1e-3);
  RecordProperty("hand_work_joule", std::to_string(bench.device.handWork()));
  RecordProperty("largest_force_newton", std::to_string(watch.largest));
  RecordProperty("fastest_change_newton_per_tick", std::to_string(watch.fastest));
  expectZeroAfterStop(bench, watch);
}

// A hand that leans on a wall a hundred times too stiff: the cap keeps it still, without any friction to
// help.
TEST(Pressing, AHandLeaningOnAWallThatIsTooStiffComesToRest)
{
  SimulatedDeviceSettings settings;
  settings.coulomb = 0.0;
  settings.quantum = 30e-6;
  ServoBench bench(settings,
                   handAlong([](double t) { return Eigen::Vector3d(t < 0.1 ? 0.0 : -0.008, 0.0, 0.0); }));
  bench.order(ForceOrder::Arm);
  double least = 1.0, most = -1.0;
  for (int tick = 0; tick < 6000; ++tick) {
    bench.send(springTo(Eigen::Vector3d::Zero(), 3e5));
    bench.tick();
    if (tick < 5000) continue;
    least = std::min(least, bench.device.position().x());
    most = std::max(most, bench.device.position().x());
  }
  EXPECT_LE(most - least, 4 * settings.quantum);
  EXPECT_GT(bench.force().x(), 1.0);
}

// A simulation gone mad: every tick another model, forces to 1e12 N, stiffness of any sign and size, now and
// then a NaN, contacts that end and come back, ticks that come late; the user arms again and again.
TEST(Pressing, RandomModelsNeverPassTheLimits)
{
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> unit(-1.0, 1.0), decade(-3.0, 5.0);
  const auto number = [&] { return unit(random) * std::pow(10.0, decade(random)); };
  SimulatedDeviceSettings settings;
  settings.quantum = 30e-6;
  settings.armTime = 0.001; // the madness trips the energy guard soon, and is to reach the limits before
  ServoBench bench(settings, handAlong(restlessHand));
  bench.loop.core().setForceLimit(kLowLimit);
  ForceWatch watch;
  for (int i = 0; i < 60000; ++i) {
    if (i % 500 == 0) {
      bench.armWithoutForce();
      watch.last = bench.force();
    }
    ContactModel model;
    model.active = random() % 64 != 0;
    for (int r = 0; r < 3; ++r) {
      model.force[r] = random() % 100 == 0 ? 1e12 * unit(random) : number();
      model.position[r] = 0.1 * unit(random);
      for (int c = 0; c < 3; ++c) {
        model.stiffness(r, c) = number();
        model.viscosity(r, c) = 0.001 * number();
      }
    }
    if (random() % 400 == 0) model.force[i % 3] = std::numeric_limits<double>::quiet_NaN();
    if (random() % 400 == 1) model.stiffness(i % 3, 0) = std::numeric_limits<double>::infinity();
    if (random() % 50 == 0) bench.clock.delayNextWake(0.004 * std::abs(unit(random)));
    bench.send(model);
    bench.tick();
    watch.look(bench.force());
  }
  watch.expectWithinLimits();
  EXPECT_LE(watch.largest, kLowLimit + kRounding);
  EXPECT_GT(watch.largest, 0.9 * kLowLimit); // the limit was reached, the slew rate too
  EXPECT_GT(watch.fastest, 0.9);
  expectZeroAfterStop(bench, watch);
}

} // namespace esm
