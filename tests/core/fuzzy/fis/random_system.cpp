// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "tests/core/fuzzy/fis/random_system.h"

#include <algorithm>
#include <cmath>

namespace esm::fis {

namespace {

template <class T>
const T& oneOf(Dice& dice, const std::vector<T>& list)
{
  return list[static_cast<std::size_t>(dice.below(static_cast<int>(list.size())))];
}

std::vector<double> rising(Dice& dice, int count, double low, double high)
{
  std::vector<double> numbers;
  for (int i = 0; i < count; ++i) numbers.push_back(dice.number(low, high));
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

std::vector<double> parametersOf(Dice& dice, Shape shape, double low, double high)
{
  const double width = high - low, a = dice.number(low, high), b = dice.number(0.05, 0.4) * width;
  const double sign = dice.chance(0.5) ? 1.0 : -1.0;
  switch (shape) {
  case Shape::Bell:
    return {a, b, dice.number(0.6, 4.0)};
  case Shape::Binary:
    return {a, dice.chance(0.5) ? sign * HUGE_VAL : a + sign * b};
  case Shape::Concave:
    return {a, a + sign * b};
  case Shape::Constant:
    return {a};
  case Shape::Cosine:
  case Shape::Gaussian:
  case Shape::Spike:
    return {a, b};
  case Shape::GaussianProduct: {
    const auto means = rising(dice, 2, low, high);
    return {means[0], b, means[1], dice.number(0.05, 0.4) * width};
  }
  case Shape::Discrete: {
    std::vector<double> xy;
    for (const double x : rising(dice, 4, low, high)) xy.insert(xy.end(), {x, dice.unit()});
    return xy;
  }
  case Shape::PiShape:
  case Shape::Trapezoid:
    return rising(dice, 4, low, high);
  case Shape::Triangle: {
    auto p = rising(dice, 3, low, high);
    if (dice.chance(0.15))
      p[0] = -HUGE_VAL;
    else if (dice.chance(0.15))
      p[2] = HUGE_VAL;
    return p;
  }
  case Shape::Ramp:
    return {a, a + sign * b};
  case Shape::Rectangle:
  case Shape::SShape:
  case Shape::ZShape:
    return rising(dice, 2, low, high);
  case Shape::Sigmoid:
    return {a, sign * dice.number(3.0, 30.0) / width};
  case Shape::SigmoidDifference: {
    const auto means = rising(dice, 2, low, high);
    return {means[0], dice.number(5.0, 40.0) / width, dice.number(5.0, 40.0) / width, means[1]};
  }
  case Shape::SigmoidProduct: {
    const auto means = rising(dice, 2, low, high);
    return {means[0], dice.number(5.0, 40.0) / width, -dice.number(5.0, 40.0) / width, means[1]};
  }
  case Shape::Linear:
    return {dice.number(-2, 2), dice.number(-2, 2), dice.number(-2, 2), dice.number(-2, 2)};
  case Shape::Function:
    break;
  }
  return {};
}

constexpr const char* kFormulas[] = {"2*in1 - in2 + 0.5", "sin(in1) * (in2 + 1)",
                                     "exp(0 - in1^2 / 8) + abs(in2)", "min(in1, in2) + 3 * x",
                                     "in1 / (1 + in2^2) - pow(abs(in1), 1.5)"};

Proposition randomProposition(Dice& dice, const System& system, const Recipe& recipe)
{
  Proposition p;
  p.variable = dice.below(static_cast<int>(system.inputs.size()));
  p.term = dice.below(static_cast<int>(system.inputs[static_cast<std::size_t>(p.variable)].terms.size()));
  for (int i = 0; i < 2 && !recipe.hedges.empty() && dice.chance(0.5); ++i)
    p.hedges.push_back(oneOf(dice, recipe.hedges));
  const auto any = std::find(p.hedges.begin(), p.hedges.end(), Hedge::Any);
  if (any != p.hedges.end()) {
    p.hedges.erase(any + 1, p.hedges.end());
    p.term = -1;
  }
  return p;
}

Rule randomRule(Dice& dice, const System& system, const Recipe& recipe, bool mayChain)
{
  Rule rule;
  using Kind = Antecedent::Kind;
  const int count = 1 + dice.below(3);
  const auto chain = [&] { return dice.chance(0.5) ? Kind::And : Kind::Or; };
  if (count == 1) {
    rule.antecedent.nodes = {{Kind::Proposition, randomProposition(dice, system, recipe), {}}};
  } else if (count == 2 || dice.chance(0.5)) {
    rule.antecedent.nodes.push_back({chain(), {}, {}});
    for (int i = 0; i < count; ++i) {
      rule.antecedent.nodes[0].children.push_back(i + 1);
      rule.antecedent.nodes.push_back({Kind::Proposition, randomProposition(dice, system, recipe), {}});
    }
  } else { // a and (b or c)
    rule.antecedent.nodes = {{Kind::And, {}, {1, 2}},
                             {Kind::Proposition, randomProposition(dice, system, recipe), {}},
                             {Kind::Or, {}, {3, 4}},
                             {Kind::Proposition, randomProposition(dice, system, recipe), {}},
                             {Kind::Proposition, randomProposition(dice, system, recipe), {}}};
  }
  if (mayChain && dice.chance(0.4)) { // what was concluded before
    auto& p = rule.antecedent.nodes.back().proposition;
    p = {true, 0, dice.below(static_cast<int>(system.outputs[0].terms.size())), {}};
  }
  const int conclusions = 1 + (system.outputs.size() > 1 && dice.chance(0.3) ? 1 : 0);
  for (int i = 0; i < conclusions; ++i) {
    const int output = conclusions == 2 ? i
                       : mayChain       ? 1
                                        : dice.below(static_cast<int>(system.outputs.size()));
    Proposition p{true,
                  output,
                  dice.below(static_cast<int>(system.outputs[static_cast<std::size_t>(output)].terms.size())),
                  {}};
    if (recipe.conclusionHedges && dice.chance(0.3))
      p.hedges = {dice.chance(0.5) ? Hedge::Very : Hedge::Somewhat};
    rule.consequents.push_back(std::move(p));
  }
  if (recipe.weights) rule.weight = dice.number(0.2, 1.0);
  return rule;
}

} // namespace

Term randomTerm(Dice& dice, Shape shape, const std::string& name, double low, double high)
{
  Term term{name, shape, parametersOf(dice, shape, low, high), 1.0, {}};
  if (shape == Shape::Function) term.formula = kFormulas[dice.below(5)];
  return term;
}

std::vector<Shape> curveShapes()
{
  std::vector<Shape> shapes;
  for (int i = 0; i < kShapeCount; ++i)
    if (!isNumber(static_cast<Shape>(i))) shapes.push_back(static_cast<Shape>(i));
  return shapes;
}

std::vector<Shape> monotoneShapes()
{
  return {Shape::Concave, Shape::Ramp, Shape::SShape, Shape::Sigmoid, Shape::ZShape};
}

Recipe everything()
{
  Recipe r;
  r.inputShapes = r.outputShapes = curveShapes();
  r.hedges = {Hedge::Any, Hedge::Extremely, Hedge::Not, Hedge::Seldom, Hedge::Somewhat, Hedge::Very};
  r.defuzzifiers = {Defuzzifier::Bisector, Defuzzifier::Centroid, Defuzzifier::LargestOfMaximum,
                    Defuzzifier::MeanOfMaximum, Defuzzifier::SmallestOfMaximum};
  for (int i = 0; i < kTNormCount; ++i)
    r.conjunctions.push_back(static_cast<TNorm>(i)), r.implications.push_back(static_cast<TNorm>(i));
  for (int i = 0; i < kSNormCount; ++i)
    r.disjunctions.push_back(static_cast<SNorm>(i)), r.aggregations.push_back(static_cast<SNorm>(i));
  r.activations = {{},
                   {ActivationKind::First, 3, 0.1, Comparison::GreaterEqual},
                   {ActivationKind::Last, 2, 0.2, Comparison::GreaterEqual},
                   {ActivationKind::Highest, 3, 0.0, Comparison::GreaterEqual},
                   {ActivationKind::Lowest, 3, 0.0, Comparison::GreaterEqual},
                   {ActivationKind::Proportional, 1, 0.0, Comparison::GreaterEqual},
                   {ActivationKind::Threshold, 1, 0.3, Comparison::GreaterEqual},
                   {ActivationKind::Threshold, 1, 0.7, Comparison::Less}};
  r.resolutions = {10, 100, 333};
  r.weights = r.heights = r.severalBlocks = r.chained = r.options = r.conclusionHedges = true;
  return r;
}

System randomSystem(Dice& dice, const Recipe& recipe)
{
  System system;
  system.name = "random";
  for (int i = 0; i < 3; ++i) {
    InputVariable input;
    input.name = "in" + std::to_string(i + 1);
    input.minimum = dice.number(-2.0, 0.0);
    input.maximum = input.minimum + dice.number(1.0, 5.0);
    input.lockRange = recipe.options && dice.chance(0.5);
    for (int t = 0; t < 4; ++t) {
      input.terms.push_back(randomTerm(dice, oneOf(dice, recipe.inputShapes), "t" + std::to_string(t),
                                       input.minimum, input.maximum));
      if (recipe.heights && dice.chance(0.3) && !isNumber(input.terms.back().shape))
        input.terms.back().height = dice.number(0.3, 1.0);
    }
    system.inputs.push_back(std::move(input));
  }
  for (int o = 0; o < 2; ++o) {
    OutputVariable output;
    output.name = "out" + std::to_string(o + 1);
    output.minimum = dice.number(-3.0, 1.0);
    output.maximum = output.minimum + dice.number(1.0, 6.0);
    output.defuzzifier = oneOf(dice, recipe.defuzzifiers);
    output.aggregation = oneOf(dice, recipe.aggregations);
    output.weightedType = isWeighted(output.defuzzifier) ? recipe.weightedType : WeightedType::Automatic;
    if (isArea(output.defuzzifier)) output.resolution = oneOf(dice, recipe.resolutions);
    if (recipe.options) {
      output.lockRange = dice.chance(0.5);
      output.lockPrevious = dice.chance(0.5);
      if (dice.chance(0.5)) output.defaultValue = dice.number(output.minimum, output.maximum);
    }
    for (int t = 0; t < 4; ++t) {
      output.terms.push_back(randomTerm(dice, oneOf(dice, recipe.outputShapes), "t" + std::to_string(t),
                                        output.minimum, output.maximum));
      if (recipe.heights && dice.chance(0.3) && !isNumber(output.terms.back().shape))
        output.terms.back().height = dice.number(0.3, 1.0);
    }
    system.outputs.push_back(std::move(output));
  }
  for (int b = 0; b < (recipe.severalBlocks ? 2 : 1); ++b) {
    RuleBlock block;
    block.name = "block" + std::to_string(b + 1);
    block.conjunction = oneOf(dice, recipe.conjunctions);
    block.disjunction = oneOf(dice, recipe.disjunctions);
    block.implication = oneOf(dice, recipe.implications);
    block.activation = oneOf(dice, recipe.activations);
    for (int r = 0; r < 6; ++r)
      block.rules.push_back(randomRule(dice, system, recipe, recipe.chained && b == 1));
    system.blocks.push_back(std::move(block));
  }
  return system;
}

std::vector<double> randomRow(Dice& dice, const System& system)
{
  std::vector<double> row;
  for (const InputVariable& input : system.inputs) {
    const double margin = 0.05 * (input.maximum - input.minimum);
    row.push_back(dice.number(input.minimum - margin, input.maximum + margin));
  }
  return row;
}

} // namespace esm::fis
