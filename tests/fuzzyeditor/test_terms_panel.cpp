// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzzyeditor/number_spin_box.h"
#include "fuzzyeditor/terms/membership_panel.h"
#include "fuzzyeditor/terms/term_edits.h"
#include "fuzzyeditor/terms/term_plot.h"
#include "tests/fuzzyeditor/panel_fixture.h"

#include <QAccessible>
#include <QCheckBox>
#include <QComboBox>
#include <QInputDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTimer>
#include <QToolButton>

#include <cmath>

namespace esm {
namespace {

using fuzzy::Handle;
using test::PanelTest;

struct TermsPanelTest : PanelTest {
  MembershipPanel panel{&evaluation};
  TermPlot* plot = panel.plot();

  void SetUp() override
  {
    panel.resize(420, 420);
    show(panel);
  }
  const std::vector<fuzzy::Term>& hardness() const { return document.ruleBase().inputs[0].terms; }
  void showVariable(int row) { panel.findChild<QComboBox*>("mfVariable")->setCurrentIndex(row); }
  /// Value that one pixel of the plot is worth.
  double perPixel() const
  {
    return 1.0 / (plot->pixelOf(2, Handle::Peak).x() - plot->pixelOf(0, Handle::Peak).x());
  }
  void drag(int term, Handle handle, double pixels, int moves = 10)
  {
    const QPoint from = plot->pixelOf(term, handle).toPoint();
    QTest::mousePress(plot, Qt::LeftButton, {}, from);
    for (int i = 1; i <= moves; ++i)
      QTest::mouseMove(plot, from + QPoint(static_cast<int>(pixels * i / moves), 0));
    QTest::mouseRelease(plot, Qt::LeftButton, {}, from + QPoint(static_cast<int>(pixels), 0));
  }
  void focusPlot()
  {
    plot->setFocus(Qt::TabFocusReason);
    ASSERT_TRUE(plot->hasFocus());
  }
  QString message() const { return panel.findChild<QLabel*>("termsMessage")->text(); }
};

TEST_F(TermsPanelTest, OneDragIsOneUndoStepAndTheValueIsUnderTheMouse)
{
  const std::vector<fuzzy::Rule> rules = document.ruleBase().rules;
  drag(0, Handle::RightFoot, 40); // leads the peak of "medium", since memberships sum to 1
  EXPECT_EQ(document.undo.count(), 1);
  EXPECT_NEAR(hardness()[0].parameters[2], 0.5 + 40 * perPixel(), perPixel());
  EXPECT_EQ(hardness()[1].parameters[1], hardness()[0].parameters[2]);
  EXPECT_EQ(hardness()[2].parameters[0], hardness()[0].parameters[2]);
  EXPECT_EQ(document.ruleBase().rules, rules);
  drag(1, Handle::Peak, -25);
  EXPECT_EQ(document.undo.count(), 2);
  document.undo.undo();
  document.undo.undo();
  EXPECT_EQ(document.ruleBase(), test::sampleRules());
}

TEST_F(TermsPanelTest, ADragFollowsInTheSameTurnOfTheEventLoop)
{
  document.setInput(0, 0.3, 0);
  QTest::qWait(5);
  const double before = evaluation.degree(1);
  const QPoint from = plot->pixelOf(1, Handle::Peak).toPoint();
  QTest::mousePress(plot, Qt::LeftButton, {}, from);
  QSignalSpy announced(&evaluation, &FuzzyEvaluation::changed);
  for (int i = 1; i <= 5; ++i) QTest::mouseMove(plot, from - QPoint(8 * i, 0));
  EXPECT_GT(evaluation.degree(1), before); // "medium" lies nearer to 0.3 now
  QCoreApplication::processEvents();
  EXPECT_EQ(announced.count(), 1); // once for all five
  QTest::mouseRelease(plot, Qt::LeftButton, {}, from - QPoint(40, 0));
}

TEST_F(TermsPanelTest, EscapeTakesADragBackWithoutAnUndoStep)
{
  const QPoint from = plot->pixelOf(1, Handle::Peak).toPoint();
  QTest::mousePress(plot, Qt::LeftButton, {}, from);
  for (int i = 1; i <= 5; ++i) QTest::mouseMove(plot, from + QPoint(8 * i, 0));
  EXPECT_NE(document.ruleBase(), test::sampleRules());
  plot->setFocus();
  QTest::keyClick(plot, Qt::Key_Escape);
  EXPECT_EQ(document.ruleBase(), test::sampleRules());
  EXPECT_EQ(document.undo.count(), 0);
  QTest::mouseMove(plot, from + QPoint(60, 0)); // the button is still down, the drag is over
  EXPECT_EQ(document.ruleBase(), test::sampleRules());
  QTest::mouseRelease(plot, Qt::LeftButton, {}, from);
}

TEST_F(TermsPanelTest, PointsStayInOrderAndInTheRangeHoweverFarTheyAreDragged)
{
  panel.findChild<QCheckBox*>("mfLock")->click();
  drag(1, Handle::RightFoot, 2000);
  EXPECT_EQ(hardness()[1].parameters[2], 1.0);
  drag(1, Handle::LeftFoot, 2000);
  EXPECT_EQ(hardness()[1].parameters[0], 0.5); // up to the peak
  drag(1, Handle::Peak, -2000);
  EXPECT_EQ(hardness()[1].parameters, (std::vector<double>{0.5, 0.5, 1.0}));
  EXPECT_EQ(hardness()[0], test::sampleRules().inputs[0].terms[0]);
}

TEST_F(TermsPanelTest, AWholeCurveIsDraggedByItsFlank)
{
  panel.findChild<QCheckBox*>("mfLock")->click();
  showVariable(1);
  const QPointF foot = plot->pixelOf(1, Handle::LeftFoot), top = plot->pixelOf(1, Handle::LeftShoulder);
  const QPoint from = ((foot + top) / 2).toPoint();
  QTest::mousePress(plot, Qt::LeftButton, {}, from);
  QTest::mouseMove(plot, from + QPoint(-20, 5));
  QTest::mouseRelease(plot, Qt::LeftButton, {}, from + QPoint(-20, 5));
  const std::vector<double>& p = document.ruleBase().inputs[1].terms[1].parameters;
  EXPECT_NEAR(p[1] - p[0], 0.4, 1e-12);
  EXPECT_LT(p[0], 0.3);
  EXPECT_EQ(document.undo.count(), 1);
}

TEST_F(TermsPanelTest, TabGoesFromPointToPointAndLeavesAtTheLast)
{
  focusPlot();
  // soft: shoulder, right foot; medium: three; hard: left foot, shoulder
  for (int i = 0; i < plot->pointCount(); ++i) {
    EXPECT_TRUE(plot->point(i).focused) << i;
    QTest::keyClick(plot, Qt::Key_Tab);
  }
  EXPECT_EQ(plot->pointCount(), 7);
  EXPECT_FALSE(plot->hasFocus());
  plot->setFocus(Qt::BacktabFocusReason);
  EXPECT_TRUE(plot->point(6).focused);
  QTest::keyClick(plot, Qt::Key_Backtab);
  EXPECT_TRUE(plot->point(5).focused);
  EXPECT_EQ(panel.edits()->term(), 2);
}

TEST_F(TermsPanelTest, ArrowsMoveByAStepAndARunOfThemIsOneUndoStep)
{
  focusPlot();
  QTest::keyClick(plot, Qt::Key_Tab);
  QTest::keyClick(plot, Qt::Key_Tab);
  QTest::keyClick(plot, Qt::Key_Tab); // the peak of "medium"
  QTest::keyClick(plot, Qt::Key_Right);
  EXPECT_NEAR(hardness()[1].parameters[1], 0.51, 1e-12);
  QTest::keyClick(plot, Qt::Key_Left, Qt::ShiftModifier);
  EXPECT_NEAR(hardness()[1].parameters[1], 0.41, 1e-12);
  EXPECT_EQ(document.undo.count(), 1);
  QTest::keyClick(plot, Qt::Key_Home);
  EXPECT_NEAR(hardness()[1].parameters[1], fuzzy::kLeastGap, 1e-12); // beside the peak of "soft"
  QTest::keyClick(plot, Qt::Key_End);
  EXPECT_NEAR(hardness()[1].parameters[1], 1.0 - fuzzy::kLeastGap, 1e-12);
  EXPECT_TRUE(fuzzy::isPartition(document.ruleBase().inputs[0]));
  document.undo.undo();
  EXPECT_EQ(document.ruleBase(), test::sampleRules());
}

TEST_F(TermsPanelTest, AWordInUseIsNotRemovedAndTheRulesAreNamed)
{
  focusPlot();
  QTest::keyClick(plot, Qt::Key_Backtab); // leaves; the focus point stays the first
  focusPlot();
  for (int i = 0; i < 3; ++i) QTest::keyClick(plot, Qt::Key_Tab);
  QTest::keyClick(plot, Qt::Key_Delete);
  EXPECT_EQ(document.undo.count(), 0);
  EXPECT_EQ(message(), "“medium” stays: rules speak of it (2). Change or delete them first.");
  panel.findChild<QComboBox*>("termChoice")->setCurrentIndex(0);
  EXPECT_FALSE(panel.findChild<QLabel*>("termsMessage")->isVisible());
  panel.findChild<QToolButton*>("termRemove")->click(); // no rule speaks of "soft"
  ASSERT_EQ(hardness().size(), 2U);
  EXPECT_EQ(hardness()[0].parameters, (std::vector<double>{-HUGE_VAL, 0.5, 1}));
}

TEST_F(TermsPanelTest, AnAddedWordHasRoomAndItsNamesCanBeWritten)
{
  panel.findChild<QToolButton*>("termAdd")->click();
  ASSERT_EQ(hardness().size(), 4U);
  EXPECT_EQ(panel.edits()->term(), 3);
  EXPECT_TRUE(fuzzy::isPartition(document.ruleBase().inputs[0]));
  auto* english = panel.findChild<QLineEdit*>("termEnglish");
  english->setFocus();
  english->selectAll();
  QTest::keyClicks(english, "doughy");
  QTest::keyClick(english, Qt::Key_Return);
  EXPECT_EQ(hardness()[3].name.english, "doughy");
  EXPECT_EQ(hardness()[3].name.german, "Wort 4");
  EXPECT_EQ(document.undo.count(), 2);
  english->selectAll();
  QTest::keyClicks(english, "Soft");
  QTest::keyClick(english, Qt::Key_Return);
  EXPECT_EQ(message(), "“Soft” is the name of another word of this variable.");
  EXPECT_EQ(document.undo.count(), 2);
}

TEST_F(TermsPanelTest, NumbersAreInTheDisplayUnitAndTakeBothDecimalMarks)
{
  showVariable(2); // stiffness, logarithmic
  panel.findChild<QComboBox*>("termChoice")->setCurrentIndex(1);
  auto* peak = panel.findChild<NumberSpinBox*>("termPlace1");
  EXPECT_EQ(peak->accessibleName(), "medium: peak");
  EXPECT_NEAR(peak->value(), 31.623, 1e-3); // 10^4.5 Pa in kPa
  speak(Language::German);
  peak->setFocus();
  peak->selectAll();
  QTest::keyClicks(peak, "12,5");
  QTest::keyClick(peak, Qt::Key_Return);
  EXPECT_NEAR(document.ruleBase().outputs[0].terms[1].parameters[1], std::log10(12500.0), 1e-12);
  EXPECT_EQ(document.ruleBase().outputs[0].terms[0].parameters[2],
            document.ruleBase().outputs[0].terms[1].parameters[1]);
}

TEST_F(TermsPanelTest, AnotherFormIsOneStepAndABellUnlocksThePartition)
{
  auto* form = panel.findChild<QComboBox*>("termForm");
  auto* lock = panel.findChild<QCheckBox*>("mfLock");
  panel.findChild<QComboBox*>("termChoice")->setCurrentIndex(1);
  EXPECT_TRUE(lock->isChecked());
  form->setCurrentIndex(1);
  emit form->activated(1);
  EXPECT_EQ(hardness()[1].shape, fuzzy::Shape::Trapezoid);
  EXPECT_TRUE(lock->isChecked()); // neighbours have made room for it
  form->setCurrentIndex(4);
  emit form->activated(4);
  EXPECT_EQ(hardness()[1].shape, fuzzy::Shape::Gaussian);
  EXPECT_FALSE(lock->isChecked());
  EXPECT_FALSE(lock->isEnabled());
  EXPECT_EQ(document.undo.count(), 2);
}

TEST_F(TermsPanelTest, WordsAreSpreadEvenlyByADialog)
{
  const auto answer = [&](int count) {
    QTimer::singleShot(0, &panel, [&, count] {
      auto* dialog = panel.findChild<QInputDialog*>("dlgSpread");
      ASSERT_TRUE(dialog);
      dialog->findChild<QSpinBox*>("spreadCount")->setValue(count);
      dialog->accept();
    });
    panel.findChild<QToolButton*>("mfSpread")->click();
  };
  answer(5);
  ASSERT_EQ(hardness().size(), 5U);
  for (int i = 0; i < 5; ++i) EXPECT_EQ(hardness()[static_cast<std::size_t>(i)].parameters[1], 0.25 * i);
  EXPECT_EQ(document.undo.count(), 1);
  answer(2);
  ASSERT_EQ(hardness().size(), 2U); // medium and hard, of which rules speak
  EXPECT_EQ(hardness()[0].id, "medium");
  answer(1);
  EXPECT_EQ(hardness().size(), 2U);
  EXPECT_EQ(message(),
            "Rules speak of 2 words of this variable, so that fewer cannot be spread. Change or delete "
            "rules first.");
}

TEST_F(TermsPanelTest, TheLockFitsTheFeetWhereItIsSetAnew)
{
  auto* lock = panel.findChild<QCheckBox*>("mfLock");
  lock->click();
  drag(0, Handle::RightFoot, -30);
  EXPECT_FALSE(fuzzy::isPartition(document.ruleBase().inputs[0]));
  lock->click();
  EXPECT_TRUE(fuzzy::isPartition(document.ruleBase().inputs[0]));
  EXPECT_EQ(document.undo.count(), 2);
  EXPECT_EQ(document.ruleBase(), test::sampleRules());
}

TEST_F(TermsPanelTest, PointsAreSlidersInTheAccessibilityTree)
{
  QAccessibleInterface* access = QAccessible::queryAccessibleInterface(plot);
  ASSERT_TRUE(access);
  ASSERT_EQ(access->childCount(), 7);
  QStringList names;
  for (int i = 0; i < 7; ++i) {
    EXPECT_EQ(access->child(i)->role(), QAccessible::Slider);
    EXPECT_EQ(access->child(i)->parent(), access);
    EXPECT_EQ(access->indexOfChild(access->child(i)), i);
    EXPECT_TRUE(access->rect().contains(access->child(i)->rect().center()));
    names << access->child(i)->text(QAccessible::Name);
  }
  EXPECT_EQ(names, (QStringList{"soft: shoulder", "soft: right foot", "medium: left foot", "medium: peak",
                                "medium: right foot", "hard: left foot", "hard: shoulder"}));
  QAccessibleValueInterface* peak = access->child(3)->valueInterface();
  ASSERT_TRUE(peak);
  EXPECT_EQ(peak->currentValue().toDouble(), 0.5);
  EXPECT_NEAR(peak->maximumValue().toDouble(), 1.0 - fuzzy::kLeastGap, 1e-12);
  peak->setCurrentValue(0.3);
  EXPECT_EQ(hardness()[1].parameters[1], 0.3);
  EXPECT_EQ(access->child(3)->text(QAccessible::Value), "0.30");
  speak(Language::German);
  EXPECT_EQ(access->child(3)->text(QAccessible::Value), "0,30");
  showVariable(2);
  QAccessibleInterface* stiff = access->child(3);
  EXPECT_NEAR(stiff->valueInterface()->currentValue().toDouble(), 31.62, 0.01); // [kPa]
}

TEST_F(TermsPanelTest, TheSavedCurveStandsBehindTheChangedOne)
{
  plot->clearFocus();
  const QImage untouched = plot->grab().toImage();
  drag(1, Handle::Peak, 50);
  QTest::mouseMove(plot, QPoint(2, 2));
  const QImage ghost = plot->grab().toImage();
  document.save();
  QTest::qWait(5);
  EXPECT_NE(plot->grab().toImage(), ghost); // no ghost of what is saved
  EXPECT_NE(ghost, untouched);
}

/// Words that are too long for the plot are cut short, the first one is not pushed out of it.
TEST_F(TermsPanelTest, LongWordsStayWithinThePlot)
{
  panel.edits()->chooseTerm(2);
  auto* english = panel.findChild<QLineEdit*>("termEnglish");
  english->setFocus();
  english->selectAll();
  QTest::keyClicks(english, QString(40, 'w'));
  QTest::keyClick(english, Qt::Key_Return);
  ASSERT_EQ(hardness()[2].name.english.size(), 40U);
  const QImage image = plot->grab().toImage();
  const int bottom = static_cast<int>(plot->pixelOf(0, Handle::Peak).y()) - 6,
            top = bottom - 8; // in the words
  const QRgb ground = image.pixel(0, 0);
  for (int y = top; y < bottom; ++y)
    for (const int x : {0, 1, image.width() - 2, image.width() - 1})
      EXPECT_EQ(image.pixel(x, y), ground) << x;
}

} // namespace
} // namespace esm
