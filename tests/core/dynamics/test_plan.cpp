// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// The planner's decisions without a net: what is planned from what is known, and what becomes of an attempt.
#include "core/dynamics/planner/judge.h"
#include "core/dynamics/planner/plan.h"
#include "tests/core/dynamics/method_lines.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace esm {
namespace {

constexpr double kLength = kFrame;

class Plans : public testing::Test {
protected:
  Plans()
  {
    m_known.resize(m_methods.facts.count());
    m_choice.method = m_methods.plain;
    for (Method method = 0; method < m_methods.facts.count(); ++method)
      m_known.of(method).accurateStep = 1e-3;
  }
  Plan make(bool isCheckDue = false, bool isFirst = true)
  {
    return plan(m_policy, m_now, m_known, m_methods.facts, m_choice, kLength, isCheckDue, isFirst);
  }

  Policy m_policy;
  FewMethods m_methods;
  Knowledge m_known{m_policy};
  Observation m_now;
  Choice m_choice;
};

TEST_F(Plans, StepsAreEvenAndNoLongerThanIsStableWithTheMargin)
{
  const Plan made = make();
  EXPECT_DOUBLE_EQ(made.step, 0.95e-4);
  EXPECT_EQ(made.steps, static_cast<std::int64_t>(std::ceil(kLength / 0.95e-4)));
  EXPECT_LE(kLength / made.count, made.step);
  EXPECT_DOUBLE_EQ(made.work, made.count * 100.0);
  EXPECT_FALSE(made.isChecked);
}

TEST_F(Plans, AnAccurateStepBelowTheLimitIsTaken)
{
  m_known.of(m_methods.plain).accurateStep = 3e-5;
  EXPECT_DOUBLE_EQ(make().step, 3e-5);
  m_known.of(m_methods.plain).cheapStep = 2e-5; // larger ones would cost more
  EXPECT_DOUBLE_EQ(make().step, 2e-5);
}

TEST_F(Plans, NoStepIsLongerThanTheStretch)
{
  m_methods.facts.line(m_methods.plain).limit = 1.0;
  m_known.of(m_methods.plain).accurateStep = 1.0;
  const Plan made = make();
  EXPECT_DOUBLE_EQ(made.step, kLength);
  EXPECT_EQ(made.steps, 1);
}

TEST_F(Plans, AccuracyIsNotPursuedBelowWhatTheEffortPaysForButByName)
{
  m_known.of(m_methods.plain).accurateStep = 1e-6;
  m_known.of(m_methods.plain).affordableStep = 2e-5;
  EXPECT_DOUBLE_EQ(make().step, 2e-5);
  m_now.isAuto = false;
  EXPECT_DOUBLE_EQ(make().step, 1e-6);
}

TEST_F(Plans, WhereTheToleranceIsGivenUpImplicitStepsKeepToTheFloorAndAreNotChecked)
{
  m_choice = {m_methods.implicit, 0, true, 5e-3};
  m_known.of(m_methods.implicit).accurateStep = 1e-5;
  const Plan made = make(true);
  EXPECT_DOUBLE_EQ(made.step, 5e-3);
  EXPECT_TRUE(made.isUnchecked);
  EXPECT_FALSE(made.isChecked);
  m_choice.isToleranceGivenUp = false;
  EXPECT_DOUBLE_EQ(make(true).step, 1e-5);
  EXPECT_TRUE(make(true).isChecked);
}

TEST_F(Plans, ACheckRepeatsTheStretchWithHalfAsManyStepsMore)
{
  const Plan made = make(true);
  EXPECT_TRUE(made.isChecked);
  EXPECT_FALSE(made.isFromAbove);
  EXPECT_EQ(made.finer, static_cast<std::int64_t>(std::ceil(1.5 * made.count)));
}

// One method of fourth order whose accurate step has room above: its check begins with larger steps.
TEST_F(Plans, ACheckFromAboveNeedsRoomOrderProofDampersAndCalm)
{
  m_choice.method = m_methods.fine;
  m_now.isDamped = true;
  MethodKnowledge& known = m_known.of(m_methods.fine);
  known.accurateStep = 5e-5;
  known.isMeasured = true;
  const Plan made = make(true);
  EXPECT_TRUE(made.isFromAbove);
  EXPECT_EQ(made.finer, static_cast<std::int64_t>(made.count));
  EXPECT_EQ(made.steps, static_cast<std::int64_t>(std::ceil(made.count / 1.5)));
  EXPECT_FALSE(make(true, false).isFromAbove) << "a second attempt needs smaller steps";
  EXPECT_FALSE(make(false).isFromAbove);
  known.accurateStep = 7e-5; // 1.5 times that is not stable
  EXPECT_FALSE(make(true).isFromAbove);
  known.accurateStep = 5e-5;
  known.affordableStep = 6e-5; // the effort sets the step
  EXPECT_FALSE(make(true).isFromAbove);
  known.affordableStep = 0.0;
  known.isMeasured = false;
  EXPECT_FALSE(make(true).isFromAbove);
  known.isMeasured = true;
  m_now.isDamped = false;
  EXPECT_FALSE(make(true).isFromAbove);
  m_now.isDamped = true;
  m_now.isOnset = true;
  EXPECT_FALSE(make(true).isFromAbove);
  m_now.isOnset = false;
  m_methods.facts.traitsOf(m_methods.fine).order = 3.0;
  EXPECT_FALSE(make(true).isFromAbove);
  m_methods.facts.traitsOf(m_methods.fine) = {MethodRole::ByName, 4.0};
  EXPECT_FALSE(make(true).isFromAbove);
}

TEST_F(Plans, StepsBeyondCountingAreNotCounted)
{
  m_known.of(m_methods.plain).accurateStep = 1e-20;
  const Plan made = make(true);
  EXPECT_GE(made.count, m_policy.steps.mostSteps);
  EXPECT_EQ(made.steps, 1);
}

TEST_F(Plans, CheckedStretchesAreShorterWhereTheyAreManySteps)
{
  const auto longest = [&] { return longestCheck(m_policy, m_now, m_known, m_methods.facts, m_choice); };
  EXPECT_DOUBLE_EQ(longest(), kFrame / 2.0);
  m_now.timeLeft = 1.0; // a known end
  EXPECT_DOUBLE_EQ(longest(), kFrame / 3.0);
  m_methods.facts.line(m_methods.plain).limit = kFrame;
  m_known.of(m_methods.plain).accurateStep = kFrame / 20.0;
  EXPECT_DOUBLE_EQ(longest(), kFrame);
}

class Judged : public testing::Test {
protected:
  Judged()
  {
    m_second.isSecond = true;
    m_second.step = 1e-4;
  }
  Verdict of(const Trial& trial) const { return judge(m_policy, trial); }
  Policy m_policy;
  Trial m_first, m_second;
};

TEST_F(Judged, AStretchThatNobodyMustLookAtIsKept)
{
  EXPECT_EQ(of(m_first), Verdict::KeepUnseen);
  m_first.isDue = true;
  EXPECT_EQ(of(m_first), Verdict::KeepUnaffordable);
  m_first.isCheckPayable = true;
  EXPECT_EQ(of(m_first), Verdict::Again);
}

TEST_F(Judged, TheWorkLimitEndsEveryRun)
{
  m_first.result = m_second.result = Run::Limit;
  EXPECT_EQ(of(m_first), Verdict::Stop);
  EXPECT_EQ(of(m_second), Verdict::Stop);
}

TEST_F(Judged, AFailedRunIsDoneAgainWithSmallerStepsWhileThatCanBePaidFor)
{
  for (const esm::Run result : {Run::NonFinite, Run::NotConverged}) {
    m_first.result = m_second.result = result;
    EXPECT_EQ(of(m_first), Verdict::Retreat);
    EXPECT_EQ(of(m_second), Verdict::Retreat);
    m_first.isOverdrawn = m_second.isOverdrawn = true;
    EXPECT_EQ(of(m_first), Verdict::Descend);
    EXPECT_EQ(of(m_second), Verdict::Descend);
    m_first.isOverdrawn = m_second.isOverdrawn = false;
  }
}

TEST_F(Judged, WhatWasBrokenOffOrNeedsNoAccuracyDescendsAtOnceButNotByName)
{
  m_first.result = Run::NotConverged;
  m_first.isExhausted = true;
  EXPECT_EQ(of(m_first), Verdict::Descend);
  m_first.isAuto = false;
  EXPECT_EQ(of(m_first), Verdict::Retreat);
  m_first.isAuto = true;
  m_first.isExhausted = false;
  m_first.isUnchecked = true;
  EXPECT_EQ(of(m_first), Verdict::Descend);
  m_second.result = Run::NotConverged;
  m_second.isUnchecked = true;
  EXPECT_EQ(of(m_second), Verdict::Retreat);
}

TEST_F(Judged, EnergyFromNowhereIsAFailure)
{
  m_first.hasGained = true;
  m_first.isDue = m_first.isCheckPayable = true;
  EXPECT_EQ(of(m_first), Verdict::Retreat);
  m_first.isOverdrawn = true;
  EXPECT_EQ(of(m_first), Verdict::Descend);
}

TEST_F(Judged, ACheckKeepsWhatIsAllowedOrAtMostATenthOfAllThatIsUnspent)
{
  m_second.error = 1.0;
  m_second.allowed = 1.0;
  EXPECT_EQ(of(m_second), Verdict::Keep);
  m_second.error = 1.01;
  EXPECT_EQ(of(m_second), Verdict::Smaller);
  m_second.unspent = 10.2;
  EXPECT_EQ(of(m_second), Verdict::Keep);
  m_second.isSane = false; // energy from nowhere
  EXPECT_EQ(of(m_second), Verdict::Smaller);
  m_second.isSane = true;
  m_second.error = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(of(m_second), Verdict::Smaller);
}

TEST_F(Judged, AtTheSmallestStepARoughAnswerIsKeptUnlessItRunsAway)
{
  m_second.error = 5.0;
  m_second.allowed = 1.0;
  m_second.step = m_second.floorStep = 1e-4;
  m_second.coarseError = 6.0;
  m_second.mostRough = 6.0;
  EXPECT_EQ(of(m_second), Verdict::KeepRough);
  m_second.coarseError = 6.1;
  EXPECT_EQ(of(m_second), Verdict::Smaller);
  m_second.coarseError = 6.0;
  m_second.step = 1.1e-4;
  EXPECT_EQ(of(m_second), Verdict::Smaller);
  m_second.isLast = true; // no other attempt can be paid for
  EXPECT_EQ(of(m_second), Verdict::KeepRough);
  m_second.isSane = false;
  EXPECT_EQ(of(m_second), Verdict::Smaller);
}

// Twenty times the budget in at least sixteen steps, at the start of a motion: waves that die out soon.
TEST_F(Judged, AFarTooLargeErrorAfterAnEventCutsTheStretch)
{
  m_second.error = 25.0;
  m_second.allowed = 1.0;
  m_second.share = 25.0;
  m_second.count = 16.0;
  m_second.mayBeginOnset = true;
  EXPECT_EQ(of(m_second), Verdict::Shorter);
  m_second.count = 15.0;
  EXPECT_EQ(of(m_second), Verdict::Smaller);
  m_second.count = 16.0;
  m_second.share = 20.0;
  EXPECT_EQ(of(m_second), Verdict::Smaller);
  m_second.share = 25.0;
  m_second.mayBeginOnset = false;
  EXPECT_EQ(of(m_second), Verdict::Smaller);
}

} // namespace
} // namespace esm
