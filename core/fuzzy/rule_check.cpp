// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/base/text_number.h"
#include "core/fuzzy/axis.h"
#include "core/fuzzy/rule_base.h"
#include "core/fuzzy/words.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace esm::fuzzy {

namespace {

/// Beyond this, differences and squares of numbers may overflow.
constexpr double kLargestNumber = 1e100;
/// An output term narrower than this share of the range has no area to speak of.
constexpr double kLeastShare = 1e-9;

/// Ids stand in files and, quoted, in rule texts: no blanks at the ends, no quotes, nothing invisible.
bool isUsableId(const std::string& id)
{
  if (id.empty() || id.front() == ' ' || id.back() == ' ') return false;
  return std::none_of(id.begin(), id.end(),
                      [](char c) { return c == '"' || (static_cast<unsigned char>(c) < 0x20) || c == 0x7f; });
}

bool isReasonable(double x)
{
  return std::abs(x) <= kLargestNumber;
} // false for NaN

Status checkCorners(const Term& term, const std::string& where)
{
  const std::vector<double>& p = term.parameters;
  const bool triangle = term.shape == Shape::Triangle;
  if (p.size() != (triangle ? 3U : 4U))
    return invalidValue(where + (triangle ? " needs 3 numbers a b c" : " needs 4 numbers a b c d") +
                        ", it has " + std::to_string(p.size()));
  for (std::size_t i = 0; i < p.size(); ++i) {
    const bool shoulder = (i == 0 && p[i] == -HUGE_VAL) || (i + 1 == p.size() && p[i] == HUGE_VAL);
    if (!shoulder && !isReasonable(p[i]))
      return invalidValue(where + ": corner " + formatDouble(p[i]) +
                          " is not a usable number; only the outer corners may be infinite");
    if (i > 0 && p[i] < p[i - 1])
      return invalidValue(where + ": corners must not fall, but " + formatDouble(p[i - 1]) +
                          " stands before " + formatDouble(p[i]));
  }
  return {};
}

Status checkTerm(const Term& term, const std::string& where)
{
  if (term.shape != Shape::Gaussian) return checkCorners(term, where);
  if (term.parameters.size() != 2)
    return invalidValue(where + " needs 2 numbers, mean and deviation, it has " +
                        std::to_string(term.parameters.size()));
  if (!isReasonable(term.parameters[0]) || !isReasonable(term.parameters[1]) ||
      !(term.parameters[1] > 1e-100))
    return invalidValue(where + ": mean " + formatDouble(term.parameters[0]) + " and deviation " +
                        formatDouble(term.parameters[1]) + " must be finite, the deviation above 0");
  return {};
}

/// A conclusion is a set with an area, or it has no centre.
Status checkOutputTerm(const Term& term, const Axis& axis, const std::string& where)
{
  const std::vector<double>& p = term.parameters;
  double from = p.front(), to = p.back();
  if (term.shape == Shape::Gaussian) {
    from = p[0] - 5.0 * p[1];
    to = p[0] + 5.0 * p[1];
  }
  const double width = std::min(to, axis.high) - std::max(from, axis.low);
  if (!(width > kLeastShare * (axis.high - axis.low)))
    return invalidValue(where +
                        " has no width within the range of its variable, so that it cannot be a conclusion");
  return {};
}

Status checkVariable(const Variable& variable, bool isOutput)
{
  const std::string where = "variable '" + variable.id + "'";
  if (!isUsableId(variable.id))
    return invalidValue(where + ": an id needs letters, without quotes or control characters");
  if (!isReasonable(variable.minimum) || !isReasonable(variable.maximum) ||
      !(variable.maximum > variable.minimum))
    return invalidValue(where + ": the range " + formatDouble(variable.minimum) + " to " +
                        formatDouble(variable.maximum) + " is empty or not finite");
  if (variable.logarithmic && !(variable.minimum >= 1e-100))
    return invalidValue(where + ": a logarithmic range must start above 0, not at " +
                        formatDouble(variable.minimum));
  if (!(variable.defaultValue >= variable.minimum && variable.defaultValue <= variable.maximum))
    return invalidValue(where + ": the default " + formatDouble(variable.defaultValue) +
                        " is outside the range " + formatDouble(variable.minimum) + " to " +
                        formatDouble(variable.maximum));
  const Axis axis = axisOf(variable);
  if (!(axis.high > axis.low)) return invalidValue(where + ": the range is too narrow");

  std::set<std::string> ids;
  for (const Term& term : variable.terms) {
    const std::string termWhere = "term '" + term.id + "' of " + where;
    if (!isUsableId(term.id))
      return invalidValue(termWhere + ": an id needs letters, without quotes or control characters");
    if (!ids.insert(foldCase(term.id)).second) return invalidValue(termWhere + " occurs twice");
    if (Status status = checkTerm(term, termWhere); !status) return status;
    if (!isOutput) continue;
    if (Status status = checkOutputTerm(term, axis, termWhere); !status) return status;
  }
  return {};
}

Status checkProposition(const Proposition& proposition, const Variable* variable, const std::string& where,
                        const char* role)
{
  if (!variable) return invalidValue(where + ": " + role + " '" + proposition.variable + "' is unknown");
  const bool known = std::any_of(variable->terms.begin(), variable->terms.end(),
                                 [&](const Term& term) { return term.id == proposition.term; });
  if (!known)
    return invalidValue(where + ": term '" + proposition.term + "' is unknown to variable '" + variable->id +
                        "'");
  return {};
}

/// Each node but the root has exactly one parent, which stands before it.
Status checkTree(const Condition& condition, const std::string& where)
{
  const auto count = condition.nodes.size();
  if (count == 0) return invalidValue(where + " has no condition");
  std::vector<int> depth(count, 0); // 0: no parent met yet
  depth[0] = 1;
  for (std::size_t i = 0; i < count; ++i) {
    const Condition::Node& node = condition.nodes[i];
    const std::size_t children = node.children.size();
    const bool fits = node.kind == Condition::Kind::Proposition ? children == 0
                      : node.kind == Condition::Kind::Not       ? children == 1
                                                                : children >= 2;
    if (!fits || depth[i] == 0 || depth[i] > kMaximumConditionDepth)
      return invalidValue(where + ": node " + std::to_string(i) + " of the condition is misplaced");
    for (const int child : node.children) {
      if (child <= static_cast<int>(i) || child >= static_cast<int>(count) ||
          depth[static_cast<std::size_t>(child)] != 0)
        return invalidValue(where + ": node " + std::to_string(i) +
                            " of the condition has an impossible child " + std::to_string(child));
      depth[static_cast<std::size_t>(child)] = depth[i] + 1;
    }
  }
  return {};
}

Status checkRule(const Rule& rule, const RuleBase& ruleBase, const std::string& where)
{
  if (Status status = checkTree(rule.condition, where); !status) return status;
  for (const Condition::Node& node : rule.condition.nodes) {
    if (node.kind != Condition::Kind::Proposition) continue;
    const Variable* variable = ruleBase.findInput(node.proposition.variable);
    if (Status status = checkProposition(node.proposition, variable, where, "input"); !status) return status;
  }
  if (rule.consequents.empty()) return invalidValue(where + " has no conclusion");
  for (const Proposition& consequent : rule.consequents) {
    const Variable* variable = ruleBase.findOutput(consequent.variable);
    if (Status status = checkProposition(consequent, variable, where, "output"); !status) return status;
    if (std::find(consequent.hedges.begin(), consequent.hedges.end(), Hedge::Not) != consequent.hedges.end())
      return invalidValue(where + ": a conclusion cannot be negated");
  }
  if (!(rule.weight >= 0.0 && rule.weight <= 1.0))
    return invalidValue(where + ": the weight " + formatDouble(rule.weight) + " is outside 0 to 1");
  return {};
}

} // namespace

Status checkRuleBase(const RuleBase& ruleBase)
{
  std::set<std::string> ids;
  for (const auto* variables : {&ruleBase.inputs, &ruleBase.outputs})
    for (const Variable& variable : *variables) {
      if (Status status = checkVariable(variable, variables == &ruleBase.outputs); !status) return status;
      if (!ids.insert(foldCase(variable.id)).second)
        return invalidValue("variable '" + variable.id + "' occurs twice");
    }
  for (std::size_t i = 0; i < ruleBase.rules.size(); ++i)
    if (Status status = checkRule(ruleBase.rules[i], ruleBase, "rule " + std::to_string(i + 1)); !status)
      return status;
  return {};
}

} // namespace esm::fuzzy
