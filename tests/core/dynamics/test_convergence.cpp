// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// The order that each solver claims, measured: halving the step divides the error by 2^order.
#include "tests/support/methods.h"
#include "tests/support/nets.h"
#include "tests/support/physics.h"

namespace esm::test {
namespace {

struct Case {
  std::string solver;
  double order;
  double step = 4e-3;      ///< coarsest [s]
  double undamped = order; ///< the order without dampers
};

Eigen::Matrix3Xd endOf(const SpringNet& net, const Loads& loads, const std::string& solver, double step,
                       double time)
{
  Simulation simulation = simulate(net, loads, fixedSteps(solver, step));
  advanceWell(simulation, time);
  return simulation.state().position;
}

/// log2 of the ratio of two errors, at h/4 and h/8, against rk4 at h/64.
double observedOrder(const SpringNet& net, const Loads& loads, const Case& c, double time)
{
  const Eigen::Matrix3Xd exact = endOf(net, loads, "rk4", c.step / 64, time);
  const double coarse = (endOf(net, loads, c.solver, c.step / 4, time) - exact).norm();
  const double fine = (endOf(net, loads, c.solver, c.step / 8, time) - exact).norm();
  EXPECT_GT(fine, 1e-13) << "the error must stand above rounding to be measured";
  return std::log2(coarse / fine);
}

/// Of every method the order that it claims; where 4e-3 s does not suit it, with another step. Not of `leapfrog`,
/// whose order is one with dampers and two without.
std::vector<Case> cases()
{
  std::vector<Case> all;
  for (const std::string& solver : accurateMethods()) {
    const auto claimed = static_cast<double>(makeIntegrator(solver)->order());
    if (solver == "stoermer3")
      all.push_back({solver, 2, 4e-3, claimed});
    else if (solver == "rk4" || solver == "implicit")
      all.push_back({solver, claimed, 8e-3});
    else if (solver == "dopri5")
      all.push_back({solver, claimed, 6.5e-3});
    else if (solver != "leapfrog")
      all.push_back({solver, claimed});
  }
  return all;
}

class Convergence : public ::testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(Solvers, Convergence, ::testing::ValuesIn(cases()),
                         [](const auto& solver) { return testName(solver.param.solver); });

SpringNet movingNet(SpringLaw law)
{
  SpringNet net = randomNet(21, 10, law);
  net.initialVelocity = Eigen::Matrix3Xd::Zero(3, 10);
  net.initialVelocity(0, 3) = 1.0;
  net.fixed[0] = 1;
  return net;
}

} // namespace

TEST_P(Convergence, UndampedLinearNet)
{
  SpringNet net = movingNet(SpringLaw::Linear);
  net.viscosity.setZero();
  EXPECT_NEAR(observedOrder(net, {}, GetParam(), 0.25), GetParam().undamped, 0.25);
}

TEST_P(Convergence, DampedNet)
{
  SpringNet net = movingNet(SpringLaw::Linear);
  net.viscosity *= 3.0;
  net.massDamping = Eigen::ArrayXd::Constant(10, 2.0);
  EXPECT_NEAR(observedOrder(net, {}, GetParam(), 0.25), GetParam().order, 0.25);
}

TEST_P(Convergence, NonlinearDampedNet)
{
  EXPECT_NEAR(observedOrder(movingNet(SpringLaw::Exponential), {}, GetParam(), 0.25), GetParam().order, 0.25);
  EXPECT_NEAR(observedOrder(movingNet(SpringLaw::Cubic), {}, GetParam(), 0.25), GetParam().order, 0.25);
}

// Corners of a force curve, a motion with corner and release, at times that are no multiples of the step: the
// order stays only if steps end exactly there.
TEST_P(Convergence, LoadsWithCornersAndARelease)
{
  SpringNet net = movingNet(SpringLaw::Linear);
  Loads loads;
  loads.gravity = {0, 0, -9.81};
  VectorCurve force;
  force.time = {0.03, 0.0517, 0.11};
  force.value.resize(3, 3);
  force.value << 0, 4, -2, 0, 1, 0, 0, 0, 3;
  loads.forces.push_back({{4, 5}, force});
  VectorCurve displacement;
  displacement.time = {0.0, 0.041, 0.2};
  displacement.value.resize(3, 3);
  displacement.value << 0, 0.05, -0.1, 0, 0.02, 0, 0, 0, 0;
  loads.motions.push_back({{7}, displacement, 0.1371});
  // Between events the number of steps is rounded up, so a halved step is not quite half: 0.4 is allowed.
  EXPECT_NEAR(observedOrder(net, loads, GetParam(), 0.25), GetParam().order, 0.4);
}

// Energy bookkeeping is of second order too, at least: the balance's drift shrinks by 4 per halving. Where
// stages repeat the viscous forces, heat is summed from the first of them, to first order.
TEST_P(Convergence, EnergyBalance)
{
  SpringNet net = movingNet(SpringLaw::Exponential);
  Loads loads;
  VectorCurve force;
  force.time = {0.0, 0.1};
  force.value = Eigen::Matrix3Xd::Zero(3, 2);
  force.value(1, 1) = 5.0;
  loads.forces.push_back({{2}, force});
  const auto drift = [&](double step) {
    Simulation simulation = simulate(net, loads, fixedSteps(GetParam().solver, step));
    const double before = balance(simulation);
    advanceWell(simulation, 0.25);
    return std::abs(balance(simulation) - before);
  };
  const std::string& solver = GetParam().solver;
  const double order = solver == "chebyshev" || solver == "stoermer3" ? 1.0 : 2.0;
  EXPECT_GT(std::log2(drift(GetParam().step / 2) / drift(GetParam().step / 8)) / 2.0, order - 0.4);
}

} // namespace esm::test
