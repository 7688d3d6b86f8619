// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/fuzzy/to_system.h"

#include "core/fuzzy/axis.h"

#include <algorithm>
#include <set>

namespace esm::fuzzy {

namespace {

/// The ids as names for a fis::System: usable, distinct.
class Naming {
public:
  std::string nameOf(const std::string& id, const char* kind)
  {
    std::string name = fis::isUsableName(id) ? id : kind + std::to_string(m_taken.size() + 1);
    while (!m_taken.insert(name).second) name += '_';
    return name;
  }

private:
  std::set<std::string> m_taken;
};

template <class Place>
void fillVariable(const Variable& variable, Naming& names, Place& place)
{
  const Axis axis = axisOf(variable);
  place.name = names.nameOf(variable.id, "variable");
  place.minimum = axis.low;
  place.maximum = axis.high;
  place.lockRange = true;
  Naming termNames;
  for (const Term& term : variable.terms) {
    place.terms.push_back(toTerm(term));
    place.terms.back().name = termNames.nameOf(term.id, "term");
  }
}

template <class Named>
int placeOf(const std::vector<Named>& things, const std::string& id)
{
  const auto found =
    std::find_if(things.begin(), things.end(), [&](const Named& thing) { return thing.id == id; });
  return static_cast<int>(found - things.begin());
}

fis::Proposition toProposition(const Proposition& proposition, const std::vector<Variable>& variables,
                               bool onOutput)
{
  fis::Proposition result;
  result.onOutput = onOutput;
  result.variable = placeOf(variables, proposition.variable);
  result.term = placeOf(variables[static_cast<std::size_t>(result.variable)].terms, proposition.term);
  result.hedges = toHedges(proposition.hedges);
  return result;
}

fis::Rule toRule(const Rule& rule, const RuleBase& ruleBase)
{
  fis::Rule result;
  result.weight = rule.weight;
  result.enabled = rule.enabled;
  for (const Condition::Node& node : rule.condition.nodes) {
    fis::Antecedent::Node target;
    target.kind = static_cast<fis::Antecedent::Kind>(node.kind);
    target.children = node.children;
    if (node.kind == Condition::Kind::Proposition)
      target.proposition = toProposition(node.proposition, ruleBase.inputs, false);
    result.antecedent.nodes.push_back(std::move(target));
  }
  for (const Proposition& consequent : rule.consequents)
    result.consequents.push_back(toProposition(consequent, ruleBase.outputs, true));
  return result;
}

} // namespace

fis::Shape toShape(Shape shape) noexcept
{
  return shape == Shape::Triangle    ? fis::Shape::Triangle
         : shape == Shape::Trapezoid ? fis::Shape::Trapezoid
                                     : fis::Shape::Gaussian;
}

fis::Hedge toHedge(Hedge hedge) noexcept
{
  switch (hedge) {
  case Hedge::Not:
    return fis::Hedge::Not;
  case Hedge::Very:
    return fis::Hedge::Very;
  case Hedge::Extremely:
    return fis::Hedge::Cubed;
  case Hedge::Somewhat:
    break;
  }
  return fis::Hedge::Somewhat;
}

std::vector<fis::Hedge> toHedges(const std::vector<Hedge>& hedges)
{
  std::vector<fis::Hedge> result;
  for (const Hedge hedge : hedges) result.push_back(toHedge(hedge));
  return result;
}

fis::Term toTerm(const Term& term)
{
  fis::Term result;
  result.shape = toShape(term.shape);
  result.parameters = term.parameters;
  return result;
}

fis::System toSystem(const RuleBase& ruleBase)
{
  fis::System system;
  Naming names;
  for (const Variable& variable : ruleBase.inputs)
    fillVariable(variable, names, system.inputs.emplace_back());
  for (const Variable& variable : ruleBase.outputs) {
    fillVariable(variable, names, system.outputs.emplace_back());
    system.outputs.back().defaultValue = toAxis(variable, variable.defaultValue);
  }
  fis::RuleBlock& block = system.blocks.emplace_back();
  block.conclusionHedges = fis::ConclusionHedges::OnSet;
  for (const Rule& rule : ruleBase.rules) block.rules.push_back(toRule(rule, ruleBase));
  return system;
}

} // namespace esm::fuzzy
