// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/fuzzy/rule_base.h"

#include "core/fuzzy/fuzzy_set.h"

#include <algorithm>
#include <cmath>

namespace esm::fuzzy {

namespace {

const Variable* findById(const std::vector<Variable>& variables, std::string_view id) noexcept
{
  const auto found = std::find_if(variables.begin(), variables.end(),
                                  [&](const Variable& variable) { return variable.id == id; });
  return found == variables.end() ? nullptr : &*found;
}

/// Height of a flank that is 0 at `zero` and 1 at `one`, for x beyond `one` on the side of `zero`. An
/// infinite `zero` is a shoulder, `zero` = `one` an upright flank.
double flank(double x, double zero, double one) noexcept
{
  if (std::isinf(zero)) return 1.0;
  if (zero == one) return 0.0;
  const double height = (x - zero) / (one - zero);
  return height > 0.0 ? std::min(height, 1.0) : 0.0; // also 0 for NaN, from a half-typed term
}

double trapezoid(double x, double a, double b, double c, double d) noexcept
{
  if (x < b) return flank(x, a, b);
  if (x > c) return flank(x, d, c);
  return x >= b ? 1.0 : 0.0; // NaN fails every comparison
}

} // namespace

const Variable* RuleBase::findInput(std::string_view id) const noexcept
{
  return findById(inputs, id);
}
const Variable* RuleBase::findOutput(std::string_view id) const noexcept
{
  return findById(outputs, id);
}

double membership(const Term& term, double x) noexcept
{
  const std::vector<double>& p = term.parameters;
  if (std::isnan(x)) return 0.0;
  switch (term.shape) {
  case Shape::Triangle:
    return p.size() == 3 ? trapezoid(x, p[0], p[1], p[1], p[2]) : 0.0;
  case Shape::Trapezoid:
    return p.size() == 4 ? trapezoid(x, p[0], p[1], p[2], p[3]) : 0.0;
  case Shape::Gaussian: {
    if (p.size() != 2) return 0.0;
    const double z = (x - p[0]) / p[1];
    const double height = std::exp(-0.5 * z * z);
    return height > 0.0 ? height : 0.0;
  }
  }
  return 0.0;
}

double applyHedges(const std::vector<Hedge>& hedges, double degree) noexcept
{
  for (auto hedge = hedges.rbegin(); hedge != hedges.rend(); ++hedge) switch (*hedge) {
    case Hedge::Not:
      degree = 1.0 - degree;
      break;
    case Hedge::Very:
      degree = degree * degree;
      break;
    case Hedge::Extremely:
      degree = degree * degree * degree;
      break;
    case Hedge::Somewhat:
      degree = std::sqrt(std::max(degree, 0.0));
      break;
    }
  return degree;
}

NamedDegree bestTerm(const Variable& variable, double value) noexcept
{
  NamedDegree best;
  const double x = toAxis(variable, value);
  for (std::size_t i = 0; i < variable.terms.size(); ++i) {
    const double degree = membership(variable.terms[i], x);
    if (best.term < 0 || degree > best.degree) best = {static_cast<int>(i), degree};
  }
  return best;
}

} // namespace esm::fuzzy
