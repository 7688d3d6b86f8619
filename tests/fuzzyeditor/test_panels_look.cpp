// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzzyeditor/inputs_panel.h"
#include "fuzzyeditor/rules/rule_table_model.h"
#include "fuzzyeditor/rules/rules_panel.h"
#include "fuzzyeditor/surface/surface_panel.h"
#include "fuzzyeditor/terms/membership_panel.h"
#include "fuzzyeditor/terms/term_plot.h"
#include "tests/fuzzyeditor/panel_fixture.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QDir>
#include <QHeaderView>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QScrollBar>
#include <QTabWidget>

namespace esm {
namespace {

using test::PanelTest;

QPalette darkPalette()
{
  QPalette dark;
  const QColor window(0x2b, 0x2d, 0x30), base(0x1e, 0x1f, 0x22), text(0xdf, 0xe1, 0xe5);
  for (const auto role : {QPalette::Window, QPalette::Button, QPalette::ToolTipBase})
    dark.setColor(role, window);
  dark.setColor(QPalette::Base, base);
  dark.setColor(QPalette::AlternateBase, QColor(0x26, 0x28, 0x2b));
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText})
    dark.setColor(role, text);
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    dark.setColor(QPalette::Disabled, role, QColor(0x86, 0x8a, 0x91));
  dark.setColor(QPalette::PlaceholderText, QColor(0x86, 0x8a, 0x91));
  dark.setColor(QPalette::Highlight, QColor(0x3d, 0x7e, 0xc4));
  dark.setColor(QPalette::HighlightedText, Qt::white);
  return dark;
}

struct PanelsLook : PanelTest {
  RulesPanel rules{&evaluation};
  InputsPanel inputs{&evaluation};
  MembershipPanel membership{&evaluation};
  SurfacePanel surface{&evaluation};
  std::vector<QWidget*> all{&rules, &inputs, &membership, &surface};

  void showAll()
  {
    rules.resize(900, 300);
    inputs.resize(340, 400);
    membership.resize(420, 260);
    surface.resize(420, 320);
    for (QWidget* panel : all) show(*panel);
    QTest::qWait(20);
  }
};

bool isInteractive(const QWidget* widget)
{
  if (qobject_cast<const QScrollBar*>(widget) || qobject_cast<const QHeaderView*>(widget)) return false;
  if (widget->focusPolicy() == Qt::NoFocus) return false;
  return qobject_cast<const QAbstractButton*>(widget) || qobject_cast<const QAbstractSlider*>(widget) ||
         qobject_cast<const QAbstractSpinBox*>(widget) || qobject_cast<const QComboBox*>(widget) ||
         qobject_cast<const QLineEdit*>(widget) || qobject_cast<const QPlainTextEdit*>(widget) ||
         qobject_cast<const QAbstractItemView*>(widget) || qobject_cast<const QTabBar*>(widget);
}

TEST_F(PanelsLook, EveryInteractiveWidgetHasANameForScreenReaders)
{
  showAll();
  for (const QWidget* panel : all)
    for (const QWidget* widget : panel->findChildren<QWidget*>())
      if (isInteractive(widget) && widget->window() == panel) {
        EXPECT_FALSE(widget->accessibleName().isEmpty())
          << widget->metaObject()->className() << " " << qPrintable(widget->objectName());
      }
}

TEST_F(PanelsLook, TabReachesEveryFieldOfAnInputInReadingOrder)
{
  showAll();
  inputs.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&inputs));
  inputs.findChild<QWidget*>("slider_hardness")->setFocus();
  QStringList reached;
  for (int i = 0; i < 3; ++i) {
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    reached << QApplication::focusWidget()->objectName();
  }
  EXPECT_EQ(reached,
            (QStringList{"spin_hardness", "word_hardness", "slider_elasticity"})); // nothing to reset
}

// Hidden panels cost nothing, and many shown ones one computation for however many moves of a slider.
TEST_F(PanelsLook, RulesAreEvaluatedOncePerTurnAndOnlyForVisiblePanels)
{
  document.setInput(0, 0.1, 0);
  QTest::qWait(5);
  EXPECT_EQ(evaluation.computations(), 0);
  showAll();
  const int before = evaluation.computations();
  for (int i = 0; i < 10; ++i) document.setInput(0, 0.1 + 0.01 * i, 1);
  QTest::qWait(20);
  EXPECT_EQ(evaluation.computations(), before + 1);
}

TEST_F(PanelsLook, PlotMarksTheValueOfTheVariableChosen)
{
  showAll();
  auto* choice = membership.findChild<QComboBox*>("mfVariable");
  EXPECT_EQ(choice->count(), 4);
  choice->setCurrentIndex(2);
  EXPECT_TRUE(membership.plot()->showsOutput());
  EXPECT_EQ(membership.plot()->accessibleName(), "Plot of the words for Stiffness");
  const QImage before = membership.plot()->grab().toImage();
  document.setInput(0, 0.9, 0);
  QTest::qWait(5);
  EXPECT_NE(membership.plot()->grab().toImage(), before);
  emit inputs.inputFocused(1);
  membership.showInput(1);
  EXPECT_EQ(membership.plot()->variableIndex(), 1);
  EXPECT_FALSE(membership.plot()->showsOutput());
  membership.showVariable(true, 0); // a finding about the words of a result
  EXPECT_TRUE(membership.plot()->showsOutput());
  EXPECT_EQ(membership.plot()->accessibleName(), "Plot of the words for Stiffness");
}

TEST_F(PanelsLook, LongTextsWrapInsteadOfWideningADock)
{
  speak(Language::German);
  showAll();
  EXPECT_LE(inputs.minimumSizeHint().width(), 340);
}

// Pictures for people to look at: ESM_SCREENSHOTS=folder test_fuzzyeditor --gtest_filter=*Screenshots*
TEST_F(PanelsLook, Screenshots)
{
  const QString folder = qEnvironmentVariable("ESM_SCREENSHOTS");
  if (folder.isEmpty()) GTEST_SKIP() << "ESM_SCREENSHOTS names no folder";
  ASSERT_TRUE(QDir().mkpath(folder));
  const QPalette light = QApplication::palette();
  showAll();
  document.setInput(0, 0.68, 0);
  rules.tableModel()->setData(rules.tableModel()->index(1, RuleTableModel::Conclusion), "stiffness IS hihg");
  rules.findChild<QPlainTextEdit*>("rulesText")
    ->appendPlainText("IF hardness IS soft AND elasticity IS lo THEN stiffness IS low");
  for (const bool dark : {false, true})
    for (const Language language : {Language::English, Language::German}) {
      QApplication::setPalette(dark ? darkPalette() : light);
      speak(language);
      const QString suffix =
        QStringLiteral("_%1_%2.png").arg(language == Language::German ? "de" : "en", dark ? "dark" : "light");
      for (int tab = 0; tab < 2; ++tab) {
        rules.findChild<QTabWidget*>("rulesTabs")->setCurrentIndex(tab);
        QTest::qWait(20);
        rules.grab().save(folder + (tab ? "/text" : "/table") + suffix);
      }
      document.setInput(1, dark ? fuzzy::InputValue(fuzzy::Word{"high", {fuzzy::Hedge::Very}}) : 0.2, 0);
      for (int variable = 0; variable < 3; ++variable) {
        membership.findChild<QComboBox*>("mfVariable")->setCurrentIndex(variable);
        QTest::qWait(20);
        membership.grab().save(folder + QStringLiteral("/plot%1").arg(variable) + suffix);
      }
      surface.grab().save(folder + "/surface" + suffix);
      inputs.grab().save(folder + "/inputs" + suffix);
    }
  QApplication::setPalette(light);
}

} // namespace
} // namespace esm
