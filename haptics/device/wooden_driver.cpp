// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/device/wooden_driver.h"

#include "haptics/zero_reports.h"

#include <algorithm>
#include <array>
#include <utility>

namespace esm {

namespace {

constexpr int kWoodenInTransfers = 2, kWoodenMostOut = 2;
constexpr std::size_t kWoodenInSize = 64;
constexpr double kWoodenResendAfter = 0.005; ///< [s]; reports that do not end are counted as gone

Serial3RGeometry geometryOf(const DriverProfile& profile)
{
  Serial3RGeometry geometry;
  geometry.origin = profile.origin;
  return geometry;
}

} // namespace

WoodenDriver::WoodenDriver(DriverProfile profile, std::unique_ptr<Wakeup> wakeup,
                           std::unique_ptr<UsbHandle> handle)
  : m_profile(std::move(profile)), m_handle(std::move(handle)), m_arm(geometryOf(m_profile))
{
  m_wakeup = std::move(wakeup);
  m_state.report = {DevicePhase::NeedsHome, 0.0f, "Put the grip to its home position, then press Home"};
}

void WoodenDriver::lose() noexcept
{
  m_state.report = {DevicePhase::Lost, 0.0f, "The device was unplugged"};
  m_state.link = DeviceLink::Lost;
}

void WoodenDriver::keepListening() noexcept
{
  while (m_listening < kWoodenInTransfers && m_handle->submitIn(kWoodenInSize)) ++m_listening;
}

void WoodenDriver::drain(double now) noexcept
{
  while (m_handle->take(now, m_completion)) {
    if (m_completion.status == UsbStatus::Lost) return lose();
    if (m_completion.endpoint != m_handle->endpoints().in) {
      m_outUnderWay = std::max(m_outUnderWay - 1, 0);
      continue;
    }
    m_listening = std::max(m_listening - 1, 0);
    if (m_completion.status == UsbStatus::Ok) take(m_completion.data(), now);
    keepListening();
  }
}

void WoodenDriver::take(std::span<const std::uint8_t> report, double now) noexcept
{
  std::array<std::int16_t, 4> words{};
  if (!wooden::decode(report, words)) return;
  const Eigen::Vector3d counts(words[0], words[1], words[2]);
  if (m_homeWanted) {
    Eigen::Vector3d home;
    if (m_arm.inverse(Eigen::Vector3d::Zero(), home)) {
      m_zero = counts - m_arm.countsOfAngles(home);
      m_homed = true;
      ++m_state.sample.epoch;
      m_state.report = {DevicePhase::Running, 1.0f, ""};
      m_state.link = DeviceLink::Ready;
    }
    m_homeWanted = false;
  }
  m_angles = m_arm.anglesOfCounts(counts - m_zero);
  m_state.sample.position = m_arm.forward(m_angles);
  m_state.heard = now;
}

void WoodenDriver::step(double now, const Eigen::Vector3d& force, bool fresh) noexcept
{
  if (m_state.report.phase == DevicePhase::Lost) return;
  keepListening();
  drain(now);
  if (m_handle->lost()) return lose();
  const double since = now - m_sentAt;
  if (!fresh && since < kKeepAlive) return;
  if (m_outUnderWay >= kWoodenMostOut && since < kWoodenResendAfter) return;
  std::array<std::int16_t, 4> words{};
  if (m_homed) words = wooden::currentWords(m_arm.currents(m_angles, force));
  const wooden::Report report = wooden::encode(words);
  m_sentAt = now;
  if (m_handle->submitOut(report)) ++m_outUnderWay;
}

void WoodenDriver::close(double now) noexcept
{
  if (!m_handle) return;
  if (m_state.report.phase != DevicePhase::Lost) {
    const wooden::Report zero{};
    for (int i = 0; i < kZeroReports; ++i) {
      m_handle->submitOut(zero);
      m_wakeup->wait(0.003);
      while (m_handle->take(now, m_completion)) {
      }
    }
  }
  m_handle.reset();
  lose();
  m_state.report.reason = "Closed";
}

void WoodenDriver::sendLastZero() noexcept
{
  const wooden::Report zero{};
  for (int i = 0; i < kZeroReports; ++i) m_handle->sendAtLast({}, zero);
}

} // namespace esm
