// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// What nothing holds falls by its weight and flies on by its momentum, whatever its springs, its sleep and
// its steps.
#include "tests/support/free_centres.h"
#include "tests/support/nets.h"
#include "tests/support/physics.h"
#include "tests/support/stress_nets.h"

#include <gtest/gtest.h>

namespace esm::test {
namespace {

VectorCurve constant(const Eigen::Vector3d& value)
{
  VectorCurve curve;
  curve.time = {0.0};
  curve.value = value;
  return curve;
}

/// Three nodes of a gram, 0.1 m apart, joined by springs of k [N/m].
SpringNet triangle(double k)
{
  SpringNet net;
  for (const Eigen::Vector3d& place : {Eigen::Vector3d{0, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}})
    addNode(net, place);
  for (const auto& [a, b] : {std::pair{0, 1}, {1, 2}, {0, 2}}) addSpring(net, a, b, k);
  net.mass.setConstant(1e-3);
  return net;
}

} // namespace

// z = g t^2 / 2; a spring of 1e12 N/m answers a weight of 0.01 N by a length that no number holds.
TEST(FreeBodies, StiffTriangleFalls)
{
  Loads loads;
  loads.gravity = {0, 0, -9.81};
  for (const double k : {1.0, 1e6, 1e12}) {
    Simulation simulation = simulate(triangle(k), loads);
    for (int frame = 0; frame < 30; ++frame) advanceWell(simulation, 1.0 / 60.0);
    for (Index node = 0; node < 3; ++node)
      EXPECT_NEAR(simulation.state().position(2, node), -9.81 / 8.0, 1e-9 * 9.81 / 8.0) << k;
  }
}

// A rod that hangs by one end starts to fall with it: alpha = g / l for a mass at the end of a hinged spring.
TEST(FreeBodies, StiffRodOnAHingeSwings)
{
  SpringNet net = chain(2, 0.1, 1e10);
  net.mass.setConstant(1e-3);
  net.fixed[0] = 1;
  Loads loads;
  loads.gravity = {0, 0, -9.81};
  SolverSettings settings;
  settings.tolerance = 0.1; // for which its springs could answer the forces by lengths that nobody sees
  Simulation simulation = simulate(net, loads, settings);
  advanceWell(simulation, 0.02);
  EXPECT_NEAR(simulation.state().position(2, 1), -9.81 / 2.0 * 0.02 * 0.02, 1e-2 * 9.81 / 2.0 * 0.02 * 0.02);
}

// Two forces that cancel out turn a stiff rod: alpha = torque / inertia = 2 f / (m l).
TEST(FreeBodies, CoupleTurnsAStiffRod)
{
  SpringNet net = chain(2, 0.1, 1e10);
  net.mass.setConstant(1e-3);
  Loads loads;
  loads.forces.push_back({{0}, constant({0, 1e-3, 0})});
  loads.forces.push_back({{1}, constant({0, -1e-3, 0})});
  SolverSettings settings;
  settings.tolerance = 0.1; // for which its springs could answer the forces by lengths that nobody sees
  Simulation simulation = simulate(net, loads, settings);
  advanceWell(simulation, 0.05);
  EXPECT_NEAR(simulation.state().position(1, 0), 0.5 * 0.05 * 0.05, 1e-2 * 0.5 * 0.05 * 0.05);
}

// What drifts slower than any watch over nodes sees still drifts, alone and beside what rests.
TEST(FreeBodies, SlowDriftNeverSleeps)
{
  SpringNet net = triangle(10.0);
  const Index held = addNode(net, {1, 0, 0}), other = addNode(net, {1.1, 0, 0});
  addSpring(net, held, other, 10.0);
  net.fixed[static_cast<std::size_t>(held)] = 1;
  net.initialVelocity = Eigen::Matrix3Xd::Zero(3, net.nodeCount());
  net.initialVelocity.leftCols(3).row(1).setConstant(1e-11);
  Simulation simulation = simulate(net);
  for (int frame = 0; frame < 120; ++frame) advanceWell(simulation, 1.0 / 60.0);
  const Eigen::Matrix3Xd moved = simulation.state().position - net.restPosition;
  EXPECT_NEAR(moved.row(1).head(3).mean(), 2e-11, 1e-16) << "rounding of 0.1 m";
  EXPECT_NEAR(simulation.state().velocity.row(1).head(3).mean(), 1e-11, 1e-20);
}

// In the last frame nothing is left to be missed in place; velocities are looked at all the same.
TEST(FreeBodies, AtTheEndOfAMotionWhatDriftsStillDrifts)
{
  constexpr double kDrift = 1e-9;
  SpringNet net = chain(2, 0.1, 1e4);
  net.viscosity.setConstant(100.0);
  net.initialVelocity = Eigen::Matrix3Xd::Zero(3, 2);
  net.initialVelocity.row(0) << 0.1, -0.1;
  net.initialVelocity.row(1).setConstant(kDrift);
  SolverSettings settings;
  settings.duration = 0.5;
  Simulation simulation = simulate(net, {}, settings);
  for (int frame = 1; frame <= 30; ++frame) advanceWell(simulation, frame / 60.0 - simulation.state().time);
  for (Index node = 0; node < 2; ++node)
    EXPECT_NEAR(simulation.state().velocity(1, node), kDrift, 1e-9 * 0.1) << "of the fastest motion";
}

// A wave in a large net that flies: its centre stays, although parts of it would be slow enough to sleep.
TEST(FreeBodies, LargeNetKeepsItsCentreWhileAWaveCrossesIt)
{
  SpringNet net = sheet(50, 1e-3, 100.0);
  net.mass.setConstant(1e-5);
  net.viscosity.setConstant(0.01);
  net.initialVelocity = Eigen::Matrix3Xd::Zero(3, net.nodeCount());
  net.initialVelocity(0, 0) = 0.1;
  SolverSettings settings;
  settings.tolerance = 0.1;
  Simulation simulation = simulate(net, {}, settings);
  FreeCentres centres(simulation.net(), simulation.loads(), simulation.state());
  ASSERT_EQ(centres.freeCount(), 1u);
  for (int frame = 0; frame < 60; ++frame) {
    advanceWell(simulation, 1.0 / 60.0);
    ASSERT_LE(centres.look(simulation.state()), 1.0) << "frame " << frame;
  }
}

// Where neither a tolerance nor a step can be paid for, centres of mass go on as they must: by weight, by a
// force that grows, by their momentum.
TEST(FreeBodies, StepsOfRefugeLeaveCentresAlone)
{
  int rough = 0;
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    StressCase story = stressCase(seed);
    story.net.fixed.assign(story.net.fixed.size(), 0);
    story.net.anchors = {};
    story.net.massDamping.resize(0);
    story.loads.motions.clear();
    VectorCurve ramp{{0.0, 0.1}, Eigen::Matrix3Xd::Zero(3, 2)};
    ramp.value(1, 1) = 10.0 * story.net.mass.sum();
    story.loads.forces = {{{0}, ramp}};
    SolverSettings settings;
    settings.tolerance = 1e-2;
    settings.effort = 1e3;
    Simulation simulation = simulate(story.net, story.loads, settings);
    FreeCentres centres(simulation.net(), simulation.loads(), simulation.state());
    StepReport report;
    for (int frame = 0; frame < 4 && report.good(); ++frame) {
      report.add(simulation.advance(1.0 / 60.0));
      EXPECT_LE(centres.look(simulation.state()), 1.0) << "seed " << seed << ": " << simulation.why();
    }
    rough += report.rough;
  }
  EXPECT_GT(rough, 30) << "most of these must be beyond their effort";
}

} // namespace esm::test
