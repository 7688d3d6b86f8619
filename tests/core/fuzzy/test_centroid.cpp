// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/fuzzy/axis.h"
#include "core/fuzzy/fis/evaluator.h"
#include "core/fuzzy/to_system.h"
#include "tests/core/fuzzy/small_rules.h"

#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <random>

namespace esm::fuzzy {
namespace {

/// A random clipped set that owns its term and hedges.
struct OwnedSet {
  Term term;
  std::vector<Hedge> hedges;
  double degree = 1.0;
};

/// The centroid of the sets by the engine: one rule each, that always holds, with the degree as its weight.
std::optional<double> centroid(const std::vector<OwnedSet>& sets, const Axis& axis)
{
  fis::System system;
  system.inputs.emplace_back().name = "in";
  system.inputs[0].terms = {{"always", fis::Shape::Constant, {1.0}, 1.0, {}}};
  fis::OutputVariable& output = system.outputs.emplace_back();
  output.name = "out";
  output.minimum = axis.low;
  output.maximum = axis.high;
  fis::RuleBlock& block = system.blocks.emplace_back();
  block.conclusionHedges = fis::ConclusionHedges::OnSet;
  for (const OwnedSet& set : sets) {
    const int place = static_cast<int>(output.terms.size());
    output.terms.push_back(toTerm(set.term));
    output.terms.back().name = "t" + std::to_string(place);
    fis::Rule rule;
    rule.antecedent.nodes = {{fis::Antecedent::Kind::Proposition, {false, 0, 0, {}}, {}}};
    rule.consequents = {{true, 0, place, toHedges(set.hedges)}};
    rule.weight = set.degree;
    block.rules.push_back(std::move(rule));
  }
  const auto evaluator = fis::Evaluator::create(system);
  if (!evaluator) {
    ADD_FAILURE() << evaluator.error().detail;
    return std::nullopt;
  }
  fis::Workspace workspace = evaluator->makeWorkspace();
  evaluator->evaluate(std::array{0.0}, workspace);
  const fis::OutputResult result = workspace.outputs()[0];
  if (result.origin != fis::Origin::Rules) return std::nullopt;
  return result.value;
}

/// Independent of the code under test: the midpoint rule over the definition.
struct BruteForce {
  double centre = 0.0, area = 0.0; ///< area in units of the axis' length
};
BruteForce bruteForce(const std::vector<OwnedSet>& sets, const Axis& axis, int cells)
{
  BruteForce result;
  double moment = 0.0;
  for (int i = 0; i < cells; ++i) {
    const double x = axis.low + (axis.high - axis.low) * (i + 0.5) / cells;
    double height = 0.0;
    for (const OwnedSet& set : sets)
      height = std::max(height, std::min(applyHedges(set.hedges, membership(set.term, x)), set.degree));
    result.area += height / cells;
    moment += x * height / cells;
  }
  result.centre = moment / result.area;
  return result;
}

class RandomSets {
public:
  explicit RandomSets(unsigned seed) : m_random(seed) {}
  double number(double from, double to) { return std::uniform_real_distribution(from, to)(m_random); }
  int integer(int from, int to) { return std::uniform_int_distribution(from, to)(m_random); }

  /// Flanks at least 0.3 wide on an axis of length 10.
  Term polygon()
  {
    double x = number(-2.0, 8.0);
    std::vector<double> corners = {x};
    const int more = integer(2, 3);
    for (int i = 0; i < more; ++i) corners.push_back(x += number(0.3, 3.0));
    if (integer(0, 4) == 0) corners.front() = -kInfinity;
    if (integer(0, 4) == 0) corners.back() = kInfinity;
    return makeTerm("t", more == 2 ? Shape::Triangle : Shape::Trapezoid, corners);
  }
  Term bell() { return makeTerm("t", Shape::Gaussian, {number(0.0, 10.0), number(0.3, 2.0)}); }
  std::vector<Hedge> hedges()
  {
    static constexpr Hedge kHedges[] = {Hedge::Very, Hedge::Extremely, Hedge::Somewhat};
    std::vector<Hedge> result;
    for (int i = integer(0, 2); i > 0; --i) result.push_back(kHedges[integer(0, 2)]);
    return result;
  }

private:
  std::mt19937 m_random;
};

double centreOf(const Term& term, double degree, const Axis& axis)
{
  return *centroid({{term, {}, degree}}, axis);
}

// A symmetric triangle stays symmetric under clipping. 1e-14: rounding.
TEST(Centroid, OfAClippedSymmetricTriangleIsItsPeak)
{
  const Term term = makeTerm("t", Shape::Triangle, {1, 3, 5});
  for (const double degree : {1e-9, 0.1, 0.5, 1.0}) EXPECT_NEAR(centreOf(term, degree, {0, 10}), 3.0, 1e-13);
}

// Triangle 0 0 3 clipped at h: height h up to 3(1-h), then a flank of area 3h^2/2 around 3-2h. So
// area 3h(1-h/2), moment 9h(1-h)^2/2 + 3h^2/2 (3-2h); at h = 1/2 the centre is 1.3125/1.125 = 7/6.
TEST(Centroid, OfAClippedUprightTriangle)
{
  const Term term = makeTerm("t", Shape::Triangle, {0, 0, 3});
  EXPECT_NEAR(centreOf(term, 0.5, {0, 10}), 7.0 / 6.0, 1e-14);
  EXPECT_NEAR(centreOf(term, 1.0, {0, 10}), 1.0, 1e-14);
}

TEST(Centroid, OfAShoulderEndsWithTheRange)
{
  const Term term = makeTerm("t", Shape::Trapezoid, {-kInfinity, 0, 2, 2});
  EXPECT_NEAR(centreOf(term, 0.3, {-4, 10}), -1.0, 1e-14); // a box from -4 to 2
}

// low = 1-x at 1/4, high = x at 3/4 on [0, 1]. Their maximum is 1/4 up to 1/4, then x up to 3/4, then 3/4:
// area 1/16 + 1/4 + 3/16 = 1/2, moment 1/128 + 13/96 + 21/128 = 59/192, centre 59/96.
TEST(Centroid, OfTwoCrossingTrianglesByHand)
{
  const std::vector<OwnedSet> sets = {{makeTerm("low", Shape::Triangle, {0, 0, 1}), {}, 0.25},
                                      {makeTerm("high", Shape::Triangle, {0, 1, 1}), {}, 0.75}};
  EXPECT_NEAR(*centroid(sets, {0, 1}), 59.0 / 96.0, 1e-15);
}

// x^2 on [0, 1] has its centre at 3/4, sqrt(x) at 3/5. 1e-10 is what the quadrature promises.
TEST(Centroid, OfHedgedTrianglesByHand)
{
  const std::vector<OwnedSet> very = {{makeTerm("t", Shape::Triangle, {0, 1, 1}), {Hedge::Very}, 1.0}};
  const std::vector<OwnedSet> somewhat = {
    {makeTerm("t", Shape::Triangle, {0, 1, 1}), {Hedge::Somewhat}, 1.0}};
  EXPECT_NEAR(*centroid(very, {0, 1}), 0.75, 1e-12);
  EXPECT_NEAR(*centroid(somewhat, {0, 1}), 0.6, 1e-10);
}

// Half a bell: mean + s sqrt(2/pi), the range ending 20 deviations away where nothing is left.
TEST(Centroid, OfHalfABell)
{
  EXPECT_NEAR(centreOf(makeTerm("t", Shape::Gaussian, {1, 0.5}), 1.0, {1, 11}),
              1.0 + 0.5 * std::sqrt(2.0 / std::numbers::pi), 1e-10);
  // A bell of a millionth of the range is not stepped over.
  EXPECT_NEAR(centreOf(makeTerm("t", Shape::Gaussian, {3.1, 1e-5}), 0.5, {0, 10}), 3.1, 1e-9);
}

// The centre does not depend on where and how long the axis is.
TEST(Centroid, MovesAndScalesWithTheAxis)
{
  for (const double scale : {1e-30, 1.0, 1e30}) {
    const Term term = makeTerm("t", Shape::Triangle, {0.0, 0.0, 3.0 * scale});
    EXPECT_NEAR(centreOf(term, 0.5, {0.0, 10.0 * scale}) / scale, 7.0 / 6.0, 1e-13) << scale;
  }
}

// Closed form against brute force: the midpoint rule with cell h errs at a kink by at most
// (change of slope) h^2 / 8; 30 kinks of slope 4 (flanks of 0.3 of 10 make 33 per unit axis) at
// h = 1/40000 leave 30 * 33 / 8 * 6e-10 = 8e-8 of area, divided by the area itself; times length 10.
TEST(Centroid, AgreesWithBruteForceForPolygons)
{
  RandomSets random(11);
  for (int i = 0; i < 60; ++i) {
    std::vector<OwnedSet> sets;
    for (int k = random.integer(1, 5); k > 0; --k)
      sets.push_back({random.polygon(), {}, random.number(0.05, 1.0)});
    const BruteForce expected = bruteForce(sets, {0, 10}, 40000);
    EXPECT_NEAR(*centroid(sets, {0, 10}), expected.centre, 10 * 8e-8 / expected.area) << "case " << i;
  }
}

// As above with bells and hedges; sqrt at a foot has an unbounded slope, whose midpoint error is about
// 0.1 h^1.5 sqrt(33) = 7e-8 per foot.
TEST(Centroid, AgreesWithBruteForceForBellsAndHedges)
{
  RandomSets random(12);
  for (int i = 0; i < 60; ++i) {
    std::vector<OwnedSet> sets;
    for (int k = random.integer(1, 4); k > 0; --k)
      sets.push_back(
        {random.integer(0, 1) ? random.bell() : random.polygon(), random.hedges(), random.number(0.05, 1.0)});
    const BruteForce expected = bruteForce(sets, {0, 10}, 40000);
    EXPECT_NEAR(*centroid(sets, {0, 10}), expected.centre, 10 * 6e-7 / expected.area) << "case " << i;
  }
}

// The two ways of integrating agree where both apply: an idle hedge pair (very of somewhat) forces the
// quadrature. 1e-9: sqrt and square do not cancel to the last bit, and the quadrature promises 1e-10.
TEST(Centroid, QuadratureAgreesWithTheClosedForm)
{
  RandomSets random(13);
  for (int i = 0; i < 100; ++i) {
    std::vector<OwnedSet> sets;
    for (int k = random.integer(1, 5); k > 0; --k)
      sets.push_back({random.polygon(), {}, random.number(0.05, 1.0)});
    const double closed = *centroid(sets, {0, 10});
    sets.front().hedges = {Hedge::Very, Hedge::Somewhat};
    EXPECT_NEAR(*centroid(sets, {0, 10}), closed, 1e-9) << "case " << i;
  }
}

TEST(Centroid, OfNothingIsNothing)
{
  EXPECT_FALSE(centroid({}, {0, 1}).has_value());
  const Term outside = makeTerm("t", Shape::Triangle, {5, 6, 7});
  EXPECT_FALSE(centroid({{outside, {}, 1.0}}, {0, 1}).has_value());
}

} // namespace
} // namespace esm::fuzzy
