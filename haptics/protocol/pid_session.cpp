// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/protocol/pid_session.h"

#include "haptics/zero_reports.h"

#include <algorithm>
#include <cmath>

namespace esm::pid {

namespace {

constexpr hid::Usage kConstantForce = usage(0x26);
constexpr hid::Usage kStart = usage(0x79), kStop = usage(0x7b);
constexpr hid::Usage kEnable = usage(0x97), kDisable = usage(0x98), kStopAll = usage(0x99),
                     kReset = usage(0x9a);
constexpr hid::Usage kLoaded = usage(0x8c), kFull = usage(0x8d), kError = usage(0x8e);
constexpr double kRateTolerance = 1e-4; ///< [s]; a tick of 1 ms that comes a little early is not too early

/// Milliseconds unless the descriptor names another power of ten of a second.
std::int64_t timeValue(const hid::Slot& slot, double seconds) noexcept
{
  const int exponent = slot.decimalExponent == 0 ? -3 : slot.decimalExponent;
  return std::llround(seconds * std::pow(10.0, -exponent));
}

std::span<std::uint8_t> blankIn(std::span<std::uint8_t> room, bool numbered, std::uint8_t id,
                                std::size_t bytes) noexcept
{
  const std::span<std::uint8_t> report = room.first(std::min(bytes, room.size()));
  std::fill(report.begin(), report.end(), std::uint8_t{0});
  if (numbered && !report.empty()) report[0] = id;
  return report;
}

} // namespace

std::span<std::uint8_t> Session::blank(const hid::Slot& any, std::size_t bytes) noexcept
{
  return blankIn(m_bytes, m_layout.numbered, any.reportId, bytes);
}

bool Session::control(hid::Usage what) noexcept
{
  if (!m_layout.control.has(what)) return true; // many have no such report and are always on
  const auto report = blank(m_layout.control.slot, m_layout.controlBytes);
  m_layout.control.put(report, what, m_quirks.controlFromOne);
  return m_port.output(report);
}

const char* Session::open(double now) noexcept
{
  m_axes = 0;
  m_effects = {};
  // Reset clears what a program before us has left. Some devices answer it by standing still for a while: no
  // reason to give up.
  control(kReset);
  control(kStopAll);
  if (!control(kEnable)) return "it does not switch its motors on";
  if (m_layout.deviceGain.present()) {
    const auto report = blank(m_layout.deviceGain, m_layout.deviceGainBytes);
    hid::putValue(report, m_layout.deviceGain, m_layout.deviceGain.logicalMax);
    if (!m_port.output(report)) return "it does not take its gain";
  }
  m_open = true;
  const int wanted = m_layout.axes[1].present() ? 2 : 1;
  for (int axis = 0; axis < wanted; ++axis) {
    if (const char* trouble = createEffect(axis)) {
      if (axis > 0) break; // a wheel with a second input but one motor
      close();
      return trouble;
    }
    m_axes = axis + 1;
  }
  m_restartAt = now + kRestart;
  return nullptr;
}

const char* Session::createEffect(int axis) noexcept
{
  const auto report = blank(m_layout.create.type.slot, m_layout.createBytes);
  m_layout.create.type.put(report, kConstantForce);
  hid::putValue(report, m_layout.create.bytes, 0);
  if (!m_port.setFeature(report)) return "it does not create an effect";
  if (!pollBlock(axis)) return "it has no room for a constant force";
  if (!setEffect(axis)) return "it does not take the effect";
  if (!sendMagnitude(axis, 0)) return "it does not take a constant force";
  if (!operate(axis, kStart, 1)) return "it does not start the effect";
  return nullptr;
}

bool Session::pollBlock(int axis) noexcept
{
  Effect& effect = m_effects[static_cast<std::size_t>(axis)];
  if (m_quirks.noBlockLoadAnswer) {
    effect = {static_cast<std::uint8_t>(axis + 1), 0, 0.0, true};
    return true;
  }
  for (int i = 0; i < kMostPolls; ++i) {
    const auto report = blank(m_layout.blockLoad.block, m_layout.blockLoadBytes);
    if (!m_port.getFeature(m_layout.blockLoad.block.reportId, report)) continue;
    const hid::Usage status = m_layout.blockLoad.status.get(report);
    if (status == kFull || status == kError) return false;
    const std::int32_t block = hid::getValue(report, m_layout.blockLoad.block);
    if (status != kLoaded || block < 1 || block > 255) continue;
    effect = {static_cast<std::uint8_t>(block), 0, 0.0, true};
    return true;
  }
  return false;
}

bool Session::setEffect(int axis) noexcept
{
  const Layout::SetEffect& e = m_layout.effect;
  const auto report = blank(e.block, m_layout.effectBytes);
  hid::putValue(report, e.block, m_effects[static_cast<std::size_t>(axis)].block);
  e.type.put(report, kConstantForce);
  hid::putValue(report, e.duration, m_quirks.endlessEffects ? 0xffff : timeValue(e.duration, kDuration));
  hid::putValue(report, e.samplePeriod, 0);
  hid::putValue(report, e.gain, e.gain.logicalMax);
  hid::Slot noButton = e.triggerButton;
  noButton.logicalMin = noButton.logicalMax = 0; // none is a value outside its range: written as it is
  hid::putValue(report, noButton, 0);
  hid::putValue(report, e.startDelay, 0);
  // By direction where the device has one, since some ignore axis bits: 90 degrees is east, along X; 0 is
  // north.
  const bool byDirection = e.directionEnable.present() && e.direction[0].present();
  hid::putValue(report, e.directionEnable, byDirection ? 1 : 0);
  if (byDirection) {
    const auto quarter = static_cast<std::int64_t>(
      std::llround(e.direction[0].logicalMin +
                   0.25 * (static_cast<double>(e.direction[0].logicalMax) - e.direction[0].logicalMin)));
    hid::putValue(report, e.direction[0], axis == 0 ? quarter : e.direction[0].logicalMin);
  }
  for (std::size_t i = 0; i < 2; ++i)
    hid::putValue(report, e.axisEnable[i], !byDirection && static_cast<int>(i) == axis ? 1 : 0);
  return m_port.output(report);
}

std::span<std::uint8_t> Session::magnitudeReport(int axis, std::int32_t value,
                                                 std::span<std::uint8_t> bytes) const noexcept
{
  const auto report =
    blankIn(bytes, m_layout.numbered, m_layout.constant.magnitude.reportId, m_layout.constantBytes);
  hid::putValue(report, m_layout.constant.block, m_effects[static_cast<std::size_t>(axis)].block);
  hid::putValue(report, m_layout.constant.magnitude, value);
  return report;
}

std::span<const std::uint8_t> Session::zeroReport(int axis, std::span<std::uint8_t> bytes) const noexcept
{
  return magnitudeReport(axis, 0, bytes);
}

bool Session::sendMagnitude(int axis, std::int32_t value) noexcept
{
  return m_port.output(magnitudeReport(axis, value, m_bytes));
}

bool Session::operate(int axis, hid::Usage what, int loops) noexcept
{
  const auto report = blank(m_layout.operation.block, m_layout.operationBytes);
  hid::putValue(report, m_layout.operation.block, m_effects[static_cast<std::size_t>(axis)].block);
  m_layout.operation.what.put(report, what);
  hid::putValue(report, m_layout.operation.loops, loops);
  return m_port.output(report);
}

bool Session::setForce(double now, const Eigen::Vector2d& share) noexcept
{
  bool taken = true;
  for (int axis = 0; axis < m_axes; ++axis) {
    Effect& effect = m_effects[static_cast<std::size_t>(axis)];
    const std::int32_t value =
      hid::scaled(m_layout.constant.magnitude, m_quirks.polarity[axis] * share[axis]);
    const bool toZero = share[axis] == 0.0 && effect.sent != value;
    const bool changed = std::abs(value - effect.sent) > 1;
    const bool early = now - effect.sentAt < 1.0 / m_quirks.updateRate - kRateTolerance;
    if (!toZero && (!changed || early)) continue;
    if (!sendMagnitude(axis, value)) {
      taken = false;
      continue;
    }
    effect.sent = value;
    effect.sentAt = now;
  }
  if (!m_quirks.endlessEffects && now >= m_restartAt) {
    for (int axis = 0; axis < m_axes; ++axis) taken = operate(axis, kStart, 1) && taken;
    m_restartAt = now + kRestart;
  }
  return taken;
}

void Session::close() noexcept
{
  if (!m_open) return;
  m_open = false;
  for (int axis = 0; axis < m_axes; ++axis) {
    for (int i = 0; i < kZeroReports; ++i) sendMagnitude(axis, 0);
    operate(axis, kStop, 0);
    if (!m_layout.blockFree.present()) continue;
    const auto report = blank(m_layout.blockFree, m_layout.blockFreeBytes);
    hid::putValue(report, m_layout.blockFree, m_effects[static_cast<std::size_t>(axis)].block);
    m_port.output(report);
  }
  m_axes = 0;
  control(kDisable);
}

} // namespace esm::pid
