// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

// Random rules, and random damage to their texts.
#include "tests/core/fuzzy/small_rules.h"

#include <random>

namespace esm::fuzzy {

/// Fixed seed, so that a failure repeats.
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
inline RuleBase nastyRules()
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

/// Any text gives a rule that the checker accepts, or one error inside the text; never a crash.
inline void feedDamagedRules(int count)
{
  for (const RuleBase& base : {smallRules(), nastyRules()}) {
    Chance chance(3);
    int rules = 0;
    for (int i = 0; i < count / 2; ++i) {
      const auto language = chance.oneIn(2) ? Language::English : Language::German;
      const std::string text = chance.damaged(formatRule(chance.rule(base), base, language));
      const auto parsed = parseRule(text, base);
      if (const Rule* read = std::get_if<Rule>(&parsed)) {
        RuleBase with = base;
        with.rules = {*read};
        const Status status = checkRuleBase(with);
        ASSERT_TRUE(status) << text << ": " << status.error().detail;
        ++rules;
        continue;
      }
      const auto& error = std::get<RuleTextError>(parsed);
      ASSERT_LE(error.offset + error.length, text.size()) << text;
      ASSERT_FALSE(error.message.empty()) << text;
    }
    EXPECT_GT(rules, 10) << "the damage should leave some rules whole";
  }
}

} // namespace esm::fuzzy
