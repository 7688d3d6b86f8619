// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dialogs/calibrate_dialog.h"
#include "app/haptics/haptic_text.h"
#include "app/haptics/user_profile.h"
#include "app/window/main_window.h"
#include "app/window/window_actions.h"
#include "core/base/file_io.h"
#include "haptics/device/driver_profile.h"
#include "haptics/emulator/emulated_falcon.h"
#include "haptics/simulated_device.h"
#include "tests/app/sheet.h"

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QGuiApplication>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QSettings>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <filesystem>
#include <functional>

using namespace esm;

namespace {

constexpr int kPatience = 30000; // [ms]; a sanitizer on a busy machine is slow
constexpr int kFalcon = 2, kWooden = 4, kEmulatorTab = 6;

/// The window with an emulated Falcon in place of USB, or with devices of the test's own.
struct HapticsPanelTest : testing::Test {
  LanguageSwitch language;
  std::unique_ptr<MainWindow> window;
  QTemporaryDir folder;
  QString firmware;

  void SetUp() override
  {
    QSettings().remove(QStringLiteral("haptics/firmware"));
    language.set(Language::English);
    firmware = folder.filePath("firmware.bin");
    ASSERT_TRUE(writeFileAtomically(firmware.toStdString(), std::string(400, 'f')));
    show(makeDeviceSource("falcon"));
  }
  void TearDown() override
  {
    window.reset();
    language.set(Language::English);
  }
  void show(std::shared_ptr<DeviceSource> devices)
  {
    window.reset();
    window = std::make_unique<MainWindow>(&language, std::move(devices));
    window->document()->start(test::sheetProject(), QString());
    window->show();
  }
  template <class W>
  W* find(const char* name)
  {
    W* widget = window->findChild<W*>(QLatin1String(name));
    EXPECT_NE(widget, nullptr) << name;
    return widget;
  }
  void click(const char* name) { QTest::mouseClick(find<QAbstractButton>(name), Qt::LeftButton); }
  QString row(int i) { return find<QListWidget>("hapticList")->item(i)->text(); }
  void choose(int i) { find<QListWidget>("hapticList")->setCurrentRow(i); }
  EmulatedFalcon* falcon() { return window->devices()->emulated(); }
  SimulationController* run() { return window->controller(); }
  bool comes(const std::function<bool()>& condition) { return QTest::qWaitFor(condition, kPatience); }

  /// Connected, homed, idle.
  void connectFalcon()
  {
    choose(kFalcon);
    window->devices()->setFirmware(firmware);
    ASSERT_TRUE(comes([&] { return find<QAbstractButton>("hapticConnect")->isEnabled(); }));
    click("hapticConnect");
    ASSERT_TRUE(comes([&] { return run()->deviceReport().phase == DevicePhase::NeedsHome; }));
    falcon()->pullOutAndIn();
    ASSERT_TRUE(comes([&] { return run()->deviceReport().phase == DevicePhase::Running; }));
  }
  void arm()
  {
    ASSERT_TRUE(comes([&] { return find<QAbstractButton>("hapticArm")->isEnabled(); }));
    click("hapticArm");
    ASSERT_TRUE(comes([&] {
      const DeviceState state = run()->hapticStatus().state;
      return state == DeviceState::Arming || state == DeviceState::Active;
    }));
  }
  bool stopped()
  {
    return comes([&] { return run()->hapticStatus().state == DeviceState::Fault; });
  }
};

/// A WoodenHaptics on the list, which opens for whoever has said that it is one.
struct OneWooden final : DeviceSource {
  std::vector<DeviceListing> list(const DeviceOptions&) override
  {
    std::vector<DeviceListing> all;
    for (const DeviceKind& kind : deviceKinds())
      all.push_back({std::string(kind.name), std::string(kind.description), true, "", "", ""});
    all[kWooden].reason = "Its USB numbers belong to nobody, so another device may carry them; confirm that "
                          "it is a WoodenHaptics";
    return all;
  }
  Result<std::unique_ptr<HapticDevice>> open(const std::string&, const DeviceOptions& options) override
  {
    asked = true;
    if (!options.optIn) return Error{ErrorCode::NoDevice, "without consent"};
    return std::unique_ptr<HapticDevice>(SimulatedDevice::withMouseHand());
  }
  std::uint32_t changes() const override { return 0; }
  std::atomic<bool> asked{false};
};

} // namespace

// A refusal is not a mystery: the list says so, and the line that permits it can be copied.
TEST_F(HapticsPanelTest, WithoutPermissionTheUdevLineIsShownAndCopied)
{
  choose(kFalcon);
  EXPECT_TRUE(comes([&] { return row(kFalcon).contains("ready to connect"); }));
  EXPECT_FALSE(find<QLineEdit>("hapticRule")->isVisible());
  find<QTabWidget>("hapticTabs")->setCurrentIndex(kEmulatorTab);
  find<QCheckBox>("emulatorPermitted")->setChecked(false);
  find<QTabWidget>("hapticTabs")->setCurrentIndex(0);
  ASSERT_TRUE(comes([&] { return row(kFalcon).contains("no permission"); }));
  EXPECT_TRUE(find<QLabel>("hapticReason")->text().contains("not permitted"));
  const QString rule = find<QLineEdit>("hapticRule")->text();
  EXPECT_TRUE(rule.contains("0403") && rule.contains("uaccess")) << qPrintable(rule);
  EXPECT_TRUE(find<QLineEdit>("hapticRule")->isVisible());
  EXPECT_FALSE(find<QAbstractButton>("hapticConnect")->isEnabled());
  click("hapticCopyRule");
  EXPECT_EQ(QGuiApplication::clipboard()->text(), rule);
}

// Hotplug: nobody presses anything, and the list knows.
TEST_F(HapticsPanelTest, TheListFollowsTheCable)
{
  ASSERT_TRUE(comes([&] { return row(kFalcon).contains("ready to connect"); }));
  falcon()->setPlugged(false);
  EXPECT_TRUE(comes([&] { return row(kFalcon).contains("not plugged in"); }));
  falcon()->setPlugged(true);
  EXPECT_TRUE(comes([&] { return row(kFalcon).contains("ready to connect"); }));
}

TEST_F(HapticsPanelTest, WithoutFirmwareItSaysSoAndForceWaits)
{
  choose(kFalcon);
  ASSERT_TRUE(comes([&] { return find<QAbstractButton>("hapticConnect")->isEnabled(); }));
  click("hapticConnect");
  ASSERT_TRUE(comes([&] { return run()->deviceReport().phase == DevicePhase::Fault; }));
  EXPECT_TRUE(comes([&] { return find<QLabel>("hapticReason")->text().contains("needs its firmware"); }));
  EXPECT_FALSE(find<QAbstractButton>("hapticArm")->isEnabled());
}

// The whole way; then Esc in a modal dialog stops and is used up by that, and the next one closes the dialog.
TEST_F(HapticsPanelTest, EscStopsInsideAModalDialog)
{
  ASSERT_NO_FATAL_FAILURE(connectFalcon());
  EXPECT_EQ(run()->coupling(), SimulationController::Coupling::Touches);
  ASSERT_NO_FATAL_FAILURE(arm());
  EXPECT_TRUE(QCoreApplication::testAttribute(Qt::AA_DontUseNativeDialogs));
  QDialog dialog(window.get());
  dialog.setModal(true);
  dialog.open();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&dialog));
  QTest::keyClick(&dialog, Qt::Key_Escape);
  EXPECT_TRUE(stopped());
  EXPECT_EQ(run()->hapticStatus().force.norm(), 0.0);
  EXPECT_TRUE(dialog.isVisible());
  QTest::keyClick(&dialog, Qt::Key_Escape);
  EXPECT_FALSE(dialog.isVisible());
}

// Space on the button that let force flow must not let it flow again; nor does it start the simulation.
TEST_F(HapticsPanelTest, SpaceStopsWhereverTheFocusIs)
{
  ASSERT_NO_FATAL_FAILURE(arm()); // the simulated device
  const bool playing = run()->isPlaying();
  auto* button = find<QAbstractButton>("hapticArm");
  button->setFocus();
  QTest::keyClick(button, Qt::Key_Space);
  EXPECT_TRUE(stopped());
  EXPECT_EQ(run()->isPlaying(), playing);
  EXPECT_TRUE(comes([&] { return find<QLabel>("hapticMessage")->text().contains("Stopped by the user"); }));
  QTest::keyClick(button, Qt::Key_Space); // now it is a button again
  EXPECT_TRUE(comes([&] { return run()->hapticStatus().state != DeviceState::Fault; }));
}

TEST_F(HapticsPanelTest, APulledCableHasAReasonAndTheWayBack)
{
  ASSERT_NO_FATAL_FAILURE(connectFalcon());
  falcon()->setPlugged(false);
  ASSERT_TRUE(comes([&] { return run()->hapticStatus().state == DeviceState::Absent; }));
  EXPECT_TRUE(comes([&] { return find<QLabel>("hapticMessage")->text().contains("unplugged"); }));
  EXPECT_FALSE(find<QAbstractButton>("hapticArm")->isEnabled());
  falcon()->setPlugged(true); // and is shown as such by itself, not as the lost one
  ASSERT_TRUE(comes([&] { return row(kFalcon).contains("ready to connect"); }));
  EXPECT_TRUE(run()->deviceName().empty());
  EXPECT_TRUE(find<QLabel>("hapticMessage")->text().isEmpty());
  ASSERT_TRUE(comes([&] { return find<QAbstractButton>("hapticConnect")->isEnabled(); }));
  click("hapticConnect");
  EXPECT_TRUE(comes([&] { return run()->deviceReport().phase == DevicePhase::NeedsHome; }));
  EXPECT_EQ(run()->hapticStatus().force.norm(), 0.0);
}

// The instrument leaves the scene with its device: no dent stays, and no force that nobody feels.
TEST_F(HapticsPanelTest, APulledCableTakesTheToolOutOfTheScene)
{
  ASSERT_NO_FATAL_FAILURE(connectFalcon());
  run()->setPlaying(true);
  ASSERT_TRUE(comes([&] { return run()->snapshotIsCurrent() && run()->snapshot().tipRadius > 0.0; }));
  falcon()->setPlugged(false);
  EXPECT_TRUE(comes([&] { return run()->snapshot().tipRadius == 0.0; }));
  EXPECT_TRUE(run()->snapshot().toolForce.isZero(0.0));
}

// Force never flows into another project by itself.
TEST_F(HapticsPanelTest, AnotherProjectTurnsTheForceOff)
{
  ASSERT_NO_FATAL_FAILURE(connectFalcon());
  ASSERT_NO_FATAL_FAILURE(arm());
  window->document()->start(test::sheetProject(), QString());
  EXPECT_TRUE(comes([&] { return run()->hapticStatus().state == DeviceState::Idle; }));
  EXPECT_FALSE(run()->forceMayFlow());
}

// What the window says is so: nothing moves while it is paused, and that is no longer said when it plays.
TEST_F(HapticsPanelTest, ItSaysWhyNothingIsFelt)
{
  ASSERT_NO_FATAL_FAILURE(connectFalcon());
  const auto saysPaused = [&] { return find<QLabel>("hapticMessage")->text().contains("paused"); };
  run()->setPlaying(false);
  ASSERT_NO_FATAL_FAILURE(arm());
  EXPECT_TRUE(comes(saysPaused));
  run()->setPlaying(true);
  EXPECT_TRUE(comes([&] { return !saysPaused(); }));
}

TEST_F(HapticsPanelTest, AnUnregisteredDeviceNeedsConsent)
{
  auto source = std::make_shared<OneWooden>();
  show(source);
  ASSERT_TRUE(comes([&] { return row(kWooden).contains("needs your consent"); }));
  choose(kWooden);
  EXPECT_FALSE(find<QAbstractButton>("hapticConnect")->isEnabled());
  EXPECT_TRUE(find<QLabel>("hapticReason")->text().contains("belong to nobody"));
  find<QCheckBox>("hapticConsent")->setChecked(true);
  ASSERT_TRUE(comes([&] { return find<QAbstractButton>("hapticConnect")->isEnabled(); }));
  EXPECT_FALSE(source->asked);
  click("hapticConnect");
  EXPECT_TRUE(comes([&] { return run()->deviceName() == "wooden"; }));
}

// Nobody feels a window that asks whether to save.
TEST_F(HapticsPanelTest, ForceFadesWhileTheWindowAsksWhetherToSave)
{
  ASSERT_NO_FATAL_FAILURE(arm());
  window->document()->rename("changed");
  bool faded = false;
  QTimer watch;
  QObject::connect(&watch, &QTimer::timeout, &watch, [&] {
    auto* question = qobject_cast<QDialog*>(QApplication::activeModalWidget());
    if (question == nullptr || run()->hapticStatus().state != DeviceState::Idle) return;
    faded = true;
    question->reject();
  });
  watch.start(10);
  EXPECT_FALSE(window->close());
  EXPECT_TRUE(faded);
}

// The user's limit holds below the device's own, which the field does not exceed.
TEST_F(HapticsPanelTest, TheForceLimitStaysBelowTheDevicesOwn)
{
  ASSERT_NO_FATAL_FAILURE(connectFalcon());
  auto* limit = find<QDoubleSpinBox>("hapticForceLimit");
  EXPECT_TRUE(comes([&] { return limit->maximum() == run()->deviceProfile()->maxForce; }));
  limit->setValue(1.5);
  EXPECT_TRUE(comes([&] { return run()->hapticStatus().forceLimit == 1.5; }));
  limit->setValue(1000.0);
  EXPECT_TRUE(comes([&] { return run()->hapticStatus().forceLimit == run()->deviceProfile()->maxForce; }));
}

// 8 mm where nobody has said another.
TEST_F(HapticsPanelTest, TheGripsRadiusIsRemembered)
{
  auto* radius = find<QDoubleSpinBox>("pullRadius");
  EXPECT_EQ(radius->value(), 8.0);
  radius->setValue(5.0);
  EXPECT_TRUE(comes([&] { return std::abs(run()->gripRadius() - 0.005) < 1e-12; }));
  EXPECT_NEAR(QSettings().value("pull/radius").toDouble(), 0.005, 1e-12);
  QSettings().remove("pull/radius");
}

// The number is what a hand feels, with gain and limit: what it would feel, then what it does.
TEST_F(HapticsPanelTest, TheForceReadIsTheOneInTheHand)
{
  const auto reads = [&](double newtons) {
    return find<QLabel>("hapticForce")->text() == QStringLiteral("%1 N").arg(newtons, 0, 'f', 2);
  };
  find<QTabWidget>("hapticTabs")->setCurrentIndex(1);
  run()->setPlaying(true);
  const Eigen::Vector3d rest = window->document()->project().net.restPosition.col(5);
  run()->startPull(5, rest + Eigen::Vector3d(0.0, 0.0, 0.02));
  ASSERT_TRUE(comes([&] { return run()->snapshot().toolForce.norm() > 0.05; }));
  run()->setForceScale(0.5);
  EXPECT_TRUE(comes([&] { return reads(0.5 * run()->snapshot().toolForce.norm()); }));
  run()->setForceScale(10.0);
  run()->setForceLimit(0.3);
  EXPECT_TRUE(comes([&] { return reads(0.3); }));
  run()->endPull();
  run()->setForceScale(2.0);
  run()->setForceLimit(1.0);
  ASSERT_NO_FATAL_FAILURE(arm());
  run()->startPull(5, rest);
  EXPECT_TRUE(comes([&] {
    const HapticStatus status = run()->hapticStatus();
    const bool active = status.state == DeviceState::Active;
    if (status.state == DeviceState::Fault) run()->arm(); // the computer has stalled: once more
    run()->movePull(rest +
                    Eigen::Vector3d(0.0, 0.0, active ? 0.01 : 0.0)); // force begins gently, or not at all
    return active && status.force.norm() > 0.05 && reads(status.force.norm());
  }));
  run()->setForceScale(0.0);
  EXPECT_TRUE(comes([&] { return reads(0.0); }));
}

TEST_F(HapticsPanelTest, TheWorkspaceIsLaidOnTheModel)
{
  ASSERT_NO_FATAL_FAILURE(connectFalcon());
  ASSERT_TRUE(comes([&] { return window->sceneView()->instrument().visible; }));
  click("hapticPlace");
  const auto& nodes = window->document()->project().net.restPosition;
  const Eigen::Vector3d middle = 0.5 * (nodes.rowwise().minCoeff() + nodes.rowwise().maxCoeff());
  EXPECT_TRUE(
    comes([&] { return window->sceneView()->instrument().workspace.center().isApprox(middle, 1e-9); }));
  ASSERT_NO_FATAL_FAILURE(arm()); // then no more: the tissue would jump into the hand
  EXPECT_TRUE(comes([&] { return !find<QAbstractButton>("hapticPlace")->isEnabled(); }));
}

// What the user has measured and seen is kept as he said it, and nothing else of his profile is touched.
TEST(UserProfile, KeepsTheCalibrationAndWhatElseIsThere)
{
  const std::filesystem::path file = userProfilePath("pid");
  std::filesystem::create_directories(file.parent_path());
  ASSERT_TRUE(writeFileAtomically(file, R"({"update_rate_Hz": 125.0})"));
  CalibrateDialog dialog(stickCalibration("pid").value());
  EXPECT_FALSE(dialog.findChild<QCheckBox*>("calibrateAcross")->isChecked());
  dialog.findChild<QDoubleSpinBox*>("calibrateNewtons")->setValue(3.25);
  dialog.findChild<QCheckBox*>("calibrateAcross")->setChecked(true);
  dialog.findChild<QDoubleSpinBox*>("calibrateOriginY")->setValue(-20.0);
  ASSERT_TRUE(setStickCalibration("pid", dialog.calibration()));
  const StickCalibration kept = stickCalibration("pid").value();
  EXPECT_EQ(kept.newtonsAtFull, 3.25);
  EXPECT_TRUE(kept.reversedAcross);
  EXPECT_FALSE(kept.reversedAlong);
  EXPECT_NEAR(kept.origin.y(), -0.02, 1e-12);
  EXPECT_EQ(loadProfile("pid", {}).value().quirks.polarity, Eigen::Vector2d(1.0, 1.0));
  EXPECT_EQ(loadProfile("pid", {}).value().quirks.updateRate, 125.0);
  ASSERT_TRUE(writeFileAtomically(file, "no JSON"));
  EXPECT_FALSE(setStickCalibration("pid", {}));
  EXPECT_EQ(readFile(file).value(), "no JSON");
  std::filesystem::remove(file);
}

// Should a sentence of the device layer change, its translation is missed here.
TEST_F(HapticsPanelTest, TheDevicesReasonsAreTranslated)
{
  const auto german = [](const std::string& sentence) { return hapticReasonText(sentence).toStdString(); };
  language.set(Language::German);
  choose(kFalcon);
  for (const DeviceKind& kind : deviceKinds()) {
    const std::string description(kind.description);
    if (kind.name != "wooden") { // a name and a kind of socket
      EXPECT_NE(german(description), description);
    }
  }
  ASSERT_TRUE(comes([&] { return find<QAbstractButton>("hapticConnect")->isEnabled(); }));
  click("hapticConnect");
  ASSERT_TRUE(comes([&] { return run()->deviceReport().phase == DevicePhase::Fault; }));
  EXPECT_NE(german(run()->deviceReport().reason), run()->deviceReport().reason);
  falcon()->setPermitted(false);
  window->devices()->rescan();
  ASSERT_TRUE(comes([&] { return !window->devices()->find("falcon")->udevRule.empty(); }));
  const std::string reason = window->devices()->find("falcon")->reason;
  EXPECT_NE(german(reason), reason);
  for (int r = static_cast<int>(ServoReason::NeedsHome); r <= static_cast<int>(ServoReason::Closed); ++r) {
    const std::string servo = reasonText(static_cast<ServoReason>(r));
    EXPECT_NE(german(servo), servo);
  }
  EXPECT_EQ(german("something new"), "something new");
}
