// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/haptics/device_desk.h"

#include <QWidget>

class QCheckBox;
class QLabel;
class QPushButton;

namespace esm {

/// What people do to a device, done to the emulated one: plug and unplug it, permit it, loosen its cable,
/// pull its grip out and push it in. Shown with --emulate-device only.
class EmulatorPanel : public QWidget {
  Q_OBJECT
public:
  explicit EmulatorPanel(DeviceDesk* desk, QWidget* parent = nullptr);

protected:
  void changeEvent(QEvent* event) override;

private:
  void retranslateUi();
  DeviceDesk* m_desk;
  QLabel* m_what = nullptr;
  QCheckBox *m_plugged = nullptr, *m_permitted = nullptr, *m_mute = nullptr;
  QPushButton* m_outAndIn = nullptr;
};

} // namespace esm
