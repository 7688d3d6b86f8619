// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/base/text_number.h"
#include "core/fuzzy/fis/files.h"
#include "core/fuzzy/fis/format_names.h"

#include <cmath>

namespace esm::fis {

namespace {

class FisWriter {
public:
  explicit FisWriter(const System& system) : m_system(system) {}

  Written write()
  {
    if (!m_system.blocks.empty()) m_block = m_system.blocks.front();
    if (!m_system.outputs.empty()) m_first = m_system.outputs.front();
    lose(!m_system.description.empty(), "the description of the system");
    std::string rules;
    for (const RuleBlock& block : m_system.blocks) rules += blockText(block);
    writeSystemPart();
    for (std::size_t i = 0; i < m_system.inputs.size(); ++i)
      writeVariable(m_system.inputs[i], "Input", i, "input '" + m_system.inputs[i].name + "': ");
    for (std::size_t i = 0; i < m_system.outputs.size(); ++i) writeOutput(m_system.outputs[i], i);
    m_text += "[Rules]\n" + rules;
    return {std::move(m_text), std::move(m_losses)};
  }

private:
  void lose(bool really, const std::string& what)
  {
    if (really) m_losses.push_back(what);
  }

  void writeSystemPart()
  {
    const bool sugeno = isWeighted(m_first.defuzzifier);
    m_text =
      "[System]\nName='" + m_system.name + "'\nType='" + (sugeno ? "sugeno" : "mamdani") + "'\nVersion=2.0\n";
    m_text += "NumInputs=" + std::to_string(m_system.inputs.size()) +
              "\nNumOutputs=" + std::to_string(m_system.outputs.size()) +
              "\nNumRules=" + std::to_string(m_ruleCount) + '\n';
    m_text += "AndMethod='" + std::string(nameIn(matlab::kTNorms, m_block.conjunction, "")) +
              "'\nOrMethod='" + std::string(nameIn(matlab::kSNorms, m_block.disjunction, "")) + "'\n";
    m_text += "ImpMethod='" + std::string(nameIn(matlab::kTNorms, m_block.implication, "")) +
              "'\nAggMethod='" + std::string(nameIn(matlab::kSNorms, m_first.aggregation, "")) + "'\n";
    m_text += "DefuzzMethod='" +
              std::string(matlab::kMethods[static_cast<std::size_t>(m_first.defuzzifier)]) + "'\n\n";
  }

  template <class Variable>
  void writeVariable(const Variable& variable, const char* role, std::size_t index, const std::string& place)
  {
    m_text += '[' + std::string(role) + std::to_string(index + 1) + "]\nName='" + variable.name + "'\n";
    m_text += "Range=[" + formatDouble(variable.minimum) + ' ' + formatDouble(variable.maximum) + "]\n";
    lose(!variable.description.empty(), place + "the description");
    if (!variable.enabled) m_text += "Enabled=0\n";
    if constexpr (!requires { variable.lockPrevious; })
      lose(variable.lockRange, place + "that values are held within the range");
    m_text += "NumMFs=" + std::to_string(variable.terms.size()) + '\n';
    for (std::size_t t = 0; t < variable.terms.size(); ++t)
      m_text += "MF" + std::to_string(t + 1) + "='" + variable.terms[t].name +
                "':" + termText(variable.terms[t], place) + '\n';
    m_text += '\n';
  }

  std::string termText(const Term& term, const std::string& place)
  {
    const matlab::FisShape* known = nullptr;
    for (const matlab::FisShape& candidate : matlab::kShapes)
      if (!known && candidate.shape == term.shape) known = &candidate;
    const std::string name = "term '" + term.name + "'";
    lose(term.height != 1.0, place + "the height of " + name);
    lose(!known->matlab, place + name + " for MATLAB, which does not know '" + std::string(known->name) +
                           "' (fuzzylite does)");
    std::string text = '\'' + std::string(known->name) + "',[";
    if (term.shape == Shape::Function) return text + term.formula + ']';
    std::vector<double> numbers = term.parameters;
    const int needed = parameterCount(term.shape);
    for (std::size_t i = 0; needed > 0 && i < numbers.size(); ++i)
      numbers[known->order[i]] = term.parameters[i];
    for (std::size_t i = 0; i < numbers.size(); ++i) text += (i == 0 ? "" : " ") + formatDouble(numbers[i]);
    return text + ']';
  }

  void writeOutput(const OutputVariable& output, std::size_t index)
  {
    const std::string place = "output '" + output.name + "': ";
    writeVariable(output, "Output", index, place);
    m_text.pop_back(); // the blank line
    if (!std::isnan(output.defaultValue)) m_text += "Default=" + formatDouble(output.defaultValue) + '\n';
    if (output.lockPrevious) m_text += "LockPrevious=1\n";
    if (output.lockRange) m_text += "LockRange=1\n";
    m_text += '\n';
    lose(output.aggregation != m_first.aggregation, place + "its aggregation (all outputs share one)");
    lose(output.defuzzifier != m_first.defuzzifier, place + "its defuzzifier (all outputs share one)");
    lose(isArea(output.defuzzifier) && output.resolution != 100,
         place + "the resolution " + std::to_string(output.resolution));
    lose(output.joinsEqualTerms, place + "that rules which conclude the same term count once");
    lose(isWeighted(output.defuzzifier) && output.weightedType != WeightedType::Automatic,
         place + "the type of the weighted defuzzifier");
  }

  std::string blockText(const RuleBlock& block)
  {
    const std::string place = "block '" + block.name + "': ";
    lose(!block.name.empty(), place + "its name");
    lose(!block.description.empty(), place + "the description");
    lose(!block.enabled, place + "that it is off (its rules are left out)");
    if (!block.enabled) return {};
    lose(block.activation.kind != ActivationKind::General, place + "the activation (all rules will fire)");
    lose(block.conclusionHedges == ConclusionHedges::OnSet, place + "that hedges of conclusions act on sets");
    lose(block.conjunction != m_block.conjunction || block.disjunction != m_block.disjunction ||
           block.implication != m_block.implication,
         place + "its norms (all rules share those of the first block)");
    std::string text;
    for (std::size_t i = 0; i < block.rules.size(); ++i) {
      const auto row = block.rules[i].enabled ? rowOf(block.rules[i]) : std::nullopt;
      lose(!row, "rule " + std::to_string(i + 1) + " of " + place +
                   (block.rules[i].enabled ? "its form does not fit a row of term numbers"
                                           : "it is off and left out"));
      if (!row) continue;
      text += *row + '\n';
      ++m_ruleCount;
    }
    return text;
  }

  /// Nothing if the rule is no plain chain of 'and' or 'or', one term per variable.
  std::optional<std::string> rowOf(const Rule& rule) const
  {
    const auto& nodes = rule.antecedent.nodes;
    using Kind = Antecedent::Kind;
    std::vector<std::string> inputs(m_system.inputs.size(), "0"), outputs(m_system.outputs.size(), "0");
    for (std::size_t i = nodes.size() > 1 ? 1 : 0; i < nodes.size(); ++i) {
      if (nodes[i].kind != Kind::Proposition || nodes[i].proposition.onOutput) return std::nullopt;
      if (!place(nodes[i].proposition, inputs)) return std::nullopt;
    }
    if (nodes[0].kind == Kind::Not) return std::nullopt;
    for (const Proposition& consequent : rule.consequents)
      if (!place(consequent, outputs)) return std::nullopt;
    std::string row;
    for (const std::string& code : inputs) row += (row.empty() ? "" : " ") + code;
    row += ",";
    for (const std::string& code : outputs) row += ' ' + code;
    return row + " (" + formatDouble(rule.weight) + ") : " + (nodes[0].kind == Kind::Or ? '2' : '1');
  }

  static bool place(const Proposition& proposition, std::vector<std::string>& row)
  {
    std::string& code = row[static_cast<std::size_t>(proposition.variable)];
    if (code != "0") return false;
    std::vector<Hedge> hedges = proposition.hedges;
    const bool inverse = !hedges.empty() && hedges.front() == Hedge::Not;
    if (inverse) hedges.erase(hedges.begin());
    std::string fraction;
    if (hedges == std::vector{Hedge::Very, Hedge::Very}) fraction = ".4";
    for (const auto& [number, hedge] : matlab::kHedgeCodes)
      if (hedges == std::vector{hedge})
        fraction = number < 10 ? ".0" + std::to_string(number) : '.' + std::to_string(number);
    if (fraction.empty() && !hedges.empty()) return false;
    code = (inverse ? "-" : "") + std::to_string(proposition.term + 1) + fraction;
    return true;
  }

  const System& m_system;
  RuleBlock m_block;
  OutputVariable m_first;
  std::string m_text;
  std::vector<std::string> m_losses;
  int m_ruleCount = 0;
};

} // namespace

Written writeFis(const System& system)
{
  return FisWriter(system).write();
}

} // namespace esm::fis
