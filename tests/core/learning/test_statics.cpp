// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/learning/statics.h"

#include "tests/core/learning/blocks.h"
#include "tests/support/nets.h"

#include <gmock/gmock.h>

#include <cmath>

namespace {

using namespace esm;
using namespace esm::test;
using learning::StaticAnswer;
using learning::Statics;
using learning::StaticsLimits;
using learning::StaticsOutcome;

/// Tension of a spring by the formulas of SpringLaw, told once more.
double tension(const SpringNet& net, Index s, double length)
{
  const double k = net.stiffness[s], rest = net.restLength[s], e = length - rest, p = net.lawParameter[s];
  switch (net.law[at(s)]) {
  case SpringLaw::Linear:
    return k * e;
  case SpringLaw::Cubic:
    return k * e * (1.0 + p * (e / rest) * (e / rest));
  case SpringLaw::Exponential:
    return k * rest / p * std::expm1(p * e / rest);
  case SpringLaw::Table: {
    const ForceTable& table = net.tables[at(static_cast<Index>(p))];
    std::size_t line = 0;
    while (line + 2 < table.strain.size() && e / rest >= table.strain[line + 1]) ++line;
    const double slope =
      (table.force[line + 1] - table.force[line]) / (table.strain[line + 1] - table.strain[line]);
    return k * rest * (table.force[line] + slope * (e / rest - table.strain[line]));
  }
  }
  return 0.0;
}

/// Norm of the forces on free nodes over the norm of the sizes of what pulls at them.
double imbalance(const SpringNet& net, const Loads& loads, const NodeArray& x)
{
  Eigen::Matrix3Xd force = Eigen::Matrix3Xd::Zero(3, net.nodeCount());
  Eigen::ArrayXd pull = Eigen::ArrayXd::Zero(net.nodeCount());
  const auto add = [&](Index node, const Eigen::Vector3d& f) {
    force.col(node) += f;
    pull[node] += f.norm();
  };
  for (Index s = 0; s < net.springCount(); ++s) {
    const Index a = net.ends(0, s), b = net.ends(1, s);
    const Eigen::Vector3d d = toVector(x[at(b)] - x[at(a)]);
    const Eigen::Vector3d f = tension(net, s, d.norm()) * d.normalized();
    add(a, f);
    add(b, -f);
  }
  for (Index i = 0; i < net.anchors.count(); ++i) {
    const Index node = net.anchors.node[at(i)];
    add(node, net.anchors.stiffness[i] * (net.anchors.point.col(i) - toVector(x[at(node)])));
  }
  for (const NodalForce& load : loads.forces)
    for (const Index node : load.nodes) add(node, load.force.at(0.0));
  for (Index i = 0; i < net.nodeCount(); ++i) add(i, net.mass[i] * loads.gravity);
  double left = 0.0, all = 0.0;
  for (Index i = 0; i < net.nodeCount(); ++i)
    if (net.fixed[at(i)] == 0) {
      left += force.col(i).squaredNorm();
      all += pull[i] * pull[i];
    }
  return std::sqrt(left / all);
}

// A mass on a spring: L + m g / k. Ten rounding errors of a length of 1 m are allowed.
TEST(Statics, AHangingMassStretchesItsSpringByItsWeightOverTheStiffness)
{
  SpringNet net = chain(2, 1.0, 40.0);
  net.fixed[0] = 1;
  Loads loads;
  loads.gravity = {2.5, 0.0, 0.0};
  Statics statics(net, loads);
  const StaticAnswer answer = statics.solve();
  ASSERT_EQ(answer.outcome, StaticsOutcome::Balanced);
  EXPECT_NEAR(statics.place()[1][0], 1.0 + 2.5 / 40.0, 2e-15);
  EXPECT_NEAR(answer.farthest, 2.5 / 40.0, 2e-15);
}

// 1e-12 is what is promised; another sum over the same forces may differ by their rounding, and does by less.
TEST(Statics, ForcesOfEveryLawCancelToTwelveDigits)
{
  for (const SpringLaw law :
       {SpringLaw::Linear, SpringLaw::Cubic, SpringLaw::Exponential, SpringLaw::Table}) {
    SpringNet net = unevenBlock({}, law, 7);
    addAnchor(net, 60, {0.02, 0.0, 0.05}, 3.0);
    Loads loads;
    loads.gravity = {0.0, 0.0, -9.81};
    loads.forces = {sharedForce(nodesNear(net, {0.02, 0.015, 0.03}, 0.012), {0.15, 0.05, -0.3})};
    Statics statics(net, loads);
    const StaticAnswer answer = statics.solve();
    ASSERT_EQ(answer.outcome, StaticsOutcome::Balanced) << static_cast<int>(law);
    EXPECT_LE(imbalance(net, loads, statics.place()), 2e-12) << static_cast<int>(law);
    EXPECT_GT(answer.farthest, 4e-4) << "the load must bend the block, or nothing is tested";
    EXPECT_EQ(answer.negativePivots, 0);
  }
}

TEST(Statics, AWarmStartTakesFewerSteps)
{
  SpringNet net = unevenBlock({}, SpringLaw::Exponential, 3);
  Loads loads;
  loads.forces = {sharedForce(nodesNear(net, {0.02, 0.015, 0.03}, 0.012), {0.3, 0.0, -0.2})};
  Statics statics(net, loads);
  const StaticAnswer cold = statics.solve();
  ASSERT_EQ(cold.outcome, StaticsOutcome::Balanced);
  net.stiffness *= 1.001;
  statics.setParameters(net);
  const StaticAnswer warm = statics.solve();
  ASSERT_EQ(warm.outcome, StaticsOutcome::Balanced);
  EXPECT_LT(warm.steps, cold.steps);
  Statics fresh(net, loads);
  ASSERT_EQ(fresh.solve().outcome, StaticsOutcome::Balanced);
  // Both have 1e-12 of their forces left, which the stiffness turns into less than that of the size.
  EXPECT_LE(std::sqrt(sumOfSquares(fresh.place(), statics.place())), 1e-12);
}

TEST(Statics, PrescribedNodesStandWhereTheLoadsHaveThem)
{
  SpringNet net = chain(3, 1.0, 10.0);
  net.fixed[0] = 1;
  Loads loads;
  PrescribedMotion pull;
  pull.nodes = {2};
  pull.displacement.time = {0.0, 2.0};
  pull.displacement.value = Eigen::Matrix3Xd::Zero(3, 2);
  pull.displacement.value(0, 1) = 1.0;
  loads.motions = {pull};
  Statics statics(net, loads, 1.0); // half of the way
  ASSERT_EQ(statics.solve().outcome, StaticsOutcome::Balanced);
  EXPECT_EQ(statics.place()[2][0], 2.5);
  EXPECT_NEAR(statics.place()[1][0], 1.25, 1e-15); // equal springs share it
}

/// Four bars that meet at a low top (von Mises' truss, held sideways): under a load beyond the limit, it snaps through.
TEST(Statics, ATrussBeyondItsLimitHasSnapped)
{
  SpringNet net;
  addNode(net, {0.0, 0.0, 0.1});
  for (const Eigen::Vector2d& foot : {Eigen::Vector2d(1, 0), {-1, 0}, {0, 1}, {0, -1}})
    addSpring(net, 0, addNode(net, {foot.x(), foot.y(), 0.0}), 1000.0);
  net.fixed = {0, 1, 1, 1, 1};
  const auto under = [&](double force) {
    Loads loads;
    loads.forces = {sharedForce({0}, {0.0, 0.0, -force})};
    Statics statics(net, loads);
    return statics.solve({1e-12, 60, 0.1}); // no further than down to the feet's level
  };
  // The limit is the largest 4 k z (sqrt(1 + h^2) / sqrt(1 + z^2) - 1), about 0.77 k h^3 = 0.77 N.
  EXPECT_EQ(under(0.6).outcome, StaticsOutcome::Balanced);
  EXPECT_EQ(under(0.9).outcome, StaticsOutcome::Snapped);
}

TEST(Statics, NetsThatNothingHoldsAreRefused)
{
  SpringNet net = chain(3);
  EXPECT_FALSE(Statics::check(net, {}));
  net.fixed[0] = 1;
  EXPECT_TRUE(Statics::check(net, {}));
  PressureBody body;
  body.bulkModulus = 1.0;
  net.pressure = {body};
  const Status refused = Statics::check(net, {});
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().detail, testing::HasSubstr("volume"));
}

} // namespace
