// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/arming.h"

#include <algorithm>

namespace esm {

void Arming::obey(std::uint32_t orderWord) noexcept
{
  if (orderWord == m_seen) return;
  m_seen = orderWord;
  switch (ForceOrders::orderOf(orderWord)) {
  case ForceOrder::Disarm:
    m_wanted = false;
    break;
  case ForceOrder::Stop:
    fail(ServoReason::EmergencyStop);
    break;
  case ForceOrder::Arm:
    if (m_fault == ServoReason::DeviceLost || m_fault == ServoReason::Closed) break;
    m_fault = ServoReason::Plain;
    m_silence = 0.0;
    if (!m_wanted) m_safeTicks = 0;
    m_wanted = !m_needsHome;
    break;
  }
}

void Arming::fail(ServoReason reason) noexcept
{
  const bool final = reason == ServoReason::DeviceLost || reason == ServoReason::Closed;
  if (m_fault == ServoReason::Plain || final) m_fault = reason;
  m_wanted = false;
  m_gain = 0.0;
}

void Arming::watch(DeviceLink link, double dt) noexcept
{
  m_silence = link == DeviceLink::NoReply ? m_silence + dt : 0.0;
  if (link == DeviceLink::Lost) fail(ServoReason::DeviceLost);
  if (m_silence > kReplyTimeout) fail(ServoReason::NoReply);
  if (link == DeviceLink::NoReply) return;
  m_needsHome = link == DeviceLink::NeedsHome;
  if (m_needsHome) {
    m_wanted = false;
    m_gain = 0.0;
  }
}

void Arming::advance(double dt, double wish, std::uint64_t scene, bool begins) noexcept
{
  const bool isSafe = scene != 0 && wish < kSafeForce; // NaN is not small
  if (scene != m_scene) m_safeTicks = 0;
  m_scene = scene;
  if (begins && !isSafe) m_gain = 0.0; // nothing is felt of it yet
  if (waits()) m_safeTicks = isSafe && m_gain == 0.0 ? m_safeTicks + 1 : 0;
  const double change = opens() ? dt / std::max(m_armTime, 1e-3) : -dt / kDisarmTime;
  m_gain = std::clamp(m_gain + change, 0.0, 1.0);
}

double Arming::dampingShare() const noexcept
{
  if (!m_wanted) return 0.0;
  return kDampingShare * std::min({1.0, 20.0 * m_gain, 10.0 * (1.0 - m_gain)});
}

DeviceState Arming::state(bool present, bool forceFlows) const noexcept
{
  if (m_fault == ServoReason::DeviceLost) return DeviceState::Absent;
  if (m_fault != ServoReason::Plain) return DeviceState::Fault;
  if (!m_wanted) return forceFlows ? DeviceState::Fading : DeviceState::Idle;
  // Without a contact, what flows while force fades in is its damping only.
  if (!present && forceFlows && (waits() || m_gain == 1.0)) return DeviceState::Fading;
  return m_gain < 1.0 ? DeviceState::Arming : DeviceState::Active;
}

} // namespace esm
