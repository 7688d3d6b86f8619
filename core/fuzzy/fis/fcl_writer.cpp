// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/base/text_number.h"
#include "core/fuzzy/fis/files.h"
#include "core/fuzzy/fis/format_names.h"

#include <cmath>

namespace esm::fis {

namespace {

class FclWriter {
public:
  explicit FclWriter(const System& system) : m_system(system) {}

  Written write()
  {
    m_text = "FUNCTION_BLOCK " + m_system.name + "\n\nVAR_INPUT\n";
    lose(!m_system.description.empty(), "the description of the system");
    for (const InputVariable& input : m_system.inputs) line(input.name + " : REAL;");
    m_text += "END_VAR\n\nVAR_OUTPUT\n";
    for (const OutputVariable& output : m_system.outputs) line(output.name + " : REAL;");
    m_text += "END_VAR\n\n";
    for (const InputVariable& input : m_system.inputs) {
      m_text += "FUZZIFY " + input.name + '\n';
      writeCommon(input, "input '" + input.name + "': ");
      m_text += "END_FUZZIFY\n\n";
    }
    for (const OutputVariable& output : m_system.outputs) writeOutput(output);
    for (const RuleBlock& block : m_system.blocks) writeBlock(block);
    m_text += "END_FUNCTION_BLOCK\n";
    return {std::move(m_text), std::move(m_losses)};
  }

private:
  void line(const std::string& text) { m_text += "  " + text + '\n'; }
  void lose(bool really, const std::string& what)
  {
    if (really) m_losses.push_back(what);
  }

  template <class Variable>
  void writeCommon(const Variable& variable, const std::string& place)
  {
    if (!variable.enabled) line("ENABLED : FALSE;");
    if (std::isfinite(variable.minimum) && std::isfinite(variable.maximum))
      line("RANGE := (" + formatDouble(variable.minimum) + " .. " + formatDouble(variable.maximum) + ");");
    else
      lose(std::isfinite(variable.minimum) || std::isfinite(variable.maximum),
           place + "the range, of which one end is infinite");
    lose(!variable.description.empty(), place + "the description");
    if constexpr (requires { variable.lockPrevious; }) {
      if (variable.lockRange) line("LOCK : RANGE;");
    } else {
      lose(variable.lockRange, place + "that values are held within the range");
    }
    for (const Term& term : variable.terms) line("TERM " + term.name + " := " + termText(term) + ';');
  }

  static std::string termText(const Term& term)
  {
    if (term.shape == Shape::Constant) return formatDouble(term.parameters[0]);
    if (term.shape == Shape::Function) return "Function " + term.formula;
    std::string text;
    if (term.shape == Shape::Discrete && term.height == 1.0) {
      for (std::size_t i = 0; i < term.parameters.size(); i += 2)
        text += (i == 0 ? "(" : " (") + formatDouble(term.parameters[i]) + ", " +
                formatDouble(term.parameters[i + 1]) + ')';
      return text;
    }
    text = nameOf(term.shape);
    for (const double parameter : term.parameters) text += ' ' + formatDouble(parameter);
    return term.height == 1.0 ? text : text + ' ' + formatDouble(term.height);
  }

  void writeOutput(const OutputVariable& output)
  {
    const std::string place = "output '" + output.name + "': ";
    m_text += "DEFUZZIFY " + output.name + '\n';
    writeCommon(output, place);
    line("METHOD : " + std::string(fcl::kMethods[static_cast<std::size_t>(output.defuzzifier)]) + ';');
    // Over numbers it joins equal conclusions, which only some systems want.
    const bool gathers = isArea(output.defuzzifier) || output.joinsEqualTerms;
    line("ACCU : " + std::string(gathers ? nameIn(fcl::kSNorms, output.aggregation, "NONE") : "NONE") + ';');
    line("DEFAULT := " + formatDouble(output.defaultValue) + (output.lockPrevious ? " | NC;" : ";"));
    lose(isArea(output.defuzzifier) && output.resolution != 100,
         place + "the resolution " + std::to_string(output.resolution));
    lose(isArea(output.defuzzifier) && !output.aggregation, place + "that it has no aggregation");
    lose(isWeighted(output.defuzzifier) && output.weightedType != WeightedType::Automatic,
         place + "the type of the weighted defuzzifier");
    m_text += "END_DEFUZZIFY\n\n";
  }

  void writeBlock(const RuleBlock& block)
  {
    const std::string place = "block '" + block.name + "': ";
    const std::string name =
      block.name.find_first_of(" \t:;(){}") == std::string::npos ? block.name : usableName(block.name);
    m_text += "RULEBLOCK " + name + '\n';
    lose(name != block.name, place + "its name, which becomes '" + name + "'");
    lose(!block.description.empty(), place + "the description");
    lose(block.activation.kind != ActivationKind::General, place + "the activation (all rules will fire)");
    lose(block.conclusionHedges == ConclusionHedges::OnSet, place + "that hedges of conclusions act on sets");
    if (!block.enabled) line("ENABLED : FALSE;");
    line("AND : " + std::string(nameIn(fcl::kTNorms, block.conjunction, "NONE")) + ';');
    line("OR : " + std::string(nameIn(fcl::kSNorms, block.disjunction, "NONE")) + ';');
    line("ACT : " + std::string(nameIn(fcl::kTNorms, block.implication, "NONE")) + ';');
    for (std::size_t i = 0; i < block.rules.size(); ++i) {
      const std::string number = std::to_string(i + 1);
      lose(!block.rules[i].enabled, place + "that rule " + number + " is off");
      line("RULE " + number + " : " + ruleText(m_system, block.rules[i]) + ';');
    }
    m_text += "END_RULEBLOCK\n\n";
  }

  const System& m_system;
  std::string m_text;
  std::vector<std::string> m_losses;
};

} // namespace

Written writeFcl(const System& system)
{
  return FclWriter(system).write();
}

} // namespace esm::fis
