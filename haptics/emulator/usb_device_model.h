// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "haptics/protocol/usb_setup.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace esm {

/// A USB device in the computer, as its bus sees it. The fake transport, the umockdev tests and the USB/IP
/// server all speak to it through this one interface.
///
/// The requests that every device knows (descriptors, configuration) are answered here; a model adds its own.
/// @note One thread at a time.
class UsbDeviceModel {
public:
  static constexpr int kStall = -1, kNothingYet = -2;

  struct Identity {
    std::uint16_t vendor = 0, product = 0;
    std::uint8_t endpointIn = 0x81, endpointOut = 0x02;
    bool interrupt = false;                  ///< endpoints; else bulk
    std::vector<std::uint8_t> hidDescriptor; ///< HID report descriptor; empty: no HID device
    bool noOutEndpoint = false;              ///< HID output reports by control only
  };

  explicit UsbDeviceModel(Identity identity);
  virtual ~UsbDeviceModel() = default;

  const Identity& identity() const noexcept { return m_identity; }
  const std::vector<std::uint8_t>& deviceDescriptor() const noexcept { return m_device; }
  const std::vector<std::uint8_t>& configurationDescriptor() const noexcept { return m_configuration; }

  /// @param data what comes with an OUT request, or the room for the answer to an IN request.
  /// @return bytes moved, or kStall.
  int control(const UsbSetup& setup, std::span<std::uint8_t> data);
  virtual bool out(std::span<const std::uint8_t> bytes) = 0; ///< @return false: stalled
  virtual int in(std::span<std::uint8_t> bytes) = 0;         ///< @return bytes, kNothingYet or kStall
  virtual void advance(double now) = 0;                      ///< its mechanics and timers [s]

protected:
  virtual int ownControl(const UsbSetup& setup, std::span<std::uint8_t> data) = 0;

private:
  Identity m_identity;
  std::vector<std::uint8_t> m_device, m_configuration;
};

} // namespace esm
