// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/fuzzy/fis/formula.h"

#include "core/base/text_number.h"

#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace esm::fis {

enum class Formula::Op : std::uint8_t {
  Constant,
  Variable,
  Add,
  Subtract,
  Multiply,
  Divide,
  Modulo,
  Power,
  Negate,
  Not,
  And,
  Or,
  Min,
  Max,
  Atan2,
  Greater,
  GreaterEqual,
  Equal,
  NotEqual,
  LessEqual,
  Less,
  Abs,
  Ceil,
  Floor,
  Round,
  Sqrt,
  Exp,
  Log,
  Log10,
  Log1p,
  Sin,
  Cos,
  Tan,
  Asin,
  Acos,
  Atan,
  Sinh,
  Cosh,
  Tanh,
  Asinh,
  Acosh,
  Atanh
};

/// Recursive descent; each read...() returns the step that holds its result, or nothing with the first fault
/// in m_error.
class FormulaParser {
public:
  FormulaParser(std::string_view text, std::span<const std::string> names) : m_text(text), m_names(names) {}

  std::variant<Formula, FormulaError> parse()
  {
    const auto root = readChain(0, 0);
    if (root && peek() != '\0') fail("here an operator was expected");
    if (root && m_at < m_text.size()) fail("here an operator was expected");
    if (!root || m_failed) return m_error;
    return std::move(m_formula);
  }

private:
  using Op = Formula::Op;
  using Place = std::optional<std::int16_t>;
  static constexpr int kMaximumDepth = 64;

  struct Named {
    std::string_view name;
    Op op;
  };
  static constexpr std::array<Named, 24> kUnary = {
    {{"abs", Op::Abs},     {"fabs", Op::Abs},    {"ceil", Op::Ceil},   {"floor", Op::Floor},
     {"round", Op::Round}, {"sqrt", Op::Sqrt},   {"exp", Op::Exp},     {"log", Op::Log},
     {"ln", Op::Log},      {"log10", Op::Log10}, {"log1p", Op::Log1p}, {"sin", Op::Sin},
     {"cos", Op::Cos},     {"tan", Op::Tan},     {"asin", Op::Asin},   {"acos", Op::Acos},
     {"atan", Op::Atan},   {"sinh", Op::Sinh},   {"cosh", Op::Cosh},   {"tanh", Op::Tanh},
     {"asinh", Op::Asinh}, {"acosh", Op::Acosh}, {"atanh", Op::Atanh}, {"not", Op::Not}}};
  static constexpr std::array<Named, 11> kBinary = {{{"min", Op::Min},
                                                     {"max", Op::Max},
                                                     {"pow", Op::Power},
                                                     {"atan2", Op::Atan2},
                                                     {"fmod", Op::Modulo},
                                                     {"gt", Op::Greater},
                                                     {"ge", Op::GreaterEqual},
                                                     {"eq", Op::Equal},
                                                     {"neq", Op::NotEqual},
                                                     {"le", Op::LessEqual},
                                                     {"lt", Op::Less}}};

  static bool isNameByte(char c)
  {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '.' || static_cast<unsigned char>(c) >= 0x80;
  }
  static bool isDigit(char c) { return c >= '0' && c <= '9'; }

  char peek()
  {
    while (m_at < m_text.size() && (m_text[m_at] == ' ' || (m_text[m_at] >= '\t' && m_text[m_at] <= '\r')))
      ++m_at;
    return m_at < m_text.size() ? m_text[m_at] : '\0';
  }
  std::string_view peekWord()
  {
    peek();
    std::size_t end = m_at;
    while (end < m_text.size() && isNameByte(m_text[end])) ++end;
    return m_text.substr(m_at, end - m_at);
  }
  std::nullopt_t fail(std::string message)
  {
    if (!m_failed) m_error = {m_at, std::move(message)};
    m_failed = true;
    return std::nullopt;
  }
  Place add(Op op, std::int16_t a = -1, std::int16_t b = -1, double constant = 0.0)
  {
    if (m_formula.m_steps.size() >= Formula::kMaximumSteps) return fail("the formula is too long");
    m_formula.m_steps.push_back({op, a, b, constant});
    return static_cast<std::int16_t>(m_formula.m_steps.size() - 1);
  }

  /// Levels 0 to 3 of operators that chain from the left: or, and, + -, * / %.
  Place readChain(int level, int depth)
  {
    if (level == 4) return readSign(depth);
    Place left = readChain(level + 1, depth);
    while (left) {
      const auto op = acceptOperator(level);
      if (!op) return left;
      const Place right = readChain(level + 1, depth);
      if (!right) return right;
      left = add(*op, *left, *right);
    }
    return left;
  }

  std::optional<Op> acceptOperator(int level)
  {
    const char c = peek();
    const auto take = [&](Op op, std::size_t bytes = 1) {
      m_at += bytes;
      return op;
    };
    if (level == 0 && peekWord() == "or") return take(Op::Or, 2);
    if (level == 1 && peekWord() == "and") return take(Op::And, 3);
    if (level == 2 && c == '+') return take(Op::Add);
    if (level == 2 && c == '-') return take(Op::Subtract);
    if (level == 3 && c == '*') return take(Op::Multiply);
    if (level == 3 && c == '/') return take(Op::Divide);
    if (level == 3 && c == '%') return take(Op::Modulo);
    return std::nullopt;
  }

  Place readSign(int depth)
  {
    if (depth > kMaximumDepth) return fail("the formula is nested too deeply");
    if (peek() == '+') {
      ++m_at;
      return readSign(depth + 1);
    }
    if (peek() != '-') return readPower(depth);
    ++m_at;
    const Place operand = readSign(depth + 1);
    return operand ? add(Op::Negate, *operand) : operand;
  }

  Place readPower(int depth)
  {
    const Place base = readTight(depth);
    if (!base || peek() != '^') return base;
    ++m_at;
    const Place exponent = readSign(depth + 1);
    return exponent ? add(Op::Power, *base, *exponent) : exponent;
  }

  Place readTight(int depth)
  {
    if (depth > kMaximumDepth) return fail("the formula is nested too deeply");
    const char c = peek();
    if (c == '!' || c == '~') {
      ++m_at;
      const Place operand = readTight(depth + 1);
      return operand ? add(c == '!' ? Op::Not : Op::Negate, *operand) : operand;
    }
    if (c == '(') return readGroup(depth);
    if (isDigit(c) || c == '.') return readNumber();
    return readName(depth);
  }

  Place readGroup(int depth)
  {
    ++m_at;
    const Place inside = readChain(0, depth + 1);
    return inside && !accept(')') ? fail("here ')' was expected") : inside;
  }

  bool accept(char c)
  {
    if (peek() != c) return false;
    ++m_at;
    return true;
  }

  Place readNumber()
  {
    std::size_t end = m_at;
    while (end < m_text.size() && (isDigit(m_text[end]) || m_text[end] == '.')) ++end;
    if (end < m_text.size() && (m_text[end] == 'e' || m_text[end] == 'E')) {
      std::size_t exponent = end + 1;
      if (exponent < m_text.size() && (m_text[exponent] == '+' || m_text[exponent] == '-')) ++exponent;
      if (exponent < m_text.size() && isDigit(m_text[exponent])) {
        end = exponent;
        while (end < m_text.size() && isDigit(m_text[end])) ++end;
      }
    }
    const auto value = parseDouble(m_text.substr(m_at, end - m_at));
    if (!value)
      return fail("'" + std::string(m_text.substr(m_at, std::min<std::size_t>(end - m_at, 40))) +
                  "' is no number");
    m_at = end;
    return add(Op::Constant, -1, -1, *value);
  }

  Place readName(int depth)
  {
    const std::string_view word = peekWord();
    if (word.empty()) return fail("here a number, a name or '(' was expected");
    for (std::size_t i = 0; i < m_names.size(); ++i)
      if (m_names[i] == word) {
        m_at += word.size();
        return add(Op::Variable, static_cast<std::int16_t>(i));
      }
    for (const Named& function : kUnary)
      if (function.name == word) return readCall(function.op, word.size(), 1, depth);
    for (const Named& function : kBinary)
      if (function.name == word) return readCall(function.op, word.size(), 2, depth);
    for (const auto& [name, value] :
         {std::pair<std::string_view, double>{"pi", std::numbers::pi}, {"inf", HUGE_VAL}, {"Inf", HUGE_VAL}})
      if (name == word) {
        m_at += word.size();
        return add(Op::Constant, -1, -1, value);
      }
    return fail("'" + std::string(word.substr(0, 40)) + "' is neither a variable nor a function");
  }

  Place readCall(Op op, std::size_t bytes, int arguments, int depth)
  {
    m_at += bytes;
    if (!accept('(')) return fail("here '(' was expected");
    const Place first = readChain(0, depth + 1);
    if (!first) return first;
    Place second = std::int16_t{-1};
    if (arguments == 2) {
      if (!accept(',')) return fail("here ',' was expected");
      second = readChain(0, depth + 1);
      if (!second) return second;
    }
    if (!accept(')')) return fail("here ')' was expected");
    return add(op, *first, *second);
  }

  std::string_view m_text;
  std::span<const std::string> m_names;
  std::size_t m_at = 0;
  Formula m_formula;
  FormulaError m_error;
  bool m_failed = false;
};

std::variant<Formula, FormulaError> Formula::parse(std::string_view text, std::span<const std::string> names)
{
  return FormulaParser(text, names).parse();
}

double Formula::compute(const Step& step, double a, double b) noexcept
{
  const auto truth = [](bool holds) { return holds ? 1.0 : 0.0; };
  switch (step.op) {
  case Op::Constant:
    return step.constant;
  case Op::Variable:
    return a;
  case Op::Add:
    return a + b;
  case Op::Subtract:
    return a - b;
  case Op::Multiply:
    return a * b;
  case Op::Divide:
    return a / b;
  case Op::Modulo:
    return std::fmod(a, b);
  case Op::Power:
    return std::pow(a, b);
  case Op::Negate:
    return -a;
  case Op::Not:
    return truth(a != 1.0);
  case Op::And:
    return truth(a == 1.0 && b == 1.0);
  case Op::Or:
    return truth(a == 1.0 || b == 1.0);
  case Op::Min:
    return std::fmin(a, b);
  case Op::Max:
    return std::fmax(a, b);
  case Op::Atan2:
    return std::atan2(a, b);
  case Op::Greater:
    return truth(a > b);
  case Op::GreaterEqual:
    return truth(a >= b);
  case Op::Equal:
    return truth(a == b);
  case Op::NotEqual:
    return truth(a != b);
  case Op::LessEqual:
    return truth(a <= b);
  case Op::Less:
    return truth(a < b);
  case Op::Abs:
    return std::abs(a);
  case Op::Ceil:
    return std::ceil(a);
  case Op::Floor:
    return std::floor(a);
  case Op::Round:
    return std::round(a);
  case Op::Sqrt:
    return std::sqrt(a);
  case Op::Exp:
    return std::exp(a);
  case Op::Log:
    return std::log(a);
  case Op::Log10:
    return std::log10(a);
  case Op::Log1p:
    return std::log1p(a);
  case Op::Sin:
    return std::sin(a);
  case Op::Cos:
    return std::cos(a);
  case Op::Tan:
    return std::tan(a);
  case Op::Asin:
    return std::asin(a);
  case Op::Acos:
    return std::acos(a);
  case Op::Atan:
    return std::atan(a);
  case Op::Sinh:
    return std::sinh(a);
  case Op::Cosh:
    return std::cosh(a);
  case Op::Tanh:
    return std::tanh(a);
  case Op::Asinh:
    return std::asinh(a);
  case Op::Acosh:
    return std::acosh(a);
  case Op::Atanh:
    return std::atanh(a);
  }
  return 0.0;
}

void Formula::slopes(const Step& step, double a, double b, double value, double& byA, double& byB) noexcept
{
  byA = byB = 0.0; // steps, comparisons and logic are level where they have a slope
  switch (step.op) {
  case Op::Add:
    byA = byB = 1.0;
    break;
  case Op::Subtract:
    byA = 1.0, byB = -1.0;
    break;
  case Op::Multiply:
    byA = b, byB = a;
    break;
  case Op::Divide:
    byA = 1.0 / b, byB = -value / b;
    break;
  case Op::Modulo:
    byA = 1.0, byB = -std::trunc(a / b);
    break;
  case Op::Power:
    byA = b == 0.0 ? 0.0 : b * std::pow(a, b - 1.0);
    byB = a > 0.0 ? value * std::log(a) : 0.0;
    break;
  case Op::Negate:
    byA = -1.0;
    break;
  case Op::Min:
    (a <= b || b != b ? byA : byB) = 1.0;
    break;
  case Op::Max:
    (a >= b || b != b ? byA : byB) = 1.0;
    break;
  case Op::Atan2:
    byA = b / (a * a + b * b), byB = -a / (a * a + b * b);
    break;
  case Op::Abs:
    byA = a < 0.0 ? -1.0 : 1.0;
    break;
  case Op::Sqrt:
    byA = value > 0.0 ? 0.5 / value : 0.0;
    break;
  case Op::Exp:
    byA = value;
    break;
  case Op::Log:
    byA = 1.0 / a;
    break;
  case Op::Log10:
    byA = 1.0 / (a * std::numbers::ln10);
    break;
  case Op::Log1p:
    byA = 1.0 / (1.0 + a);
    break;
  case Op::Sin:
    byA = std::cos(a);
    break;
  case Op::Cos:
    byA = -std::sin(a);
    break;
  case Op::Tan:
    byA = 1.0 + value * value;
    break;
  case Op::Asin:
    byA = 1.0 / std::sqrt(1.0 - a * a);
    break;
  case Op::Acos:
    byA = -1.0 / std::sqrt(1.0 - a * a);
    break;
  case Op::Atan:
    byA = 1.0 / (1.0 + a * a);
    break;
  case Op::Sinh:
    byA = std::cosh(a);
    break;
  case Op::Cosh:
    byA = std::sinh(a);
    break;
  case Op::Tanh:
    byA = 1.0 - value * value;
    break;
  case Op::Asinh:
    byA = 1.0 / std::sqrt(a * a + 1.0);
    break;
  case Op::Acosh:
    byA = 1.0 / std::sqrt(a * a - 1.0);
    break;
  case Op::Atanh:
    byA = 1.0 / (1.0 - a * a);
    break;
  default:
    break;
  }
}

void Formula::computeAll(double x, std::span<const double> variables, double* value) const noexcept
{
  for (std::size_t i = 0; i < m_steps.size(); ++i) {
    const Step& step = m_steps[i];
    if (step.op == Op::Variable) {
      value[i] = step.a == 0 ? x : variables[static_cast<std::size_t>(step.a - 1)];
      continue;
    }
    const double a = step.a >= 0 ? value[step.a] : 0.0, b = step.b >= 0 ? value[step.b] : 0.0;
    value[i] = compute(step, a, b);
  }
}

double Formula::evaluate(double x, std::span<const double> variables) const noexcept
{
  std::array<double, kMaximumSteps> value; // each step is written before it is read
  computeAll(x, variables, value.data());
  return m_steps.empty() ? 0.0 : value[m_steps.size() - 1];
}

void Formula::addSlopes(double x, std::span<const double> variables, double factor,
                        std::span<double> slopesOut) const noexcept
{
  if (m_steps.empty()) return;
  std::array<double, kMaximumSteps> value, adjoint;
  computeAll(x, variables, value.data());
  for (std::size_t i = 0; i < m_steps.size(); ++i) adjoint[i] = 0.0;
  adjoint[m_steps.size() - 1] = factor;
  for (std::size_t i = m_steps.size(); i-- > 0;) {
    const Step& step = m_steps[i];
    if (adjoint[i] == 0.0 || step.a < 0) continue;
    const auto first = static_cast<std::size_t>(step.a);
    if (step.op == Op::Variable) {
      slopesOut[first] += adjoint[i];
      continue;
    }
    double byA = 0.0, byB = 0.0;
    slopes(step, value[first], step.b >= 0 ? value[static_cast<std::size_t>(step.b)] : 0.0, value[i], byA,
           byB);
    adjoint[first] += adjoint[i] * byA;
    if (step.b >= 0) adjoint[static_cast<std::size_t>(step.b)] += adjoint[i] * byB;
  }
}

} // namespace esm::fis
