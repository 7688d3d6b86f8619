// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "haptics/device/driver_profile.h"
#include "haptics/haptic_device.h"

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace esm {

class DeviceDriver;
class UsbTransport;
struct UsbDeviceInfo;

/// One kind of device that this build can drive.
struct DeviceKind {
  std::string_view name;        ///< as the user picks it
  std::string_view description; ///< one line (English)
  bool usb = false;             ///< has to be plugged in; its profile is NAME.json
  Result<std::unique_ptr<HapticDevice>> (*open)(const DeviceOptions& options);
};

/// All of them. A new device adds its file and its line in device_registry.cpp.
std::span<const DeviceKind> deviceKinds() noexcept;

/// Errors: NoDevice for a name that is not in the table (the message lists those that are), or from the
/// device: not plugged in, not permitted (the message then has the udev rule), in use; InvalidValue and the
/// like from its profile.
Result<std::unique_ptr<HapticDevice>> openDevice(std::string_view name, const DeviceOptions& options = {});

/// What stands between the user and a device now.
struct DeviceListing {
  std::string name, description;
  bool usable = false;
  std::string reason;   ///< why not; empty if usable
  std::string details;  ///< what else one may want to know: the firmware with its SHA-256
  std::string udevRule; ///< the line that permits it; empty unless permission is what is missing
};

/// Every kind, in the table's order. Takes a few milliseconds: for a list on demand, not for each frame.
std::vector<DeviceListing> listDevices(const DeviceOptions& options = {});

/// Another number whenever a USB device has come or gone. Any thread.
std::uint32_t usbChanges() noexcept;

// === With a bus of one's own, for tests and emulated devices

/// The driver of a USB kind ("falcon", "pid", "wooden") on this bus. Errors: as openDevice().
Result<std::unique_ptr<DeviceDriver>> openDriver(std::string_view kind, const DeviceOptions& options,
                                                 UsbTransport& usb);
std::vector<DeviceListing> listDevices(UsbTransport& usb, const DeviceOptions& options = {});

} // namespace esm
