// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/device_registry.h"

#include <QString>

#include <memory>
#include <string>
#include <vector>

namespace esm {

class EmulatedFalcon;

/// Where the window's devices come from: this computer's USB, or an emulated one.
/// @note Threads: any; list() and open() may take their time and wait for each other.
class DeviceSource {
public:
  virtual ~DeviceSource() = default;
  virtual std::vector<DeviceListing> list(const DeviceOptions& options) = 0;
  virtual Result<std::unique_ptr<HapticDevice>> open(const std::string& name,
                                                     const DeviceOptions& options) = 0;
  virtual std::uint32_t changes() const = 0; ///< another number whenever a device has come or gone; quick
  virtual EmulatedFalcon* emulated() { return nullptr; }
};

/// @param emulate what is asked for by --emulate-device: "" or "falcon".
std::shared_ptr<DeviceSource> makeDeviceSource(const QString& emulate);

} // namespace esm
