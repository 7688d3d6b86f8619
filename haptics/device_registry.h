// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "haptics/haptic_device.h"

#include <memory>
#include <span>
#include <string_view>

namespace esm {

/// One kind of device that this build can drive.
struct DeviceKind {
  std::string_view name;        ///< as the user picks it
  std::string_view description; ///< one line (English)
  Result<std::unique_ptr<HapticDevice>> (*open)();
};

/// All of them. A new device adds its file and its line in device_registry.cpp.
std::span<const DeviceKind> deviceKinds() noexcept;

/// Errors: NoDevice for a name that is not in the table (the message lists those that are), or from the
/// device.
Result<std::unique_ptr<HapticDevice>> openDevice(std::string_view name);

} // namespace esm
