// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/protocol/falcon_packet.h"

#include <algorithm>
#include <cmath>

namespace esm::falcon {

namespace {

constexpr std::uint8_t kOpen = '<', kClose = '>', kZero = 'A';
constexpr std::size_t kStateAt = 13, kSpareAt = 14, kCloseAt = 15;
constexpr std::uint8_t kHomingBit = 0x1;

Packet encode(const std::array<std::int16_t, 3>& words, std::uint8_t state) noexcept
{
  Packet packet;
  packet.front() = kOpen;
  for (std::size_t i = 0; i < 12; ++i) {
    const auto word = static_cast<std::uint16_t>(words[i / 4]);
    packet[1 + i] = static_cast<std::uint8_t>(kZero + (word >> (4 * (i % 4)) & 0xf));
  }
  packet[kStateAt] = static_cast<std::uint8_t>(kZero + state);
  packet[kSpareAt] = kZero;
  packet[kCloseAt] = kClose;
  return packet;
}

std::array<std::int16_t, 3> words(std::span<const std::uint8_t, kPacketSize> packet) noexcept
{
  std::array<std::int16_t, 3> found{};
  for (std::size_t i = 0; i < 3; ++i) {
    unsigned word = 0;
    for (std::size_t k = 0; k < 4; ++k) word |= (packet[1 + 4 * i + k] - unsigned{kZero}) << (4 * k);
    found[i] = static_cast<std::int16_t>(word);
  }
  return found;
}

bool fits(std::size_t place, std::uint8_t byte) noexcept
{
  if (place == 0) return byte == kOpen;
  if (place == kCloseAt) return byte == kClose;
  const int most = place == kStateAt ? 0x7f : 0xf;
  return byte >= kZero && byte <= kZero + most;
}

} // namespace

Packet encode(const Command& command) noexcept
{
  const int state = (command.leds & 0xe) | (command.homing ? kHomingBit : 0);
  return encode(command.motor, static_cast<std::uint8_t>(state));
}

Packet encode(const Reply& reply) noexcept
{
  return encode(reply.encoder, static_cast<std::uint8_t>((reply.homed & 7) << 4 | (reply.buttons & 0xf)));
}

bool decode(std::span<const std::uint8_t, kPacketSize> packet, Command& command) noexcept
{
  for (std::size_t i = 0; i < kPacketSize; ++i)
    if (!fits(i, packet[i])) return false;
  const int state = packet[kStateAt] - kZero;
  command = {words(packet), static_cast<std::uint8_t>(state & 0xe), (state & kHomingBit) != 0};
  return true;
}

std::array<std::int16_t, 3> motorWords(const Eigen::Vector3d& torques) noexcept
{
  std::array<std::int16_t, 3> motor{};
  const double largest = torques.cwiseAbs().maxCoeff();
  if (!torques.allFinite() || !(largest > 0.0)) return motor;
  // First the direction, then the size: no product on the way can overflow.
  const double size = std::min(largest, kFullScale / kUnitsPerTorque) * kUnitsPerTorque;
  for (std::size_t i = 0; i < 3; ++i)
    motor[i] = static_cast<std::int16_t>(std::lround(torques[static_cast<Eigen::Index>(i)] / largest * size));
  return motor;
}

bool StreamParser::push(std::uint8_t byte) noexcept
{
  if (m_count == kPacketSize) m_count = 0;
  if (!fits(m_count, byte)) {
    m_dropped += m_count + (byte == kOpen ? 0 : 1);
    m_count = 0;
    if (byte != kOpen) return false;
  }
  m_bytes[m_count++] = byte;
  return m_count == kPacketSize;
}

Reply StreamParser::reply() const noexcept
{
  const int state = m_bytes[kStateAt] - kZero;
  return {words(m_bytes), static_cast<std::uint8_t>(state >> 4 & 7), static_cast<std::uint8_t>(state & 0xf)};
}

} // namespace esm::falcon
