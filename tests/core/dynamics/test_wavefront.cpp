// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// The propagation of 1999, node by node from the greatest force outward.
#include "core/dynamics/methods/integrator.h"
#include "core/dynamics/methods/wavefront_order.h"
#include "tests/support/nets.h"
#include "tests/support/physics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

namespace esm::test {
namespace {

/// A sheet hung by its upper corners, strongly damped, so that it comes to rest soon.
SpringNet hangingSheet()
{
  SpringNet net = sheet(6, 0.01, 100.0);
  net.mass.setConstant(1e-3);
  net.viscosity.setConstant(0.05);
  net.massDamping = Eigen::ArrayXd::Constant(36, 20.0);
  net.restLength *= 0.95;
  for (const std::size_t corner : {0u, 5u, 30u, 35u}) net.fixed[corner] = 1;
  return net;
}

struct WaveRun {
  System system;
  MotionState state;
  StepReport report;
};

WaveRun runOf(const SpringNet& net, const Loads& loads, std::unique_ptr<Integrator> method, double h,
              int steps)
{
  WaveRun run{System(net, loads), startOf(net), {}};
  run.system.enter(run.state, true);
  method->prepare(run.system);
  for (int i = 1; i <= steps; ++i)
    EXPECT_EQ(method->step(run.system, run.state, h, i * h, run.report), StepResult::Done);
  return run;
}

Loads weight()
{
  Loads loads;
  loads.gravity = {0, 0, -9.81};
  return loads;
}

double largestDistance(const NodeArray& a, const NodeArray& b)
{
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, dot(a[i] - b[i], a[i] - b[i]));
  return std::sqrt(largest);
}

} // namespace

// Layers: each node stands behind a neighbour, and no node before one that is nearer to the start. What no
// spring reaches comes at the end.
TEST(Wavefront, GoesOutwardLayerByLayer)
{
  SpringNet net = chain(7);
  const Index lonely = addNode(net, {0, 5, 0});
  const System system(net, {});
  WavefrontOrder order;
  order.prepare(system);
  for (const std::size_t start : {2u, 6u}) {
    order.startAt(start);
    ASSERT_EQ(order.nodes().size(), 8u);
    EXPECT_EQ(order.nodes().front(), static_cast<Index>(start));
    EXPECT_EQ(order.nodes().back(), lonely);
    int before = 0;
    for (const Index node : order.nodes().first(7)) {
      const int layer = std::abs(static_cast<int>(node) - static_cast<int>(start));
      EXPECT_GE(layer, before);
      before = layer;
    }
  }
}

// At rest no method's errors in time are left: the shape is the one that Verlet comes to, to the micrometre
// that is left of the motion after two seconds.
TEST(Wavefront, ComesToTheSameRestShape)
{
  const SpringNet net = hangingSheet();
  const WaveRun wave = runOf(net, weight(), makeIntegrator("wavefront"), 5e-4, 4000);
  const WaveRun verlet = runOf(net, weight(), makeIntegrator("verlet"), 5e-4, 4000);
  NodeArray start(wave.state.x.size());
  copyNodes(net.restPosition, start);
  EXPECT_LT(largestDistance(wave.state.x, verlet.state.x), 1e-6);
  EXPECT_GT(largestDistance(wave.state.x, start), 1e-3);
}

// First order: half the step, half the error.
TEST(Wavefront, IsOfFirstOrder)
{
  const SpringNet net = hangingSheet();
  const WaveRun exact = runOf(net, weight(), makeIntegrator("rk4"), 1e-5, 3000);
  const auto error = [&](double h, int steps) {
    return largestDistance(runOf(net, weight(), makeIntegrator("wavefront"), h, steps).state.x,
                           exact.state.x);
  };
  EXPECT_NEAR(std::log2(error(2e-4, 150) / error(5e-5, 600)) / 2.0, 1.0, 0.25);
}

// A blow that changes forces faster than the threshold allows: the propagation starts over with smaller inner
// steps, and the work comes out to a fifth, as first order in time allows.
TEST(Wavefront, StartsOverWhereForcesJump)
{
  SpringNet net = hangingSheet();
  net.viscosity.setZero();
  net.massDamping.resize(0);
  Loads loads = weight();
  VectorCurve blow{{0.0}, Eigen::Matrix3Xd::Zero(3, 1)};
  blow.value(2, 0) = 2.0;
  loads.forces.push_back({{14}, blow});
  const WaveRun wave = runOf(net, loads, makeIntegrator("wavefront"), 2.5e-4, 40);
  EXPECT_GT(wave.report.rejectedSteps, 0);
  const WaveRun exact = runOf(net, loads, makeIntegrator("rk4"), 1e-5, 1000);
  EXPECT_NEAR(wave.state.work, exact.state.work, 0.2 * exact.state.work);
}

// Equal input, equal bits; what blows up is refused with the state of before.
TEST(Wavefront, IsDeterministicAndNeverKeepsInfinity)
{
  const SpringNet net = hangingSheet();
  const WaveRun first = runOf(net, weight(), makeIntegrator("wavefront"), 7e-4, 100);
  const WaveRun second = runOf(net, weight(), makeIntegrator("wavefront"), 7e-4, 100);
  EXPECT_EQ(std::memcmp(first.state.x.data(), second.state.x.data(), first.state.x.size() * sizeof(Lanes)),
            0);
  WaveRun run{System(net, weight()), first.state, {}};
  auto method = makeIntegrator("wavefront");
  method->prepare(run.system);
  StepResult result = StepResult::Done;
  for (int i = 0; i < 2000 && result == StepResult::Done; ++i) {
    result = method->step(run.system, run.state, 1.0, run.state.time + 1.0, run.report);
    for (const Lanes& x : run.state.x) ASSERT_TRUE(std::isfinite(sumLanes(x)));
  }
  EXPECT_EQ(result, StepResult::NonFinite);
}

} // namespace esm::test
