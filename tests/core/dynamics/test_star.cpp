// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// Many springs on one free hub: it swings a hundred times faster than what hangs on it, and must not set the
// steps of all.
#include "core/dynamics/methods/stiff_nodes.h"
#include "tests/support/nets.h"
#include "tests/support/physics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace esm::test {
namespace {

constexpr double kDuration = 0.1; // [s]

/// Leaves of a gram on a sphere of 0.1 m about the hub, node 0, each on a spring of its own.
SpringNet star(Index leaves, double hubMass, double stretch, double viscosity = 0.0)
{
  std::mt19937 random(7);
  const auto uniform = [&] { return static_cast<double>(random()) / 2147483648.0 - 1.0; };
  SpringNet net;
  addNode(net, Eigen::Vector3d::Zero());
  net.restPosition.conservativeResize(3, leaves + 1);
  net.mass = Eigen::ArrayXd::Constant(leaves + 1, 1e-3);
  net.mass[0] = hubMass;
  net.fixed.assign(at(leaves + 1), 0);
  net.nodeId.clear();
  for (Index i = 0; i <= leaves; ++i) net.nodeId.push_back(static_cast<NodeId>(i));
  net.ends.resize(2, leaves);
  for (Index i = 0; i < leaves; ++i) {
    const Eigen::Vector3d towards(uniform(), uniform(), uniform());
    net.restPosition.col(i + 1) = 0.1 * towards.normalized();
    net.ends.col(i) << 0, i + 1;
    net.springId.push_back(static_cast<SpringId>(i));
  }
  net.restLength = Eigen::ArrayXd::Constant(leaves, 0.1 / stretch);
  net.stiffness = Eigen::ArrayXd::Constant(leaves, 10.0);
  net.viscosity = Eigen::ArrayXd::Constant(leaves, viscosity);
  net.law.assign(at(leaves), SpringLaw::Linear);
  net.lawParameter = Eigen::ArrayXd::Zero(leaves);
  net.tensionOnly.assign(at(leaves), 0);
  net.kind.assign(at(leaves), SpringKind::Line);
  return net;
}

/// Two stars whose hubs are joined by a spring as stiff as each of them.
SpringNet twinStars(Index leaves)
{
  SpringNet net = star(leaves, 1e-3, 1.0, 0.01);
  const SpringNet other = net;
  const Index hub = net.nodeCount();
  for (Index i = 0; i < other.nodeCount(); ++i) {
    addNode(net, other.restPosition.col(i) + Eigen::Vector3d(0.25, 0.05, 0.0));
    net.mass[hub + i] = other.mass[i];
  }
  for (Index s = 0; s < other.springCount(); ++s)
    addSpring(net, hub + other.ends(0, s), hub + other.ends(1, s), other.stiffness[s], other.viscosity[s]);
  addSpring(net, 0, hub, 10.0 * static_cast<double>(leaves), 0.01 * static_cast<double>(leaves));
  return net;
}

/// A push aside on half of the leaves, for a third of the time.
Loads wind(const SpringNet& net)
{
  NodalForce force;
  for (Index i = 1; i < net.nodeCount(); ++i)
    if (net.restPosition(0, i) > 0.0) force.nodes.push_back(i);
  force.force.time = {0.0, 0.03, 0.03};
  force.force.value = Eigen::Matrix3Xd::Zero(3, 3);
  force.force.value(1, 0) = force.force.value(1, 1) = 0.01;
  return {Eigen::Vector3d::Zero(), {force}, {}};
}

Simulation ofStar(const SpringNet& net, const Loads& loads, double tolerance, const char* solver = "auto")
{
  SolverSettings settings;
  settings.solver = solver;
  settings.tolerance = tolerance;
  settings.duration = kDuration;
  settings.skipResting = false;
  return simulate(net, loads, settings);
}

/// @return force passes.
double play(SpringNet net, const Loads& loads, bool isHeld)
{
  net.fixed[0] = isHeld;
  Simulation simulation = ofStar(net, loads, 1e-3);
  StepReport sum;
  for (int frame = 1; frame <= 6; ++frame)
    sum.add(simulation.advance(frame / 60.0 - simulation.state().time));
  EXPECT_TRUE(sum.good()) << simulation.why();
  EXPECT_FALSE(sum.rough) << simulation.why();
  return static_cast<double>(sum.springsEvaluated) / net.springCount();
}

/// Root of the mean square over nodes and frames, over that of the motion.
double errorAgainstReference(const SpringNet& net, const Loads& loads)
{
  Simulation simulation = ofStar(net, loads, 1e-3), exact = ofStar(net, loads, 1e-7, "dopri5");
  double error = 0.0, motion = 0.0;
  for (int frame = 1; frame <= 6; ++frame) {
    for (Simulation* one : {&simulation, &exact}) advanceWell(*one, frame / 60.0 - one->state().time);
    error += (simulation.state().position - exact.state().position).squaredNorm();
    motion += (exact.state().position - net.restPosition).squaredNorm();
  }
  return std::sqrt(error / motion);
}

} // namespace

// At their limit explicit steps of this star take 13 to 20 times the passes of the held one, whose hub does not
// swing. Ten is what whoever lets a hub go may be asked for.
TEST(Star, AFreeHubCostsNoMoreThanTenHeldOnes)
{
  constexpr Index kLeaves = 100'000;
  const SpringNet resting = star(kLeaves, 1e-3, 1.0), pressed = star(kLeaves, 1e-3, 1.0 / 1.1);
  const Loads push = wind(resting);
  EXPECT_LE(play(resting, push, false), 10.0 * play(resting, push, true));
  EXPECT_LE(play(pressed, {}, false), 10.0 * play(pressed, {}, true));
}

// The hub of 2,000 leaves swings 26 times faster than these, or 80 times where it is light.
TEST(Star, KeepsItsToleranceWithAFreeHub)
{
  for (const double viscosity : {0.0, 0.02})
    for (const double hubMass : {1e-3, 1e-4}) {
      const SpringNet net = star(2000, hubMass, 1.0, viscosity);
      EXPECT_LE(errorAgainstReference(net, wind(net)), 1e-3) << hubMass << ' ' << viscosity;
    }
}

// Half of the step, a quarter of the error: by the order of both rules, with a hub that swings slower than the
// steps, so that there is an order to see.
TEST(Star, FewImplicitNodesAreOfSecondOrder)
{
  const SpringNet net = star(400, 1e-3, 1.0, 0.01);
  const Loads loads = wind(net);
  Simulation exact = simulate(net, loads, fixedSteps("dopri5", 1e-5));
  advanceWell(exact, 0.02);
  double errors[2];
  for (const int halving : {0, 1}) {
    Simulation simulation = simulate(net, loads, fixedSteps("multirate", 2e-4 / (1 + halving)));
    advanceWell(simulation, 0.02);
    errors[halving] = (simulation.state().position - exact.state().position).norm();
  }
  EXPECT_NEAR(errors[0] / errors[1], 4.0, 0.4);
}

// What joins two of the few stands in their matrix: of second order, and with as many passes as one alone takes.
TEST(Star, JoinedHubsAreSolvedTogether)
{
  const SpringNet net = twinStars(400);
  std::vector<Index> hubs = StiffNodes::find(System(net, {}));
  std::sort(hubs.begin(), hubs.end());
  EXPECT_EQ(hubs, (std::vector<Index>{0, 401}));
  const Loads loads = wind(net);
  Simulation exact = simulate(net, loads, fixedSteps("dopri5", 1e-5));
  advanceWell(exact, 0.02);
  double errors[2], passes = 0.0;
  for (const int halving : {0, 1}) {
    Simulation simulation = simulate(net, loads, fixedSteps("multirate", 2e-4 / (1 + halving)));
    const StepReport report = simulation.advance(0.02);
    ASSERT_TRUE(report.good()) << simulation.why();
    errors[halving] = (simulation.state().position - exact.state().position).norm();
    passes =
      static_cast<double>(report.springsEvaluated) / static_cast<double>(net.springCount() * report.steps);
  }
  EXPECT_NEAR(errors[0] / errors[1], 4.0, 0.4);
  EXPECT_LE(passes, 2.0) << "of a step";
}

TEST(StiffNodes, AreTheHubsAndNobodyElse)
{
  const auto found = [](const SpringNet& net) { return StiffNodes::find(System(net, {})); };
  EXPECT_EQ(found(star(2000, 1e-3, 1.0)), std::vector<Index>{0});
  EXPECT_TRUE(found(star(2000, 100.0, 1.0)).empty()) << "a hub so heavy is as slow as the others";
  EXPECT_TRUE(found(chain(100)).empty());
  EXPECT_TRUE(found(sheet(10, 0.1, 100.0)).empty());
  SpringNet gripped = sheet(10, 0.1, 100.0);
  addAnchor(gripped, 44, gripped.restPosition.col(44), 1e5);
  EXPECT_EQ(found(gripped), std::vector<Index>{44});
}

} // namespace esm::test
