// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// Two whole runs tell whether a tolerance is kept, and a finer one is taken where it is not.
#include "core/dynamics/tolerance_check.h"
#include "tests/support/nets.h"
#include "tests/support/physics.h"

namespace esm::test {
namespace {

constexpr double kFrames = 60.0; ///< per second
using Next = ToleranceCheck::Next;

struct Verified {
  ToleranceCheck check;
  std::vector<Eigen::Matrix3Xd> frames; ///< of the result
  int runs = 0;
};

Verified verify(const SpringNet& net, const Loads& loads, SolverSettings settings, double duration)
{
  settings.duration = duration;
  Verified verified{ToleranceCheck(settings), {}, 0};
  std::vector<Eigen::Matrix3Xd> former;
  Next next = Next::RunAgain;
  while (ToleranceCheck::isOpen(next)) {
    if (next == Next::RunAgain) former = std::move(verified.frames);
    verified.frames.clear();
    Simulation simulation = simulate(net, loads, verified.check.settings());
    StepReport report;
    verified.check.start(simulation.state());
    verified.frames.push_back(simulation.state().position);
    for (long frame = 1; frame <= std::lround(duration * kFrames); ++frame) {
      const StepReport step = simulation.advance(1.0 / kFrames);
      report.add(step);
      verified.check.add(simulation.state(), step);
      verified.frames.push_back(simulation.state().position);
    }
    next = verified.check.endRun(report);
    ++verified.runs;
  }
  if (next == Next::TakeFormer) verified.frames = former;
  return verified;
}

SolverSettings tolerance(double value)
{
  SolverSettings settings;
  settings.tolerance = value;
  return settings;
}

/// 1 kg on a spring of 100 N/m: 10 rad/s about x = 1 m.
constexpr double kOmega = 10.0, kSwing = 0.1;
SpringNet oscillator()
{
  SpringNet net = chain(2);
  net.fixed[0] = 1;
  net.mass.setOnes();
  net.stiffness.setConstant(100.0);
  net.viscosity.setZero();
  net.restPosition.col(1) = Eigen::Vector3d(1.0 + kSwing, 0, 0);
  net.restLength.setConstant(1.0);
  return net;
}

/// By the closed form, relative as docs/FILE_FORMAT.md has it.
double errorOfOscillator(const std::vector<Eigen::Matrix3Xd>& frames)
{
  double error = 0.0, displacement = 0.0;
  for (std::size_t frame = 0; frame < frames.size(); ++frame) {
    const double x = 1.0 + kSwing * std::cos(kOmega * static_cast<double>(frame) / kFrames);
    error += (frames[frame].col(1) - Eigen::Vector3d(x, 0, 0)).squaredNorm();
    displacement += std::pow(x - 1.0 - kSwing, 2);
  }
  return std::sqrt(error / displacement);
}

/// A node at (0, 0.5, 0) between two supports 1 m to the left and right of the origin. Thrown down, it has to
/// get over the barrier at the origin, where both springs are shortest: k (L - 1)^2 for both together.
/// @param more  energy that it is thrown with, over the barrier's
SpringNet snappingNode(double more)
{
  SpringNet net = chain(3);
  net.fixed[0] = net.fixed[2] = 1;
  net.mass.setOnes();
  net.stiffness.setConstant(100.0);
  net.viscosity.setZero();
  net.restPosition << -1, 0, 1, 0, 0.5, 0, 0, 0, 0;
  const double length = std::hypot(1.0, 0.5);
  net.restLength.setConstant(length);
  const double barrier = 100.0 * (length - 1.0) * (length - 1.0);
  net.initialVelocity.setZero(3, 3);
  net.initialVelocity(1, 1) = -std::sqrt(2.0 * barrier * more);
  return net;
}

} // namespace

TEST(ToleranceCheck, TakesARunThatKeepsItsTolerance)
{
  const Verified verified = verify(oscillator(), {}, tolerance(1e-3), 2.0);
  EXPECT_TRUE(verified.check.kept());
  EXPECT_EQ(verified.runs, 2);
  EXPECT_EQ(verified.check.resultTolerance(), 1e-3);
  EXPECT_LE(errorOfOscillator(verified.frames), 1e-3);
}

// What it measures is the error, to what the finer run errs: a tenth of the tolerance.
TEST(ToleranceCheck, MeasuresWhatFixedStepsErr)
{
  for (const double step : {1.0 / 240.0, 1.0 / 120.0}) {
    SolverSettings settings = fixedSteps("verlet", step);
    settings.tolerance = 1e-4;
    const Verified verified = verify(oscillator(), {}, settings, 2.0);
    const double error = errorOfOscillator(verified.frames);
    ASSERT_TRUE(verified.check.measuredError());
    EXPECT_NEAR(*verified.check.measuredError(), error, 1e-5) << step;
    // Verlet's phase runs ahead by (w h)^2 / 24; over 20 rad that is a third of 20 times as much in the mean.
    EXPECT_NEAR(error, std::pow(kOmega * step, 2) / 24.0 * 20.0 / 3.0, 0.1 * error);
    EXPECT_FALSE(verified.check.kept());
    EXPECT_EQ(verified.runs, 2); // it is what was asked for
    EXPECT_NE(verified.check.why().find("away from"), std::string::npos);
  }
}

// A second, light oscillator at rest holds the steps at its limit of stability, 1/500 s: a run with a tenth
// of the tolerance would take the same and agree, whatever they err.
TEST(ToleranceCheck, IsNotDeceivedByStepsAtTheirLimit)
{
  SpringNet net = oscillator();
  addNode(net, {0, 1, 0});
  net.mass[2] = 1e-4;
  addSpring(net, 0, 2, 100.0);
  const Verified verified = verify(net, {}, tolerance(1e-1), 2.0);
  const double error = errorOfOscillator(verified.frames);
  ASSERT_TRUE(verified.check.measuredError());
  EXPECT_GT(error, 1e-5);
  EXPECT_NEAR(*verified.check.measuredError(), error, 0.3 * error);
  EXPECT_TRUE(verified.check.kept());
  EXPECT_EQ(verified.check.resultTolerance(), 1e-1);
}

// Whether it gets over the barrier energy says, and a hundred-thousandth of it decides.
TEST(ToleranceCheck, TakesFinerStepsWhereAMotionMultipliesErrors)
{
  for (const double more : {1e-5, -1e-5}) {
    const Verified verified = verify(snappingNode(1.0 + more), {}, tolerance(1e-2), 4.0);
    EXPECT_TRUE(verified.check.kept()) << verified.check.why();
    EXPECT_LT(verified.check.resultTolerance(), 1e-2);
    double lowest = 1.0;
    for (const Eigen::Matrix3Xd& frame : verified.frames) lowest = std::min(lowest, frame(1, 1));
    const bool isOver = lowest < -0.1;
    EXPECT_EQ(isOver, more > 0.0) << lowest;
  }
}

// With just the energy of the barrier it would stay up there for ever: rounding decides.
TEST(ToleranceCheck, SaysWhatNoStepsCanDo)
{
  const Verified verified = verify(snappingNode(1.0), {}, tolerance(1e-6), 8.0);
  EXPECT_FALSE(verified.check.kept());
  EXPECT_NE(verified.check.why().find("smallest errors"), std::string::npos) << verified.check.why();
}

TEST(ToleranceCheck, ANetAtRestIsExact)
{
  SpringNet net = chain(5);
  const Verified verified = verify(net, {}, tolerance(1e-6), 0.5);
  EXPECT_TRUE(verified.check.kept());
  EXPECT_EQ(verified.check.measuredError(), 0.0);
}

TEST(ToleranceCheck, ARunThatFailsProvesNothing)
{
  StepReport good, failed, rough;
  failed.notConverged = true;
  rough.rough = true;
  const NetState state{Eigen::Matrix3Xd::Zero(3, 2), Eigen::Matrix3Xd::Zero(3, 2), 0.0};
  for (const StepReport& finer : {failed, rough}) {
    ToleranceCheck check(tolerance(1e-3));
    check.start(state);
    check.add(state, good);
    ASSERT_EQ(check.endRun(good), Next::RunAgain);
    check.start(state);
    check.add(state, good);
    EXPECT_EQ(check.endRun(finer), Next::TakeFormer);
    EXPECT_FALSE(check.kept());
    EXPECT_FALSE(check.measuredError());
  }
  ToleranceCheck check(tolerance(1e-3));
  check.start(state);
  check.add(state, good);
  EXPECT_EQ(check.endRun(failed), Next::TakeThis);
  EXPECT_FALSE(check.kept());
}

} // namespace esm::test
