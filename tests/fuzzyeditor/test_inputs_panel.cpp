// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzzyeditor/inputs_panel.h"
#include "fuzzyeditor/number_spin_box.h"
#include "tests/fuzzyeditor/panel_fixture.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QScrollArea>
#include <QSlider>
#include <QToolButton>

namespace esm {
namespace {

using test::PanelTest;

struct InputsPanelTest : PanelTest {
  InputsPanel panel{&evaluation};
  QSlider* slider = panel.findChild<QSlider*>("slider_hardness");
  NumberSpinBox* spin = panel.findChild<NumberSpinBox*>("spin_hardness");
  QComboBox* word = panel.findChild<QComboBox*>("word_hardness");

  void SetUp() override { panel.resize(340, 420); }
  double hardness() const { return std::get<double>(document.inputs()[0]); }
  void typeWord(const QString& text)
  {
    word->setFocus();
    word->lineEdit()->selectAll();
    QTest::keyClicks(word->lineEdit(), text);
    QTest::keyClick(word->lineEdit(), Qt::Key_Return);
  }
  void typeNumber(const QString& text)
  {
    spin->setFocus();
    spin->selectAll();
    QTest::keyClicks(spin, text);
    QTest::keyClick(spin, Qt::Key_Return);
  }
};

TEST_F(InputsPanelTest, ALongNameOfARegionPushesNoFieldOutOfSight)
{
  QWidget* content = panel.findChild<QScrollArea*>()->widget();
  const int before = content->minimumSizeHint().width();
  document.target = QString(80, 'W');
  emit document.inputsChanged();
  EXPECT_TRUE(panel.findChild<QLabel*>("inputsTarget")->text().contains(document.target));
  EXPECT_EQ(content->minimumSizeHint().width(), before);
}

TEST_F(InputsPanelTest, OneDragIsOneUndoStepAndFieldsFollow)
{
  for (int drag = 1; drag <= 2; ++drag) {
    slider->setSliderDown(true);
    for (const int value : {600, 700, 800}) slider->setValue(value + drag);
    slider->setSliderDown(false);
  }
  EXPECT_EQ(document.undo.count(), 2);
  EXPECT_EQ(hardness(), 0.802);
  EXPECT_EQ(spin->text(), "0.802");
  EXPECT_EQ(word->currentText(), "hard 0.60");
  document.undo.undo();
  EXPECT_EQ(slider->value(), 801);
  document.undo.undo();
  EXPECT_EQ(slider->value(), 500);
  document.undo.redo();
  EXPECT_EQ(hardness(), 0.801); // the first drag's end, not its start
}

TEST_F(InputsPanelTest, ARunOfArrowKeysIsOneUndoStep)
{
  show(panel);
  slider->setFocus();
  for (int i = 0; i < 5; ++i) QTest::keyClick(slider, Qt::Key_Right);
  EXPECT_EQ(document.undo.count(), 1);
  EXPECT_NEAR(hardness(), 0.55, 1e-12);
  QTest::qWait(750); // longer than the pause that ends a run
  QTest::keyClick(slider, Qt::Key_Right);
  EXPECT_EQ(document.undo.count(), 2);
}

// "62,5" must not become 625, whichever language the program speaks.
TEST_F(InputsPanelTest, NumbersTakeCommaAndPointInBothLanguages)
{
  for (const Language language : {Language::German, Language::English}) {
    speak(language);
    typeNumber("0,625");
    EXPECT_EQ(hardness(), 0.625);
    EXPECT_EQ(spin->text(), language == Language::German ? "0,625" : "0.625");
    typeNumber("0.25");
    EXPECT_EQ(hardness(), 0.25);
    EXPECT_EQ(spin->text(), language == Language::German ? "0,25" : "0.25");
  }
  EXPECT_EQ(document.undo.count(), 4); // a typed number is a step of its own
}

TEST_F(InputsPanelTest, AWordBecomesAFuzzyInput)
{
  speak(Language::German);
  show(panel);
  typeWord("sehr hart");
  const fuzzy::InputValue veryHard = fuzzy::Word{"hard", {fuzzy::Hedge::Very}};
  EXPECT_EQ(document.inputs()[0], veryHard);
  EXPECT_EQ(word->currentText(), "sehr hart");
  EXPECT_EQ(slider->value(), 1000); // where the word fits best
  speak(Language::English);
  EXPECT_EQ(word->currentText(), "very hard");
  slider->setValue(300); // back to a number
  EXPECT_EQ(hardness(), 0.3);
}

TEST_F(InputsPanelTest, AWordChosenFromTheListIsTaken)
{
  show(panel);
  word->setCurrentIndex(0);
  emit word->activated(0);
  EXPECT_EQ(document.inputs()[0], fuzzy::InputValue(fuzzy::Word{"soft", {}}));
  EXPECT_EQ(document.undo.count(), 1);
}

TEST_F(InputsPanelTest, AMistypedWordIsSaidAtTheFieldAndStays)
{
  speak(Language::German);
  show(panel);
  auto* mistake = panel.findChild<QLabel*>("mistake_hardness");
  typeWord("hrat");
  EXPECT_EQ(document.undo.count(), 0);
  EXPECT_EQ(word->currentText(), "hrat");
  ASSERT_TRUE(mistake->isVisible());
  EXPECT_EQ(mistake->text(), "„hrat“ ist kein Wort dieser Größe. Ist „hart“ gemeint?");
  document.setInput(1, 0.9, 0); // a change elsewhere does not throw it away
  EXPECT_EQ(word->currentText(), "hrat");
  QTest::keyClick(word->lineEdit(), Qt::Key_Escape);
  EXPECT_EQ(word->currentText(), "mittel 1,00");
  EXPECT_FALSE(mistake->isVisible());
  typeWord("7");
  EXPECT_EQ(mistake->text(), "Der Wert muss zwischen 0,00 und 1,00 liegen.");
}

TEST_F(InputsPanelTest, ResetGoesBackToTheDefault)
{
  auto* reset = panel.findChild<QToolButton*>("reset_hardness");
  EXPECT_FALSE(reset->isEnabled());
  document.setInput(0, 0.9, 0);
  EXPECT_TRUE(reset->isEnabled());
  reset->click();
  EXPECT_EQ(hardness(), 0.5);
}

TEST_F(InputsPanelTest, ResultsAreInTheUnitsThatPhysiciansRead)
{
  show(panel);
  QTest::qWait(1);
  // The centroid of a symmetric set on log10 is its middle: 10^4.5 Pa.
  EXPECT_EQ(panel.findChild<QLabel*>("value_youngs_modulus")->text(), "31.6\u00a0kPa");
  EXPECT_FALSE(panel.findChild<QLabel*>("default_youngs_modulus")->isVisible());
  EXPECT_EQ(panel.findChild<QLabel*>("value_viscosity")->text(), "4.00\u00a0ms");
  EXPECT_TRUE(panel.findChild<QLabel*>("default_viscosity")->isVisible());
}

TEST_F(InputsPanelTest, SaysWhoseTissueItIs)
{
  document.target = "Wall";
  emit document.inputsChanged();
  EXPECT_EQ(panel.findChild<QLabel*>("inputsTarget")->text(), "Tissue: Wall");
}

TEST_F(InputsPanelTest, AnotherRuleBaseGetsItsOwnRows)
{
  fuzzy::RuleBase other = test::sampleRules();
  other.rules.clear();
  other.inputs.erase(other.inputs.begin());
  document.load(other);
  EXPECT_FALSE(panel.findChild<QSlider*>("slider_hardness"));
  EXPECT_TRUE(panel.findChild<QSlider*>("slider_elasticity"));
}

} // namespace
} // namespace esm
