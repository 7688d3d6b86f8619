// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzzyeditor/why/why_panel.h"

#include "core/net/net_builder.h"
#include "fuzzyeditor/rules/rule_display.h"
#include "fuzzyeditor/why/why_tree.h"
#include "tests/fuzzyeditor/panel_fixture.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTreeWidget>

#include <optional>

namespace esm {
namespace {

using test::PanelTest;

/// A square of two triangles, half of it in a region, and the application's part of the work.
class SampleSource : public WhySource {
public:
  SampleSource()
  {
    Mesh mesh;
    mesh.position.resize(3, 4);
    mesh.position << 0, 0.01, 0.01, 0, 0, 0, 0.01, 0.01, 0, 0, 0, 0;
    mesh.triangles.resize(3, 2);
    mesh.triangles << 0, 0, 1, 2, 2, 3;
    auto built = buildNet(mesh);
    EXPECT_TRUE(built);
    net = std::move(built).value();
    Region wall;
    wall.name = "Wall";
    wall.ellipsoid.centre = {0.01, 0.005, 0};
    wall.ellipsoid.semiAxes.setConstant(0.02);
    wall.falloff = 1.0;
    wall.inputs = model.inputs;
    wall.inputs[0] = 0.8;
    model.regions.push_back(wall);
    derive();
  }
  void derive()
  {
    EXPECT_TRUE(applyTissue(model, net));
    auto made = TissueField::create(model);
    EXPECT_TRUE(made);
    m_field.emplace(std::move(made).value());
    emit changed();
  }
  void speak(Language language)
  {
    m_language = language;
    emit changed();
  }
  const TissueField* field() const override { return broken ? nullptr : &*m_field; }
  TissueExplanation explanation() const override
  {
    return TissueExplainer(net).explain(*m_field, net, thing);
  }
  Language language() const override { return m_language; }
  void apply(const InputChange& change) override
  {
    auto& inputs =
      change.region < 0 ? model.inputs : model.regions[static_cast<std::size_t>(change.region)].inputs;
    inputs[static_cast<std::size_t>(change.input)] = change.to;
    ++applied;
    derive();
  }

  TissueModel model = defaultTissue();
  SpringNet net;
  ExplainedThing thing{ExplainedThing::Kind::Spring, 0};
  bool broken = false;
  int applied = 0;

private:
  std::optional<TissueField> m_field;
  Language m_language = Language::English;
};

struct WhyPanelTest : PanelTest {
  SampleSource source;
  WhyPanel panel{&source};
  QLabel* sentence = panel.findChild<QLabel*>("whySentence");
  QTreeWidget* tree = panel.findChild<QTreeWidget*>("whyTree");

  void showPanel()
  {
    panel.resize(400, 420);
    show(panel);
    QTest::qWait(5);
  }
  QString text(const char* object) { return panel.findChild<QLabel*>(object)->text(); }
};

TEST_F(WhyPanelTest, SentenceAndTreeAreTheExplanation)
{
  showPanel();
  const TissueExplanation why = source.explanation();
  EXPECT_EQ(sentence->text(), toQt(sentenceOf(why, source.model, Language::English)));
  ASSERT_EQ(why.layers.size(), 2U);
  ASSERT_EQ(tree->topLevelItemCount(), 3 + 1 + 2); // three numbers, geometry, base tissue and region
  EXPECT_EQ(tree->topLevelItem(0)->text(WhyTree::What), "stiffness = E h A / L²");
  EXPECT_EQ(tree->topLevelItem(0)->text(WhyTree::Value), toQt(shownNumber(why.main(), Language::English)));
  const bool wallFirst = why.layers[1].layer.share > why.layers[0].layer.share;
  const QTreeWidgetItem* strongest = tree->topLevelItem(4);
  EXPECT_EQ(strongest->text(WhyTree::What), wallFirst ? "Region Wall" : "Base tissue");
  EXPECT_TRUE(strongest->isExpanded());
  const QTreeWidgetItem* rule = strongest->child(0)->child(0);
  EXPECT_TRUE(rule->text(WhyTree::What).startsWith("Rule ")) << qPrintable(rule->text(WhyTree::What));
  EXPECT_EQ(rule->data(WhyTree::Share, WhyTree::kShareRole).toDouble(),
            why.layers[wallFirst ? 1 : 0].outputs[0].rules[0].degree);
  EXPECT_TRUE(rule->child(0)->text(WhyTree::What).startsWith("hardness: "));
}

// What is unfolded stays so while a slider moves.
TEST_F(WhyPanelTest, FollowsAndKeepsWhatIsUnfolded)
{
  showPanel();
  tree->topLevelItem(3)->setExpanded(true);
  tree->topLevelItem(4)->setExpanded(false);
  const QString before = sentence->text();
  source.model.inputs[0] = 0.9;
  source.derive();
  QTest::qWait(5);
  EXPECT_NE(sentence->text(), before);
  EXPECT_TRUE(tree->topLevelItem(3)->isExpanded());
  EXPECT_FALSE(tree->topLevelItem(4)->isExpanded());
}

// So it does when the shares change places, and when another thing is chosen.
TEST_F(WhyPanelTest, KeepsWhatIsUnfoldedWhenRowsMove)
{
  showPanel();
  const QString strongest = tree->topLevelItem(4)->text(WhyTree::What);
  ASSERT_TRUE(tree->topLevelItem(4)->isExpanded());
  source.thing = {ExplainedThing::Kind::Node, strongest == "Region Wall" ? 3 : 1}; // at the other end
  source.model.regions[0].ellipsoid.semiAxes.setConstant(0.012);
  source.derive();
  QTest::qWait(5);
  const QList<QTreeWidgetItem*> found = tree->findItems(strongest, Qt::MatchExactly, WhyTree::What);
  ASSERT_EQ(found.size(), 1);
  EXPECT_NE(tree->indexOfTopLevelItem(found[0]), 4) << "else nothing has moved";
  EXPECT_TRUE(found[0]->isExpanded());
  EXPECT_TRUE(found[0]->child(0)->isExpanded());
}

TEST_F(WhyPanelTest, HiddenItAsksNothingAndShownOncePerTurn)
{
  for (int i = 0; i < 5; ++i) source.derive();
  QTest::qWait(5);
  EXPECT_EQ(panel.explanations(), 0);
  showPanel();
  const int shown = panel.explanations();
  for (int i = 0; i < 5; ++i) source.derive();
  QTest::qWait(5);
  EXPECT_EQ(panel.explanations(), shown + 1);
}

// "Apply" makes the spring so much harder, in one step.
TEST_F(WhyPanelTest, ApplyDoesWhatTheLineSays)
{
  showPanel();
  panel.findChild<QSpinBox*>("whyPercent")->setValue(30);
  panel.findChild<QComboBox*>("whyDirection")->setCurrentIndex(1);
  EXPECT_DOUBLE_EQ(panel.factor(), 1.3);
  EXPECT_TRUE(text("whyChange0").startsWith("hardness of ")) << qPrintable(text("whyChange0"));
  auto* apply = panel.findChild<QPushButton*>("whyApply0");
  EXPECT_EQ(apply->accessibleName(), "Apply: " + text("whyChange0"));
  const double before = source.net.stiffness[0];
  QTest::mouseClick(apply, Qt::LeftButton);
  EXPECT_EQ(source.applied, 1);
  EXPECT_NEAR(source.net.stiffness[0] / before, 1.3, 0.013);
}

TEST_F(WhyPanelTest, LockedRegionsAreNotApplied)
{
  source.model.regions[0].locked = true;
  source.derive();
  showPanel();
  int locked = 0;
  for (int row = 0; row < 2; ++row) {
    auto* apply = panel.findChild<QPushButton*>(QStringLiteral("whyApply%1").arg(row));
    ASSERT_NE(apply, nullptr);
    locked += apply->isEnabled() ? 0 : 1;
  }
  EXPECT_EQ(locked, 1);
}

TEST_F(WhyPanelTest, CopiesTheTableWithTheExactNumbers)
{
  showPanel();
  panel.findChild<QAction*>("whyCopyCsv")->trigger();
  const TissueExplanation why = source.explanation();
  const ChangeList list{"stiffness", 0.8, changesFor(*source.field(), why, why.main(), 0.8)};
  EXPECT_EQ(QApplication::clipboard()->text(),
            toQt(explanationCsv(why, source.model, &list, Language::English)));
  panel.findChild<QAction*>("whyCopySentence")->trigger();
  EXPECT_EQ(QApplication::clipboard()->text(), sentence->text());
}

TEST_F(WhyPanelTest, ActivatedRulesAreShown)
{
  showPanel();
  QSignalSpy activated(&panel, &WhyPanel::ruleActivated);
  QTreeWidgetItem* rule = tree->topLevelItem(4)->child(0)->child(0);
  emit tree->itemActivated(rule, 0);
  ASSERT_EQ(activated.count(), 1);
  EXPECT_EQ(activated[0][0].toInt() + 1,
            rule->text(WhyTree::What).section(' ', 1).section(':', 0, 0).toInt());
  emit tree->itemActivated(tree->topLevelItem(0), 0);
  EXPECT_EQ(activated.count(), 1);
}

TEST_F(WhyPanelTest, SpeaksGermanAndSaysWhenRulesAreBroken)
{
  showPanel();
  speak(Language::German);
  source.speak(Language::German);
  QTest::qWait(5);
  EXPECT_TRUE(sentence->text().startsWith("Feder 0 hat ")) << qPrintable(sentence->text());
  EXPECT_TRUE(text("whyChange0").startsWith(QStringLiteral("Härte (")));
  source.broken = true;
  emit source.changed();
  QTest::qWait(5);
  EXPECT_FALSE(tree->isEnabled());
  EXPECT_FALSE(panel.findChild<QLabel*>("whyChange0")->isVisible());
}

TEST_F(WhyPanelTest, FitsANarrowDockAndEveryControlHasAName)
{
  showPanel();
  EXPECT_LE(panel.minimumSizeHint().width(), 340);
  for (const char* name : {"whySentence", "whyMenu", "whyTree", "whyPercent", "whyDirection", "whyApply0"})
    EXPECT_FALSE(panel.findChild<QWidget*>(name)->accessibleName().isEmpty()) << name;
}

} // namespace
} // namespace esm
