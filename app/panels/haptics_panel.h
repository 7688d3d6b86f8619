// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/haptics/device_desk.h"
#include "app/panels/gesture_spin_box.h"
#include "app/simulation_controller.h"

#include <QElapsedTimer>
#include <QWidget>

class QLabel;
class QPushButton;
class QTabWidget;

namespace esm {

class ForceDial;
class HapticDevices;
class HapticPath;
class JitterPlot;
class TracePlot;

/// Dock Haptics. Its head is always there: state and reason, force limit, gain, force on, stop. Below, in
/// tabs: devices, force (number, arrow, curves), position, energy, timing, record and replay, and the
/// emulator if there is one. The force is what a device would feel, so it can be read without any being
/// armed.
class HapticsPanel : public QWidget {
  Q_OBJECT
public:
  HapticsPanel(DeviceDesk* desk, SimulationController* controller, QWidget* parent = nullptr);

protected:
  void changeEvent(QEvent* event) override;

private:
  void buildHead();
  void buildTabs(DeviceDesk* desk);
  void retranslateUi();
  void refreshState();
  void refreshForce();
  void refreshArm();
  void setMessage(const QString& text);

  SimulationController* m_controller;
  QLabel *m_state = nullptr, *m_message = nullptr, *m_limitLabel = nullptr, *m_gripLabel = nullptr,
         *m_gainLabel = nullptr, *m_forceLabel = nullptr, *m_force = nullptr, *m_timing = nullptr;
  GestureSpinBox *m_limit = nullptr, *m_grip = nullptr, *m_gain = nullptr;
  QPushButton *m_arm = nullptr, *m_stop = nullptr;
  QTabWidget* m_tabs = nullptr;
  QWidget* m_emulator = nullptr; ///< null without emulation
  HapticDevices* m_devices = nullptr;
  HapticPath* m_path = nullptr;
  ForceDial* m_dial = nullptr;
  TracePlot *m_forcePlot = nullptr, *m_positionPlot = nullptr, *m_energyPlot = nullptr;
  JitterPlot* m_jitterPlot = nullptr;
  QString m_said; ///< what went wrong last, until the device's state changes
  QElapsedTimer m_lastState, m_lastForce;
};

} // namespace esm
