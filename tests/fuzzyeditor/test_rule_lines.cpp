// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzzyeditor/rules/rule_lines.h"
#include "tests/fuzzyeditor/fake_fuzzy_document.h"

#include <gtest/gtest.h>

namespace esm {
namespace {

struct RuleLines : testing::Test {
  fuzzy::RuleBase base = test::sampleRules();
  RuleLineReader reader;
  const QString first = "IF hardness IS very hard THEN stiffness IS high";
  const QString second = "IF hardness IS medium AND elasticity IS low THEN stiffness IS medium WITH 0.8";
  const QString third = "IF elasticity IS high THEN viscosity IS low";

  std::vector<RuleLine> read(const QStringList& text)
  {
    std::vector<RuleLine> lines = reader.read(text, base);
    findSources(lines, base.rules);
    return lines;
  }
  std::vector<int> sources(const QStringList& text)
  {
    std::vector<int> result;
    for (const RuleLine& line : read(text)) result.push_back(line.source);
    return result;
  }
};

TEST_F(RuleLines, UnchangedTextGivesTheVeryRules)
{
  EXPECT_EQ(rulesOf(read({first, second, third}), base.rules), base.rules);
}

TEST_F(RuleLines, OffAndNoteSurviveMovingAndEditing)
{
  const QString changed = "IF elasticity IS low THEN viscosity IS high";
  EXPECT_EQ(sources({third, first, second}), (std::vector<int>{2, 0, 1}));
  EXPECT_EQ(sources({first, second, changed}), (std::vector<int>{0, 1, 2}));
  const std::vector<fuzzy::Rule> rules = rulesOf(read({first, second, changed}), base.rules);
  EXPECT_FALSE(rules[2].enabled);
  EXPECT_EQ(rules[2].note, "not measured yet");
}

TEST_F(RuleLines, ANewLineTakesNothingFromOthers)
{
  const QString fresh = "IF hardness IS soft THEN stiffness IS low";
  EXPECT_EQ(sources({first, fresh, second, third}), (std::vector<int>{0, -1, 1, 2}));
  EXPECT_EQ(sources({first, third}), (std::vector<int>{0, 2}));
  EXPECT_EQ(sources({fresh, "", "# remark", first, second, third}), (std::vector<int>{-1, -1, -1, 0, 1, 2}));
}

TEST_F(RuleLines, TwoEqualRulesAreTwo)
{
  EXPECT_EQ(sources({first, first, second, third}), (std::vector<int>{0, -1, 1, 2}));
}

TEST_F(RuleLines, AMistakeIsToldByItsNeighbours)
{
  EXPECT_EQ(sources({first, "IF hardness IS medum THEN stiffness IS high", third}),
            (std::vector<int>{0, 1, 2}));
}

TEST_F(RuleLines, MergingKeepsRemarksAndMistakesAndTakesChangesFromElsewhere)
{
  const QStringList text{"# my findings", first, "IF hardness IS medum", third};
  const std::vector<RuleLine> lines = read(text);
  fuzzy::RuleBase now = base;
  now.rules[0].weight = 0.5;          // changed in the table
  now.rules.push_back(base.rules[1]); // and one added, equal to one whose line is a mistake
  now.rules.back().condition = base.rules[2].condition;
  EXPECT_EQ(mergedText(lines, base.rules, now, Language::English),
            (QStringList{"# my findings", first + " WITH 0.5", "IF hardness IS medum", third,
                         "IF elasticity IS high THEN stiffness IS medium WITH 0.8"}));
  now.rules.erase(now.rules.begin() + 1); // the rule of the mistake goes, the text typed stays
  EXPECT_TRUE(mergedText(lines, base.rules, now, Language::English).contains("IF hardness IS medum"));
}

TEST_F(RuleLines, MergingDoesNotBringBackADeletedLine)
{
  const std::vector<RuleLine> lines = read({first, "IF hardness IS medum AND elasticity", third, "nonsense"});
  EXPECT_EQ(mergedText(read({first, third}), base.rules, base, Language::English),
            (QStringList{first, third}));
  EXPECT_EQ(mergedText(lines, base.rules, base, Language::German).size(), 4);
}

TEST_F(RuleLines, LanguageSwitchTranslatesTheRulesOnly)
{
  EXPECT_EQ(
    mergedText(read({"# remark", first, "IF gibberish"}), base.rules, base, Language::German).first(2),
    (QStringList{"# remark", "WENN Härte IST sehr hart DANN Steifigkeit IST groß"}));
}

} // namespace
} // namespace esm
