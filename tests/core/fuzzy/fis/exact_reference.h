// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

// The exact mode against an integrator that knows of a curve only the numbers in its definition: Boole's rule
// in long double, halved until two halves agree with their whole.
#include "core/fuzzy/fis/evaluator.h"
#include "tests/core/fuzzy/fis/random_system.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace esm::fis {

struct Moments {
  long double area = 0, moment = 0;
};

/// Boole's closed rule of 5 points, of which the ends and the middle are known.
struct Part {
  double a, b;
  std::array<long double, 5> y;
  Moments sum() const
  {
    static constexpr std::array<long double, 5> kWeight = {7.0L / 90, 32.0L / 90, 12.0L / 90, 32.0L / 90,
                                                           7.0L / 90};
    const long double width = static_cast<long double>(b) - a;
    Moments sum;
    for (std::size_t i = 0; i < 5; ++i) {
      sum.area += width * kWeight[i] * y[i];
      sum.moment += width * kWeight[i] * y[i] * (a + width * 0.25L * static_cast<long double>(i));
    }
    return sum;
  }
};

/// Integrates in parts, each to 1e-16 of the area. Where norms divide by nearly nothing the set is rounding
/// noise that no halving makes smooth: then the budget runs out and there is no reference.
template <class F>
class Integral {
public:
  /// @param numbers of which those inside become ends of parts: a rule that hardly fires may leave of a curve
  /// no more than the tip above one of them.
  Integral(const F& f, double a, double b, const std::vector<double>& numbers) : m_f(f)
  {
    constexpr int kParts =
      1009; // many, lest a narrow top be missed; a prime, so that no part ends where sets tend to
    std::vector<double> ends;
    for (int i = 0; i <= kParts; ++i) ends.push_back(a + (b - a) * i / kParts);
    for (const double number : numbers)
      if (number > a && number < b) ends.push_back(number);
    std::sort(ends.begin(), ends.end());
    for (const bool measures : {true, false})
      for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        const double x0 = ends[i], x1 = ends[i + 1];
        const Part part{x0,
                        x1,
                        {value(x0), value(0.75 * x0 + 0.25 * x1), value(0.5 * (x0 + x1)),
                         value(0.25 * x0 + 0.75 * x1), value(x1)}};
        if (measures)
          m_tolerance += 1e-16L * std::abs(part.sum().area);
        else
          add(part, 46);
      }
  }
  bool isSound() const { return m_budget > 0; }
  const Moments& sum() const { return m_sum; }

private:
  long double value(double x) const { return static_cast<long double>(m_f(x)); }

  void add(const Part& whole, int depth)
  {
    const double middle = 0.5 * (whole.a + whole.b);
    const auto& y = whole.y;
    const Part left{
      whole.a,
      middle,
      {y[0], value(0.75 * whole.a + 0.25 * middle), y[1], value(0.25 * whole.a + 0.75 * middle), y[2]}};
    const Part right{
      middle,
      whole.b,
      {y[2], value(0.75 * middle + 0.25 * whole.b), y[3], value(0.25 * middle + 0.75 * whole.b), y[4]}};
    const Moments l = left.sum(), r = right.sum(), w = whole.sum();
    const bool fine = std::abs(l.area + r.area - w.area) <= m_tolerance &&
                      std::abs(l.moment + r.moment - w.moment) <= m_tolerance;
    if (fine || depth == 0 || --m_budget <= 0) {
      m_sum.area += l.area + r.area;
      m_sum.moment += l.moment + r.moment;
      return;
    }
    add(left, depth - 1);
    add(right, depth - 1);
  }

  const F& m_f;
  Moments m_sum;
  long double m_tolerance = 0;
  int m_budget = 40000;
};

struct Deviation {
  double centroid = 0.0, bisector = 0.0;
  int centroids = 0, bisectors = 0, maxima = 0, noise = 0;
};

inline void checkMaximum(const Evaluator& evaluator, const Workspace& workspace, int output, double value,
                         Defuzzifier defuzzifier, std::uint64_t seed)
{
  const OutputVariable& variable = evaluator.system().outputs[static_cast<std::size_t>(output)];
  const auto height = [&](double x) { return evaluator.aggregatedAt(output, x, workspace); };
  double highest = 0.0;
  constexpr int kSteps = 400;
  const double step = (variable.maximum - variable.minimum) / kSteps;
  for (int i = 0; i < kSteps; ++i) highest = std::max(highest, height(variable.minimum + (i + 0.5) * step));
  // Right beside the place too: at an edge the place itself may round to the low side.
  const double near = std::max({height(value), height(value - 1e-9), height(value + 1e-9)});
  if (defuzzifier != Defuzzifier::MeanOfMaximum) {
    EXPECT_GE(near, highest * (1.0 - 1e-4)) << "seed " << seed;
  }
  for (int i = 0; i < kSteps; ++i) {
    const double x = variable.minimum + (i + 0.5) * step;
    const bool before = defuzzifier == Defuzzifier::SmallestOfMaximum && x < value - 1e-6;
    const bool behind = defuzzifier == Defuzzifier::LargestOfMaximum && x > value + 1e-6;
    if (before || behind) {
      EXPECT_LE(height(x), near + 1e-12) << "seed " << seed << " at " << x;
      EXPECT_LT(height(x), near * (1 + 1e-10))
        << "seed " << seed << " at " << x << ": an earlier (later) highest place";
    }
  }
}

inline Deviation compare(int engines, std::uint64_t firstSeed)
{
  Deviation worst;
  for (int e = 0; e < engines; ++e) {
    const std::uint64_t seed = firstSeed + static_cast<std::uint64_t>(e);
    Dice dice(seed);
    Recipe recipe = everything();
    recipe.conclusionHedges = e % 3 == 0;
    recipe.options = false;
    // Where the drastic product asks for exactly 1, the top of a bell is as wide as its rounding: no area.
    std::erase(recipe.implications, TNorm::DrasticProduct);
    if (e % 2 == 0) recipe.aggregations = {SNorm::Maximum};
    if (e % 4 == 0) recipe.implications = {TNorm::Minimum, TNorm::AlgebraicProduct};
    System system = randomSystem(dice, recipe);
    if (e % 3 == 0)
      for (RuleBlock& block : system.blocks) block.conclusionHedges = ConclusionHedges::OnSet;
    const auto evaluator = Evaluator::create(system);
    if (!evaluator) {
      ADD_FAILURE() << evaluator.error().detail;
      return worst;
    }
    Workspace workspace = evaluator->makeWorkspace();
    evaluator->evaluate(randomRow(dice, system), workspace);
    for (std::size_t o = 0; o < system.outputs.size(); ++o) {
      const OutputResult result = workspace.outputs()[o];
      if (result.origin != Origin::Rules) continue;
      const OutputVariable& variable = system.outputs[o];
      const double range = variable.maximum - variable.minimum;
      const auto height = [&](double x) {
        return evaluator->aggregatedAt(static_cast<int>(o), x, workspace);
      };
      std::vector<double> numbers;
      for (const Term& term : variable.terms)
        numbers.insert(numbers.end(), term.parameters.begin(), term.parameters.end());
      // Of a set that is next to nothing only the roundings of its edges are left: 1e-15 of the range.
      const auto note = [&](double error, double area) {
        if (area < 1e-9) return;
        EXPECT_LE(error - 1e-15 / area, 1e-12) << "seed " << seed << " output " << o << " area " << area;
      };
      if (variable.defuzzifier == Defuzzifier::Centroid) {
        const Integral integral(height, variable.minimum, variable.maximum, numbers);
        if (!integral.isSound()) {
          ++worst.noise;
          continue;
        }
        const Moments& whole = integral.sum();
        const double error = std::abs(result.value - static_cast<double>(whole.moment / whole.area)) / range;
        note(error, static_cast<double>(whole.area) / range);
        worst.centroid = std::max(worst.centroid, error);
        ++worst.centroids;
      } else if (variable.defuzzifier == Defuzzifier::Bisector) {
        const Integral below(height, variable.minimum, result.value, numbers),
          above(height, result.value, variable.maximum, numbers);
        if (!below.isSound() || !above.isSound()) {
          ++worst.noise;
          continue;
        }
        const Moments &left = below.sum(), &right = above.sum();
        const double error = static_cast<double>(std::abs(left.area - right.area) / (left.area + right.area));
        note(error, static_cast<double>(left.area + right.area) / range);
        worst.bisector = std::max(worst.bisector, error);
        ++worst.bisectors;
      } else {
        checkMaximum(*evaluator, workspace, static_cast<int>(o), result.value, variable.defuzzifier, seed);
        ++worst.maxima;
      }
    }
  }
  return worst;
}

} // namespace esm::fis
