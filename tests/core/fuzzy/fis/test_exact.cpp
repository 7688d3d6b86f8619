// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "tests/core/fuzzy/fis/exact_reference.h"

namespace esm::fis {

// 1e-12 of the range: what double arithmetic allows with a margin of some thousand roundings.
TEST(ExactArea, AgreesWithAnIndependentQuadrature)
{
  const Deviation worst = compare(400, 1);
  EXPECT_GT(worst.centroids, 50);
  EXPECT_GT(worst.bisectors, 50);
  EXPECT_GT(worst.maxima, 100);
}

// By hand: a triangle 0 1 4 clipped at 1/2.
TEST(ExactArea, OfATrapezoidByHand)
{
  System system;
  system.inputs = {{"in", "", true, 0, 1, false, {{"t", Shape::Ramp, {0, 1}, 1.0, {}}}}};
  OutputVariable output;
  output.name = "out";
  output.minimum = 0;
  output.maximum = 4;
  output.terms = {{"t", Shape::Triangle, {0, 1, 4}, 1.0, {}}};
  system.outputs = {output};
  RuleBlock block;
  block.rules = {{{{{Antecedent::Kind::Proposition, {false, 0, 0, {}}, {}}}}, {{true, 0, 0, {}}}, 1.0, true}};
  system.blocks = {block};
  const auto value = [&](Defuzzifier defuzzifier) {
    system.outputs[0].defuzzifier = defuzzifier;
    const auto evaluator = Evaluator::create(system);
    Workspace workspace = evaluator->makeWorkspace();
    evaluator->evaluate(std::array{0.5}, workspace);
    return workspace.outputs()[0].value;
  };
  // Corners 0, 0.5, 2.5, 4 at height 1/2: areas 1/8, 1, 3/8 with middles at 1/3, 3/2, 3.
  EXPECT_NEAR(value(Defuzzifier::Centroid), (1.0 / 24 + 1.5 + 9.0 / 8) / 1.5, 1e-15);
  EXPECT_NEAR(value(Defuzzifier::Bisector), 0.5 + (0.75 - 0.125) / 0.5, 1e-15);
  EXPECT_NEAR(value(Defuzzifier::SmallestOfMaximum), 0.5, 1e-15);
  EXPECT_NEAR(value(Defuzzifier::LargestOfMaximum), 2.5, 1e-15);
  EXPECT_NEAR(value(Defuzzifier::MeanOfMaximum), 1.5, 1e-15);
}

} // namespace esm::fis
