// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// What must stay, balance or be as the loads say, with every solver.
#include "tests/support/methods.h"
#include "tests/support/nets.h"
#include "tests/support/physics.h"

#include <Eigen/Geometry>

namespace esm::test {
namespace {

VectorCurve curve(std::vector<double> time, std::vector<Eigen::Vector3d> values)
{
  VectorCurve result;
  result.time = std::move(time);
  result.value.resize(3, static_cast<Eigen::Index>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i) result.value.col(static_cast<Eigen::Index>(i)) = values[i];
  return result;
}

class Conservation : public ::testing::TestWithParam<std::string> {
protected:
  SolverSettings settings(double tolerance) const
  {
    SolverSettings s;
    s.solver = GetParam();
    s.tolerance = tolerance;
    s.workLimit = 0.0; // a method that is named takes the steps that it takes
    return s;
  }
  /// Velocities half a step beside the positions see dampers turned by that much: heat is of first order.
  bool isStaggered() const
  {
    const std::string& solver = GetParam();
    return solver == "leapfrog" || solver == "chebyshev" || solver == "stoermer3";
  }
  bool isFirstOrder() const { return GetParam() == "leapfrog"; } ///< where dampers work
  bool isImplicit() const { return GetParam() == "implicit"; }
};
INSTANTIATE_TEST_SUITE_P(Solvers, Conservation, ::testing::ValuesIn(accurateMethods()),
                         [](const auto& solver) { return testName(solver.param); });

} // namespace

// A net that flies straight on stays as it is: no spring is stretched, no damper works.
TEST_P(Conservation, TranslationCostsNoEnergy)
{
  SpringNet net = relaxed(4, 12);
  net.initialVelocity = Eigen::Vector3d(1.0, -2.0, 0.5).replicate(1, net.nodeCount());
  Simulation simulation = simulate(net, {}, settings(1e-3));
  const double kinetic = simulation.energies().kinetic;
  advanceWell(simulation, 1.0);
  EXPECT_NEAR(simulation.energies().kinetic, kinetic, 1e-10 * kinetic);
  EXPECT_LT(simulation.energies().elastic, 1e-16 * kinetic);
  EXPECT_LT(simulation.dissipatedEnergy(), 1e-16 * kinetic);
  const Eigen::Matrix3Xd straight = net.restPosition + net.initialVelocity;
  EXPECT_LT((simulation.state().position - straight).norm(), 1e-9);
}

// A dumb-bell that spins in balance: the spring's pull k (l - L) = m w^2 l/2 holds the circle, so length,
// energy and angular momentum stay and nothing is dissipated although the spring has a damper.
TEST_P(Conservation, RotationCostsNoEnergy)
{
  const double k = 100.0, w = 3.0, length = 1.0, m = 1.0;
  SpringNet net = chain(2, length, k);
  net.restPosition.colwise() -= Eigen::Vector3d(0.5 * length, 0, 0);
  net.restLength[0] = length - m * w * w * length / (2 * k);
  net.viscosity[0] = 5.0;
  net.initialVelocity = Eigen::Matrix3Xd::Zero(3, 2);
  net.initialVelocity(1, 0) = -0.5 * w * length;
  net.initialVelocity(1, 1) = 0.5 * w * length;
  Simulation simulation = simulate(net, {}, settings(1e-4));
  const double energy = simulation.energies().total();
  const Eigen::Vector3d spin = simulation.angularMomentum();
  EXPECT_NEAR(spin.z(), 0.5 * m * w * length * length, 1e-14);
  advanceWell(simulation, 2.0);
  EXPECT_NEAR(simulation.energies().total(), energy, 1e-4 * energy);
  EXPECT_LT((simulation.angularMomentum() - spin).norm(), 1e-4 * spin.norm());
  EXPECT_LT(simulation.dissipatedEnergy(), (isStaggered() ? 5e-4 : 1e-4) * energy);
  const Eigen::Vector3d axis = simulation.state().position.col(1) - simulation.state().position.col(0);
  EXPECT_NEAR(axis.norm(), length, 1e-4 * length);
  EXPECT_NEAR(axis.x() / length, std::cos(2.0 * w), 5e-4);
}

// kinetic + elastic + gravity + heat - work stays, with all that acts at once: gravity, damped nonlinear
// springs, anchors, mass damping, a force curve, a motion with corners (blows) and a release, a tool that
// comes and moves.
TEST_P(Conservation, WorkAndEnergyBalance)
{
  SpringNet net = randomNet(11, 12, SpringLaw::Exponential);
  net.massDamping = Eigen::ArrayXd::Constant(12, 0.5);
  addAnchor(net, 3, {0.2, 0.1, 0.9}, 40.0, 0.5);
  net.fixed[0] = 1;
  Loads loads;
  loads.gravity = {0, 0, -9.81};
  loads.forces.push_back({{2, 5}, curve({0.05, 0.2, 0.25}, {{0, 0, 0}, {3, 0, 1}, {0, -2, 0}})});
  loads.motions.push_back({{7, 8}, curve({0.0, 0.1, 0.2}, {{0, 0, 0}, {0, 0.1, 0}, {0.1, 0.1, 0}}), 0.3});
  // (1e-5 would take leapfrog 60 million steps.)
  Simulation simulation = simulate(net, loads, settings(isFirstOrder() ? 1e-3 : 1e-5));
  const double before = balance(simulation);
  double largest = 0.0;
  for (int frame = 0; frame < 30; ++frame) {
    if (frame >= 10) {
      const Eigen::Vector3d target = net.restPosition.col(4) + Eigen::Vector3d(0.01 * (frame - 10), 0, 0.1);
      const ToolSpring tool{4, target, {0.6, 0, 0}, 30.0, 0.4};
      simulation.setTools({&tool, 1});
    }
    advanceWell(simulation, 1.0 / 60.0);
    largest = std::max(largest, std::abs(balance(simulation) - before));
  }
  EXPECT_GT(simulation.dissipatedEnergy(), 0.1) << "something must have happened";
  EXPECT_GT(std::abs(simulation.externalWork()), 0.1);
  EXPECT_LT(largest, isStaggered() ? 4e-3 : 2e-4) << "of about 1 J that went in and out";
}

// A node of mass m on a tool that moves with V, y ahead of it: m y" + c y' + k y = 0 from y' = V, by the closed form.
// The tool has given the node all its momentum m v, so its work is the force times V over time, V m v.
TEST_P(Conservation, ATargetThatMovesIsAMovingSupport)
{
  const double k = 40.0, c = 0.6, m = 0.5, speed = 0.3, w = std::sqrt(k / m - 0.25 * c * c / (m * m));
  SpringNet net = chain(2, 1.0, 0.0);
  net.mass[1] = m;
  net.fixed[0] = 1;
  const Eigen::Vector3d start = net.restPosition.col(1), way(0.0, speed, 0.0);
  for (const bool isSetAnew : {false, true}) {
    Simulation simulation = simulate(net, {}, settings(isFirstOrder() ? 1e-4 : 1e-6));
    for (int frame = 0; frame < 30; ++frame) {
      const ToolSpring tool{1, start + frame / 60.0 * way, way, k, c, true};
      if (frame == 0 || isSetAnew) simulation.setTools({&tool, 1});
      advanceWell(simulation, 1.0 / 60.0);
    }
    const double t = 0.5, fade = speed * std::exp(-0.5 * c / m * t) / w;
    const double y = fade * std::sin(w * t),
                 rate = fade * (w * std::cos(w * t) - 0.5 * c / m * std::sin(w * t));
    const double close = isFirstOrder() ? 1e-3 : 1e-5; // ten of the tolerance
    EXPECT_NEAR(simulation.state().position(1, 1), speed * t - y, close * speed * t);
    EXPECT_NEAR(simulation.state().velocity(1, 1), speed - rate, close * w * speed * t);
    EXPECT_NEAR(simulation.toolForce(0).y(), k * y + c * rate, close * k * speed * t);
    const double work = m * speed * (speed - rate), stored = 0.5 * k * y * y;
    EXPECT_NEAR(simulation.externalWork(), work, 2.0 * close * work);
    EXPECT_NEAR(simulation.energies().elastic, stored, 10.0 * close * work);
    EXPECT_NEAR(balance(simulation), 0.0, (isStaggered() ? 1e-2 : 10.0 * close) * work);
  }
}

// A node led slowly away from a fixed one: the hand's force is the spring's.
TEST_P(Conservation, ReactionOfAPrescribedNodeIsTheSpringForce)
{
  SpringNet net = chain(2, 1.0, 50.0);
  net.viscosity[0] = 2.0;
  net.fixed[0] = 1;
  Loads loads;
  loads.motions.push_back({{1}, curve({0.0, 1.0}, {{0, 0, 0}, {0.2, 0, 0}}), {}});
  Simulation simulation = simulate(net, loads, settings(1e-4));
  advanceWell(simulation, 0.5);
  EXPECT_NEAR(simulation.state().position(0, 1), 1.1, 1e-15);
  const double tension = 50.0 * 0.1 + 2.0 * 0.2; // stretched by 0.1 m at 0.2 m/s
  EXPECT_NEAR(simulation.reaction(1).x(), tension, 1e-12);
  EXPECT_NEAR(simulation.reaction(0).x(), -tension, 1e-12);
  Eigen::ArrayXd tensions(1);
  simulation.springTensions(tensions);
  EXPECT_NEAR(tensions[0], tension, 1e-12);
  advanceWell(simulation, 0.5);
  EXPECT_DOUBLE_EQ(simulation.reaction(1).x(), 50.0 * (simulation.state().position(0, 1) - 1.0))
    << "at the end it rests";
  // Work: stored in the spring and burnt in the damper, less the kinetic energy that the node had at t = 0
  // and gave back when it was stopped.
  EXPECT_NEAR(simulation.externalWork(), 0.5 * 50.0 * 0.04 + 2.0 * 0.04 - 0.5 * 0.04, 1e-6);
}

// Until the release the node is where the curve says; at that instant it flies on with the curve's speed.
TEST_P(Conservation, ReleasedNodeKeepsPositionAndVelocity)
{
  SpringNet net = chain(2, 1.0, 0.0);
  Loads loads;
  loads.motions.push_back({{1}, curve({0.0, 0.25}, {{0, 0, 0}, {0, 0.5, 0}}), 0.25});
  Simulation simulation = simulate(net, loads, settings(1e-3));
  advanceWell(simulation, 0.1);
  EXPECT_NEAR(simulation.state().position(1, 1), 0.2, 1e-15);
  EXPECT_NEAR(simulation.state().velocity(1, 1), 2.0, 1e-14);
  advanceWell(simulation, 0.4);
  EXPECT_NEAR(simulation.state().position(1, 1), 0.5 + 0.25 * 2.0, 1e-12);
  EXPECT_NEAR(simulation.state().velocity(1, 1), 2.0, 1e-14);
  EXPECT_TRUE(simulation.reaction(1).isZero(0.0));
}

// A motion that rests before its release lets go at rest; before its first time the first value holds.
TEST_P(Conservation, MotionHoldsItsEndValues)
{
  SpringNet net = chain(2, 1.0, 0.0);
  Loads loads;
  loads.motions.push_back({{1}, curve({0.1, 0.2}, {{0.3, 0, 0}, {0.5, 0, 0}}), 0.4});
  Simulation simulation = simulate(net, loads, settings(1e-3));
  EXPECT_NEAR(simulation.state().position(0, 1), 1.3, 1e-15);
  advanceWell(simulation, 0.05);
  EXPECT_NEAR(simulation.state().position(0, 1), 1.3, 1e-15);
  advanceWell(simulation, 0.95);
  EXPECT_NEAR(simulation.state().position(0, 1), 1.5, 1e-15);
  EXPECT_EQ(simulation.state().velocity(0, 1), 0.0);
}

// A constant force on a free mass: x = F t^2 / 2m, whatever the frames are; the jump at 0.1 s is hit exactly.
TEST_P(Conservation, ForceJumpIsHitExactly)
{
  SpringNet net = chain(2, 1.0, 0.0);
  net.mass[0] = 2.0;
  Loads loads;
  loads.forces.push_back({{0}, curve({0.1, 0.1}, {{0, 0, 0}, {0, 6, 0}})});
  Simulation simulation = simulate(net, loads, settings(1e-3));
  for (int frame = 0; frame < 7; ++frame) advanceWell(simulation, 0.037);
  const double since = 7 * 0.037 - 0.1;
  EXPECT_NEAR(simulation.state().position(1, 0), 0.5 * 3.0 * since * since, 1e-12);
  EXPECT_NEAR(simulation.state().velocity(1, 0), 3.0 * since, 1e-12);
}

TEST_P(Conservation, FixedNodesStayWhateverALoadSays)
{
  SpringNet net = chain(3, 1.0, 10.0);
  net.fixed[1] = 1;
  net.initialVelocity = Eigen::Matrix3Xd::Ones(3, 3);
  Loads loads;
  loads.gravity = {0, -9.81, 0};
  loads.forces.push_back({{1}, curve({0.0}, {{5, 5, 5}})});
  loads.motions.push_back({{1}, curve({0.0, 1.0}, {{0, 0, 0}, {1, 0, 0}}), {}});
  Simulation simulation = simulate(net, loads, settings(1e-3));
  advanceWell(simulation, 0.3);
  EXPECT_EQ(simulation.state().position.col(1), net.restPosition.col(1));
  EXPECT_TRUE(simulation.state().velocity.col(1).isZero(0.0));
}

} // namespace esm::test
