// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/haptics/device_source.h"

#include "haptics/emulator/emulated_falcon.h"

#include <atomic>
#include <mutex>

namespace esm {

namespace {

class SystemDevices final : public DeviceSource {
public:
  std::vector<DeviceListing> list(const DeviceOptions& options) override
  {
    const std::lock_guard lock(m_mutex);
    std::vector<DeviceListing> all = listDevices(options);
    m_listed = true;
    return all;
  }
  Result<std::unique_ptr<HapticDevice>> open(const std::string& name, const DeviceOptions& options) override
  {
    const std::lock_guard lock(m_mutex);
    return openDevice(name, options);
  }
  /// The first look at USB takes its time: it belongs to list().
  std::uint32_t changes() const override { return m_listed ? usbChanges() : 0; }

private:
  std::mutex m_mutex;
  std::atomic<bool> m_listed{false};
};

class EmulatedDevices final : public DeviceSource {
public:
  std::vector<DeviceListing> list(const DeviceOptions& options) override
  {
    const std::lock_guard lock(m_mutex);
    return m_falcon.list(options);
  }
  Result<std::unique_ptr<HapticDevice>> open(const std::string& name, const DeviceOptions& options) override
  {
    const std::lock_guard lock(m_mutex);
    return name == "falcon" ? m_falcon.open(options) : openDevice(name, options);
  }
  std::uint32_t changes() const override { return m_falcon.changes(); }
  EmulatedFalcon* emulated() override { return &m_falcon; }

private:
  std::mutex m_mutex;
  EmulatedFalcon m_falcon;
};

} // namespace

std::shared_ptr<DeviceSource> makeDeviceSource(const QString& emulate)
{
  if (emulate == QLatin1String("falcon")) return std::make_shared<EmulatedDevices>();
  return std::make_shared<SystemDevices>();
}

} // namespace esm
