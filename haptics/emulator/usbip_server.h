// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "haptics/emulator/usb_device_model.h"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <span>
#include <vector>

namespace esm {

/// The device side of USB/IP: bytes of one connection in, bytes out, an emulated device behind. No sockets
/// here.
///
///     list and import requests (as `usbip` sends them) -> submit and unlink (as the kernel's vhci-hcd does)
///
/// A read that the device cannot answer yet waits here until it can or is unlinked.
/// @note One thread.
/// @see Linux, Documentation/usb/usbip_protocol.rst
class UsbIpServer {
public:
  static constexpr std::size_t kLongestTransfer = 65536;
  static constexpr std::size_t kMostWaiting = 64;

  /// @param imported the other end is the kernel already: no import request comes.
  UsbIpServer(UsbDeviceModel& device, bool imported) : m_device(device), m_imported(imported) {}

  /// @return false: these bytes are no USB/IP, or more than any kernel asks; close the connection.
  bool receive(std::span<const std::uint8_t> bytes);
  void advance(double now); ///< lets the device work and answers waiting reads
  std::vector<std::uint8_t>& output() noexcept { return m_out; } ///< to be sent and then cleared
  bool imported() const noexcept { return m_imported; }
  std::uint64_t transfers() const noexcept { return m_transfers; }

private:
  struct Read {
    std::uint32_t sequence = 0;
    std::size_t size = 0;
  };

  /// @return bytes used, 0: more must come first, -1: nonsense.
  std::ptrdiff_t takeRequest(std::span<const std::uint8_t> bytes);
  std::ptrdiff_t takeCommand(std::span<const std::uint8_t> bytes);
  bool submit(std::span<const std::uint8_t> header, std::span<const std::uint8_t> data);
  void unlink(std::span<const std::uint8_t> header);
  void serveReads();
  void reply(std::uint32_t command, std::uint32_t sequence, std::int32_t status, std::size_t length);
  void putDevice(bool withInterfaces);
  void put16(std::uint16_t value);
  void put32(std::uint32_t value);

  UsbDeviceModel& m_device;
  bool m_imported;
  std::vector<std::uint8_t> m_in, m_out;
  std::deque<Read> m_reads;
  std::uint64_t m_transfers = 0;
};

} // namespace esm
