// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/base/text_encoding.h"
#include "core/fuzzy/fis/fcl_blocks.h"
#include "core/fuzzy/fis/fcl_defaults.h"
#include "core/fuzzy/fis/fcl_terms.h"
#include "core/fuzzy/fis/files.h"
#include "core/fuzzy/fis/format_names.h"

#include <algorithm>
#include <map>
#include <set>

namespace esm::fis {

namespace {

class FclReader {
public:
  FclReader(const FunctionBlock& block, Notes& notes) : m_scan(block.text), m_notes(notes), m_once(notes)
  {
    m_system.name = block.name;
    if (!block.name.empty()) m_scan.take();
  }

  System read()
  {
    while (!m_scan.atEnd()) {
      if (m_scan.accept("VAR_INPUT"))
        readVariables(true);
      else if (m_scan.accept("VAR_OUTPUT"))
        readVariables(false);
      else if (m_scan.accept("FUZZIFY"))
        readFuzzify();
      else if (m_scan.accept("DEFUZZIFY"))
        readDefuzzify();
      else if (m_scan.accept("RULEBLOCK"))
        readBlock();
      else if (!passOver("VAR", "END_VAR") && !passOver("OPTION", "END_OPTION") &&
               !passOver("OPTIONS", "END_OPTIONS"))
        throw Fault{m_scan.word().data(), shown(m_scan.word()) + " may not stand here"};
    }
    for (const auto& [block, text] : m_rules) addRule(m_system.blocks[block], text);
    accumulate();
    for (OutputVariable& output : m_system.outputs) {
      if (!completeOutput(output, m_hasMethod.count(output.name) > 0))
        m_notes.add(nullptr,
                    "the terms of '" + output.name + "' are singletons: METHOD : COG is read as COGS");
      output.joinsEqualTerms = isWeighted(output.defuzzifier) && output.aggregation;
    }
    return std::move(m_system);
  }

private:
  /// A part that says nothing about inference.
  bool passOver(std::string_view begin, std::string_view end)
  {
    if (!m_scan.is(begin)) return false;
    m_notes.add(m_scan.word().data(), std::string(begin) + " ... " + std::string(end) + " is passed over");
    while (!m_scan.accept(end)) m_scan.take();
    return true;
  }

  void readVariables(bool inputs)
  {
    while (!m_scan.accept("END_VAR")) {
      std::vector<std::string> names;
      do names.push_back(usableName(m_scan.take()));
      while (m_scan.accept(","));
      m_scan.expect(":");
      readType(names.front());
      m_scan.expect(";");
      for (const std::string& name : names)
        if (inputs) {
          m_system.inputs.emplace_back();
          m_system.inputs.back().name = name;
        } else {
          m_system.outputs.emplace_back();
          m_system.outputs.back().name = name;
          m_system.outputs.back().aggregation.reset();
          m_system.outputs.back().defuzzifier = Defuzzifier::None;
        }
      if (!m_scan.accept("RANGE")) continue; // as jFuzzyLogic has it
      if (inputs)
        readRange(m_system.inputs.back());
      else
        readRange(m_system.outputs.back());
    }
  }

  void readType(const std::string& name)
  {
    const std::string_view type = m_scan.take();
    if (!equalIgnoringCase(type, "REAL") && !equalIgnoringCase(type, "LREAL"))
      m_notes.add(type.data(), "'" + name + "' is read as REAL, not as " + shown(type));
    if (const std::string_view initial = m_scan.upTo(';'); !initial.empty())
      m_notes.add(initial.data(), "the initial value of '" + name + "' is passed over");
  }

  template <class Variable>
  Variable& find(std::vector<Variable>& variables, const char* role)
  {
    const std::string_view word = m_scan.take();
    for (Variable& variable : variables)
      if (variable.name == usableName(word)) return variable;
    throw Fault{word.data(), shown(word) + " is no declared " + role};
  }

  void readFuzzify()
  {
    InputVariable& input = find(m_system.inputs, "input");
    while (!m_scan.accept("END_FUZZIFY")) {
      if (m_scan.accept("TERM"))
        input.terms.push_back(readFclTerm(m_scan, m_system, false).terms.front());
      else if (!readCommon(input))
        throw Fault{m_scan.word().data(), shown(m_scan.word()) + " may not stand in FUZZIFY"};
      m_scan.accept(";");
    }
  }

  template <class Variable>
  void readRange(Variable& variable)
  {
    m_scan.expect(":=");
    m_scan.expect("(");
    const char* from = m_scan.word().data();
    variable.minimum = m_scan.number();
    m_scan.expect("..");
    variable.maximum = m_scan.number();
    giveUpToHere("RANGE", variable, from);
    m_scan.expect(")");
    m_scan.accept(";");
  }

  template <class Variable>
  void giveUpToHere(std::string_view key, const Variable& variable, const char* from)
  {
    const auto length = static_cast<std::size_t>(m_scan.word().data() - from);
    m_once.give(key, '\'' + variable.name + '\'', trimmed(std::string_view(from, length)));
  }

  /// What both kinds of variables have.
  template <class Variable>
  bool readCommon(Variable& variable)
  {
    if (m_scan.accept("RANGE")) {
      readRange(variable);
    } else if (m_scan.accept("ENABLED")) {
      m_scan.expect(":");
      m_once.give("ENABLED", '\'' + variable.name + '\'', m_scan.word());
      variable.enabled = m_scan.is("TRUE");
      if (!m_scan.accept("TRUE")) m_scan.expect("FALSE");
    } else if (m_scan.accept("LOCK")) {
      m_scan.expect(":");
      do {
        if constexpr (requires { variable.lockPrevious; })
          if (m_scan.accept("PREVIOUS")) {
            variable.lockPrevious = true;
            continue;
          }
        m_scan.expect("RANGE");
        variable.lockRange = true;
      } while (m_scan.accept("|"));
    } else {
      return false;
    }
    return true;
  }

  void readDefuzzify()
  {
    OutputVariable& output = find(m_system.outputs, "output");
    while (!m_scan.accept("END_DEFUZZIFY")) {
      if (m_scan.accept("TERM")) {
        addTerm(output);
      } else if (m_scan.accept("METHOD")) {
        m_scan.expect(":");
        m_once.give("METHOD", '\'' + output.name + '\'', m_scan.word());
        output.defuzzifier = readMethod();
        m_hasMethod.insert(output.name);
      } else if (m_scan.accept("ACCU")) {
        m_scan.expect(":");
        m_once.give("ACCU", '\'' + output.name + '\'', m_scan.word());
        output.aggregation = readNorm<SNorm>(fcl::kSNorms, fcl::kForeignSNorms, sNormNamed);
      } else if (m_scan.accept("DEFAULT")) {
        readDefault(output);
      } else if (!readCommon(output)) {
        throw Fault{m_scan.word().data(), shown(m_scan.word()) + " may not stand in DEFUZZIFY"};
      }
      m_scan.accept(";");
    }
  }

  void addTerm(OutputVariable& output)
  {
    FclTerm read = readFclTerm(m_scan, m_system, true);
    const int variable = static_cast<int>(&output - m_system.outputs.data());
    if (!read.heights.empty()) m_singletons[{variable, static_cast<int>(output.terms.size())}] = read.heights;
    output.terms.insert(output.terms.end(), read.terms.begin(), read.terms.end());
  }

  void readDefault(OutputVariable& output)
  {
    m_scan.expect(":=");
    if (m_scan.accept("NC")) {
      output.lockPrevious = true;
      return;
    }
    const char* from = m_scan.word().data();
    output.defaultValue = m_scan.number();
    giveUpToHere("DEFAULT", output, from);
    if (!m_scan.accept("|")) return;
    m_scan.expect("NC");
    output.lockPrevious = true;
  }

  Defuzzifier readMethod()
  {
    const std::string_view word = m_scan.take();
    const int index = indexIn(fcl::kMethods, word);
    if (index >= 0) return static_cast<Defuzzifier>(index);
    for (const auto& [name, method] :
         {std::pair<std::string_view, Defuzzifier>{"Centroid", Defuzzifier::Centroid},
          {"Bisector", Defuzzifier::Bisector},
          {"COGF", Defuzzifier::WeightedAverage}}) // over functions, with jFuzzyLogic
      if (equalIgnoringCase(word, name)) return method;
    throw Fault{word.data(), shown(word) + " is no known METHOD"};
  }

  template <class Norm, std::size_t N, class Foreign>
  std::optional<Norm> readNorm(const std::array<std::string_view, N>& names, const Foreign& foreign,
                               std::optional<Norm> (*named)(std::string_view) noexcept)
  {
    const std::string_view word = m_scan.take();
    if (equalIgnoringCase(word, "NONE")) return std::nullopt;
    if (const int index = indexIn(names, word); index >= 0) return static_cast<Norm>(index);
    for (const auto& [name, norm] : foreign)
      if (equalIgnoringCase(word, name)) return norm;
    if (const auto norm = named(word)) return norm;
    throw Fault{word.data(), shown(word) + " is no known norm"};
  }

  void readBlock()
  {
    m_system.blocks.emplace_back();
    RuleBlock& block = m_system.blocks.back();
    block.conjunction.reset();
    block.disjunction.reset();
    block.implication.reset();
    constexpr std::array<std::string_view, 7> kKeys = {"AND",     "OR",   "ACT",          "RULE",
                                                       "ENABLED", "ACCU", "END_RULEBLOCK"};
    if (indexIn(kKeys, m_scan.word()) < 0) block.name = std::string(m_scan.take());
    NormWords words;
    OnceKeys once(m_notes);
    while (!m_scan.accept("END_RULEBLOCK")) {
      if (m_scan.accept("RULE")) {
        m_scan.upTo(':'); // its number or name
        m_scan.expect(":");
        m_rules.emplace_back(m_system.blocks.size() - 1, m_scan.restOfStatement());
      } else {
        readBlockKey(block, words, once);
      }
      m_scan.accept(";");
    }
    completeNorms(block, words);
  }

  void readBlockKey(RuleBlock& block, NormWords& words, OnceKeys& once)
  {
    const std::string_view key = m_scan.take();
    m_scan.expect(":");
    for (const std::string_view known : {"AND", "OR", "ACT", "ENABLED"}) // accumulate() gives ACCU
      if (equalIgnoringCase(key, known)) once.give(known, '\'' + block.name + '\'', m_scan.word());
    if (equalIgnoringCase(key, "AND")) {
      words.conjunction = m_scan.word();
      block.conjunction = readNorm<TNorm>(fcl::kTNorms, fcl::kForeignTNorms, tNormNamed);
    } else if (equalIgnoringCase(key, "OR")) {
      words.disjunction = m_scan.word();
      block.disjunction = readNorm<SNorm>(fcl::kSNorms, fcl::kForeignSNorms, sNormNamed);
    } else if (equalIgnoringCase(key, "ACT")) {
      block.implication = readNorm<TNorm>(fcl::kTNorms, fcl::kForeignTNorms, tNormNamed);
    } else if (equalIgnoringCase(key, "ACCU")) {
      const std::string_view word = m_scan.word();
      const auto norm = readNorm<SNorm>(fcl::kSNorms, fcl::kForeignSNorms, sNormNamed);
      if (norm) m_accumulations.push_back({m_system.blocks.size() - 1, *norm, word});
    } else if (equalIgnoringCase(key, "ENABLED")) {
      block.enabled = m_scan.is("TRUE");
      if (!m_scan.accept("TRUE")) m_scan.expect("FALSE");
    } else {
      throw Fault{key.data(), shown(key) + " may not stand in RULEBLOCK"};
    }
  }

  /// A conclusion on SINGLETONS is one on each of them, with a weight where it is not full.
  void addRule(RuleBlock& block, std::string_view text)
  {
    const char* mixed = nullptr;
    const Rule rule = readRule(text, m_system, true, &mixed);
    if (mixed && !m_saidMixed)
      m_notes.add(mixed,
                  "AND is joined before the OR in front of it, as the standard has it; jFuzzyLogic joins "
                  "from the left, brackets say which is meant");
    m_saidMixed = m_saidMixed || mixed;
    Rule whole = rule;
    whole.consequents.clear();
    std::vector<Rule> parts;
    for (const Proposition& conclusion : rule.consequents) {
      const auto several = m_singletons.find({conclusion.variable, conclusion.term});
      const std::vector<double> heights =
        several == m_singletons.end() ? std::vector<double>{1.0} : several->second;
      for (std::size_t i = 0; i < heights.size(); ++i) {
        Proposition one = conclusion;
        one.term += static_cast<int>(i);
        if (heights[i] == 1.0) {
          whole.consequents.push_back(std::move(one));
          continue;
        }
        if (block.implication != TNorm::AlgebraicProduct)
          throw Fault{text.data(), "singletons of a height other than 1 are read with ACT : PROD only"};
        Rule part = rule;
        part.consequents = {std::move(one)};
        part.weight *= heights[i];
        parts.push_back(std::move(part));
      }
    }
    if (!whole.consequents.empty()) block.rules.push_back(std::move(whole));
    block.rules.insert(block.rules.end(), parts.begin(), parts.end());
  }

  /// Gives the ACCU of blocks to the outputs that their rules conclude on, where they have none of their own.
  void accumulate()
  {
    const auto given = m_system.outputs;
    for (const Accumulation& accumulation : m_accumulations)
      for (std::size_t o = 0; o < given.size(); ++o) {
        OutputVariable& output = m_system.outputs[o];
        if (!concludesOn(m_system.blocks[accumulation.block], o)) continue;
        if (output.aggregation && output.aggregation != accumulation.norm)
          m_notes.add(accumulation.word.data(), "ACCU : " + std::string(accumulation.word) +
                                                  " is passed over for '" + output.name +
                                                  "', which has another one already");
        if (!output.aggregation) output.aggregation = accumulation.norm;
      }
  }

  static bool concludesOn(const RuleBlock& block, std::size_t output)
  {
    return std::any_of(block.rules.begin(), block.rules.end(), [&](const Rule& rule) {
      return std::any_of(rule.consequents.begin(), rule.consequents.end(),
                         [&](const Proposition& p) { return p.variable == static_cast<int>(output); });
    });
  }

  struct Accumulation {
    std::size_t block;
    SNorm norm;
    std::string_view word;
  };
  FclScanner m_scan;
  Notes& m_notes;
  OnceKeys m_once; ///< of variables; a block has its own
  System m_system;
  std::vector<std::pair<std::size_t, std::string_view>> m_rules;
  std::vector<Accumulation> m_accumulations;
  bool m_saidMixed = false;
  std::set<std::string> m_hasMethod;                               ///< outputs that say theirs
  std::map<std::pair<int, int>, std::vector<double>> m_singletons; ///< heights, by output and first term
};

} // namespace

Result<System> readFcl(std::string_view text, std::string_view fileName, const ReadOptions& options)
{
  std::string plain = toUtf8(text);
  const SourceText source(plain, fileName);
  Notes notes(source, options.notes);
  return runReader(source, [&] {
    blankComments(plain);
    const auto blocks = functionBlocksOf(plain);
    return FclReader(chooseBlock(blocks, options.block, notes), notes).read();
  });
}

} // namespace esm::fis
