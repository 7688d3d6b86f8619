// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/document.h"
#include "tests/app/sheet.h"

#include <QSignalSpy>

#include <gtest/gtest.h>

namespace esm {
namespace {

/// Default rules with one peak of hardness elsewhere.
fuzzy::RuleBase withPeakAt(double place)
{
  fuzzy::RuleBase rules = fuzzy::RuleBase(defaultTissue().rules);
  rules.inputs[0].terms[3].parameters[1] = place;
  return rules;
}

TEST(Gestures, RuleBasesOfOneDragAreOneUndoStep)
{
  Document document;
  document.start(test::sheetProject(), QString());
  const Project before = document.project();
  for (const double place : {0.51, 0.52, 0.53}) document.setRuleBase(withPeakAt(place), "drag", 7);
  EXPECT_EQ(document.undoStack()->count(), 1);
  document.setRuleBase(withPeakAt(0.54), "drag", 8);
  EXPECT_EQ(document.undoStack()->count(), 2);
  document.undoStack()->undo();
  EXPECT_EQ(document.ruleBase(), withPeakAt(0.53));
  document.undoStack()->undo();
  EXPECT_EQ(document.ruleBase(), before.tissue.rules);
  EXPECT_EQ(document.project().net.stiffness.matrix(), before.net.stiffness.matrix());
}

TEST(Gestures, ADragThatEndsWhereItBeganLeavesNothing)
{
  Document document;
  document.start(test::sheetProject(), QString());
  document.setRuleBase(withPeakAt(0.6), "first", 0); // from here on springs come from the words
  const Eigen::ArrayXd stiffness = document.project().net.stiffness;
  document.setRuleBase(withPeakAt(0.52), "drag", 7);
  document.setRuleBase(withPeakAt(0.6), "drag", 7);
  EXPECT_EQ(document.undoStack()->count(), 1);
  EXPECT_EQ(document.project().net.stiffness.matrix(), stiffness.matrix());
  std::vector<fuzzy::InputValue> inputs = document.inputs();
  const std::vector<fuzzy::InputValue> start = inputs;
  inputs[0] = 0.9;
  inputs[1] = 0.1;
  document.setInputs(inputs, "cross", 3);
  document.setInputs(start, "cross", 3);
  EXPECT_EQ(document.undoStack()->count(), 1);
  EXPECT_EQ(document.inputs(), start);
}

TEST(Gestures, TheSavedRuleBaseIsThatOfTheLastOpening)
{
  Document document;
  QSignalSpy saved(&document, &FuzzyDocument::ruleBaseSaved);
  document.start(test::sheetProject(), QString());
  EXPECT_EQ(saved.count(), 1);
  const fuzzy::RuleBase opened = document.ruleBase();
  document.setRuleBase(withPeakAt(0.6), "edit");
  EXPECT_EQ(document.savedRuleBase(), opened);
}

} // namespace
} // namespace esm
