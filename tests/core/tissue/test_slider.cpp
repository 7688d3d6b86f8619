// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// A slider from end to end: from the word to the springs that move. Counted work, no time.
#include "core/contact/node_hold.h"
#include "core/contact/tool_grip.h"
#include "core/dynamics/simulation.h"
#include "core/tissue/tissue_derivation.h"
#include "tests/core/tissue/test_nets.h"

#include <algorithm>

namespace esm {
namespace {

/// An organ of so many rings of 100 nodes, a quarter of a millimetre apart: three springs a node.
SpringNet organOf(Index rings)
{
  return test::netOf(test::tubeMesh(rings, 100, 0.00025, 0.004));
}

/// What the moves of one slider cost.
struct Work {
  Index springs = 0, touched = 0;
  std::int64_t derivationSaw = 0, engineSaw = 0, firstSaw = 0, awake = 0;
  std::size_t bytesSent = 0;
};

Work moveSlider(Index rings)
{
  SpringNet net = organOf(rings);
  TissueModel model = defaultTissue();
  Region region; // over 2 % of a hundred thousand springs
  region.ellipsoid.centre = {0.02, 0, 0};
  region.ellipsoid.semiAxes = {0.00085, 0.02, 0.02};
  region.inputs = model.inputs;
  model.regions.push_back(region);
  auto derivation = TissueDerivation::create(model, net);
  SolverSettings settings;
  settings.tolerance = 1e-2;
  auto simulation = Simulation::create(net, {}, settings);
  Work work;
  work.springs = net.springCount();
  if (!derivation || !simulation) return work;
  for (int move = 0; move < 4; ++move) {
    model.regions[0].inputs[0] = 0.6 + 0.05 * move;
    ParameterPatch patch;
    const auto report = derivation->update(model, net, &patch);
    const auto change = simulation->setParameters(patch);
    if (!report || !change) return {};
    work.touched = static_cast<Index>(patch.springs.size());
    work.derivationSaw = std::max(work.derivationSaw, report->placesSeen);
    if (move == 0)
      work.firstSaw = change->springsSeen;
    else
      work.engineSaw = std::max(work.engineSaw, change->springsSeen);
    work.bytesSent = std::max(work.bytesSent, patch.springs.size() * sizeof(patch.springs[0]) +
                                                patch.nodes.size() * sizeof(patch.nodes[0]) +
                                                patch.anchors.size() * sizeof(patch.anchors[0]));
    work.awake = std::max(work.awake, simulation->advance(1.0 / 60.0).nodesAwake);
    if (!(simulation->net().stiffness == net.stiffness).all()) ADD_FAILURE() << "the engine missed something";
  }
  return work;
}

} // namespace

// A slider that touches 2 % of a net of 100,000 springs costs by these 2,000: what the derivation looks at, what is
// sent, what the engine looks at, and who wakes. On a net of a third of that size it is the same.
TEST(Slider, CostsByTheSpringsThatItTouches)
{
  const Work large = moveSlider(334), small = moveSlider(112);
  EXPECT_NEAR(large.springs, 100'000, 200);
  EXPECT_NEAR(large.touched, 2'000, 200);
  EXPECT_EQ(large.touched, small.touched);
  EXPECT_EQ(large.derivationSaw, small.derivationSaw);
  EXPECT_LE(large.derivationSaw, 4 * large.touched) << "the region's springs and nodes, before and after";
  EXPECT_EQ(large.engineSaw, small.engineSaw);
  EXPECT_LE(large.engineSaw, 2 * large.touched) << "to see what differs, and to write it";
  EXPECT_LE(large.firstSaw, large.springs + 2 * large.touched) << "once, to know where they are";
  EXPECT_LE(large.bytesSent, 48u * static_cast<std::size_t>(large.touched));
  EXPECT_LE(large.awake, 4'000) << "the region and some layers around it";
}

// What a hand takes its springs from follows a patch as if it had been summed anew.
TEST(Slider, TheHandsHoldFollowsAPatchToTheBit)
{
  SpringNet net = organOf(20);
  TissueModel model = defaultTissue();
  for (const double x : {0.001, 0.003}) {
    Region region;
    region.ellipsoid.centre = {x, 0, 0};
    region.ellipsoid.semiAxes = {0.0007, 0.02, 0.02};
    region.inputs = model.inputs;
    model.regions.push_back(region);
  }
  auto derivation = TissueDerivation::create(model, net);
  ASSERT_TRUE(derivation);
  NodeHolds holds(net);
  NodeLinks links;
  for (int move = 0; move < 8; ++move) {
    model.regions[static_cast<std::size_t>(move % 2)].inputs[0] =
      move < 4 ? 0.95 - 0.05 * move : 0.3 + 0.07 * move;
    ParameterPatch patch;
    SpringNet before = net;
    ASSERT_TRUE(derivation->update(model, net, &patch));
    holds.adapt(net, changeBy(patch, before).nodes, links);
    const NodeHolds anew(net);
    for (Index node = 0; node < net.nodeCount(); ++node) {
      ASSERT_EQ(holds.at(node).stiffness, anew.at(node).stiffness) << "move " << move;
      ASSERT_EQ(holds.at(node).viscosity, anew.at(node).viscosity) << "move " << move;
    }
  }
}

} // namespace esm
