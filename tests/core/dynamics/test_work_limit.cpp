// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// Every run has a limit of work, and says when it has reached it.
#include "tests/support/nets.h"
#include "tests/support/physics.h"

#include <gtest/gtest.h>

namespace esm::test {
namespace {

/// A gram of two nodes that swing at 1.4e9/s.
SpringNet stiffPair()
{
  SpringNet net = chain(2, 0.1, 1e15);
  net.mass.setConstant(1e-3);
  net.initialVelocity = Eigen::Matrix3Xd::Zero(3, 2);
  net.initialVelocity(0, 0) = 1.0;
  return net;
}

} // namespace

TEST(WorkLimit, EndsARunOfFixedStepsAndSaysWhereItIs)
{
  SolverSettings settings = fixedSteps("verlet", 1e-8);
  settings.workLimit = 1e3;
  SpringNet net = chain(3, 0.1, 100.0);
  Simulation simulation = simulate(net, {}, settings);
  const StepReport report = simulation.advance(1.0 / 60.0);
  EXPECT_TRUE(report.stepLimit);
  EXPECT_FALSE(report.good());
  EXPECT_LE(report.steps, 1000);
  EXPECT_NEAR(simulation.state().time, 1e-8 * static_cast<double>(report.steps), 1e-3 * 1e-5);
  EXPECT_NE(simulation.why().find("the work limit of 1e+03 force passes"), std::string::npos)
    << simulation.why();
}

// What one frame leaves over another may take, up to the end that is known.
TEST(WorkLimit, IsOfTheWholeRun)
{
  SolverSettings settings = fixedSteps("verlet", 1.0 / 60.0 / 100.0);
  settings.workLimit = 60;
  settings.duration = 4.0 / 60.0;
  Simulation simulation = simulate(chain(3, 0.1, 1.0), {}, settings);
  EXPECT_TRUE(simulation.advance(2.0 / 60.0).good());
  const StepReport report = simulation.advance(2.0 / 60.0);
  EXPECT_TRUE(report.stepLimit);
  EXPECT_NEAR(static_cast<double>(report.steps), 40.0, 2.0);
  simulation.reset();
  EXPECT_TRUE(simulation.advance(2.0 / 60.0).good()) << "a run after reset() is another one";
}

TEST(WorkLimit, AutoPlansToStayBelow)
{
  SolverSettings settings;
  settings.workLimit = 2e3;
  settings.duration = 0.5;
  Simulation simulation = simulate(stiffPair(), {}, settings);
  StepReport sum;
  for (int frame = 0; frame < 30 && sum.good(); ++frame) sum.add(simulation.advance(1.0 / 60.0));
  EXPECT_LE(static_cast<double>(sum.springsEvaluated), 30.0 * settings.workLimit);
  EXPECT_TRUE(sum.rough || sum.stepLimit) << simulation.why();
}

// No spring to evaluate, and an anchor that asks for 1e10 steps a frame: steps count, too.
TEST(WorkLimit, CountsStepsWhereThereIsNoSpring)
{
  SpringNet net;
  addAnchor(net, addNode(net, {0.1, 0, 0}), {0, 0, 0}, 1e12);
  net.mass.setConstant(1e-6);
  SolverSettings settings;
  settings.workLimit = 1e3;
  settings.solver = "leapfrog";
  Simulation simulation = simulate(net, {}, settings);
  const StepReport report = simulation.advance(1.0 / 60.0);
  EXPECT_TRUE(report.stepLimit) << simulation.why();
  EXPECT_LE(report.steps, 1000);
}

TEST(WorkLimit, IsRefusedIfItIsNone)
{
  SolverSettings settings;
  settings.workLimit = -1.0;
  EXPECT_FALSE(Simulation::create(chain(2), {}, settings));
}

} // namespace esm::test
