// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/contact/static_compliance.h"

#include "tests/core/contact/hanging_chain.h"

#include <gtest/gtest.h>

namespace esm {

namespace {

Simulation simulationOf(const SpringNet& net)
{
  auto created = Simulation::create(net, {}, {});
  EXPECT_TRUE(created);
  return std::move(*created);
}

NodeCombination only(Index node)
{
  return {{node}, {1.0}};
}

} // namespace

// Three springs of 100 N/m in a row, one end held: the third node gives 3/100 m/N along them. Inertia over a
// second (0.01 kg/s^2 per node) is all that holds it across, and softens the row by less than a thousandth.
TEST(StaticCompliance, SpringsInARowAddTheirCompliances)
{
  const Simulation simulation = simulationOf(chain(4));
  StaticCompliance compliance;
  NodeLinks links;
  const Eigen::Matrix3d c = compliance.at(simulation, only(3), links);
  EXPECT_NEAR(c(0, 0), 0.03, 0.03 * 1e-3);
  EXPECT_GT(c(1, 1), 1.0);
  EXPECT_NEAR(c(0, 1), 0.0, 1e-12);
}

TEST(StaticCompliance, AHeldNodeDoesNotGiveWay)
{
  const Simulation simulation = simulationOf(chain(4));
  StaticCompliance compliance;
  NodeLinks links;
  EXPECT_TRUE(compliance.at(simulation, only(0), links).isZero(0.0));
}

// The middle of a spring between nodes that give 1/100 and 2/100 m/N: a unit force there is half a newton on
// each, which moves them by 1/100 and 1.5/100 m, the middle by 1.25/100 m.
TEST(StaticCompliance, APointBetweenNodesMovesByTheirMean)
{
  const Simulation simulation = simulationOf(chain(3));
  StaticCompliance compliance;
  NodeLinks links;
  const Eigen::Matrix3d c = compliance.at(simulation, {{1, 2}, {0.5, 0.5}}, links);
  EXPECT_NEAR(c(0, 0), 0.0125, 0.0125 * 1e-3);
}

// What it says is what the motion comes to: a tool spring pulls the end of a chain, and once at rest force
// over way of the node is 1/C.
TEST(StaticCompliance, AgreesWithTheNetAtRestUnderAPull)
{
  SpringNet net = chain(5);
  net.massDamping.setConstant(5, 5.0);
  Simulation simulation = simulationOf(net);
  StaticCompliance compliance;
  NodeLinks links;
  const double c = compliance.at(simulation, only(4), links)(0, 0);
  const ToolSpring tool{4, net.restPosition.col(4) + Eigen::Vector3d(0.004, 0.0, 0.0),
                        Eigen::Vector3d::Zero(), 50.0, 0.0};
  simulation.setTools({&tool, 1});
  for (int i = 0; i < 600; ++i) simulation.advance(1.0 / 60.0);
  const double way = simulation.state().position(0, 4) - net.restPosition(0, 4);
  EXPECT_NEAR(way / simulation.toolForce(0).x(), c, 2e-3 * c); // tolerance of the solver and inertia's share
}

// 40 x 100 nodes: more than kMostNodes. The far half is held instead of free, which a point in the middle of
// a sheet that is tied to its place hardly notices.
TEST(StaticCompliance, LargeNetsAnswerFromTheNeighbourhood)
{
  constexpr Index kColumns = 100, kRows = 40, kNodes = kColumns * kRows;
  static_assert(kNodes > StaticCompliance::kMostNodes);
  SpringNet net;
  std::vector<std::pair<Index, Index>> ends;
  for (Index y = 0; y < kRows; ++y)
    for (Index x = 0; x < kColumns; ++x) {
      if (x + 1 < kColumns) ends.emplace_back(y * kColumns + x, y * kColumns + x + 1);
      if (y + 1 < kRows) ends.emplace_back(y * kColumns + x, (y + 1) * kColumns + x);
    }
  resizeNet(net, kNodes, static_cast<Index>(ends.size()));
  for (Index i = 0; i < kNodes; ++i)
    net.restPosition.col(i) = Eigen::Vector3d(0.01 * (i % kColumns), 0.01 * (i / kColumns), 0.0);
  for (Index s = 0; s < net.springCount(); ++s)
    net.ends.col(s) << ends[static_cast<std::size_t>(s)].first, ends[static_cast<std::size_t>(s)].second;
  net.restLength.setConstant(0.01);
  net.stiffness.setConstant(100.0);
  net.viscosity.setConstant(0.1);
  net.mass.setConstant(0.001);
  net.anchors.point = net.restPosition;
  net.anchors.stiffness.setConstant(kNodes, 2.0);
  net.anchors.viscosity.setConstant(kNodes, 0.01);
  for (Index i = 0; i < kNodes; ++i) net.anchors.node.push_back(i);

  // The same answer from the whole, by a sheet of its middle that is small enough.
  const Simulation simulation = simulationOf(net);
  StaticCompliance compliance;
  NodeLinks links;
  const Index middle = 20 * kColumns + 50;
  const Eigen::Matrix3d c = compliance.at(simulation, only(middle), links);
  // Along x the row answers nearly alone: a chain of 100 N/m on anchors of 2 N/m gives 1/(2 sqrt(k a +
  // a^2/4)).
  const double row = 1.0 / (2.0 * std::sqrt(100.0 * 2.0 + 1.0));
  EXPECT_NEAR(c(0, 0), row, 0.02 * row);
  EXPECT_EQ(c, compliance.at(simulation, only(middle), links));
}

} // namespace esm
