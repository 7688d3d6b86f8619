// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// Stoermer's multistep method: how far it is stable, and what it keeps from one run to the next.
#include "core/dynamics/bounds/stoermer_limits.h"
#include "tests/support/nets.h"
#include "tests/support/one_mass.h"
#include "tests/support/physics.h"

#include <Eigen/Eigenvalues>

#include <cmath>

namespace esm::test {
namespace {

using Eigen::MatrixXd;

/// The spectral radius of a step, by its recurrence over (x, u, p, a_{n-1}, a_{n-2}, a_{n-3}); all lengths in
/// h.
/// @param k,d  h^2 M^-1 K and h M^-1 D in coordinates scaled by the masses' roots
double growthPerStep(const MatrixXd& k, const MatrixXd& d, bool corrected)
{
  const Eigen::Index n = k.rows();
  const MatrixXd all = MatrixXd::Identity(6 * n, 6 * n);
  const auto part = [&](Eigen::Index i) { return MatrixXd(all.middleRows(i * n, n)); };
  const MatrixXd x = part(0), u = part(1), p = part(2), a1 = part(3), a2 = part(4), a3 = part(5);
  MatrixXd a = -k * x - d * p, foretold;
  const MatrixXd v = u + (7.0 * a + 6.0 * a1 - a2) / 24.0;
  if (corrected) a = -k * x - d * v;
  const MatrixXd next = u + (14.0 * a - 5.0 * a1 + 4.0 * a2 - a3) / 12.0;
  if (corrected)
    foretold = next + (20.0 * a - 8.0 * a1) / 24.0;
  else
    foretold = next + (27.0 * a - 22.0 * a1 + 7.0 * a2) / 24.0 + (p - v) * (2.0 / 3.0);
  MatrixXd step(6 * n, 6 * n);
  step << x + next, next, foretold, a, a1, a2;
  return step.eigenvalues().cwiseAbs().maxCoeff();
}

double growthOfMode(double w, double g, double h, bool corrected)
{
  const MatrixXd one = MatrixXd::Identity(1, 1);
  return growthPerStep(h * h * w * w * one, h * g * one, corrected);
}

} // namespace

// The limits bound every mode that keeps to the bounds: undamped, damped as little as the bounds say and as
// much, by the roots of the recurrence. (A mode at rest has a double root 1, of which rounding makes 1 +
// 1e-8.)
TEST(Stoermer, LimitsHoldForEachModeWithinTheBounds)
{
  constexpr double kFastest = 1000.0;
  for (const double damping : {0.0, 30.0, 100.0, 350.0, 700.0, 1500.0, 3000.0, 10000.0})
    for (const double owed : {0.0, 0.5, 1.0}) {
      FastestMode mode;
      mode.stiffness = kFastest * kFastest;
      mode.damping = damping;
      mode.undamped = 0.1 * mode.stiffness;
      mode.leastDamping = owed * damping / mode.stiffness;
      const StoermerLimits limits(mode);
      for (const double part : {0.3, 0.7, 0.9, 1.0})
        for (int i = 0; i <= 40; ++i) {
          const double w = kFastest * i / 40;
          const double least = mode.leastDamping * std::max(w * w - mode.undamped, 0.0);
          for (int j = 0; j <= 8; ++j) {
            const double g = least + (damping - least) * j / 8;
            EXPECT_LT(growthOfMode(w, g, part * limits.alone, false), 1.0 + 1e-7) << w << ' ' << g;
            EXPECT_LT(growthOfMode(w, g, part * limits.corrected, true), 1.0 + 1e-7) << w << ' ' << g;
          }
        }
    }
}

// Nor are they far below what is possible: a fifth longer steps grow where one mode is all there is.
TEST(Stoermer, LimitsAreNotFarBelowWhatOneModeBears)
{
  for (const double damping : {0.0, 100.0, 1500.0, 10000.0}) {
    FastestMode mode;
    mode.stiffness = 1e6;
    mode.damping = damping;
    mode.leastDamping = damping / mode.stiffness;
    const StoermerLimits limits(mode);
    EXPECT_GT(growthOfMode(1000.0, damping, 1.2 * limits.alone, false), 1.0 + 1e-4) << damping;
    EXPECT_GT(growthOfMode(1000.0, damping, 1.25 * limits.corrected, true), 1.0 + 1e-4) << damping;
  }
}

// In nets whose dampers have other directions than what is stiff there are no single modes: the matrices do
// not commute. By the eigenvalues of the dense step, with the 5 % that the driver leaves.
TEST(Stoermer, NoStepUpToTheLimitLetsANetGrow)
{
  for (std::uint32_t seed = 1; seed <= 5; ++seed)
    for (const double damped : {0.05, 0.2, 0.5, 1.0, 3.0}) {
      SpringNet net = relaxed(seed, 8);
      const MatrixXd k = scaledMatrix(net, net.stiffness);
      const double fastest = std::sqrt(Eigen::SelfAdjointEigenSolver<MatrixXd>(k).eigenvalues().maxCoeff());
      net.viscosity = net.stiffness * (2.0 * damped / fastest);
      for (Index s = 0; s < net.springCount(); ++s)
        net.viscosity[s] *= 0.4 + 0.2 * static_cast<double>(s % 4);
      const MatrixXd d = scaledMatrix(net, net.viscosity);
      FastestMode mode;
      mode.stiffness = fastest * fastest;
      mode.damping = Eigen::SelfAdjointEigenSolver<MatrixXd>(d).eigenvalues().maxCoeff();
      mode.leastDamping = 0.4 * 2.0 * damped / fastest;
      const StoermerLimits limits(mode);
      for (const double part : {0.4, 0.7, 0.95})
        for (const bool corrected : {false, true}) {
          const double h = part * (corrected ? limits.corrected : limits.alone);
          EXPECT_LT(growthPerStep(h * h * k, h * d, corrected), 1.0 + 1e-6) // six rigid motions
            << "seed " << seed << ", damped " << damped << ", " << part << (corrected ? " corrected" : "");
        }
    }
}

// What a run leaves is what the next one needs: four runs end where one does, and take one pass per step,
// with a correction one and a half. Only the start takes more: Runge-Kutta's four, three times, and the first
// own force.
TEST(Stoermer, RunsGoOnWhereTheLastOneEnded)
{
  for (const double damping : {20.0, 2500.0}) {
    const auto endAfter = [&](int runs, std::int64_t& evaluated) {
      FastestMode mode;
      mode.stiffness = 1e6;
      mode.damping = mode.decay = damping;
      mode.leastDamping = 1e-6 * damping;
      OneMass mass("stoermer", 1000.0, damping, mode);
      const double h = 0.9 * mass.method->stableStep(mode);
      mass.system.springsEvaluated = 0;
      for (int i = 1; i <= runs; ++i) EXPECT_EQ(mass.run(80.0 * h * i / runs, 80 / runs), StepResult::Done);
      evaluated = mass.system.springsEvaluated;
      return mass.displacement();
    };
    std::int64_t atOnce = 0, inParts = 0;
    const double end = endAfter(1, atOnce);
    EXPECT_NEAR(endAfter(4, inParts), end, 1e-9) << damping; // rounding of a stretch of 1 m, 80 times
    EXPECT_EQ(inParts, atOnce) << damping;
    EXPECT_LE(atOnce, damping > 1000.0 ? 13 + 2 * 77 : 13 + 77); // half a pass of one spring counts as one
  }
}

// A step too small to need corrections, and one that does: both are of fourth order where dampers work (the
// convergence tests see only the one), measured against the closed form.
TEST(Stoermer, BothWaysAreOfFourthOrder)
{
  constexpr double kW = 100.0, kEnd = 0.05;
  for (const bool corrected : {false, true}) {
    const double g = corrected ? 150.0 : 30.0;
    const auto errorWith = [&](std::int64_t steps) {
      FastestMode mode; // of other parts of a net, which are damped well or hardly
      mode.stiffness = kW * kW;
      mode.damping = corrected ? 1e4 : g;
      OneMass mass("stoermer", kW, g, mode);
      EXPECT_EQ(mass.run(kEnd, steps), StepResult::Done);
      const double d = 0.5 * g, w = std::sqrt(kW * kW - d * d);
      const double exact = std::exp(-d * kEnd) * (std::cos(w * kEnd) + d / w * std::sin(w * kEnd));
      return std::abs(mass.displacement() - exact);
    };
    // The first steps are Runge-Kutta's, and the rest rises with the fourth power and the fifth.
    EXPECT_NEAR(std::log2(errorWith(160) / errorWith(320)), 4.0, 0.4) << (corrected ? "corrected" : "alone");
  }
}

} // namespace esm::test
