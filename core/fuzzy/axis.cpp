// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/fuzzy/axis.h"

#include <algorithm>
#include <cmath>

namespace esm::fuzzy {

Axis axisOf(const Variable& variable) noexcept
{
  if (!variable.logarithmic) return {variable.minimum, variable.maximum};
  return {std::log10(variable.minimum), std::log10(variable.maximum)};
}

double toAxis(const Variable& variable, double value) noexcept
{
  if (!std::isfinite(value)) value = variable.defaultValue;
  value = std::max(variable.minimum, std::min(value, variable.maximum));
  return variable.logarithmic ? std::log10(value) : value;
}

double fromAxis(const Variable& variable, double x) noexcept
{
  const double value = variable.logarithmic ? std::pow(10.0, x) : x;
  return std::max(variable.minimum, std::min(value, variable.maximum)); // pow may round past an end
}

} // namespace esm::fuzzy
