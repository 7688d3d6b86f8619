// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/region_list.h"
#include "app/panels/regions_panel.h"
#include "core/project/project_io.h"
#include "tests/app/sheet.h"

#include <QAbstractButton>
#include <QCheckBox>
#include <QComboBox>
#include <QDropEvent>
#include <QMimeData>
#include <QSignalSpy>
#include <QTest>

#include <gtest/gtest.h>

using namespace esm;

namespace {

/// A sheet of 70 mm with a hard ball in a corner, a document and the panel over it.
struct RegionsTest : testing::Test {
  Document document;
  std::unique_ptr<RegionsPanel> panel;
  QStringList problems;

  void SetUp() override
  {
    document.start(test::sheetProject(), QString());
    panel = std::make_unique<RegionsPanel>(&document);
    panel->resize(280, 600);
    panel->show();
    QObject::connect(&document, &Document::problem, panel.get(),
                     [this](const Error& error) { problems << QString::fromStdString(error.detail); });
  }
  void TearDown() override { panel.reset(); }

  void addBall(const char* name = "ball")
  {
    Region region;
    region.name = name;
    region.ellipsoid.centre = {0.02, 0.02, 0.0};
    region.ellipsoid.semiAxes.setConstant(0.02);
    region.inputs = document.project().tissue.inputs;
    region.inputs[0] = 0.9;
    document.addRegion(std::move(region));
  }
  const std::vector<Region>& regions() const { return document.project().tissue.regions; }
  QString names() const
  {
    QString all;
    for (const Region& region : regions()) all += QString::fromStdString(region.name);
    return all;
  }
  std::string json() const { return toJson(document.project()); }
  int steps() { return document.undoStack()->count(); }
  template <class W>
  W* find(const char* name)
  {
    W* widget = panel->findChild<W*>(QLatin1String(name));
    EXPECT_NE(widget, nullptr) << name;
    return widget;
  }
  void click(const char* name) { find<QAbstractButton>(name)->click(); }
};

} // namespace

// === Document

// Whatever a lock forbids leaves every byte as it was, and the user hears which region it was.
TEST_F(RegionsTest, ALockedRegionIsNeitherChangedNorRemovedNorMoved)
{
  addBall("a");
  addBall("b");
  document.lockRegion(0, true);
  document.setInputTarget(0);
  const std::string before = json();
  const int count = steps();

  Region moved = regions()[0];
  moved.ellipsoid.centre.x() += 0.01;
  document.setRegion(0, moved, "move");
  document.removeRegion(0);
  document.moveRegion(0, 1);
  document.detachTwin(0);
  document.setInput(0, 0.2, 0);
  document.setInputs(std::vector<fuzzy::InputValue>(document.inputs().size(), 0.5), "preset");
  EXPECT_EQ(json(), before);
  EXPECT_EQ(steps(), count);
  EXPECT_EQ(problems.size(), 6);
  for (const QString& problem : problems)
    EXPECT_TRUE(problem.contains("region 1 'a' is locked")) << qPrintable(problem);

  document.showRegion(0, false); // is no change of the tissue
  document.moveRegion(1, 0);     // others may pass it
  EXPECT_EQ(names(), "ba");
  document.lockRegion(1, false);
  document.setInputTarget(1);
  document.setInput(0, 0.2, 0);
  EXPECT_EQ(std::get<double>(regions()[1].inputs[0]), 0.2);
}

TEST_F(RegionsTest, AnIndexThatDoesNotExistIsRefusedWithAMessage)
{
  addBall();
  const std::string before = json();
  for (const int index : {-1, 1, 99}) {
    document.removeRegion(index);
    document.setRegion(index, regions()[0], "x");
    document.lockRegion(index, true);
    document.showRegion(index, false);
    document.moveRegion(0, index);
  }
  EXPECT_EQ(json(), before);
  EXPECT_EQ(problems.size(), 15);
}

TEST_F(RegionsTest, EveryEditOfRegionsIsUndoneByteByByte)
{
  const std::string before = json();
  addBall("a");
  addBall("b");
  Region region = regions()[0];
  region.profile = FalloffProfile::Smoother;
  region.insideOut = true;
  region.mirror = MirrorPlane{{0.035, 0, 0}, {1, 0, 0}};
  document.setRegion(0, region, "change");
  region.insideOut = false;
  document.setRegion(0, region, "outside in");
  document.detachTwin(0);
  EXPECT_EQ(regions().size(), 3u);
  document.moveRegion(2, 0);
  document.showRegion(1, false);
  document.lockRegion(1, true);
  document.removeRegion(0);
  const std::string after = json();
  QUndoStack* undo = document.undoStack();
  EXPECT_EQ(undo->count(), 9);
  while (undo->canUndo()) undo->undo();
  EXPECT_EQ(json(), before);
  while (undo->canRedo()) undo->redo();
  EXPECT_EQ(json(), after);
}

// One drag is one step; one that Esc has taken back is none, and a file's own numbers come back with it.
TEST_F(RegionsTest, ADragThatEndsWhereItBeganLeavesNoStep)
{
  addBall();
  Project project = document.project();
  project.net.stiffness *= 1.25; // as an older program may have written them
  document.start(project, QString());
  document.setInputTarget(0);
  const std::string before = json();
  const GizmoShape start{regions()[0].ellipsoid, regions()[0].falloff};
  GizmoShape dragged = start;

  panel->beginDrag();
  for (int i = 1; i <= 4; ++i) {
    dragged.ellipsoid.centre.x() = 0.02 + 0.002 * i;
    panel->drag(dragged);
    EXPECT_EQ(steps(), 1);
    EXPECT_EQ(regions()[0].ellipsoid.centre, dragged.ellipsoid.centre);
  }
  panel->drag(start);
  EXPECT_EQ(steps(), 0);
  EXPECT_EQ(json(), before);
  EXPECT_FALSE(document.isModified());

  panel->drag(dragged);
  EXPECT_EQ(document.undoStack()->undoText(), "move region");
  panel->beginDrag();
  dragged.falloff = 0.7;
  panel->drag(dragged);
  EXPECT_EQ(document.undoStack()->undoText(), "change falloff");
  EXPECT_EQ(steps(), 2) << "another drag, another step";
}

// Only springs whose midpoint at rest lies in the region are written anew; counted by the definition.
TEST_F(RegionsTest, ASoftenedRegionDerivesItsOwnSpringsOnly)
{
  addBall();
  const SpringNet before = document.project().net;
  document.setInput(0, 0.3, 0); // the region is the target
  const SpringNet& after = document.project().net;
  int inside = 0;
  for (Index s = 0; s < after.springCount(); ++s) {
    const Eigen::Vector3d middle =
      0.5 * (after.restPosition.col(after.ends(0, s)) + after.restPosition.col(after.ends(1, s)));
    const bool touched = (middle - Eigen::Vector3d(0.02, 0.02, 0.0)).norm() < 0.02;
    EXPECT_EQ(after.stiffness(s) != before.stiffness(s), touched) << s;
    inside += touched ? 1 : 0;
  }
  EXPECT_EQ(document.lastApply().springsChanged, inside);
}

// === Panel

TEST_F(RegionsTest, FromSelectionLaysARegionAroundTheNodes)
{
  EXPECT_FALSE(find<QAbstractButton>("regionFromSelection")->isEnabled());
  const std::vector<Index> nodes{9, 10, 11, 17, 18, 19, 25, 26, 27};
  panel->setSelection(nodes);
  click("regionFromSelection");
  ASSERT_EQ(regions().size(), 1u);
  const RegionShape shape(regions()[0]);
  for (const Index node : nodes) EXPECT_EQ(shape.weight(document.project().net.restPosition.col(node)), 1.0);
  EXPECT_EQ(shape.weight(document.project().net.restPosition.col(63)), 0.0);
  EXPECT_EQ(steps(), 1);
}

TEST_F(RegionsTest, FieldsChangeProfileInsideOutAndMirror)
{
  addBall();
  auto* profile = find<QComboBox>("regionProfile");
  profile->setCurrentIndex(2);
  emit profile->activated(2);
  EXPECT_EQ(regions()[0].profile, FalloffProfile::Smoother);
  click("regionInsideOut");
  EXPECT_TRUE(regions()[0].insideOut);
  click("regionInsideOut");

  auto* mirror = find<QComboBox>("regionMirror");
  EXPECT_FALSE(find<QAbstractButton>("regionDetachTwin")->isEnabled());
  mirror->setCurrentIndex(1);
  emit mirror->activated(1);
  ASSERT_TRUE(regions()[0].mirror);
  EXPECT_EQ(regions()[0].mirror->normal, Eigen::Vector3d::UnitX());
  EXPECT_NEAR(regions()[0].mirror->point.x(), 0.035, 1e-12) << "the middle of the sheet";
  auto* at = find<GestureSpinBox>("regionMirrorAt");
  EXPECT_NEAR(at->value(), 35.0, 1e-9);
  at->setValue(40.0);
  EXPECT_NEAR(regions()[0].mirror->point.x(), 0.04, 1e-12);
  click("regionDetachTwin");
  ASSERT_EQ(regions().size(), 2u);
  EXPECT_NEAR(regions()[1].ellipsoid.centre.x(), 0.06, 1e-12);
  EXPECT_FALSE(find<QAbstractButton>("regionDetachTwin")->isEnabled());
}

// A plane that a file brings and that is none of x, y, z is shown and not lost.
TEST_F(RegionsTest, AnObliqueMirrorIsShownAsItsOwn)
{
  addBall();
  Region region = regions()[0];
  region.mirror = MirrorPlane{{0, 0, 0}, {1, 1, 0}};
  document.setRegion(0, region, "mirror");
  auto* mirror = find<QComboBox>("regionMirror");
  EXPECT_EQ(mirror->count(), 5);
  EXPECT_EQ(mirror->currentText(), "own plane");
  EXPECT_FALSE(find<GestureSpinBox>("regionMirrorAt")->isEnabled());
  emit mirror->activated(4);
  EXPECT_EQ(regions()[0].mirror, region.mirror);
}

TEST_F(RegionsTest, ALockedRegionCanBeReadButNotChanged)
{
  addBall();
  click("regionLocked");
  EXPECT_TRUE(regions()[0].locked);
  EXPECT_FALSE(find<GestureSpinBox>("regionCentreX")->isEnabled());
  EXPECT_FALSE(find<QAbstractButton>("regionRemove")->isEnabled());
  auto* list = find<RegionList>("regionsList");
  list->item(1)->setCheckState(Qt::Unchecked);
  EXPECT_TRUE(regions()[0].enabled);
  EXPECT_EQ(list->item(1)->checkState(), Qt::Checked) << "the row goes back";
  EXPECT_EQ(problems.size(), 1);
  click("regionVisible");
  EXPECT_FALSE(regions()[0].visible);
  click("regionLocked");
  EXPECT_TRUE(find<GestureSpinBox>("regionCentreX")->isEnabled());
}

TEST_F(RegionsTest, EyeAndLockOfARowAreClicked)
{
  addBall();
  auto* list = find<RegionList>("regionsList");
  const QRect row = list->visualItemRect(list->item(1));
  const QPoint lock(row.right() - 8, row.center().y()), eye(row.right() - 30, row.center().y());
  QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, eye);
  EXPECT_FALSE(regions()[0].visible);
  QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, lock);
  EXPECT_TRUE(regions()[0].locked);
  QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, eye);
  QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, lock);
  EXPECT_TRUE(regions()[0].visible && !regions()[0].locked);
}

// A dropped row moves its region in the document, and with undo back; the base tissue stays the first.
TEST_F(RegionsTest, RowsAreReorderedByDragAndDrop)
{
  for (const char* name : {"a", "b", "c"}) addBall(name);
  auto* list = find<RegionList>("regionsList");
  const auto drop = [&](int region, int onRow, bool lowerHalf) {
    document.setInputTarget(region);
    const QRect row = list->visualItemRect(list->item(onRow));
    const QPointF at(20.0, lowerHalf ? row.bottom() - 1 : row.top() + 1);
    QMimeData nothing;
    QDropEvent event(at, Qt::MoveAction, &nothing, Qt::LeftButton, Qt::NoModifier);
    list->dropEvent(&event);
  };
  drop(0, 3, true); // a below c
  EXPECT_EQ(names(), "bca");
  EXPECT_EQ(document.inputTarget(), 2);
  drop(2, 0, false); // above the base tissue: as far up as a region goes
  EXPECT_EQ(names(), "abc");
  drop(1, 2, true); // where it is
  EXPECT_EQ(steps(), 5);
  document.undoStack()->undo();
  EXPECT_EQ(names(), "bca");
  EXPECT_EQ(list->count(), 4);
}
