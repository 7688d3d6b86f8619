// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/error_text.h"
#include "app/import_dialog.h"
#include "app/main_window.h"
#include "app/panels/regions_panel.h"
#include "app/scripted_run.h"
#include "app/state_dump.h"
#include "app/window_actions.h"
#include "core/base/file_io.h"
#include "core/net/net_builder.h"
#include "core/project/project_io.h"
#include "tests/app/sheet.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeWidget>

#include <gtest/gtest.h>

using namespace esm;

namespace {

/// The window as a user without OpenGL gets it: the test platform has none.
struct WindowTest : testing::Test {
  LanguageSwitch language;
  std::unique_ptr<MainWindow> window;
  QTemporaryDir folder;

  void SetUp() override
  {
    applyTheme(Theme::Light);
    language.set(Language::English);
    window = std::make_unique<MainWindow>(&language);
    window->document()->start(test::sheetProject(), QString());
    window->show();
  }
  void TearDown() override
  {
    window.reset();
    language.set(Language::English);
  }
  template <class W>
  W* find(const char* name)
  {
    W* widget = window->findChild<W*>(QLatin1String(name));
    EXPECT_NE(widget, nullptr) << name;
    return widget;
  }
  void click(const char* name) { QTest::mouseClick(find<QAbstractButton>(name), Qt::LeftButton); }
};

bool isInteractive(const QWidget* widget)
{
  if (widget->objectName().startsWith("qt_") || widget->inherits("QScrollBar"))
    return false; // Qt's own parts
  for (const QWidget* up = widget->parentWidget(); up != nullptr; up = up->parentWidget())
    if (qobject_cast<const QAbstractSpinBox*>(up) || qobject_cast<const QComboBox*>(up) ||
        qobject_cast<const QAbstractItemView*>(up) || up->inherits("QTabBar") ||
        up->inherits("QDockWidgetTitleButton"))
      return false; // the part of a widget that has a name
  if (widget->inherits("QDockWidgetTitleButton") || widget->inherits("QToolBarExtension")) return false;
  return qobject_cast<const QAbstractButton*>(widget) || qobject_cast<const QAbstractSlider*>(widget) ||
         qobject_cast<const QAbstractSpinBox*>(widget) || qobject_cast<const QComboBox*>(widget) ||
         qobject_cast<const QLineEdit*>(widget) || qobject_cast<const QAbstractItemView*>(widget) ||
         qobject_cast<const QPlainTextEdit*>(widget);
}

} // namespace

TEST_F(WindowTest, StartsWithoutOpenGlAndSaysSo)
{
  QTest::qWait(50);
  EXPECT_FALSE(window->sceneView()->hasOpenGl());
  for (const char* dock :
       {"dockRules", "dockInputs", "dockMf", "dockWhy", "dockRegions", "dockTissue", "dockHaptics"})
    EXPECT_TRUE(find<QDockWidget>(dock)->isVisible()) << dock;
  EXPECT_EQ(find<QLabel>("lblNodes")->text(), "64 nodes");
  EXPECT_TRUE(window->windowTitle().contains("sheet"));
}

// Tests and screen readers find every control by its name (rule R5 of the user interface).
TEST_F(WindowTest, EveryControlHasAnObjectNameAndAnAccessibleName)
{
  int controls = 0;
  for (const Language spoken : {Language::English, Language::German}) {
    window->setLanguage(spoken);
    for (const QWidget* widget : window->findChildren<QWidget*>()) {
      if (!isInteractive(widget)) continue;
      ++controls;
      EXPECT_FALSE(widget->objectName().isEmpty())
        << widget->metaObject()->className() << " in " << qPrintable(widget->parentWidget()->objectName());
      EXPECT_FALSE(widget->accessibleName().isEmpty())
        << widget->metaObject()->className() << " " << qPrintable(widget->objectName());
    }
  }
  EXPECT_GT(controls, 80);
}

TEST_F(WindowTest, SwitchesLanguageWhileItRuns)
{
  EXPECT_EQ(find<QDockWidget>("dockRules")->windowTitle(), "Fuzzy Rules");
  window->setLanguage(Language::German);
  EXPECT_EQ(find<QDockWidget>("dockRules")->windowTitle(), "Fuzzy-Regeln");
  EXPECT_EQ(find<QLabel>("lblNodes")->text(), "64 Knoten");
  EXPECT_EQ(window->document()->inputTargetName(), "Grundgewebe");
  EXPECT_EQ(window->document()->ruleLanguage(), Language::German);
  EXPECT_EQ(errorLead(ErrorCode::FileUnreadable), "Die Datei kann nicht gelesen werden.");
  window->setLanguage(Language::English);
  EXPECT_EQ(find<QDockWidget>("dockRules")->windowTitle(), "Fuzzy Rules");
}

TEST_F(WindowTest, RegionPanelEditsByCommands)
{
  click("regionAdd");
  ASSERT_EQ(window->document()->project().tissue.regions.size(), 1u);
  EXPECT_EQ(window->document()->inputTarget(), 0);
  auto* falloff = find<QAbstractSpinBox>("regionFalloff");
  QTest::keyPress(falloff, Qt::Key_Up);
  falloff->stepUp(); // the key kept down
  EXPECT_EQ(window->document()->undoStack()->count(), 2);
  EXPECT_NEAR(window->document()->project().tissue.regions[0].falloff, 0.4, 1e-12);
  click("regionDuplicate");
  click("regionUp");
  EXPECT_EQ(window->document()->inputTarget(), 0);
  auto* list = find<QListWidget>("regionsList");
  EXPECT_EQ(list->count(), 3);
  list->item(1)->setCheckState(Qt::Unchecked);
  EXPECT_FALSE(window->document()->project().tissue.regions[0].enabled);
  list->setCurrentRow(0);
  EXPECT_EQ(window->document()->inputTarget(), -1);
  EXPECT_FALSE(find<QAbstractButton>("regionRemove")->isEnabled());
}

// Turns of a box [degrees] survive the way through the quaternion; 1e-9 is rounding.
TEST(RegionTurns, RoundTrip)
{
  for (const Eigen::Vector3d& turns :
       {Eigen::Vector3d(10, 20, 30), Eigen::Vector3d(-170, 80, 175), Eigen::Vector3d(0, 0, -90)})
    EXPECT_TRUE(turnsOf(rotationOf(turns)).isApprox(turns, 1e-9)) << turns.transpose();
}

// A pull by hand: the force comes back as number without any device being armed; stop lets go.
TEST_F(WindowTest, PullShowsForceAndStopEndsIt)
{
  SimulationController* run = window->controller();
  run->setPlaying(true);
  run->startPull(27, window->document()->project().net.restPosition.col(27));
  run->movePull(window->document()->project().net.restPosition.col(27) + Eigen::Vector3d(0, 0, 0.01));
  EXPECT_TRUE(QTest::qWaitFor([&] { return run->snapshot().toolForce.norm() > 1e-4; }, 5000));
  EXPECT_EQ(run->snapshot().grabbedNode, 27);
  EXPECT_NE(run->hapticStatus().state, DeviceState::Active);
  window->actions()->stop->trigger();
  EXPECT_TRUE(QTest::qWaitFor([&] { return run->snapshot().grabbedNode == kNoIndex; }, 5000));
  EXPECT_FALSE(run->isPulling());
}

// Only after "Force on" the device feels the pull, and never more than the limit.
TEST_F(WindowTest, ArmedDeviceFeelsThePullUpToTheLimit)
{
  SimulationController* run = window->controller();
  const Eigen::Vector3d place = window->document()->project().net.restPosition.col(27);
  run->setForceLimit(0.3);
  run->setPlaying(true);
  run->startPull(27, place);
  run->movePull(place + Eigen::Vector3d(0, 0, 0.02));
  QTest::qWait(300);
  EXPECT_EQ(run->hapticStatus().force.norm(), 0.0);
  run->endPull(); // force begins with nothing in the hand only
  run->arm();
  EXPECT_TRUE(QTest::qWaitFor([&] { return run->hapticStatus().state != DeviceState::Idle; }, 15000));
  QTest::qWait(300);
  run->startPull(27, place);
  run->movePull(place + Eigen::Vector3d(0, 0, 0.02));
  EXPECT_TRUE(QTest::qWaitFor([&] { return run->hapticStatus().force.norm() > 0.01; }, 15000));
  for (int i = 0; i < 20; ++i) {
    QTest::qWait(20);
    EXPECT_LE(run->hapticStatus().force.norm(), 0.3 + 1e-12);
  }
  run->stop();
  EXPECT_TRUE(QTest::qWaitFor([&] { return run->hapticStatus().force.norm() == 0.0; }, 2000));
  EXPECT_EQ(run->hapticStatus().state, DeviceState::Fault);
}

TEST_F(WindowTest, ImportDialogReportsAndBuildsTheNet)
{
  const QString path = folder.filePath("two.obj");
  ASSERT_TRUE(writeFileAtomically(path.toStdString(),
                                  "v 0 0 0\nv 40 0 0\nv 0 40 0\nv 40 40 0\nv 9 9 9\nf 1 2 3\nf 2 4 3\n"));
  JobRunner jobs;
  ImportDialog dialog({path}, &jobs, true, defaultTissue());
  ASSERT_TRUE(QTest::qWaitFor([&] { return dialog.findChild<QAbstractButton*>("importOk")->isEnabled(); }));
  EXPECT_TRUE(dialog.findChild<QLabel*>("importSize")->text().contains("40 × 40 × 9 mm"));
  EXPECT_TRUE(dialog.findChild<QLabel*>("importPrediction")->text().contains("4 nodes, 5 springs"));
  EXPECT_FALSE(dialog.findChild<QAbstractButton*>("importAdd")->isEnabled());
  dialog.findChild<QComboBox*>("importUnit")->setCurrentText("cm");
  EXPECT_TRUE(dialog.findChild<QLabel*>("importSize")->text().contains("400 × 400 × 90 mm"));
  dialog.accept(); // the net of these choices is still being made: there is nothing to take
  EXPECT_NE(dialog.result(), QDialog::Accepted);
  ASSERT_TRUE(QTest::qWaitFor([&] { return dialog.findChild<QAbstractButton*>("importOk")->isEnabled(); }));
  dialog.accept();
  EXPECT_EQ(dialog.result(), QDialog::Accepted);
  const IncomingModel model = dialog.takeModel();
  EXPECT_EQ(model.net.nodeCount(), 4);
  EXPECT_EQ(model.source.unit, LengthUnit::Centimetre);
  ASSERT_TRUE(window->document()->importModel(model, true));
  EXPECT_EQ(window->document()->undoStack()->count(), 1);
}

// The lone vertex is a defect with a place; chosen in the list it is ringed in the preview.
TEST_F(WindowTest, ImportDialogListsDefectsAndRemembersChoices)
{
  const QString path = folder.filePath("two.remembered");
  ASSERT_TRUE(writeFileAtomically(path.toStdString(),
                                  "v 0 0 0\nv 40 0 0\nv 0 40 0\nv 40 40 0\nv 9 9 9\nf 1 2 3\nf 2 4 3\n"));
  JobRunner jobs;
  const auto ready = [](ImportDialog& dialog) {
    return QTest::qWaitFor([&] { return dialog.findChild<QAbstractButton*>("importOk")->isEnabled(); });
  };
  {
    ImportDialog dialog({path}, &jobs, true, defaultTissue());
    ASSERT_TRUE(ready(dialog));
    EXPECT_TRUE(dialog.findChild<QLabel*>("importRemembered")->text().isEmpty());
    auto* list = dialog.findChild<QTreeWidget*>("importDefects");
    ASSERT_EQ(list->topLevelItemCount(), 2); // the open border, the vertex that nothing uses
    list->setCurrentItem(list->topLevelItem(1)->child(0));
    ASSERT_EQ(dialog.view()->marks().cols(), 1);
    EXPECT_LT((dialog.view()->marks() - Eigen::Vector3d(0.009, 0.009, 0.009)).norm(), 1e-12);
    dialog.findChild<QCheckBox*>("importUseless")->setChecked(true);
    ASSERT_TRUE(ready(dialog));
    dialog.accept();
  }
  ImportDialog again({path}, &jobs, true, defaultTissue());
  EXPECT_TRUE(again.findChild<QCheckBox*>("importUseless")->isChecked());
  EXPECT_TRUE(again.findChild<QLabel*>("importRemembered")->text().contains("REMEMBERED"));
  again.findChild<QAbstractButton*>("importReset")->click();
  EXPECT_FALSE(again.findChild<QCheckBox*>("importUseless")->isChecked());
  ASSERT_TRUE(ready(again));
}

// Numbers of the material come as inputs of the tissue, together with the net, in one step of undo.
TEST_F(WindowTest, ImportDialogBringsTheMaterial)
{
  const QString path = folder.filePath("bar.material");
  ASSERT_TRUE(writeFileAtomically(
    path.toStdString(), "v 0 0 0\nv 9 0 0\nv 0 30 0\nv 0 0 9\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"));
  Document* document = window->document();
  const TissueModel before = document->project().tissue;
  JobRunner jobs;
  ImportDialog dialog({path}, &jobs, true, before);
  const auto ready = [&] {
    return QTest::qWaitFor([&] { return dialog.findChild<QAbstractButton*>("importOk")->isEnabled(); });
  };
  ASSERT_TRUE(ready());
  dialog.findChild<QComboBox*>("importBody")->setCurrentIndex(1);
  dialog.findChild<QDoubleSpinBox*>("importThickness")->setValue(1.5);
  dialog.findChild<QDoubleSpinBox*>("importModulus")->setValue(40.0);
  EXPECT_FALSE(dialog.findChild<QCheckBox*>("importFit")->isEnabled()); // the modulus brings it
  ASSERT_TRUE(ready());
  dialog.accept();
  const IncomingModel model = dialog.takeModel();
  EXPECT_EQ(model.source.material.youngsModulus, 40e3);
  ASSERT_TRUE(document->importModel(model, true));
  EXPECT_EQ(document->project().tissue.thickness, 0.0015);
  EXPECT_NEAR(document->tissueField()->base().youngsModulus / 40e3, 1.0, 0.01);
  EXPECT_NE(document->project().net.material.modulusScale, 1.0);
  document->undoStack()->undo();
  EXPECT_EQ(document->project().tissue.thickness, before.thickness);
  EXPECT_EQ(document->project().tissue.inputs, before.inputs);
}

// What is added comes beside the model with its own lines, struts and bands, in one step of undo; nothing of
// the model moves, its tissue and recipe stay, and the whole can be simulated and saved.
TEST_F(WindowTest, ImportDialogAddsToTheModel)
{
  const QString path = folder.filePath("bar.added");
  ASSERT_TRUE(writeFileAtomically(path.toStdString(),
                                  "v 0 0 0\nv 9 0 0\nv 0 30 0\nv 0 0 9\nv 0 0 40\nv 20 0 40\n"
                                  "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\nl 4 5 6\n"));
  Document* document = window->document();
  const Project before = document->project();
  const Index nodes = before.net.nodeCount(), springs = before.net.springCount();
  ASSERT_GT(nodes, 0);
  JobRunner jobs;
  ImportDialog dialog({path}, &jobs, false, before.tissue);
  dialog.findChild<QComboBox*>("importAnchors")->setCurrentIndex(1);
  ASSERT_TRUE(QTest::qWaitFor([&] { return dialog.findChild<QAbstractButton*>("importOk")->isEnabled(); }));
  EXPECT_TRUE(dialog.replaces());
  auto* add = dialog.findChild<QAbstractButton*>("importAdd");
  ASSERT_TRUE(add->isEnabled());
  add->click();
  EXPECT_FALSE(dialog.replaces());
  dialog.accept();
  ASSERT_TRUE(document->importModel(dialog.takeModel(), dialog.replaces()));
  const Project& after = document->project();
  EXPECT_EQ(after.net.nodeCount(), nodes + 6);
  EXPECT_EQ(after.net.springCount(), springs + 6 + 2);
  EXPECT_EQ(std::count(after.net.kind.begin() + springs, after.net.kind.end(), SpringKind::Line), 2);
  EXPECT_EQ((after.net.anchors.bandLength > 0.0).count(), 4); // from the surface, not from the lines
  EXPECT_EQ(after.net.restPosition.leftCols(nodes), before.net.restPosition);
  EXPECT_NEAR(after.net.restPosition(1, nodes + 2), 0.03, 1e-15);
  EXPECT_TRUE((after.net.stiffness.head(springs) == before.net.stiffness).all());
  EXPECT_TRUE(checkNet(after.net));
  EXPECT_EQ(after.name, before.name);
  EXPECT_EQ(after.source, before.source);
  EXPECT_EQ(after.tissue.inputs, before.tissue.inputs);
  const auto file = folder.filePath("both.esm");
  ASSERT_TRUE(document->saveAs(file));
  const auto read = loadProject(file.toStdString());
  ASSERT_TRUE(read) << read.error().detail;
  EXPECT_EQ(read->net.nodeCount(), nodes + 6);
  document->undoStack()->undo();
  EXPECT_EQ(document->project().net.nodeCount(), nodes);
}

// 600 triangles, one above the other, and one that pierces them all: more than are listed. The list says so,
// instead of passing what it shows for all there is.
TEST_F(WindowTest, ImportDialogSaysThatMoreTrianglesMayRunThroughOthers)
{
  std::string text = "v 1 1 -1\nv 2 1 -1\nv 1 1 601\nf 1 2 3\n";
  for (int i = 0; i < 600; ++i) {
    const std::string z = std::to_string(i) + ".5";
    text += "v 0 0 " + z + "\nv 9 0 " + z + "\nv 0 9 " + z + "\nf -3 -2 -1\n";
  }
  const QString path = folder.filePath("stack.pierced");
  ASSERT_TRUE(writeFileAtomically(path.toStdString(), text));
  JobRunner jobs;
  ImportDialog dialog({path}, &jobs, true, defaultTissue());
  ASSERT_TRUE(QTest::qWaitFor([&] { return dialog.findChild<QAbstractButton*>("importOk")->isEnabled(); }));
  auto* list = dialog.findChild<QTreeWidget*>("importDefects");
  const auto found = list->findItems("Triangles that run through others: at least ", Qt::MatchStartsWith);
  ASSERT_EQ(found.size(), 1);
  QTreeWidgetItem* head = found.front();
  const int last = head->childCount() - 1;
  EXPECT_EQ(head->child(last)->text(0), "The search ended early: there may be more");
  EXPECT_FALSE(head->toolTip(0).isEmpty());
  list->setCurrentItem(head->child(last)); // a remark has no place
  EXPECT_EQ(dialog.view()->marks().cols(), 0);
  language.set(Language::German);
  EXPECT_TRUE(
    QTest::qWaitFor([&] { return list->findItems("Triangles that run", Qt::MatchStartsWith).isEmpty(); }));
}

// A mesh file that changes on disk shows a bar; Update takes it in one step of undo, and the bar goes.
TEST_F(WindowTest, AChangedFileIsOfferedAndTakenInOneStep)
{
  const QString path = folder.filePath("wall.watched");
  const auto write = [&](const char* last) {
    ASSERT_TRUE(writeFileAtomically(path.toStdString(), std::string("v 0 0 0\nv 1 0 0\nv 0 1 0\n") + last +
                                                          "f 1 2 3\nf 2 4 3\n"));
  };
  write("v 1 1 0\n");
  Document* document = window->document();
  {
    JobRunner jobs;
    ImportDialog dialog({path}, &jobs, true, document->project().tissue);
    ASSERT_TRUE(QTest::qWaitFor([&] { return dialog.findChild<QAbstractButton*>("importOk")->isEnabled(); }));
    dialog.accept();
    ASSERT_TRUE(document->importModel(dialog.takeModel(), true));
  }
  document->setFixed({1}, true);
  const int steps = document->undoStack()->count();
  auto* bar = window->findChild<QFrame*>("changedFilesBar");
  QTest::qWait(700); // longer than a change takes to settle
  EXPECT_TRUE(bar->isHidden());
  write("v 1 1 0.5\n");
  ASSERT_TRUE(QTest::qWaitFor([&] { return !bar->isHidden(); }));
  EXPECT_TRUE(window->findChild<QLabel*>("changedFilesText")->text().contains("wall.watched"));
  window->findChild<QAbstractButton*>("changedFilesIgnore")->click();
  EXPECT_TRUE(bar->isHidden());
  EXPECT_EQ(document->undoStack()->count(), steps);
  write("v 1 1 0.25\n"); // once more: it asks again
  ASSERT_TRUE(QTest::qWaitFor([&] { return !bar->isHidden(); }));
  window->findChild<QAbstractButton*>("changedFilesUpdate")->click();
  ASSERT_TRUE(QTest::qWaitFor([&] { return document->undoStack()->count() == steps + 1; }));
  EXPECT_EQ(document->project().net.restPosition(2, 3), 0.25);
  EXPECT_EQ(document->project().net.fixed[1], 1); // what was carried over
  ASSERT_TRUE(QTest::qWaitFor([&] { return bar->isHidden(); }));
  document->undoStack()->undo();
  EXPECT_EQ(document->project().net.restPosition(2, 3), 0.0);
}

TEST_F(WindowTest, ImportDialogSaysWhyItCannot)
{
  const QString path = folder.filePath("empty.stl");
  ASSERT_TRUE(writeFileAtomically(path.toStdString(), ""));
  JobRunner jobs;
  ImportDialog dialog({path}, &jobs, true, defaultTissue());
  auto* message = dialog.findChild<QLabel*>("importMessage");
  ASSERT_TRUE(QTest::qWaitFor([&] { return !message->text().isEmpty(); }));
  EXPECT_TRUE(message->text().contains("empty.stl"));
  EXPECT_FALSE(dialog.findChild<QAbstractButton*>("importOk")->isEnabled());
}

// A cancelled task is told to stop, and nobody hears of its result.
TEST(Jobs, CancelStopsTheTaskAndDropsItsResult)
{
  JobRunner jobs;
  std::atomic<bool> ran = false;
  bool heard = false;
  jobs.start(
    [&](WorkControl* control) -> Result<int> {
      while (!stopWanted(control)) QThread::msleep(1);
      ran = true;
      return 1;
    },
    [&](Result<int>) { heard = true; });
  jobs.cancel();
  EXPECT_TRUE(QTest::qWaitFor([&] { return ran.load(); }));
  QTest::qWait(30);
  EXPECT_FALSE(heard);
  EXPECT_FALSE(jobs.busy());
  jobs.start([](WorkControl*) -> Result<int> { throw std::bad_alloc(); },
             [&](Result<int> result) { heard = !result && result.error().code == ErrorCode::Internal; });
  EXPECT_TRUE(QTest::qWaitFor([&] { return heard; }));
}

TEST_F(WindowTest, StateDumpTellsWhatTheWindowShows)
{
  const QString path = folder.filePath("state.json");
  StateDump dump(window.get(), path);
  ASSERT_TRUE(QTest::qWaitFor([&] { return QFile::exists(path); }));
  QFile file(path);
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  const QJsonObject state = QJsonDocument::fromJson(file.readAll()).object();
  EXPECT_EQ(state["nodes"].toInt(), 64);
  EXPECT_EQ(state["undoCount"].toInt(), 0);
  EXPECT_TRUE(state["widgets"].toObject().contains("regionAdd"));
}
