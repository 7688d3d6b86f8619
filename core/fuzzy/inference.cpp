// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/fuzzy/inference.h"

#include "core/fuzzy/fuzzy_set.h"

#include <algorithm>
#include <cmath>

namespace esm::fuzzy {

namespace {

/// A degree so small that no conclusion should hang on it: the far tail of a bell would else turn an
/// output that no rule speaks of into the middle of the range.
constexpr double kLeastDegree = 1e-12;

int indexOf(const std::vector<Variable>& variables, const std::string& id)
{
  for (std::size_t i = 0; i < variables.size(); ++i)
    if (variables[i].id == id) return static_cast<int>(i);
  return -1;
}

const Term* findTerm(const Variable& variable, const std::string& id)
{
  for (const Term& term : variable.terms)
    if (term.id == id) return &term;
  return nullptr;
}

/// One input made ready: a place on the axis or a fuzzy set.
struct Fact {
  double x = 0.0;
  std::optional<HedgedTerm> word;
};

Fact makeFact(const Variable& variable, const InputValue* input)
{
  Fact fact;
  fact.x = toAxis(variable, variable.defaultValue);
  if (!input) return fact;
  if (const double* value = std::get_if<double>(input))
    fact.x = toAxis(variable, *value);
  else if (const Word* word = std::get_if<Word>(input); const Term* term = findTerm(variable, word->term))
    fact.word = HedgedTerm{term, &word->hedges};
  return fact;
}

double degreeOf(const Fact& fact, const HedgedTerm& set, const Axis& axis)
{
  return fact.word ? heightOfIntersection(*fact.word, set, axis) : set.at(fact.x);
}

/// What the rules that fired conclude about one output.
std::vector<ClippedSet> conclusions(const RuleBase& ruleBase, const std::vector<RuleFiring>& firings,
                                    const Variable& output)
{
  std::vector<ClippedSet> sets;
  for (const RuleFiring& firing : firings) {
    if (firing.degree < kLeastDegree) continue;
    for (const Proposition& consequent : ruleBase.rules[static_cast<std::size_t>(firing.rule)].consequents) {
      if (consequent.variable != output.id) continue;
      const Term* term = findTerm(output, consequent.term);
      const auto same = std::find_if(sets.begin(), sets.end(), [&](const ClippedSet& set) {
        return set.set.term == term && *set.set.hedges == consequent.hedges;
      });
      if (same != sets.end())
        same->degree = std::max(same->degree, firing.degree);
      else if (term)
        sets.push_back({{term, &consequent.hedges}, firing.degree});
    }
  }
  return sets;
}

OutputValue defuzzify(const RuleBase& ruleBase, const std::vector<RuleFiring>& firings,
                      const Variable& output)
{
  const std::vector<ClippedSet> sets = conclusions(ruleBase, firings, output);
  if (const auto centre = centroid(sets, axisOf(output))) return {fromAxis(output, *centre), true};
  return {output.defaultValue, false};
}

} // namespace

/// The rule base with every id of every condition resolved.
struct Engine::Compiled {
  struct Node {
    Condition::Kind kind = Condition::Kind::Proposition;
    int input = -1;
    HedgedTerm set;
    std::vector<int> children;
  };
  struct CompiledRule {
    int index = -1;
    double weight = 1.0;
    std::vector<Node> nodes;
  };
  RuleBase ruleBase;
  std::vector<CompiledRule> rules;

  void compile();
  double degree(const CompiledRule& rule, const std::vector<Fact>& facts) const;
};

void Engine::Compiled::compile()
{
  for (std::size_t r = 0; r < ruleBase.rules.size(); ++r) {
    const Rule& rule = ruleBase.rules[r];
    if (!rule.enabled) continue;
    CompiledRule compiled{static_cast<int>(r), rule.weight, {}};
    for (const Condition::Node& node : rule.condition.nodes) {
      Node resolved{node.kind, -1, {}, node.children};
      if (node.kind == Condition::Kind::Proposition) {
        resolved.input = indexOf(ruleBase.inputs, node.proposition.variable);
        const Variable& variable = ruleBase.inputs[static_cast<std::size_t>(resolved.input)];
        resolved.set = {findTerm(variable, node.proposition.term), &node.proposition.hedges};
      }
      compiled.nodes.push_back(std::move(resolved));
    }
    rules.push_back(std::move(compiled));
  }
}

double Engine::Compiled::degree(const CompiledRule& rule, const std::vector<Fact>& facts) const
{
  std::vector<double> degrees(rule.nodes.size());
  for (std::size_t i = rule.nodes.size(); i-- > 0;) { // children stand behind their parents
    const Node& node = rule.nodes[i];
    const auto child = [&](int index) { return degrees[static_cast<std::size_t>(index)]; };
    switch (node.kind) {
    case Condition::Kind::Proposition: {
      const auto input = static_cast<std::size_t>(node.input);
      degrees[i] = degreeOf(facts[input], node.set, axisOf(ruleBase.inputs[input]));
      break;
    }
    case Condition::Kind::And:
      degrees[i] = 1.0;
      for (const int index : node.children) degrees[i] = std::min(degrees[i], child(index));
      break;
    case Condition::Kind::Or:
      for (const int index : node.children) degrees[i] = std::max(degrees[i], child(index));
      break;
    case Condition::Kind::Not:
      degrees[i] = 1.0 - child(node.children.front());
      break;
    }
  }
  return degrees.front() * rule.weight;
}

Result<Engine> Engine::create(RuleBase ruleBase)
{
  if (Status status = checkRuleBase(ruleBase); !status) return status.error();
  auto compiled = std::make_shared<Compiled>();
  compiled->ruleBase = std::move(ruleBase);
  compiled->compile(); // after the move: the nodes refer into this copy
  return Engine(std::move(compiled));
}

const RuleBase& Engine::ruleBase() const noexcept
{
  return m_compiled->ruleBase;
}

Inference Engine::evaluate(std::span<const InputValue> inputs) const
{
  const RuleBase& rules = m_compiled->ruleBase;
  std::vector<Fact> facts;
  for (std::size_t i = 0; i < rules.inputs.size(); ++i)
    facts.push_back(makeFact(rules.inputs[i], i < inputs.size() ? &inputs[i] : nullptr));

  Inference inference;
  for (const Compiled::CompiledRule& rule : m_compiled->rules)
    inference.firings.push_back({rule.index, m_compiled->degree(rule, facts)});
  for (const Variable& output : rules.outputs)
    inference.outputs.push_back(defuzzify(rules, inference.firings, output));
  return inference;
}

std::vector<std::pair<double, double>> aggregatedSet(const RuleBase& ruleBase, const Inference& inference,
                                                     int output, int points)
{
  std::vector<std::pair<double, double>> plot;
  const Variable& variable = ruleBase.outputs[static_cast<std::size_t>(output)];
  const std::vector<ClippedSet> sets = conclusions(ruleBase, inference.firings, variable);
  const Axis axis = axisOf(variable);
  for (int i = 0; i < points; ++i) {
    const double x = axis.low + (axis.high - axis.low) * i / std::max(points - 1, 1);
    double height = 0.0;
    for (const ClippedSet& set : sets) height = std::max(height, set.at(x));
    plot.emplace_back(fromAxis(variable, x), height);
  }
  return plot;
}

} // namespace esm::fuzzy
