// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

// Part of shape.h: where curves bend.
#include "core/fuzzy/fis/shape.h"

#include <algorithm>
#include <cmath>

namespace esm::fis {

/// Calls visit(x) for every top and bottom of a product or difference of sigmoids: there the slope changes
/// its sign, which is looked for around both inflections.
template <class Visit>
void forEachTurn(const Curve& curve, const Visit& visit)
{
  const auto& p = curve.parameters;
  const double reach = 12.0 / std::max(1e-300, std::min(std::abs(p[1]), std::abs(p[2])));
  const double low = std::min(p[0], p[3]) - reach, high = std::max(p[0], p[3]) + reach;
  constexpr int kSteps = 48;
  double x0 = low, s0 = membershipSlope(curve, x0).byX;
  for (int i = 1; i <= kSteps; ++i) {
    const double x1 = low + (high - low) * i / kSteps, s1 = membershipSlope(curve, x1).byX;
    if (s0 * s1 < 0.0) {
      double a = x0, b = x1;
      for (double middle = 0.5 * (a + b); middle > a && middle < b; middle = 0.5 * (a + b))
        ((membershipSlope(curve, middle).byX > 0.0) == (s0 > 0.0) ? a : b) = middle;
      visit(a);
    }
    x0 = x1, s0 = s1;
  }
}

template <class Visit>
void forEachCorner(const Curve& curve, const Visit& visit)
{
  const auto& p = curve.parameters;
  const auto at = [&](int i) {
    if (std::isfinite(p[static_cast<std::size_t>(i)]))
      visit(Corner{p[static_cast<std::size_t>(i)], {{i, -1}}, {{1.0, 0.0}}});
  };
  const auto middle = [&](int i, int j) {
    const double x = 0.5 * (p[static_cast<std::size_t>(i)] + p[static_cast<std::size_t>(j)]);
    if (std::isfinite(x)) visit(Corner{x, {{i, j}}, {{0.5, 0.5}}});
  };
  switch (curve.shape) {
  case Shape::Triangle:
    for (const int i : {0, 1, 2}) at(i);
    break;
  case Shape::Trapezoid:
    for (const int i : {0, 1, 2, 3}) at(i);
    break;
  case Shape::Ramp:
  case Shape::Rectangle:
    at(0);
    at(1);
    break;
  case Shape::SShape:
  case Shape::ZShape:
    at(0);
    at(1);
    middle(0, 1);
    break;
  case Shape::PiShape:
    for (const int i : {0, 1, 2, 3}) at(i);
    middle(0, 1);
    middle(2, 3);
    break;
  case Shape::Cosine:
    at(0);
    visit(Corner{p[0] - 0.5 * p[1], {{0, 1}}, {{1.0, -0.5}}});
    visit(Corner{p[0] + 0.5 * p[1], {{0, 1}}, {{1.0, 0.5}}});
    break;
  case Shape::Discrete:
    for (std::size_t i = 0; i + 1 < p.size(); i += 2) at(static_cast<int>(i));
    break;
  case Shape::GaussianProduct:
    at(0);
    at(2);
    if (p[0] > p[2]) { // between the means both bells fall: the top of their product
      const double a = 1.0 / (p[1] * p[1]), b = 1.0 / (p[3] * p[3]);
      visit(Corner{(a * p[0] + b * p[2]) / (a + b), {{0, 2}}, {{a / (a + b), b / (a + b)}}});
    }
    break;
  case Shape::Concave:
    at(1);
    break;
  case Shape::Bell:
  case Shape::Binary:
  case Shape::Gaussian:
  case Shape::Spike:
    at(0);
    break;
  case Shape::SigmoidDifference: // also where both sigmoids meet and the difference changes its sign
    if (p[1] != p[2]) visit(Corner{(p[1] * p[0] - p[2] * p[3]) / (p[1] - p[2]), {{-1, -1}}, {}});
    [[fallthrough]];
  case Shape::SigmoidProduct:
    forEachTurn(curve, [&](double x) { visit(Corner{x, {{-1, -1}}, {}}); });
    break;
  case Shape::Constant:
  case Shape::Function:
  case Shape::Linear:
  case Shape::Sigmoid:
    break;
  }
}

template <class Visit>
void forEachGuide(const Curve& curve, const Visit& visit)
{
  const auto& p = curve.parameters;
  const auto around = [&](double center, double width) {
    for (const double k : {1.0, 2.5, 5.0, 8.0}) {
      visit(center - k * width);
      visit(center + k * width);
    }
  };
  const auto sigmoid = [&](double inflection, double slope) {
    visit(inflection);
    if (slope == 0.0) return;
    around(inflection, 1.5 / std::abs(slope));
    visit(inflection - 30.0 / std::abs(slope));
    visit(inflection + 30.0 / std::abs(slope));
  };
  switch (curve.shape) {
  case Shape::Gaussian:
    around(p[0], std::abs(p[1]));
    break;
  case Shape::GaussianProduct:
    around(p[0], std::abs(p[1]));
    around(p[2], std::abs(p[3]));
    break;
  case Shape::Bell:
    around(p[0], std::abs(p[1]));
    break;
  case Shape::Spike:
    around(p[0], 0.3 * std::abs(p[1]));
    break;
  case Shape::Sigmoid:
    sigmoid(p[0], p[1]);
    break;
  case Shape::SigmoidDifference:
  case Shape::SigmoidProduct:
    sigmoid(p[0], p[1]);
    sigmoid(p[3], p[2]);
    break;
  case Shape::Concave:
    around(p[1], std::abs(p[1] - p[0]));
    break;
  default:
    break;
  }
}

} // namespace esm::fis
