// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "tests/core/fuzzy/small_rules.h"

#include <cmath>

namespace esm::fuzzy {
namespace {

struct Case {
  const char* name;
  Shape shape;
  std::vector<double> parameters;
  double x, expected;
};

// By hand from the definitions; tolerance 1e-15 is rounding.
TEST(Membership, FollowsItsDefinition)
{
  const Case cases[] = {
    {"foot", Shape::Triangle, {0, 1, 3}, 0.0, 0.0},
    {"left flank", Shape::Triangle, {0, 1, 3}, 0.25, 0.25},
    {"peak", Shape::Triangle, {0, 1, 3}, 1.0, 1.0},
    {"right flank", Shape::Triangle, {0, 1, 3}, 2.5, 0.25},
    {"outside", Shape::Triangle, {0, 1, 3}, 3.5, 0.0},
    {"upright flank holds its edge", Shape::Triangle, {1, 1, 2}, 1.0, 1.0},
    {"before an upright flank", Shape::Triangle, {1, 1, 2}, 0.999, 0.0},
    {"a single place", Shape::Triangle, {1, 1, 1}, 1.0, 1.0},
    {"beside a single place", Shape::Triangle, {1, 1, 1}, 1.001, 0.0},
    {"left shoulder", Shape::Triangle, {-kInfinity, 1, 2}, -1e300, 1.0},
    {"flank of a left shoulder", Shape::Triangle, {-kInfinity, 1, 2}, 1.75, 0.25},
    {"right shoulder", Shape::Triangle, {0, 1, kInfinity}, kInfinity, 1.0},
    {"plateau", Shape::Trapezoid, {0, 1, 2, 4}, 1.5, 1.0},
    {"flank of a trapezoid", Shape::Trapezoid, {0, 1, 2, 4}, 3.0, 0.5},
    {"box", Shape::Trapezoid, {1, 1, 2, 2}, 2.0, 1.0},
    {"beyond a box", Shape::Trapezoid, {1, 1, 2, 2}, 2.001, 0.0},
    {"bell at its mean", Shape::Gaussian, {2, 0.5}, 2.0, 1.0},
    {"bell one deviation off", Shape::Gaussian, {2, 0.5}, 2.5, std::exp(-0.5)},
    {"NaN belongs nowhere", Shape::Trapezoid, {-kInfinity, 0, 0, kInfinity}, std::nan(""), 0.0},
    {"numbers missing", Shape::Triangle, {0, 1}, 0.5, 0.0},
  };
  for (const Case& c : cases)
    EXPECT_NEAR(membership(makeTerm("t", c.shape, c.parameters), c.x), c.expected, 1e-15) << c.name;
}

// A term that is being typed may be anything; its membership is still a number in [0, 1].
TEST(Membership, IsANumberForNonsenseTerms)
{
  const double values[] = {0.0, -1.0, 1e308, -1e308, kInfinity, -kInfinity, std::nan("")};
  for (const double a : values)
    for (const double b : values)
      for (const double x : values)
        for (const Shape shape : {Shape::Triangle, Shape::Gaussian}) {
          const std::vector<double> p = shape == Shape::Gaussian ? std::vector{a, b} : std::vector{a, b, a};
          const double degree = membership(makeTerm("t", shape, p), x);
          EXPECT_TRUE(degree >= 0.0 && degree <= 1.0) << a << ' ' << b << ' ' << x;
        }
}

TEST(Hedges, ApplyFromTheLastOutward)
{
  EXPECT_DOUBLE_EQ(applyHedges({Hedge::Very}, 0.5), 0.25);
  EXPECT_DOUBLE_EQ(applyHedges({Hedge::Extremely}, 0.5), 0.125);
  EXPECT_DOUBLE_EQ(applyHedges({Hedge::Somewhat}, 0.25), 0.5);
  EXPECT_DOUBLE_EQ(applyHedges({Hedge::Not}, 0.25), 0.75);
  EXPECT_DOUBLE_EQ(applyHedges({Hedge::Not, Hedge::Very}, 0.5), 0.75); // not (very hard)
  EXPECT_DOUBLE_EQ(applyHedges({Hedge::Very, Hedge::Not}, 0.5), 0.25); // very (not hard)
  EXPECT_DOUBLE_EQ(applyHedges({}, 0.3), 0.3);
}

TEST(BestTerm, NamesAValueByItsNearestWord)
{
  Variable variable{"v",
                    {},
                    "Pa",
                    1.0,
                    1e6,
                    1.0,
                    true,
                    {makeTerm("low", Shape::Triangle, {-kInfinity, 1, 4}),
                     makeTerm("high", Shape::Triangle, {1, 4, kInfinity})}};
  EXPECT_EQ(bestTerm(variable, 10.0).term, 0); // log10 = 1
  EXPECT_EQ(bestTerm(variable, 1e5).term, 1);
  EXPECT_NEAR(bestTerm(variable, std::pow(10.0, 1.75)).degree, 0.75, 1e-12);
  EXPECT_EQ(bestTerm(variable, -5.0).term, 0) << "below the range is its lower end";
  variable.terms.clear();
  EXPECT_EQ(bestTerm(variable, 1.0).term, -1);
}

} // namespace
} // namespace esm::fuzzy
