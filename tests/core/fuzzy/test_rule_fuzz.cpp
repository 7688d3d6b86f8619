// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "tests/core/fuzzy/small_rules.h"

#include <random>

namespace esm::fuzzy {
namespace {

/// Random rules and random damage to their texts; fixed seed, so that a failure repeats.
class Chance {
public:
  explicit Chance(unsigned seed) : m_random(seed) {}
  int below(int count) { return std::uniform_int_distribution(0, count - 1)(m_random); }
  bool oneIn(int count) { return below(count) == 0; }

  Proposition proposition(const std::vector<Variable>& variables, bool mayNegate)
  {
    const Variable& variable = variables[static_cast<std::size_t>(below(static_cast<int>(variables.size())))];
    const int term = below(static_cast<int>(variable.terms.size()));
    Proposition result{variable.id, variable.terms[static_cast<std::size_t>(term)].id, {}};
    for (int i = oneIn(2) ? below(4) : 0; i > 0; --i)
      result.hedges.push_back(static_cast<Hedge>(mayNegate ? below(4) : 1 + below(3)));
    return result;
  }

  /// Appends a random subtree, parents first; returns its place.
  int condition(const RuleBase& base, Condition& condition, int depth)
  {
    const auto place = condition.nodes.size();
    condition.nodes.emplace_back();
    auto kind = static_cast<Condition::Kind>(below(4));
    if (depth == 0) kind = Condition::Kind::Proposition;
    condition.nodes[place].kind = kind;
    if (kind == Condition::Kind::Proposition)
      condition.nodes[place].proposition = proposition(base.inputs, true);
    else
      for (int i = kind == Condition::Kind::Not ? 1 : 2 + below(3); i > 0; --i) {
        const int child = this->condition(base, condition, depth - 1);
        condition.nodes[place].children.push_back(child);
      }
    return static_cast<int>(place);
  }

  Rule rule(const RuleBase& base)
  {
    Rule result;
    condition(base, result.condition, 4);
    for (int i = 1 + below(3); i > 0; --i) result.consequents.push_back(proposition(base.outputs, false));
    if (oneIn(2)) result.weight = std::uniform_real_distribution(0.0, 1.0)(m_random);
    return result;
  }

  std::string damaged(std::string text)
  {
    static const std::vector<std::string> kPieces = {"(",      ")",     "\"", "IF ",  " THEN ", " AND ",
                                                     " NOT ",  " IS ",  "ß",  "\xC3", "\xFF",   "\n",
                                                     " WITH ", "1e999", ",",  "Ä"};
    for (int i = 1 + below(3); i > 0; --i) {
      const auto at = static_cast<std::size_t>(below(static_cast<int>(text.size()) + 1));
      switch (below(4)) {
      case 0:
        text.erase(at, 1 + static_cast<std::size_t>(below(10)));
        break;
      case 1:
        text.insert(at, kPieces[static_cast<std::size_t>(below(static_cast<int>(kPieces.size())))]);
        break;
      case 2:
        text.insert(at, 1, static_cast<char>(below(256)));
        break;
      default:
        text += text.substr(at);
        break;
      }
    }
    return text;
  }

private:
  std::mt19937 m_random;
};

/// Names made to be confused: like keywords, like hedges, with marks, with each other's ids, empty.
RuleBase nastyRules()
{
  RuleBase base = smallRules();
  const auto name = [](Variable& variable, std::size_t term, Names names) {
    variable.terms[term].name = std::move(names);
  };
  base.inputs[0].name = {"IF THEN", "elasticity"};
  base.inputs[1].name = {"hardness", ""};
  name(base.inputs[0], 0, {"very", "sehr sehr"});
  name(base.inputs[0], 1, {"very hard", "not"});
  name(base.inputs[0], 2, {"hard", "a (b)"});
  name(base.inputs[1], 0, {"a \"quoted\" name", "two\nlines"});
  name(base.inputs[1], 1, {"high, low.", "   "});
  name(base.outputs[0], 0, {"high", "high"});
  base.outputs[1].name = {"stiffness", "shift ability"};
  return base;
}

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

// Any text gives a rule that the checker accepts, or one error inside the text; never a crash.
TEST(RuleTextFuzz, DamagedTextsGiveARuleOrAnErrorInsideTheText)
{
  for (const RuleBase& base : {smallRules(), nastyRules()}) {
    Chance chance(3);
    int rules = 0;
    for (int i = 0; i < 700; ++i) {
      const auto language = chance.oneIn(2) ? Language::English : Language::German;
      const std::string text = chance.damaged(formatRule(chance.rule(base), base, language));
      const auto parsed = parseRule(text, base);
      if (const Rule* read = std::get_if<Rule>(&parsed)) {
        RuleBase with = base;
        with.rules = {*read};
        const Status status = checkRuleBase(with);
        EXPECT_TRUE(status) << text << ": " << status.error().detail;
        ++rules;
        continue;
      }
      const auto& error = std::get<RuleTextError>(parsed);
      EXPECT_LE(error.offset + error.length, text.size()) << text;
      EXPECT_FALSE(error.message.empty()) << text;
    }
    EXPECT_GT(rules, 10) << "the damage should leave some rules whole";
  }
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
