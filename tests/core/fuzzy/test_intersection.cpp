// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/fuzzy/axis.h"
#include "core/fuzzy/fis/evaluator.h"
#include "core/fuzzy/to_system.h"
#include "tests/core/fuzzy/small_rules.h"

#include <cmath>
#include <random>

namespace esm::fuzzy {
namespace {

double height(const Term& a, const Term& b, const std::vector<Hedge>& hedgesA = {},
              const std::vector<Hedge>& hedgesB = {}, Axis axis = {0, 10})
{
  return fis::heightOfIntersection(toTerm(a), toHedges(hedgesA), toTerm(b), toHedges(hedgesB), axis.low,
                                   axis.high);
}

// By hand: where the falling flank of one meets the rising flank of the other.
TEST(HeightOfIntersection, OfPolygonsByHand)
{
  const Term one = makeTerm("a", Shape::Triangle, {0, 1, 2});
  EXPECT_DOUBLE_EQ(height(one, makeTerm("b", Shape::Triangle, {1, 2, 3})), 0.5);
  EXPECT_NEAR(height(one, makeTerm("b", Shape::Triangle, {1.5, 2, 3})), 1.0 / 3.0, 1e-15); // 2-x = 2x-3
  EXPECT_DOUBLE_EQ(height(one, makeTerm("b", Shape::Trapezoid, {0.5, 1, 4, 5})), 1.0);
  EXPECT_DOUBLE_EQ(height(one, makeTerm("b", Shape::Triangle, {3, 4, 5})), 0.0);
  EXPECT_DOUBLE_EQ(height(one, one), 1.0);
}

TEST(HeightOfIntersection, SeesUprightFlanksAndSinglePlaces)
{
  const Term one = makeTerm("a", Shape::Triangle, {0, 1, 2});
  EXPECT_DOUBLE_EQ(height(one, makeTerm("b", Shape::Triangle, {1.75, 1.75, 1.75})), 0.25);
  EXPECT_DOUBLE_EQ(height(one, makeTerm("b", Shape::Trapezoid, {1.5, 1.5, 9, 9})), 0.5);
  EXPECT_DOUBLE_EQ(height(one, makeTerm("b", Shape::Trapezoid, {-kInfinity, 0, 0.5, 0.5})), 0.5);
}

TEST(HeightOfIntersection, StopsAtTheRange)
{
  // Both are 1 at 1, but the range ends at 0.25.
  const Term one = makeTerm("a", Shape::Triangle, {0, 1, 2});
  EXPECT_DOUBLE_EQ(height(one, one, {}, {}, {0, 0.25}), 0.25);
}

// Equal bells two deviations apart cross midway, one deviation from each mean.
TEST(HeightOfIntersection, OfBells)
{
  EXPECT_NEAR(height(makeTerm("a", Shape::Gaussian, {3, 1}), makeTerm("b", Shape::Gaussian, {5, 1})),
              std::exp(-0.5), 1e-15);
}

// very: 2-x = (x-1)^2 at x = (1+sqrt 5)/2, height 2-x. not: a set meets its complement at 1/2.
TEST(HeightOfIntersection, OfHedgedSets)
{
  const Term one = makeTerm("a", Shape::Triangle, {0, 1, 2}), two = makeTerm("b", Shape::Triangle, {1, 2, 3});
  EXPECT_NEAR(height(one, two, {}, {Hedge::Very}), 2.0 - (1.0 + std::sqrt(5.0)) / 2.0, 1e-15);
  EXPECT_NEAR(height(one, one, {}, {Hedge::Not}), 0.5, 1e-15);
}

// Sampling can only miss the highest place, by no more than slope times half a step: slopes reach
// 3 / 0.3 (very extremely), the step is 1e-3 ... so 5e-3; sqrt feet lie at height 0 and do not matter.
TEST(HeightOfIntersection, IsNeverBelowAndHardlyAboveASampledOne)
{
  std::mt19937 random(5);
  const auto number = [&](double a, double b) { return std::uniform_real_distribution(a, b)(random); };
  const std::vector<std::vector<Hedge>> hedges = {{}, {Hedge::Very}, {Hedge::Extremely}, {Hedge::Not}};
  for (int i = 0; i < 200; ++i) {
    const double a = number(0, 8), b = a + number(0.4, 2), c = b + number(0.4, 2), m = number(0, 10);
    const Term s = makeTerm("a", Shape::Triangle, {a, b, c});
    const Term t = i % 2 ? makeTerm("b", Shape::Gaussian, {m, number(0.4, 2)})
                         : makeTerm("b", Shape::Trapezoid, {m - 1, m, m + 0.5, m + 2});
    const auto& ha = hedges[static_cast<std::size_t>(i) % 4];
    const auto& hb = hedges[static_cast<std::size_t>(i / 4) % 4];
    double sampled = 0.0;
    for (int k = 0; k <= 10000; ++k)
      sampled = std::max(sampled, std::min(applyHedges(ha, membership(s, k * 1e-3)),
                                           applyHedges(hb, membership(t, k * 1e-3))));
    const double exact = height(s, t, ha, hb);
    EXPECT_GE(exact, sampled - 1e-15) << "case " << i;
    EXPECT_LE(exact, sampled + 5e-3) << "case " << i;
  }
}

} // namespace
} // namespace esm::fuzzy
