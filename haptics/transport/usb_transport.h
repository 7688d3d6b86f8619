// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "haptics/protocol/usb_setup.h"
#include "haptics/transport/wakeup.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace esm {

/// A device on the bus, not opened.
struct UsbDeviceInfo {
  std::uint16_t vendor = 0, product = 0;
  std::uint8_t bus = 0, address = 0;
  int hidInterface = -1; ///< number of its first HID interface
  bool forceFeedback =
    false;               ///< its HID reports speak of physical effects (page 0x0F), as far as one can see
  bool permitted = true; ///< this user may open it, as far as one can see
};

enum class UsbStatus : std::uint8_t { Ok, TimedOut, Stalled, Cancelled, Lost, Failed };

struct UsbOutcome {
  UsbStatus status = UsbStatus::Failed;
  std::size_t length = 0; ///< bytes moved
};

/// A transfer that has ended.
struct UsbCompletion {
  static constexpr std::size_t kMostBytes = 512;
  UsbStatus status = UsbStatus::Failed;
  std::uint8_t endpoint = 0;
  std::size_t length = 0;
  std::array<std::uint8_t, kMostBytes> bytes; ///< of an IN transfer

  std::span<const std::uint8_t> data() const noexcept { return {bytes.data(), length}; }
};

/// The first IN and OUT endpoint of the claimed interface; 0: none.
struct UsbEndpoints {
  std::uint8_t in = 0, out = 0;
};

/// An opened device with one interface claimed; the kernel's driver, if it had one, comes back when this
/// goes.
/// @note Threads: one, the device's own. Completions also post the Wakeup given at opening.
class UsbHandle {
public:
  virtual ~UsbHandle() = default;
  /// Waits for the end. `data` is sent or filled.
  virtual UsbOutcome control(const UsbSetup& setup, std::span<std::uint8_t> data) noexcept = 0;
  /// @return false: nothing was started (too many under way, or the device is lost).
  virtual bool submitOut(std::span<const std::uint8_t> bytes) noexcept = 0;
  virtual bool submitIn(std::size_t bytes) noexcept = 0;
  /// The next transfer that has ended. @param now [s]; only an emulated device cares.
  virtual bool take(double now, UsbCompletion& completion) noexcept = 0;
  /// For a thread that is dying, from its signal handler: sends `bytes` to the OUT endpoint, or by `setup`
  /// where there is none. Needs no lock that another thread or this one may hold, allocates nothing, waits
  /// 20 ms at most. False: it did not leave.
  virtual bool sendAtLast(const UsbSetup& setup, std::span<const std::uint8_t> bytes) noexcept = 0;
  virtual UsbEndpoints endpoints() const noexcept = 0;
  virtual bool lost() const noexcept = 0; ///< unplugged
};

/// Finds and opens USB devices.
/// @note Threads: any, one at a time; changes() any.
class UsbTransport {
public:
  virtual ~UsbTransport() = default;
  virtual std::vector<UsbDeviceInfo> list() = 0;
  /// Errors: NoDevice (gone, busy, or not permitted: the text then has the udev rule that permits it).
  virtual Result<std::unique_ptr<UsbHandle>> open(const UsbDeviceInfo& device, int interface,
                                                  Wakeup& wakeup) = 0;
  /// Another number whenever a device has come or gone.
  virtual std::uint32_t changes() const noexcept = 0;
};

/// Whether a HID report descriptor has the page of physical interface devices.
bool mentionsForceFeedback(std::span<const std::uint8_t> hidDescriptor) noexcept;

/// The line for /etc/udev/rules.d that lets the user at the screen use this device.
std::string udevRule(std::uint16_t vendor, std::uint16_t product);

} // namespace esm
