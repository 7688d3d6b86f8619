// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/haptics/device_desk.h"
#include "app/simulation_controller.h"
#include "haptics/hand_path.h"
#include "haptics/trace_log.h"

#include <QWidget>

#include <optional>

class QLabel;
class QPushButton;

namespace esm {

/// Record and replay: the way of the hand and what it felt, in the files of `esm haptics record`, `replay`
/// and `run --csv`. What is recorded goes to the user's state folder meanwhile, so that a program that dies
/// leaves it there; it is removed when it was saved or the program ends in order. A loaded path leads the
/// hand of an emulated device, or of a simulated one of its own.
class HapticPath : public QWidget {
  Q_OBJECT
public:
  HapticPath(DeviceDesk* desk, SimulationController* controller, QWidget* parent = nullptr);
  ~HapticPath() override;
  void refresh();

signals:
  void said(const QString& text);

protected:
  void changeEvent(QEvent* event) override;

private:
  void retranslateUi();
  void take(const std::vector<TraceSample>& ticks);
  void record(bool on);
  void beginLog();
  void dropLog();
  void save(bool path);
  void load();
  void lead();
  bool emulated() const; ///< whether the connected device is the emulated one

  static constexpr std::size_t kMostTicks = 600'000; ///< ten minutes

  DeviceDesk* m_desk;
  SimulationController* m_controller;
  QPushButton *m_record = nullptr, *m_savePath = nullptr, *m_saveLog = nullptr, *m_load = nullptr,
              *m_lead = nullptr;
  QLabel *m_recorded = nullptr, *m_loaded = nullptr;
  std::vector<TraceSample> m_ticks;
  bool m_recording = false;
  std::optional<TraceLog> m_log; ///< while recording
  QString m_logFile;             ///< of the last recording, until it was saved
  QString m_left;                ///< recording of a program that died
  std::optional<HandPath> m_path;
  QString m_file;
  WaitingHand* m_hand = nullptr; ///< of the device "path", while it is attached
};

} // namespace esm
