// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dialogs/real_time_dialog.h"
#include "app/text/language.h"
#include "app/text/reason_text.h"
#include "app/theme.h"
#include "app/window/main_window.h"
#include "app/window/status_strip.h"
#include "app/window/window_actions.h"
#include "tests/app/sheet.h"

#include <QAbstractButton>
#include <QAction>
#include <QActionGroup>
#include <QDoubleSpinBox>
#include <QListWidget>
#include <QMenu>
#include <QSettings>
#include <QStatusBar>
#include <QTest>
#include <QTimer>

#include <gtest/gtest.h>

#include <algorithm>

using namespace esm;

namespace {

struct RealTimeTest : testing::Test {
  LanguageSwitch language;
  void SetUp() override
  {
    applyTheme(Theme::Light);
    language.set(Language::English);
    QSettings().remove(QStringLiteral("realTime"));
  }
  void TearDown() override { language.set(Language::English); }
};

SimSnapshot running(Stability stability)
{
  SimSnapshot snapshot;
  snapshot.playing = true;
  snapshot.stability = stability;
  snapshot.realTimeFactor = stability == Stability::Slow ? 0.62 : 1.0;
  snapshot.position.setZero(3, 64);
  snapshot.report.nodesAwake = 12;
  snapshot.report.springsEvaluated = 34567;
  snapshot.quality = {0, 5, QualityMeasure::SlowMotion, 0.01, 0.01, 1e6};
  snapshot.solver = "leapfrog";
  snapshot.message =
    "springs at node 812 (1e+09 N/m on 0.01 kg) need explicit steps of 0.4 us; the engine went implicit";
  return snapshot;
}

QString colourOf(const QLabel& light)
{
  return light.text().section(QLatin1Char('\''), 1, 1).section(QLatin1Char(':'), 1);
}

/// A net and settings that make the engine say something of each kind.
std::string whyOf(double stiffness, SolverSettings settings, int frames = 3)
{
  Project project = test::sheetProject();
  project.net.stiffness.setConstant(stiffness);
  project.loads.gravity = {0.0, 0.0, -9.81};
  Simulation simulation = Simulation::create(project.net, project.loads, std::move(settings)).value();
  for (int i = 0; i < frames; ++i)
    if (!simulation.advance(1.0 / 60.0).good()) break;
  return simulation.why();
}

} // namespace

// Green while the tolerance is kept, yellow while something gives way, red when it stopped; words say the
// same.
TEST_F(RealTimeTest, TheLightShowsWhatGivesWay)
{
  StabilityLight light;
  const SignalColours colours = signalColours(light.palette());
  const auto show = [&](const SimSnapshot& snapshot) { light.show(snapshot), QTest::qWait(0); };
  show(running(Stability::Good));
  EXPECT_EQ(colourOf(light), colours.good.name());
  EXPECT_TRUE(light.text().contains("stable"));
  show(running(Stability::Implicit));
  EXPECT_EQ(colourOf(light), colours.warning.name());
  EXPECT_TRUE(light.text().contains("implicit"));
  EXPECT_TRUE(light.toolTip().contains("node 812")) << qPrintable(light.toolTip()); // cause
  EXPECT_TRUE(light.toolTip().contains("Softer tissue"));                           // cure
  SimSnapshot rough = running(Stability::Rough);
  rough.quality.rung = 2;
  rough.quality.measure = QualityMeasure::Tolerance;
  rough.quality.tolerance = 0.2;
  show(rough);
  EXPECT_EQ(colourOf(light), colours.warning.name());
  EXPECT_TRUE(light.toolTip().contains("20 % instead of 1 %")) << qPrintable(light.toolTip());
  show(running(Stability::Slow));
  EXPECT_EQ(colourOf(light), colours.warning.name());
  EXPECT_TRUE(light.text().contains("0.62 × real time")) << qPrintable(light.text());
  show(running(Stability::Stopped));
  EXPECT_EQ(colourOf(light), colours.bad.name());
  EXPECT_TRUE(light.text().contains("stopped"));
  language.set(Language::German);
  show(running(Stability::Slow));
  EXPECT_TRUE(light.text().contains("0,62 × Echtzeit")) << qPrintable(light.text());
  EXPECT_TRUE(light.toolTip().contains("Federn am Knoten 812")) << qPrintable(light.toolTip());
}

TEST_F(RealTimeTest, TheStatusBarShowsAccuracyWorkAndSleep)
{
  QStatusBar bar;
  bar.resize(1600, 24);
  StatusStrip strip(&bar);
  strip.setNet(64, 161);
  const auto label = [&](const char* name) { return bar.findChild<QLabel*>(QLatin1String(name)); };
  SimSnapshot snapshot = running(Stability::Good);
  strip.setRun(snapshot);
  EXPECT_EQ(label("lblNodes")->text(), "12 of 64 nodes awake");
  EXPECT_TRUE(label("lblSprings")->toolTip().contains("34567 springs evaluated"))
    << qPrintable(label("lblSprings")->toolTip());
  EXPECT_EQ(label("lblRealTime")->text(), "real time 1.00×");
  EXPECT_TRUE(label("lblSolver")->text().contains("leapfrog"));
  EXPECT_TRUE(label("lblSolver")->toolTip().contains("0.4 µs"));
  snapshot.quality = {2, 5, QualityMeasure::Tolerance, 0.01, 0.2, 1e6};
  strip.setRun(snapshot);
  EXPECT_EQ(label("lblRealTime")->text(), "real time 1.00×, tolerance 20 %");
  EXPECT_TRUE(label("lblRealTime")->toolTip().contains("step 2 of 5"));
  snapshot.playing = false;
  strip.setRun(snapshot);
  EXPECT_EQ(label("lblNodes")->text(), "64 nodes");
  strip.setNet(0, 0); // a new project: the run is that of another model
  strip.setRun(snapshot);
  EXPECT_TRUE(label("lblRealTime")->text().isEmpty());
  EXPECT_TRUE(label("lblSolver")->text().isEmpty());
}

// A frame that hangs, read again and again while no other picture comes: the light turns, the lag is shown from
// 100 ms on, and after half a second it is said that there is no picture.
TEST_F(RealTimeTest, AFrameThatHangsIsSeenWhileItHangs)
{
  QStatusBar bar;
  bar.resize(1600, 24);
  StatusStrip strip(&bar);
  strip.setNet(64, 161);
  const auto text = [&](const char* name) { return bar.findChild<QLabel*>(QLatin1String(name))->text(); };
  SimSnapshot picture = running(Stability::Good);
  picture.clock = FrameClock(0.02);
  picture.clock.start(0.0);
  picture.clock.endFrame(0.02, 0.02, 0.02); // the next one is due at 0.02 s
  const auto readAt = [&](double now) {
    readClock(picture, now);
    strip.setRun(picture);
  };
  readAt(0.03);
  EXPECT_TRUE(text("lblStable").contains("stable"));
  EXPECT_EQ(text("lblRealTime"), "real time 1.00×");
  readAt(0.1); // 60 ms late
  EXPECT_TRUE(text("lblStable").contains("slowed")) << qPrintable(text("lblStable"));
  EXPECT_FALSE(text("lblRealTime").contains("behind"));
  readAt(0.29);
  EXPECT_TRUE(text("lblRealTime").endsWith("×, 250 ms behind")) << qPrintable(text("lblRealTime"));
  readAt(1.35);
  EXPECT_TRUE(text("lblStable").contains("too heavy, no picture for 1.3 s")) << qPrintable(text("lblStable"));
  language.set(Language::German);
  readAt(2.0201);
  EXPECT_TRUE(text("lblStable").contains("zu schwer, seit 2,0 s kein Bild")) << qPrintable(text("lblStable"));
  EXPECT_TRUE(text("lblRealTime").endsWith("2,0 s im Rückstand")) << qPrintable(text("lblRealTime"));
}

// A message or a label that is cut off tells nothing: lesser ones make room, and come back.
TEST_F(RealTimeTest, TheStatusBarMakesRoomForAMessage)
{
  QStatusBar bar;
  StatusStrip strip(&bar);
  strip.setTool("Pull");
  strip.setNet(64, 161);
  strip.setDerived({}, 1e-3);
  strip.setRun(running(Stability::Good));
  bar.resize(1100, 24);
  bar.show();
  const auto label = [&](const char* name) { return bar.findChild<QLabel*>(QLatin1String(name)); };
  ASSERT_TRUE(QTest::qWaitFor([&] { return label("lblDerived")->isVisible(); }));
  const QString message(120, 'x');
  bar.showMessage(message);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !label("lblDerived")->isVisible(); }));
  QTest::qWait(30);
  EXPECT_TRUE(label("lblStable")->isVisible());
  EXPECT_GE(label("lblStable")->width(), label("lblStable")->sizeHint().width());
  int end = bar.width();
  for (const QLabel* shown : bar.findChildren<QLabel*>())
    if (shown->isVisible()) end = std::min(end, shown->x());
  EXPECT_LT(bar.fontMetrics().horizontalAdvance(message), end);
  EXPECT_EQ(bar.toolTip(), message);
  bar.clearMessage();
  EXPECT_TRUE(QTest::qWaitFor([&] { return label("lblDerived")->isVisible(); }));
}

// The fullest bar that a heavy net makes, on small screens: what is shown is whole and lies beside its neighbours;
// factor, lag, error, light and the awake nodes are always among it, and what is short is whole in its tool tip.
TEST_F(RealTimeTest, NothingInTheStatusBarIsCutOff)
{
  QStatusBar bar;
  StatusStrip strip(&bar);
  strip.setNet(40962, 514939);
  DerivationReport report;
  report.springsChanged = 514939;
  SimSnapshot snapshot = running(Stability::Slow);
  snapshot.position.setZero(3, 40962);
  snapshot.report.nodesAwake = 38765;
  snapshot.solver = "block-descent";
  snapshot.realTimeFactor = 0.07;
  snapshot.lag = 0.752;
  snapshot.frameTime = 2.04;
  snapshot.quality = {2, 5, QualityMeasure::Tolerance, 0.01, 0.2, 1e6};
  snapshot.report.rough = true;
  snapshot.roughUntil = 1.0;
  snapshot.toldError = 0.39;
  HapticStatus device;
  device.state = DeviceState::Idle;
  device.rate = 1000.0;
  bar.show();
  const auto field = [&](const char* name) { return bar.findChild<StatusField*>(QLatin1String(name)); };
  for (const Language spoken : {Language::English, Language::German}) {
    language.set(spoken);
    const bool german = spoken == Language::German;
    strip.setLanguage(german ? "de" : "en");
    strip.setTool(german ? "Ziehen: Gewebe fassen und ziehen (Esc lässt los)"
                         : "Pull: drag the tissue (Esc lets go)");
    for (const QString& message : {QString(), QString(80, 'x') + " 12.345 N"})
      for (int width = 700; width <= 1600; width += 20) {
        bar.resize(width, 24);
        strip.setDerived(report, 0.0123);
        strip.setDevice(device);
        strip.setRun(snapshot);
        bar.showMessage(message);
        QCoreApplication::sendPostedEvents();
        QTest::qWait(0);
        SCOPED_TRACE(testing::Message() << width << (german ? " de " : " en ") << message.toStdString());
        std::vector<QRect> places;
        for (const QLabel* label : bar.findChildren<QLabel*>()) {
          if (!label->isVisible() || label->text().isEmpty()) continue;
          EXPECT_GE(label->width(), label->sizeHint().width()) << qPrintable(label->text());
          places.push_back(label->geometry());
        }
        std::ranges::sort(places, {}, [](const QRect& place) { return place.left(); });
        for (std::size_t i = 0; i + 1 < places.size(); ++i)
          EXPECT_LT(places[i].right(), places[i + 1].left());
        EXPECT_LT(places.back().right(), width);
        EXPECT_TRUE(field("lblRealTime")->text().contains(german ? "0,07×" : "0.07×"));
        EXPECT_TRUE(field("lblRealTime")->text().contains("752 ms"));
        EXPECT_TRUE(field("lblTolerance")->text().contains(german ? "Fehler etwa 39 %" : "error about 39 %"));
        EXPECT_TRUE(
          field("lblStable")->text().contains(german ? "seit 2,0 s kein Bild" : "no picture for 2.0 s"));
        for (const char* name : {"lblRealTime", "lblTolerance", "lblStable"}) {
          EXPECT_TRUE(field(name)->isVisible()) << name;
          EXPECT_TRUE(field(name)->text().contains(field(name)->whole()) ||
                      field(name)->toolTip().contains(field(name)->whole()))
            << qPrintable(field(name)->toolTip());
        }
        if (width >= 1280 && message.isEmpty()) {
          EXPECT_TRUE(field("lblNodes")->text().startsWith("38765")) << qPrintable(field("lblNodes")->text());
          EXPECT_TRUE(bar.findChild<QLabel*>("lblTool")->text().startsWith(german ? "Ziehen" : "Pull"));
          EXPECT_TRUE(field("lblDevice")->isVisible());
        }
      }
  }
}

// A number that is cut is another one: a text goes by words.
TEST_F(RealTimeTest, ATextIsCutBetweenItsWords)
{
  const QFontMetrics metrics(QApplication::font());
  const QString text = "forces of up to 12345.678 N were measured";
  for (int room = 0; room <= metrics.horizontalAdvance(text); ++room) {
    QString cut = elidedAtWord(text, metrics, room);
    ASSERT_LE(metrics.horizontalAdvance(cut), room);
    if (cut.isEmpty() || cut == QString(QChar(0x2026))) continue;
    EXPECT_TRUE(cut == text || cut.endsWith(QString::fromUtf8(" …"))) << qPrintable(cut);
    cut.remove(QString::fromUtf8(" …"));
    EXPECT_TRUE(text == cut || text.startsWith(cut + ' ')) << qPrintable(cut);
  }
  EXPECT_EQ(elidedAtWord(text, metrics, metrics.horizontalAdvance(text)), text);
}

// Said while it is so, also when paused or late, and while the motion comes from there; not without a cause.
TEST_F(RealTimeTest, AToleranceThatWasGivenUpIsSaidForAsLongAsItIsSo)
{
  QStatusBar bar;
  bar.resize(1600, 24);
  StatusStrip strip(&bar);
  const auto* note = bar.findChild<QLabel*>("lblTolerance");
  SimSnapshot snapshot = running(Stability::Slow); // the light speaks of the clock
  strip.setRun(snapshot);
  EXPECT_TRUE(note->isHidden());
  snapshot.report.rough = true;
  snapshot.roughUntil = snapshot.time = 0.35;
  strip.setRun(snapshot);
  EXPECT_FALSE(note->text().contains("error")) << qPrintable(note->text()); // nothing has moved
  snapshot.toldError = 0.0432;
  strip.setRun(snapshot);
  EXPECT_FALSE(note->isHidden());
  EXPECT_TRUE(note->text().contains("rough, error about 4 %")) << qPrintable(note->text());
  EXPECT_TRUE(note->toolTip().contains("tolerance of 1 %")) << qPrintable(note->toolTip());
  EXPECT_TRUE(note->toolTip().contains("softer tissue or heavier nodes")) << qPrintable(note->toolTip());
  snapshot.playing = false; // the shape that is seen is as rough as before
  strip.setRun(snapshot);
  EXPECT_FALSE(note->isHidden());
  snapshot.playing = true;
  snapshot.report.rough = false;
  snapshot.time = 0.5;
  strip.setRun(snapshot);
  EXPECT_FALSE(note->isHidden());
  EXPECT_TRUE(note->text().contains("given up until t = 0.35 s")) << qPrintable(note->text());
  language.set(Language::German);
  strip.setRun(snapshot);
  EXPECT_TRUE(QTest::qWaitFor([&] { return note->text().contains("aufgegeben bis t = 0,35 s"); }))
    << qPrintable(note->text());
  strip.setNet(64, 161); // another model
  EXPECT_TRUE(note->isHidden());
}

// A real net that no step can follow at the effort allowed: the note comes by itself, stays when paused, and
// goes with a new beginning.
TEST_F(RealTimeTest, TheWindowSaysThatATooStiffNetIsRough)
{
  MainWindow window(&language);
  QualityPlan plan;
  plan.effort = 1e3; // less than a step costs
  window.controller()->setQuality(plan);
  Project project = test::sheetProject();
  project.net.stiffness.setConstant(1e13);
  project.net.fixed[0] = project.net.fixed[7] = 1; // or it would only fall
  project.net.initialVelocity.setRandom(3, project.net.nodeCount());
  window.document()->start(std::move(project), QString());
  window.show();
  const auto* note = window.findChild<QLabel*>("lblTolerance");
  EXPECT_FALSE(note->isVisible());
  window.controller()->setPlaying(true);
  EXPECT_TRUE(QTest::qWaitFor([&] { return note->isVisible(); }, 20000))
    << window.controller()->snapshot().time << " s, effort " << window.controller()->snapshot().quality.effort
    << ": " << window.controller()->snapshot().message;
  window.controller()->setPlaying(false);
  QTest::qWait(300);
  EXPECT_TRUE(note->isVisible());
  window.controller()->reset();
  EXPECT_TRUE(QTest::qWaitFor([&] { return !note->isVisible(); }, 20000));
}

// A net of steps so fine that a picture takes many refreshes of the screen: in between the window reads the
// clock, and for one and the same picture the time that the next one has taken rises.
TEST_F(RealTimeTest, TheWindowReadsTheClockBetweenTwoPictures)
{
  MainWindow window(&language);
  Project project = test::sheetProject();
  project.simulation.solver = {"verlet", 1e-3, 1e-8, 1};
  window.document()->start(std::move(project), QString());
  window.show();
  const SimSnapshot& snapshot = window.controller()->snapshot();
  std::uint64_t sequence = 0;
  double frameTime = 0.0;
  int risen = 0;
  QObject::connect(window.controller(), &SimulationController::clockRead, &window, [&] {
    risen += snapshot.sequence == sequence && snapshot.frameTime > frameTime ? 1 : 0;
    sequence = snapshot.sequence;
    frameTime = snapshot.frameTime;
  });
  window.controller()->setPlaying(true);
  EXPECT_TRUE(QTest::qWaitFor([&] { return risen > 3; }, 20000));
  EXPECT_TRUE(QTest::qWaitFor(
    [&] { return window.findChild<QLabel*>("lblStable")->text().contains("slowed"); }, 20000));
  window.controller()->setPlaying(false);
  EXPECT_TRUE(QTest::qWaitFor([&] { return !snapshot.playing; }, 20000));
  EXPECT_EQ(snapshot.frameTime, 0.0);
  EXPECT_EQ(snapshot.lag, 0.0);
}

// The light turns for the worse with the reading of the clock that finds it so, not with the next of the numbers:
// each time that a net which keeps time gives way to one whose pictures take a second.
TEST_F(RealTimeTest, TheLightTurnsAtOnce)
{
  MainWindow window(&language);
  window.show();
  const SimSnapshot& snapshot = window.controller()->snapshot();
  const auto* light = window.findChild<QLabel*>("lblStable");
  int readings = 0, wrong = 0;
  const auto read = [&] { // after the window has
    if (snapshot.stability != Stability::Slow) return;
    ++readings;
    wrong += light->text().contains("stable") || light->text().contains("paused") ? 1 : 0;
  };
  QObject::connect(window.controller(), &SimulationController::clockRead, &window, read);
  QObject::connect(window.controller(), &SimulationController::frame, &window, read);
  for (int i = 0; i < 6; ++i) {
    Project project = test::sheetProject();
    window.document()->start(project, QString());
    window.controller()->setPlaying(true);
    QTest::qWait(150 + 15 * i);
    project.simulation.solver = {"verlet", 1e-3, 1e-8, 1};
    window.document()->start(std::move(project), QString());
    readings = 0;
    EXPECT_TRUE(QTest::qWaitFor([&] { return readings > 3; }, 20000));
  }
  EXPECT_EQ(wrong, 0);
}

// What the engine really says, in German: should a sentence of it change, its translation is missed here.
TEST_F(RealTimeTest, TheEnginesReasonsAreTranslated)
{
  language.set(Language::German);
  const std::string reasons[] = {
    whyOf(100.0, {"auto", 1e-2}),                 // explicit
    whyOf(100.0, {"auto", 1e-7}),                 // of higher order
    whyOf(1e13, {"auto", 1e-2}),                  // implicit
    whyOf(1e13, {"auto", 1e-2, 0.0, 1, 1e3}),     // the tolerance given up
    whyOf(100.0, {"rk4", 1e-2}),                  // as asked
    whyOf(1e9, {"verlet", 1e-2, 0.005, 1}, 2000), // stopped
  };
  for (const std::string& reason : reasons)
    for (const QString& clause : QString::fromStdString(reason).split(QStringLiteral("; "))) {
      EXPECT_FALSE(clause.isEmpty());
      EXPECT_NE(reasonText(clause.toStdString()), clause) << reason;
    }
  EXPECT_TRUE(QString::fromStdString(reasons[5]).contains("infinite")) << reasons[5];
  EXPECT_EQ(reasonText("springs at node 812 (1e+09 N/m on 0.01 kg) need explicit steps of 0.4 us"),
            "Federn am Knoten 812 (1e+09 N/m an 0,01 kg) brauchen explizite Schritte von 0,4 µs");
  EXPECT_EQ(reasonText("something new"), "something new");
  language.set(Language::English);
  EXPECT_EQ(reasonText("the engine went implicit"), "the engine went implicit");
}

TEST_F(RealTimeTest, TheOrderIsChosenAndKept)
{
  EXPECT_EQ(savedQualityPlan(), QualityPlan());
  RealTimeDialog dialog(savedQualityPlan());
  auto* order = dialog.findChild<QListWidget*>("realTimeOrder");
  ASSERT_EQ(order->count(), 3);
  EXPECT_FALSE(dialog.findChild<QAbstractButton*>("realTimeUp")->isEnabled());
  order->setCurrentRow(1);
  dialog.findChild<QAbstractButton*>("realTimeUp")->click(); // effort before tolerance
  order->setCurrentRow(2);
  dialog.findChild<QAbstractButton*>("realTimeUp")->click(); // slow motion before tolerance
  EXPECT_TRUE(order->item(2)->text().startsWith("never")) << qPrintable(order->item(2)->text());
  EXPECT_FALSE(order->item(1)->text().startsWith("never"));
  dialog.findChild<QDoubleSpinBox*>("realTimeCoarsest")->setValue(8.0);
  dialog.findChild<QDoubleSpinBox*>("realTimeFinest")->setValue(10.0); // the allowed error goes along
  const QualityPlan chosen = dialog.plan();
  EXPECT_EQ(formatQualityOrder(chosen.order), "effort,slow-motion,tolerance");
  EXPECT_NEAR(chosen.finest, 0.1, 1e-12);
  EXPECT_NEAR(chosen.coarsest, 0.1, 1e-12);
  saveQualityPlan(chosen);
  EXPECT_EQ(savedQualityPlan(), chosen);
  dialog.findChild<QAbstractButton*>("realTimeDefaults")->click();
  EXPECT_EQ(dialog.plan(), QualityPlan());
  for (const char* name : {"realTimeOk", "realTimeCancel", "realTimeOrder", "realTimeFinest"})
    EXPECT_FALSE(dialog.findChild<QWidget*>(QLatin1String(name))->accessibleName().isEmpty()) << name;
}

TEST_F(RealTimeTest, DamagedSettingsAreTheDefaults)
{
  QSettings settings;
  settings.setValue("realTime/order", "tolerance,tolerance,fast");
  settings.setValue("realTime/finest", "-3");
  settings.setValue("realTime/coarsest", "much");
  EXPECT_EQ(savedQualityPlan(), QualityPlan());
}

// From the menu to the engine: the wish of the dialog is in force at once, in the midst of motion.
TEST_F(RealTimeTest, TheWindowPutsTheWishIntoForce)
{
  MainWindow window(&language);
  window.document()->start(test::sheetProject(), QString());
  window.show();
  window.controller()->setPlaying(true);
  const auto wanted = [&] { return window.controller()->snapshot().quality.wantedTolerance; };
  ASSERT_TRUE(QTest::qWaitFor([&] { return window.controller()->snapshot().time > 0.05; }, 20000));
  EXPECT_NEAR(wanted(), 0.01, 1e-12);
  bool answered = false;
  QTimer::singleShot(0, [&] {
    auto* dialog = window.findChild<RealTimeDialog*>();
    if (dialog == nullptr) return;
    dialog->findChild<QDoubleSpinBox*>("realTimeFinest")->setValue(3.0);
    dialog->findChild<QAbstractButton*>("realTimeOk")->click();
    answered = true;
  });
  window.actions()->realTime->trigger();
  ASSERT_TRUE(answered);
  EXPECT_TRUE(QTest::qWaitFor([&] { return std::abs(wanted() - 0.03) < 1e-12; }, 20000));
  EXPECT_GT(window.controller()->snapshot().time, 0.05);
  MainWindow next(&language); // the next start
  next.document()->start(test::sheetProject(), QString());
  EXPECT_TRUE(QTest::qWaitFor(
    [&] { return std::abs(next.controller()->snapshot().quality.wantedTolerance - 0.03) < 1e-12; }, 20000));
}

// Every solver of the engine can be chosen, with a line on it in the language of the window.
TEST_F(RealTimeTest, TheMenuNamesAllSolvers)
{
  MainWindow window(&language);
  const QList<QAction*> actions = window.actions()->solver->actions();
  EXPECT_EQ(actions.size(), static_cast<qsizetype>(solverNames().size() + 1));
  window.setLanguage(Language::German);
  for (const SolverInfo& info : solverNames()) {
    auto* action =
      window.findChild<QAction*>(QStringLiteral("actSolver_") + QString::fromStdString(info.name));
    ASSERT_NE(action, nullptr) << info.name;
    EXPECT_EQ(action->text().toStdString(), info.name);
    EXPECT_FALSE(action->toolTip().isEmpty());
  }
  EXPECT_EQ(window.findChild<QAction*>("actSolver_rk4")->toolTip(), "explizit, vierte Ordnung");
}
