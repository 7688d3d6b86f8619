// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "tests/core/fuzzy/small_rules.h"

#include <cmath>
#include <functional>

namespace esm::fuzzy {
namespace {

struct Fault {
  const char* expected; ///< part of the message
  std::function<void(RuleBase&)> make;
};

RuleBase soundRules()
{
  RuleBase base = smallRules();
  base.rules.push_back(rule(base, "IF hardness IS hard AND NOT shift IS free THEN stiffness IS high"));
  return base;
}

TEST(RuleCheck, SoundRulesPass)
{
  EXPECT_TRUE(checkRuleBase(soundRules()));
}

// Every fault is refused, and the message names the culprit.
TEST(RuleCheck, NamesTheCulprit)
{
  const double nan = std::nan("");
  const Fault faults[] = {
    {"variable 'hardness' occurs twice", [](RuleBase& b) { b.outputs[0].id = "hardness"; }},
    {"variable 'Hardness' occurs twice", [](RuleBase& b) { b.inputs[1].id = "Hardness"; }},
    {"an id needs letters", [](RuleBase& b) { b.inputs[0].id.clear(); }},
    {"an id needs letters", [](RuleBase& b) { b.inputs[0].terms[0].id = "so\"ft"; }},
    {"term 'soft' of variable 'hardness' occurs twice",
     [](RuleBase& b) { b.inputs[0].terms[1].id = "soft"; }},
    {"needs 3 numbers", [](RuleBase& b) { b.inputs[0].terms[0].parameters.pop_back(); }},
    {"corners must not fall", [](RuleBase& b) { b.inputs[0].terms[0].parameters[1] = 2.0; }},
    {"not a usable number", [nan](RuleBase& b) { b.inputs[0].terms[0].parameters[1] = nan; }},
    {"only the outer corners", [](RuleBase& b) { b.inputs[0].terms[0].parameters[1] = kInfinity; }},
    {"deviation",
     [](RuleBase& b) {
       b.inputs[0].terms[0] = makeTerm("soft", Shape::Gaussian, {0.0, 0.0});
     }},
    {"needs 2 numbers", [](RuleBase& b) { b.inputs[0].terms[0].shape = Shape::Gaussian; }},
    {"range", [](RuleBase& b) { b.inputs[0].maximum = 0.0; }},
    {"range", [nan](RuleBase& b) { b.inputs[0].minimum = nan; }},
    {"must start above 0", [](RuleBase& b) { b.outputs[0].logarithmic = true; }},
    {"default", [](RuleBase& b) { b.outputs[0].defaultValue = 1.5; }},
    {"no width",
     [](RuleBase& b) {
       b.outputs[0].terms[0].parameters = {0.5, 0.5, 0.5};
     }},
    {"no width",
     [](RuleBase& b) {
       b.outputs[0].terms[0].parameters = {5, 6, 7};
     }},
    {"rule 1: term 'hrad' is unknown",
     [](RuleBase& b) { b.rules[0].condition.nodes[1].proposition.term = "hrad"; }},
    {"rule 1: input 'stiffness'",
     [](RuleBase& b) { b.rules[0].condition.nodes[1].proposition.variable = "stiffness"; }},
    {"rule 1: output 'hardness'", [](RuleBase& b) { b.rules[0].consequents[0].variable = "hardness"; }},
    {"cannot be negated", [](RuleBase& b) { b.rules[0].consequents[0].hedges = {Hedge::Not}; }},
    {"no conclusion", [](RuleBase& b) { b.rules[0].consequents.clear(); }},
    {"no condition", [](RuleBase& b) { b.rules[0].condition.nodes.clear(); }},
    {"weight", [](RuleBase& b) { b.rules[0].weight = 1.01; }},
    {"weight", [nan](RuleBase& b) { b.rules[0].weight = nan; }},
    {"misplaced", [](RuleBase& b) { b.rules[0].condition.nodes[0].children.pop_back(); }},
    {"impossible child 99", [](RuleBase& b) { b.rules[0].condition.nodes[0].children[0] = 99; }},
    {"impossible child 0", [](RuleBase& b) { b.rules[0].condition.nodes[0].children[0] = 0; }},
    {"impossible child 2",
     [](RuleBase& b) {
       b.rules[0].condition.nodes[0].children = {2, 2};
     }},
  };
  for (const Fault& fault : faults) {
    RuleBase base = soundRules();
    fault.make(base);
    const Status status = checkRuleBase(base);
    ASSERT_FALSE(status) << fault.expected;
    EXPECT_EQ(status.error().code, ErrorCode::InvalidValue);
    EXPECT_NE(status.error().detail.find(fault.expected), std::string::npos) << status.error().detail;
    EXPECT_FALSE(Engine::create(base));
  }
}

TEST(RuleCheck, BoundsTheDepthOfConditions)
{
  RuleBase base = soundRules();
  const auto nest = [&base](int depth) {
    Condition condition;
    for (int i = 1; i < depth; ++i) condition.nodes.push_back({Condition::Kind::Not, {}, {i}});
    condition.nodes.push_back({Condition::Kind::Proposition, {"hardness", "hard", {}}, {}});
    base.rules[0].condition = condition;
    return checkRuleBase(base).hasValue();
  };
  EXPECT_TRUE(nest(kMaximumConditionDepth));
  EXPECT_FALSE(nest(kMaximumConditionDepth + 1));
}

} // namespace
} // namespace esm::fuzzy
