// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// Motions whose solution is known in closed form, with every solver.
#include "tests/support/methods.h"
#include "tests/support/nets.h"
#include "tests/support/physics.h"

namespace esm::test {

class ClosedForms : public ::testing::TestWithParam<std::string> {
protected:
  SolverSettings settings(double tolerance) const
  {
    SolverSettings s;
    s.solver = GetParam();
    s.tolerance = tolerance;
    s.workLimit = 0.0; // a method that is named takes the steps that it takes
    return s;
  }
};
INSTANTIATE_TEST_SUITE_P(Solvers, ClosedForms, ::testing::ValuesIn(accurateMethods({"auto"})),
                         [](const auto& solver) { return testName(solver.param); });

namespace {

/// One mass [kg] on an anchor: m x'' + c x' + k x = 0 from x0 at rest.
SpringNet oscillator(double mass, double c, double k, double x0)
{
  SpringNet net;
  addNode(net, {x0, 0, 0});
  net.mass[0] = mass;
  addAnchor(net, 0, {0, 0, 0}, k, c);
  return net;
}

} // namespace

// x = x0 exp(-d t) (cos w t + d/w sin w t), d = c/2m, w^2 = k/m - d^2. Compared over 3 s; the allowance is
// the requested tolerance of the displacement, which is up to 2 x0.
TEST_P(ClosedForms, UnderdampedOscillator)
{
  const double m = 0.5, c = 0.4, k = 80.0, x0 = 0.1, d = c / (2 * m), w = std::sqrt(k / m - d * d);
  Simulation simulation = simulate(oscillator(m, c, k, x0), {}, settings(1e-4));
  for (int frame = 1; frame <= 180; ++frame) {
    advanceWell(simulation, 1.0 / 60.0);
    const double t = simulation.state().time;
    const double x = x0 * std::exp(-d * t) * (std::cos(w * t) + d / w * std::sin(w * t));
    ASSERT_NEAR(simulation.state().position(0, 0), x, 1e-4 * 2 * x0) << "t = " << t;
  }
}

// Two real rates r = -d +- sqrt(d^2 - k/m): x = x0 (r1 exp(r2 t) - r2 exp(r1 t)) / (r1 - r2).
TEST_P(ClosedForms, OverdampedOscillator)
{
  const double m = 0.5, c = 40.0, k = 80.0, x0 = 0.1, d = c / (2 * m), root = std::sqrt(d * d - k / m);
  const double r1 = -d + root, r2 = -d - root;
  Simulation simulation = simulate(oscillator(m, c, k, x0), {}, settings(1e-4));
  for (int frame = 1; frame <= 120; ++frame) {
    advanceWell(simulation, 1.0 / 60.0);
    const double t = simulation.state().time;
    const double x = x0 * (r1 * std::exp(r2 * t) - r2 * std::exp(r1 * t)) / (r1 - r2);
    ASSERT_NEAR(simulation.state().position(0, 0), x, 1e-4 * x0) << "t = " << t;
  }
}

// The centre of mass of two free masses goes straight on and momentum stays: every spring pulls both ends
// with the same bits, so only the sum's rounding is left (Newton's remainder for the implicit solver).
TEST_P(ClosedForms, TwoFreeMassesKeepTheirMomentum)
{
  SpringNet net = chain(2, 1.0, 50.0);
  net.mass << 0.3, 1.7;
  net.viscosity[0] = 0.2;
  net.initialVelocity.resize(3, 2);
  net.initialVelocity << 1.0, -0.5, 2.0, 0.25, 0.0, 3.0;
  Simulation simulation = simulate(net, {}, settings(1e-4));
  const Eigen::Vector3d momentum = simulation.momentum();
  const Eigen::Vector3d centre = net.restPosition * net.mass.matrix() / 2.0;
  const double tolerance = GetParam() == "implicit" ? 1e-4 : 1e-12;
  advanceWell(simulation, 2.0);
  EXPECT_LT((simulation.momentum() - momentum).norm(), tolerance);
  const Eigen::Vector3d moved = simulation.state().position * net.mass.matrix() / 2.0;
  EXPECT_LT((moved - centre - simulation.state().time * momentum / 2.0).norm(), tolerance);
}

// A chain of N masses between walls, longitudinal: mode j has w_j = 2 sqrt(k/m) sin(j pi / (2 (N + 1))) and
// the shape sin(i j pi / (N + 1)). Started in one mode it stays in it. 1e-3 of the amplitude: the tolerance
// is of the displacement from the start, up to twice the amplitude, over one second.
TEST_P(ClosedForms, NormalModesOfAFixedChain)
{
  constexpr Index kInner = 6;
  const double m = 0.02, k = 30.0, amplitude = 1e-3;
  for (const int mode : {1, 3, 6}) {
    SpringNet net = chain(kInner + 2, 0.1, k);
    net.mass.setConstant(m);
    net.fixed.front() = net.fixed.back() = 1;
    const Eigen::Matrix3Xd balance = net.restPosition;
    const auto shape = [&](Index i) { return std::sin(i * mode * std::numbers::pi / (kInner + 1)); };
    for (Index i = 0; i < kInner + 2; ++i) net.restPosition(0, i) += amplitude * shape(i);
    const double w = 2 * std::sqrt(k / m) * std::sin(mode * std::numbers::pi / (2 * (kInner + 1)));
    Simulation simulation = simulate(net, {}, settings(2e-4));
    for (int frame = 0; frame < 30; ++frame) {
      advanceWell(simulation, 1.0 / 60.0);
      const double expected = amplitude * std::cos(w * simulation.state().time);
      for (Index i = 1; i <= kInner; ++i)
        ASSERT_NEAR(simulation.state().position(0, i) - balance(0, i), expected * shape(i), 1e-3 * amplitude)
          << "mode " << mode << " node " << i;
    }
  }
}

// A pendulum of length L released at angle a: T = 4 sqrt(L/g) K(sin(a/2)). The rod is a stiff spring: at m g
// / k = 1e-5 m per metre and up to 3 m g of pull in the swing the period is longer by at most about 2e-5;
// 2e-4 is allowed for that and for finding the crossing.
TEST_P(ClosedForms, PendulumPeriodIsAnEllipticIntegral)
{
  const double length = 1.0, g = 9.81, angle = 2.0, k = 9.81e5;
  SpringNet net;
  addNode(net, {0, 0, 0});
  addNode(net, {length * std::sin(angle), 0, -length * std::cos(angle)});
  net.fixed[0] = 1;
  addSpring(net, 0, 1, k, 200.0); // the damper calms the rod; along the rod nothing else moves
  Loads loads;
  loads.gravity = {0, 0, -g};
  // Where dampers work leapfrog is of first order: 1e-5 would take it ten times as many steps.
  const bool isFirstOrder = GetParam() == "leapfrog";
  Simulation simulation = simulate(net, loads, settings(isFirstOrder ? 1e-4 : 1e-5));
  const double period = 4 * std::sqrt(length / g) * std::comp_ellint_1(std::sin(angle / 2));
  // At T/4 and 3T/4 the bob is below the pivot; find the first crossing of x = 0 by linear interpolation.
  double before = simulation.state().position(0, 1), timeBefore = 0.0, crossing = 0.0;
  while (crossing == 0.0 && simulation.state().time < period) {
    advanceWell(simulation, 1e-3);
    const double x = simulation.state().position(0, 1), t = simulation.state().time;
    if (x <= 0.0) crossing = timeBefore + (t - timeBefore) * before / (before - x);
    before = x;
    timeBefore = t;
  }
  EXPECT_NEAR(4 * crossing / period, 1.0, 2e-4);
}

// N equal masses on N springs: spring i carries the weight of all below it, so the tip hangs
// m g / k N (N + 1) / 2 deeper than without gravity.
TEST_P(ClosedForms, StaticExtensionOfAHangingChain)
{
  constexpr Index kLinks = 8;
  const double m = 0.1, k = 200.0, g = 9.81;
  SpringNet net = chain(kLinks + 1, 0.1, k);
  for (Index i = 0; i <= kLinks; ++i) net.restPosition.col(i) = Eigen::Vector3d(0, 0, -0.1 * i);
  net.mass.setConstant(m);
  net.viscosity.setConstant(3.0);
  net.massDamping = Eigen::ArrayXd::Constant(kLinks + 1, 10.0);
  net.fixed[0] = 1;
  Loads loads;
  loads.gravity = {0, 0, -g};
  Simulation simulation = simulate(net, loads, settings(1e-4));
  advanceWell(simulation, 12.0);
  const double extension = m * g / k * kLinks * (kLinks + 1) / 2.0;
  const double tip = -simulation.state().position(2, kLinks) - 0.1 * kLinks;
  EXPECT_NEAR(tip, extension, 1e-4 * extension);
  // The support carries the whole weight, its own node included.
  EXPECT_NEAR(simulation.reaction(0).z(), (kLinks + 1) * m * g, 1e-3 * m * g);
}

} // namespace esm::test
