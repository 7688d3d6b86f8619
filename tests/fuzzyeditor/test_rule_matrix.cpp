// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzzyeditor/rules/rule_matrix_model.h"
#include "fuzzyeditor/rules/rule_matrix_page.h"
#include "fuzzyeditor/rules/rules_panel.h"
#include "tests/fuzzyeditor/panel_fixture.h"

#include <QAbstractItemModelTester>
#include <QAbstractItemView>
#include <QComboBox>
#include <QLabel>
#include <QPainter>
#include <QTableView>

#include <cmath>

namespace esm {
namespace {

using test::PanelTest;

/// hardness (3 words) down, elasticity (2 words) across, stiffness in the cells: what the sample's rule 2
/// asks for, so the page opens with it.
struct RuleMatrixTest : PanelTest {
  RuleMatrixPage page{&evaluation};
  RuleMatrixModel* model = page.model();
  QAbstractItemModelTester tester{model, QAbstractItemModelTester::FailureReportingMode::Fatal};
  QTableView* table = page.findChild<QTableView*>("rulesMatrix");
  enum Hardness { Soft, Medium, Hard };
  enum Elasticity { Low, High };
  enum Stiffness { None = -1, LowE, MediumE, HighE };

  void SetUp() override { page.resize(600, 240); }
  QString shown(int row, int column) const { return model->index(row, column).data().toString(); }
  bool isEmpty(int row, int column) const
  {
    return model->index(row, column).data(RuleMatrixModel::IsEmptyRole).toBool();
  }
  const std::vector<fuzzy::Rule>& rules() const { return document.ruleBase().rules; }
  void addRule(const char* text)
  {
    fuzzy::RuleBase base = document.ruleBase();
    base.rules.push_back(std::get<fuzzy::Rule>(fuzzy::parseRule(text, base)));
    document.load(base);
  }
};

TEST_F(RuleMatrixTest, OpensWithTheInputsThatRulesJoin)
{
  EXPECT_EQ(model->rowInput(), 0);
  EXPECT_EQ(model->columnInput(), 1);
  EXPECT_EQ(model->output(), 0);
  EXPECT_EQ(model->rowCount(), 3);
  EXPECT_EQ(model->columnCount(), 2);
  EXPECT_EQ(model->headerData(Hard, Qt::Vertical).toString(), "hard");
  EXPECT_EQ(model->headerData(High, Qt::Horizontal).toString(), "high");
  EXPECT_EQ(page.findChild<QComboBox*>("matrixRows")->currentText(), "Hardness");
}

// Own rules plain, with their weight; rules of one condition in parentheses over their whole row; nothing
// where nothing is said.
TEST_F(RuleMatrixTest, CellsShowOwnRulesCoveringRulesAndHoles)
{
  EXPECT_EQ(shown(Medium, Low), "medium\u00a0×\u00a00.8");
  EXPECT_EQ(shown(Hard, Low), "(high)");
  EXPECT_EQ(shown(Hard, High), "(high)");
  for (const auto& [row, column] : {std::pair(Soft, Low), std::pair(Soft, High), std::pair(Medium, High)}) {
    EXPECT_EQ(shown(row, column), "");
    EXPECT_TRUE(isEmpty(row, column));
  }
  addRule("IF elasticity IS low AND hardness IS hard THEN stiffness IS very low"); // either order is the cell
  EXPECT_EQ(shown(Hard, Low), "very low · (high)");
  addRule("IF hardness IS soft OR elasticity IS high THEN stiffness IS low");
  EXPECT_EQ(shown(Soft, Low), "(low)");
  EXPECT_EQ(shown(Hard, High), "(high) · (low)");
  addRule("IF NOT hardness IS soft AND elasticity IS not high THEN stiffness IS medium");
  EXPECT_EQ(shown(Medium, Low), "medium\u00a0×\u00a00.8 · (medium)");
}

TEST_F(RuleMatrixTest, ARuleThatIsOffSaysSo)
{
  fuzzy::RuleBase base = document.ruleBase();
  base.rules[1].enabled = false;
  document.load(base);
  EXPECT_EQ(shown(Medium, Low), "medium\u00a0×\u00a00.8, off");
  model->setCells({model->index(Medium, Low)}, HighE); // a choice means it
  EXPECT_TRUE(rules()[1].enabled);
}

TEST_F(RuleMatrixTest, ChoosingAWordWritesChangesAndRemovesARule)
{
  const fuzzy::RuleBase before = document.ruleBase();
  model->setData(model->index(Soft, High), LowE);
  ASSERT_EQ(rules().size(), 4U);
  EXPECT_EQ(fuzzy::formatRule(rules()[3], document.ruleBase(), Language::English),
            "IF hardness IS soft AND elasticity IS high THEN stiffness IS low");
  EXPECT_EQ(shown(Soft, High), "low");
  model->setData(model->index(Soft, High), HighE);
  EXPECT_EQ(shown(Soft, High), "high");
  EXPECT_EQ(rules().size(), 4U);
  model->setData(model->index(Soft, High), None);
  EXPECT_TRUE(isEmpty(Soft, High));
  EXPECT_EQ(document.ruleBase(), before);
  EXPECT_EQ(document.undo.count(), 3); // one step each
  document.undo.undo();
  EXPECT_EQ(shown(Soft, High), "high");

  model->setData(model->index(Medium, Low), LowE); // keeps its weight
  EXPECT_EQ(rules()[1].weight, 0.8);
  EXPECT_EQ(shown(Medium, Low), "low\u00a0×\u00a00.8");
}

// Several own rules become the one that was chosen; what they say about other outputs stays.
TEST_F(RuleMatrixTest, OneChoiceSettlesACellOfSeveralRules)
{
  addRule("IF hardness IS medium AND elasticity IS low THEN stiffness IS high");
  addRule("IF hardness IS medium AND elasticity IS low THEN stiffness IS low AND viscosity IS high");
  EXPECT_EQ(shown(Medium, Low), "medium\u00a0×\u00a00.8 · high · low");
  model->setData(model->index(Medium, Low), HighE);
  EXPECT_EQ(shown(Medium, Low), "high\u00a0×\u00a00.8");
  ASSERT_EQ(rules().size(), 4U);
  ASSERT_EQ(rules()[3].consequents.size(), 1U);
  EXPECT_EQ(rules()[3].consequents[0].variable, "viscosity");
  EXPECT_EQ(document.undo.count(), 1);
}

TEST_F(RuleMatrixTest, KeysChooseAndClear)
{
  show(page);
  table->setFocus();
  table->setCurrentIndex(model->index(Soft, Low));
  QTest::keyClick(table, Qt::Key_Return);
  auto* choice = table->findChild<QComboBox*>("matrixCell");
  ASSERT_TRUE(choice);
  EXPECT_EQ(choice->accessibleName(), "hardness soft, elasticity low: no rule for stiffness.");
  EXPECT_EQ(choice->count(), 4); // no rule, low, medium, high
  ASSERT_TRUE(QTest::qWaitFor([&] { return choice->view()->isVisible(); }, 2000));
  QTest::keyClick(choice->view(), Qt::Key_Down);
  QTest::keyClick(choice->view(), Qt::Key_Return);
  EXPECT_EQ(shown(Soft, Low), "low");
  EXPECT_EQ(document.undo.count(), 1);
  QTest::qWait(20);
  EXPECT_EQ(table->currentIndex(), model->index(Soft, Low)); // ready for the next key
  EXPECT_TRUE(table->hasFocus());

  table->setFocus();
  table->setCurrentIndex(model->index(Soft, Low));
  QTest::keyClick(table, Qt::Key_Delete);
  EXPECT_TRUE(isEmpty(Soft, Low));
  EXPECT_EQ(document.undo.count(), 2);
  QTest::keyClick(table, Qt::Key_Delete); // nothing there: no step
  EXPECT_EQ(document.undo.count(), 2);
}

// The tint is the degree of now: hardness 0.5 is wholly medium, elasticity 0.2 mostly low.
TEST_F(RuleMatrixTest, CellsKnowHowStronglyTheirRulesFire)
{
  const auto own = [&](int row, int column) {
    return model->index(row, column).data(RuleMatrixModel::OwnDegreeRole).toDouble();
  };
  const double low = std::exp(-0.2 * 0.2 / (2 * 0.25 * 0.25));
  EXPECT_NEAR(own(Medium, Low), 0.8 * low, 1e-12);
  EXPECT_EQ(own(Hard, Low), 0.0);
  document.setInput(0, 1.0, 0);
  EXPECT_EQ(own(Medium, Low), 0.0);
  EXPECT_EQ(model->index(Hard, Low).data(RuleMatrixModel::CoverDegreeRole).toDouble(), 1.0);
  EXPECT_EQ(model->index(Hard, Low).data(Qt::AccessibleTextRole).toString(),
            "hardness hard, elasticity low: stiffness (high). Fires 1.00.");

  show(page);
  QTest::qWait(5);
  const QImage fires = table->viewport()->grab(table->visualRect(model->index(Hard, Low))).toImage();
  document.setInput(0, 0.0, 0);
  QTest::qWait(5);
  EXPECT_NE(table->viewport()->grab(table->visualRect(model->index(Hard, Low))).toImage(), fires);
}

// A cell without a rule must not look like one with a word that is cut off: it is hatched.
TEST_F(RuleMatrixTest, EmptyCellsAreHatched)
{
  document.setInput(0, 0.0, 0);
  show(page);
  const auto colors = [&](int row, int column) {
    const QImage cell = table->viewport()->grab(table->visualRect(model->index(row, column))).toImage();
    int ground = 0;
    for (int y = 4; y < cell.height() - 4; ++y)
      for (int x = 4; x < cell.width() - 4; ++x) ground += cell.pixel(x, y) == cell.pixel(3, 3);
    return double(ground) / ((cell.width() - 8) * (cell.height() - 8));
  };
  EXPECT_LT(colors(Soft, High), 0.9); // measured 0.8 at most: every eighth pixel belongs to a line
  EXPECT_TRUE(isEmpty(Soft, High));
}

TEST_F(RuleMatrixTest, RulesAboutOtherInputsAreCountedNotHidden)
{
  auto* note = page.findChild<QLabel*>("matrixNote");
  EXPECT_TRUE(note->text().isEmpty());
  fuzzy::RuleBase base = document.ruleBase();
  base.inputs.push_back(base.inputs[0]);
  base.inputs[2].id = "wall";
  base.inputs[2].name = {"wall", "Wand"};
  document.load(base);
  addRule("IF wall IS soft AND hardness IS soft THEN stiffness IS low");
  EXPECT_EQ(model->unshownRules(), 1);
  EXPECT_TRUE(note->text().startsWith("1 rule"));
  model->setAxes(2, 0, 0);
  EXPECT_EQ(shown(Soft, Soft), "low");
  EXPECT_EQ(model->unshownRules(), 1); // now it is the one about elasticity
}

TEST_F(RuleMatrixTest, AnInputChosenTwiceChangesPlaces)
{
  auto* rows = page.findChild<QComboBox*>("matrixRows");
  rows->setCurrentIndex(1);
  emit rows->activated(1);
  EXPECT_EQ(model->rowInput(), 1);
  EXPECT_EQ(model->columnInput(), 0);
  EXPECT_EQ(page.findChild<QComboBox*>("matrixColumns")->currentText(), "Hardness");
}

// Terms may come and go, and inputs too: the grid follows, or gives way to a sentence.
TEST_F(RuleMatrixTest, FollowsTheVocabulary)
{
  speak(Language::German);
  EXPECT_EQ(model->headerData(Soft, Qt::Vertical).toString(), "weich");
  EXPECT_EQ(shown(Hard, Low), "(groß)");
  fuzzy::RuleBase base = document.ruleBase();
  base.rules.clear();
  base.inputs[0].terms.pop_back();
  document.load(base);
  EXPECT_EQ(model->rowCount(), 2);
  base.inputs.pop_back();
  document.load(base);
  EXPECT_EQ(model->rowCount(), 0);
  EXPECT_FALSE(page.findChild<QLabel*>("matrixNote")->text().isEmpty());
  document.load(test::sampleRules());
  EXPECT_EQ(model->rowCount(), 3);
}

} // namespace
} // namespace esm
