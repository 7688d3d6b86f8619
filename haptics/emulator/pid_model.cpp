// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/emulator/pid_model.h"

#include "haptics/emulator/pid_model_descriptor.h"
#include "haptics/kinematics/planar2.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace esm {

namespace {

using pid::usage;

UsbDeviceModel::Identity describePid(bool noOutEndpoint)
{
  UsbDeviceModel::Identity id;
  id.vendor = 0x1209; // pid.codes, for tests only
  id.product = 0x0001;
  id.interrupt = true;
  id.endpointOut = 0x01;
  id.noOutEndpoint = noOutEndpoint;
  id.hidDescriptor.assign(kPidModelDescriptor.begin(), kPidModelDescriptor.end());
  return id;
}

} // namespace

PidModel::PidModel(const Settings& settings, std::unique_ptr<Hand> hand)
  : UsbDeviceModel(describePid(settings.noOutEndpoint)),
    m_settings(settings),
    m_descriptor(std::make_unique<hid::ReportDescriptor>()),
    m_grip(settings.mechanics, std::move(hand)),
    m_busy(settings.busyAnswers)
{
  m_descriptor->parse(kPidModelDescriptor);
  m_layout.find(*m_descriptor);
}

int PidModel::effects() const noexcept
{
  return static_cast<int>(
    std::count_if(m_effects.begin(), m_effects.end(), [](const Effect& e) { return e.used; }));
}

int PidModel::runningEffects() const noexcept
{
  return static_cast<int>(
    std::count_if(m_effects.begin(), m_effects.end(), [](const Effect& e) { return e.started; }));
}

PidModel::Effect* PidModel::effect(std::span<const std::uint8_t> report, const hid::Slot& block)
{
  const std::int32_t index = hid::getValue(report, block);
  if (index < 1 || index > static_cast<std::int32_t>(m_effects.size())) return nullptr;
  Effect& found = m_effects[static_cast<std::size_t>(index) - 1];
  return found.used ? &found : nullptr;
}

bool PidModel::out(std::span<const std::uint8_t> bytes)
{
  return take(bytes);
}

bool PidModel::take(std::span<const std::uint8_t> report)
{
  if (report.empty()) return false;
  const std::uint8_t id = report[0];
  const pid::Layout& l = m_layout;
  if (id == l.constant.magnitude.reportId) {
    Effect* e = effect(report, l.constant.block);
    if (!e) return true;
    e->magnitude = hid::getValue(report, l.constant.magnitude);
    ++m_reports;
    m_zeros = e->magnitude == 0 ? m_zeros + 1 : 0;
  } else if (id == l.effect.block.reportId) {
    Effect* e = effect(report, l.effect.block);
    if (!e) return true;
    const std::int32_t duration = hid::getValue(report, l.effect.duration);
    e->duration = duration == 0xffff ? 1e9 : 0.001 * duration;
    e->direction = 2.0 * std::numbers::pi * hid::getValue(report, l.effect.direction[0]) /
                   (static_cast<double>(l.effect.direction[0].logicalMax) + 1.0);
  } else if (id == l.operation.block.reportId) {
    Effect* e = effect(report, l.operation.block);
    if (!e) return true;
    e->started = l.operation.what.get(report) != usage(0x7b);
    e->startedAt = m_now;
  } else if (id == l.blockFree.reportId) {
    if (Effect* e = effect(report, l.blockFree)) *e = {};
  } else if (id == l.control.slot.reportId) {
    const hid::Usage what = l.control.get(report);
    if (what == usage(0x97)) m_enabled = true;
    if (what == usage(0x98)) m_enabled = false;
    if (what == usage(0x9a)) m_effects = {};
    if (what == usage(0x99))
      for (Effect& e : m_effects) e.started = false;
  }
  return true;
}

void PidModel::create()
{
  m_created = 0;
  if (m_settings.full) return;
  for (std::size_t i = 0; i < m_effects.size() && m_created == 0; ++i) {
    if (m_effects[i].used) continue;
    m_effects[i] = {};
    m_effects[i].used = true;
    m_created = static_cast<int>(i) + 1;
  }
}

int PidModel::ownControl(const UsbSetup& setup, std::span<std::uint8_t> data)
{
  constexpr std::uint8_t kGetReport = 1, kSetReport = 9, kSetIdle = 10, kSetProtocol = 11;
  const int type = setup.value >> 8, id = setup.value & 0xff;
  if (setup.request == kSetIdle || setup.request == kSetProtocol) return 0;
  if (setup.request == kSetReport && type == 2) return take(data) ? static_cast<int>(data.size()) : kStall;
  if (setup.request == kSetReport && type == 3 && !data.empty() && id == m_layout.create.type.slot.reportId) {
    create();
    return static_cast<int>(data.size());
  }
  if (setup.request != kGetReport || type != 3) return kStall;
  // Whole first: the host may ask for fewer bytes than the report has.
  std::array<std::uint8_t, hid::ReportDescriptor::kMostReportBytes> room{};
  const auto report =
    std::span(room).first(m_descriptor->reportBytes(hid::ReportType::Feature, static_cast<std::uint8_t>(id)));
  if (report.empty() || data.empty()) return kStall;
  report[0] = static_cast<std::uint8_t>(id);
  if (id == m_layout.blockLoad.block.reportId) {
    if (m_busy > 0) {
      --m_busy; // block 0, no status: not yet
    } else {
      hid::putValue(report, m_layout.blockLoad.block, m_created);
      m_layout.blockLoad.status.put(report, m_created > 0 ? usage(0x8c) : usage(0x8d));
    }
  } else if (id == kPidModelPoolReport) {
    report[1] = 0xff; // RAM
    report[2] = 0x7f;
    report[3] = static_cast<std::uint8_t>(m_effects.size());
    report[4] = 1; // the device manages its memory
  }
  const std::size_t count = std::min(data.size(), report.size());
  std::copy_n(report.begin(), count, data.begin());
  return static_cast<int>(count);
}

void PidModel::advance(double now)
{
  m_now = now;
  m_force.setZero();
  for (Effect& e : m_effects) {
    if (e.started && now - e.startedAt > e.duration) e.started = false;
    if (!e.started || !m_enabled) continue;
    const double size = m_settings.newtonsAtFull * e.magnitude / m_layout.constant.magnitude.logicalMax;
    // As the wind: from the direction named. North is away from the user, y of the scene.
    m_force += size * Eigen::Vector3d(-std::sin(e.direction), -std::cos(e.direction), 0.0);
  }
  m_grip.write(m_force);
  DeviceSample sample;
  m_grip.read(now, sample);
  m_position = sample.position;
}

std::int32_t PidModel::axisValue(int axis) const noexcept
{
  const Planar2 plane{m_settings.stroke, m_settings.newtonsAtFull};
  const double share = std::clamp(plane.axes(m_position)[axis], -1.0, 1.0);
  return hid::scaled(m_layout.axes[static_cast<std::size_t>(axis)], share);
}

int PidModel::in(std::span<std::uint8_t> bytes)
{
  const std::array<std::int32_t, 2> now{axisValue(0), axisValue(1)};
  if (now == m_told) return kNothingYet; // as sticks do: only when something has changed
  const std::size_t size = m_descriptor->reportBytes(hid::ReportType::Input, m_layout.axes[0].reportId);
  if (bytes.size() < size) return kStall;
  m_told = now;
  const auto report = bytes.first(size);
  std::fill(report.begin(), report.end(), std::uint8_t{0});
  report[0] = m_layout.axes[0].reportId;
  for (std::size_t i = 0; i < 2; ++i) hid::putValue(report, m_layout.axes[i], now[i]);
  return static_cast<int>(size);
}

} // namespace esm
