// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/selftest/bench.h"
#include "haptics/selftest/selftest.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace esm {

namespace {

/// Some centimetres deep into the wall at x = 0, sliding along it, restless; from outside, where it is armed.
Eigen::Vector3d restlessHand(double t)
{
  const double share = std::clamp((t - 0.2) / 0.5, 0.0, 1.0);
  return {0.002 - share * 0.012 * (1.0 + std::sin(6.3 * t) + 0.5 * std::sin(17.0 * t + 1.0)),
          0.02 * std::sin(2.1 * t) + 0.004 * std::sin(31.0 * t), 0.015 * std::sin(3.3 * t + 2.0)};
}

/// A minute against 400 N/m, in models of 60 Hz that are made for where the hand was a frame ago.
/// @return the least that the hand had put in by any time [J].
double leastHandWork(double& largestForce)
{
  VirtualServo<SimulatedDevice> servo(std::make_unique<SimulatedDevice>(
    SimulatedDeviceSettings{}, std::make_unique<FormulaHand>(restlessHand)));
  servo.arm();
  double least = kInfinity;
  Eigen::Vector3d seen = servo.device.position();
  for (int tick = 0; tick < 60000; ++tick) {
    if (tick % 50 == 0 || tick % 50 == 17 || tick % 50 == 33) {
      ContactModel model = wallModel(400.0);
      model.position = seen;
      model.force.x() = -400.0 * seen.x();
      servo.send(model);
      seen = servo.device.position();
    }
    servo.tick();
    least = std::min(least, servo.device.handWork());
    largestForce = std::max(largestForce, servo.device.force().norm());
  }
  return least;
}

/// A simulation that drives the hand: 60 N s/m of negative damping. @return the time from 20 mJ in the hand,
/// beyond what the leak forgives, to no force for good [s]; infinite if there is no end.
double timeToTrip()
{
  auto hand = std::make_unique<FormulaHand>(
    [](double t) { return Eigen::Vector3d(0.002 * std::sin(12.0 * t), 0.0, 0.0); });
  VirtualServo<SimulatedDevice> servo(
    std::make_unique<SimulatedDevice>(SimulatedDeviceSettings{}, std::move(hand)));
  servo.arm();
  double given = 0.0, reached = kInfinity, lastForce = kInfinity;
  Eigen::Vector3d last = servo.device.position();
  for (int i = 0; i < 5000; ++i) {
    ContactModel push;
    push.active = true;
    push.force = 60.0 * servo.device.velocity();
    servo.send(push);
    const Eigen::Vector3d force = servo.device.force();
    servo.tick();
    given += force.dot(servo.device.position() - last) - 0.001 * EnergyGuard::kLeak;
    last = servo.device.position();
    if (given > EnergyGuard::kTrip) reached = std::min(reached, servo.clock.now());
    if (!servo.device.force().isZero(0.0)) lastForce = servo.clock.now();
  }
  if (servo.core().status().reason != ServoReason::EnergyTooHigh) return kInfinity;
  return std::max(0.0, lastForce - reached); // it may trip before the hand has got all of it
}

} // namespace

std::vector<SelftestRow> selftestEnergy()
{
  double force = 0.0;
  const double work = leastHandWork(force);
  std::vector<SelftestRow> rows;
  rows.push_back({"A6", "least that the hand has put in during a minute of pressing", 1000.0 * work, -1.0,
                  kInfinity, "mJ"});
  rows.push_back({"A6", "largest force meanwhile", force, 1.0, 5.0, "N"});
  rows.push_back({"A6", "from 20 mJ generated to no force", 1000.0 * timeToTrip(), 0.0, 100.0, "ms"});
  return rows;
}

} // namespace esm
