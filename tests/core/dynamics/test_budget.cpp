// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// A call of advance() ends soon after its budget says so, in a good state, and the next ones get on.
#include "tests/support/nets.h"
#include "tests/support/physics.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace esm::test {
namespace {

constexpr double kFrame = 1.0 / 60.0;

/// Free but for one edge, under weight and struck.
SpringNet struckSheet(Index side, double stiffness)
{
  SpringNet net = sheet(side, 0.005, stiffness);
  net.mass.setConstant(1e-4);
  net.viscosity.setConstant(1e-5 * stiffness);
  for (Index i = 0; i < side; ++i) net.fixed[static_cast<std::size_t>(i)] = 1;
  net.initialVelocity = Eigen::Matrix3Xd::Zero(3, net.nodeCount());
  net.initialVelocity.row(2).tail(side).setConstant(0.3);
  return net;
}

SolverSettings by(const std::string& solver)
{
  SolverSettings settings;
  settings.solver = solver;
  settings.workLimit = 0.0;
  settings.effort = 1e12; // every method goes its own way, however long that is
  settings.tolerance = 1e-4;
  return settings;
}

Loads weight()
{
  Loads loads;
  loads.gravity = {0.0, 0.0, -9.81};
  return loads;
}

/// Says yes when it is asked for the n-th time.
struct Question {
  int yesAt = 0, asked = 0;
  std::function<bool()> function()
  {
    return [this] { return ++asked >= yesAt; };
  }
};

class Budgets : public testing::TestWithParam<const char*> {};

} // namespace

// Between two questions lies a piece of work or, if that is more, a step; and after the answer what ends the
// step and looks at what has been done. A look at the bounds takes up to thirty passes.
TEST_P(Budgets, AreAskedForInTime)
{
  const SpringNet net = struckSheet(30, 2e4);
  const double pass = static_cast<double>(net.springCount());
  const double most = Budget::kPiece + 40.0 * pass;
  double before = 0.0;
  for (int n = 1; n <= 12; ++n) {
    Simulation simulation = simulate(net, weight(), by(GetParam()));
    Question question{n};
    const StepReport report = simulation.advance(20.0 * kFrame, {.isSpent = question.function()});
    if (question.asked < n) break; // it was done
    EXPECT_TRUE(report.interrupted && report.stepLimit);
    EXPECT_EQ(question.asked, n) << "who has heard yes asks no more";
    EXPECT_LT(report.simulatedTime, 20.0 * kFrame);
    EXPECT_TRUE(simulation.state().position.allFinite());
    EXPECT_DOUBLE_EQ(simulation.state().time, report.simulatedTime);
    EXPECT_NE(simulation.why().find("time allowed was over"), std::string::npos) << simulation.why();
    const double work = static_cast<double>(report.springsEvaluated);
    EXPECT_LE(work - before, most) << "question " << n;
    before = std::max(before, work);
  }
  EXPECT_GT(before, 0.0);
}

// What was done up to the answer is kept, so the pieces arrive where the whole does: within the tolerance of
// both where a method keeps one; and where it errs by frame steps, with no more energy than there was.
TEST_P(Budgets, LeaveAGoodStateFromWhichItGoesOn)
{
  constexpr double kEnd = 4.0 * kFrame;
  const SpringNet net = struckSheet(8, 500.0);
  SolverSettings settings = by(GetParam());
  settings.tolerance = 1e-3;
  Simulation whole = simulate(net, weight(), settings), parts = simulate(net, weight(), settings);
  ASSERT_TRUE(whole.advance(kEnd).good());
  const double before = parts.energies().total();
  int calls = 0, interrupted = 0;
  while (parts.state().time < kEnd * (1.0 - 1e-9) && ++calls < 5000) {
    Question question{1 + (calls % 2 == 1 ? calls % 3 : 13 * calls % 97)};
    const StepReport report =
      parts.advance(std::min(kFrame, kEnd - parts.state().time), {.isSpent = question.function()});
    interrupted += report.interrupted;
    ASSERT_TRUE(report.good() || report.interrupted) << parts.why();
  }
  EXPECT_LT(calls, 5000);
  EXPECT_GT(interrupted, 0);
  EXPECT_LE(parts.energies().total(), before + 1e-3 * std::abs(before));
  if (whole.advance(kFrame).rough) return;
  const double moved = (whole.state().position - net.restPosition).norm();
  parts.advance(kFrame);
  EXPECT_LE((parts.state().position - whole.state().position).norm(), 1e-2 * moved);
}

INSTANTIATE_TEST_SUITE_P(Methods, Budgets,
                         testing::Values("auto", "leapfrog", "verlet", "stoermer", "chebyshev", "implicit",
                                         "multirate", "block-descent", "descent"));

TEST(Budget, OfStepsEndsAtTheSameBits)
{
  const auto run = [](std::int64_t steps) {
    Simulation simulation = simulate(struckSheet(12, 2e3), weight(), by("auto"));
    simulation.advance(kFrame, {.steps = steps});
    return simulation.state().position;
  };
  EXPECT_EQ(run(7), run(7));
  EXPECT_EQ(run(0), run(0));
  EXPECT_NE(run(7), run(20));
}

// Nobody who is never interrupted pays for it or moves otherwise, as long as runs are shorter than a piece.
TEST(Budget, ThatLastsChangesNoBit)
{
  const SpringNet net = struckSheet(8, 500.0);
  SolverSettings settings = by("auto");
  settings.tolerance = 1e-2; // runs of some ten steps of 161 springs
  Simulation asked = simulate(net, weight(), settings), alone = simulate(net, weight(), settings);
  for (int frame = 0; frame < 30; ++frame) {
    asked.advance(kFrame, {.isSpent = [] { return false; }});
    alone.advance(kFrame);
    EXPECT_EQ(asked.state().position, alone.state().position);
  }
}

// A frame that the clock has broken off tells that plain steps take too long here.
TEST(Budget, ThatDoesNotLastMakesWhoKeepsTimeTakeBlocks)
{
  SolverSettings settings = by("auto");
  settings.keepsTime = true;
  Simulation simulation = simulate(struckSheet(30, 2e4), weight(), settings);
  Question question{3};
  EXPECT_TRUE(simulation.advance(kFrame, {.isSpent = question.function()}).interrupted);
  const StepReport next = simulation.advance(kFrame, {.isSpent = [] { return false; }});
  EXPECT_TRUE(next.good() && next.rough);
  EXPECT_NE(simulation.why().find("to keep time"), std::string::npos) << simulation.why();
}

} // namespace esm::test
