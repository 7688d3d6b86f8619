// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/append_net.h"
#include "app/document/document.h"
#include "core/base/file_io.h"
#include "core/net/net_builder.h"
#include "core/project/journal_reader.h"
#include "core/project/project_io.h"
#include "fuzzyeditor/fuzzy_evaluation.h"
#include "tests/app/sheet.h"

#include <QSignalSpy>
#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <random>

using namespace esm;

namespace {

Region ball(const Project& project, const char* name, double radius)
{
  Region region;
  region.name = name;
  region.ellipsoid.centre = Eigen::Vector3d(0.02, 0.02, 0.0);
  region.ellipsoid.semiAxes.setConstant(radius);
  region.inputs = project.tissue.inputs;
  region.inputs[0] = 0.9;
  return region;
}

struct DocumentTest : testing::Test {
  Document document;
  QTemporaryDir folder;

  void SetUp() override { document.start(test::sheetProject(), QString()); }
  std::string json() const { return toJson(document.project()); }
  double meanStiffness() const { return document.project().net.stiffness.mean(); }

  /// One of every kind of edit.
  void editEverything()
  {
    document.setInput(0, 0.8, 0);
    document.setInput(1, fuzzy::Word{document.ruleBase().inputs[1].terms[0].id, {}}, 0);
    fuzzy::RuleBase rules = document.ruleBase();
    rules.rules[0].weight = 0.5;
    document.setRuleBase(rules, "weight");
    document.addRegion(ball(document.project(), "A", 0.02));
    document.setInput(0, 0.1, 0); // of the region: it is the target now
    document.addRegion(ball(document.project(), "B", 0.03));
    document.moveRegion(1, 0);
    Region moved = document.project().tissue.regions[0];
    moved.ellipsoid.centre.x() += 0.01;
    document.setRegion(0, moved, "move");
    document.removeRegion(1);
    document.setTissueSettings({0.004, 900.0, SpringLaw::Linear, 0.0});
    document.setGravity({0, 0, -9.81});
    document.setFixed({0, 3}, true);
    document.rename("other");
    document.setSolver("rk4");
    IncomingModel model{"second", {}, buildNet(test::sheetMesh(4)).value(), {}};
    ASSERT_TRUE(document.importModel(model, false));
    ASSERT_TRUE(document.importModel(model, true));
    document.setParametersFromTissue(false);
    document.setInput(2, 0.9, 0);
  }
};

} // namespace

// The promise of undo: nothing of an edit stays behind, not a bit.
TEST_F(DocumentTest, UndoToTheStartIsByteEqual)
{
  const std::string before = json();
  editEverything();
  const std::string after = json();
  EXPECT_NE(before, after);
  QUndoStack* undo = document.undoStack();
  EXPECT_EQ(undo->count(), 18);
  while (undo->canUndo()) undo->undo();
  EXPECT_EQ(json(), before);
  EXPECT_FALSE(document.isModified());
  while (undo->canRedo()) undo->redo();
  EXPECT_EQ(json(), after);
}

// A file may hold parameters that this program would compute otherwise (an older version): they come back
// too.
TEST_F(DocumentTest, UndoGivesBackForeignParameters)
{
  Project project = test::sheetProject();
  project.net.stiffness *= 1.25;
  document.start(project, QString());
  const std::string before = json();
  document.setInput(0, 0.8, 1);
  document.setInput(0, 0.9, 1);
  document.setInput(1, 0.3, 0);
  EXPECT_NE(json(), before);
  document.undoStack()->undo();
  document.undoStack()->undo();
  EXPECT_EQ(json(), before);
}

// One drag of a slider sends many values; it is one step. The next drag is another one.
TEST_F(DocumentTest, OneGestureIsOneStep)
{
  for (const int gesture : {1, 2})
    for (const double value : {0.3, 0.4, 0.5 + 0.1 * gesture}) document.setInput(0, value, gesture);
  ASSERT_EQ(document.undoStack()->count(), 2);
  document.undoStack()->undo();
  EXPECT_EQ(std::get<double>(document.inputs()[0]), 0.6);
  document.undoStack()->redo();
  EXPECT_EQ(std::get<double>(document.inputs()[0]), 0.7);

  document.addRegion(ball(document.project(), "A", 0.02));
  Region region = document.project().tissue.regions[0];
  for (int i = 1; i <= 3; ++i) {
    region.falloff = 0.1 * i;
    document.setRegion(0, region, "falloff", 7);
  }
  EXPECT_EQ(document.undoStack()->count(), 4);
  document.undoStack()->undo();
  EXPECT_EQ(document.project().tissue.regions[0].falloff, Region{}.falloff);
}

// A preset or a jump to a gap sets all sliders of the target, base or region, and one undo sets them back.
TEST_F(DocumentTest, AllInputsAtOnceAreOneStepOfTheirTarget)
{
  std::vector<fuzzy::InputValue> values = document.inputs();
  for (fuzzy::InputValue& value : values) value = 0.25;
  values[1] = fuzzy::Word{document.ruleBase().inputs[1].terms[0].id, {}};
  const std::string before = json();
  const double stiffness = meanStiffness();
  document.setInputs(values, "preset");
  EXPECT_EQ(document.undoStack()->undoText(), "preset");
  EXPECT_EQ(document.project().tissue.inputs, values);
  EXPECT_LT(meanStiffness(), stiffness);
  document.setInputs(values, "the same again");
  EXPECT_EQ(document.undoStack()->count(), 1);
  values.pop_back();
  document.setInputs(values, "not of this rule base");
  EXPECT_EQ(document.undoStack()->count(), 1);
  document.undoStack()->undo();
  EXPECT_EQ(json(), before);

  document.addRegion(ball(document.project(), "A", 0.02));
  values.push_back(0.25);
  document.setInputs(values, "of the region");
  EXPECT_EQ(document.project().tissue.regions[0].inputs, values);
  EXPECT_NE(document.project().tissue.inputs, values);
}

TEST_F(DocumentTest, TypedValuesDoNotMerge)
{
  document.setInput(0, 0.3, 0);
  document.setInput(0, 0.4, 0);
  EXPECT_EQ(document.undoStack()->count(), 2);
}

// Harder tissue makes stiffer springs: the one parameter path of the house, end to end.
TEST_F(DocumentTest, InputReachesTheSprings)
{
  document.setInput(0, 0.2, 0);
  const double soft = meanStiffness();
  QSignalSpy changed(&document, &Document::parametersChanged);
  document.setInput(0, 0.9, 0);
  EXPECT_GT(meanStiffness(), 1.5 * soft);
  EXPECT_EQ(changed.count(), 1);
  EXPECT_EQ(document.net()->stiffness.mean(), meanStiffness());
}

// A region speaks for its inside only: springs whose midpoint is outside keep their bits.
TEST_F(DocumentTest, RegionChangesOnlySpringsInside)
{
  document.setInput(0, 0.2, 0);
  const SpringNet before = document.project().net;
  const Region region = ball(document.project(), "A", 0.02);
  document.addRegion(region);
  const SpringNet& after = document.project().net;
  int inside = 0;
  for (Index s = 0; s < after.springCount(); ++s) {
    const Eigen::Vector3d middle =
      0.5 * (after.restPosition.col(after.ends(0, s)) + after.restPosition.col(after.ends(1, s)));
    if (region.ellipsoid.radius(middle) < 0.999) {
      ++inside;
      EXPECT_GT(after.stiffness[s], before.stiffness[s]) << "spring " << s;
    } else {
      EXPECT_EQ(after.stiffness[s], before.stiffness[s]) << "spring " << s;
    }
  }
  EXPECT_GT(inside, 5);
  EXPECT_LT(inside, after.springCount());
}

// A slider writes to the net that is there: no array of it moves, what others hold stays as it was, and the patch
// says exactly what has changed, on undo and redo as well, from the first edit on.
TEST_F(DocumentTest, AnEditOfTheTissueIsAPatch)
{
  RecoveredWork work;
  work.project = test::sheetProject();
  work.netDerived = true; // its numbers are its tissue's
  document.startRecovered(work, QString());
  SpringNet follower = *document.net();
  const auto held = document.net();
  const double* const place = document.project().net.stiffness.data();
  const double* const rest = document.project().net.restPosition.data();
  int patches = 0;
  QObject::connect(&document, &Document::parametersChanged, [&] {
    const auto patch = document.lastPatch();
    ASSERT_TRUE(patch);
    ASSERT_TRUE(checkPatch(*patch, follower));
    EXPECT_LE(std::ssize(patch->springs), document.lastApply().springsChanged);
    patch->applyTo(follower);
    EXPECT_TRUE((follower.stiffness == document.project().net.stiffness).all());
    EXPECT_TRUE((follower.mass == document.project().net.mass).all());
    EXPECT_TRUE((follower.anchors.stiffness == document.project().net.anchors.stiffness).all());
    ++patches;
  });
  const double before = held->stiffness.sum();
  document.addRegion(ball(document.project(), "A", 0.02));
  document.setInput(0, 0.3, 4); // of the region
  document.setInput(0, 0.4, 4);
  EXPECT_LT(std::ssize(document.lastPatch()->springs), document.project().net.springCount() / 2);
  EXPECT_GT(std::ssize(document.lastPatch()->springs), 5);
  while (document.undoStack()->canUndo()) document.undoStack()->undo();
  while (document.undoStack()->canRedo()) document.undoStack()->redo();
  EXPECT_EQ(patches, 7);
  EXPECT_EQ(document.project().net.stiffness.data(), place);
  EXPECT_EQ(document.project().net.restPosition.data(), rest);
  EXPECT_EQ(held->stiffness.sum(), before);
}

// Where numbers come from elsewhere, as on undo to those of a file, nobody can say which: then the whole net counts.
TEST_F(DocumentTest, ForeignNumbersAreNoPatch)
{
  Project project = test::sheetProject();
  project.net.stiffness *= 1.25;
  document.start(project, QString());
  document.setInput(0, 0.8, 1);
  EXPECT_TRUE(document.lastPatch());
  document.undoStack()->undo();
  EXPECT_FALSE(document.lastPatch());
  EXPECT_TRUE((document.project().net.stiffness == project.net.stiffness).all());
}

TEST_F(DocumentTest, RefusedTissueChangesNothing)
{
  const std::string before = json();
  QSignalSpy problems(&document, &Document::problem);
  Region flat = ball(document.project(), "flat", 0.02);
  flat.ellipsoid.semiAxes.z() = 0.0;
  document.addRegion(flat);
  EXPECT_EQ(problems.count(), 1);
  EXPECT_EQ(json(), before);
  EXPECT_EQ(document.undoStack()->count(), 0);
}

TEST_F(DocumentTest, FailedOpenKeepsTheDocument)
{
  document.setInput(0, 0.7, 0);
  const std::string before = json();
  const QString bad = folder.filePath("bad.esm");
  ASSERT_TRUE(writeFileAtomically(bad.toStdString(), R"({"format": "esm-project", "net": )"));
  const Status opened = document.open(bad);
  ASSERT_FALSE(opened);
  EXPECT_NE(opened.error().detail.find("bad.esm"), std::string::npos) << opened.error().detail;
  EXPECT_EQ(json(), before);
  EXPECT_EQ(document.undoStack()->count(), 1);
  EXPECT_TRUE(document.isModified());
  EXPECT_FALSE(document.open(folder.filePath("absent.esm")));
  EXPECT_EQ(json(), before);
}

TEST_F(DocumentTest, SaveMakesCleanAndOpensEqual)
{
  document.setInput(0, 0.7, 0);
  const QString path = folder.filePath("a.esm");
  ASSERT_TRUE(document.saveAs(path));
  EXPECT_FALSE(document.isModified());
  const std::string saved = json();
  document.setInput(0, 0.8, 0);
  EXPECT_TRUE(document.isModified());
  ASSERT_TRUE(document.open(path));
  EXPECT_EQ(json(), saved);
  EXPECT_EQ(document.path(), path);
}

// A rule base with another set of inputs: values follow their variable by id, new ones start at the default.
TEST_F(DocumentTest, InputsFollowTheirVariables)
{
  document.setInput(1, 0.33, 0);
  fuzzy::RuleBase rules = document.ruleBase();
  fuzzy::Variable extra = rules.inputs[0];
  extra.id = "extra";
  extra.name = {"extra", "extra"};
  extra.defaultValue = 0.25;
  rules.inputs.insert(rules.inputs.begin(), extra);
  document.setRuleBase(rules, "add variable");
  ASSERT_EQ(document.inputs().size(), rules.inputs.size());
  EXPECT_EQ(std::get<double>(document.inputs()[0]), 0.25);
  EXPECT_EQ(std::get<double>(document.inputs()[2]), 0.33);
}

// Another model has other nodes: who remembers one must hear of it, on undo as well.
TEST_F(DocumentTest, AnotherModelIsAnnounced)
{
  QSignalSpy replaced(&document, &Document::modelReplaced);
  document.setFixed({1}, true);
  EXPECT_EQ(replaced.count(), 0);
  ASSERT_TRUE(document.importModel({"second", {}, buildNet(test::sheetMesh(4)).value(), {}}, true));
  document.undoStack()->undo();
  EXPECT_EQ(replaced.count(), 2);
}

// The document follows edits at the price of what they touch; the full derivation is the oracle.
TEST_F(DocumentTest, ParametersFollowEditsAndUndoBitByBit)
{
  document.addRegion(ball(document.project(), "A", 0.015));
  document.addRegion(ball(document.project(), "B", 0.01));
  std::mt19937 random(7);
  const auto upTo = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  for (int step = 0; step < 60; ++step) {
    const int region = upTo(2);
    switch (upTo(6)) {
    case 0:
      document.undoStack()->undo();
      break;
    case 1:
      document.undoStack()->redo();
      break;
    case 2:
      document.setTissueSettings({0.001 * (1 + upTo(4)), 1000.0, SpringLaw::Linear, 0.0});
      break;
    case 3: {
      if (document.project().tissue.regions.size() < 2) break;
      Region moved = document.project().tissue.regions[static_cast<std::size_t>(region)];
      moved.ellipsoid.centre.x() = 0.005 * upTo(8);
      document.setRegion(region, moved, "move");
      break;
    }
    case 4:
      document.setInputTarget(upTo(3) - 1);
      [[fallthrough]];
    default:
      document.setInput(upTo(7), 0.1 * upTo(11), 0);
    }
    SpringNet oracle = document.project().net;
    ASSERT_TRUE(applyTissue(document.project().tissue, oracle));
    ASSERT_TRUE((oracle.stiffness == document.project().net.stiffness).all()) << "step " << step;
    ASSERT_TRUE((oracle.viscosity == document.project().net.viscosity).all()) << "step " << step;
    ASSERT_TRUE((oracle.mass == document.project().net.mass).all()) << "step " << step;
    ASSERT_EQ(document.tissueField()->model().inputs, document.project().tissue.inputs);
  }
}

TEST_F(DocumentTest, AnEditDerivesOnlyWhatItTouches)
{
  document.addRegion(ball(document.project(), "A", 0.008));
  document.setInputTarget(0);
  document.setInput(0, 0.4, 0); // the first edit of a net derives everything
  document.setInput(0, 0.2, 0);
  EXPECT_GT(document.lastApply().springsChanged, 0);
  EXPECT_LT(document.lastApply().springsChanged, document.project().net.springCount() / 2);
}

// Whoever hears of the new project and asks why must not get the former rules' answer.
TEST_F(DocumentTest, InferenceBelongsToTheNewRulesOnceTheProjectIsAnnounced)
{
  FuzzyEvaluation evaluation(&document);
  ASSERT_EQ(evaluation.inference().firings.size(), document.ruleBase().rules.size());
  Project other = test::sheetProject();
  other.tissue.rules.rules.resize(3);
  std::size_t firings = 0;
  QObject::connect(&document, &Document::projectReset,
                   [&] { firings = evaluation.inference().firings.size(); });
  document.start(std::move(other), QString());
  EXPECT_EQ(firings, 3U);
}

TEST_F(DocumentTest, TargetFollowsTheRegions)
{
  QSignalSpy moved(&document, &Document::inputTargetChanged);
  document.addRegion(ball(document.project(), "A", 0.02));
  EXPECT_EQ(document.inputTarget(), 0);
  EXPECT_EQ(document.inputTargetName(), "A");
  document.removeRegion(0);
  EXPECT_EQ(document.inputTarget(), -1);
  document.undoStack()->undo();
  EXPECT_EQ(document.inputTarget(), 0);
  EXPECT_EQ(moved.count(), 3);
}

// The first net's ids and places stay, the second's come above them, and the whole passes the net check.
TEST(AppendNet, KeepsTheFirstAndRenumbersTheSecond)
{
  SpringNet net = test::sheetProject(4).net;
  net.springId.back() = SpringId{500};
  const SpringNet first = net, second = buildNet(test::sheetMesh(3)).value();
  appendNet(net, second, 0.002);
  EXPECT_TRUE(checkNet(net));
  EXPECT_EQ(net.nodeCount(), first.nodeCount() + second.nodeCount());
  EXPECT_EQ(net.springCount(), first.springCount() + second.springCount());
  EXPECT_EQ(net.triangleCount(), first.triangleCount() + second.triangleCount());
  EXPECT_EQ(net.restPosition.leftCols(first.nodeCount()), first.restPosition);
  EXPECT_EQ(net.ends(0, first.springCount()), second.ends(0, 0) + first.nodeCount());
  EXPECT_EQ(net.springId[static_cast<std::size_t>(first.springCount())], SpringId{501});
  EXPECT_EQ(net.nodeId[static_cast<std::size_t>(first.nodeCount())], NodeId{16});
}
