// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// The part of shape.h that says whether a term's numbers make a shape.
#include "core/fuzzy/fis/shape.h"

#include "core/base/text_number.h"

#include <cmath>
#include <string>

namespace esm::fis {

namespace {

/// Beyond this, differences and squares of numbers may overflow.
constexpr double kLargestNumber = 1e100;

Status checkDiscrete(const Term& term)
{
  const auto& p = term.parameters;
  if (p.size() < 2 || p.size() % 2 != 0)
    return invalidValue("needs pairs of numbers x y, it has " + std::to_string(p.size()) + " numbers");
  if (p.size() > 2 * kMaximumPoints)
    return invalidValue("has " + std::to_string(p.size() / 2) + " points, more than " +
                        std::to_string(kMaximumPoints));
  for (std::size_t i = 2; i < p.size(); i += 2)
    if (!(p[i] >= p[i - 2]))
      return invalidValue("needs x that do not fall, but " + formatDouble(p[i - 2]) + " stands before " +
                          formatDouble(p[i]));
  return {};
}

Status checkOrder(const Term& term)
{
  const auto& p = term.parameters;
  for (std::size_t i = 1; i < p.size(); ++i)
    if (!(p[i] >= p[i - 1]))
      return invalidValue("needs numbers that do not fall, but " + formatDouble(p[i - 1]) +
                          " stands before " + formatDouble(p[i]));
  return {};
}

/// Curves that are level up to, or from, infinity. Order is checked elsewhere.
bool mayBeInfinite(const Term& term, std::size_t index)
{
  const auto& p = term.parameters;
  const bool left = p[index] < 0.0;
  switch (term.shape) {
  case Shape::Binary:
    return index == 1;
  case Shape::Triangle:
    return index == (left ? 0U : 2U);
  case Shape::Rectangle:
    return index == (left ? 0U : 1U);
  case Shape::GaussianProduct: // a mean at infinity: no flank on that side
    return index == (left ? 0U : 2U);
  case Shape::Trapezoid:
    return left ? index <= 1 : index >= 2;
  case Shape::PiShape: // a flank that begins at infinity and ends elsewhere has no middle
    return left ? index <= 1 && p[0] == p[1] : index >= 2 && p[2] == p[3];
  default:
    return false;
  }
}

Status checkWidths(const Term& term)
{
  const auto& p = term.parameters;
  const auto zero = [&](std::size_t i) {
    return std::abs(p[i]) < 1e-100
             ? Status(
                 invalidValue(std::string(parameterName(term.shape, static_cast<int>(i))) + " must not be 0"))
             : Status();
  };
  switch (term.shape) {
  case Shape::Bell:
  case Shape::Gaussian:
  case Shape::Spike:
    return zero(1);
  case Shape::Cosine:
    if (!(p[1] > 1e-100)) return invalidValue("width must be above 0");
    return {};
  case Shape::GaussianProduct: {
    Status first = zero(1);
    return first ? zero(3) : first;
  }
  case Shape::Binary:
    if (p[0] == p[1]) return invalidValue("direction must differ from start");
    return {};
  case Shape::Discrete:
    return checkDiscrete(term);
  case Shape::PiShape:
  case Shape::Rectangle:
  case Shape::SShape:
  case Shape::Trapezoid:
  case Shape::Triangle:
  case Shape::ZShape:
    return checkOrder(term);
  default:
    return {};
  }
}

} // namespace

Status checkTerm(const Term& term)
{
  const auto& p = term.parameters;
  const int needed = parameterCount(term.shape);
  if (needed >= 0 && p.size() != static_cast<std::size_t>(needed))
    return invalidValue("needs " + std::to_string(needed) + " parameters, it has " +
                        std::to_string(p.size()));
  if (term.shape == Shape::Linear && p.empty()) return invalidValue("needs coefficients");
  if (term.shape == Shape::Function && (term.formula.empty() || !p.empty()))
    return invalidValue("needs a formula and no parameters");
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (std::abs(p[i]) <= kLargestNumber || (std::isinf(p[i]) && mayBeInfinite(term, i))) continue;
    return invalidValue("parameter " + formatDouble(p[i]) + " is not a usable number");
  }
  if (!(std::abs(term.height) <= kLargestNumber) || (isNumber(term.shape) && term.height != 1.0))
    return invalidValue("the height " + formatDouble(term.height) + " is not usable");
  return checkWidths(term);
}

} // namespace esm::fis
