// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/selftest/bench.h"
#include "haptics/selftest/selftest.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace esm {

namespace {

constexpr int kUpdates = 1000000;
constexpr double kUserLimit = 3.0; ///< [N]
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// Any numbers of any size, now and then none.
class MadSimulation {
public:
  ContactModel next()
  {
    ContactModel model;
    model.active = m_random() % 64 != 0;
    const double reach = std::pow(10.0, 4.0 * m_unit(m_random) + 1.0);
    for (int r = 0; r < 3; ++r) {
      model.force[r] = reach * m_unit(m_random);
      model.position[r] = 0.1 * m_unit(m_random);
      for (int c = 0; c < 3; ++c) {
        model.stiffness(r, c) = 10.0 * reach * m_unit(m_random);
        model.viscosity(r, c) = 0.001 * reach * m_unit(m_random);
      }
    }
    if (m_random() % 4 == 0) model.normal = Eigen::Vector3d(m_unit(m_random), m_unit(m_random), 0.5);
    if (m_random() % 2000 == 0) model.force[0] = kNaN;
    if (m_random() % 2000 == 0) model.stiffness(1, 2) = kInfinity;
    return model;
  }
  double late() { return m_random() % 50 == 0 ? 0.004 * std::abs(m_unit(m_random)) : 0.0; }

private:
  std::mt19937_64 m_random{11};
  std::uniform_real_distribution<double> m_unit{-1.0, 1.0};
};

} // namespace

std::vector<SelftestRow> selftestLimits()
{
  const auto restless = [](double t) {
    return Eigen::Vector3d(0.01 * std::sin(6.3 * t), 0.02 * std::sin(2.1 * t), 0.01 * std::sin(17.0 * t));
  };
  VirtualServo<LedDevice> servo(std::make_unique<LedDevice>(restless));
  servo.core().setForceLimit(kUserLimit);
  MadSimulation simulation;
  double largest = 0.0, fastest = 0.0;
  Eigen::Vector3d last = Eigen::Vector3d::Zero();
  bool finite = true;
  for (int i = 0; i < kUpdates; ++i) {
    const int phase = i % 1000; // what trips or stops is armed again, as the user would, with nothing in hand
    if (phase == 0) servo.core().orders().give(ForceOrder::Stop);
    if (phase == 60) servo.core().orders().give(ForceOrder::Arm);
    if (const double late = simulation.late(); late > 0.0) servo.clock.delayNextWake(late);
    servo.send(phase < 120 ? ContactModel{} : simulation.next());
    servo.tick();
    const Eigen::Vector3d& force = servo.device.force();
    finite = finite && force.allFinite();
    largest = std::max(largest, force.norm());
    fastest = std::max(fastest, (force - last).norm());
    last = force;
  }
  constexpr double kRounding = 1e-12;
  std::vector<SelftestRow> rows;
  rows.push_back({"A9", "largest force under a million mad models, limit 3 N", finite ? largest : kNaN, 2.5,
                  kUserLimit + kRounding, "N"});
  rows.push_back({"A9", "largest change of it in a tick", fastest, 0.5, 1.0 + kRounding, "N"});
  return rows;
}

} // namespace esm
