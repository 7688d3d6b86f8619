// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzzyeditor/surface/surface_panel.h"
#include "fuzzyeditor/surface/surface_plot.h"
#include "fuzzyeditor/surface/surface_source.h"
#include "fuzzyeditor/surface/surface_table.h"
#include "tests/fuzzyeditor/panel_fixture.h"

#include <QAccessible>
#include <QClipboard>
#include <QComboBox>
#include <QGuiApplication>
#include <QPushButton>
#include <QTabWidget>
#include <QTableView>

#include <cmath>

namespace esm {
namespace {

using test::PanelTest;

struct SurfacePanelTest : PanelTest {
  SurfacePanel panel{&evaluation};
  SurfacePlot* plot = panel.plot();
  SurfaceSource* source = panel.source();

  void open()
  {
    panel.resize(520, 420);
    show(panel);
    QTest::qWait(5);
  }
  double input(std::size_t i) const { return std::get<double>(document.inputs()[i]); }
  void waitForAll()
  {
    ASSERT_TRUE(QTest::qWaitFor([&] { return source->surface() && !source->isRefining(); }, 20000));
  }
};

TEST_F(SurfacePanelTest, HiddenItComputesNothing)
{
  document.setInput(0, 0.9, 0);
  fuzzy::RuleBase rules = document.ruleBase();
  rules.rules[0].weight = 0.5;
  document.setRuleBase(rules, "weight");
  QTest::qWait(5);
  EXPECT_EQ(source->computations(), 0);
  open();
  EXPECT_EQ(source->computations(), 1);
  panel.hide();
  rules.rules[0].weight = 0.4;
  document.setRuleBase(rules, "weight");
  QTest::qWait(5);
  EXPECT_EQ(source->computations(), 1);
}

// The cross moves over the same surface; an edit of a rule makes another one, however many come in one turn.
TEST_F(SurfacePanelTest, ItComputesOnlyWhenTheSurfaceIsAnother)
{
  open();
  waitForAll();
  const int before = source->computations();
  for (const double hardness : {0.1, 0.2, 0.3}) document.setInput(0, hardness, 0);
  QTest::qWait(20);
  EXPECT_EQ(source->computations(), before);
  fuzzy::RuleBase rules = document.ruleBase();
  for (const double weight : {0.5, 0.4, 0.3}) {
    rules.rules[0].weight = weight;
    document.setRuleBase(rules, "weight", 1);
  }
  QTest::qWait(20);
  EXPECT_EQ(source->computations(), before + 1);
}

TEST_F(SurfacePanelTest, TheMapShowsWhatTheEngineSays)
{
  open();
  waitForAll();
  const fuzzy::ControlSurface& surface = *source->surface();
  ASSERT_EQ(surface.columns(), 41U);
  const auto engine = fuzzy::Engine::create(document.ruleBase());
  for (const std::size_t row : {0U, 13U, 40U})
    for (const std::size_t column : {0U, 20U, 37U}) {
      const std::vector<fuzzy::InputValue> inputs{surface.x[column], surface.y[row]};
      EXPECT_EQ(surface.at(row, column), engine->evaluate(inputs).outputs[0].value);
    }
}

TEST_F(SurfacePanelTest, DraggingTheCrossSetsBothInputsAsOneUndoStep)
{
  open();
  const QRectF map = plot->area();
  const QPoint from = plot->cross().toPoint();
  QTest::mousePress(plot, Qt::LeftButton, {}, from);
  for (int i = 1; i <= 8; ++i) QTest::mouseMove(plot, from + QPoint(6 * i, -5 * i));
  QTest::mouseRelease(plot, Qt::LeftButton, {}, from + QPoint(48, -40));
  EXPECT_EQ(document.undo.count(), 1);
  EXPECT_NEAR(input(0), 0.5 + 48 / map.width(), 1.0 / map.width());
  EXPECT_NEAR(input(1), 0.2 + 40 / map.height(), 1.0 / map.height());
  EXPECT_NEAR(plot->cross().x(), from.x() + 48, 1.0);
  document.undo.undo();
  EXPECT_EQ(input(0), 0.5);
  EXPECT_EQ(input(1), 0.2);
}

TEST_F(SurfacePanelTest, EscapeTakesADragBack)
{
  open();
  plot->setFocus();
  QTest::mousePress(plot, Qt::LeftButton, {}, plot->area().center().toPoint() + QPoint(30, 30));
  EXPECT_NE(input(1), 0.2);
  QTest::keyClick(plot, Qt::Key_Escape);
  EXPECT_EQ(input(0), 0.5);
  EXPECT_EQ(input(1), 0.2);
  EXPECT_EQ(document.undo.count(), 0);
}

TEST_F(SurfacePanelTest, KeysMoveTheCross)
{
  open();
  plot->setFocus();
  QTest::keyClick(plot, Qt::Key_Right);
  QTest::keyClick(plot, Qt::Key_Up, Qt::ShiftModifier);
  EXPECT_NEAR(input(0), 0.51, 1e-12);
  EXPECT_NEAR(input(1), 0.30, 1e-12);
  EXPECT_EQ(document.undo.count(), 1); // a run of keys
  QTest::keyClick(plot, Qt::Key_End);
  QTest::keyClick(plot, Qt::Key_PageDown);
  EXPECT_EQ(input(0), 1.0);
  EXPECT_EQ(input(1), 0.0);
}

TEST_F(SurfacePanelTest, ScreenReadersReadAndSetBothInputs)
{
  open();
  QAccessibleInterface* access = QAccessible::queryAccessibleInterface(plot);
  ASSERT_TRUE(access);
  ASSERT_EQ(access->childCount(), 2);
  EXPECT_EQ(access->child(0)->text(QAccessible::Name), "Hardness");
  EXPECT_EQ(access->child(1)->text(QAccessible::Name), "Elasticity");
  EXPECT_EQ(access->child(0)->text(QAccessible::Value),
            "Hardness 0.50, elasticity 0.20: stiffness 31.6\u00a0kPa");
  access->child(1)->valueInterface()->setCurrentValue(0.7);
  EXPECT_EQ(input(1), 0.7);
  EXPECT_EQ(access->child(1)->valueInterface()->currentValue().toDouble(), 0.7);
}

TEST_F(SurfacePanelTest, AWordStaysOnTheAxisThatDoesNotMove)
{
  document.setInput(1, fuzzy::Word{"high", {}}, 0);
  open();
  plot->setFocus();
  QTest::keyClick(plot, Qt::Key_Left);
  EXPECT_EQ(document.inputs()[1], fuzzy::InputValue(fuzzy::Word{"high", {}}));
  EXPECT_NEAR(input(0), 0.49, 1e-12);
}

TEST_F(SurfacePanelTest, TheSameInputTwiceSwapsTheAxes)
{
  open();
  auto* x = panel.findChild<QComboBox*>("surfaceX");
  auto* y = panel.findChild<QComboBox*>("surfaceY");
  x->setCurrentIndex(1);
  EXPECT_EQ(y->currentIndex(), 0);
  EXPECT_EQ(source->question().x, 1);
  EXPECT_EQ(source->question().y, 0);
  EXPECT_TRUE(source->surface());
}

TEST_F(SurfacePanelTest, TheTableIsCopiedAsColumnsThatOtherProgramsRead)
{
  speak(Language::German);
  open();
  panel.findChild<QTabWidget*>("surfaceTabs")->setCurrentIndex(1);
  waitForAll();
  QTest::qWait(5);
  auto* view = panel.findChild<QTableView*>("surfaceTable");
  EXPECT_EQ(view->model()->rowCount(), 41 * 41);
  panel.findChild<QPushButton*>("surfaceCopy")->click();
  const QStringList lines = QGuiApplication::clipboard()->text().split('\n');
  ASSERT_EQ(lines.size(), 41 * 41 + 2); // header, rows, the end of the last
  EXPECT_EQ(lines[0], "\"Härte\",\"Elastizität\",\"Steifigkeit [kPa]\"");
  const fuzzy::ControlSurface& surface = *source->surface();
  const QStringList fields = lines[1 + 5 * 41 + 20].split(',');
  ASSERT_EQ(fields.size(), 3);
  EXPECT_NEAR(fields[0].toDouble(), surface.x[20], 1e-11);
  EXPECT_NEAR(fields[1].toDouble(), surface.y[5], 1e-11);
  EXPECT_NEAR(fields[2].toDouble() * 1e3, surface.at(5, 20), 1e-9 * surface.at(5, 20));
  EXPECT_EQ(lines[1].split(',')[2], ""); // soft and no rule about it
}

TEST_F(SurfacePanelTest, ARuleBaseWithoutASurfaceIsSaid)
{
  fuzzy::RuleBase rules = document.ruleBase();
  rules.rules.clear();
  rules.inputs.erase(rules.inputs.begin());
  open();
  document.load(rules);
  QTest::qWait(5);
  EXPECT_FALSE(source->surface());
  EXPECT_EQ(plot->pointCount(), 0);
  EXPECT_EQ(plot->accessibleDescription(), "There is no result or there are no two inputs to show.");
  plot->grab();
}

} // namespace
} // namespace esm
