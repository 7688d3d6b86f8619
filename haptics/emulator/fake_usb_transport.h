// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "haptics/emulator/usb_device_model.h"
#include "haptics/transport/usb_transport.h"

#include <atomic>
#include <memory>
#include <mutex>

namespace esm {

/// A bus in the computer with one emulated device on it, and the faults that a test wants.
///
/// Time is what the holder of the handle says in take(); so one thread and a virtual clock play a device for
/// an hour in a second, with equal results each time. With a thread of its own a device runs on it as well.
/// @note Threads: as UsbTransport; the faults any.
class FakeUsbTransport final : public UsbTransport {
public:
  explicit FakeUsbTransport(std::shared_ptr<UsbDeviceModel> model);

  std::vector<UsbDeviceInfo> list() override;
  Result<std::unique_ptr<UsbHandle>> open(const UsbDeviceInfo& device, int interface,
                                          Wakeup& wakeup) override;
  std::uint32_t changes() const noexcept override;

  // === Faults
  void unplug();
  void plugIn();                      ///< the same device again
  void setMute(bool mute);            ///< transfers are taken and never end
  void setPermitted(bool permitted);  ///< opening is refused
  void corruptNext(std::size_t byte); ///< one byte of the next IN transfer comes wrong
  void setLatency(double seconds);    ///< from the answer of the device to the completion

  struct Bus;

private:
  std::shared_ptr<Bus> m_bus;
};

} // namespace esm
