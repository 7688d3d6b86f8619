// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "haptics/emulator/usb_device_model.h"

#include <chrono>
#include <cstdint>
#include <list>
#include <memory>
#include <mutex>

#include <umockdev.h>

namespace esm {

/// A USB bus for the real libusb, made by umockdev: an emulated device on it, plugged and unplugged at will.
/// Runs under umockdev-wrapper. What libusb asks of the kernel arrives on umockdev's own thread.
class UsbTestbed {
public:
  explicit UsbTestbed(std::shared_ptr<UsbDeviceModel> model);
  ~UsbTestbed();
  UsbTestbed(const UsbTestbed&) = delete;
  UsbTestbed& operator=(const UsbTestbed&) = delete;

  void plugIn();
  void unplug();
  bool claimed() const;
  void setMute(bool mute); ///< transfers are taken and never end

private:
  static gboolean onIoctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self);
  bool answer(UMockdevIoctlClient* client);
  void submit(UMockdevIoctlClient* client, UMockdevIoctlData* argument);
  void reap(UMockdevIoctlClient* client, UMockdevIoctlData* argument);
  void discard(UMockdevIoctlClient* client, UMockdevIoctlData* argument);
  bool work(UMockdevIoctlData* urb); ///< @return whether it has ended
  double now() const;

  std::shared_ptr<UsbDeviceModel> m_model;
  UMockdevTestbed* m_bed;
  UMockdevIoctlBase* m_handler;
  mutable std::mutex m_mutex; ///< of all below
  std::list<UMockdevIoctlData*> m_underWay, m_ended;
  bool m_plugged = false, m_claimed = false, m_mute = false;
  std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
};

} // namespace esm
