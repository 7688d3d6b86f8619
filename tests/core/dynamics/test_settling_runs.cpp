// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// Whole motions end in balance, within the tolerance.
#include "core/dynamics/rest/settling.h"
#include "tests/core/dynamics/skip_nets.h"
#include "tests/support/physics.h"

#include <algorithm>

namespace esm::test {
namespace {

/// A sheet that swings on its bedding some ten times before it rests.
SpringNet livelySheet()
{
  SpringNet net = beddedSheet(12);
  for (double& viscosity : net.anchors.viscosity) viscosity = 3e-4;
  return net;
}

} // namespace

// What is seen at a glance is never more than what a factor finds, in whichever moment of a net's motion.
TEST(Settling, GlancesFromBelow)
{
  const SpringNet net = livelySheet();
  Loads loads;
  loads.forces.push_back({{70, 71}, curve({0.0}, Eigen::Vector3d(0, 2e-3, 5e-3))});
  Simulation simulation = simulate(net, loads, settingsOf(1e-4, false));
  System system(net, loads);
  Settling settling;
  StepReport report;
  for (int frame = 0; frame < 30; ++frame) {
    ASSERT_TRUE(simulation.advance(1.0 / 60.0).good());
    const NetState& state = simulation.state();
    MotionState motion = startOf(net);
    system.enter(motion, true);
    copyNodes(state.position, motion.x);
    copyNodes(state.velocity, motion.v);
    const SettlingBudget budget{1e-14, 0.0, 0.0};
    const double glanced = settling.glance(system, motion, budget, report);
    const double missed = settling.settle(system, motion, budget, report);
    EXPECT_GT(missed, 1.0); // so that nothing was moved
    EXPECT_LE(glanced, missed * (1.0 + 1e-9)) << frame;
    EXPECT_GT(glanced, std::min(16.0, 0.1 * missed)) << frame; // further it need not look
  }
}

// A net that swings down to a load ends where the energy is least, at rest while single nodes would still
// swing, and the error of the whole run keeps the tolerance. The work of the load is counted on the way.
TEST(Settling, EndsARunInBalanceWithinTheTolerance)
{
  Loads loads;
  loads.forces.push_back({{70, 71}, curve({0.0}, Eigen::Vector3d(0, 2e-3, 5e-3))});
  Simulation full = simulate(livelySheet(), loads, fixedSteps("rk4", 2e-5));
  const Frames reference = play(full, 60);
  Simulation relaxing = simulate(livelySheet(), loads, settingsOf(1e-6, true, "relax"));
  const Frames balance = play(relaxing, 1);
  const double way = (balance.position.back() - balance.position.front()).norm();
  for (const double tolerance : {1e-1, 1e-2, 1e-3}) {
    SCOPED_TRACE(tolerance);
    Simulation simulation = simulate(livelySheet(), loads, settingsOf(tolerance, true));
    const double energy = test::balance(simulation);
    const Frames frames = play(simulation, 60);
    EXPECT_LT(errorOf(frames, reference), tolerance);
    EXPECT_EQ(frames.report.back().springsEvaluated, 0);
    // One of Newton's steps over a way of a third of the tolerance leaves the square of it, about; and it is
    // known to a hundredth.
    EXPECT_LT((frames.position.back() - balance.position.back()).norm(),
              tolerance * (tolerance + 1e-2) * way);
    // The quadrature of work and heat is as good as the tolerance asks.
    EXPECT_NEAR(test::balance(simulation), energy, std::max(5e-3, tolerance) * simulation.dissipatedEnergy());
  }
}

// A net that is pulled and let go moves a little at the end of a long run: what may be missed then is a share
// of the mean over all of that run, not of the mean up to now, which was larger.
TEST(Settling, MissesAShareOfTheWholeRunWhereItsEndIsKnown)
{
  Loads loads;
  loads.forces.push_back(
    {{70, 71},
     curve({0.0, 0.1, 0.1001},
           (Eigen::Matrix3Xd(3, 3) << 0, 0, 0, 2e-3, 2e-3, 0, 5e-3, 5e-3, 0).finished())});
  Simulation full = simulate(livelySheet(), loads, fixedSteps("rk4", 2e-5));
  const Frames reference = play(full, 90);
  constexpr double kTolerance = 0.1;
  SolverSettings settings = settingsOf(kTolerance, true);
  settings.duration = 10.0; // nothing happens after the second and a half that is looked at
  Simulation simulation = simulate(livelySheet(), loads, settings);
  const Frames frames = play(simulation, 90);
  EXPECT_LT(errorOf(frames, reference), kTolerance);
  EXPECT_EQ(frames.report.back().springsEvaluated, 0);
}

// A poke that is held ends where it is, beside nodes that never woke, as soon as what is left of it may be
// missed: after 8 frames at 1e-2 and 10 at 1e-3, not when each of its nodes has become slow, which takes 15
// and 16.
TEST(Settling, EndsTheMotionOfAPart)
{
  const SpringNet net = beddedSheet(100);
  Loads loads;
  loads.forces.push_back(
    {{5050, 5051}, curve({0.0, 0.1}, (Eigen::Matrix3Xd(3, 2) << 0, 0, 0, 2e-3, 0, 5e-3).finished())});
  Simulation full = simulate(net, loads, settingsOf(1e-5, false));
  const Frames reference = play(full, 40);
  for (const double tolerance : {1e-2, 1e-3}) {
    SCOPED_TRACE(tolerance);
    Simulation simulation = simulate(net, loads, settingsOf(tolerance, true));
    const Frames frames = play(simulation, 40);
    EXPECT_LT(errorOf(frames, reference), tolerance);
    std::size_t rested = 0;
    while (rested < 40 && frames.report[rested].nodesAwake > 0) {
      EXPECT_LT(frames.report[rested].nodesAwake, net.nodeCount() / 2);
      ++rested;
    }
    EXPECT_LE(rested, 12u);
  }
}

} // namespace esm::test
