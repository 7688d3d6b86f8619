// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/device/pid_driver.h"

#include "haptics/zero_reports.h"

#include <algorithm>
#include <array>
#include <utility>

namespace esm {

namespace {

constexpr std::uint8_t kGetReport = 0x01, kGetDescriptor = 0x06, kSetReport = 0x09;
constexpr std::size_t kLongestDescriptor = 4096;
constexpr std::size_t kPidInSize = 64;
constexpr int kPidInTransfers = 2, kPidMostOut = 3;
constexpr double kOutTimeout = 0.02; ///< [s]; a device that takes no force for so long does not reply
constexpr int kOutWaits = 100;       ///< of kOutWait each, while opening and closing
constexpr double kOutWait = 0.001;   ///< [s]

} // namespace

PidDriver::PidDriver(DriverProfile profile, std::unique_ptr<Wakeup> wakeup, std::unique_ptr<UsbHandle> handle,
                     int interface)
  : m_profile(std::move(profile)),
    m_handle(std::move(handle)),
    m_interface(static_cast<std::uint16_t>(std::max(interface, 0))),
    m_plane{m_profile.stroke, m_profile.newtonsAtFull},
    m_descriptor(std::make_unique<hid::ReportDescriptor>()),
    m_session(std::make_unique<pid::Session>(m_layout, m_profile.quirks, *this))
{
  m_wakeup = std::move(wakeup);
  m_state.sample.position = -m_profile.origin;
  m_state.report = {DevicePhase::Opening, 0.0f, "Reading what the device can do"};
}

void PidDriver::fail(const char* reason) noexcept
{
  m_state.report = {DevicePhase::Fault, 0.0f, reason};
  m_state.link = DeviceLink::NeedsHome; // exactly 0 N
}

void PidDriver::lose() noexcept
{
  m_state.report = {DevicePhase::Lost, 0.0f, "The device was unplugged"};
  m_state.link = DeviceLink::Lost;
}

bool PidDriver::control(const UsbSetup& setup, std::span<std::uint8_t> data) noexcept
{
  const UsbOutcome outcome = m_handle->control(setup, data);
  return outcome.status == UsbStatus::Ok && outcome.length == data.size();
}

bool PidDriver::setFeature(std::span<const std::uint8_t> report) noexcept
{
  std::array<std::uint8_t, hid::ReportDescriptor::kMostReportBytes> bytes{};
  std::copy(report.begin(), report.end(), bytes.begin());
  const auto id = static_cast<std::uint16_t>(m_layout.numbered ? report[0] : 0);
  const auto value = static_cast<std::uint16_t>(3 << 8 | id);
  return control({0x21, kSetReport, value, m_interface, static_cast<std::uint16_t>(report.size())},
                 {bytes.data(), report.size()});
}

bool PidDriver::getFeature(std::uint8_t id, std::span<std::uint8_t> report) noexcept
{
  const auto value = static_cast<std::uint16_t>(3 << 8 | id);
  return control({0xa1, kGetReport, value, m_interface, static_cast<std::uint16_t>(report.size())}, report);
}

UsbSetup PidDriver::outputSetup(std::span<const std::uint8_t> report) const noexcept
{
  const auto value = static_cast<std::uint16_t>(2 << 8 | (m_layout.numbered ? report[0] : 0));
  return {0x21, kSetReport, value, m_interface, static_cast<std::uint16_t>(report.size())};
}

bool PidDriver::output(std::span<const std::uint8_t> report) noexcept
{
  if (m_handle->endpoints().out == 0) { // by control, then
    std::array<std::uint8_t, hid::ReportDescriptor::kMostReportBytes> bytes{};
    std::copy(report.begin(), report.end(), bytes.begin());
    return control(outputSetup(report), {bytes.data(), report.size()});
  }
  if (m_outUnderWay >= kPidMostOut || !m_handle->submitOut(report)) return false;
  if (m_outUnderWay++ == 0) m_outSince = m_now;
  return !m_waits || waitForOut();
}

bool PidDriver::waitForOut() noexcept
{
  m_outFailed = false;
  for (int i = 0; i < kOutWaits && m_outUnderWay > 0; ++i) {
    drain(m_now);
    if (m_outUnderWay > 0) m_wakeup->wait(kOutWait);
  }
  const bool done = m_outUnderWay == 0 && !m_outFailed;
  m_outUnderWay = 0;
  return done;
}

void PidDriver::open(double now) noexcept
{
  std::array<std::uint8_t, kLongestDescriptor> bytes;
  const UsbSetup setup{0x81, kGetDescriptor, 0x2200, m_interface, kLongestDescriptor};
  const UsbOutcome outcome = m_handle->control(setup, bytes);
  if (outcome.status == UsbStatus::Lost) return lose();
  if (outcome.status != UsbStatus::Ok) return fail("The device does not describe its reports");
  if (m_descriptor->parse({bytes.data(), outcome.length}) != hid::Flaw::None)
    return fail("The device describes its reports in a way that makes no sense");
  if (m_layout.find(*m_descriptor)) return fail("The device has no constant force that a program can set");
  if (m_session->open(now))
    return m_handle->lost() ? lose() : fail("The device does not take a force effect");
  m_waits = false;
  m_state.report = {DevicePhase::Running, 1.0f, ""};
  m_state.link = DeviceLink::Ready;
  m_state.heard = now;
}

void PidDriver::step(double now, const Eigen::Vector3d& force, bool) noexcept
{
  m_now = now;
  if (m_state.report.phase == DevicePhase::Lost) return;
  if (!m_started) {
    m_started = true;
    open(now);
    keepListening();
  }
  drain(now);
  if (m_handle->lost()) return lose();
  if (m_state.report.phase != DevicePhase::Running) return;
  const bool stuck = m_outUnderWay > 0 && now - m_outSince > kOutTimeout;
  if (m_session->setForce(now, m_plane.command(force)) && !m_outFailed && !stuck) m_state.heard = now;
  m_outFailed = false;
}

void PidDriver::keepListening() noexcept
{
  while (m_listening < kPidInTransfers && m_handle->submitIn(kPidInSize)) ++m_listening;
}

void PidDriver::drain(double now) noexcept
{
  while (m_handle->take(now, m_completion)) {
    if (m_completion.status == UsbStatus::Lost) return lose();
    const bool good = m_completion.status == UsbStatus::Ok;
    if (m_completion.endpoint == m_handle->endpoints().in) {
      m_listening = std::max(m_listening - 1, 0);
      if (good) take(m_completion.data(), now);
      keepListening();
    } else {
      m_outUnderWay = std::max(m_outUnderWay - 1, 0);
      m_outSince = now;
      m_outFailed = m_outFailed || !good;
    }
  }
}

void PidDriver::take(std::span<const std::uint8_t> report, double) noexcept
{
  if (report.empty()) return;
  for (std::size_t i = 0; i < 2; ++i) {
    const hid::Slot& slot = m_layout.axes[i];
    if (!slot.present() || (m_layout.numbered && report[0] != slot.reportId)) continue;
    m_axes[static_cast<Eigen::Index>(i)] = hid::centred(slot, hid::getValue(report, slot));
  }
  for (std::size_t i = 0; i < m_layout.buttons.size(); ++i) {
    const hid::Slot& slot = m_layout.buttons[i];
    if (!slot.present() || (m_layout.numbered && report[0] != slot.reportId)) continue;
    const std::uint32_t bit = 1u << i;
    m_state.sample.buttons =
      hid::getValue(report, slot) != 0 ? m_state.sample.buttons | bit : m_state.sample.buttons & ~bit;
  }
  m_state.sample.position = m_plane.position(m_axes) - m_profile.origin;
}

void PidDriver::close(double now) noexcept
{
  if (!m_handle) return;
  m_now = now;
  m_waits = true;
  m_outUnderWay = 0;
  if (m_state.report.phase != DevicePhase::Lost) m_session->close();
  m_handle.reset();
  lose();
  m_state.report.reason = "Closed";
}

void PidDriver::sendLastZero() noexcept
{
  if (m_state.report.phase != DevicePhase::Running) return;
  std::array<std::uint8_t, hid::ReportDescriptor::kMostReportBytes> bytes{};
  for (int i = 0; i < kZeroReports; ++i)
    for (int axis = 0; axis < m_session->axes(); ++axis) {
      const std::span<const std::uint8_t> report = m_session->zeroReport(axis, bytes);
      m_handle->sendAtLast(outputSetup(report), report);
    }
}

} // namespace esm
