// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/fuzzy/fis/system.h"

#include "core/base/text_number.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace esm::fis {

namespace {

bool same(double a, double b)
{
  return a == b || (std::isnan(a) && std::isnan(b));
}

bool isNameByte(char c)
{
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '.' ||
         static_cast<unsigned char>(c) >= 0x80;
}

bool isReserved(std::string_view name)
{
  for (const std::string_view word : {"if", "then", "is", "and", "or", "with"})
    if (name == word) return true;
  return hedgeNamed(name).has_value();
}

bool hasHedge(const Proposition& proposition, Hedge hedge)
{
  return std::find(proposition.hedges.begin(), proposition.hedges.end(), hedge) != proposition.hedges.end();
}

} // namespace

bool operator==(const InputVariable& a, const InputVariable& b)
{
  return a.name == b.name && a.description == b.description && a.enabled == b.enabled &&
         same(a.minimum, b.minimum) && same(a.maximum, b.maximum) && a.lockRange == b.lockRange &&
         a.terms == b.terms;
}

bool operator==(const OutputVariable& a, const OutputVariable& b)
{
  return a.name == b.name && a.description == b.description && a.enabled == b.enabled &&
         same(a.minimum, b.minimum) && same(a.maximum, b.maximum) && a.lockRange == b.lockRange &&
         a.lockPrevious == b.lockPrevious && same(a.defaultValue, b.defaultValue) &&
         a.aggregation == b.aggregation && a.defuzzifier == b.defuzzifier && a.resolution == b.resolution &&
         a.weightedType == b.weightedType && a.joinsEqualTerms == b.joinsEqualTerms && a.terms == b.terms;
}

bool operator==(const RuleBlock& a, const RuleBlock& b)
{
  return a.name == b.name && a.description == b.description && a.enabled == b.enabled &&
         a.conjunction == b.conjunction && a.disjunction == b.disjunction && a.implication == b.implication &&
         a.activation == b.activation && a.conclusionHedges == b.conclusionHedges && a.rules == b.rules;
}

bool operator==(const System& a, const System& b)
{
  return a.name == b.name && a.description == b.description && a.inputs == b.inputs &&
         a.outputs == b.outputs && a.blocks == b.blocks;
}

bool isUsableName(std::string_view name) noexcept
{
  return !name.empty() && std::all_of(name.begin(), name.end(), isNameByte) && !isReserved(name);
}

std::string usableName(std::string_view name)
{
  std::string usable;
  std::copy_if(name.begin(), name.end(), std::back_inserter(usable), isNameByte);
  if (usable.empty()) return "unnamed";
  return isReserved(usable) ? usable + '_' : usable;
}

bool isWeighted(Defuzzifier defuzzifier) noexcept
{
  return defuzzifier == Defuzzifier::WeightedAverage || defuzzifier == Defuzzifier::WeightedSum;
}
bool isArea(Defuzzifier defuzzifier) noexcept
{
  return defuzzifier != Defuzzifier::None && !isWeighted(defuzzifier);
}

std::vector<std::string> formulaNames(const System& system, std::size_t output)
{
  std::vector<std::string> names = {"x"};
  const auto add = [&](const std::string& name, const char* role) {
    names.push_back(name == "x" ? std::string(role) + name : name);
  };
  for (const InputVariable& input : system.inputs) add(input.name, "input.");
  for (std::size_t i = 0; i < std::min(output, system.outputs.size()); ++i)
    add(system.outputs[i].name, "output.");
  return names;
}

SystemKind kindOf(const System& system) noexcept
{
  std::optional<SystemKind> common;
  const auto add = [&](SystemKind kind) { common = !common || *common == kind ? kind : SystemKind::Hybrid; };
  bool product = !system.blocks.empty();
  for (const RuleBlock& block : system.blocks)
    product = product && block.implication == TNorm::AlgebraicProduct;
  for (const OutputVariable& output : system.outputs) {
    if (isArea(output.defuzzifier)) {
      add(product ? SystemKind::Larsen : SystemKind::Mamdani);
      continue;
    }
    if (!isWeighted(output.defuzzifier) || output.terms.empty()) return SystemKind::Unknown;
    const bool numbers = std::all_of(output.terms.begin(), output.terms.end(),
                                     [](const Term& term) { return isNumber(term.shape); });
    const bool monotone = std::all_of(output.terms.begin(), output.terms.end(),
                                      [](const Term& term) { return isMonotone(term.shape); });
    if (numbers)
      add(SystemKind::TakagiSugeno);
    else if (monotone && output.weightedType != WeightedType::TakagiSugeno)
      add(SystemKind::Tsukamoto);
    else
      add(SystemKind::InverseTsukamoto);
  }
  return common.value_or(SystemKind::Unknown);
}

std::string_view nameOf(SystemKind kind) noexcept
{
  constexpr std::array<std::string_view, 7> kNames = {
    "Mamdani", "Larsen", "Takagi-Sugeno", "Tsukamoto", "inverse Tsukamoto", "hybrid", "unknown"};
  return kNames[static_cast<std::size_t>(kind)];
}

namespace {

std::string propositionText(const System& system, const Proposition& proposition)
{
  const auto place = static_cast<std::size_t>(proposition.variable);
  const std::string& variable = proposition.onOutput ? system.outputs[place].name : system.inputs[place].name;
  const auto& terms = proposition.onOutput ? system.outputs[place].terms : system.inputs[place].terms;
  std::string text = variable + " is";
  for (const Hedge hedge : proposition.hedges) text += ' ' + std::string(nameOf(hedge));
  if (proposition.term >= 0) text += ' ' + terms[static_cast<std::size_t>(proposition.term)].name;
  return text;
}

std::string antecedentText(const System& system, const Antecedent& antecedent, int index)
{
  using Kind = Antecedent::Kind;
  const Antecedent::Node& node = antecedent.nodes[static_cast<std::size_t>(index)];
  if (node.kind == Kind::Proposition) return propositionText(system, node.proposition);
  std::string text;
  for (std::size_t i = 0; i < node.children.size(); ++i) {
    const auto child = antecedent.nodes[static_cast<std::size_t>(node.children[i])].kind;
    if (node.kind == Kind::Not)
      text += "not ";
    else if (i > 0)
      text += node.kind == Kind::And ? " and " : " or ";
    const bool group = node.kind == Kind::Not  ? child != Kind::Not
                       : node.kind == Kind::Or ? child == Kind::Or
                                               : child == Kind::And || child == Kind::Or;
    const std::string part = antecedentText(system, antecedent, node.children[i]);
    text += group ? '(' + part + ')' : part;
  }
  return text;
}

} // namespace

std::string ruleText(const System& system, const Rule& rule)
{
  std::string text = "if " + antecedentText(system, rule.antecedent, 0) + " then ";
  for (std::size_t i = 0; i < rule.consequents.size(); ++i)
    text += (i == 0 ? "" : " and ") + propositionText(system, rule.consequents[i]);
  if (rule.weight != 1.0) text += " with " + formatDouble(rule.weight);
  return text;
}

namespace {

bool isOneLine(const std::string& text)
{
  return std::none_of(text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r' || c == '#'; }) &&
         (text.empty() ||
          (static_cast<unsigned char>(text.front()) > ' ' && static_cast<unsigned char>(text.back()) > ' '));
}

class SystemChecker {
public:
  explicit SystemChecker(const System& system) : m_system(system) {}

  Status check()
  {
    if (!isOneLine(m_system.name) || !isOneLine(m_system.description))
      return invalidValue("the name or description of the system is not one plain line of text");
    std::set<std::string> names;
    for (const InputVariable& input : m_system.inputs) {
      if (Status status = checkVariable(input, "input", names); !status) return status;
      for (const Term& term : input.terms)
        if (term.shape == Shape::Linear || term.shape == Shape::Function)
          if (Status status = checkFormula(term, 0, where(term, "input", input.name)); !status) return status;
    }
    for (std::size_t i = 0; i < m_system.outputs.size(); ++i) {
      const OutputVariable& output = m_system.outputs[i];
      if (Status status = checkVariable(output, "output", names); !status) return status;
      if (output.resolution < 1 || output.resolution > 1000000)
        return invalidValue("output '" + output.name + "': the resolution " +
                            std::to_string(output.resolution) + " is outside 1 to 1000000");
      if (output.joinsEqualTerms && !output.aggregation)
        return invalidValue("output '" + output.name +
                            "': equal terms are joined, but it has no aggregation");
      for (const Term& term : output.terms)
        if (Status status = checkFormula(term, i, where(term, "output", output.name)); !status) return status;
    }
    for (const RuleBlock& block : m_system.blocks)
      if (Status status = checkBlock(block); !status) return status;
    return {};
  }

private:
  static std::string where(const Term& term, const char* role, const std::string& variable)
  {
    return "term '" + term.name + "' of " + role + " '" + variable + "'";
  }

  template <class Variable>
  Status checkVariable(const Variable& variable, const char* role, std::set<std::string>& names)
  {
    const std::string place = std::string(role) + " '" + variable.name + "'";
    if (!isUsableName(variable.name))
      return invalidValue(place + ": a name is one word of letters, digits, _ and ., and no keyword");
    if (!names.insert(variable.name).second) return invalidValue(place + ": the name is taken");
    if (!isOneLine(variable.description))
      return invalidValue(place + ": the description is not one plain line of text");
    if (!(variable.maximum >= variable.minimum))
      return invalidValue(place + ": the range " + formatDouble(variable.minimum) + " to " +
                          formatDouble(variable.maximum) + " is empty");
    std::set<std::string_view> termNames;
    for (const Term& term : variable.terms) {
      if (!isUsableName(term.name))
        return invalidValue(where(term, role, variable.name) +
                            ": a name is one word of letters, digits, _ and ., and no keyword");
      if (!termNames.insert(term.name).second)
        return invalidValue(where(term, role, variable.name) + " occurs twice");
      if (const Status status = checkTerm(term); !status)
        return invalidValue(where(term, role, variable.name) + ": " + status.error().detail);
    }
    return {};
  }

  Status checkFormula(const Term& term, std::size_t output, const std::string& place) const
  {
    if (term.shape != Shape::Function) return {};
    if (!isOneLine(term.formula)) return invalidValue(place + ": the formula is not one plain line of text");
    const auto names = formulaNames(m_system, output);
    const auto parsed = Formula::parse(term.formula, names);
    if (const auto* error = std::get_if<FormulaError>(&parsed))
      return invalidValue(place + ": " + error->message);
    return {};
  }

  Status checkBlock(const RuleBlock& block) const
  {
    const std::string place = "block '" + block.name + "'";
    if (!isOneLine(block.name) || !isOneLine(block.description))
      return invalidValue(place + ": the name or description is not one plain line of text");
    if (block.activation.count < 0 || !std::isfinite(block.activation.threshold))
      return invalidValue(place + ": the activation needs a count from 0 on and a finite threshold");
    for (std::size_t i = 0; i < block.rules.size(); ++i)
      if (Status status = checkRule(block, block.rules[i], "rule " + std::to_string(i + 1) + " of " + place);
          !status)
        return status;
    return {};
  }

  Status checkRule(const RuleBlock& block, const Rule& rule, const std::string& place) const
  {
    if (Status status = checkTree(rule.antecedent, place); !status) return status;
    for (const Antecedent::Node& node : rule.antecedent.nodes) {
      using Kind = Antecedent::Kind;
      if (node.kind == Kind::And && !block.conjunction)
        return invalidValue(place + " has 'and', but its block no conjunction");
      if (node.kind == Kind::Or && !block.disjunction)
        return invalidValue(place + " has 'or', but its block no disjunction");
      if (node.kind != Kind::Proposition) continue;
      if (Status status = checkProposition(node.proposition, place, true); !status) return status;
    }
    if (rule.consequents.empty()) return invalidValue(place + " has no conclusion");
    for (const Proposition& consequent : rule.consequents) {
      if (!consequent.onOutput) return invalidValue(place + " concludes on an input");
      if (Status status = checkProposition(consequent, place, false); !status) return status;
      if (Status status = checkConclusion(block, consequent, place); !status) return status;
    }
    if (!std::isfinite(rule.weight)) return invalidValue(place + ": the weight is not a finite number");
    return {};
  }

  Status checkProposition(const Proposition& proposition, const std::string& place, bool mayBeAny) const
  {
    const std::size_t count = proposition.onOutput ? m_system.outputs.size() : m_system.inputs.size();
    if (proposition.variable < 0 || proposition.variable >= static_cast<int>(count))
      return invalidValue(place + " names a variable that does not exist");
    const auto variable = static_cast<std::size_t>(proposition.variable);
    const auto& terms =
      proposition.onOutput ? m_system.outputs[variable].terms : m_system.inputs[variable].terms;
    if (proposition.term >= static_cast<int>(terms.size()) || proposition.term < -1)
      return invalidValue(place + " names a term that does not exist");
    const bool any = hasHedge(proposition, Hedge::Any);
    if (proposition.term < 0 && (!mayBeAny || !any || proposition.hedges.back() != Hedge::Any))
      return invalidValue(place + " has a proposition without a term");
    if (any && (proposition.term >= 0 || proposition.hedges.back() != Hedge::Any ||
                std::count(proposition.hedges.begin(), proposition.hedges.end(), Hedge::Any) > 1))
      return invalidValue(place + ": 'any' stands in place of a term, at the end");
    return {};
  }

  /// What turning the conclusion into a number needs.
  Status checkConclusion(const RuleBlock& block, const Proposition& consequent,
                         const std::string& place) const
  {
    const OutputVariable& output = m_system.outputs[static_cast<std::size_t>(consequent.variable)];
    if (!output.enabled || !block.enabled) return {};
    const std::string on = place + " concludes on '" + output.name + "', ";
    if (output.defuzzifier == Defuzzifier::None) return invalidValue(on + "which has no defuzzifier");
    if (!isArea(output.defuzzifier)) return {};
    if (!output.aggregation) return invalidValue(on + "which has no aggregation");
    if (!block.implication) return invalidValue(on + "but its block has no implication");
    if (!std::isfinite(output.minimum) || !std::isfinite(output.maximum) ||
        !std::isfinite(output.maximum - output.minimum))
      return invalidValue(on + "whose range is not finite, so that its set has no area");
    return {};
  }

  static Status checkTree(const Antecedent& antecedent, const std::string& place)
  {
    using Kind = Antecedent::Kind;
    const std::size_t count = antecedent.nodes.size();
    if (count == 0) return invalidValue(place + " has no condition");
    std::vector<int> depth(count, 0); // 0: no parent met yet
    depth[0] = 1;
    for (std::size_t i = 0; i < count; ++i) {
      const Antecedent::Node& node = antecedent.nodes[i];
      const std::size_t children = node.children.size();
      const bool fits = node.kind == Kind::Proposition ? children == 0
                        : node.kind == Kind::Not       ? children == 1
                                                       : children >= 2;
      if (!fits || depth[i] == 0 || depth[i] > Antecedent::kMaximumDepth)
        return invalidValue(place + ": the condition is nested too deeply or no tree");
      for (const int child : node.children) {
        if (child <= static_cast<int>(i) || child >= static_cast<int>(count) ||
            depth[static_cast<std::size_t>(child)] != 0)
          return invalidValue(place + ": the condition is no tree");
        depth[static_cast<std::size_t>(child)] = depth[i] + 1;
      }
    }
    return {};
  }

  const System& m_system;
};

} // namespace

Status checkSystem(const System& system)
{
  return SystemChecker(system).check();
}

} // namespace esm::fis
