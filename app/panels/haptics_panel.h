// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/panels/gesture_spin_box.h"
#include "app/simulation_controller.h"

#include <QElapsedTimer>
#include <QWidget>

class QComboBox;
class QLabel;
class QPushButton;

namespace esm {

class ForceCurve;
class ForceDial;

/// Dock Haptics: which device, in which state and why, its force limit, arm and stop; and the force of the
/// pull tool as number, arrow and curve. The number is what a device would feel, so it can be read without
/// any device being armed.
class HapticsPanel : public QWidget {
  Q_OBJECT
public:
  explicit HapticsPanel(SimulationController* controller, QWidget* parent = nullptr);

protected:
  void changeEvent(QEvent* event) override;

private:
  void retranslateUi();
  void refreshState();
  void refreshForce();
  void chooseDevice();

  SimulationController* m_controller;
  QComboBox* m_device = nullptr;
  QLabel *m_deviceLabel = nullptr, *m_state = nullptr, *m_reason = nullptr, *m_limitLabel = nullptr,
         *m_forceLabel = nullptr, *m_force = nullptr;
  GestureSpinBox* m_limit = nullptr;
  QPushButton *m_arm = nullptr, *m_stop = nullptr;
  ForceDial* m_dial = nullptr;
  ForceCurve* m_curve = nullptr;
  std::vector<TraceSample> m_trace;
  QElapsedTimer m_clock, m_lastState;
  double m_traceOffset = 0.0; ///< panel clock minus servo clock [s]
  bool m_traceAligned = false;
};

/// "ready, 0 N", ... in the window's language.
QString deviceStateText(DeviceState state);

} // namespace esm
