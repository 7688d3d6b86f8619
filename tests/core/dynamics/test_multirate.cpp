// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// Springs at their own rates give the motion that one rate for all gives, for less.
#include "core/dynamics/methods/integrator.h"
#include "core/dynamics/methods/multirate_layout.h"
#include "tests/support/nets.h"
#include "tests/support/physics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>

namespace esm::test {
namespace {

struct Trial {
  System system;
  MotionState state;
  StepReport report;
  StepResult result = StepResult::Done;

  double balance() const
  {
    return system.kineticEnergy(state.v) + system.elasticEnergy(state.x) + state.heat - state.work;
  }
};

Trial begin(const SpringNet& net, const Loads& loads = {})
{
  Trial run{System(net, loads), startOf(net), {}};
  run.system.enter(run.state, true);
  return run;
}

/// Equal steps of at most h; between two events of the loads.
void advance(Trial& run, Integrator& method, double h, double duration)
{
  const double last = run.state.time + duration;
  method.prepare(run.system);
  while (run.state.time < last && run.result == StepResult::Done) {
    const double from = run.state.time, event = run.system.nextEvent(from), to = std::min(event, last);
    const int steps = std::max(1, static_cast<int>(std::ceil((to - from) / h * (1.0 - 1e-9))));
    for (int i = 1; i <= steps && run.result == StepResult::Done; ++i) {
      const double end = i == steps ? to : from + (to - from) * i / steps;
      run.result = method.step(run.system, run.state, (to - from) / steps, end, run.report);
    }
    if (run.state.time == event && run.system.enter(run.state, false))
      method.constraintsChanged(run.system);
    else
      method.restart();
  }
}

Trial runOf(const SpringNet& net, const Loads& loads, std::unique_ptr<Integrator> method, double h,
            double duration)
{
  Trial run = begin(net, loads);
  advance(run, *method, h, duration);
  return run;
}

double distance(const NodeArray& a, const NodeArray& b)
{
  double square = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) square += dot(a[i] - b[i], a[i] - b[i]);
  return std::sqrt(square / static_cast<double>(a.size()));
}

bool sameBits(const NodeArray& a, const NodeArray& b)
{
  return std::memcmp(a.data(), b.data(), a.size() * sizeof(Lanes)) == 0;
}

/// A sheet in a frame, its middle thrown sideways, with every 30th spring 1e4 times stiffer.
SpringNet sheetWithFewStiffSprings(double stiffer)
{
  SpringNet net = sheet(10, 0.01, 100.0);
  net.mass.setConstant(1e-4);
  net.viscosity.setConstant(0.01);
  net.restLength *= 0.95;
  for (Index i = 0; i < 10; ++i)
    for (const Index node : {i, 90 + i, 10 * i, 10 * i + 9}) net.fixed[static_cast<std::size_t>(node)] = 1;
  for (Index s = 7; s < net.springCount(); s += 30) {
    net.stiffness[s] *= stiffer;
    net.restLength[s] = (net.restPosition.col(net.ends(0, s)) - net.restPosition.col(net.ends(1, s))).norm();
  }
  net.initialVelocity = Eigen::Matrix3Xd::Zero(3, 100);
  net.initialVelocity(2, 44) = 0.5;
  return net;
}

} // namespace

// Where all springs need the same rate there is nothing to divide: the very bits of Verlet.
TEST(Multirate, IsVerletWhereAllSpringsAreAlike)
{
  const SpringNet net = sheetWithFewStiffSprings(1.0);
  const Trial one = runOf(net, {}, makeIntegrator("verlet"), 1e-4, 0.02),
              many = runOf(net, {}, makeIntegrator("multirate"), 1e-4, 0.02);
  EXPECT_TRUE(sameBits(one.state.x, many.state.x));
  EXPECT_TRUE(sameBits(one.state.v, many.state.v));
}

// A dozen springs 1e4 times stiffer hold Verlet at steps 80 times smaller. Multirate reaches the same motion
// (to 5 % of the displacement, what the phases of its middle modes lose at the largest step) with a tenth of
// the spring evaluations.
TEST(Multirate, AFewStiffSpringsCostLittle)
{
  const SpringNet net = sheetWithFewStiffSprings(1e4);
  auto method = makeIntegrator("multirate");
  Trial many = begin(net);
  method->prepare(many.system);
  advance(many, *method, method->stableStep({}), 0.02);
  const Trial one = runOf(net, {}, makeIntegrator("verlet"), 1e-6, 0.02);
  NodeArray rest(many.state.x.size());
  copyNodes(net.restPosition, rest);
  ASSERT_EQ(many.result, StepResult::Done);
  ASSERT_EQ(one.result, StepResult::Done);
  EXPECT_LT(distance(one.state.x, many.state.x), 0.05 * distance(one.state.x, rest));
  EXPECT_LT(many.system.springsEvaluated, one.system.springsEvaluated / 10);
}

// All rates scale with the base step: halving it twice divides the error by 16. Anchors, mass damping, a
// force with a corner and a driven node with release take part.
TEST(Multirate, IsOfSecondOrder)
{
  SpringNet net = sheetWithFewStiffSprings(1e4);
  addAnchor(net, 33, {0.03, 0.03, 0.01}, 50.0, 0.1);
  net.massDamping = Eigen::ArrayXd::Constant(100, 5.0);
  Loads loads;
  loads.gravity = {0, 0, -9.81};
  VectorCurve force{{0.0, 0.003, 0.007}, Eigen::Matrix3Xd::Zero(3, 3)};
  force.value(1, 1) = 0.05;
  loads.forces.push_back({{25, 26}, force});
  VectorCurve shift{{0.0, 0.004}, Eigen::Matrix3Xd::Zero(3, 2)};
  shift.value(2, 1) = 0.001;
  loads.motions.push_back({{66}, shift, 0.0061});
  const Trial exact = runOf(net, loads, makeIntegrator("rk4"), 5e-7, 0.008);
  const auto error = [&](double h) {
    const Trial run = runOf(net, loads, makeIntegrator("multirate"), h, 0.008);
    EXPECT_EQ(run.result, StepResult::Done);
    EXPECT_NEAR(run.balance(), exact.balance(), 0.02 * exact.state.heat) << h; // quadratures of second order
    return distance(run.state.x, exact.state.x);
  };
  EXPECT_NEAR(std::log2(error(2e-5) / error(5e-6)) / 2.0, 2.0, 0.4);
}

// Equal input, equal bits.
TEST(Multirate, IsDeterministic)
{
  const SpringNet net = sheetWithFewStiffSprings(1e5);
  const Trial first = runOf(net, {}, makeIntegrator("multirate"), 3e-5, 0.01);
  const Trial second = runOf(net, {}, makeIntegrator("multirate"), 3e-5, 0.01);
  EXPECT_TRUE(sameBits(first.state.x, second.state.x));
  EXPECT_TRUE(sameBits(first.state.v, second.state.v));
}

// Masses from 1e-9 to 1e3 kg, stiffness up to 1e9, springs of no length, light nodes with heavy dampers: any
// step is either done, with finite numbers and no great energy from nowhere, or refused with the old state.
TEST(Multirate, IsBoundedOrSaysSo)
{
  int done = 0;
  for (std::uint32_t seed = 0; seed < 600; ++seed) {
    std::mt19937 random(seed);
    const auto decade = [&](double low, double high) {
      return std::pow(10.0, low + (high - low) * (static_cast<double>(random()) / 4294967296.0));
    };
    SpringNet net = randomNet(seed, 10);
    for (Index s = 0; s < net.springCount(); ++s) {
      net.stiffness[s] = decade(-1, seed % 3 ? 4 : 9);
      net.viscosity[s] = seed % 2 ? decade(-4, 2) : 0.0;
    }
    for (Index i = 0; i < net.nodeCount(); ++i) net.mass[i] = seed % 5 ? decade(-4, 0) : decade(-9, 3);
    if (seed % 4 == 0) net.restPosition.col(3) = net.restPosition.col(net.ends(1, 6));
    auto method = makeIntegrator("multirate");
    Trial run = begin(net);
    if (!MultirateLayout::plan(run.system).pays) continue; // plain Verlet
    method->prepare(run.system);
    StepBound bound;
    bound.prepare();
    const FastestMode mode = bound.compute(run.system, run.state.x, run.state.v);
    const double h = std::min(0.9 * method->stableStep(mode), 1e-3), before = run.balance();
    advance(run, *method, h, 20.0 * h);
    for (std::size_t i = 0; i < run.state.x.size(); ++i)
      ASSERT_TRUE(std::isfinite(sumLanes(run.state.x[i] + run.state.v[i]))) << seed;
    if (run.result != StepResult::Done) continue;
    ++done;
    const double mechanical = run.balance() - run.state.heat;
    EXPECT_LT(mechanical, 3.0 * before + 1e-12) << seed; // what one look between may let pass
  }
  EXPECT_GT(done, 100);
}

} // namespace esm::test
