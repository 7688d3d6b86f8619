// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "haptics/transport/usb_transport.h"

#include <memory>

namespace esm {

/// USB by libusb: asynchronous transfers, an event thread of its own, and news of plugged and unplugged
/// devices by hotplug events, or where those are missing by looking each second. Opening takes a device from
/// the kernel's driver, closing gives it back.
/// @note Threads: as UsbTransport. Handles may outlive the transport.
class LibusbTransport final : public UsbTransport {
public:
  /// Errors: NoDevice, if the system has no USB that we can see.
  static Result<std::unique_ptr<LibusbTransport>> create();

  std::vector<UsbDeviceInfo> list() override;
  Result<std::unique_ptr<UsbHandle>> open(const UsbDeviceInfo& device, int interface,
                                          Wakeup& wakeup) override;
  std::uint32_t changes() const noexcept override;

  class Bus;

private:
  explicit LibusbTransport(std::shared_ptr<Bus> bus) : m_bus(std::move(bus)) {}
  std::shared_ptr<Bus> m_bus;
};

} // namespace esm
