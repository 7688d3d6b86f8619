// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/document.h"
#include "app/panels/gesture_spin_box.h"
#include "app/text/language.h"
#include "tests/app/sheet.h"

#include <QApplication>
#include <QClipboard>
#include <QEvent>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>

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

/// Counts how often what it watches is painted.
struct PaintCounter : QObject {
  int paints = 0;
  bool eventFilter(QObject*, QEvent* event) override
  {
    paints += event->type() == QEvent::Paint;
    return false;
  }
};

// Panels show their numbers several times a second; beside a 3D view each painting composes the whole window.
TEST(Gestures, ANumberThatIsShownAlreadyIsNotPaintedAgain)
{
  GestureSpinBox box;
  box.setDecimals(1);
  box.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&box));
  box.display(5.0);
  QTest::qWait(50);
  PaintCounter counter;
  box.installEventFilter(&counter);
  for (int i = 0; i < 5; ++i) {
    box.display(5.02); // rounds to the same
    QTest::qWait(10);
  }
  EXPECT_EQ(counter.paints, 0);
  box.display(6.0);
  QTest::qWait(50);
  EXPECT_GT(counter.paints, 0);
  EXPECT_EQ(box.value(), 6.0);
  auto* edit = box.findChild<QLineEdit*>();
  edit->setText(QStringLiteral("7")); // typed, not entered
  box.display(6.0);
  EXPECT_EQ(box.cleanText(), box.textFromValue(6.0));
}

// A force limit of 0.5 N that became 5 N because a language writes 0,5: either mark is taken, in any language.
TEST(Gestures, ANumberFieldTakesEitherDecimalMark)
{
  LanguageSwitch language;
  for (const Language spoken : {Language::German, Language::English})
    for (const QString& text : {QStringLiteral("7.25"), QStringLiteral("7,25")}) {
      language.set(spoken);
      GestureSpinBox box;
      box.setRange(0.0, 1000.0);
      box.setDecimals(2);
      box.setSuffix(QStringLiteral(" N"));
      box.selectAll();
      QTest::keyClicks(&box, text);
      QTest::keyClick(&box, Qt::Key_Return);
      EXPECT_DOUBLE_EQ(box.value(), 7.25) << qPrintable(text);
      QApplication::clipboard()->setText(text);
      box.setValue(1.0);
      box.selectAll();
      box.findChild<QLineEdit*>()->paste();
      QTest::keyClick(&box, Qt::Key_Return);
      EXPECT_DOUBLE_EQ(box.value(), 7.25) << qPrintable(text);
    }
  language.set(Language::English);
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
