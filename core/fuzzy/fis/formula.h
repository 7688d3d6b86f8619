// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace esm::fis {

/// Why a formula is none, and where.
struct FormulaError {
  std::size_t offset = 0; ///< bytes from the start of the formula
  std::string message;
};

/// An arithmetic expression, as in the terms "Function" of FLL and in numbers of FIS files ("-pi/4").
///
///     or  and  + -  * / %  unary -  ^ (from the right)  ! ~ (not, minus)  functions, (...), numbers, pi
///
/// Functions: abs fabs ceil floor round sqrt exp log log10 log1p sin cos tan asin acos atan sinh cosh tanh
/// asinh acosh atanh, and of two arguments min max pow atan2 fmod gt ge eq neq le lt. Truth is 1, all else is
/// false. Compiled to a list of steps, each over the results of earlier ones, so evaluating allocates
/// nothing.
class Formula {
public:
  static constexpr std::size_t kMaximumSteps = 512;

  /// @param names first what stands for x, then the variables in their order; empty: numbers only.
  static std::variant<Formula, FormulaError> parse(std::string_view text, std::span<const std::string> names);

  /// May be NaN or infinite (the root of -1, 1/0): the caller decides. @param variables one per name but x.
  double evaluate(double x, std::span<const double> variables) const noexcept;
  /// Adds `factor` times the derivatives by x and by each variable to `slopes`.
  void addSlopes(double x, std::span<const double> variables, double factor,
                 std::span<double> slopes) const noexcept;

private:
  friend class FormulaParser;
  enum class Op : std::uint8_t;
  struct Step {
    Op op{};
    std::int16_t a = -1, b = -1; ///< steps, or the variable
    double constant = 0.0;
  };
  void computeAll(double x, std::span<const double> variables, double* value) const noexcept;
  static double compute(const Step& step, double a, double b) noexcept;
  static void slopes(const Step& step, double a, double b, double value, double& byA, double& byB) noexcept;
  std::vector<Step> m_steps;
};

} // namespace esm::fis
