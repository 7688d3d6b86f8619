// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// Whether small errors are multiplied: an exponential, and not what only drifts.
#include "tests/support/dice.h"
#include "tests/support/nets.h"
#include "tests/support/physics.h"

#include <gtest/gtest.h>

namespace esm::test {
namespace {

double growthOf(const SpringNet& net, const Loads& loads, double duration)
{
  SolverSettings settings;
  settings.duration = duration;
  Simulation simulation = simulate(net, loads, settings);
  simulation.watchGrowth();
  for (int frame = 1; frame <= std::lround(60.0 * duration); ++frame)
    advanceWell(simulation, frame / 60.0 - simulation.state().time);
  return simulation.errorGrowth();
}

/// Two nodes of a gram that nothing holds, pressed together by a tenth of their distance.
SpringNet freePair(double k)
{
  SpringNet net = chain(2, 0.09, k);
  net.mass.setConstant(1e-3);
  net.restLength.setConstant(0.1);
  return net;
}

} // namespace

// A pair swings and turns for ever, and two such motions drift apart in proportion to time: in 30 s by
// thousands of times their first difference. That multiplies nothing: the equations of a pair are solved.
TEST(GrowthWatch, DriftOfAFreePairIsNoGrowth)
{
  for (const double k : {0.1, 1.0, 10.0, 100.0})
    for (const double turn : {0.0, 0.02}) {
      SpringNet net = freePair(k);
      net.initialVelocity = Eigen::Matrix3Xd::Zero(3, 2);
      net.initialVelocity.col(0) << 0.0, turn, 0.0;
      EXPECT_LT(growthOf(net, {}, 30.0), 100.0) << k << ", " << turn;
    }
}

// Upside down: three masses above each other, on springs that nothing keeps upright. With w = sqrt(g/l) a
// difference grows by exp(w t), 10^4 within the first second, and more once they tumble.
TEST(GrowthWatch, TumblingMassesMultiplyErrors)
{
  SpringNet net = chain(4, 0.1, 1e3);
  net.mass.setConstant(1e-2);
  net.fixed[0] = 1;
  Loads loads;
  loads.gravity = {-9.81, 1e-3, 0.0}; // along the chain, which stands on its held end
  EXPECT_GT(growthOf(net, loads, 2.0), 100.0);
}

// A star of stiff and viscous springs, many of them pressed: the motion goes by implicit steps, and to follow a difference
// explicitly took hundreds of thousands for each frame.
TEST(GrowthWatch, CostsNoMoreThanTheMotionBears)
{
  SpringNet net;
  Dice dice(5);
  const Index hub = addNode(net, {0, 0, 0});
  for (int leaf = 0; leaf < 100; ++leaf) {
    const Eigen::Vector3d place =
      5.0 * Eigen::Vector3d(dice.uniform(-1, 1), dice.uniform(-1, 1), dice.uniform(-1, 1));
    const Index spring = addSpring(net, hub, addNode(net, place), 1e5, 2e4);
    net.restLength[spring] = place.norm() * dice.uniform(0.0, 2.0);
  }
  net.mass.setConstant(0.0044);
  net.fixed.back() = 1;
  Simulation simulation = simulate(net);
  simulation.watchGrowth();
  std::int64_t springs = 0;
  constexpr int kFrames = 10;
  for (int frame = 0; frame < kFrames; ++frame) springs += simulation.advance(1.0 / 60.0).springsEvaluated;
  const double passes = static_cast<double>(springs) / static_cast<double>(net.springCount());
  const double free = 2e5 / static_cast<double>(net.springCount()) * kFrames;
  EXPECT_LE(simulation.errorGrowthPasses(),
            2.0 * (13.0 * passes + free)); // twice: stages of dampers are counted, too
}

} // namespace esm::test
