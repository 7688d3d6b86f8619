// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// Walls of random bodies under forces that crush them, tools that jerk, cuts under load: all numbers stay finite and
// no energy comes without work. Limits as in tests/core/dynamics/test_stress_sweep.cpp.
#include "core/structure/support.h"
#include "core/tissue/tissue_model.h"
#include "tests/core/structure/bodies.h"
#include "tests/support/dice.h"
#include "tests/support/stress_run.h"

#include <algorithm>

namespace esm::test {

namespace {

Mesh randomBody(Dice& dice)
{
  switch (dice.below(3)) {
  case 0:
    return tubeMesh(dice.uniform(0.003, 0.02), dice.uniform(0.02, 0.1), 6 + dice.below(8), 4 + dice.below(8));
  case 1:
    return boxMesh({dice.uniform(0.02, 0.05), dice.uniform(0.02, 0.05), dice.uniform(0.02, 0.05)}, 0.01);
  default:
    return organMesh({dice.uniform(0.01, 0.05), dice.uniform(0.01, 0.05), dice.uniform(0.01, 0.05)},
                     3 + dice.below(3));
  }
}

StressCase wallCase(std::uint32_t seed)
{
  Dice dice(seed);
  StressCase story;
  story.net = netOf(randomBody(dice));
  const double size =
    (story.net.restPosition.rowwise().maxCoeff() - story.net.restPosition.rowwise().minCoeff()).minCoeff();
  SupportOptions options;
  options.interior = SupportOptions::Interior::Wall;
  options.wallThickness = size * dice.uniform(0.02, 0.2);
  options.wallLayers = dice.below(4);
  const auto report = addSupport(story.net, options);
  EXPECT_TRUE(report) << seed << ": " << (report ? "" : report.error().detail);
  TissueModel tissue = defaultTissue();
  for (fuzzy::InputValue& input : tissue.inputs) input = dice.uniform(0.0, 1.0);
  EXPECT_TRUE(applyTissue(tissue, story.net)) << seed;
  const Index nodes = story.net.nodeCount();
  for (int i = dice.below(6); i > 0; --i) story.net.fixed[static_cast<std::size_t>(dice.below(nodes))] = 1;
  story.loads.gravity = {0.0, 0.0, dice.uniform(-10.0, 10.0)};
  for (int i = 1 + dice.below(4); i > 0; --i) {
    VectorCurve curve;
    const double force = dice.decades(-2.0, 3.0);
    curve.time = {0.0, 0.02, 0.02, 0.05};
    curve.value.resize(3, 4);
    for (int k = 0; k < 4; ++k) curve.value.col(k) = force * dice.vector(1.0);
    story.loads.forces.push_back({{dice.below(nodes)}, curve});
  }
  ToolSpring tool;
  tool.node = dice.below(nodes);
  tool.target = story.net.restPosition.col(tool.node) + 0.1 * dice.vector(1.0);
  tool.stiffness = dice.decades(0.0, 4.0);
  story.changes.push_back({1, std::vector<ToolSpring>{tool}, {}});
  SpringNet cut = story.net;
  for (Index s = 0; s < cut.springCount(); ++s)
    if (dice.below(4) == 0) cut.stiffness[s] = cut.viscosity[s] = 0.0;
  story.changes.push_back({2, std::vector<ToolSpring>{}, cut});
  return story;
}

} // namespace

TEST(WallStress, StaysBoundedWhateverHappensToIt)
{
  SolverSettings settings;
  settings.tolerance = 1e-2;
  settings.effort = 5e5;
  settings.workLimit = 0.0;
  double growth = 0.0;
  for (std::uint32_t seed = 1; seed <= 100; ++seed) {
    const StressResult result = runStress(wallCase(seed), settings);
    EXPECT_TRUE(result.created && result.finite) << "seed " << seed << ": " << result.why;
    EXPECT_EQ(result.badFrames, 0) << "seed " << seed << ": " << result.why;
    EXPECT_EQ(result.broken, "") << "seed " << seed;
    EXPECT_LE(std::max(result.balance, result.frameGrowth), 0.1) << "seed " << seed << ": " << result.why;
    growth = std::max({growth, result.balance, result.frameGrowth});
  }
  RecordProperty("growth", std::to_string(growth));
}

} // namespace esm::test
