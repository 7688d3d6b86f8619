// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "tests/core/fuzzy/small_rules.h"

#include <cmath>
#include <random>
#include <thread>

namespace esm::fuzzy {
namespace {

double degreeOf(const std::string& condition, std::vector<InputValue> inputs)
{
  const Engine e = engine(smallRules(), {"IF " + condition + " THEN stiffness IS high"});
  return e.evaluate(inputs).firings.at(0).degree;
}

// hardness 0.7, elasticity 0.4, shift 0.1, so hard 0.7, soft 0.3, low 0.6, high 0.4, free 0.9, fixed 0.1.
TEST(Inference, ConditionsAreMinimumMaximumAndComplement)
{
  const std::vector<InputValue> in = {0.7, 0.4, 0.1};
  EXPECT_DOUBLE_EQ(degreeOf("hardness IS hard", in), 0.7);
  EXPECT_DOUBLE_EQ(degreeOf("hardness IS hard AND elasticity IS low", in), 0.6);
  EXPECT_DOUBLE_EQ(degreeOf("hardness IS hard OR shift IS free", in), 0.9);
  EXPECT_DOUBLE_EQ(degreeOf("NOT hardness IS hard", in), 1.0 - 0.7);
  EXPECT_DOUBLE_EQ(degreeOf("hardness IS not very hard", in), 1.0 - 0.7 * 0.7);
  // AND binds before OR; parentheses turn it round.
  EXPECT_DOUBLE_EQ(degreeOf("shift IS free OR hardness IS hard AND shift IS fixed", in), 0.9);
  EXPECT_DOUBLE_EQ(degreeOf("(shift IS free OR hardness IS hard) AND shift IS fixed", in), 0.1);
  EXPECT_DOUBLE_EQ(degreeOf("NOT (hardness IS hard AND shift IS free)", in), 1.0 - 0.7);
  EXPECT_DOUBLE_EQ(degreeOf("hardness IS hard AND elasticity IS low AND shift IS free", in), 0.6);
}

// Rule 1 fires at 0.75 (high), rule 2 at 0.25 (low): the centre 59/96 of test_centroid.cpp.
TEST(Inference, TwoRulesByHand)
{
  const Engine e = engine(smallRules(), {"IF hardness IS hard THEN stiffness IS high",
                                         "IF hardness IS soft THEN stiffness IS low"});
  const Inference result = e.evaluate(std::vector<InputValue>{0.75, 0.5, 0.5});
  EXPECT_NEAR(result.outputs[0].value, 59.0 / 96.0, 1e-15);
  EXPECT_TRUE(result.outputs[0].fromRules);
}

// Two rules for one term aggregate by maximum: the lower one adds nothing.
TEST(Inference, AggregationIsMaximum)
{
  const std::vector<InputValue> in = {0.75, 0.4, 0.5};
  const Engine one = engine(smallRules(), {"IF hardness IS hard THEN stiffness IS high"});
  const Engine two = engine(smallRules(), {"IF hardness IS hard THEN stiffness IS high",
                                           "IF elasticity IS high THEN stiffness IS high"});
  EXPECT_EQ(one.evaluate(in).outputs[0].value, two.evaluate(in).outputs[0].value);
}

// Beyond the range of an input its end counts, so that nothing changes with it there.
TEST(Inference, BeyondTheRangeSlopesAreZero)
{
  RuleBase base = smallRules();
  base.inputs[0].terms[1] = makeTerm("hard", Shape::Triangle, {-1, 2, 3}); // rises through both ends
  const Engine e = engine(
    base, {"IF hardness IS hard THEN stiffness IS high", "IF elasticity IS low THEN stiffness IS low"});
  for (const double hardness : {0.9, 1.5, -0.5}) {
    const std::vector<InputValue> in = {hardness, 0.4, 0.5};
    const bool within = hardness >= 0.0 && hardness <= 1.0;
    EXPECT_EQ(e.slopes(in, 0)[0] != 0.0, within) << hardness;
  }
}

// What no conclusion hangs on is not drawn either: the tail of a bell that does not fire.
TEST(Inference, RulesThatDoNotFireAreNotDrawn)
{
  RuleBase base = smallRules();
  base.rules.push_back(rule(base, "IF hardness IS hard THEN stiffness IS high"));
  for (const auto& [degree, drawn] : {std::pair{1e-13, false}, {1e-11, true}}) {
    Inference inference;
    inference.firings.push_back({0, degree});
    double highest = 0.0;
    for (const auto& [x, height] : aggregatedSet(base, inference, 0, 11)) highest = std::max(highest, height);
    EXPECT_EQ(highest, drawn ? degree : 0.0);
  }
}

TEST(Inference, WeightScalesTheDegreeAndDisabledRulesAreSilent)
{
  RuleBase base = smallRules();
  base.rules.push_back(rule(base, "IF hardness IS hard THEN stiffness IS high WITH 0.5"));
  base.rules.push_back(rule(base, "IF hardness IS hard THEN stiffness IS low"));
  base.rules.push_back(rule(base, "IF hardness IS soft THEN stiffness IS low"));
  base.rules[1].enabled = false;
  const auto e = Engine::create(base);
  const Inference result = e->evaluate(std::vector<InputValue>{0.5, 0.5, 0.5});
  ASSERT_EQ(result.firings.size(), 2U);
  EXPECT_EQ(result.firings[0].rule, 0);
  EXPECT_DOUBLE_EQ(result.firings[0].degree, 0.25);
  EXPECT_EQ(result.firings[1].rule, 2);
  EXPECT_DOUBLE_EQ(result.firings[1].degree, 0.5);
}

TEST(Inference, OneRuleMayConcludeOnSeveralOutputs)
{
  const Engine e = engine(smallRules(), {"IF hardness IS hard THEN stiffness IS high AND depth IS small"});
  const Inference result = e.evaluate(std::vector<InputValue>{1.0, 0.5, 0.5});
  EXPECT_NEAR(result.outputs[0].value, 2.0 / 3.0, 1e-15); // a whole triangle 0 1 1
  EXPECT_NEAR(result.outputs[1].value, 2.0, 1e-14);
}

// What no rule reaches keeps its default and says so; so does an output whose rules all have degree 0.
TEST(Inference, WithoutARuleAnOutputTakesItsDefault)
{
  const Engine e = engine(smallRules(), {"IF hardness IS hard THEN stiffness IS high"});
  const Inference result = e.evaluate(std::vector<InputValue>{0.0, 0.5, 0.5});
  EXPECT_FALSE(result.outputs[0].fromRules);
  EXPECT_EQ(result.outputs[0].value, 0.25);
  EXPECT_FALSE(result.outputs[1].fromRules);
  EXPECT_EQ(result.outputs[1].value, 3.0);
}

// "soft" (1-x) and "hard" (x) meet at 1/2; "very hard" (x^2) meets 1-x at (3-sqrt 5)/2.
TEST(Inference, WordsCountByTheHeightOfTheirIntersection)
{
  const Word hard{"hard", {}}, veryHard{"hard", {Hedge::Very}};
  EXPECT_DOUBLE_EQ(degreeOf("hardness IS hard", {hard, 0.5, 0.5}), 1.0);
  EXPECT_DOUBLE_EQ(degreeOf("hardness IS soft", {hard, 0.5, 0.5}), 0.5);
  EXPECT_NEAR(degreeOf("hardness IS soft", {veryHard, 0.5, 0.5}), (3.0 - std::sqrt(5.0)) / 2.0, 1e-15);
}

TEST(Inference, OddInputsCountAsTheDefault)
{
  const Engine e = engine(smallRules(), {"IF hardness IS hard THEN stiffness IS high"});
  const double expected = e.evaluate(std::vector<InputValue>{0.5, 0.5, 0.5}).firings[0].degree;
  for (const InputValue& odd : {InputValue(std::nan("")), InputValue(kInfinity), InputValue(Word{"no", {}})})
    EXPECT_EQ(e.evaluate(std::vector<InputValue>{odd, 0.5, 0.5}).firings[0].degree, expected);
  EXPECT_EQ(e.evaluate({}).firings[0].degree, expected);
  EXPECT_EQ(e.evaluate(std::vector<InputValue>{7.0}).firings[0].degree, 1.0) << "above the range is its end";
}

// On a logarithmic output a triangle around 10^3 has its centre there. 1e-12: log10 and pow round.
TEST(Inference, LogarithmicOutputsAreAveragedInDecades)
{
  RuleBase base = smallRules();
  base.outputs.push_back({"modulus",
                          {"modulus", "Modul"},
                          "Pa",
                          1.0,
                          1e6,
                          10.0,
                          true,
                          {makeTerm("kilo", Shape::Triangle, {2, 3, 4})}});
  const Engine e = engine(base, {"IF hardness IS hard THEN modulus IS kilo"});
  const Inference result = e.evaluate(std::vector<InputValue>{0.3, 0.5, 0.5});
  EXPECT_NEAR(result.outputs[2].value / 1000.0, 1.0, 1e-12);
}

// Wherever the inputs lie: no NaN, and every answer within its variable's range.
TEST(Inference, AnswersLieInTheirRange)
{
  RuleBase base = smallRules();
  base.outputs[1].terms.push_back(makeTerm("bell", Shape::Gaussian, {5, 0.01}));
  const Engine e = engine(base, {"IF hardness IS extremely hard OR shift IS hardly free THEN depth IS bell",
                                 "IF elasticity IS somewhat low THEN depth IS very large WITH 0.01"});
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(-0.2, 1.2);
  for (int i = 0; i < 500; ++i) {
    const Inference result =
      e.evaluate(std::vector<InputValue>{number(random), number(random), number(random)});
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_GE(result.outputs[k].value, base.outputs[k].minimum);
      EXPECT_LE(result.outputs[k].value, base.outputs[k].maximum);
    }
  }
}

// One engine, several threads, the same bits (under the thread sanitizer also: no race).
TEST(Inference, IsTheSameOnManyThreads)
{
  const Engine e = engine(smallRules(), {"IF hardness IS hard THEN stiffness IS high",
                                         "IF hardness IS soft THEN stiffness IS very low"});
  const auto sum = [copy = e] {
    double total = 0.0;
    for (int i = 0; i <= 100; ++i)
      total += copy.evaluate(std::vector<InputValue>{i / 100.0, 0.5, 0.5}).outputs[0].value;
    return total;
  };
  const double expected = sum();
  std::vector<double> sums(4);
  std::vector<std::thread> threads;
  for (double& result : sums) threads.emplace_back([&result, &sum] { result = sum(); });
  for (std::thread& thread : threads) thread.join();
  for (const double result : sums) EXPECT_EQ(result, expected);
}

TEST(AggregatedSet, IsTheMaximumOfTheClippedTerms)
{
  const Engine e = engine(smallRules(), {"IF hardness IS hard THEN stiffness IS high",
                                         "IF hardness IS soft THEN stiffness IS low"});
  const Inference result = e.evaluate(std::vector<InputValue>{0.75, 0.5, 0.5});
  const auto plot = aggregatedSet(e.ruleBase(), result, 0, 5);
  const std::vector<std::pair<double, double>> expected = {
    {0.0, 0.25}, {0.25, 0.25}, {0.5, 0.5}, {0.75, 0.75}, {1.0, 0.75}};
  EXPECT_EQ(plot, expected);
}

} // namespace
} // namespace esm::fuzzy
