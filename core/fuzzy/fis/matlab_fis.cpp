// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/base/text_number.h"
#include "core/fuzzy/fis/files.h"
#include "core/fuzzy/fis/source_text.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace esm::fis {

namespace {

constexpr std::array<std::string_view, kTNormCount> kTNorms = {"min",
                                                               "prod",
                                                               "bounded_difference",
                                                               "drastic_product",
                                                               "einstein_product",
                                                               "hamacher_product",
                                                               "nilpotent_minimum"};
constexpr std::array<std::string_view, kSNormCount> kSNorms = {
  "max",          "probor",       "bounded_sum",       "drastic_sum",
  "einstein_sum", "hamacher_sum", "nilpotent_maximum", "normalized_sum",
  "sum"};
constexpr std::array<std::string_view, 8> kMethods = {"none", "bisector", "centroid", "lom",
                                                      "mom",  "som",      "wtaver",   "wtsum"};

/// A shape's name in FIS and where its parameters stand there: ours[i] = theirs[order[i]].
struct FisShape {
  std::string_view name;
  Shape shape;
  std::array<std::size_t, 4> order = {0, 1, 2, 3};
  bool matlab = true; ///< else an addition of fuzzylite
};
constexpr std::array<FisShape, 23> kShapes = {{{"trimf", Shape::Triangle},
                                               {"trapmf", Shape::Trapezoid},
                                               {"gaussmf", Shape::Gaussian, {1, 0, 2, 3}},
                                               {"gauss2mf", Shape::GaussianProduct, {1, 0, 3, 2}},
                                               {"gbellmf", Shape::Bell, {2, 0, 1, 3}},
                                               {"sigmf", Shape::Sigmoid, {1, 0, 2, 3}},
                                               {"dsigmf", Shape::SigmoidDifference, {1, 0, 2, 3}},
                                               {"psigmf", Shape::SigmoidProduct, {1, 0, 2, 3}},
                                               {"pimf", Shape::PiShape},
                                               {"smf", Shape::SShape},
                                               {"zmf", Shape::ZShape},
                                               {"constant", Shape::Constant},
                                               {"linear", Shape::Linear},
                                               {"rampmf", Shape::Ramp, {0, 1, 2, 3}, false},
                                               {"linsmf", Shape::Ramp},
                                               {"linzmf", Shape::Ramp, {1, 0, 2, 3}},
                                               {"binarymf", Shape::Binary, {0, 1, 2, 3}, false},
                                               {"concavemf", Shape::Concave, {0, 1, 2, 3}, false},
                                               {"cosinemf", Shape::Cosine, {0, 1, 2, 3}, false},
                                               {"discretemf", Shape::Discrete, {0, 1, 2, 3}, false},
                                               {"function", Shape::Function, {0, 1, 2, 3}, false},
                                               {"rectmf", Shape::Rectangle, {0, 1, 2, 3}, false},
                                               {"spikemf", Shape::Spike, {0, 1, 2, 3}, false}}};

/// Hedges behind the point of a term's number, as fuzzylite writes them.
constexpr std::array<std::pair<int, Hedge>, 5> kHedgeCodes = {
  {{1, Hedge::Seldom}, {5, Hedge::Somewhat}, {20, Hedge::Very}, {30, Hedge::Extremely}, {99, Hedge::Any}}};

template <std::size_t N>
int indexIn(const std::array<std::string_view, N>& names, std::string_view word)
{
  for (std::size_t i = 0; i < N; ++i)
    if (equalIgnoringCase(names[i], word)) return static_cast<int>(i);
  return -1;
}

std::string_view unquoted(std::string_view text)
{
  text = trimmed(text);
  if (text.size() >= 2 && (text.front() == '\'' || text.front() == '"') && text.back() == text.front())
    return text.substr(1, text.size() - 2);
  return text;
}

/// The line without what is behind %, # or //, unless in quotes.
std::string_view withoutComment(std::string_view line)
{
  char quote = '\0';
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (quote != '\0') {
      if (line[i] == quote) quote = '\0';
    } else if (line[i] == '\'' || line[i] == '"') {
      quote = line[i];
    } else if (line[i] == '%' || line[i] == '#' || line.substr(i, 2) == "//") {
      return line.substr(0, i);
    }
  }
  return line;
}

class FisReader {
public:
  explicit FisReader(SourceText& source) : m_source(source) {}

  System read()
  {
    std::string_view line;
    while (m_source.nextLine(line)) {
      line = trimmed(withoutComment(line));
      if (line.empty()) continue;
      if (line.front() == '[' && line.find('=') == std::string_view::npos)
        startSection(line);
      else if (m_section == Section::Rules)
        m_rules.push_back(line);
      else
        readKey(line);
    }
    finish();
    return std::move(m_system);
  }

private:
  enum class Section { None, System, Input, Output, Rules };

  void startSection(std::string_view line)
  {
    if (line.substr(0, 7) == "[System") {
      m_section = Section::System;
    } else if (line.substr(0, 6) == "[Input") {
      m_section = Section::Input;
      m_system.inputs.emplace_back();
      m_system.inputs.back().name = "input" + std::to_string(m_system.inputs.size());
    } else if (line.substr(0, 7) == "[Output") {
      m_section = Section::Output;
      m_system.outputs.emplace_back();
      m_system.outputs.back().name = "output" + std::to_string(m_system.outputs.size());
    } else if (line.substr(0, 6) == "[Rules") {
      m_section = Section::Rules;
    } else {
      throw Fault{line.data(), shown(line) + " is no known section"};
    }
  }

  void readKey(std::string_view line)
  {
    const std::size_t sign = line.find('=');
    if (sign == std::string_view::npos) throw Fault{line.data(), "here 'key = value' was expected"};
    const std::string_view key = trimmed(line.substr(0, sign)), value = trimmed(line.substr(sign + 1));
    bool known = false;
    if (m_section == Section::System) known = readSystemKey(key, value);
    if (m_section == Section::Input) known = readVariableKey(m_system.inputs.back(), key, value);
    if (m_section == Section::Output)
      known = readVariableKey(m_system.outputs.back(), key, value) ||
              readOutputKey(m_system.outputs.back(), key, value);
    if (!known) throw Fault{key.data(), shown(key) + " is no key that may stand here"};
  }

  bool readSystemKey(std::string_view key, std::string_view value)
  {
    const std::string_view word = unquoted(value);
    if (key == "Name") {
      m_system.name = plainLine(word);
    } else if (key == "AndMethod") {
      m_block.conjunction = readNorm(kTNorms, word, tNormNamed);
    } else if (key == "OrMethod") {
      m_block.disjunction = readNorm(kSNorms, word, sNormNamed);
    } else if (key == "ImpMethod") {
      m_block.implication = readNorm(kTNorms, word, tNormNamed);
    } else if (key == "AggMethod") {
      m_aggregation = readNorm(kSNorms, word, sNormNamed);
    } else if (key == "DefuzzMethod") {
      const int method = indexIn(kMethods, word);
      if (method < 0 && !word.empty()) throw Fault{word.data(), shown(word) + " is no known defuzzification"};
      m_defuzzifier = static_cast<Defuzzifier>(std::max(method, 0));
    } else {
      for (const std::string_view redundant :
           {"Type", "Version", "NumInputs", "NumOutputs", "NumRules", "NumMFs", "TypeReductionMethod"})
        if (key == redundant) return true;
      return false;
    }
    return true;
  }

  /// A name without what would not fit on one line of FLL.
  static std::string plainLine(std::string_view text)
  {
    std::string line(trimmed(text));
    std::replace(line.begin(), line.end(), '#', '_');
    return line;
  }

  template <class Norm, std::size_t N>
  static std::optional<Norm> readNorm(const std::array<std::string_view, N>& names, std::string_view word,
                                      std::optional<Norm> (*named)(std::string_view) noexcept)
  {
    if (word.empty() || word == "none") return std::nullopt;
    if (const int index = indexIn(names, word); index >= 0) return static_cast<Norm>(index);
    if (const auto norm = named(word)) return norm;
    throw Fault{word.data(), shown(word) + " is no known method"};
  }

  template <class Variable>
  bool readVariableKey(Variable& variable, std::string_view key, std::string_view value)
  {
    if (key == "Name") {
      variable.name = usableName(unquoted(value));
    } else if (key == "Range") {
      const auto numbers = readList(value);
      if (numbers.size() != 2) throw Fault{value.data(), "a range needs two numbers"};
      variable.minimum = numbers[0];
      variable.maximum = numbers[1];
    } else if (key == "Enabled") {
      variable.enabled = readExpression(unquoted(value)) == 1.0;
    } else if (key.substr(0, 2) == "MF") {
      variable.terms.push_back(readTerm(value));
    } else {
      return key == "NumMFs";
    }
    return true;
  }

  static bool readOutputKey(OutputVariable& output, std::string_view key, std::string_view value)
  {
    if (key == "Default") {
      output.defaultValue = readExpression(value);
    } else if (key == "LockPrevious") {
      output.lockPrevious = readExpression(value) == 1.0;
    } else if (key == "LockRange") {
      output.lockRange = readExpression(value) == 1.0;
    } else {
      return false;
    }
    return true;
  }

  /// "[-pi/4 0, 2*pi]"
  static std::vector<double> readList(std::string_view text)
  {
    text = trimmed(text);
    if (text.size() < 2 || text.front() != '[' || text.back() != ']')
      throw Fault{text.data(), "here a list in [ ] was expected"};
    std::string_view rest = text.substr(1, text.size() - 2);
    std::vector<double> numbers;
    for (;;) {
      rest.remove_prefix(std::min(rest.find_first_not_of(" \t,;"), rest.size()));
      if (rest.empty()) return numbers;
      const std::size_t end = std::min(rest.find_first_of(" \t,;"), rest.size());
      numbers.push_back(readExpression(rest.substr(0, end)));
      rest.remove_prefix(end);
    }
  }

  /// 'name':'trimf',[a b c]
  static Term readTerm(std::string_view text)
  {
    std::size_t colon = text.front() == '\'' ? text.find('\'', 1) : 0;
    colon = text.find(':', std::min(colon, text.size()));
    if (colon == std::string_view::npos)
      throw Fault{text.data(), "here 'name':'shape',[numbers] was expected"};
    const std::string_view rest = trimmed(text.substr(colon + 1));
    const std::size_t comma = rest.find(',');
    if (comma == std::string_view::npos) throw Fault{rest.data(), "here 'shape',[numbers] was expected"};
    std::string_view shape = unquoted(rest.substr(0, comma));
    if (!shape.empty() && shape.front() == '\'') shape.remove_prefix(1); // fuzzylite writes 'binarymf
    const std::string_view list = trimmed(rest.substr(comma + 1));
    Term term;
    term.name = usableName(unquoted(text.substr(0, colon)));
    const FisShape* known = nullptr;
    for (const FisShape& candidate : kShapes)
      if (candidate.name == shape) known = &candidate;
    if (!known) throw Fault{shape.data(), shown(shape) + " is no known shape"};
    term.shape = known->shape;
    if (term.shape == Shape::Function) {
      if (list.size() < 2) throw Fault{list.data(), "here [formula] was expected"};
      term.formula = trimmed(list.substr(1, list.size() - 2));
      return term;
    }
    takeParameters(term, *known, readList(list));
    if (const Status status = checkTerm(term); !status)
      throw Fault{list.data(), "term " + shown(term.name) + ": " + status.error().detail};
    return term;
  }

  /// In our order. Numbers beyond those that the shape needs are passed over, as MATLAB does.
  static void takeParameters(Term& term, const FisShape& known, const std::vector<double>& numbers)
  {
    const int needed = parameterCount(known.shape);
    if (needed < 0 || numbers.size() < static_cast<std::size_t>(needed)) {
      term.parameters = numbers;
      return;
    }
    for (std::size_t i = 0; i < static_cast<std::size_t>(needed); ++i)
      term.parameters.push_back(numbers[known.order[i]]);
  }

  void finish()
  {
    for (OutputVariable& output : m_system.outputs) {
      output.aggregation = m_aggregation;
      output.defuzzifier = m_defuzzifier;
    }
    m_system.blocks.push_back(m_block);
    for (const std::string_view line : m_rules) {
      Rule rule = readRuleRow(line);
      // A row of zeros, which exporters leave of conditions that FIS cannot hold, never fires.
      if (!rule.antecedent.nodes.empty()) m_system.blocks.back().rules.push_back(std::move(rule));
    }
  }

  /// "1 -2, 1 (0.5) : 1"
  Rule readRuleRow(std::string_view line)
  {
    const std::size_t comma = line.find(','), open = line.find('('), close = line.find(')'),
                      colon = line.rfind(':');
    if (comma == std::string_view::npos || open == std::string_view::npos ||
        close == std::string_view::npos || colon == std::string_view::npos || comma > open || open > close ||
        close > colon)
      throw Fault{line.data(), "here a rule 'inputs, outputs (weight) : 1 or 2' was expected"};
    Rule rule;
    const auto conditions = readRow(line.substr(0, comma), m_system.inputs, false);
    rule.consequents = readRow(line.substr(comma + 1, open - comma - 1), m_system.outputs, true);
    rule.weight = readExpression(trimmed(line.substr(open + 1, close - open - 1)));
    const std::string_view connection = trimmed(line.substr(colon + 1));
    const double joins = readExpression(connection);
    if (joins != 1.0 && joins != 2.0) throw Fault{connection.data(), "the connection is 1 (and) or 2 (or)"};
    if (rule.consequents.empty()) throw Fault{line.data(), "the rule has no conclusion"};
    if (conditions.size() > 1) {
      Antecedent::Node chain;
      chain.kind = joins == 1.0 ? Antecedent::Kind::And : Antecedent::Kind::Or;
      for (std::size_t i = 0; i < conditions.size(); ++i) chain.children.push_back(static_cast<int>(i) + 1);
      rule.antecedent.nodes.push_back(std::move(chain));
    }
    for (const Proposition& condition : conditions)
      rule.antecedent.nodes.push_back({Antecedent::Kind::Proposition, condition, {}});
    return rule;
  }

  template <class Variable>
  std::vector<Proposition> readRow(std::string_view row, const std::vector<Variable>& variables,
                                   bool onOutput)
  {
    std::vector<Proposition> propositions;
    std::size_t place = 0;
    std::string_view rest = trimmed(row);
    for (; !rest.empty(); ++place) {
      const std::string_view word = takeWord(rest);
      if (place >= variables.size()) throw Fault{word.data(), "the rule names more variables than there are"};
      const double code = readNumber(word);
      if (code != 0.0)
        propositions.push_back(
          readCode(code, word, static_cast<int>(place), variables[place].terms.size(), onOutput));
    }
    if (place < variables.size()) throw Fault{row.data(), "the rule names fewer variables than there are"};
    return propositions;
  }

  /// A term's number, negative for not; behind the point, with fuzzylite, a hedge.
  static Proposition readCode(double code, std::string_view word, int variable, std::size_t terms,
                              bool onOutput)
  {
    const double size = std::abs(code), whole = std::floor(size + 1e-6);
    const int fraction = static_cast<int>(std::lround((size - whole) * 100.0));
    if (!(whole <= static_cast<double>(terms)))
      throw Fault{word.data(), shown(word) + " is no term: the variable has " + std::to_string(terms)};
    Proposition proposition{onOutput, variable, static_cast<int>(whole) - 1, {}};
    if (code < 0.0) proposition.hedges.push_back(Hedge::Not);
    if (fraction == 40) proposition.hedges.insert(proposition.hedges.end(), {Hedge::Very, Hedge::Very});
    bool known = fraction == 0 || fraction == 40;
    for (const auto& [number, hedge] : kHedgeCodes)
      if (fraction == number) proposition.hedges.push_back(hedge), known = true;
    if (fraction == 99) proposition.term = -1;
    if (!known || (proposition.term < 0 && fraction != 99))
      throw Fault{word.data(), shown(word) + " is no known term or hedge"};
    return proposition;
  }

  SourceText& m_source;
  System m_system;
  RuleBlock m_block;
  std::optional<SNorm> m_aggregation = SNorm::Maximum;
  Defuzzifier m_defuzzifier = Defuzzifier::Centroid;
  Section m_section = Section::None;
  std::vector<std::string_view> m_rules;
};

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

  template <class Norm, std::size_t N>
  static std::string normText(const std::array<std::string_view, N>& names, std::optional<Norm> norm)
  {
    return norm ? std::string(names[static_cast<std::size_t>(*norm)]) : "";
  }

  void writeSystemPart()
  {
    const bool sugeno = isWeighted(m_first.defuzzifier);
    m_text =
      "[System]\nName='" + m_system.name + "'\nType='" + (sugeno ? "sugeno" : "mamdani") + "'\nVersion=2.0\n";
    m_text += "NumInputs=" + std::to_string(m_system.inputs.size()) +
              "\nNumOutputs=" + std::to_string(m_system.outputs.size()) +
              "\nNumRules=" + std::to_string(m_ruleCount) + '\n';
    m_text += "AndMethod='" + normText(kTNorms, m_block.conjunction) + "'\nOrMethod='" +
              normText(kSNorms, m_block.disjunction) + "'\n";
    m_text += "ImpMethod='" + normText(kTNorms, m_block.implication) + "'\nAggMethod='" +
              normText(kSNorms, m_first.aggregation) + "'\n";
    m_text +=
      "DefuzzMethod='" + std::string(kMethods[static_cast<std::size_t>(m_first.defuzzifier)]) + "'\n\n";
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
    const FisShape* known = nullptr;
    for (const FisShape& candidate : kShapes)
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
    for (const auto& [number, hedge] : kHedgeCodes)
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

Result<System> readFis(std::string_view text, std::string_view fileName)
{
  SourceText source(text, fileName);
  return runReader(source, [&] { return FisReader(source).read(); });
}

Written writeFis(const System& system)
{
  return FisWriter(system).write();
}

} // namespace esm::fis
