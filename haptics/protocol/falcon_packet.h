// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

/// Run-mode packets of the Novint Falcon: 16 bytes each way, one reply per command, four bits in each data
/// byte.
///
///     '<'  12 nibbles: three int16, lowest nibble first, 0x41 + nibble  state  'A'  '>'
///
/// State to the device: 0x41 + (LEDs | homing); from it: 0x41 + (homed axes << 4 | buttons).
/// @note Pure; no allocation; any thread.
namespace esm::falcon {

constexpr std::size_t kPacketSize = 16;
using Packet = std::array<std::uint8_t, kPacketSize>;

enum Led : std::uint8_t { kGreen = 0x2, kBlue = 0x4, kRed = 0x8 };
enum Button : std::uint8_t { kPlus = 1, kForward = 2, kCentre = 4, kMinus = 8 };
constexpr std::uint8_t kHomedAll = 7;
constexpr int kFullScale = 4095; ///< of a motor; beyond it nothing is gained, and the word would wrap
constexpr double kUnitsPerTorque = 10000.0; ///< [1/(N m)], of an arm

struct Command {
  std::array<std::int16_t, 3> motor{};
  std::uint8_t leds = 0;
  bool homing = false; ///< in each packet, or the device forgets its home
};

struct Reply {
  std::array<std::int16_t, 3> encoder{};
  std::uint8_t homed = 0; ///< bits 1, 2, 4
  std::uint8_t buttons = 0;
};

Packet encode(const Command& command) noexcept;
Packet encode(const Reply& reply) noexcept; ///< for an emulated device
bool decode(std::span<const std::uint8_t, kPacketSize> packet, Command& command) noexcept;

/// Motor words for arm torques [N m]: if one is beyond full scale, all shrink by one factor, so that the
/// force keeps its direction. Anything that is not a number gives zero.
std::array<std::int16_t, 3> motorWords(const Eigen::Vector3d& torques) noexcept;

/// Finds packets in a stream of bytes. A byte that cannot stand where it stands ends the packet; '<' appears
/// nowhere within one, so the next packet is found whatever came before.
class StreamParser {
public:
  /// @return whether `byte` completes a packet; it is in packet() then.
  bool push(std::uint8_t byte) noexcept;
  std::span<const std::uint8_t, kPacketSize> packet() const noexcept { return m_bytes; }
  Reply reply() const noexcept;
  std::uint64_t dropped() const noexcept { return m_dropped; } ///< bytes that belonged to no packet

private:
  Packet m_bytes{};
  std::size_t m_count = 0;
  std::uint64_t m_dropped = 0;
};

} // namespace esm::falcon
