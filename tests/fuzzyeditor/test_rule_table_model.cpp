// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzzyeditor/rules/rule_table_model.h"
#include "tests/fuzzyeditor/fake_fuzzy_document.h"

#include <QAbstractItemModelTester>
#include <QMimeData>
#include <QPersistentModelIndex>
#include <QPoint>

#include <gtest/gtest.h>

#include <memory>

namespace esm {
namespace {

using test::FakeFuzzyDocument;
using Model = RuleTableModel;

struct RuleTable : testing::Test {
  FakeFuzzyDocument document;
  FuzzyEvaluation evaluation{&document};
  Model model{&evaluation};
  QAbstractItemModelTester tester{&model, QAbstractItemModelTester::FailureReportingMode::Fatal};

  QString text(int row, int column) const { return model.index(row, column).data().toString(); }
  bool set(int row, int column, const QVariant& value)
  {
    return model.setData(model.index(row, column), value);
  }
  const std::vector<fuzzy::Rule>& rules() const { return document.ruleBase().rules; }
};

TEST_F(RuleTable, ShowsRulesWithoutKeywordsInTheirOwnColumns)
{
  EXPECT_EQ(text(0, Model::Condition), "hardness IS very hard");
  EXPECT_EQ(text(0, Model::Conclusion), "stiffness IS high");
  EXPECT_EQ(text(1, Model::Weight), "0.80");
  EXPECT_EQ(text(1, Model::Conclusion), "stiffness IS medium"); // the weight has its own column
  EXPECT_EQ(text(2, Model::Note), "not measured yet");
  EXPECT_EQ(text(2, Model::Degree), "off");
}

// Hardness 0.5 is medium with 1, elasticity 0.2 low with exp(-0.2^2 / (2 0.25^2)) = 0.726; times 0.8.
TEST_F(RuleTable, DegreeIsThatOfTheCurrentInputs)
{
  EXPECT_NEAR(model.index(1, Model::Degree).data(Model::DegreeRole).toDouble(), 0.8 * 0.72615, 1e-4);
  document.setInput(0, 1.0, 0);
  EXPECT_NEAR(model.index(0, Model::Degree).data(Model::DegreeRole).toDouble(), 1.0, 1e-12);
  EXPECT_EQ(model.index(1, Model::Degree).data(Model::DegreeRole).toDouble(), 0.0);
}

TEST_F(RuleTable, EditingACellIsOneUndoStepAndKeepsTheRest)
{
  const fuzzy::Rule before = rules()[0];
  EXPECT_TRUE(set(0, Model::Condition, "Härte IST mittel ODER elasticity IS low"));
  EXPECT_EQ(document.undo.count(), 1);
  EXPECT_EQ(text(0, Model::Condition), "hardness IS medium OR elasticity IS low");
  EXPECT_EQ(rules()[0].consequents, before.consequents);
  EXPECT_EQ(rules()[0].note, "palpation");
  document.undo.undo();
  EXPECT_EQ(rules()[0], before);
  EXPECT_EQ(text(0, Model::Condition), "hardness IS very hard");
}

TEST_F(RuleTable, TheSameTextAgainIsNoUndoStep)
{
  EXPECT_TRUE(set(0, Model::Condition, "hardness is VERY hard"));
  EXPECT_EQ(document.undo.count(), 0);
}

TEST_F(RuleTable, AMistakeStaysInItsCellAndLeavesTheRuleAlone)
{
  document.setLanguage(Language::German);
  const fuzzy::RuleBase before = document.ruleBase();
  EXPECT_FALSE(set(1, Model::Conclusion, "Steifigkeit IST gros"));
  EXPECT_EQ(document.ruleBase(), before);
  EXPECT_EQ(document.undo.count(), 0);
  EXPECT_EQ(text(1, Model::Conclusion), "Steifigkeit IST gros"); // not lost
  EXPECT_EQ(model.index(1, Model::Conclusion).data(Model::MistakeRangeRole).toPoint(), QPoint(16, 4));
  ASSERT_TRUE(model.mistake());
  EXPECT_EQ(model.mistake()->error.suggestion, "groß");

  model.cureMistake();
  EXPECT_FALSE(model.mistake());
  EXPECT_EQ(text(1, Model::Conclusion), "Steifigkeit IST groß");
  EXPECT_EQ(rules()[1].weight, 0.8);
  EXPECT_EQ(document.undo.count(), 1);
}

TEST_F(RuleTable, AMistakeMovesWithItsRule)
{
  EXPECT_FALSE(set(2, Model::Condition, "hardnes IS soft"));
  model.removeRules({0});
  ASSERT_TRUE(model.mistake());
  EXPECT_EQ(model.mistake()->row, 1);
  EXPECT_EQ(text(1, Model::Condition), "hardnes IS soft");
}

TEST_F(RuleTable, WeightMustLieBetweenZeroAndOne)
{
  EXPECT_FALSE(set(0, Model::Weight, 1.5));
  EXPECT_TRUE(set(0, Model::Weight, 0.25));
  EXPECT_EQ(rules()[0].weight, 0.25);
}

TEST_F(RuleTable, CheckBoxSwitchesARule)
{
  EXPECT_TRUE(model.setData(model.index(2, Model::On), Qt::Checked, Qt::CheckStateRole));
  EXPECT_TRUE(rules()[2].enabled);
  EXPECT_EQ(document.undo.count(), 1);
}

TEST_F(RuleTable, WholeRulesMoveDuplicateAndGoEachInOneStep)
{
  const std::vector<fuzzy::Rule> start = rules();
  EXPECT_EQ(model.moveRules({1, 2}, 0), 0);
  EXPECT_EQ(rules(), (std::vector<fuzzy::Rule>{start[1], start[2], start[0]}));
  EXPECT_EQ(model.duplicateRules({0, 2}), 3);
  EXPECT_EQ(rules().size(), 5U);
  EXPECT_EQ(rules()[4], start[0]);
  model.removeRules({0, 1, 3});
  EXPECT_EQ(rules(), (std::vector<fuzzy::Rule>{start[0], start[0]}));
  EXPECT_EQ(document.undo.count(), 3);
  for (int i = 0; i < 3; ++i) document.undo.undo();
  EXPECT_EQ(rules(), start);
  EXPECT_EQ(model.rowCount(), 3);
}

TEST_F(RuleTable, SelectionStaysWithItsRuleWhenOthersComeAndGo)
{
  const QPersistentModelIndex first = model.index(0, 0), last = model.index(2, 0);
  model.addRule(0);
  EXPECT_EQ(first.row(), 0);
  EXPECT_EQ(last.row(), 3);
  model.removeRules({1});
  EXPECT_EQ(last.row(), 2);
}

TEST_F(RuleTable, DroppingMovesRules)
{
  const std::vector<fuzzy::Rule> start = rules();
  const std::unique_ptr<QMimeData> dragged(model.mimeData({model.index(2, 0), model.index(2, 1)}));
  model.dropMimeData(dragged.get(), Qt::MoveAction, 0, 0, {});
  EXPECT_EQ(rules(), (std::vector<fuzzy::Rule>{start[2], start[0], start[1]}));
}

// A new rule says what holds now, so that adding it does not jerk the tissue.
TEST_F(RuleTable, NewRuleDescribesTheCurrentState)
{
  document.setInput(0, 0.95, 0);
  const double before = evaluation.inference().outputs[0].value;
  EXPECT_EQ(model.addRule(0), 1);
  EXPECT_EQ(text(1, Model::Condition), "hardness IS hard");
  EXPECT_EQ(text(1, Model::Conclusion), "stiffness IS high");
  EXPECT_NEAR(evaluation.inference().outputs[0].value / before, 1.0, 0.1); // the set grows a little
}

TEST_F(RuleTable, FollowsTheLanguage)
{
  document.setLanguage(Language::German);
  EXPECT_EQ(text(0, Model::Condition), "Härte IST sehr hart");
  EXPECT_EQ(model.headerData(Model::Condition, Qt::Horizontal).toString(), "WENN");
}

} // namespace
} // namespace esm
