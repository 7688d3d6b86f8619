// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/fuzzy/fis/fcl_defaults.h"

#include "core/base/ascii_case.h"

#include <algorithm>
#include <cmath>

namespace esm::fis {

namespace {

/// Where a curve does something: as far as jFuzzyLogic takes it to reach.
std::pair<double, double> spanOf(const Term& term)
{
  const auto& p = term.parameters;
  double low = HUGE_VAL, high = -HUGE_VAL;
  const auto around = [&](double centre, double reach) {
    low = std::min(low, centre - std::abs(reach)), high = std::max(high, centre + std::abs(reach));
  };
  switch (term.shape) {
  case Shape::Gaussian:
    around(p[0], 4.0 * p[1]);
    break;
  case Shape::GaussianProduct:
    around(p[0], 4.0 * p[1]);
    around(p[2], 4.0 * p[3]);
    break;
  case Shape::Bell:
    around(p[0], std::pow(999.0, 0.5 / p[2]) * p[1]);
    break;
  case Shape::Sigmoid:
    around(p[0], 9.0 / p[1]);
    break;
  case Shape::SigmoidDifference:
  case Shape::SigmoidProduct:
    around(p[0], 9.0 / p[1]);
    around(p[3], 9.0 / p[2]);
    break;
  case Shape::Function:
    break;
  default:
    forEachCorner(Curve{term.shape, p, term.height, nullptr, {}},
                  [&](const Corner& corner) { around(corner.x, 0.0); });
  }
  return {low, high};
}

void inferRange(OutputVariable& output)
{
  if (std::isfinite(output.minimum) || std::isfinite(output.maximum)) return;
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const Term& term : output.terms) {
    const auto [from, to] = spanOf(term);
    low = std::min(low, from), high = std::max(high, to);
  }
  if (low <= high) output.minimum = low, output.maximum = high;
}

} // namespace

void completeNorms(RuleBlock& block, const NormWords& words)
{
  if (!block.implication) block.implication = TNorm::Minimum;
  if (words.conjunction.empty() && words.disjunction.empty()) {
    block.conjunction = TNorm::Minimum;
    block.disjunction = SNorm::Maximum;
  } else if (words.disjunction.empty() && block.conjunction) {
    block.disjunction = static_cast<SNorm>(*block.conjunction); // both lists have the same order
    if (equalIgnoringCase(words.conjunction, "HAMACHER")) block.disjunction = SNorm::EinsteinSum;
  } else if (words.conjunction.empty() && block.disjunction &&
             static_cast<int>(*block.disjunction) < kTNormCount) {
    block.conjunction = static_cast<TNorm>(*block.disjunction);
    if (equalIgnoringCase(words.disjunction, "EINSTEIN")) block.conjunction = TNorm::HamacherProduct;
  }
}

bool completeOutput(OutputVariable& output, bool hasMethod)
{
  const bool numbers =
    !output.terms.empty() && std::all_of(output.terms.begin(), output.terms.end(),
                                         [](const Term& term) { return isNumber(term.shape); });
  if (!hasMethod && !output.terms.empty())
    output.defuzzifier = numbers ? Defuzzifier::WeightedAverage : Defuzzifier::Centroid;
  if (!isArea(output.defuzzifier)) return true;
  if (output.defuzzifier == Defuzzifier::Centroid && numbers) {
    output.defuzzifier = Defuzzifier::WeightedAverage;
    return false;
  }
  if (!output.aggregation) output.aggregation = SNorm::Maximum;
  inferRange(output);
  return true;
}

} // namespace esm::fis
