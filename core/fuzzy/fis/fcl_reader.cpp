// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/fuzzy/fis/files.h"
#include "core/fuzzy/fis/format_names.h"

#include <algorithm>
#include <cmath>

namespace esm::fis {

namespace {

using namespace fcl;

/// Words, numbers and signs of an FCL text; comments passed over.
class FclScanner {
public:
  explicit FclScanner(std::string_view text) : m_text(text)
  {
    if (text.substr(0, 3) == "\xEF\xBB\xBF") m_next = 3;
    advance();
  }

  std::string_view word() const { return m_word; }
  bool atEnd() const { return m_word.empty(); }
  bool is(std::string_view word) const { return equalIgnoringCase(m_word, word); }
  bool accept(std::string_view word)
  {
    if (!is(word)) return false;
    advance();
    return true;
  }
  void expect(std::string_view word)
  {
    if (!accept(word))
      throw Fault{m_word.data(), "here '" + std::string(word) + "' was expected" +
                                   (atEnd() ? "" : ", not " + shown(m_word))};
  }
  std::string_view take()
  {
    const std::string_view word = m_word;
    if (word.empty()) throw Fault{m_word.data(), "the text ends too early"};
    advance();
    return word;
  }
  double number()
  {
    const bool negative = accept("-");
    if (!negative) accept("+");
    const double value = readNumber(take());
    return negative ? -value : value;
  }
  /// Everything up to the sign, trimmed; the sign is next.
  std::string_view upTo(char sign)
  {
    const std::size_t from = static_cast<std::size_t>(m_word.data() - m_text.data());
    while (!atEnd() && !(m_word.size() == 1 && m_word[0] == sign)) advance();
    const std::size_t to = static_cast<std::size_t>(m_word.data() - m_text.data());
    return trimmed(m_text.substr(from, to - from));
  }
  /// The rest of the line of the last word, or up to a semicolon.
  std::string_view restOfStatement()
  {
    const std::size_t from = static_cast<std::size_t>(m_word.data() - m_text.data());
    std::size_t end = from;
    while (!atEnd() && !is(";") && !is("RULE") && !is("END_RULEBLOCK")) {
      end = static_cast<std::size_t>(m_word.data() - m_text.data()) + m_word.size();
      advance();
    }
    return m_text.substr(from, end - from);
  }

private:
  static bool isWordByte(char c)
  {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           static_cast<unsigned char>(c) >= 0x80;
  }

  void skip()
  {
    while (m_next < m_text.size()) {
      const std::string_view rest = m_text.substr(m_next);
      if (static_cast<unsigned char>(rest[0]) <= ' ')
        ++m_next;
      else if (rest[0] == '#' || rest[0] == '%' || rest.substr(0, 2) == "//")
        m_next = std::min(m_text.find_first_of("\r\n", m_next), m_text.size());
      else if (rest.substr(0, 2) == "(*" || rest.substr(0, 2) == "/*")
        skipBlock(rest[0] == '(' ? "*)" : "*/");
      else
        break;
    }
  }
  void skipBlock(std::string_view closing)
  {
    const std::size_t end = m_text.find(closing, m_next + 2);
    if (end == std::string_view::npos) throw Fault{m_text.data() + m_next, "this comment never ends"};
    m_next = end + 2;
  }

  void advance()
  {
    skip();
    std::size_t end = m_next;
    while (end < m_text.size() && (isWordByte(m_text[end]) || isInnerByte(end))) ++end;
    if (end == m_next && end < m_text.size()) end += isPair(end) ? 2 : 1;
    m_word = m_text.substr(m_next, end - m_next);
    m_next = end;
  }
  bool isPair(std::size_t at) const
  {
    const std::string_view pair = m_text.substr(at, 2);
    return pair == ":=" || pair == "..";
  }
  /// A point within a number or name ("1.5", but not "0..10"), the sign of an exponent ("1e-5").
  bool isInnerByte(std::size_t at) const
  {
    if (m_text[at] == '.') return m_text.substr(at, 2) != ".." && (at == 0 || m_text[at - 1] != '.');
    if ((m_text[at] != '-' && m_text[at] != '+') || at < m_next + 2 ||
        (m_text[at - 1] != 'e' && m_text[at - 1] != 'E'))
      return false;
    const char first = m_text[m_next];
    return (first >= '0' && first <= '9') || first == '.';
  }

  std::string_view m_text, m_word;
  std::size_t m_next = 0;
};

class FclReader {
public:
  explicit FclReader(std::string_view text) : m_scan(text) {}

  System read()
  {
    if (m_scan.accept("FUNCTION_BLOCK") && !startsPart()) m_system.name = std::string(m_scan.take());
    while (!m_scan.atEnd() && !m_scan.accept("END_FUNCTION_BLOCK")) {
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
      else
        throw Fault{m_scan.word().data(), shown(m_scan.word()) + " may not stand here"};
    }
    for (const auto& [block, text] : m_rules)
      m_system.blocks[block].rules.push_back(readRule(text, m_system, true));
    inferRanges();
    return std::move(m_system);
  }

private:
  bool startsPart() const { return m_scan.is("VAR_INPUT") || m_scan.is("VAR_OUTPUT"); }

  void readVariables(bool inputs)
  {
    while (!m_scan.accept("END_VAR")) {
      const std::string name = usableName(m_scan.take());
      if (inputs) {
        m_system.inputs.emplace_back();
        m_system.inputs.back().name = name;
      } else {
        m_system.outputs.emplace_back();
        m_system.outputs.back().name = name;
        m_system.outputs.back().aggregation.reset();
        m_system.outputs.back().defuzzifier = Defuzzifier::None;
      }
      m_scan.expect(":");
      m_scan.take();    // REAL
      m_scan.upTo(';'); // an initial value, which an evaluation has no use for
      m_scan.expect(";");
    }
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
      if (readCommon(input)) continue;
      throw Fault{m_scan.word().data(), shown(m_scan.word()) + " may not stand in FUZZIFY"};
    }
  }

  /// What both kinds of variables have.
  template <class Variable>
  bool readCommon(Variable& variable)
  {
    if (m_scan.accept("TERM")) {
      variable.terms.push_back(readTerm());
    } else if (m_scan.accept("RANGE")) {
      m_scan.expect(":=");
      m_scan.expect("(");
      variable.minimum = m_scan.number();
      m_scan.expect("..");
      variable.maximum = m_scan.number();
      m_scan.expect(")");
    } else if (m_scan.accept("ENABLED")) {
      m_scan.expect(":");
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
    m_scan.accept(";");
    return true;
  }

  Term readTerm()
  {
    Term term;
    const std::string_view name = m_scan.take();
    term.name = usableName(name);
    m_scan.expect(":=");
    const std::string_view first = m_scan.word();
    if (m_scan.is("(")) {
      readPoints(term);
    } else if (const auto shape = shapeOf(first)) {
      m_scan.take();
      readParameters(term, *shape);
    } else {
      term.shape = Shape::Constant;
      term.parameters = {m_scan.number()};
    }
    if (term.shape == Shape::Function) return term;
    if (const Status status = checkTerm(term); !status)
      throw Fault{first.data(), "term " + shown(name) + ": " + status.error().detail};
    return term;
  }

  /// The shapes by name, and as jFuzzyLogic calls them.
  static std::optional<Shape> shapeOf(std::string_view word)
  {
    if (const auto shape = shapeNamed(word)) return shape;
    constexpr std::array<std::pair<std::string_view, Shape>, 6> kOthers = {{{"trian", Shape::Triangle},
                                                                            {"trape", Shape::Trapezoid},
                                                                            {"gauss", Shape::Gaussian},
                                                                            {"gbell", Shape::Bell},
                                                                            {"sigm", Shape::Sigmoid},
                                                                            {"singleton", Shape::Constant}}};
    for (const auto& [name, shape] : kOthers)
      if (equalIgnoringCase(name, word)) return shape;
    return std::nullopt;
  }

  void readParameters(Term& term, Shape shape)
  {
    const std::string_view list = m_scan.upTo(';');
    term.shape = shape;
    if (shape == Shape::Function) {
      term.formula = std::string(list);
      return;
    }
    std::string_view rest = list;
    while (!(rest = trimmed(rest)).empty()) {
      if (rest[0] == ',' || rest[0] == '(' || rest[0] == ')') {
        rest.remove_prefix(1);
        continue;
      }
      const std::size_t end = std::min(rest.find_first_of(" \t\r\n,()"), rest.size());
      term.parameters.push_back(readNumber(rest.substr(0, end)));
      rest.remove_prefix(end);
    }
    const int needed = parameterCount(shape);
    const bool surplus = shape == Shape::Discrete
                           ? term.parameters.size() % 2 == 1
                           : needed >= 0 && term.parameters.size() == static_cast<std::size_t>(needed) + 1;
    if (!surplus || isNumber(shape)) return;
    term.height = term.parameters.back();
    term.parameters.pop_back();
  }

  /// (x, y) (x, y) ...
  void readPoints(Term& term)
  {
    term.shape = Shape::Discrete;
    while (m_scan.accept("(")) {
      term.parameters.push_back(m_scan.number());
      m_scan.expect(",");
      term.parameters.push_back(m_scan.number());
      m_scan.expect(")");
    }
  }

  void readDefuzzify()
  {
    OutputVariable& output = find(m_system.outputs, "output");
    while (!m_scan.accept("END_DEFUZZIFY")) {
      if (readCommon(output)) continue;
      if (m_scan.accept("METHOD")) {
        m_scan.expect(":");
        output.defuzzifier = readMethod();
      } else if (m_scan.accept("ACCU")) {
        m_scan.expect(":");
        output.aggregation = readNorm<SNorm>(kSNorms, sNormNamed);
      } else if (m_scan.accept("DEFAULT")) {
        readDefault(output);
      } else {
        throw Fault{m_scan.word().data(), shown(m_scan.word()) + " may not stand in DEFUZZIFY"};
      }
      m_scan.accept(";");
    }
  }

  void readDefault(OutputVariable& output)
  {
    m_scan.expect(":=");
    if (m_scan.accept("NC")) {
      output.lockPrevious = true;
      return;
    }
    output.defaultValue = m_scan.number();
    if (!m_scan.accept("|")) return;
    m_scan.expect("NC");
    output.lockPrevious = true;
  }

  Defuzzifier readMethod()
  {
    const std::string_view word = m_scan.take();
    const int index = indexIn(kMethods, word);
    if (index >= 0) return static_cast<Defuzzifier>(index);
    for (const auto& [name, method] :
         {std::pair<std::string_view, Defuzzifier>{"Centroid", Defuzzifier::Centroid},
          {"Bisector", Defuzzifier::Bisector}})
      if (equalIgnoringCase(word, name)) return method;
    throw Fault{word.data(), shown(word) + " is no known METHOD"};
  }

  template <class Norm, std::size_t N>
  std::optional<Norm> readNorm(const std::array<std::string_view, N>& names,
                               std::optional<Norm> (*named)(std::string_view) noexcept)
  {
    const std::string_view word = m_scan.take();
    if (equalIgnoringCase(word, "NONE")) return std::nullopt;
    if (const int index = indexIn(names, word); index >= 0) return static_cast<Norm>(index);
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
    if (!m_scan.is("AND") && !m_scan.is("OR") && !m_scan.is("ACT") && !m_scan.is("RULE") &&
        !m_scan.is("ENABLED") && !m_scan.is("ACCU") && !m_scan.is("END_RULEBLOCK"))
      block.name = std::string(m_scan.take());
    while (!m_scan.accept("END_RULEBLOCK")) {
      if (m_scan.accept("RULE")) {
        m_scan.upTo(':'); // its number or name
        m_scan.expect(":");
        m_rules.emplace_back(m_system.blocks.size() - 1, m_scan.restOfStatement());
      } else {
        readBlockKey(block);
      }
      m_scan.accept(";");
    }
    // IEC 61131-7 lets one of AND and OR follow from the other.
    if (!block.conjunction && !block.disjunction)
      block.conjunction = TNorm::Minimum, block.disjunction = SNorm::Maximum;
    if (!block.implication) block.implication = TNorm::Minimum;
  }

  void readBlockKey(RuleBlock& block)
  {
    const std::string_view key = m_scan.take();
    m_scan.expect(":");
    if (equalIgnoringCase(key, "AND")) {
      block.conjunction = readNorm<TNorm>(kTNorms, tNormNamed);
    } else if (equalIgnoringCase(key, "OR")) {
      block.disjunction = readNorm<SNorm>(kSNorms, sNormNamed);
    } else if (equalIgnoringCase(key, "ACT")) {
      block.implication = readNorm<TNorm>(kTNorms, tNormNamed);
    } else if (equalIgnoringCase(key, "ACCU")) { // as the standard's first edition has it
      const auto norm = readNorm<SNorm>(kSNorms, sNormNamed);
      for (OutputVariable& output : m_system.outputs)
        if (!output.aggregation) output.aggregation = norm;
    } else if (equalIgnoringCase(key, "ENABLED")) {
      block.enabled = m_scan.is("TRUE");
      if (!m_scan.accept("TRUE")) m_scan.expect("FALSE");
    } else {
      throw Fault{key.data(), shown(key) + " may not stand in RULEBLOCK"};
    }
  }

  /// Without RANGE the terms span it; without ACCU it is MAX.
  void inferRanges()
  {
    for (OutputVariable& output : m_system.outputs) {
      if (!isArea(output.defuzzifier)) continue;
      if (!output.aggregation) output.aggregation = SNorm::Maximum;
      if (std::isfinite(output.minimum) || std::isfinite(output.maximum)) continue;
      double low = HUGE_VAL, high = -HUGE_VAL;
      for (const Term& term : output.terms)
        forEachCorner(
          Curve{term.shape, term.parameters, term.height, nullptr, {}},
          [&](const Corner& corner) { low = std::min(low, corner.x), high = std::max(high, corner.x); });
      if (low < high) output.minimum = low, output.maximum = high;
    }
  }

  FclScanner m_scan;
  System m_system;
  std::vector<std::pair<std::size_t, std::string_view>> m_rules;
};

} // namespace

Result<System> readFcl(std::string_view text, std::string_view fileName)
{
  const SourceText source(text, fileName);
  return runReader(source, [&] { return FclReader(text).read(); });
}

} // namespace esm::fis
