// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// What the planner makes of costs and checks, without a net: which method runs, what is learned, when the next check
// comes, and who may spend how much of the tolerance.
#include "core/dynamics/planner/check_rhythm.h"
#include "core/dynamics/planner/error_ledger.h"
#include "core/dynamics/planner/weighing.h"
#include "tests/core/dynamics/method_lines.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace esm {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

class Weighed : public testing::Test {
protected:
  Weighed()
  {
    m_known.resize(m_methods.facts.count());
    for (Method method = 0; method < m_methods.facts.count(); ++method) m_known.of(method).accurateStep = 1.0;
    m_now.springs = 100.0;
    m_now.leastCost = 1.0;
  }
  Weighing weighing() { return Weighing(m_policy, m_now, m_known, m_methods.facts); }
  /// Explicit steps are so many that other ways are weighed.
  void holdUp(double limit = 1e-6)
  {
    for (const Method method : {m_methods.plain, m_methods.twin, m_methods.fine})
      m_methods.facts.line(method).limit = limit;
  }

  Policy m_policy;
  FewMethods m_methods;
  Knowledge m_known{m_policy};
  Observation m_now;
};

TEST_F(Weighed, AFrameCostsItsStepsTimesWhatOneCosts)
{
  EXPECT_DOUBLE_EQ(weighing().cost(m_methods.plain), 100.0 * std::ceil(kFrame / 0.95e-4));
  m_known.of(m_methods.plain).accurateStep = 1e-5;
  EXPECT_DOUBLE_EQ(weighing().cost(m_methods.plain), 100.0 * std::ceil(kFrame / 1e-5));
  EXPECT_DOUBLE_EQ(weighing().costAtLimit(m_methods.plain), 100.0 * std::ceil(kFrame / 0.95e-4));
}

// Second order at twice the accurate step errs four times as much as it may.
TEST_F(Weighed, StepsThatTheEffortForcesCountByWhatTheyErrTooMuch)
{
  m_known.of(m_methods.plain).accurateStep = 1e-5;
  m_known.of(m_methods.plain).affordableStep = 2e-5;
  EXPECT_DOUBLE_EQ(weighing().cost(m_methods.plain), 4.0 * 100.0 * std::ceil(kFrame / 2e-5));
}

TEST_F(Weighed, TheCheapestExplicitMethodIsChosen)
{
  EXPECT_EQ(weighing().cheapestExplicit(m_methods.plain, 1.0), m_methods.plain);
  m_known.of(m_methods.plain).accurateStep = 1e-5;
  EXPECT_EQ(weighing().cheapestExplicit(m_methods.plain, 1.0), m_methods.twin);
  EXPECT_EQ(weighing().cheapestExplicit(m_methods.plain, 0.1), m_methods.plain) << "a change must pay";
}

TEST_F(Weighed, ATwinThatTakesTheSameStepsTakesOver)
{
  m_methods.facts.traitsOf(m_methods.plain).sharper = m_methods.twin;
  EXPECT_TRUE(weighing().isOutdone(m_methods.plain));
  m_methods.facts.line(m_methods.twin).limit = 0.5e-4;
  EXPECT_FALSE(weighing().isOutdone(m_methods.plain));
  EXPECT_FALSE(weighing().isOutdone(m_methods.fine));
}

TEST_F(Weighed, LocalStepsAreLaidOutOnlyWhereFewHoldAllAndMustBeFarCheaper)
{
  weighing().cheapestExplicit(m_methods.plain, 1.0);
  EXPECT_FALSE(m_methods.facts.isLaidOut(m_methods.local));
  m_now.fewHoldAll = true;
  EXPECT_EQ(weighing().cheapestExplicit(m_methods.plain, 1.0), m_methods.local);
  EXPECT_TRUE(m_methods.facts.isLaidOut(m_methods.local));
  m_methods.facts.line(m_methods.local).isLaidOut = false; // another part of the net: what was measured stays
  static_cast<KnownSteps&>(m_known.of(m_methods.local)) = {1.0, 1.0, true, kInfinity};
  EXPECT_EQ(weighing().cheapestExplicit(m_methods.plain, 1.0), m_methods.local);
  EXPECT_EQ(m_known.of(m_methods.local).accurateStep, 1.0);
  m_methods.facts.line(m_methods.local).cost =
    700.0; // a seventh... of ten times longer steps: 0.7 of plain ones
  EXPECT_EQ(weighing().cheapestExplicit(m_methods.plain, 1.0), m_methods.plain);
  // Held-up nets weigh them as well.
  m_now.fewHoldAll = false;
  m_methods.facts.line(m_methods.local).cost = 50.0;
  holdUp();
  EXPECT_EQ(weighing().cheapestExplicit(m_methods.plain, 1.0), m_methods.local);
}

TEST_F(Weighed, CautionGrowsAsTheToleranceShrinks)
{
  m_now.tolerance = 1e-1;
  EXPECT_EQ(weighing().caution(), 1.0);
  m_now.tolerance = 1e-4;
  EXPECT_NEAR(weighing().caution(), std::pow(1e-2, 0.6), 1e-15);
}

TEST_F(Weighed, WhatMayBeSpentDependsOnDampersAndOnWhatHoldsUp)
{
  m_now.tolerance = 1e-3;
  m_now.lastingShare = 0.5;
  EXPECT_EQ(weighing().spendable(m_methods.plain), 0.5);
  m_now.isDamped = true;
  EXPECT_EQ(weighing().spendable(m_methods.plain), 1.0);
  EXPECT_EQ(weighing().spendable(m_methods.implicit), 1.0);
  holdUp();
  EXPECT_EQ(weighing().spendable(m_methods.plain), weighing().caution());
  EXPECT_NEAR(weighing().spendable(m_methods.implicit), std::pow(1e-2, 0.3), 1e-15);
  m_now.fewHoldAll = true;
  EXPECT_EQ(weighing().spendable(m_methods.plain), 1.0);
  m_now.fewHoldAll = false;
  m_now.isAuto = false;
  EXPECT_EQ(weighing().spendable(m_methods.plain), 1.0);
}

TEST_F(Weighed, AMethodThatNobodyCouldCheckForTheEffortIsNotTakenAtCoarseTolerances)
{
  m_now.effort = 100.0;
  m_now.tolerance = 1e-3;
  EXPECT_TRUE(weighing().isPayable(m_methods.fine));
  m_now.tolerance = 1e-1;
  EXPECT_FALSE(weighing().isPayable(m_methods.fine));
  EXPECT_TRUE(weighing().isPayable(m_methods.plain));
  m_now.effort = 1e8;
  EXPECT_TRUE(weighing().isPayable(m_methods.fine));
  m_now.effort = 100.0;
  m_now.tolerance = 1e-3;
  m_now.asksForLess = true;
  EXPECT_FALSE(weighing().isPayable(m_methods.fine));
}

TEST_F(Weighed, ASavingMustMakeUpForItsPriceBeforeTheEnd)
{
  m_now.timeLeft = 2.0 * kFrame;
  EXPECT_TRUE(weighing().paysOff(10.0, 19.9));
  EXPECT_FALSE(weighing().paysOff(10.0, 20.1));
  m_now.timeLeft = kInfinity;
  EXPECT_TRUE(weighing().paysOff(1e-3, 1e9));
}

TEST_F(Weighed, ATinyEffortGivesTheToleranceUp)
{
  m_now.effort = 1e3;
  EXPECT_TRUE(weighing().isToleranceTooDear());
  m_now.leastCost = 1e5; // but nothing costs less
  EXPECT_FALSE(weighing().isToleranceTooDear());
  m_now.leastCost = 1.0;
  m_now.fewHoldAll = true;
  EXPECT_TRUE(weighing().isToleranceTooDear()) << "local steps are not laid out";
  m_methods.facts.layOut(m_methods.local);
  EXPECT_FALSE(weighing().isToleranceTooDear());
}

TEST_F(Weighed, ANetThatIsNotHeldUpCostsPlainStepsAtLeast)
{
  const double plain = 100.0 * std::ceil(kFrame / 1e-4);
  EXPECT_DOUBLE_EQ(weighing().leastCost(), plain);
  EXPECT_FALSE(m_methods.facts.isLaidOut(m_methods.implicit));
  holdUp();
  EXPECT_DOUBLE_EQ(weighing().leastCost(), 5000.0);
  EXPECT_TRUE(m_methods.facts.isLaidOut(m_methods.implicit));
  m_now.isByBlocks = true;
  EXPECT_DOUBLE_EQ(weighing().leastCost(), weighing().plainCost());
  m_now.isByBlocks = false;
  m_now.isAuto = false;
  EXPECT_DOUBLE_EQ(weighing().leastCost(), weighing().plainCost());
}

TEST_F(Weighed, TheSmallestStepThatTheEffortPaysFor)
{
  m_now.affordable = 1e4;
  EXPECT_DOUBLE_EQ(weighing().affordableStep(m_methods.fine), kFrame * 150.0 / 1e4);
  EXPECT_DOUBLE_EQ(weighing().affordableStep(m_methods.local), kFrame * m_now.springs / 1e4);
}

TEST_F(Weighed, AtFirstASoftNetGoesExplicitAndAStiffOneImplicit)
{
  EXPECT_EQ(weighing().first().method, m_methods.plain);
  holdUp();
  m_methods.facts.line(m_methods.local).cost = 1e6;
  m_known.of(m_methods.implicit).accurateStep = kFrame / 16.0;
  EXPECT_EQ(weighing().first().method, m_methods.implicit);
  EXPECT_FALSE(weighing().first().isToleranceGivenUp);
  m_now.isByBlocks = true;
  EXPECT_EQ(weighing().first().method, m_methods.plain);
  m_now.isByBlocks = false;
  m_now.effort = m_now.affordable = 2e4;
  const Choice rough = weighing().first();
  EXPECT_TRUE(rough.isToleranceGivenUp);
  EXPECT_DOUBLE_EQ(rough.floorStep, kFrame / 4.0) << "four steps of 5000 are what the effort pays for";
  EXPECT_DOUBLE_EQ(m_known.of(m_methods.implicit).accurateStep, kFrame / 4.0);
}

TEST_F(Weighed, ImplicitStepsAreLeftWhereExplicitOnesCostLess)
{
  Choice choice;
  choice.method = m_methods.implicit;
  m_now.tolerance = 1e-1;
  m_now.calm = 1.0;
  m_known.of(m_methods.implicit).accurateStep = kFrame / 40.0; // 200,000 a frame; plain ones 17,600
  EXPECT_EQ(weighing().reconsider(choice, {}).method, m_methods.plain);
  m_known.of(m_methods.implicit).accurateStep = kFrame / 4.0; // 20,000
  EXPECT_EQ(weighing().reconsider(choice, {}).method, m_methods.implicit);
  m_known.of(m_methods.implicit).accurateStep = kFrame / 10.0;
  m_now.calm = 0.0; // an onset tells little
  EXPECT_EQ(weighing().reconsider(choice, {}).method, m_methods.implicit);
  m_now.calm = 1.0;
  EXPECT_EQ(weighing().reconsider(choice, {}).method, m_methods.plain);
  m_now.effort = m_now.affordable = 1e3; // too dear either way: bounded
  const Choice rough = weighing().reconsider(choice, {});
  EXPECT_EQ(rough.method, m_methods.implicit);
  EXPECT_TRUE(rough.isToleranceGivenUp);
}

TEST_F(Weighed, AChangeMustPayForItsCheckUnlessItIsProven)
{
  Choice choice;
  choice.method = m_methods.fine;
  m_now.timeLeft = 0.1 * kFrame;
  EXPECT_EQ(weighing().reconsider(choice, {}).method, m_methods.fine);
  EXPECT_EQ(weighing().reconsider(choice, m_methods.plain).method, m_methods.plain);
  m_now.timeLeft = kInfinity;
  EXPECT_EQ(weighing().reconsider(choice, {}).method, m_methods.plain);
  // A twin costs nothing to change to.
  m_methods.facts.traitsOf(m_methods.fine).sharper = m_methods.twin;
  m_known.of(m_methods.plain).accurateStep = 1e-6;
  m_now.timeLeft = 0.1 * kFrame;
  EXPECT_EQ(weighing().reconsider(choice, {}).method, m_methods.twin);
}

TEST_F(Weighed, PlainStepsThatAreFarTooExactWhereNetsAreHeldUpGoImplicit)
{
  Choice choice;
  choice.method = m_methods.plain;
  holdUp();
  m_known.of(m_methods.twin).accurateStep = m_known.of(m_methods.fine).accurateStep = 1e-9;
  m_known.of(m_methods.plain).accurateStep = 4e-3;
  m_methods.facts.line(m_methods.local) = {{}, 1e-9, 100.0};
  EXPECT_EQ(weighing().reconsider(choice, {}).method, m_methods.implicit);
  EXPECT_DOUBLE_EQ(m_known.of(m_methods.implicit).accurateStep, 2e-3);
  m_known.of(m_methods.plain).accurateStep = 3e-6; // three steps at the limit: not far
  EXPECT_EQ(weighing().reconsider(choice, {}).method, m_methods.plain);
}

TEST_F(Weighed, ProbesGoToWhatCouldBeFarCheaperAndIsNotHopeless)
{
  const Method present = m_methods.fine;
  m_known.of(present).accurateStep = 1e-5; // 250,000 a frame
  const std::optional<Weighing::Proposal> best = weighing().worthAProbe(present);
  ASSERT_TRUE(best);
  EXPECT_EQ(best->method, m_methods.plain);
  EXPECT_DOUBLE_EQ(best->step, 0.95e-4);
  m_known.of(m_methods.plain).accurateStep = 1e-6; // at its limit it would err 9000 times too much
  EXPECT_EQ(weighing().worthAProbe(present)->method, m_methods.twin);
  m_known.of(m_methods.twin).untilProbe = 1;
  EXPECT_FALSE(weighing().worthAProbe(present));
  m_known.of(m_methods.twin).untilProbe = 0;
  m_now.timeLeft = 0.01 * kFrame; // it would save too little
  EXPECT_FALSE(weighing().worthAProbe(present));
  m_now.timeLeft = kInfinity;
  m_methods.facts.line(m_methods.twin).cost = 1500.0;
  EXPECT_FALSE(weighing().worthAProbe(present));
}

// A method that its twin outdoes is probed only with steps beyond the twin's, at coarse tolerances.
TEST_F(Weighed, AnOutdoneTwinIsProbedBeyondItsTwinsSteps)
{
  m_methods.facts.traitsOf(m_methods.plain).sharper = m_methods.twin;
  m_methods.facts.line(m_methods.plain).limit = 2e-4;
  m_methods.facts.line(m_methods.fine).cost = 1e5;
  m_known.of(m_methods.plain).accurateStep = 0.9e-4;
  m_now.tolerance = 1e-1;
  const std::optional<Weighing::Proposal> best = weighing().worthAProbe(m_methods.twin);
  ASSERT_TRUE(best);
  EXPECT_EQ(best->method, m_methods.plain);
  EXPECT_GE(best->step, 0.95e-4);
  m_now.tolerance = 1e-3;
  EXPECT_FALSE(weighing().worthAProbe(m_methods.twin));
}

TEST_F(Weighed, GuessesFollowTheTypicalErrorsOrder)
{
  m_known.guessAll(m_methods.facts, {4e-4, 1.0, true});
  EXPECT_NEAR(m_known.of(m_methods.plain).accurateStep, 1e-4 * std::sqrt(4e-4 / 4e-2), 1e-18);
  EXPECT_DOUBLE_EQ(m_known.of(m_methods.implicit).accurateStep, kFrame / 16.0);
  EXPECT_FALSE(m_known.of(m_methods.plain).isMeasured);
  m_methods.facts.traitsOf(m_methods.plain).typicalErrorOfWaves = 4e-4;
  m_known.guess(m_methods.plain, m_methods.facts, {4e-4, 1.0, false});
  EXPECT_NEAR(m_known.of(m_methods.plain).accurateStep, 1e-4, 1e-18);
  m_known.of(m_methods.plain).accurateStep = 1e-3; // more is known to do
  m_known.guessAtLeast(m_methods.plain, m_methods.facts, {4e-4, 1.0, false});
  EXPECT_EQ(m_known.of(m_methods.plain).accurateStep, 1e-3);
  m_known.of(m_methods.plain).accurateStep = 1e-6;
  m_known.guessAtLeast(m_methods.plain, m_methods.facts, {4e-4, 1.0, false});
  EXPECT_NEAR(m_known.of(m_methods.plain).accurateStep, 1e-4, 1e-18);
}

TEST_F(Weighed, AToleranceAHundredthMakesStepsOfSecondOrderATenth)
{
  m_known.rescale(m_methods.facts, 1e-2);
  EXPECT_NEAR(m_known.of(m_methods.plain).accurateStep, 0.1, 1e-15);
  EXPECT_NEAR(m_known.of(m_methods.fine).accurateStep, std::pow(10.0, -0.5), 1e-15);
}

TEST_F(Weighed, ACheckMovesTheStepByTheErrorsOrder)
{
  const auto learn = [&](Method method, double share) {
    m_known.learnOwn(method, m_methods.facts, {share, 1e-5});
    return m_known.of(method).accurateStep;
  };
  EXPECT_DOUBLE_EQ(learn(m_methods.plain, 1.0), 1e-5) << "near the budget it stays";
  EXPECT_DOUBLE_EQ(learn(m_methods.plain, 4.0), 0.9e-5 / 2.0);
  EXPECT_DOUBLE_EQ(learn(m_methods.plain, 1e-9), 3e-5) << "no more than three times at once";
  EXPECT_DOUBLE_EQ(learn(m_methods.fine, 16.0), 0.82e-5 / 2.0);
  EXPECT_DOUBLE_EQ(learn(m_methods.plain, 1e9), 1e-5 / 64.0);
  EXPECT_DOUBLE_EQ(learn(m_methods.implicit, 1e9), 1e-6);
  EXPECT_DOUBLE_EQ(learn(m_methods.plain, 0.0), 3e-5);
}

TEST_F(Weighed, WhatIsEasierForOneMethodIsSoForTheOthers)
{
  for (Method method = 0; method < m_methods.facts.count(); ++method)
    static_cast<KnownSteps&>(m_known.of(method)) = {1e-5, 1e-5, false, kInfinity};
  m_known.learnOwn(m_methods.plain, m_methods.facts, {0.2025, 1e-5}); // 0.9/0.45: twice the step
  m_known.learnOthers(m_methods.plain, m_methods.facts, {0.2025, 1e-5});
  EXPECT_NEAR(m_known.of(m_methods.plain).estimate, 2e-5, 1e-19);
  EXPECT_TRUE(m_known.of(m_methods.plain).isMeasured);
  EXPECT_NEAR(m_known.of(m_methods.twin).accurateStep, 2e-5, 1e-19);
  EXPECT_NEAR(m_known.of(m_methods.fine).accurateStep, std::sqrt(2.0) * 1e-5, 1e-19)
    << "by the orders' ratio";
  EXPECT_DOUBLE_EQ(m_known.of(m_methods.implicit).accurateStep, 1e-5);
  m_known.learnOthers(m_methods.implicit, m_methods.facts, {0.1, 1e-5});
  EXPECT_FALSE(m_known.of(m_methods.implicit).isMeasured);
  // Who has been measured knows better than another's guess.
  m_known.of(m_methods.fine).isMeasured = true;
  const double before = m_known.of(m_methods.fine).accurateStep;
  static_cast<KnownSteps&>(m_known.of(m_methods.twin)) = {1e-5, 1e-5, false, kInfinity};
  m_known.learnOthers(m_methods.twin, m_methods.facts, {0.2025, 1e-5});
  EXPECT_EQ(m_known.of(m_methods.fine).accurateStep, before);
  // Local steps only coarsen what the others do.
  m_known.of(m_methods.local).accurateStep = 1e-2;
  m_known.learnOthers(m_methods.local, m_methods.facts, {1.0, 1e-2});
  EXPECT_GE(m_known.of(m_methods.fine).accurateStep, 1e-2);
}

TEST_F(Weighed, WhatIsHarderForOneMethodIsSoForAllWhateverTheirOrders)
{
  for (Method method = 0; method < m_methods.facts.count(); ++method)
    static_cast<KnownSteps&>(m_known.of(method)) = {1e-5, 1e-5, true, kInfinity};
  m_known.learnOthers(m_methods.plain, m_methods.facts, {3.24, 1e-5}); // 0.9/1.8: half of the step
  EXPECT_NEAR(m_known.of(m_methods.twin).accurateStep, 0.5e-5, 1e-19);
  EXPECT_NEAR(m_known.of(m_methods.fine).accurateStep, std::sqrt(0.5) * 1e-5, 1e-19);
  m_known.of(m_methods.plain).estimate = 0.0; // nothing to compare with
  m_known.learnOthers(m_methods.plain, m_methods.facts, {3.24, 1e-5});
  EXPECT_NEAR(m_known.of(m_methods.twin).accurateStep, 0.5e-5, 1e-19);
  m_known.learnOthers(m_methods.plain, m_methods.facts, {1e6, 1e-5});
  EXPECT_NEAR(m_known.of(m_methods.twin).accurateStep, 0.1e-5, 1e-19) << "no less than a fifth at once";
}

TEST_F(Weighed, OfTwoTwinsOneBoundsTheOther)
{
  m_methods.facts.traitsOf(m_methods.plain).sharper = m_methods.twin;
  m_known.of(m_methods.plain).accurateStep = m_known.of(m_methods.twin).accurateStep = 1e-5;
  m_known.learnProbe(m_methods.plain, m_methods.facts, {1.0, 3e-5});
  EXPECT_EQ(m_known.of(m_methods.twin).accurateStep, 3e-5) << "the sharper one errs no more";
  m_known.learnProbe(m_methods.twin, m_methods.facts, {1.0, 2e-5});
  EXPECT_EQ(m_known.of(m_methods.plain).accurateStep, 2e-5) << "and the other no less";
  m_known.learnProbe(m_methods.twin, m_methods.facts, {9.0, 2e-5});
  EXPECT_NEAR(m_known.of(m_methods.twin).accurateStep, 2e-5 * 0.9 / 3.0, 1e-18);
}

TEST_F(Weighed, ImplicitStepsThatCostMoreThanShorterOnesAreNotTakenForSome)
{
  MethodKnowledge& known = m_known.of(m_methods.implicit);
  m_known.learnCost(m_methods.implicit, m_methods.facts, 3e-3, 100.0, 80.0);
  EXPECT_DOUBLE_EQ(known.cheapStep, 2e-3);
  m_known.learnCost(m_methods.implicit, m_methods.facts, 2e-3, 100.0, 120.0);
  EXPECT_DOUBLE_EQ(known.cheapStep, 2.3e-3);
  m_known.learnFailure(m_methods.implicit, m_methods.facts, 1e-3);
  EXPECT_DOUBLE_EQ(known.cheapStep, 1e-3);
  EXPECT_DOUBLE_EQ(known.accurateStep, 2.5e-4);
  m_known.learnCost(m_methods.plain, m_methods.facts, 3e-3, 100.0, 80.0);
  m_known.learnFailure(m_methods.plain, m_methods.facts, 1e-3);
  EXPECT_EQ(m_known.of(m_methods.plain).cheapStep, kInfinity);
  EXPECT_DOUBLE_EQ(m_known.of(m_methods.plain).accurateStep, 2.5e-4);
}

TEST_F(Weighed, ProbesThatFailComeLess)
{
  MethodKnowledge& known = m_known.of(m_methods.fine);
  for (const int gap : {1, 2, 4, 4}) {
    m_known.endProbe(m_methods.fine, false);
    EXPECT_EQ(known.untilProbe, gap);
  }
  known.probedStep = 1e-4;
  m_known.passCheck(3.0);
  EXPECT_EQ(known.untilProbe, 1);
  EXPECT_EQ(known.probedStep, 0.0);
  m_known.endProbe(m_methods.fine, true);
  EXPECT_EQ(known.untilProbe, 0);
  EXPECT_EQ(known.probeGap, 1);
}

class Rhythm : public testing::Test {
protected:
  /// Stretches until the next check.
  int gap()
  {
    int stretches = 0;
    for (; !m_rhythm.isDue(); ++stretches) m_rhythm.pass();
    return stretches;
  }
  CheckRhythm::Found found(double share) const
  {
    return {share, share, kFrame, 1.0, false, false, kInfinity};
  }
  Policy m_policy;
  CheckRhythm m_rhythm{m_policy};
};

TEST_F(Rhythm, ChecksThatPassComeLessAndLessOften)
{
  for (const int stretches : {2, 4, 8, 16, 24, 24}) {
    m_rhythm.learn(found(0.9));
    EXPECT_EQ(gap(), stretches);
  }
}

TEST_F(Rhythm, AnErrorBeyondTheBudgetIsLookedAtSoonUnlessNothingCanBeDone)
{
  for (int i = 0; i < 6; ++i) m_rhythm.learn(found(0.9));
  m_rhythm.learn(found(2.0));
  EXPECT_EQ(gap(), 6);
  m_rhythm.learn(found(std::numeric_limits<double>::quiet_NaN()));
  EXPECT_EQ(gap(), 1);
  CheckRhythm::Found held = found(2.0);
  held.isHeld = true;
  for (const int stretches : {2, 4, 8, 8}) {
    m_rhythm.learn(held);
    EXPECT_EQ(gap(), stretches);
  }
}

TEST_F(Rhythm, AGrownStepIsCheckedAtOnceAndABriefStretchTellsLittle)
{
  CheckRhythm::Found grown = found(0.1);
  grown.grows = true;
  m_rhythm.learn(grown);
  EXPECT_EQ(gap(), 1);
  m_rhythm.reset(0.0);
  CheckRhythm::Found brief = found(0.9);
  brief.length = kFrame / 8.0; // tells little
  for (int i = 0; i < 4; ++i) m_rhythm.learn(brief);
  EXPECT_EQ(gap(), 1);
}

TEST_F(Rhythm, NearTheEndASureMethodIsNotCheckedAgain)
{
  CheckRhythm::Found sure = found(0.4);
  sure.timeLeft = 4.0 * kFrame;
  m_rhythm.learn(sure);
  EXPECT_EQ(gap(), 5);
  sure.timeLeft = 40.0 * kFrame;
  m_rhythm.learn(sure);
  EXPECT_EQ(gap(), 4);
}

// Errors come from the waves that feed the dampers: four times the power, twice the error. Where a method knows its
// own error that tells instead.
TEST_F(Rhythm, TheErrorBetweenChecksFollowsThePowerOrTheLocalError)
{
  m_rhythm.learn(found(0.6));
  EXPECT_NEAR(m_rhythm.expectedError(kFrame, 4.0), 1.2, 1e-12);
  EXPECT_NEAR(m_rhythm.expectedError(kFrame / 2.0, 1.0), 0.3, 1e-12);
  CheckRhythm::Found undamped = found(0.6);
  undamped.power = 0.0;
  m_rhythm.learn(undamped);
  EXPECT_NEAR(m_rhythm.expectedError(kFrame, 4.0), 0.6, 1e-12);
  m_rhythm.learnOverLocal(0.6, kFrame); // no method of next order was at hand
  EXPECT_NEAR(m_rhythm.expectedError(kFrame, 4.0), 0.6, 1e-12);
  m_rhythm.setLocalError(3.0);
  m_rhythm.learnOverLocal(0.6, kFrame / 8.0); // the first one counts, however short
  EXPECT_NEAR(m_rhythm.expectedError(kFrame, 4.0), 0.6, 1e-12);
  m_rhythm.learnOverLocal(2.4, kFrame / 8.0); // a later one must not be short
  EXPECT_NEAR(m_rhythm.expectedError(kFrame, 4.0), 0.6, 1e-12);
  m_rhythm.learnOverLocal(2.4, kFrame); // half of the way, in logarithms
  EXPECT_NEAR(m_rhythm.expectedError(kFrame, 4.0), 1.2, 1e-12);
  m_rhythm.learnOverLocal(kInfinity, kFrame);
  EXPECT_NEAR(m_rhythm.expectedError(kFrame, 4.0), 1.2, 1e-12);
}

TEST_F(Rhythm, LongGapsCountAsSeveralChecksForThoseThatWait)
{
  m_rhythm.reset(0.0);
  EXPECT_EQ(m_rhythm.passCheck(kFrame), 1.0);
  EXPECT_NEAR(m_rhythm.passCheck(13.0 * kFrame), 2.0, 1e-12);
  EXPECT_EQ(m_rhythm.passCheck(1000.0 * kFrame), 4.0);
}

// The mean square of an error is the sum of what each account has spent, as they err at other nodes and times. Whatever
// part of their grants they take, in whatever order, the sum stays within the tolerance.
TEST(ErrorLedger, GrantsNeverExceedTheTolerance)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(0.0, 1.0);
  const ErrorLedger ledger;
  for (int run = 0; run < 10000; ++run) {
    double steps = 0.0, sleepers = 0.0, settled = 0.0;
    for (int i = 0; i < 20; ++i) {
      const double mostSteps = std::pow(ledger.steps(any(random) < 0.3), 2);
      steps = std::max(steps, any(random) * mostSteps);
      sleepers = std::max(sleepers, any(random) * std::pow(ledger.sleepers(), 2));
      ASSERT_LE(steps + sleepers, 1.0);
      settled = ledger.settling(steps); // what sleeps then is part of it
      ASSERT_LE(steps + settled, 1.0);
    }
  }
  EXPECT_GE(ledger.settling(kInfinity), std::pow(ledger.sleepers(), 2))
    << "a floor, as errors are only measured";
  EXPECT_LE(ledger.settling(0.0), 0.64);
  EXPECT_LT(ledger.steps(true), 0.2 * ledger.steps(false));
}

} // namespace
} // namespace esm
