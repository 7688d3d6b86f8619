// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/device_registry.h"

#include "haptics/simulated_device.h"

#include <array>
#include <string>

namespace esm {

namespace {

Result<std::unique_ptr<HapticDevice>> openSimulated()
{
  return std::unique_ptr<HapticDevice>(SimulatedDevice::withMouseHand());
}

constexpr std::array kKinds{
  DeviceKind{"simulated", "A device in the computer, led by the mouse", openSimulated},
};

} // namespace

std::span<const DeviceKind> deviceKinds() noexcept
{
  return kKinds;
}

Result<std::unique_ptr<HapticDevice>> openDevice(std::string_view name)
{
  std::string known;
  for (const DeviceKind& kind : kKinds) {
    if (kind.name == name) return kind.open();
    known += (known.empty() ? "" : ", ") + std::string(kind.name);
  }
  return Error{ErrorCode::NoDevice,
               "There is no haptic device '" + std::string(name) + "'; known are: " + known};
}

} // namespace esm
