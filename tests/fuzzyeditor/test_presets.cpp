// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tissue/presets.h"
#include "fuzzyeditor/inputs_panel.h"
#include "fuzzyeditor/preset_bar.h"
#include "tests/fuzzyeditor/panel_fixture.h"

#include <QAction>
#include <QLabel>
#include <QMenu>
#include <QToolButton>

namespace esm {
namespace {

using test::PanelTest;

struct PresetsTest : PanelTest {
  InputsPanel panel{&evaluation};
  QMenu* menu = panel.findChild<QMenu*>("presetMenu");
  QLabel* current = panel.findChild<QLabel*>("presetCurrent");

  void SetUp() override
  {
    panel.resize(360, 700);
    document.load(defaultRules());
    show(panel);
    QTest::qWait(5);
  }
  QString value(const char* id) const
  {
    return panel.findChild<QLabel*>(QStringLiteral("value_") + id)->text();
  }
  void choose(const char* id) { panel.findChild<QAction*>(QStringLiteral("actPreset_") + id)->trigger(); }
};

TEST_F(PresetsTest, OneChoiceIsOneStepAndLeavesTheBedAlone)
{
  EXPECT_EQ(menu->actions().size(), 12);
  document.setInput(2, 0.1, 0); // shiftability
  const std::vector<fuzzy::InputValue> before = document.inputs();
  choose("liver");
  EXPECT_EQ(document.undo.count(), 2);
  EXPECT_EQ(document.undo.undoText(), "Preset: liver");
  EXPECT_EQ(document.inputs()[2], before[2]);
  EXPECT_EQ(document.inputs()[0], fuzzy::InputValue(fuzzy::Word{"doughy", {}}));
  EXPECT_EQ(current->text(), "The inputs are those of: liver");
  document.undo.undo();
  EXPECT_EQ(document.inputs(), before);
  EXPECT_EQ(current->text(), "The inputs are those of no preset.");
}

// Twelve presets, twelve sets of words: each is known again by its own.
TEST_F(PresetsTest, EachIsKnownAgain)
{
  for (const TissuePreset& preset : tissuePresets()) {
    choose(preset.id);
    EXPECT_EQ(current->text(), QStringLiteral("The inputs are those of: ") + preset.name.english.c_str());
  }
}

TEST_F(PresetsTest, SourcesSayHowItWasMeasuredAndWhatIsOnlyAnEstimate)
{
  auto* info = panel.findChild<QToolButton*>("presetInfo");
  auto* details = panel.findChild<QLabel*>("presetDetails");
  EXPECT_FALSE(info->isEnabled()); // of no preset
  choose("uterus");
  ASSERT_TRUE(info->isEnabled());
  QTest::mouseClick(info, Qt::LeftButton);
  ASSERT_TRUE(details->isVisible());
  for (const char* part :
       {"6.38\u00a0kPa (2.76\u00a0kPa to 11.3\u00a0kPa)", "shear wave elastography, in vivo", "Stader et al.",
        "1.05\u00a0g/cm³", "0.09 (0.05 to 0.13), estimate", "Kiss et al."})
    EXPECT_TRUE(details->text().contains(part)) << part << "\n" << qPrintable(details->text());
  speak(Language::German);
  for (const char* part :
       {"6,38\u00a0kPa", "2,76\u00a0kPa", "Scherwellen-Elastographie, in vivo", "Steifigkeit"})
    EXPECT_TRUE(details->text().contains(part)) << part << "\n" << qPrintable(details->text());
  document.setInput(0, 0.3, 0); // no longer the preset
  EXPECT_FALSE(details->isVisible());
}

TEST_F(PresetsTest, TooltipsOfTheMenuTellTheSame)
{
  EXPECT_TRUE(panel.findChild<QAction*>("actPreset_skin")->toolTip().contains("Ni Annaidh et al. 2012"));
}

// A rule base without the words of a preset gets no half preset: the menu says what can be had.
TEST_F(PresetsTest, WhatTheRuleBaseCannotSayIsOff)
{
  fuzzy::RuleBase rules = document.ruleBase();
  rules.rules.clear();
  rules.inputs[0].terms.erase(rules.inputs[0].terms.begin() + 1); // doughy
  document.load(rules);
  QTest::qWait(5);
  EXPECT_FALSE(panel.findChild<QAction*>("actPreset_liver")->isEnabled());
  EXPECT_TRUE(panel.findChild<QAction*>("actPreset_skin")->isEnabled());
}

TEST_F(PresetsTest, ResetBringsAllInputsBackInOneStep)
{
  auto* reset = panel.findChild<QToolButton*>("inputsReset");
  EXPECT_FALSE(reset->isEnabled());
  choose("skin");
  document.setInput(2, 0.9, 0);
  QTest::mouseClick(reset, Qt::LeftButton);
  EXPECT_EQ(document.undo.count(), 3);
  for (const fuzzy::InputValue& value : document.inputs()) EXPECT_EQ(value, fuzzy::InputValue(0.5));
  EXPECT_FALSE(reset->isEnabled());
}

// kPa, g/cm³, per cent, and what a finger feels: 31.6 kPa at the middle of the sliders give way by 2.6 mm.
TEST_F(PresetsTest, ResultsHaveTheUnitsOfPhysicians)
{
  EXPECT_EQ(value("youngs_modulus"), "31.6\u00a0kPa");
  EXPECT_EQ(value("density"), "1.05\u00a0g/cm³");
  EXPECT_EQ(value("rupture_strain"), "66.1\u00a0%");
  auto* deflection = panel.findChild<QLabel*>("valueDeflection");
  EXPECT_TRUE(deflection->isVisible());
  EXPECT_EQ(deflection->text(), "2.61\u00a0mm");
  choose("fat");
  QTest::qWait(5);
  EXPECT_EQ(deflection->text(), ">\u00a05.00\u00a0mm");
  document.load(test::sampleRules()); // knows nothing of volume
  QTest::qWait(5);
  EXPECT_FALSE(deflection->isVisible());
}

} // namespace
} // namespace esm
