// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dialogs/import_dialog.h"
#include "app/panels/regions_panel.h"
#include "app/text/error_text.h"
#include "app/window/main_window.h"
#include "app/window/scripted_run.h"
#include "app/window/state_dump.h"
#include "app/window/window_actions.h"
#include "core/base/file_io.h"
#include "core/net/net_builder.h"
#include "core/project/project_io.h"
#include "tests/app/window_test.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeWidget>

#include <gtest/gtest.h>

using namespace esm;
using test::WindowTest;

namespace {

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
  EXPECT_FALSE(run->isPulling());
  // At once, whatever pictures of the time before still come.
  int held = run->snapshot().grabbedNode != kNoIndex || run->snapshot().toolForce.norm() > 0.0 ? 1 : 0;
  QObject::connect(run, &SimulationController::frame, window.get(),
                   [&] { held += run->snapshot().grabbedNode != kNoIndex ? 1 : 0; });
  QTest::qWait(200);
  EXPECT_EQ(held, 0);
}

// The simulation lets go at a reset: whoever shows or leads the pull must, too.
TEST_F(WindowTest, ResetEndsThePull)
{
  SimulationController* run = window->controller();
  run->startPull(27, window->document()->project().net.restPosition.col(27));
  ASSERT_TRUE(run->isPulling());
  window->actions()->reset->trigger();
  EXPECT_FALSE(run->isPulling());
}

// While force is on the space key stops, so it is not named as what plays.
TEST_F(WindowTest, APullWhilePausedNamesTheWayOutThatWorks)
{
  const auto said = [&] {
    emit window->sceneView()->pullStarted(27, 0.0, 0.0, 0.0);
    window->controller()->endPull();
    return window->statusBar()->currentMessage();
  };
  EXPECT_TRUE(said().contains("space key"));
  EXPECT_TRUE(
    QTest::qWaitFor([&] { return window->controller()->hapticStatus().state == DeviceState::Idle; }));
  window->controller()->arm();
  ASSERT_TRUE(window->controller()->forceMayFlow());
  EXPECT_TRUE(said().contains("paused") && !said().contains("space key")) << qPrintable(said());
  window->controller()->disarm();
}

// Esc serves many ends; that something was stopped is said only where it was.
TEST_F(WindowTest, StopSaysOnlyWhatItHasDone)
{
  const auto said = [&] {
    window->actions()->stop->trigger();
    return window->statusBar()->currentMessage();
  };
  EXPECT_FALSE(said().contains("Stopped")) << qPrintable(said());
  window->controller()->startPull(27, window->document()->project().net.restPosition.col(27));
  EXPECT_TRUE(said().contains("Stopped"));
  EXPECT_FALSE(window->controller()->isPulling());
  EXPECT_FALSE(said().contains("Stopped"));
}

/// What the view does at Esc, which has no hand here without OpenGL: it lets go before any shortcut is looked for.
class LetsGoAtEscape : public QObject {
public:
  explicit LetsGoAtEscape(SceneView* view) : m_view(view) { view->installEventFilter(this); }
  bool eventFilter(QObject*, QEvent* event) override
  {
    if (event->type() == QEvent::ShortcutOverride) emit m_view->pullEnded();
    return false;
  }

private:
  SceneView* m_view;
};

// The view lets go at Esc before the window's stop hears of it: what was held is said all the same.
TEST_F(WindowTest, EscInAPullSaysThatTheTissueIsReleased)
{
  window->activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(window.get()));
  SceneView* view = window->sceneView();
  const LetsGoAtEscape hand(view);
  const auto saidAtEscape = [&] {
    QTest::keyClick(view, Qt::Key_Escape);
    EXPECT_FALSE(window->controller()->isPulling());
    return window->statusBar()->currentMessage();
  };
  emit view->pullStarted(27, 0.0, 0.0, 0.0);
  ASSERT_TRUE(window->controller()->isPulling());
  EXPECT_EQ(saidAtEscape(), "Stopped: the tissue is released, force is zero.");
  EXPECT_EQ(saidAtEscape(), "Force is zero, nothing is held.");
  language.set(Language::German);
  emit view->pullStarted(27, 0.0, 0.0, 0.0);
  EXPECT_EQ(saidAtEscape(), "Gestoppt: Das Gewebe ist losgelassen, die Kraft ist null.");
}

// The way to stop is never folded away, however narrow the window is.
TEST_F(WindowTest, StopStaysInTheToolBarOfANarrowWindow)
{
  for (QDockWidget* dock : window->findChildren<QDockWidget*>()) dock->hide();
  for (const Language spoken : {Language::English, Language::German}) {
    window->setLanguage(spoken);
    window->resize(600, 500);
    QTest::qWait(50);
    auto* stop = find<QWidget>("tool_actStop");
    EXPECT_FALSE(find<QWidget>("colouringBox")->isVisible()) << window->width(); // others have no room
    ASSERT_TRUE(stop->isVisible());
    EXPECT_TRUE(window->rect().contains(QRect(stop->mapTo(window.get(), QPoint()), stop->size())));
    EXPECT_GE(stop->width(), stop->sizeHint().width());
  }
}

// No field of the window drops one of the decimal marks.
TEST_F(WindowTest, EveryNumberFieldTakesEitherDecimalMark)
{
  int fields = 0;
  for (const Language spoken : {Language::English, Language::German}) {
    window->setLanguage(spoken);
    for (const QDoubleSpinBox* box : window->findChildren<QDoubleSpinBox*>())
      for (const char* number : {"0.5", "0,5"}) {
        if (box->decimals() == 0) continue;
        ++fields;
        QString text = box->prefix() + QLatin1String(number) + box->suffix();
        int position = static_cast<int>(text.size());
        EXPECT_NE(box->validate(text, position), QValidator::Invalid)
          << qPrintable(box->objectName()) << " " << qPrintable(text);
      }
  }
  EXPECT_GT(fields, 40);
}

TEST_F(WindowTest, RedoHasBothUsualKeys)
{
  EXPECT_TRUE(window->actions()->redo->shortcuts().contains(QKeySequence(Qt::CTRL | Qt::Key_Y)));
  EXPECT_TRUE(window->actions()->redo->shortcuts().contains(QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z)));
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
