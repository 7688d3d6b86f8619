// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/haptics/device_desk.h"
#include "app/simulation_controller.h"

#include <QWidget>

class QCheckBox;
class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;
class QToolButton;

namespace esm {

/// The devices of this computer, each with its state and the reason for it, and the way to each: permission,
/// firmware, consent, connection, home, place of its workspace.
class HapticDevices : public QWidget {
  Q_OBJECT
public:
  HapticDevices(DeviceDesk* desk, SimulationController* controller, QWidget* parent = nullptr);
  void refresh(); ///< state of what is connected; call a few times a second

signals:
  void said(const QString& text); ///< what went wrong, for the panel's head

protected:
  void changeEvent(QEvent* event) override;

private:
  void build();
  void layOut();
  void retranslateUi();
  void takeList();
  void fillList();
  void showDetails();
  void showRow(int row);
  std::string current() const; ///< name of the row; empty: none
  bool isConnected(const std::string& name) const;
  QString reasonOf(const DeviceListing& listing) const;
  void connectOrNot();
  void chooseFirmware();
  void placeOnModel();
  void calibrate();

  DeviceDesk* m_desk;
  SimulationController* m_controller;
  QListWidget* m_list = nullptr;
  QLabel *m_what = nullptr, *m_reason = nullptr, *m_firmware = nullptr;
  QLineEdit* m_rule = nullptr;
  QToolButton *m_copyRule = nullptr, *m_rescan = nullptr;
  QCheckBox* m_consent = nullptr;
  QPushButton *m_connect = nullptr, *m_home = nullptr, *m_chooseFirmware = nullptr, *m_place = nullptr,
              *m_calibrate = nullptr;
  std::string m_failedName;
  QString m_failure; ///< why m_failedName could not be opened
};

} // namespace esm
