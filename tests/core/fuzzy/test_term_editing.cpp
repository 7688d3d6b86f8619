// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/fuzzy/term_editing.h"
#include "tests/core/fuzzy/small_rules.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace esm::fuzzy {
namespace {

constexpr Handle kAllHandles[] = {Handle::LeftFoot,      Handle::LeftShoulder, Handle::Peak,
                                  Handle::RightShoulder, Handle::RightFoot,    Handle::LeftFlank,
                                  Handle::RightFlank,    Handle::Curve};

Variable variableOf(std::vector<Term> terms)
{
  return {"v", {"v", "v"}, "", 0.0, 1.0, 0.5, false, std::move(terms)};
}

/// soft, medium, hard: shoulders outside, as an input of the tissue.
Variable threeWords()
{
  return variableOf({makeTerm("soft", Shape::Triangle, {-kInfinity, 0, 0.5}),
                     makeTerm("medium", Shape::Triangle, {0, 0.5, 1}),
                     makeTerm("hard", Shape::Triangle, {0.5, 1, kInfinity})});
}

/// Trapezoids and triangles, and an upright left end that fills the range.
Variable mixedWords()
{
  return variableOf({makeTerm("hard", Shape::Trapezoid, {0.65, 0.8, 0.9, kInfinity}),
                     makeTerm("soft", Shape::Trapezoid, {0, 0, 0.1, 0.3}),
                     makeTerm("medium", Shape::Trapezoid, {0.1, 0.3, 0.5, 0.65}),
                     makeTerm("firm", Shape::Triangle, {0.5, 0.65, 0.8})});
}

/// Logarithmic, outer terms as wide outward as inward, as an output of the tissue.
Variable stiffness()
{
  Variable variable = variableOf({makeTerm("low", Shape::Triangle, {2.5, 3, 3.5}),
                                  makeTerm("medium", Shape::Triangle, {3, 3.5, 5}),
                                  makeTerm("high", Shape::Triangle, {3.5, 5, 6.5})});
  variable.logarithmic = true;
  variable.minimum = 300;
  variable.maximum = 1e7;
  variable.defaultValue = 1e4;
  return variable;
}

double sumAt(const Variable& variable, double x)
{
  double sum = 0.0;
  for (const Term& term : variable.terms) sum += membership(term, x);
  return sum;
}

/// Where a partition must sum to 1: from the first core to the last, or to the end where it did before.
void expectSumOne(const Variable& variable, bool toTheEnds)
{
  const std::vector<int> order = orderOfCores(variable);
  const auto corner = [&](int term, std::size_t i) {
    return variable.terms[static_cast<std::size_t>(term)].parameters[i];
  };
  const Axis axis = axisOf(variable);
  const double from = toTheEnds ? axis.low : corner(order.front(), 1);
  const double to = toTheEnds ? axis.high : corner(order.back(), 1);
  for (int i = 0; i <= 50; ++i) {
    const double x = std::min(from + (to - from) * i / 50, to); // an outer flank may be upright
    EXPECT_NEAR(sumAt(variable, x), 1.0, 1e-9) << x; // flanks down to 1/1000 of the range: 1e-16 / 1e-3 each
  }
}

bool passes(const Variable& variable, bool output)
{
  RuleBase base;
  (output ? base.outputs : base.inputs).push_back(variable);
  return static_cast<bool>(checkRuleBase(base));
}

bool ordered(const Term& term)
{
  return term.shape == Shape::Gaussian || std::is_sorted(term.parameters.begin(), term.parameters.end());
}

/// Random drags: any handle of any term to any place, also far beyond the range.
template <class Check>
void dragAtRandom(Variable variable, bool keepPartition, Check check)
{
  std::mt19937 random(7);
  const Axis axis = axisOf(variable);
  std::uniform_real_distribution<double> place(axis.low - 0.3 * (axis.high - axis.low),
                                               axis.high + 0.3 * (axis.high - axis.low));
  for (int i = 0; i < 600; ++i) {
    const int term = static_cast<int>(random() % variable.terms.size());
    std::vector<Handle> handles = handlesOf(variable.terms[static_cast<std::size_t>(term)]);
    handles.push_back(Handle::Curve);
    const Handle handle = handles[random() % handles.size()];
    variable.terms = moveHandle(variable, term, handle, place(random), keepPartition);
    check(variable, term, handle);
    if (testing::Test::HasFailure()) return;
  }
}

TEST(TermEditing, SumStaysOneUnderAnyDragsOfAKeptPartition)
{
  for (const Variable& start : {threeWords(), mixedWords(), stiffness()}) {
    ASSERT_TRUE(isPartition(start));
    const bool toTheEnds = !start.logarithmic;
    dragAtRandom(start, true, [&](const Variable& variable, int, Handle) {
      EXPECT_TRUE(isPartition(variable));
      expectSumOne(variable, toTheEnds);
    });
  }
}

TEST(TermEditing, OrderOfCornersAndValidityHoldUnderAnyDrags)
{
  Variable mixed = mixedWords();
  mixed.terms.push_back(makeTerm("bell", Shape::Gaussian, {0.4, 0.1}));
  mixed.terms.push_back(makeTerm("wide", Shape::Triangle, {-0.5, 0.5, 1.5}));
  for (const Variable& start : {threeWords(), mixed, stiffness()})
    for (const bool keep : {false, true})
      dragAtRandom(start, keep, [&](const Variable& variable, int term, Handle handle) {
        EXPECT_TRUE(std::all_of(variable.terms.begin(), variable.terms.end(), ordered));
        EXPECT_TRUE(passes(variable, true)) << term << ' ' << static_cast<int>(handle);
      });
}

TEST(TermEditing, ADraggedHandleGoesWhereItIsLedOrToItsLimit)
{
  Variable mixed = mixedWords();
  mixed.terms.push_back(makeTerm("bell", Shape::Gaussian, {0.4, 0.1}));
  for (const Variable& start : {threeWords(), mixedWords(), mixed})
    for (const bool keep : {false, true})
      for (int term = 0; term < static_cast<int>(start.terms.size()); ++term)
        for (const Handle handle : handlesOf(start.terms[static_cast<std::size_t>(term)]))
          for (const double to : {-1.0, 0.0, 0.35, 0.55, 1.0, 2.0}) {
            const Limits limits = limitsOf(start, term, handle, keep);
            Variable moved = start;
            moved.terms = moveHandle(start, term, handle, to, keep);
            const Term& now = moved.terms[static_cast<std::size_t>(term)];
            const std::vector<Handle> left = handlesOf(now); // a foot that became a shoulder has no place
            if (std::find(left.begin(), left.end(), handle) == left.end()) continue;
            EXPECT_NEAR(placeOf(now, handle), std::clamp(to, limits.least, limits.greatest), 1e-15);
            EXPECT_GE(limits.least, 0.0);
            EXPECT_LE(limits.greatest, 1.0);
          }
}

TEST(TermEditing, NeighboursFeetFollowAPeakAndAFootLeadsTheNeighboursPeak)
{
  const Variable start = threeWords();
  for (const auto& terms :
       {moveHandle(start, 1, Handle::Peak, 0.4, true), moveHandle(start, 0, Handle::RightFoot, 0.4, true),
        moveHandle(start, 2, Handle::LeftFoot, 0.4, true)}) {
    EXPECT_EQ(terms[0].parameters, (std::vector<double>{-kInfinity, 0, 0.4}));
    EXPECT_EQ(terms[1].parameters, (std::vector<double>{0, 0.4, 1}));
    EXPECT_EQ(terms[2].parameters, (std::vector<double>{0.4, 1, kInfinity}));
  }
  const auto alone = moveHandle(start, 1, Handle::Peak, 0.4, false);
  EXPECT_EQ(alone[0], start.terms[0]);
  EXPECT_EQ(alone[2], start.terms[2]);
  EXPECT_EQ(alone[1].parameters, (std::vector<double>{0, 0.4, 1}));
}

// Rules conclude the centre of an output's term; the outermost must keep it at its peak.
TEST(TermEditing, AnOuterFlankAsWideAsTheInnerStaysSo)
{
  auto terms = moveHandle(stiffness(), 0, Handle::Peak, 3.25, true);
  EXPECT_EQ(terms[0].parameters, (std::vector<double>{3.0, 3.25, 3.5}));
  terms = moveHandle(stiffness(), 1, Handle::Peak, 4.0, true);
  EXPECT_EQ(terms[0].parameters, (std::vector<double>{2.0, 3.0, 4.0}));
  EXPECT_EQ(terms[2].parameters, (std::vector<double>{4.0, 5.0, 6.0}));
}

TEST(TermEditing, AWholeCurveKeepsItsForm)
{
  const Variable start = mixedWords();
  const auto terms = moveHandle(start, 2, Handle::Curve, 0.5, false);
  const std::vector<double> expected{0.2, 0.4, 0.6, 0.75};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(terms[2].parameters[i], expected[i], 1e-15);
  // Its flat part stays in the range, however far it is led.
  EXPECT_NEAR(moveHandle(start, 2, Handle::Curve, 9.0, false)[2].parameters[2], 1.0, 1e-15);
}

TEST(TermEditing, GapsAndOverlapsAreNoPartition)
{
  Variable variable = threeWords();
  variable.terms[0].parameters[2] = 0.45;
  EXPECT_FALSE(isPartition(variable));
  variable.terms[0].parameters[2] = 0.55;
  EXPECT_FALSE(isPartition(variable));
  variable = threeWords();
  variable.terms[1] = makeTerm("medium", Shape::Gaussian, {0.5, 0.2});
  EXPECT_FALSE(isPartition(variable));
  EXPECT_FALSE(isPartition(variableOf({})));
}

TEST(TermEditing, FittingMakesAPartitionOfAnyWordsWithDistinctCores)
{
  Variable variable = threeWords();
  variable.terms[0].parameters = {-kInfinity, 0.1, 0.2};
  variable.terms[1].parameters = {0.4, 0.6, 0.7};
  const auto fitted = fittedPartition(variable);
  ASSERT_TRUE(fitted);
  variable.terms = *fitted;
  EXPECT_TRUE(isPartition(variable));
  EXPECT_EQ(variable.terms[0].parameters, (std::vector<double>{-kInfinity, 0.1, 0.6}));
  variable.terms[0].parameters[1] = variable.terms[1].parameters[1]; // two peaks at one place
  variable.terms[0].parameters[2] = 1.0;
  EXPECT_FALSE(fittedPartition(variable));
}

TEST(TermEditing, WordsSpreadEvenlyAreAPartitionOfTheRange)
{
  for (const Outside outside : {Outside::Shoulder, Outside::Flank})
    for (int count = 1; count <= 9; ++count) {
      for (Variable variable : {threeWords(), stiffness()}) {
        variable.terms.assign(static_cast<std::size_t>(count), variable.terms[0]);
        for (int i = 0; i < count; ++i) variable.terms[static_cast<std::size_t>(i)].id = std::to_string(i);
        variable.terms = spreadEvenly(variable, outside);
        EXPECT_TRUE(isPartition(variable));
        EXPECT_TRUE(passes(variable, true));
        expectSumOne(variable, outside == Outside::Shoulder && count > 1);
        for (int i = 0; i < count; ++i)
          EXPECT_EQ(variable.terms[static_cast<std::size_t>(i)].id, std::to_string(i));
        const Axis axis = axisOf(variable);
        const auto peak = [&](int i) { return variable.terms[static_cast<std::size_t>(i)].parameters[1]; };
        for (int i = 2; i < count; ++i)
          EXPECT_NEAR(peak(i) - peak(i - 1), peak(1) - peak(0), 1e-14 * (axis.high - axis.low));
      }
    }
}

TEST(TermEditing, SpreadingKeepsTheOrderOfTheWords)
{
  Variable variable = mixedWords(); // listed as hard, soft, medium, firm
  variable.terms = spreadEvenly(variable, Outside::Shoulder);
  EXPECT_EQ(variable.terms[1].parameters[1], 0.0);
  EXPECT_EQ(variable.terms[0].parameters[1], 1.0);
  EXPECT_LT(variable.terms[2].parameters[1], variable.terms[3].parameters[1]);
}

TEST(TermEditing, ANewWordStandsInTheWidestGapAndNotOnAnother)
{
  Variable variable = mixedWords();
  variable.terms = withNewTerm(variable, true);
  EXPECT_TRUE(isPartition(variable));
  expectSumOne(variable, true);
  // Cores are up to 0.1, 0.3 to 0.5, 0.65, from 0.8.
  EXPECT_NEAR(variable.terms.back().parameters[1], 0.2, 1e-15);
  EXPECT_EQ(withNewTerm(mixedWords(), false)[1], mixedWords().terms[1]);
  EXPECT_EQ(withNewTerm(variableOf({}), true)[0].parameters, (std::vector<double>{0, 0.5, 1}));
}

TEST(TermEditing, NeighboursCloseTheGapOfAWordThatIsGone)
{
  for (const Variable& start : {threeWords(), mixedWords(), stiffness()})
    for (int term = 0; term < static_cast<int>(start.terms.size()); ++term) {
      Variable variable = start;
      variable.terms = withoutTerm(start, term, true);
      EXPECT_TRUE(isPartition(variable));
      expectSumOne(variable, !start.logarithmic);
      EXPECT_TRUE(passes(variable, true));
    }
}

TEST(TermEditing, AnotherFormStandsWhereTheFormerStood)
{
  const Axis axis{0.0, 1.0};
  const std::vector<Term> starts = {makeTerm("a", Shape::Triangle, {0.2, 0.4, 0.8}),
                                    makeTerm("b", Shape::Trapezoid, {0.2, 0.4, 0.5, 0.8}),
                                    makeTerm("c", Shape::Gaussian, {0.4, 0.1})};
  for (const Term& start : starts)
    for (const Form form :
         {Form::Triangle, Form::Trapezoid, Form::LeftShoulder, Form::RightShoulder, Form::Gaussian}) {
      const Term made = withForm(start, form, axis);
      EXPECT_EQ(formOf(made), form);
      EXPECT_TRUE(ordered(made));
      EXPECT_TRUE(passes(variableOf({made}), true));
      if (form == formOf(start)) {
        EXPECT_EQ(made, start);
      }
      if (form == Form::LeftShoulder) {
        EXPECT_EQ(membership(made, 0.0), 1.0);
      }
      if (form == Form::RightShoulder) {
        EXPECT_EQ(membership(made, 1.0), 1.0);
      }
      // Between forms with corners, places of 1/2 stay.
      if (start.shape == Shape::Gaussian || form == Form::Gaussian) continue;
      if (form != Form::LeftShoulder) {
        EXPECT_NEAR(membership(made, 0.3), 0.5, 1e-12);
      }
      if (form != Form::RightShoulder) {
        EXPECT_NEAR(membership(made, start.shape == Shape::Triangle ? 0.6 : 0.65), 0.5, 1e-12);
      }
    }
  // A Gaussian is 1/2 where the triangle is.
  EXPECT_NEAR(
    membership(withForm(makeTerm("t", Shape::Triangle, {0.2, 0.4, 0.6}), Form::Gaussian, axis), 0.3), 0.5,
    1e-12);
}

TEST(TermEditing, HandlesAreWhatCanBeSeenFromLeftToRight)
{
  EXPECT_EQ(handlesOf(makeTerm("a", Shape::Triangle, {-kInfinity, 0, 1})),
            (std::vector{Handle::Peak, Handle::RightFoot}));
  EXPECT_EQ(handlesOf(makeTerm("a", Shape::Trapezoid, {-kInfinity, 0, 0.5, 1})),
            (std::vector{Handle::RightShoulder, Handle::RightFoot}));
  EXPECT_TRUE(handlesOf(makeTerm("a", Shape::Triangle, {-kInfinity, 0, kInfinity})).empty());
  for (const Variable& variable : {threeWords(), mixedWords(), stiffness()})
    for (const Term& term : variable.terms) {
      std::vector<double> places;
      for (const Handle handle : handlesOf(term)) {
        places.push_back(placeOf(term, handle));
        if (heightOf(handle) == 1.0) {
          EXPECT_EQ(membership(term, places.back()), 1.0);
        }
      }
      EXPECT_TRUE(std::is_sorted(places.begin(), places.end()));
    }
  const Term bell = makeTerm("g", Shape::Gaussian, {0.4, 0.1});
  EXPECT_NEAR(membership(bell, placeOf(bell, Handle::RightFlank)), heightOf(Handle::RightFlank), 1e-15);
}

TEST(TermEditing, FindsTheRulesThatSpeakOfAWord)
{
  RuleBase base;
  base.inputs = {threeWords()};
  base.outputs = {stiffness()};
  base.outputs[0].id = "s";
  const auto add = [&](const char* text) { base.rules.push_back(std::get<Rule>(parseRule(text, base))); };
  add("IF v IS soft THEN s IS low");
  add("IF v IS medium OR v IS NOT soft THEN s IS medium");
  add("IF v IS hard THEN s IS low");
  EXPECT_EQ(rulesWith(base, "v", "soft"), (std::vector{0, 1}));
  EXPECT_EQ(rulesWith(base, "s", "low"), (std::vector{0, 2}));
  EXPECT_TRUE(rulesWith(base, "s", "soft").empty());
}

// A half-typed or absurd place changes nothing.
TEST(TermEditing, NoPlaceIsNoMove)
{
  const Variable start = mixedWords();
  for (const Handle handle : kAllHandles) {
    const std::vector<Handle> there = handlesOf(start.terms[2]);
    if (handle != Handle::Curve && std::find(there.begin(), there.end(), handle) == there.end()) continue;
    EXPECT_EQ(moveHandle(start, 2, handle, std::nan(""), true), start.terms);
  }
}

} // namespace
} // namespace esm::fuzzy
