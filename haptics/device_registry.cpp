// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/device_registry.h"

#include "haptics/device/driven_device.h"
#include "haptics/device/laparoscope_device.h"
#include "haptics/simulated_device.h"
#include "haptics/usb/libusb_transport.h"

#include <array>
#include <exception>
#include <string>

namespace esm {

namespace {

/// The machine's USB, looked at for the first time when somebody asks.
Result<std::unique_ptr<LibusbTransport>>& systemUsb()
{
  static auto usb = LibusbTransport::create();
  return usb;
}

template <const char* kKind>
Result<std::unique_ptr<HapticDevice>> openUsb(const DeviceOptions& options)
{
  auto& usb = systemUsb();
  if (!usb) return usb.error();
  try {
    auto driver = openDriver(kKind, options, **usb);
    if (!driver) return driver.error();
    return std::unique_ptr<HapticDevice>(std::make_unique<DrivenDevice>(std::move(*driver)));
  } catch (const std::exception& trouble) { // no memory or no thread to be had
    return Error{ErrorCode::NoDevice, std::string("The device cannot be opened: ") + trouble.what()};
  }
}

Result<std::unique_ptr<HapticDevice>> openSimulated(const DeviceOptions&)
{
  return std::unique_ptr<HapticDevice>(SimulatedDevice::withMouseHand());
}

Result<std::unique_ptr<HapticDevice>> openLaparoscope(const DeviceOptions&)
{
  const Laparoscope4 instrument(Eigen::Vector3d(0.0, 0.0, 0.15), 0.30);
  return std::unique_ptr<HapticDevice>(LaparoscopeDevice::simulated(instrument));
}

constexpr char kFalcon[] = "falcon", kPid[] = "pid", kWooden[] = "wooden";

constexpr std::array kKinds{
  DeviceKind{"simulated", "A device in the computer, led by the mouse", false, openSimulated},
  DeviceKind{"laparoscope", "An instrument through a trocar in the computer, led by the mouse", false,
             openLaparoscope},
  DeviceKind{kFalcon, "Novint Falcon (USB); needs your firmware file", true, openUsb<kFalcon>},
  DeviceKind{kPid, "Force-feedback stick or wheel (USB HID PID)", true, openUsb<kPid>},
  DeviceKind{kWooden, "WoodenHaptics (USB)", true, openUsb<kWooden>},
};

} // namespace

std::span<const DeviceKind> deviceKinds() noexcept
{
  return kKinds;
}

Result<std::unique_ptr<HapticDevice>> openDevice(std::string_view name, const DeviceOptions& options)
{
  std::string known;
  for (const DeviceKind& kind : kKinds) {
    if (kind.name == name) return kind.open(options);
    known += (known.empty() ? "" : ", ") + std::string(kind.name);
  }
  return Error{ErrorCode::NoDevice,
               "There is no haptic device '" + std::string(name) + "'; known are: " + known};
}

std::vector<DeviceListing> listDevices(const DeviceOptions& options)
{
  auto& usb = systemUsb();
  if (usb) return listDevices(**usb, options);
  std::vector<DeviceListing> all;
  for (const DeviceKind& kind : kKinds)
    all.push_back({std::string(kind.name), std::string(kind.description), !kind.usb,
                   kind.usb ? usb.error().detail : "", "", ""});
  return all;
}

std::uint32_t usbChanges() noexcept
{
  auto& usb = systemUsb();
  return usb ? (*usb)->changes() : 0;
}

} // namespace esm
