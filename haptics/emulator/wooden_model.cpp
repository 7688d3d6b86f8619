// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/emulator/wooden_model.h"

#include "haptics/protocol/wooden_packet.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace esm {

namespace {

/// Eight bytes in, eight out, maker's own usages.
const std::vector<std::uint8_t> kDescriptor{0x06, 0x00, 0xff, 0x09, 0x01, 0xa1, 0x01, 0x15, 0x00,
                                            0x26, 0xff, 0x00, 0x75, 0x08, 0x95, 0x08, 0x09, 0x02,
                                            0x81, 0x02, 0x09, 0x03, 0x91, 0x02, 0xc0};
constexpr double kReportPeriod = 0.001; ///< [s]

UsbDeviceModel::Identity describeWooden()
{
  UsbDeviceModel::Identity id;
  id.vendor = 0x1234;
  id.product = 0x0006;
  id.interrupt = true;
  id.endpointOut = 0x01;
  id.hidDescriptor = kDescriptor;
  return id;
}

} // namespace

WoodenModel::WoodenModel(const SimulatedDeviceSettings& mechanics, std::unique_ptr<Hand> hand)
  : UsbDeviceModel(describeWooden()), m_grip(mechanics, std::move(hand))
{
  m_arm.inverse(Eigen::Vector3d::Zero(), m_angles);
  m_start = m_arm.countsOfAngles(m_angles);
}

int WoodenModel::ownControl(const UsbSetup& setup, std::span<std::uint8_t> data)
{
  constexpr std::uint8_t kSetReport = 9, kSetIdle = 10;
  if (setup.request == kSetIdle) return 0;
  if (setup.request == kSetReport) return out(data) ? static_cast<int>(data.size()) : kStall;
  return kStall;
}

bool WoodenModel::out(std::span<const std::uint8_t> bytes)
{
  std::array<std::int16_t, 4> words{};
  if (!wooden::decode(bytes, words)) return false;
  ++m_reports;
  m_heard = m_now;
  Eigen::Vector3d amperes(words[0], words[1], words[2]);
  m_zeros = amperes.isZero(0.0) ? m_zeros + 1 : 0;
  amperes = (0.001 * amperes).cwiseMax(-wooden::kLargestCurrent).cwiseMin(wooden::kLargestCurrent);
  m_force = m_arm.forceOfCurrents(m_angles, amperes);
  return true;
}

void WoodenModel::advance(double now)
{
  m_now = now;
  if (now - m_heard > kWatchdog) m_force.setZero();
  m_grip.write(m_force);
  DeviceSample sample;
  m_grip.read(now, sample);
  m_arm.inverse(sample.position, m_angles);
}

int WoodenModel::in(std::span<std::uint8_t> bytes)
{
  if (m_now - m_toldAt < kReportPeriod - 1e-9) return kNothingYet;
  if (bytes.size() < wooden::kReportSize) return kStall;
  m_toldAt = m_now;
  std::array<std::int16_t, 4> words{};
  const Eigen::Vector3d counts = m_arm.countsOfAngles(m_angles) - m_start;
  for (std::size_t i = 0; i < 3; ++i)
    words[i] = static_cast<std::int16_t>(std::lround(counts[static_cast<Eigen::Index>(i)]));
  words[3] = m_counter++;
  const wooden::Report report = wooden::encode(words);
  std::copy(report.begin(), report.end(), bytes.begin());
  return wooden::kReportSize;
}

} // namespace esm
