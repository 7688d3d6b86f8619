// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/fuzzy/rule_findings.h"

#include "core/fuzzy/inference.h"
#include "core/fuzzy/rule_text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace esm::fuzzy {
namespace {

using fis::FindingKind;

/// Seven words evenly over [0, 1], neighbours crossing at one half, and a second input of two words.
RuleBase sevenWords()
{
  RuleBase base;
  Variable hardness{"hardness", {"hardness", "Härte"}, "", 0.0, 1.0, 0.5, false, {}};
  Variable wall{"wall", {"wall", "Wand"}, "", 1.0, 1000.0, 10.0, true, {}};
  Variable stiffness{"stiffness", {"stiffness", "Steifigkeit"}, "", 0.0, 7.0, 3.0, false, {}};
  for (int i = 0; i < 7; ++i) {
    const std::string id = "w" + std::to_string(i);
    hardness.terms.push_back({id, {id, id}, Shape::Triangle, {(i - 1) / 6.0, i / 6.0, (i + 1) / 6.0}});
    stiffness.terms.push_back({id, {id, id}, Shape::Triangle, {i - 1.0, double(i), i + 1.0}});
  }
  wall.terms = {{"thin", {"thin", "thin"}, Shape::Triangle, {-1.0, 0.0, 3.0}},
                {"thick", {"thick", "thick"}, Shape::Triangle, {0.0, 3.0, 4.0}}};
  base.inputs = {hardness, wall};
  base.outputs = {stiffness};
  for (int i = 0; i < 7; ++i)
    base.rules.push_back(std::get<Rule>(
      parseRule("IF hardness IS w" + std::to_string(i) + " THEN stiffness IS w" + std::to_string(i), base)));
  return base;
}

bool fires(const RuleBase& base, const RuleFinding& finding, double others)
{
  std::vector<InputValue> inputs;
  for (const Variable& input : base.inputs)
    inputs.emplace_back(input.logarithmic ? std::pow(input.maximum, others) : others);
  for (const auto& [input, value] : finding.place) inputs[static_cast<std::size_t>(input)] = value;
  return Engine::create(base)->evaluate(inputs).outputs[0].fromRules;
}

TEST(RuleFindings, ThereAreNoneWhereEveryWordHasItsRule)
{
  EXPECT_TRUE(findOddities(sevenWords()).empty());
}

// Neighbouring words reach up to the peak and no further: without its rule only the peak itself is bare, a
// place that chance does not hit.
TEST(RuleFindings, OneRuleLeftOutLeavesAHoleAtItsPeak)
{
  RuleBase base = sevenWords();
  base.rules.erase(base.rules.begin() + 2);
  const auto findings = findOddities(base);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].kind, FindingKind::Uncovered);
  EXPECT_EQ(findings[0].place, (std::vector<std::pair<int, double>>{{0, 2 / 6.0}}));
  for (const double wall : {0.1, 0.5, 1.0}) EXPECT_FALSE(fires(base, findings[0], wall));
}

// Two neighbours left out: a hole from peak to peak, and the place is its middle. A hole elsewhere is
// another.
TEST(RuleFindings, EachHoleIsListedOnceWithItsMiddle)
{
  RuleBase base = sevenWords();
  base.rules.erase(base.rules.begin() + 5);
  base.rules.erase(base.rules.begin() + 2, base.rules.begin() + 4);
  const auto findings = findOddities(base);
  ASSERT_EQ(findings.size(), 2U);
  EXPECT_NEAR(findings[0].place.at(0).second, 2.5 / 6.0, 1e-12);
  EXPECT_NEAR(findings[1].place.at(0).second, 5.0 / 6.0, 1e-12);
}

// A logarithmic input's place is a value, not its logarithm: from thick's foot (1) to its peak (1000).
TEST(RuleFindings, PlacesArePlainValues)
{
  RuleBase base = sevenWords();
  base.rules = {std::get<Rule>(parseRule("IF wall IS thick THEN stiffness IS w1", base))};
  const auto findings = findOddities(base);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].place, (std::vector<std::pair<int, double>>{{1, 1.0}}));
  EXPECT_FALSE(fires(base, findings[0], 0.5));
}

TEST(RuleFindings, NameRulesAndTerms)
{
  RuleBase base = sevenWords();
  const auto add = [&](const char* text) { base.rules.push_back(std::get<Rule>(parseRule(text, base))); };
  add("IF hardness IS w0 THEN stiffness IS w6");                    // 7: against 0
  add("IF hardness IS w1 THEN stiffness IS w1 WITH 0.5");           // 8: as 1
  add("IF hardness IS w2 AND wall IS thin THEN stiffness IS w2");   // 9: behind 2
  add("IF hardness IS w0 AND hardness IS w4 THEN stiffness IS w3"); // 10: never
  base.inputs[1].terms.push_back({"thinnish", {"thinnish", "thinnish"}, Shape::Triangle, {-1.0, 0.2, 3.0}});
  const auto findings = findOddities(base);
  const auto has = [&](FindingKind kind, int rule, int other) {
    return std::any_of(findings.begin(), findings.end(), [&](const RuleFinding& f) {
      return f.kind == kind && f.rule == rule && f.otherRule == other;
    });
  };
  EXPECT_EQ(findings.size(), 5U);
  EXPECT_TRUE(has(FindingKind::Contradiction, 0, 7));
  EXPECT_TRUE(has(FindingKind::Duplicate, 1, 8));
  EXPECT_TRUE(has(FindingKind::Shadowed, 9, 2));
  EXPECT_TRUE(has(FindingKind::NeverFires, 10, -1));
  ASSERT_EQ(findings[0].kind, FindingKind::Overlap);
  EXPECT_EQ(findings[0].variable, 1);
  EXPECT_EQ(findings[0].term, 0);
  EXPECT_EQ(findings[0].otherTerm, 2);
  EXPECT_GT(findings[0].overlap, 0.6);
}

// Each copy is named once, against the first: a list that grows with the rules, not with their pairs.
TEST(RuleFindings, ManyEqualRulesMakeOneFindingEach)
{
  RuleBase base = sevenWords();
  for (int i = 0; i < 20; ++i) base.rules.push_back(base.rules[0]);
  const auto findings = findOddities(base);
  EXPECT_EQ(findings.size(), 20U);
  for (const RuleFinding& finding : findings) EXPECT_EQ(finding.rule, 0);
}

TEST(RuleFindings, RulesThatAreOffDoNotCount)
{
  RuleBase base = sevenWords();
  base.rules[3].enabled = false;
  const auto findings = findOddities(base);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].kind, FindingKind::Uncovered);
  for (Rule& rule : base.rules) rule.enabled = false;
  ASSERT_EQ(findOddities(base).size(), 1U);
  EXPECT_EQ(findOddities(base)[0].kind, FindingKind::OutputNeverSet);
}

} // namespace
} // namespace esm::fuzzy
