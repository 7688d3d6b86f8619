// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/fuzzy/rule_findings.h"
#include "core/fuzzy/rule_text.h"
#include "core/tissue/tissue_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace esm {
namespace {

using fuzzy::InputValue;

class DefaultRules : public testing::Test {
protected:
  fuzzy::Inference infer(const InputValue& hardness, const InputValue& elasticity,
                         const InputValue& shift) const
  {
    return infer(std::vector<InputValue>{hardness, elasticity, shift});
  }
  /// Inputs that are not given stay in the middle.
  fuzzy::Inference infer(std::vector<InputValue> inputs) const
  {
    inputs.resize(rules.inputs.size(), 0.5);
    return engine.evaluate(inputs);
  }
  /// The input of a finding in words.
  InputValue word(std::size_t input, std::string_view text) const
  {
    const auto parsed = fuzzy::parseInput(text, rules.inputs[input]);
    if (const auto* error = std::get_if<fuzzy::RuleTextError>(&parsed)) {
      ADD_FAILURE() << text << ": " << error->message;
      return 0.5;
    }
    return std::get<InputValue>(parsed);
  }
  fuzzy::RuleBase rules = defaultRules();
  fuzzy::Engine engine = *fuzzy::Engine::create(defaultRules());
};

/// Corners, middles and what lies between, of all seven inputs at once: 5^7 would be too many, so every input
/// walks its own way through [0, 1] (additive recurrence), corners first.
std::vector<InputValue> placeInInputs(int n)
{
  constexpr double kSteps[] = {0.754877, 0.569840, 0.430160, 0.324718, 0.245122, 0.185037, 0.139680};
  std::vector<InputValue> inputs;
  for (int i = 0; i < 7; ++i) {
    const double x = n < 128 ? (n >> i) % 2 : kSteps[i] * n - std::floor(kSteps[i] * n);
    inputs.emplace_back(x);
  }
  return inputs;
}

TEST_F(DefaultRules, AreOfASizeThatCanBeRead)
{
  EXPECT_EQ(rules.inputs.size(), 7U);
  EXPECT_EQ(rules.outputs.size(), 7U);
  EXPECT_GE(rules.rules.size(), 24U);
  EXPECT_LE(rules.rules.size(), 40U);
  const auto aboutTwoInputs = [](const fuzzy::Rule& rule) {
    std::set<std::string> inputs;
    for (const auto& node : rule.condition.nodes) inputs.insert(node.proposition.variable);
    return inputs.size() - inputs.count("") == 2;
  };
  const auto interactions = std::count_if(rules.rules.begin(), rules.rules.end(), aboutTwoInputs);
  EXPECT_GE(interactions, 6);
  EXPECT_LE(interactions, 10);
  for (const fuzzy::Variable& output : rules.outputs) EXPECT_TRUE(output.logarithmic) << output.id;
  EXPECT_TRUE(checkRuleBase(rules));
}

// A strong partition: every value of an input is shared out among its words without rest. 1e-12: rounding.
TEST_F(DefaultRules, WordsOfAnInputSumToOneEverywhere)
{
  for (const fuzzy::Variable& input : rules.inputs)
    for (int i = 0; i <= 1000; ++i) {
      double sum = 0.0;
      for (const fuzzy::Term& term : input.terms) sum += fuzzy::membership(term, i / 1000.0);
      ASSERT_NEAR(sum, 1.0, 1e-12) << input.id << ' ' << i;
    }
}

// No hole: wherever the sliders stand, a rule speaks for every output.
TEST_F(DefaultRules, CoverEveryInput)
{
  for (int n = 0; n < 3000; ++n) {
    const auto result = infer(placeInInputs(n));
    for (std::size_t o = 0; o < rules.outputs.size(); ++o) {
      ASSERT_TRUE(result.outputs[o].fromRules) << n << ' ' << rules.outputs[o].id;
      ASSERT_GE(result.outputs[o].value, rules.outputs[o].minimum);
      ASSERT_LE(result.outputs[o].value, rules.outputs[o].maximum);
    }
  }
}

// Nothing contradicts, repeats, hides or never fires, and the words neither gape nor overlap: the list of
// problems of a new project is empty.
TEST_F(DefaultRules, HaveNoOddities)
{
  for (const fuzzy::RuleFinding& finding : fuzzy::findOddities(rules))
    ADD_FAILURE() << fis::nameOf(finding.kind) << " rule " << finding.rule + 1 << " variable "
                  << finding.variable;
}

// Two rules of neighbouring words left out leave a hole between their peaks, and the list says where.
TEST_F(DefaultRules, MissingRulesAreFound)
{
  rules.rules.erase(rules.rules.begin() + 3, rules.rules.begin() + 5); // hardness medium and firm
  const auto findings = fuzzy::findOddities(rules);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].kind, fis::FindingKind::Uncovered);
  ASSERT_EQ(findings[0].place.size(), 1U);
  EXPECT_EQ(findings[0].place[0].first, 0);
  EXPECT_NEAR(findings[0].place[0].second, 3.5 / 6.0, 1e-12);
}

// Nor is there a word, plain or hedged, to which no rule answers.
TEST_F(DefaultRules, AnswerToEveryWord)
{
  using fuzzy::Hedge;
  const std::vector<std::vector<Hedge>> hedges = {
    {}, {Hedge::Not}, {Hedge::Very}, {Hedge::Extremely}, {Hedge::Somewhat}, {Hedge::Not, Hedge::Very}};
  for (std::size_t i = 0; i < rules.inputs.size(); ++i)
    for (const fuzzy::Term& term : rules.inputs[i].terms)
      for (const auto& hedge : hedges) {
        std::vector<InputValue> inputs(rules.inputs.size(), 0.5);
        inputs[i] = fuzzy::Word{term.id, hedge};
        for (const fuzzy::OutputValue& output : infer(inputs).outputs)
          EXPECT_TRUE(output.fromRules) << rules.inputs[i].id << ' ' << term.id;
      }
}

// A slider never turns back what it has just done. Strictly: every step of 1/200 changes the value.
TEST_F(DefaultRules, RiseAndFallWithTheirInput)
{
  fuzzy::Inference last = infer(0.0, 0.0, 0.0);
  for (int i = 1; i <= 200; ++i) {
    const double x = i / 200.0;
    const fuzzy::Inference next = infer(x, x, x);
    EXPECT_GT(next.outputs[0].value, last.outputs[0].value) << "stiffness at hardness " << x;
    EXPECT_LT(next.outputs[1].value, last.outputs[1].value) << "viscosity at elasticity " << x;
    EXPECT_LT(next.outputs[2].value, last.outputs[2].value) << "anchoring at shiftability " << x;
    last = next;
  }
}

// The same with the other six sliders anywhere, interactions and all. 1e-9: inference is exact to rounding.
// Only the volume stiffness may dip, by a few per cent where "thick" passes into "solid": there both words
// are half true, and so is what they conclude together.
TEST_F(DefaultRules, RiseAndFallWhateverTheOthersSay)
{
  constexpr double kDirection[] = {1, -1, -1, 1, 1, 1, 1};
  const char* outputIds[] = {"youngs_modulus", "viscosity",  "anchoring",   "density",
                             "rupture_strain", "stiffening", "volume_ratio"};
  for (std::size_t i = 0; i < 7; ++i) {
    std::size_t output = 0;
    while (rules.outputs[output].id != outputIds[i]) ++output;
    for (int n = 0; n < 150; ++n) {
      std::vector<InputValue> inputs = placeInInputs(n);
      double last = -std::numeric_limits<double>::infinity();
      for (int step = 0; step <= 50; ++step) {
        inputs[i] = step / 50.0;
        const double value = kDirection[i] * std::log(infer(inputs).outputs[output].value);
        ASSERT_GE(value, last - (i == 6 ? 0.05 : 1e-9))
          << rules.inputs[i].id << ' ' << step << " place " << n;
        last = value;
      }
    }
  }
}

// Myometrium and tube 30 to 60 kPa in the middle; gallbladder 255 kPa (within a factor 1.5) at "rather
// hard"; muscle and liver 5 to 10 kPa at "rather soft"; retardation times of a few ms.
TEST_F(DefaultRules, GiveMeasuredMagnitudes)
{
  const auto modulus = [&](double hardness) { return infer(hardness, 0.5, 0.5).outputs[0].value; };
  EXPECT_GT(modulus(0.5), 30e3);
  EXPECT_LT(modulus(0.5), 60e3);
  EXPECT_GT(modulus(0.75), 255e3 / 1.5);
  EXPECT_LT(modulus(0.75), 255e3 * 1.5);
  EXPECT_GT(modulus(0.25), 5e3);
  EXPECT_LT(modulus(0.25), 10e3);
  EXPECT_LT(modulus(0.0), 2e3);
  EXPECT_GT(modulus(1.0), 1e6);
  const double retardation = infer(0.5, 0.5, 0.5).outputs[1].value;
  EXPECT_GT(retardation, 1e-3);
  EXPECT_LT(retardation, 20e-3);
}

// Two findings together say what neither says alone. Each interaction is tried at its place, against the
// same place with the second finding at the middle; "higher" and "lower" are at least 5 per cent, beyond any
// rounding.
TEST_F(DefaultRules, TwoFindingsSayMoreThanEach)
{
  struct Interaction {
    std::size_t first;
    double at;
    std::size_t second;
    double together;
    const char* output;
    bool raises;
  };
  enum Input : std::size_t { Hardness, Elasticity, Shiftability, Heaviness, Toughness, Stretch, Wall };
  for (const Interaction& x :
       std::initializer_list<Interaction>{{Wall, 1.0, Hardness, 0.0, "volume_ratio", true},
                                          {Wall, 1.0 / 3.0, Hardness, 1.0, "volume_ratio", true},
                                          {Toughness, 0.0, Stretch, 1.0, "rupture_strain", false},
                                          {Toughness, 1.0, Wall, 0.0, "rupture_strain", true},
                                          {Shiftability, 0.0, Wall, 0.0, "anchoring", false},
                                          {Shiftability, 1.0, Wall, 0.0, "anchoring", true},
                                          {Hardness, 1.0 / 6.0, Wall, 1.0, "viscosity", true},
                                          {Wall, 1.0 / 3.0, Toughness, 1.0, "stiffening", true}}) {
    std::vector<InputValue> inputs(7, 0.5);
    inputs[Elasticity] = 0.75;
    inputs[Heaviness] = x.first == Toughness && !x.raises ? 1.0 : 0.5; // dense: the watery rule is silent
    inputs[x.first] = x.at;
    std::size_t output = 0;
    while (rules.outputs[output].id != x.output) ++output;
    const double alone = infer(inputs).outputs[output].value;
    inputs[x.second] = x.together;
    const double ratio = infer(inputs).outputs[output].value / alone;
    EXPECT_GT(x.raises ? ratio : 1.0 / ratio, 1.05) << rules.inputs[x.first].id << ' ' << x.output;
  }
  const double watery = infer({0.5, 0.5, 0.5, 0.5, 0.0}).outputs[4].value;
  EXPECT_LT(watery, infer({0.5, 0.5, 0.5, 1.0, 0.0}).outputs[4].value / 1.05);
}

TEST_F(DefaultRules, UnderstandFindingsAsTheyAreSpoken)
{
  const auto english =
    infer(word(0, "rather hard"), word(1, "a little elastic"), word(2, "hardly shiftable"));
  const auto german =
    infer(word(0, "ziemlich hart"), word(1, "wenig elastisch"), word(2, "kaum verschieblich"));
  for (std::size_t o = 0; o < 3; ++o) {
    EXPECT_TRUE(english.outputs[o].fromRules);
    EXPECT_EQ(english.outputs[o].value, german.outputs[o].value);
  }
  const auto middle = infer(0.5, 0.5, 0.5);
  EXPECT_GT(english.outputs[0].value, 2 * middle.outputs[0].value) << "rather hard is stiffer than medium";
  EXPECT_GT(english.outputs[1].value, 1.5 * middle.outputs[1].value) << "a little elastic is sluggish";
  EXPECT_GT(english.outputs[2].value, 2 * middle.outputs[2].value) << "hardly shiftable is held";
}

// From soft to very hard, each word in its place.
TEST_F(DefaultRules, OrderTheWordsOfHardness)
{
  double last = 0.0;
  for (const char* text :
       {"very soft", "soft", "rather soft", "medium", "ziemlich hart", "hart", "sehr hart", "extrem hart"}) {
    const double modulus = infer(word(0, text), 0.5, 0.5).outputs[0].value;
    EXPECT_GT(modulus, last) << text;
    last = modulus;
  }
}

TEST_F(DefaultRules, ReadBackInBothLanguages)
{
  for (const fuzzy::Rule& rule : rules.rules)
    for (const Language language : {Language::English, Language::German}) {
      const std::string text = fuzzy::formatRule(rule, rules, language);
      const auto parsed = fuzzy::parseRule(text, rules);
      ASSERT_TRUE(std::holds_alternative<fuzzy::Rule>(parsed)) << text;
      EXPECT_EQ(std::get<fuzzy::Rule>(parsed), rule) << text;
      EXPECT_EQ(text.find('"'), std::string::npos) << "no name needs quotes: " << text;
    }
}

TEST_F(DefaultRules, TakeTheRulesOfTheManual)
{
  const auto english = fuzzy::parseRule("IF hardness IS very hard THEN stiffness IS high", rules);
  const auto german = fuzzy::parseRule("WENN Härte IST sehr hart DANN Steifigkeit IST hoch", rules);
  ASSERT_TRUE(std::holds_alternative<fuzzy::Rule>(english));
  EXPECT_EQ(std::get<fuzzy::Rule>(english), std::get<fuzzy::Rule>(german));
}

} // namespace
} // namespace esm
