// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/selftest/bench.h"
#include "haptics/selftest/selftest.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace esm {

namespace {

constexpr Eigen::Index kMasses = 12;
constexpr double kStiffness = 300.0; ///< of the row of springs as a whole [N/m]
constexpr double kMass = 0.002;      ///< of each node [kg]
constexpr double kViscosity = 2.0;   ///< of each spring [N s/m]
constexpr double kStep = 0.0002;     ///< [s]: 5 kHz
constexpr double kPress = 0.015, kTremor = 0.0005, kTremorRate = 7.0; ///< [m], [m], [Hz]
constexpr double kBegin = 0.5;                                        ///< armed before, at rest [s]

/// A row of masses and springs from a wall to the tool, by implicit Euler; its end is where the tool is.
class TissueRow {
public:
  TissueRow()
  {
    const double k = kStiffness * static_cast<double>(kMasses + 1);
    Eigen::MatrixXd laplace = Eigen::MatrixXd::Zero(kMasses, kMasses);
    for (Eigen::Index i = 0; i < kMasses; ++i) {
      laplace(i, i) = 2.0;
      if (i > 0) laplace(i, i - 1) = laplace(i - 1, i) = -1.0;
    }
    m_stiffness = k * laplace;
    m_viscosity = kViscosity * laplace;
    m_k = k;
    m_inverse = (kMass * Eigen::MatrixXd::Identity(kMasses, kMasses) + kStep * m_viscosity +
                 kStep * kStep * m_stiffness)
                  .inverse();
  }
  void step(double tool, double toolVelocity)
  {
    Eigen::VectorXd load = -m_stiffness * (m_x + kStep * m_v) - m_viscosity * m_v;
    load[kMasses - 1] += m_k * tool + kViscosity * toolVelocity;
    m_v += m_inverse * (kStep * load);
    m_x += kStep * m_v;
    m_force = m_k * (m_x[kMasses - 1] - tool) + kViscosity * (m_v[kMasses - 1] - toolVelocity);
  }
  double force() const { return m_force; } ///< on the tool [N]

private:
  Eigen::MatrixXd m_stiffness, m_viscosity, m_inverse;
  Eigen::VectorXd m_x = Eigen::VectorXd::Zero(kMasses), m_v = Eigen::VectorXd::Zero(kMasses);
  double m_k = 0.0, m_force = 0.0;
};

double pressed(double t, double rate)
{
  const double s = std::max(t - kBegin, 0.0);
  constexpr double kTurn = 2.0 * std::numbers::pi;
  return -0.5 * kPress * (1.0 - std::cos(kTurn * rate * s)) -
         kTremor * std::sin(kTurn * kTremorRate * s) * std::min(1.0, 4.0 * s);
}

struct MultiRateError {
  double most = 0.0, rms = 0.0, jump = 0.0; ///< over the peak force [1], the same, [N per tick]
};

/// A tool at `rate` Hz with a tremor, the tissue in frames: each frame moves it with the newest hand and
/// sends force and condensed stiffness; against the same tissue at 5 kHz with the true hand.
MultiRateError multiRate(double rate, double frames)
{
  const auto hand = [rate](double t) { return Eigen::Vector3d(pressed(t, rate), 0.0, 0.0); };
  VirtualServo<LedDevice> servo(std::make_unique<LedDevice>(hand));
  servo.arm();
  servo.core().setForceLimit(20.0);
  TissueRow truth, simulated;
  MultiRateError error;
  double simulatedTime = 0.0, exact = 0.0, peak = 0.0, squares = 0.0, last = 0.0, lastTool = 0.0;
  int count = 0;
  for (double t = 0.0, frame = 0.0; t < kBegin + 3.0;) {
    servo.tick();
    t = servo.clock.now();
    for (; exact < t - 0.5 * kStep; exact += kStep) {
      const double next = pressed(exact + kStep, rate);
      truth.step(next, (next - pressed(exact, rate)) / kStep);
    }
    if (t >= frame) {
      frame += 1.0 / frames;
      const ToolState tool = servo.tool().latest();
      const double x = tool.position.x();
      const double steps = std::round((t - simulatedTime) / kStep);
      for (int i = 1; i <= static_cast<int>(steps); ++i) { // the hand went there at an even pace
        const double before = lastTool + (x - lastTool) * (i - 1) / steps;
        const double now = lastTool + (x - lastTool) * i / steps;
        simulated.step(now, (now - before) / kStep);
      }
      simulatedTime += steps * kStep;
      lastTool = x;
      ContactModel model;
      model.active = true;
      model.position.x() = x;
      model.force.x() = simulated.force();
      model.stiffness(0, 0) = kStiffness;
      servo.send(model);
    }
    const double felt = servo.device.force().x();
    if (t > kBegin) {
      peak = std::max(peak, std::abs(truth.force()));
      const double off = std::abs(felt - truth.force());
      error.most = std::max(error.most, off);
      squares += off * off;
      ++count;
      error.jump = std::max(error.jump, std::abs(felt - last));
    }
    last = felt;
  }
  error.most /= peak;
  error.rms = std::sqrt(squares / count) / peak;
  return error;
}

} // namespace

std::vector<SelftestRow> selftestTissue()
{
  struct Case {
    const char* what;
    double rate, frames, most, rms;
  };
  std::vector<SelftestRow> rows;
  double jump = 0.0;
  for (const Case& c :
       {Case{"1 Hz on 60 frames per second", 1.0, 60.0, 8.0, 2.0}, Case{"1 Hz on 125", 1.0, 125.0, 6.0, 1.2},
        Case{"2 Hz on 60", 2.0, 60.0, 13.0, 2.5}}) {
    const MultiRateError error = multiRate(c.rate, c.frames);
    rows.push_back({"A7", std::string("largest error of the force, pressing at ") + c.what,
                    100.0 * error.most, 0.0, c.most, "%"});
    rows.push_back({"A7", std::string("root mean square, ") + c.what, 100.0 * error.rms, 0.0, c.rms, "%"});
    if (c.rate == 1.0) jump = std::max(jump, error.jump);
  }
  rows.push_back({"A8", "largest change of the force in a tick, at 1 Hz", jump, 0.0, 0.15, "N"});
  return rows;
}

} // namespace esm
