// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/base/text_encoding.h"
#include "core/base/text_number.h"
#include "core/fuzzy/fis/files.h"
#include "core/fuzzy/fis/source_text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

namespace esm::fis {

namespace {

constexpr std::array<std::string_view, 8> kDefuzzifiers = {
  "none",          "Bisector",          "Centroid",        "LargestOfMaximum",
  "MeanOfMaximum", "SmallestOfMaximum", "WeightedAverage", "WeightedSum"};
constexpr std::array<std::string_view, 3> kWeightedTypes = {"Automatic", "TakagiSugeno", "Tsukamoto"};
constexpr std::array<std::string_view, 7> kActivations = {"General", "First",        "Last",     "Highest",
                                                          "Lowest",  "Proportional", "Threshold"};
constexpr std::array<std::string_view, 6> kComparisons = {"<", "<=", "==", "!=", ">=", ">"};

template <std::size_t N>
std::size_t choose(const std::array<std::string_view, N>& names, std::string_view word, const char* what)
{
  for (std::size_t i = 0; i < N; ++i)
    if (names[i] == word) return i;
  throw Fault{word.data(), shown(word) + " is no known " + what};
}

bool readBoolean(std::string_view word)
{
  if (word == "true") return true;
  if (word != "false") throw Fault{word.data(), "here true or false was expected, not " + shown(word)};
  return false;
}

template <class Norm>
std::optional<Norm> readNorm(std::string_view word, std::optional<Norm> (*named)(std::string_view) noexcept)
{
  if (word == "none" || word.empty()) return std::nullopt;
  const auto norm = named(word);
  if (!norm) throw Fault{word.data(), shown(word) + " is no known norm"};
  return norm;
}

Term readTerm(std::string_view text)
{
  Term term;
  const std::string_view name = takeWord(text), shape = takeWord(text);
  if (name.empty()) throw Fault{name.data(), "here the name of a term is missing"};
  term.name = usableName(name);
  const auto known = shapeNamed(shape);
  if (!known) throw Fault{shape.data(), shown(shape) + " is no known shape of a term"};
  term.shape = *known;
  if (term.shape == Shape::Function) {
    term.formula = text;
  } else {
    const std::string_view place = text;
    while (!text.empty()) term.parameters.push_back(readNumber(takeWord(text)));
    const int needed = parameterCount(term.shape);
    const bool surplus = term.shape == Shape::Discrete
                           ? term.parameters.size() % 2 == 1
                           : needed >= 0 && term.parameters.size() == static_cast<std::size_t>(needed) + 1;
    if (surplus && !isNumber(term.shape)) {
      term.height = term.parameters.back();
      term.parameters.pop_back();
    }
    if (const Status status = checkTerm(term); !status)
      throw Fault{place.data(), "term " + shown(name) + ": " + status.error().detail};
  }
  return term;
}

/// Reads line by line; each line is "key: value".
class FllReader {
public:
  FllReader(SourceText& source, Notes& notes) : m_source(source), m_once(notes) {}

  System read()
  {
    std::string_view line;
    while (m_source.nextLine(line)) readLine(line);
    for (const auto& [block, text, off] : m_rules) { // rules may stand before the variables they name
      Rule rule = readRule(text, m_system, false);
      rule.enabled = !off;
      m_system.blocks[block].rules.push_back(std::move(rule));
    }
    return std::move(m_system);
  }

private:
  enum class Part { System, Input, Output, Block };

  void readLine(std::string_view line)
  {
    const std::size_t comment = std::min(line.find('#'), line.size());
    const std::string_view remark = line.substr(comment);
    line = trimmed(line.substr(0, comment));
    const std::string_view own = remark.substr(0, 2) == "#!" ? trimmed(remark.substr(2)) : std::string_view();
    if (line.empty()) {
      if (!own.empty()) readOwn(own);
      return;
    }
    const std::size_t colon = line.find(':');
    if (colon == std::string_view::npos) throw Fault{line.data(), "here 'key: value' was expected"};
    const std::string_view key = trimmed(line.substr(0, colon)), value = trimmed(line.substr(colon + 1));
    if (!startPart(key, value)) readKey(key, value, own == "off");
  }

  /// What fuzzylite does not know.
  void readOwn(std::string_view text)
  {
    if (m_part == Part::Output && text == "equal-terms: joined")
      m_system.outputs.back().joinsEqualTerms = true;
    if (m_part == Part::Block && text == "conclusion-hedges: set")
      m_system.blocks.back().conclusionHedges = ConclusionHedges::OnSet;
  }

  bool startPart(std::string_view key, std::string_view value)
  {
    if (key == "Engine") {
      if (m_hasEngine) throw Fault{key.data(), "a second engine begins here; a file holds one"};
      m_hasEngine = true;
      m_system.name = value;
    } else if (key == "InputVariable") {
      m_part = Part::Input;
      m_system.inputs.emplace_back();
      m_system.inputs.back().name = usableName(value);
    } else if (key == "OutputVariable") {
      m_part = Part::Output;
      m_system.outputs.emplace_back();
      m_system.outputs.back().name = usableName(value);
      m_system.outputs.back().aggregation.reset();
      m_system.outputs.back().defuzzifier = Defuzzifier::None;
    } else if (key == "RuleBlock") {
      m_part = Part::Block;
      m_system.blocks.emplace_back();
      m_system.blocks.back().name = value;
      m_system.blocks.back().conjunction.reset();
      m_system.blocks.back().disjunction.reset();
      m_system.blocks.back().implication.reset();
    } else {
      return false;
    }
    if (key != "Engine") m_once.forget();
    return true;
  }

  void readKey(std::string_view key, std::string_view value, bool off)
  {
    bool known = false;
    if (m_part == Part::System && key == "description") known = (m_system.description = value, true);
    if (m_part == Part::Input) known = readVariableKey(m_system.inputs.back(), key, value);
    if (m_part == Part::Output)
      known = readVariableKey(m_system.outputs.back(), key, value) ||
              readOutputKey(m_system.outputs.back(), key, value);
    if (m_part == Part::Block) known = readBlockKey(m_system.blocks.back(), key, value, off);
    if (known && key != "term" && key != "rule") m_once.give(keyNow(key, value), {}, value);
    if (!known) throw Fault{key.data(), shown(key) + " is no key that may stand here"};
  }

  /// What version 6 calls a key of version 5.
  static std::string_view keyNow(std::string_view key, std::string_view value)
  {
    if (key == "accumulation") return "aggregation";
    if (key == "lock-valid") return "lock-previous";
    return key == "activation" && tNormNamed(value) ? "implication" : key;
  }

  template <class Variable>
  bool readVariableKey(Variable& variable, std::string_view key, std::string_view value)
  {
    if (key == "description") {
      variable.description = value;
    } else if (key == "enabled") {
      variable.enabled = readBoolean(value);
    } else if (key == "range") {
      variable.minimum = readNumber(takeWord(value));
      variable.maximum = readNumber(value);
    } else if (key == "lock-range") {
      variable.lockRange = readBoolean(value);
    } else if (key == "term") {
      variable.terms.push_back(readTerm(value));
    } else {
      return false;
    }
    return true;
  }

  static bool readOutputKey(OutputVariable& output, std::string_view key, std::string_view value)
  {
    if (key == "aggregation" || key == "accumulation") {
      output.aggregation = readNorm(value, sNormNamed);
    } else if (key == "default") {
      output.defaultValue = readNumber(value);
    } else if (key == "lock-previous" || key == "lock-valid") {
      output.lockPrevious = readBoolean(value);
    } else if (key == "defuzzifier") {
      output.defuzzifier = static_cast<Defuzzifier>(choose(kDefuzzifiers, takeWord(value), "defuzzifier"));
      if (value.empty()) return true;
      if (isArea(output.defuzzifier))
        output.resolution = readCount(value);
      else
        output.weightedType =
          static_cast<WeightedType>(choose(kWeightedTypes, value, "type of a weighted defuzzifier"));
    } else {
      return false;
    }
    return true;
  }

  bool readBlockKey(RuleBlock& block, std::string_view key, std::string_view value, bool off)
  {
    if (key == "description") {
      block.description = value;
    } else if (key == "enabled") {
      block.enabled = readBoolean(value);
    } else if (key == "conjunction") {
      block.conjunction = readNorm(value, tNormNamed);
    } else if (key == "disjunction") {
      block.disjunction = readNorm(value, sNormNamed);
    } else if (key == "implication") {
      block.implication = readNorm(value, tNormNamed);
    } else if (key == "activation") {
      if (tNormNamed(value)) // as version 5 called the implication
        block.implication = tNormNamed(value);
      else
        block.activation = readActivation(value);
    } else if (key == "rule") {
      m_rules.push_back({m_system.blocks.size() - 1, value, off});
    } else {
      return false;
    }
    return true;
  }

  static Activation readActivation(std::string_view text)
  {
    Activation activation;
    const std::string_view name = takeWord(text);
    if (name == "none" || name.empty()) return activation;
    activation.kind = static_cast<ActivationKind>(choose(kActivations, name, "activation"));
    if (text.empty()) return activation;
    if (activation.kind == ActivationKind::Threshold) {
      activation.comparison = static_cast<Comparison>(choose(kComparisons, takeWord(text), "comparison"));
      activation.threshold = readNumber(takeWord(text));
    } else if (activation.kind != ActivationKind::General &&
               activation.kind != ActivationKind::Proportional) {
      activation.count = readCount(takeWord(text));
      const bool ordered =
        activation.kind == ActivationKind::First || activation.kind == ActivationKind::Last;
      if (ordered && !text.empty()) activation.threshold = readNumber(takeWord(text));
    }
    if (!text.empty()) throw Fault{text.data(), "nothing more may follow here, but " + shown(text) + " does"};
    return activation;
  }

  struct PendingRule {
    std::size_t block;
    std::string_view text;
    bool off;
  };
  SourceText& m_source;
  System m_system;
  OnceKeys m_once; ///< of the part
  Part m_part = Part::System;
  bool m_hasEngine = false;
  std::vector<PendingRule> m_rules;
};

class FllWriter {
public:
  explicit FllWriter(const System& system) : m_system(system) {}

  Written write()
  {
    line("Engine: " + m_system.name, 0);
    describe(m_system.description);
    for (const InputVariable& input : m_system.inputs) {
      line("InputVariable: " + input.name, 0);
      startVariable(input);
      for (const Term& term : input.terms) writeTerm(term);
    }
    for (const OutputVariable& output : m_system.outputs) writeOutput(output);
    for (const RuleBlock& block : m_system.blocks) writeBlock(block);
    return std::move(m_written);
  }

private:
  void line(const std::string& text, int indent = 2)
  {
    m_written.text += std::string(static_cast<std::size_t>(indent), ' ') + text + '\n';
  }
  void describe(const std::string& description)
  {
    if (!description.empty()) line("description: " + description);
  }
  static std::string truth(bool value) { return value ? "true" : "false"; }

  template <class Variable>
  void startVariable(const Variable& variable)
  {
    describe(variable.description);
    line("enabled: " + truth(variable.enabled));
    line("range: " + formatDouble(variable.minimum) + ' ' + formatDouble(variable.maximum));
    line("lock-range: " + truth(variable.lockRange));
  }

  /// A minus that subtracts from nothing; that of "1e-3" follows a letter, that of "x and -y" a blank.
  static bool hasLeadingMinus(std::string_view formula)
  {
    std::string_view word;
    for (std::size_t i = 0; i < formula.size(); ++i) {
      const std::size_t end = std::min(formula.find_first_of(" \t+-*/%^(),!~", i), formula.size());
      if (end > i) {
        word = formula.substr(i, end - i);
        i = end - 1;
        continue;
      }
      const char c = formula[i];
      const bool wantsOperand = word.empty() || word == "and" || word == "or";
      if (c == '-' && wantsOperand) return true;
      if (c == ' ' || c == '\t') continue;
      const bool isExponent = (c == '-' || c == '+') &&
                              std::isdigit(static_cast<unsigned char>(word[0])) != 0 &&
                              (word.back() == 'e' || word.back() == 'E');
      if (c != ')' && !isExponent) word = {};
    }
    return false;
  }

  void writeTerm(const Term& term)
  {
    std::string text = "term: " + term.name + ' ' + std::string(nameOf(term.shape));
    if (term.shape == Shape::Function) text += ' ' + term.formula;
    for (const double parameter : term.parameters) text += ' ' + formatDouble(parameter);
    if (term.height != 1.0) text += ' ' + formatDouble(term.height);
    line(text);
    if (term.shape == Shape::Function && hasLeadingMinus(term.formula))
      m_written.losses.push_back("term '" + term.name + "': fuzzylite cannot read '-' before an operand");
    for (const char* name : {"input.x", "output.x"}) // see formulaNames()
      if (term.formula.find(name) != std::string::npos)
        m_written.losses.push_back("term '" + term.name + "': fuzzylite cannot read '" + name +
                                   "', call that variable otherwise than x");
  }

  void writeOutput(const OutputVariable& output)
  {
    line("OutputVariable: " + output.name, 0);
    startVariable(output);
    line("aggregation: " + (output.aggregation ? std::string(nameOf(*output.aggregation)) : "none"));
    std::string defuzzifier(kDefuzzifiers[static_cast<std::size_t>(output.defuzzifier)]);
    if (isArea(output.defuzzifier)) defuzzifier += ' ' + std::to_string(output.resolution);
    if (isWeighted(output.defuzzifier))
      defuzzifier += ' ' + std::string(kWeightedTypes[static_cast<std::size_t>(output.weightedType)]);
    line("defuzzifier: " + defuzzifier);
    line("default: " + formatDouble(output.defaultValue));
    line("lock-previous: " + truth(output.lockPrevious));
    if (output.joinsEqualTerms) {
      line("#! equal-terms: joined");
      m_written.losses.push_back("output '" + output.name +
                                 "': fuzzylite will count each rule by itself that concludes the same term");
    }
    for (const Term& term : output.terms) writeTerm(term);
  }

  static std::string activationText(const Activation& activation)
  {
    std::string text(kActivations[static_cast<std::size_t>(activation.kind)]);
    switch (activation.kind) {
    case ActivationKind::General:
    case ActivationKind::Proportional:
      break;
    case ActivationKind::First:
    case ActivationKind::Last:
      text += ' ' + std::to_string(activation.count) + ' ' + formatDouble(activation.threshold);
      break;
    case ActivationKind::Highest:
    case ActivationKind::Lowest:
      text += ' ' + std::to_string(activation.count);
      break;
    case ActivationKind::Threshold:
      text += ' ' + std::string(kComparisons[static_cast<std::size_t>(activation.comparison)]) + ' ' +
              formatDouble(activation.threshold);
      break;
    }
    return text;
  }

  void writeBlock(const RuleBlock& block)
  {
    line("RuleBlock: " + block.name, 0);
    describe(block.description);
    line("enabled: " + truth(block.enabled));
    line("conjunction: " + (block.conjunction ? std::string(nameOf(*block.conjunction)) : "none"));
    line("disjunction: " + (block.disjunction ? std::string(nameOf(*block.disjunction)) : "none"));
    line("implication: " + (block.implication ? std::string(nameOf(*block.implication)) : "none"));
    line("activation: " + activationText(block.activation));
    if (block.conclusionHedges == ConclusionHedges::OnSet) {
      line("#! conclusion-hedges: set");
      m_written.losses.push_back("block '" + block.name +
                                 "': fuzzylite will apply hedges of conclusions to degrees, not to sets");
    }
    for (std::size_t i = 0; i < block.rules.size(); ++i) {
      const Rule& rule = block.rules[i];
      const std::string text = ruleText(m_system, rule),
                        place = "rule " + std::to_string(i + 1) + " of block '" + block.name + "'";
      line("rule: " + text + (rule.enabled ? "" : " #! off"));
      if (!rule.enabled) m_written.losses.push_back(place + ": fuzzylite will use the rule, which is off");
      noteForeign(rule, place);
    }
  }

  void noteForeign(const Rule& rule, const std::string& place)
  {
    bool negates = false, cubes = false;
    const auto look = [&](const Proposition& p) {
      for (const Hedge hedge : p.hedges) cubes = cubes || hedge == Hedge::Cubed;
    };
    for (const auto& node : rule.antecedent.nodes) {
      negates = negates || node.kind == Antecedent::Kind::Not;
      look(node.proposition);
    }
    for (const Proposition& consequent : rule.consequents) look(consequent);
    if (negates) m_written.losses.push_back(place + ": fuzzylite cannot read 'not' before a group");
    if (cubes) m_written.losses.push_back(place + ": fuzzylite cannot read the hedge 'cubed'");
  }

  const System& m_system;
  Written m_written;
};

} // namespace

Result<System> readFll(std::string_view text, std::string_view fileName, const ReadOptions& options)
{
  const std::string utf8 = toUtf8(text);
  SourceText source(utf8, fileName);
  Notes notes(source, options.notes);
  return runReader(source, [&] { return FllReader(source, notes).read(); });
}

Written writeFll(const System& system)
{
  return FllWriter(system).write();
}

} // namespace esm::fis
