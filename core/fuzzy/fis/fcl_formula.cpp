// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/fuzzy/fis/fcl_formula.h"

#include <cctype>

namespace esm::fis {

namespace {

///     sum      := product (+- product)*
///     product  := power (*/ power)*
///     power    := atom (^% atom)*
///     atom     := +- atom | number | variable | [function] '(' sum (',' sum)* ')'
class FormulaTranslator {
public:
  FormulaTranslator(std::string_view text, const System& system) : m_text(text), m_system(system) {}

  std::string translate()
  {
    const std::string result = readSum(0);
    if (peek() != '\0') throw Fault{m_text.data() + m_at, "here an operator was expected"};
    return result;
  }

private:
  static constexpr int kDepth = 24;

  char peek()
  {
    while (m_at < m_text.size() && static_cast<unsigned char>(m_text[m_at]) <= ' ') ++m_at;
    return m_at < m_text.size() ? m_text[m_at] : '\0';
  }

  std::string readSum(int depth)
  {
    std::string sum = readProduct(depth);
    for (char c = peek(); c == '+' || c == '-'; c = peek()) {
      ++m_at;
      sum += std::string(" ") + c + ' ' + readProduct(depth);
    }
    return sum;
  }

  std::string readProduct(int depth)
  {
    std::string product = readPower(depth);
    for (char c = peek(); c == '*' || c == '/'; c = peek()) {
      ++m_at;
      product += std::string(" ") + c + ' ' + readPower(depth);
    }
    return product;
  }

  std::string readPower(int depth)
  {
    std::string power = readAtom(depth);
    for (char c = peek(); c == '^' || c == '%'; c = peek()) {
      ++m_at;
      const std::string right = readAtom(depth);
      power = (c == '^' ? "pow(" : "fmod(") + power + ", " + right + ')';
    }
    return power;
  }

  std::string readAtom(int depth)
  {
    if (depth > kDepth) throw Fault{m_text.data() + m_at, "the formula is nested too deeply"};
    const char c = peek();
    if (c == '+' || c == '-') {
      ++m_at;
      const std::string atom = readAtom(depth + 1);
      return c == '+' ? atom : "(0 - " + atom + ')';
    }
    if (c == '(') return readGroup(depth);
    const std::string_view word = readWord();
    if (word.empty()) throw Fault{m_text.data() + m_at, "here a number, a name or '(' was expected"};
    if (std::isdigit(static_cast<unsigned char>(word[0])) != 0 || word[0] == '.') return std::string(word);
    return peek() == '(' ? functionOf(word) + readGroup(depth) : variableOf(word);
  }

  std::string readGroup(int depth)
  {
    std::string group;
    do {
      ++m_at; // '(' or ','
      group += (group.empty() ? "(" : ", ") + readSum(depth + 1);
    } while (peek() == ',');
    if (peek() != ')') throw Fault{m_text.data() + m_at, "here ')' was expected"};
    ++m_at;
    return group + ')';
  }

  std::string_view readWord()
  {
    std::size_t end = m_at;
    const auto isDigit = [&](std::size_t i) { return m_text[i] >= '0' && m_text[i] <= '9'; };
    const bool number = end < m_text.size() && (isDigit(end) || m_text[end] == '.');
    for (; end < m_text.size(); ++end) {
      const auto c = static_cast<unsigned char>(m_text[end]);
      const bool exponentSign =
        number && (c == '+' || c == '-') && end > m_at && (m_text[end - 1] == 'e' || m_text[end - 1] == 'E');
      if (std::isalnum(c) == 0 && c != '_' && c != '.' && c < 0x80 && !exponentSign) break;
    }
    const std::string_view word = m_text.substr(m_at, end - m_at);
    m_at = end;
    return word;
  }

  static std::string functionOf(std::string_view word)
  {
    const std::string name = asciiLower(word);
    return name == "ln" ? "log" : name == "log" ? "log10" : name;
  }

  std::string variableOf(std::string_view word) const
  {
    const auto names = formulaNames(m_system, m_system.outputs.size());
    const std::string usable = usableName(word);
    for (std::size_t i = 1; i < names.size(); ++i) {
      const std::size_t inputs = m_system.inputs.size();
      const std::string& own =
        i <= inputs ? m_system.inputs[i - 1].name : m_system.outputs[i - 1 - inputs].name;
      if (equalIgnoringCase(own, usable)) return names[i];
    }
    if (equalIgnoringCase(word, "pi")) return "pi";
    throw Fault{word.data(), shown(word) + " is neither a variable nor a function"};
  }

  std::string_view m_text;
  const System& m_system;
  std::size_t m_at = 0;
};

} // namespace

std::string formulaOfFcl(std::string_view text, const System& system)
{
  return FormulaTranslator(text, system).translate();
}

} // namespace esm::fis
