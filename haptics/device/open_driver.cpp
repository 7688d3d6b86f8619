// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/base/file_io.h"
#include "haptics/device/falcon_driver.h"
#include "haptics/device/pid_driver.h"
#include "haptics/device/sha256.h"
#include "haptics/device/wooden_driver.h"
#include "haptics/device_registry.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace esm {

namespace {

constexpr std::size_t kLargestFirmware = 65536;

bool isKind(std::string_view kind, const DriverProfile& profile, const UsbDeviceInfo& info)
{
  if (std::find(profile.usb.begin(), profile.usb.end(), UsbId{info.vendor, info.product}) !=
      profile.usb.end())
    return true;
  return kind == "pid" && info.forceFeedback; // whatever its maker
}

std::optional<UsbDeviceInfo> findKind(std::string_view kind, const DriverProfile& profile, UsbTransport& usb)
{
  for (const UsbDeviceInfo& info : usb.list())
    if (isKind(kind, profile, info)) return info;
  return {};
}

std::string optInReason(const DriverProfile& profile)
{
  return "Its USB numbers belong to nobody, so another device may carry them; confirm that it is a " +
         profile.device.name;
}

Result<std::vector<std::uint8_t>> readFirmware(const DriverProfile& profile)
{
  if (profile.firmware.empty()) return std::vector<std::uint8_t>{};
  const Result<std::string> bytes = readFile(profile.firmware);
  if (!bytes) return bytes.error();
  if (bytes->empty() || bytes->size() > kLargestFirmware)
    return Error{ErrorCode::BadFormat, profile.firmware.string() + " holds " + std::to_string(bytes->size()) +
                                         " bytes; a firmware image has 1 to " +
                                         std::to_string(kLargestFirmware)};
  return std::vector<std::uint8_t>(bytes->begin(), bytes->end());
}

DeviceListing describe(const DeviceKind& kind, const DeviceOptions& options, UsbTransport& usb)
{
  DeviceListing listing{std::string(kind.name), std::string(kind.description), false, "", "", ""};
  const Result<DriverProfile> profile = loadProfile(kind.name, options);
  if (!profile) {
    listing.reason = profile.error().detail;
    return listing;
  }
  if (!profile->firmware.empty()) {
    const auto firmware = readFirmware(*profile);
    listing.details = firmware
                        ? "Firmware " + profile->firmware.string() + ", SHA-256 " + sha256Hex(*firmware)
                        : firmware.error().detail;
  }
  const auto info = findKind(kind.name, *profile, usb);
  if (!info) {
    listing.reason = "Not plugged in";
  } else if (!info->permitted) {
    listing.reason = "You are not permitted to use it; the udev rule permits it";
    listing.udevRule = udevRule(info->vendor, info->product);
  } else {
    listing.usable = true;
    if (profile->needsOptIn) listing.reason = optInReason(*profile);
  }
  return listing;
}

} // namespace

Result<std::unique_ptr<DeviceDriver>> openDriver(std::string_view kind, const DeviceOptions& options,
                                                 UsbTransport& usb)
{
  Result<DriverProfile> profile = loadProfile(kind, options);
  if (!profile) return profile.error();
  Result<std::vector<std::uint8_t>> firmware = readFirmware(*profile);
  if (!firmware) return firmware.error();
  const auto info = findKind(kind, *profile, usb);
  if (!info) return Error{ErrorCode::NoDevice, "No " + profile->device.name + " is plugged in"};
  if (profile->needsOptIn && !profile->optIn) return Error{ErrorCode::NoDevice, optInReason(*profile)};
  auto wakeup = std::make_unique<Wakeup>();
  const int interface = std::max(info->hidInterface, 0);
  auto handle = usb.open(*info, interface, *wakeup);
  if (!handle) return handle.error();
  std::unique_ptr<DeviceDriver> driver;
  if (kind == "falcon")
    driver = std::make_unique<FalconDriver>(std::move(*profile), std::move(wakeup), std::move(*handle),
                                            std::move(*firmware));
  else if (kind == "pid")
    driver =
      std::make_unique<PidDriver>(std::move(*profile), std::move(wakeup), std::move(*handle), interface);
  else if (kind == "wooden")
    driver = std::make_unique<WoodenDriver>(std::move(*profile), std::move(wakeup), std::move(*handle));
  else
    return Error{ErrorCode::NoDevice, "There is no driver for '" + std::string(kind) + "'"};
  return driver;
}

std::vector<DeviceListing> listDevices(UsbTransport& usb, const DeviceOptions& options)
{
  std::vector<DeviceListing> all;
  for (const DeviceKind& kind : deviceKinds()) {
    if (kind.usb)
      all.push_back(describe(kind, options, usb));
    else
      all.push_back({std::string(kind.name), std::string(kind.description), true, "", "", ""});
  }
  return all;
}

} // namespace esm
