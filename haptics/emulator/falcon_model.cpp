// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/emulator/falcon_model.h"

#include "haptics/protocol/ftdi.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace esm {

namespace {

constexpr std::array<std::uint8_t, 2> kModemStatus{0x01, 0x60};
constexpr double kOutHome = 0.03, kInHome = -0.03; ///< ways of the grip that home it [m]

UsbDeviceModel::Identity describeFalcon()
{
  UsbDeviceModel::Identity id;
  id.vendor = 0x0403;
  id.product = 0xcb48;
  return id;
}

} // namespace

FalconModel::FalconModel(const Settings& settings, std::unique_ptr<Hand> hand)
  : UsbDeviceModel(describeFalcon()),
    m_settings(settings),
    m_grip(settings.mechanics, std::move(hand)),
    m_pose(settings.origin),
    m_running(settings.running),
    m_out(settings.homed),
    m_in(settings.homed)
{
  m_mechanism.inverse(m_pose, m_angles);
}

int FalconModel::ownControl(const UsbSetup& setup, std::span<std::uint8_t>)
{
  if (setup.requestType != ftdi::kVendorOut) return kStall;
  switch (setup.request) {
  case ftdi::kReset:
    if (setup.value == 1) m_queue.clear();
    break;
  case ftdi::kDivisor:
    m_divisor = setup.value;
    m_hello.clear();
    if (m_divisor == ftdi::k142857Baud.value) {
      m_ready = false;
      m_uploaded = 0;
    }
    if (m_divisor == ftdi::k1500000Baud.value && m_uploaded == m_settings.imageSize) m_running = true;
    break;
  case ftdi::kLatency:
    m_latency = 0.001 * setup.value;
    break;
  default:
    break;
  }
  return 0;
}

bool FalconModel::out(std::span<const std::uint8_t> bytes)
{
  if (m_settings.dead) return true;
  for (const std::uint8_t byte : bytes) {
    if (!m_running)
      boot(byte);
    else if (m_divisor == ftdi::k1500000Baud.value && m_parser.push(byte))
      obey();
  }
  return true;
}

void FalconModel::boot(std::uint8_t byte)
{
  if (m_divisor == ftdi::k9600Baud.value) {
    m_hello.push_back(byte);
    if (byte != 0x0d) return;
    if (m_hello == std::vector<std::uint8_t>{0x0a, 0x43, 0x0d})
      answer(std::array<std::uint8_t, 4>{0x0a, 0x44, 0x2c, 0x0d});
    m_hello.clear();
  } else if (m_divisor == ftdi::k142857Baud.value) {
    const bool wrong = m_ready && m_settings.wrongEchoes > 0 && m_uploaded == m_settings.imageSize / 2;
    if (wrong) --m_settings.wrongEchoes;
    answer(std::array<std::uint8_t, 1>{wrong ? static_cast<std::uint8_t>(byte ^ 1) : byte});
    if (m_ready) ++m_uploaded;
    m_ready = true;
  }
}

void FalconModel::obey()
{
  if (!falcon::decode(m_parser.packet(), m_command)) return;
  ++m_commands;
  const Eigen::Vector3d words(m_command.motor[0], m_command.motor[1], m_command.motor[2]);
  m_zeros = words.isZero(0.0) ? m_zeros + 1 : 0;
  if (!m_command.homing) m_out = m_in = false;
  const bool homed = m_out && m_in;
  Eigen::Matrix3d jacobian;
  m_force.setZero();
  if (m_mechanism.jacobian(m_pose, m_angles, jacobian))
    m_force = jacobian.transpose() * words / falcon::kUnitsPerTorque;
  m_grip.write(m_force);

  falcon::Reply reply;
  const Eigen::Vector3d counts = m_mechanism.countsOfAngles(m_angles);
  for (std::size_t i = 0; i < 3; ++i) {
    const long offset = homed ? 0 : m_settings.unhomedOffset;
    reply.encoder[i] = static_cast<std::int16_t>(
      std::clamp(std::lround(counts[static_cast<Eigen::Index>(i)]) + offset, -32768L, 32767L));
  }
  reply.homed = homed ? falcon::kHomedAll : std::uint8_t{0};
  reply.buttons = m_buttons;
  answer(falcon::encode(reply));
}

void FalconModel::advance(double now)
{
  if (!m_started) m_statusAt = now;
  m_started = true;
  m_now = now;
  DeviceSample sample;
  m_grip.read(now, sample);
  const Eigen::Vector3d wanted = sample.position + m_settings.origin;
  if (m_mechanism.inverse(wanted, m_angles)) m_pose = wanted; // at the end of its reach the grip stays
  if (m_running && sample.position.z() > kOutHome) m_out = true;
  if (m_running && m_out && sample.position.z() < kInHome) m_in = true;
}

int FalconModel::in(std::span<std::uint8_t> bytes)
{
  if (m_queue.empty() && m_now - m_statusAt < m_latency) return kNothingYet;
  m_statusAt = m_now;
  const std::size_t room = std::min(bytes.size(), ftdi::kPacketSize);
  if (room < kModemStatus.size()) return kStall;
  std::copy(kModemStatus.begin(), kModemStatus.end(), bytes.begin());
  const std::size_t count = std::min(room - kModemStatus.size(), m_queue.size());
  const auto end = m_queue.begin() + static_cast<std::ptrdiff_t>(count);
  std::copy(m_queue.begin(), end, bytes.begin() + kModemStatus.size());
  m_queue.erase(m_queue.begin(), end);
  return static_cast<int>(kModemStatus.size() + count);
}

} // namespace esm
