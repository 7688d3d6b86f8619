// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// Parts of a net that nothing joins move as each would alone: the same bits, whatever lies beside them.
#include "core/net/net_builder.h"
#include "core/net/net_islands.h"
#include "tests/core/dynamics/skip_nets.h"
#include "tests/support/side_by_side.h"

#include <array>
#include <string>

namespace esm::test {
namespace {

constexpr double kStretch = 1.0 / 60.0;

/// A sheet on a bed, with nodes of its own that a force and a motion take hold of.
struct Organ {
  SpringNet net;
  Loads loads;
};

Organ organ(Index n, double stiffness, double delay)
{
  Organ organ;
  organ.net = beddedSheet(n);
  organ.net.stiffness *= stiffness;
  organ.net.viscosity *= stiffness;
  organ.loads.gravity = {0, 0, -1.0};
  Eigen::Matrix3Xd push(3, 3);
  push.setZero();
  push(2, 1) = 0.02;
  organ.loads.forces.push_back({{n + 1, n + 2}, curve({delay, delay + 0.05, delay + 0.1}, push)});
  Eigen::Matrix3Xd lift = Eigen::Matrix3Xd::Zero(3, 2);
  lift(0, 1) = 0.001;
  organ.loads.motions.push_back({{0}, curve({0.0, 0.2}, lift), 0.4 + delay});
  return organ;
}

Scene sceneOf(const Organ& a, const Organ& b)
{
  return sideBySide({{a.net, a.loads}, {b.net, b.loads}});
}

void expectSame(const Simulation& whole, const std::vector<Index>& places, const Simulation& alone)
{
  ASSERT_EQ(static_cast<Index>(places.size()), alone.net().nodeCount());
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto node = static_cast<Eigen::Index>(i);
    ASSERT_EQ(whole.state().position.col(places[i]), alone.state().position.col(node)) << "node " << i;
    ASSERT_EQ(whole.state().velocity.col(places[i]), alone.state().velocity.col(node)) << "node " << i;
  }
}

TEST(Islands, AreThePartsThatNothingJoins)
{
  SpringNet net = chain(9);
  net.stiffness.setConstant(1.0);
  const Scene scene = sideBySide({{net, {}}, {chain(4), {}}});
  SpringNet all = scene.net;
  addNode(all, {5, 5, 5});
  addNode(all, {6, 5, 5});
  const std::vector<NetIsland> islands = findIslands(all, 10);
  ASSERT_EQ(islands.size(), 3U); // the lone nodes are one
  EXPECT_EQ(islands[0].nodes, scene.nodes[0]);
  EXPECT_EQ(islands[1].nodes, scene.nodes[1]);
  EXPECT_EQ(islands[2].nodes, (std::vector<Index>{13, 14}));
  EXPECT_EQ(islands[0].springs.size(), 8U);
  EXPECT_TRUE(islands[2].springs.empty());
  const std::vector<NetIsland> two = findIslands(all, 2); // the smallest are put together
  ASSERT_EQ(two.size(), 2U);
  EXPECT_EQ(two[0].nodes, scene.nodes[0]);
  EXPECT_EQ(two[1].nodes.size(), 6U);
  EXPECT_EQ(findIslands(all, 1).front().nodes.size(), 15U);
}

TEST(Islands, OfAPressureAreOne)
{
  SpringNet net = sideBySide({{chain(3), {}}, {chain(3), {}}}).net;
  PressureBody body;
  body.triangles.resize(3, 4); // two nodes of either chain
  body.triangles << 0, 0, 0, 1, 1, 2, 3, 2, 2, 3, 1, 3;
  body.bulkModulus = 1.0;
  net.pressure = {body};
  EXPECT_EQ(findIslands(net, 10).size(), 1U);
}

TEST(Islands, IslandsMakeTheWholeAgain)
{
  const Organ a = organ(6, 1.0, 0.0), b = organ(4, 2.0, 0.1);
  const Scene scene = sceneOf(a, b);
  const std::vector<NetIsland> islands = findIslands(scene.net, 10);
  ASSERT_EQ(islands.size(), 2U);
  for (std::size_t k = 0; k < 2; ++k) {
    const SpringNet part = islandNet(scene.net, islands[k]);
    const SpringNet& own = k == 0 ? a.net : b.net;
    EXPECT_TRUE(checkNet(part));
    EXPECT_EQ(part.restPosition, own.restPosition);
    EXPECT_EQ(part.ends, own.ends);
    EXPECT_TRUE((part.stiffness == own.stiffness).all());
    EXPECT_EQ(part.anchors.node, own.anchors.node);
    EXPECT_EQ(part.anchors.point, own.anchors.point);
  }
}

struct Case {
  const char* solver;
  double tolerance;
  int threads;
};

class AsAlone : public testing::TestWithParam<Case> {};

// With loads, tools that come, move and go, other parameters, sleep and reset.
TEST_P(AsAlone, TwoNetsMoveAsEachByItself)
{
  const Organ organs[] = {organ(24, 1.0, 0.0), organ(21, 3.0, 0.3)};
  const Scene scene = sceneOf(organs[0], organs[1]);
  SolverSettings settings = settingsOf(GetParam().tolerance, true, GetParam().solver);
  settings.threads = GetParam().threads;
  Simulation whole = simulate(scene.net, scene.loads, settings);
  EXPECT_EQ(whole.islandCount(), 2U);
  settings.threads = 1;
  std::array<Simulation, 2> alone = {simulate(organs[0].net, organs[0].loads, settings),
                                     simulate(organs[1].net, organs[1].loads, settings)};
  bool haveSlept = false;
  for (int frame = 0; frame < 150; ++frame) {
    if (frame == 60 || frame == 63 || frame == 66) { // one tool on either, then on one, then none
      std::vector<ToolSpring> all;
      for (std::size_t k = 0; k < 2; ++k) {
        std::vector<ToolSpring> own;
        if (frame == 60 || (frame == 63 && k == 1))
          own.push_back(pull(organs[k].net, static_cast<Index>(30 + k), {0, 0, 0.002}, 5.0));
        alone[k].setTools(own);
        for (ToolSpring tool : own) {
          tool.node = scene.nodes[k][static_cast<std::size_t>(tool.node)];
          all.push_back(tool);
        }
      }
      whole.setTools(all);
      for (std::size_t i = 0; i < all.size(); ++i)
        EXPECT_EQ(whole.toolForce(i), alone[all.size() == 1 ? 1 : i].toolForce(0));
    }
    if (frame == 75) { // the second organ hardens here and there, its masses and its bed change
      SpringNet changed = scene.net, own = organs[1].net;
      ParameterPatch patch, ownPatch;
      for (Index s = 5; s < 40; s += 3)
        ownPatch.springs.push_back({s, own.law[0], 60.0, 0.4, own.lawParameter[s]});
      for (Index i = 2; i < 9; i += 2) ownPatch.nodes.push_back({i, 1.5 * own.mass[i], 0.0});
      for (Index k = 0; k < own.anchors.count(); k += 5) ownPatch.anchors.push_back({k, 3.0, 0.2});
      patch = ownPatch;
      for (ParameterPatch::Spring& spring : patch.springs)
        spring.spring = scene.springs[1][static_cast<std::size_t>(spring.spring)];
      for (ParameterPatch::Node& node : patch.nodes)
        node.node = scene.nodes[1][static_cast<std::size_t>(node.node)];
      for (ParameterPatch::Anchor& anchor : patch.anchors) anchor.anchor += organs[0].net.anchors.count();
      const auto change = whole.setParameters(patch), ownChange = alone[1].setParameters(ownPatch);
      ASSERT_TRUE(change && ownChange);
      EXPECT_EQ(change->nodes.size(), ownChange->nodes.size());
      EXPECT_EQ(change->springs.size(), ownChange->springs.size());
      EXPECT_EQ(change->energies.elastic, ownChange->energies.elastic);
      EXPECT_TRUE((whole.net().stiffness(scene.springs[1]) == alone[1].net().stiffness).all());
    }
    if (frame == 90) { // all numbers anew: the first organ's are what they were
      SpringNet own = alone[1].net(), all = whole.net();
      own.viscosity *= 2.0;
      all.viscosity(scene.springs[1]) = own.viscosity;
      ASSERT_TRUE(whole.setParameters(all));
      ASSERT_TRUE(alone[1].setParameters(own));
      ASSERT_TRUE(alone[0].setParameters(SpringNet(alone[0].net())));
    }
    if (frame == 120)
      for (Simulation* each : {&whole, &alone[0], &alone[1]}) each->reset();
    const StepReport report = whole.advance(kStretch);
    std::int64_t springs = 0, awake = 0;
    for (Simulation& each : alone) {
      const StepReport own = each.advance(kStretch);
      springs += own.springsEvaluated;
      awake += own.nodesAwake;
      haveSlept = haveSlept || own.nodesAwake < each.net().nodeCount();
    }
    EXPECT_EQ(report.springsEvaluated, springs);
    EXPECT_EQ(report.nodesAwake, awake);
    for (std::size_t k = 0; k < 2; ++k) expectSame(whole, scene.nodes[k], alone[k]);
    ASSERT_FALSE(HasFatalFailure()) << "frame " << frame;
  }
  EXPECT_TRUE(haveSlept || settings.solver != "auto");
  const EnergyReport energies = whole.energyReport(), first = alone[0].energyReport(),
                     second = alone[1].energyReport();
  EXPECT_NEAR(energies.heat, first.heat + second.heat, 1e-15 * energies.heat);
  EXPECT_NEAR(energies.work, first.work + second.work, 1e-15 * std::abs(energies.work));
  EXPECT_EQ(whole.reaction(scene.nodes[1][0]), alone[1].reaction(0));
  Eigen::ArrayXd tension(scene.net.springCount()), own(organs[1].net.springCount());
  whole.springTensions(tension);
  alone[1].springTensions(own);
  EXPECT_TRUE((tension(scene.springs[1]) == own).all());
  EXPECT_EQ(whole.stableStep(), std::min(alone[0].stableStep(), alone[1].stableStep()));
}

INSTANTIATE_TEST_SUITE_P(Islands, AsAlone,
                         testing::Values(Case{"auto", 1e-3, 1}, Case{"auto", 1e-1, 1}, Case{"auto", 1e-3, 2},
                                         Case{"block-descent", 1e-2, 3}, Case{"implicit", 1e-1, 2}),
                         [](const auto& tried) {
                           std::string name = std::string(tried.param.solver) + std::to_string(tried.index);
                           std::erase(name, '-');
                           return name;
                         });

// The error is of each island's own displacement: what moves a thousandth beside what moves much is no less exact.
TEST(Islands, ASmallMotionBesideALargeOneKeepsItsTolerance)
{
  Organ large = organ(24, 1.0, 0.0), small = organ(8, 1.0, 0.0);
  large.loads.gravity.setZero();
  small.loads = large.loads;
  large.loads.forces[0].force.value *= 10.0;
  small.loads.forces[0] = {{9, 10}, large.loads.forces[0].force};
  small.loads.forces[0].force.value *= 1e-3;
  small.loads.motions.clear();
  const Scene scene = sceneOf(large, small);
  constexpr double kTolerance = 1e-2;
  Simulation simulation = simulate(scene.net, scene.loads, settingsOf(kTolerance, true));
  Simulation reference = simulate(small.net, small.loads, settingsOf(1e-6, true));
  double error = 0.0, motion = 0.0;
  for (int frame = 0; frame < 60; ++frame) {
    simulation.advance(kStretch);
    reference.advance(kStretch);
    const Eigen::Matrix3Xd moved = reference.state().position - small.net.restPosition;
    error = std::max(
      error, (simulation.state().position(Eigen::all, scene.nodes[1]) - reference.state().position).norm());
    motion = std::max(motion, moved.norm());
  }
  EXPECT_GT(motion, 0.0);
  EXPECT_LE(error, kTolerance * motion);
}

// What lies beside costs nothing while it rests.
TEST(Islands, WhatRestsBesideCostsNothing)
{
  Organ still = organ(24, 1.0, 0.0), moving = organ(8, 1.0, 0.0);
  still.loads = {};
  moving.loads.gravity.setZero();
  const Scene scene = sceneOf(still, moving);
  Simulation whole = simulate(scene.net, scene.loads, settingsOf(1e-3, true));
  Simulation alone = simulate(moving.net, moving.loads, settingsOf(1e-3, true));
  for (int frame = 0; frame < 40; ++frame)
    EXPECT_EQ(whole.advance(kStretch).springsEvaluated, alone.advance(kStretch).springsEvaluated);
}

// Who is broken off anywhere goes on from there: no part is lost, and all come to the same time again.
TEST(Islands, OnesThatWereBrokenOffCatchUp)
{
  const Organ a = organ(20, 1.0, 0.0), b = organ(21, 3.0, 0.05);
  for (const int threads : {1, 2}) {
    const Scene scene = sceneOf(a, b);
    SolverSettings settings = settingsOf(1e-2, true);
    settings.threads = threads;
    Simulation whole = simulate(scene.net, scene.loads, settings);
    Simulation smooth = simulate(scene.net, scene.loads, settings);
    int broken = 0, asked = 0;
    while (whole.state().time < 0.15) {
      const double before = whole.state().time;
      const StepReport report = whole.advance(kStretch, {0, [&asked] { return ++asked % 7 == 0; }});
      broken += report.interrupted;
      EXPECT_EQ(report.interrupted, report.stepLimit);
      EXPECT_GE(whole.state().time, before);
      EXPECT_DOUBLE_EQ(whole.state().time, before + report.simulatedTime);
      ASSERT_LT(++asked, 100'000);
    }
    EXPECT_GT(broken, 3);
    whole.advance(0.2 - whole.state().time);
    smooth.advance(0.2);
    EXPECT_EQ(whole.state().time, smooth.state().time);
    const double way = (smooth.state().position - scene.net.restPosition).norm();
    EXPECT_LE((whole.state().position - smooth.state().position).norm(), 0.05 * way);
  }
}

// A failure is of the part that has it; the others stay good, and why() names the node of the whole net.
TEST(Islands, NodesAreCalledByTheirPlacesInTheWholeNet)
{
  const Organ soft = organ(8, 1.0, 0.0), stiff = organ(8, 1e4, 0.0);
  const Scene scene = sceneOf(soft, stiff);
  Simulation whole = simulate(scene.net, scene.loads, fixedSteps("leapfrog", 1.0));
  Simulation alone = simulate(stiff.net, stiff.loads, fixedSteps("leapfrog", 1.0));
  EXPECT_EQ(whole.stiffestNode(), scene.nodes[1][static_cast<std::size_t>(alone.stiffestNode())]);
}

} // namespace
} // namespace esm::test
