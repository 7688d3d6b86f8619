// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/selftest/bench.h"
#include "haptics/selftest/selftest.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <random>

namespace esm {

namespace {

constexpr double kQuantum = 30e-6;    ///< [m], a third to two thirds of what a Falcon resolves
constexpr double kFineQuantum = 2e-6; ///< [m]; coarser steps swing by themselves on stiff walls
constexpr double kNothing = 40e-6;    ///< [m]
constexpr int kSeconds = 10;          ///< weak damping takes its time
constexpr double kPush = 1.0;         ///< [N] by which the device is pressed to the wall
constexpr double kImpact = 0.1;       ///< [m/s]

struct Wall {
  double ownDamping, addedDamping, tick;
  int delayTicks;
  double delay() const { return tick * delayTicks; }
  double theory() const { return 2.0 * (ownDamping + addedDamping) / (tick + 2.0 * delay()); }
};

/// Without the servo's caps: the physics that they rest on. Whether the swing after the impact dies down:
/// in the last second it stays on the wall and is smaller than in the fifth, or it is nearly nothing.
bool calmsDown(const Wall& wall, double stiffness)
{
  SimulatedDeviceSettings settings;
  settings.damping = wall.ownDamping;
  settings.coulomb = 0.0;
  settings.quantum = kFineQuantum;
  settings.period = wall.tick;
  settings.delayTicks = wall.delayTicks;
  SimulatedDevice device(settings);
  device.setMotion({0.001, 0.0, 0.0}, {-kImpact, 0.0, 0.0});
  DeviceSample sample;
  double velocity = 0.0, last = 0.001;
  double least[kSeconds], most[kSeconds];
  std::fill(std::begin(least), std::end(least), kInfinity);
  std::fill(std::begin(most), std::end(most), -kInfinity);
  const double lag = 1.0 / (2.0 * std::numbers::pi * 200.0);
  for (double t = 0.0; t < kSeconds - 0.001; t += wall.tick) {
    device.read(t, sample);
    const double x = sample.position.x();
    velocity += (x - last - wall.tick * velocity) / (wall.tick + lag);
    last = x;
    const double force = x < 0.0 ? std::max(0.0, -stiffness * x - wall.addedDamping * velocity) : 0.0;
    device.write({force - kPush, 0.0, 0.0});
    const auto second = static_cast<std::size_t>(t);
    least[second] = std::min(least[second], device.position().x());
    most[second] = std::max(most[second], device.position().x());
  }
  const double end = most[kSeconds - 1] - least[kSeconds - 1], before = most[4] - least[4];
  const bool bounces = most[kSeconds - 1] > 0.0; // what swings too far leaves the wall, and swings no further
  return end < kNothing || (!bounces && end < before);
}

/// Stiffness over theory where walls begin to swing for ever, to 2 % by halving.
double measuredLimit(const Wall& wall)
{
  double stable = 0.5, unstable = 1.5;
  while (unstable - stable > 0.02) {
    const double middle = 0.5 * (stable + unstable);
    (calmsDown(wall, middle * wall.theory()) ? stable : unstable) = middle;
  }
  return 0.5 * (stable + unstable);
}

/// A hand leans on a wall a hundred times too stiff, for a minute, while ticks come up to 3 ms late and one
/// in a hundred is missed. @return swing in the last second, in quanta.
double swingUnderJitter(double& largestShare)
{
  SimulatedDeviceSettings settings;
  settings.quantum = kQuantum;
  settings.coulomb = 0.0;
  auto hand = std::make_unique<FormulaHand>(
    [](double t) { return Eigen::Vector3d(t < 0.2 ? 0.001 : -0.008, 0.0, 0.0); });
  VirtualServo<SimulatedDevice> servo(std::make_unique<SimulatedDevice>(settings, std::move(hand)));
  servo.arm();
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  double least = kInfinity, most = -kInfinity;
  largestShare = 0.0;
  while (servo.clock.now() < 60.0) {
    servo.clock.delayNextWake(random() % 100 == 0 ? 0.001 + 0.003 * unit(random) : 0.003 * unit(random));
    servo.send(wallModel(3e5));
    servo.tick();
    if (servo.clock.now() < 59.0) continue;
    least = std::min(least, servo.device.position().x());
    most = std::max(most, servo.device.position().x());
    largestShare = std::max(largestShare, servo.device.force().norm());
  }
  return (most - least) / kQuantum;
}

} // namespace

std::vector<SelftestRow> selftestWalls()
{
  double lowest = kInfinity, highest = 0.0;
  for (const double damping : {1.0, 3.0, 6.0})
    for (const double added : {0.0, 1.0})
      for (const double tick : {0.0005, 0.001, 0.004})
        for (const int delay : {0, 1, 2}) {
          const Wall wall{damping, added, tick, delay};
          if (wall.delay() > 0.0021) continue;
          const double limit = measuredLimit(wall);
          lowest = std::min(lowest, limit);
          highest = std::max(highest, limit);
        }
  const ContactLaw law{DeviceProfile{}};
  double pressed = 0.0;
  const double swing = swingUnderJitter(pressed);
  std::vector<SelftestRow> rows;
  rows.push_back(
    {"A4", "lowest stiffness at which walls swing, over 2 (b + B) / (T + 2 tau)", lowest, 0.85, 1.05, "1"});
  rows.push_back({"A4", "highest", highest, 0.85, 1.05, "1"});
  rows.push_back(
    {"A5", "stiffness cap over that limit", law.stiffnessCap(0.0) / (2.0 * 3.0 / 0.001), 0.0, 0.5, "1"});
  rows.push_back(
    {"A5", "swing after a minute of late ticks on a wall that is too stiff", swing, 0.0, 4.0, "quanta"});
  rows.push_back({"A5", "while the wall pushes back with", pressed, 1.0, 5.0, "N"});
  return rows;
}

} // namespace esm
