// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "tests/core/fuzzy/rule_mutations.h"

namespace esm::fuzzy {
namespace {

void expectRoundTrip(const RuleBase& base, unsigned seed)
{
  ASSERT_TRUE(checkRuleBase(base));
  Chance chance(seed);
  for (int i = 0; i < 150; ++i) {
    const Rule original = chance.rule(base);
    for (const Language language : {Language::English, Language::German}) {
      const std::string text = formatRule(original, base, language);
      EXPECT_EQ(text.find('\n'), std::string::npos);
      const auto parsed = parseRule(text, base);
      const Rule* read = std::get_if<Rule>(&parsed);
      ASSERT_TRUE(read && *read == original) << text << (read ? "" : ": " + std::get<1>(parsed).message);
    }
  }
}

TEST(RuleTextRoundTrip, ReadsBackWhatItWrites)
{
  expectRoundTrip(smallRules(), 1);
}
TEST(RuleTextRoundTrip, HoldsForConfusingNames)
{
  expectRoundTrip(nastyRules(), 2);
}

TEST(RuleTextFuzz, DamagedTextsGiveARuleOrAnErrorInsideTheText)
{
  feedDamagedRules(1400);
}

TEST(RuleTextFuzz, RandomBytesGiveAnError)
{
  const RuleBase base = smallRules();
  Chance chance(4);
  for (int i = 0; i < 1000; ++i) {
    std::string text(static_cast<std::size_t>(chance.below(200)), ' ');
    for (char& c : text) c = static_cast<char>(chance.below(256));
    EXPECT_TRUE(std::holds_alternative<RuleTextError>(parseRule(text, base)));
    parseInput(text, base.inputs[0]);
    parseRules(text, base);
  }
}

TEST(RuleTextFuzz, DeepAndLongTextsEnd)
{
  const RuleBase base = smallRules();
  const std::string tail = "hardness IS hard THEN depth IS small";
  const std::string deep = "IF " + std::string(100000, '(') + tail;
  auto parsed = parseRule(deep, base);
  EXPECT_EQ(std::get<RuleTextError>(parsed).kind, RuleTextError::Kind::UnbalancedParenthesis);
  std::string nots = "IF ", hedges = "IF hardness IS ", chain = "IF ";
  for (int i = 0; i < 5000; ++i) {
    nots += "NOT ";
    hedges += "very ";
    chain += "hardness IS hard AND ";
  }
  EXPECT_TRUE(std::holds_alternative<RuleTextError>(parseRule(nots + tail, base)));
  EXPECT_TRUE(std::holds_alternative<Rule>(parseRule(hedges + "hard THEN depth IS small", base)));
  EXPECT_TRUE(std::holds_alternative<Rule>(parseRule(chain + tail, base)));
  EXPECT_TRUE(std::holds_alternative<RuleTextError>(parseRule("IF " + std::string(1000000, 'x'), base)));
}

TEST(RuleTextRoundTrip, ReachesTheDepthThatTheCheckerAllows)
{
  RuleBase base = smallRules();
  Rule deep = rule(base, "IF hardness IS hard THEN depth IS small");
  const Condition::Node leaf = deep.condition.nodes[0];
  deep.condition.nodes.clear();
  for (int i = 1; i < kMaximumConditionDepth; ++i) { // AND within OR within AND ...
    const int place = static_cast<int>(deep.condition.nodes.size());
    const auto kind = i % 2 ? Condition::Kind::And : Condition::Kind::Or;
    deep.condition.nodes.push_back({kind, {}, {place + 1, place + 2}});
    deep.condition.nodes.push_back(leaf);
  }
  deep.condition.nodes.push_back(leaf);
  base.rules = {deep};
  ASSERT_TRUE(checkRuleBase(base));
  EXPECT_EQ(rule(base, formatRule(deep, base, Language::German)), deep);
}

} // namespace
} // namespace esm::fuzzy
