// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/device/driven_device.h"

#include "haptics/exit_guard.h"
#include "haptics/thread_priority.h"

#include <algorithm>
#include <utility>

namespace esm {

namespace {

constexpr double kLongestWait = 0.002; ///< [s]; drivers have deadlines of their own

}

DrivenDevice::DrivenDevice(std::unique_ptr<DeviceDriver> driver, Drive drive)
  : m_driver(std::move(driver)), m_drive(drive)
{
  if (m_drive == Drive::OwnThread)
    m_thread = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

DrivenDevice::~DrivenDevice()
{
  if (m_drive == Drive::Inline) {
    m_driver->close(m_now);
    return;
  }
  m_thread.request_stop();
  m_driver->wakeup().post();
  m_thread.join();
}

void DrivenDevice::step(double now, const Eigen::Vector3d& force, bool fresh) noexcept
{
  if (m_homeWanted.exchange(false, std::memory_order_relaxed)) m_driver->requestHome();
  m_driver->step(now, force, fresh);
  m_states.back() = m_driver->state();
  m_states.publish();
  const DeviceReport& report = m_driver->state().report;
  m_phase.store(report.phase, std::memory_order_relaxed);
  m_progress.store(report.progress, std::memory_order_relaxed);
  m_reason.store(report.reason, std::memory_order_relaxed);
  m_unhomed.store(report.unhomed, std::memory_order_relaxed);
}

void DrivenDevice::run(const std::stop_token& stop) noexcept
{
  raiseThreadPriority();
  SteadyClock clock;
  runUntil(stop, clock);
  m_driver->close(clock.now());
}

void DrivenDevice::runUntil(const std::stop_token& stop, SteadyClock& clock) noexcept
{
  const LastWords words([](void* driver) noexcept { static_cast<DeviceDriver*>(driver)->sendLastZero(); },
                        m_driver.get());
  std::uint64_t seen = 0;
  double commandAt = clock.now();
  while (!stop.stop_requested()) {
    m_driver->wakeup().wait(kLongestWait);
    const Force& newest = m_force.latest();
    const double now = clock.now();
    const bool fresh = newest.sequence != seen;
    seen = newest.sequence;
    if (fresh) commandAt = now;
    const bool silent = now - commandAt > kCommandTimeout;
    step(now, silent ? Eigen::Vector3d(Eigen::Vector3d::Zero()) : newest.newtons, fresh);
  }
}

DeviceLink DrivenDevice::read(double time, DeviceSample& sample) noexcept
{
  if (m_drive == Drive::Inline) {
    m_now = time;
    step(time, m_force.latest().newtons, false);
  }
  const DriverState& state = m_states.latest();
  m_lost = m_lost || state.link == DeviceLink::Lost;
  if (m_lost) return DeviceLink::Lost;
  if (state.link == DeviceLink::NeedsHome) return state.link;
  if (time - state.heard > kQuietPeriods * profile().period) return DeviceLink::NoReply;
  sample = state.sample;
  sample.age = std::max(time - state.heard, 0.0);
  return state.link;
}

bool DrivenDevice::write(const Eigen::Vector3d& force) noexcept
{
  if (m_lost || !force.allFinite()) return false;
  m_force.back() = {force, ++m_sequence};
  m_force.publish();
  if (m_drive == Drive::Inline)
    step(m_now, m_force.latest().newtons, true);
  else
    m_driver->wakeup().post();
  return true;
}

DeviceReport DrivenDevice::report() const noexcept
{
  return {m_phase.load(std::memory_order_relaxed), m_progress.load(std::memory_order_relaxed),
          m_reason.load(std::memory_order_relaxed), m_unhomed.load(std::memory_order_relaxed)};
}

} // namespace esm
