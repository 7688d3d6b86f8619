// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/base/text_encoding.h"
#include "core/fuzzy/fis/files.h"
#include "core/fuzzy/fis/format_names.h"
#include "core/fuzzy/fis/matlab_rules.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

namespace esm::fis {

namespace {

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
  FisReader(SourceText& source, Notes& notes) : m_source(source), m_notes(notes), m_once(notes) {}

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
    m_title = line;
    if (line.substr(0, 7) == "[System") {
      m_section = Section::System;
      m_title.clear();
    } else if (line.substr(0, 6) == "[Input") {
      m_section = Section::Input;
      m_place = placeOf(line.substr(6), m_system.inputs.size());
      startVariable(m_system.inputs, line, "input");
    } else if (line.substr(0, 7) == "[Output") {
      m_section = Section::Output;
      m_place = placeOf(line.substr(7), m_system.outputs.size());
      startVariable(m_system.outputs, line, "output");
    } else if (line.substr(0, 6) == "[Rules") {
      m_section = Section::Rules;
    } else {
      throw Fault{line.data(), shown(line) + " is no known section"};
    }
  }

  /// The number that a text begins with, from 0; without one the next place.
  static std::size_t placeOf(std::string_view text, std::size_t next)
  {
    std::size_t end = 0;
    while (end < text.size() && text[end] >= '0' && text[end] <= '9') ++end;
    if (end == 0) return next;
    const int number = readCount(text.substr(0, end));
    if (number < 1 || number > kMostParts)
      throw Fault{text.data(), shown(text.substr(0, end)) + " is no number from 1 to 1000"};
    return static_cast<std::size_t>(number - 1);
  }

  /// Rules go by number, so the number of a section counts, not its turn.
  template <class Variable>
  void startVariable(std::vector<Variable>& variables, std::string_view line, const std::string& role)
  {
    if (m_place < variables.size() && !variables[m_place].name.empty())
      throw Fault{line.data(), "this section occurs twice"};
    if (m_place >= variables.size()) variables.resize(m_place + 1);
    variables[m_place].name = role + std::to_string(m_place + 1);
  }

  void readKey(std::string_view line)
  {
    const std::size_t sign = line.find('=');
    if (sign == std::string_view::npos) throw Fault{line.data(), "here 'key = value' was expected"};
    const std::string_view key = trimmed(line.substr(0, sign)), value = trimmed(line.substr(sign + 1));
    bool known = false;
    if (m_section == Section::System) known = readSystemKey(key, value);
    if (m_section == Section::Input) known = readVariableKey(m_system.inputs[m_place], key, value);
    if (m_section == Section::Output)
      known = readVariableKey(m_system.outputs[m_place], key, value) ||
              readOutputKey(m_system.outputs[m_place], key, value);
    if (!known) throw Fault{key.data(), shown(key) + " is no key that may stand here"};
    if (key.substr(0, 2) != "MF" && !isRedundant(key)) m_once.give(key, m_title, unquoted(value));
  }

  bool readSystemKey(std::string_view key, std::string_view value)
  {
    const std::string_view word = unquoted(value);
    if (key == "Name") {
      m_system.name = plainLine(word);
    } else if (key == "Type") {
      if (asciiLower(word).find("type2") != std::string::npos) throw Fault{word.data(), kTypeTwo};
    } else if (key == "NumInputs") {
      m_announced[0] = readCount(value);
    } else if (key == "NumOutputs") {
      m_announced[1] = readCount(value);
    } else if (key == "NumRules") {
      m_announced[2] = readCount(value);
    } else if (key == "AndMethod") {
      m_block.conjunction = readNorm(matlab::kTNorms, word, tNormNamed);
    } else if (key == "OrMethod") {
      m_block.disjunction = readNorm(matlab::kSNorms, word, sNormNamed);
    } else if (key == "ImpMethod") {
      m_block.implication = readNorm(matlab::kTNorms, word, tNormNamed);
    } else if (key == "AggMethod") {
      m_aggregation = readNorm(matlab::kSNorms, word, sNormNamed);
    } else if (key == "DefuzzMethod") {
      const int method = indexIn(matlab::kMethods, word);
      if (method < 0 && !word.empty()) throw Fault{word.data(), shown(word) + " is no known defuzzification"};
      m_defuzzifier = static_cast<Defuzzifier>(std::max(method, 0));
    } else {
      return isRedundant(key);
    }
    return true;
  }

  static bool isRedundant(std::string_view key)
  {
    return key == "Version" || key == "Type" || key == "NumMFs" || key == "TypeReductionMethod";
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
      if (key.back() == 'U' || key.back() == 'L') throw Fault{key.data(), kTypeTwo};
      const std::size_t place = placeOf(key.substr(2), variable.terms.size());
      if (place < variable.terms.size() && !variable.terms[place].name.empty())
        throw Fault{key.data(), shown(key) + " occurs twice"};
      if (place >= variable.terms.size()) variable.terms.resize(place + 1);
      variable.terms[place] = readTerm(value);
    } else if (key == "NumMFs") {
      m_announcedTerms.emplace_back(key.data(), readCount(value), m_section == Section::Output, m_place);
    } else {
      return false;
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
  Term readTerm(std::string_view text)
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
    const matlab::FisShape* known = nullptr;
    for (const matlab::FisShape& candidate : matlab::kShapes)
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
  void takeParameters(Term& term, const matlab::FisShape& known, const std::vector<double>& numbers)
  {
    const int needed = parameterCount(known.shape);
    if (needed < 0 || numbers.size() < static_cast<std::size_t>(needed)) {
      term.parameters = numbers;
      return;
    }
    for (std::size_t i = 0; i < static_cast<std::size_t>(needed); ++i)
      term.parameters.push_back(numbers[known.order[i]]);
    if (numbers.size() > static_cast<std::size_t>(needed)) ++m_surplus;
  }

  void finish()
  {
    completeNames();
    for (OutputVariable& output : m_system.outputs) {
      output.defuzzifier = m_defuzzifier;
      output.aggregation = m_aggregation;
    }
    m_system.blocks.push_back(m_block);
    for (const std::string_view line : m_rules) {
      Rule rule = readRuleRow(line, m_system);
      // A row of zeros, which exporters leave of conditions that FIS cannot hold, never fires.
      if (!rule.antecedent.nodes.empty())
        m_system.blocks.back().rules.push_back(std::move(rule));
      else
        m_notes.add(line.data(), "a rule without a condition is left out");
    }
    compareCounts();
  }

  void completeNames()
  {
    std::set<std::string> taken;
    complete(m_system.inputs, "Input", taken);
    complete(m_system.outputs, "Output", taken);
  }

  /// Every number has its section and its curve; names that occur again get a number.
  template <class Variable>
  void complete(std::vector<Variable>& variables, const std::string& section, std::set<std::string>& taken)
  {
    for (std::size_t v = 0; v < variables.size(); ++v) {
      Variable& variable = variables[v];
      const std::string title = '[' + section + std::to_string(v + 1) + ']';
      if (variable.name.empty()) throw Fault{endOfText(), "the section " + title + " is missing"};
      makeUnique(variable.name, taken, title);
      std::set<std::string> termNames;
      for (std::size_t t = 0; t < variable.terms.size(); ++t) {
        const std::string curve = title + ", MF" + std::to_string(t + 1);
        if (variable.terms[t].name.empty()) throw Fault{endOfText(), curve + " is missing"};
        makeUnique(variable.terms[t].name, termNames, curve);
      }
    }
  }

  void makeUnique(std::string& name, std::set<std::string>& taken, const std::string& place)
  {
    const std::string first = name;
    for (int i = 2; !taken.insert(name).second; ++i) name = first + '_' + std::to_string(i);
    if (name != first)
      m_notes.add(nullptr, place + ": the name '" + first + "' occurs again and is read as '" + name + "'");
  }

  void compareCounts()
  {
    const std::size_t counts[] = {m_system.inputs.size(), m_system.outputs.size(), m_rules.size()};
    constexpr const char* kWhat[] = {"NumInputs", "NumOutputs", "NumRules"};
    for (std::size_t i = 0; i < 3; ++i)
      if (m_announced[i] >= 0 && static_cast<std::size_t>(m_announced[i]) != counts[i])
        m_notes.add(nullptr, std::string(kWhat[i]) + " says " + std::to_string(m_announced[i]) +
                               ", the file holds " + std::to_string(counts[i]));
    for (const auto& [at, count, onOutput, place] : m_announcedTerms) {
      const std::size_t held =
        onOutput ? m_system.outputs[place].terms.size() : m_system.inputs[place].terms.size();
      if (static_cast<std::size_t>(count) != held)
        m_notes.add(at,
                    "NumMFs says " + std::to_string(count) + ", the section holds " + std::to_string(held));
    }
    if (m_surplus > 0)
      m_notes.add(nullptr, "curves with more numbers than their shape needs: " + std::to_string(m_surplus) +
                             "; those beyond are passed over, as MATLAB does");
  }

  const char* endOfText() const { return m_source.text().data() + m_source.text().size(); }

  static constexpr int kMostParts = 1000;
  static constexpr const char* kTypeTwo = "type-2 systems are not read";

  SourceText& m_source;
  Notes& m_notes;
  OnceKeys m_once;
  std::string m_title; ///< "[Input1]"; empty for [System]
  System m_system;
  std::size_t m_place = 0; ///< of the section's variable
  std::array<int, 3> m_announced = {-1, -1, -1};
  std::vector<std::tuple<const char*, int, bool, std::size_t>> m_announcedTerms;
  int m_surplus = 0; ///< curves with numbers that are passed over
  RuleBlock m_block;
  std::optional<SNorm> m_aggregation = SNorm::Maximum;
  Defuzzifier m_defuzzifier = Defuzzifier::Centroid;
  Section m_section = Section::None;
  std::vector<std::string_view> m_rules;
};

} // namespace

Result<System> readFis(std::string_view text, std::string_view fileName, const ReadOptions& options)
{
  const std::string utf8 = toUtf8(text);
  SourceText source(utf8, fileName);
  Notes notes(source, options.notes);
  return runReader(source, [&] { return FisReader(source, notes).read(); });
}

} // namespace esm::fis
