// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/fuzzy/rule_base.h"

#include "core/fuzzy/axis.h"
#include "core/fuzzy/to_system.h"

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
  const fis::Shape shape = toShape(term.shape);
  if (std::isnan(x) || static_cast<int>(term.parameters.size()) != fis::parameterCount(shape)) return 0.0;
  const double height = fis::membership({shape, term.parameters, 1.0, nullptr, {}}, x);
  return height > 0.0 ? height : 0.0; // also 0 for NaN, from a half-typed term
}

double applyHedges(const std::vector<Hedge>& hedges, double degree) noexcept
{
  for (auto hedge = hedges.rbegin(); hedge != hedges.rend(); ++hedge)
    degree = fis::apply(toHedge(*hedge), degree);
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
