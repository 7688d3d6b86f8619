// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/haptics/device_source.h"
#include "app/jobs/job.h"
#include "haptics/hand_path.h"

#include <QObject>
#include <QTimer>

#include <functional>

namespace esm {

/// The haptic devices as the window knows them: which there are, what stands in their way, and what the user
/// has said about them. USB is asked on threads of its own, again whenever a device comes or goes; the window
/// never waits for it. GUI thread.
class DeviceDesk : public QObject {
  Q_OBJECT
public:
  using Opened = Result<std::unique_ptr<HapticDevice>>;

  explicit DeviceDesk(std::shared_ptr<DeviceSource> source, QObject* parent = nullptr);

  const std::vector<DeviceListing>& listings() const noexcept { return m_listings; }
  const DeviceListing* find(const std::string& name) const;
  void rescan();
  bool scanning() const noexcept { return m_scan.busy(); }

  /// What is in the computer opens at once, USB on another thread; `finish` gets the device or why not.
  /// Opening another one drops the former.
  void open(const std::string& name, std::function<void(Opened)> finish);
  bool opening() const noexcept { return m_open.busy(); }

  // === What the user says
  const std::filesystem::path& firmware() const noexcept { return m_options.firmware; }
  void setFirmware(const QString& file); ///< kept for the next start
  /// "Yes, what carries these numbers is that device"; for this run of the program only.
  void setConsent(bool consent);
  bool consent() const noexcept { return m_options.optIn; }

  EmulatedFalcon* emulated() { return m_source->emulated(); } ///< null without emulation

signals:
  void listed(); ///< listings() are new
  void busyChanged();

private:
  std::shared_ptr<DeviceSource> m_source;
  JobRunner m_scan, m_open;
  QTimer m_watch;
  std::uint32_t m_changes = 0;
  DeviceOptions m_options;
  std::vector<DeviceListing> m_listings;
};

} // namespace esm
