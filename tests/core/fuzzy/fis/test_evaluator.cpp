// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/fuzzy/fis/checks.h"
#include "core/fuzzy/fis/evaluator.h"
#include "core/fuzzy/fis/files.h"
#include "tests/core/fuzzy/fis/random_system.h"
#include "tests/support/allocation_counter.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <thread>

namespace esm::fis {

namespace {

System systemOf(const std::string& rules, const std::string& more = "")
{
  const std::string text =
    "Engine: small\nInputVariable: heat\n range: 0 10\n term: cold Ramp 6 2\n term: hot Ramp 4 8\n"
    "InputVariable: noise\n range: 0 1\n term: quiet Ramp 1 0\n term: loud Ramp 0 1\n"
    "OutputVariable: speed\n range: 0 100\n aggregation: Maximum\n defuzzifier: WeightedAverage\n default: "
    "7\n" +
    more +
    " term: low Constant 10\n term: high Constant 90\nRuleBlock: rules\n conjunction: Minimum\n disjunction: "
    "Maximum\n implication: Minimum\n" +
    rules;
  auto system = readFll(text, "small");
  EXPECT_TRUE(system) << system.error().detail;
  return std::move(*system);
}

OutputResult answer(const System& system, std::vector<Input> inputs)
{
  const auto evaluator = Evaluator::create(system);
  Workspace workspace = evaluator->makeWorkspace();
  evaluator->evaluate(std::span<const Input>(inputs), workspace);
  return workspace.outputs()[0];
}

const char* kRules = " rule: if heat is cold then speed is low\n rule: if heat is hot then speed is high\n";

std::vector<FindingKind> kindsOf(const System& system)
{
  std::vector<FindingKind> kinds;
  for (const Finding& finding : checkRules(system)) kinds.push_back(finding.kind);
  return kinds;
}

} // namespace

// At heat 5: cold 1/4, hot 1/4.
TEST(Evaluator, TakesNumbersIntervalsAndWords)
{
  const System system = systemOf(kRules);
  EXPECT_DOUBLE_EQ(answer(system, {Input::number(5.0)}).value, 50.0);
  // Within [3, 5] cold is 3/4 at its best, hot 1/4: (10 * 3 + 90) / 4
  EXPECT_DOUBLE_EQ(answer(system, {Input::interval(3.0, 5.0)}).value, 30.0);
  // hot meets cold where both are 1/4; very hot, being lower, at t^2 = 1/2 - t: t = (sqrt 3 - 1) / 2
  EXPECT_NEAR(answer(system, {Input::word(system.inputs[0].terms[1])}).value, (10 * 0.25 + 90) / 1.25, 1e-13);
  const std::array very = {Hedge::Very};
  const double t = (std::sqrt(3.0) - 1.0) / 2.0;
  EXPECT_NEAR(answer(system, {Input::word(system.inputs[0].terms[1], very)}).value,
              (10 * t * t + 90) / (t * t + 1), 1e-12);
}

// Where a formula needs a number, the middle of the interval stands in.
TEST(Evaluator, TheMiddleOfAnIntervalStandsIn)
{
  System system = systemOf(" rule: if heat is any then speed is high\n");
  system.outputs[0].terms[1] = {"high", Shape::Linear, {3.0, 0.0, 1.0}, 1.0, {}};
  EXPECT_DOUBLE_EQ(answer(system, {Input::interval(2.0, 6.0), Input::number(0.0)}).value, 13.0);
}

TEST(Evaluator, SaysWhereAValueComesFrom)
{
  System system = systemOf(" rule: if heat is hot then speed is high\n");
  EXPECT_EQ(answer(system, {Input::number(9.0)}).origin, Origin::Rules);
  EXPECT_EQ(answer(system, {Input::number(1.0)}).origin, Origin::Default);
  EXPECT_EQ(answer(system, {Input::number(1.0)}).value, 7.0);
  EXPECT_EQ(answer(system, {}).origin, Origin::Default); // nobody gave the heat
  system.outputs[0].lockPrevious = true;
  const auto evaluator = Evaluator::create(system);
  Workspace workspace = evaluator->makeWorkspace();
  evaluator->evaluate(std::array{9.0, 0.0}, workspace);
  evaluator->evaluate(std::array{1.0, 0.0}, workspace);
  EXPECT_EQ(workspace.outputs()[0].origin, Origin::Previous);
  EXPECT_EQ(workspace.outputs()[0].value, 90.0);
  workspace.restart();
  evaluator->evaluate(std::array{1.0, 0.0}, workspace);
  EXPECT_EQ(workspace.outputs()[0].value, 7.0);
}

TEST(Evaluator, DerivesByTheTermsThatAWordMeets)
{
  System system = systemOf(kRules);
  const auto value = [&](double start) {
    system.inputs[0].terms[0].parameters[0] = start;
    const Term hot{"hot", Shape::Ramp, {4, 8}, 1.0, {}};
    return answer(system, {Input::word(hot)}).value;
  };
  const double difference = (value(6.0 + 1e-5) - value(6.0 - 1e-5)) / 2e-5;
  system.inputs[0].terms[0].parameters[0] = 6.0;
  const auto evaluator = Evaluator::create(system);
  Workspace workspace = evaluator->makeWorkspace();
  const std::array inputs = {Input::word(system.inputs[0].terms[1]), Input{}};
  evaluator->evaluate(std::span<const Input>(inputs), workspace);
  Gradient gradient;
  evaluator->differentiate(0, workspace, gradient);
  EXPECT_NEAR(gradient.byParameter[0], difference, 1e-6); // central differences at 1e-5: 1e-10 and rounding
}

TEST(Evaluator, AllocatesNothing)
{
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Dice dice(seed);
    const System system = randomSystem(dice, everything());
    for (const auto area : {Options::Area::Exact, Options::Area::Sampled}) {
      const auto evaluator = Evaluator::create(system, {area, 0});
      Workspace workspace = evaluator->makeWorkspace();
      const auto row = randomRow(dice, system);
      Gradient gradient;
      evaluator->evaluate(row, workspace);
      evaluator->differentiate(0, workspace, gradient); // sizes the gradient
      const auto before = test::allocationsOfThisThread();
      evaluator->evaluate(row, workspace);
      evaluator->differentiate(1, workspace, gradient);
      EXPECT_EQ(test::allocationsOfThisThread(), before) << "seed " << seed;
    }
  }
}

TEST(Evaluator, IsTheSameOnManyThreads)
{
  Dice dice(3);
  const System system = randomSystem(dice, everything());
  const auto evaluator = Evaluator::create(system);
  const auto row = randomRow(dice, system);
  std::array<double, 4> values{};
  std::vector<std::thread> threads;
  for (double& value : values)
    threads.emplace_back([&] {
      Workspace workspace = evaluator->makeWorkspace();
      for (int i = 0; i < 20; ++i) evaluator->evaluate(row, workspace);
      value = workspace.outputs()[0].value;
    });
  for (std::thread& thread : threads) thread.join();
  for (const double value : values) EXPECT_TRUE(value == values[0] || std::isnan(value));
}

TEST(Formula, ComputesAndNamesTheFault)
{
  const std::vector<std::string> names = {"x", "a"};
  const auto value = [&](const std::string& text) {
    const auto parsed = Formula::parse(text, names);
    const auto* formula = std::get_if<Formula>(&parsed);
    return formula ? formula->evaluate(3.0, std::array{2.0}) : kNoValue;
  };
  EXPECT_EQ(value("1 + 2 * x ^ a"), 19.0);
  EXPECT_EQ(value("-x^2"), -9.0);
  EXPECT_EQ(value("2^3^2"), 512.0);
  EXPECT_EQ(value("max(x, a) % 2 + gt(x, a)"), 2.0);
  EXPECT_NEAR(value("sin(pi / 2) * 1e-1"), 0.1, 1e-16);
  for (const auto& [text, offset] :
       {std::pair<const char*, std::size_t>{"1 + ", 4}, {"(x", 2}, {"y * 2", 0}, {"min(x)", 5}, {"1 2", 2}}) {
    const auto parsed = Formula::parse(text, names);
    ASSERT_TRUE(std::holds_alternative<FormulaError>(parsed)) << text;
    EXPECT_EQ(std::get<FormulaError>(parsed).offset, offset) << text;
  }
}

TEST(Checks, FindWhatIsOdd)
{
  using Kind = FindingKind;
  EXPECT_TRUE(kindsOf(systemOf(kRules)).empty());
  EXPECT_EQ(kindsOf(systemOf(" rule: if heat is hot then speed is high\n")), std::vector{Kind::Uncovered});
  const std::string rules = kRules;
  EXPECT_EQ(kindsOf(systemOf(rules + " rule: if heat is hot then speed is high with 0.5\n")),
            std::vector{Kind::Duplicate});
  EXPECT_EQ(kindsOf(systemOf(rules + " rule: if heat is hot then speed is low\n")),
            std::vector{Kind::Contradiction});
  EXPECT_EQ(kindsOf(systemOf(rules + " rule: if heat is hot and noise is loud then speed is low with 0\n")),
            std::vector{Kind::NeverFires});
  EXPECT_EQ(kindsOf(systemOf("")), std::vector{Kind::OutputNeverSet});
  System overlap = systemOf(rules);
  overlap.inputs[1].terms[0].parameters = {0.1, 1};
  EXPECT_EQ(kindsOf(overlap), (std::vector{Kind::Overlap, Kind::Gap})); // and at no noise neither holds
  System shadow = systemOf(rules + " rule: if heat is hot and noise is loud then speed is high\n");
  shadow.outputs[0].defuzzifier = Defuzzifier::Centroid;
  shadow.outputs[0].terms = {{"low", Shape::Triangle, {0, 20, 40}, 1.0, {}},
                             {"high", Shape::Triangle, {60, 80, 100}, 1.0, {}}};
  EXPECT_EQ(kindsOf(shadow), std::vector{Kind::Shadowed});
}

// Equal triangles of half width 1, one moved by d: the common part is (1 - d/2)^2, of what either covers 62
// per cent at d = 1/4 and 55 at 0.32. More than 60 per cent is odd.
TEST(Checks, TermsMayShareSixtyPerCent)
{
  for (const auto& [shift, odd] : {std::pair{0.25, true}, {0.32, false}}) {
    System system = systemOf(kRules);
    system.outputs[0].minimum = -1.0, system.outputs[0].maximum = 2.0;
    system.outputs[0].terms = {{"low", Shape::Triangle, {-1, 0, 1}, 1.0, {}},
                               {"high", Shape::Triangle, {shift - 1, shift, shift + 1}, 1.0, {}}};
    const auto kinds = kindsOf(system);
    EXPECT_EQ(std::count(kinds.begin(), kinds.end(), FindingKind::Overlap), odd ? 1 : 0) << shift;
  }
}

// The witness of an uncovered place is one: nothing fires there.
TEST(Checks, WitnessesHold)
{
  const System system = systemOf(" rule: if heat is hot and noise is loud then speed is high\n");
  const auto findings = checkRules(system);
  ASSERT_EQ(findings.size(), 2U); // nothing hot, whatever the noise; no noise, whatever the heat
  const auto evaluator = Evaluator::create(system);
  Workspace workspace = evaluator->makeWorkspace();
  for (const Finding& finding : findings) {
    ASSERT_EQ(finding.inputs.size(), 1U);
    const auto other = static_cast<std::size_t>(1 - finding.inputs[0]);
    for (int i = 0; i <= 20; ++i) {
      std::vector<double> place = finding.witness;
      place[other] =
        system.inputs[other].minimum + i * (system.inputs[other].maximum - system.inputs[other].minimum) / 20;
      evaluator->evaluate(place, workspace);
      EXPECT_EQ(workspace.outputs()[0].origin, Origin::Default) << place[0] << ' ' << place[1];
    }
  }
  EXPECT_NE(findings[0].inputs, findings[1].inputs);
}

} // namespace esm::fis
