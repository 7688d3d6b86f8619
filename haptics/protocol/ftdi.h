// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "haptics/protocol/usb_setup.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

/// Vendor requests of the FTDI bridge chip, and the two status bytes that open each of its IN packets.
namespace esm::ftdi {

constexpr std::uint8_t kVendorOut = 0x40;
enum Request : std::uint8_t { kReset = 0, kModem = 1, kFlow = 2, kDivisor = 3, kLine = 4, kLatency = 9 };

constexpr UsbSetup request(Request what, std::uint16_t value) noexcept
{
  return {kVendorOut, what, value, 0, 0};
}
constexpr UsbSetup kPurgeReceived = request(kReset, 1), kPurgeSent = request(kReset, 2);
constexpr UsbSetup kDtrLow = request(kModem, 0x0100), kDtrHigh = request(kModem, 0x0101);
constexpr UsbSetup kRtsLow = request(kModem, 0x0200);
constexpr UsbSetup kNoFlowControl = request(kFlow, 0);
constexpr UsbSetup k8N1 = request(kLine, 8);
constexpr UsbSetup latency(std::uint16_t milliseconds) noexcept
{
  return request(kLatency, milliseconds);
}
/// Baud rate = 3 MHz / divisor; bits 14 and 15 are eighths.
constexpr UsbSetup k9600Baud = request(kDivisor, 0x4138);
constexpr UsbSetup k142857Baud = request(kDivisor, 0x0015);
constexpr UsbSetup k1500000Baud = request(kDivisor, 0x0002);

constexpr std::size_t kPacketSize = 64; ///< full speed
constexpr std::size_t kStatusSize = 2;  ///< modem status at the start of each IN packet
constexpr std::size_t kPayloadSize = kPacketSize - kStatusSize;

/// Calls `take` with the payload of each packet in one IN transfer.
template <class Take>
void forEachPayload(std::span<const std::uint8_t> transfer, Take take)
{
  for (std::size_t at = 0; at < transfer.size(); at += kPacketSize) {
    const auto packet = transfer.subspan(at, std::min(kPacketSize, transfer.size() - at));
    if (packet.size() > kStatusSize) take(packet.subspan(kStatusSize));
  }
}

} // namespace esm::ftdi
