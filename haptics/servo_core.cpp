// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/servo_core.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace esm {

namespace {

constexpr double kVelocityCutoff = 200.0; ///< [Hz]; below it encoder steps show, above it damping comes late

}

ServoCore::ServoCore(HapticDevice& device, TripleBuffer<ToolState>& tool, TripleBuffer<ContactModel>& contact)
  : m_device(device),
    m_toolBuffer(tool),
    m_contactBuffer(contact),
    m_arming(device.profile().armTime),
    m_law(device.profile())
{}

void ServoCore::tick(double now, double dt) noexcept
{
  m_arming.obey(m_orders.latest());
  const DeviceLink link = m_device.read(now, m_sample);
  m_arming.watch(link, dt);
  if (link == DeviceLink::Ready && m_sample.position.allFinite()) {
    estimateVelocity(dt);
    sendTool(now);
  }
  if (!m_law.take(m_contactBuffer.latest(), now)) m_arming.fail(ServoReason::BadModel);
  Eigen::Vector3d wish = m_law.force(now, dt, m_lastPosition, m_velocity);
  if (!wish.allFinite()) m_arming.fail(ServoReason::BadModel);
  m_arming.advance(dt);
  if (m_arming.gain() == 0.0)
    wish.setZero(); // 0 x NaN would be NaN
  else
    wish *= m_arming.gain();

  const DeviceProfile& profile = m_device.profile();
  const double limit = std::min(profile.maxForce, m_userLimit.load(std::memory_order_relaxed));
  // A late tick earns no larger step, one that follows it closely only a part; a clock's rounding is neither.
  const double slewTime = dt < 0.999 * profile.period ? dt : profile.period;
  const Eigen::Vector3d& force = m_limiter.limit(wish, limit, slewTime);
  if (!m_device.write(force) && link != DeviceLink::Lost) m_arming.fail(ServoReason::NoReply);
  report(now, limit);
}

void ServoCore::sendZero() noexcept
{
  m_device.write(Eigen::Vector3d::Zero());
}

void ServoCore::setForceLimit(double newtons) noexcept
{
  if (std::isfinite(newtons)) m_userLimit.store(std::max(newtons, 0.0), std::memory_order_relaxed);
}

/// First-order low-pass on the difference quotient.
void ServoCore::estimateVelocity(double dt) noexcept
{
  if (!m_hasSample || m_sample.epoch != m_epoch) {
    m_velocity.setZero();
  } else {
    const double lag = 1.0 / (2.0 * std::numbers::pi * kVelocityCutoff);
    m_velocity += ((m_sample.position - m_lastPosition) - dt * m_velocity) / (dt + lag);
  }
  m_hasSample = true;
  m_epoch = m_sample.epoch;
  m_lastPosition = m_sample.position;
}

void ServoCore::sendTool(double now) noexcept
{
  m_toolBuffer.back() = {++m_toolSequence, now, m_lastPosition, m_velocity};
  m_toolBuffer.publish();
}

ServoReason ServoCore::reason() const noexcept
{
  if (m_arming.fault() != ServoReason::Plain) return m_arming.fault();
  if (m_arming.needsHome()) return ServoReason::NeedsHome;
  if (m_arming.wanted() && m_law.stale()) return ServoReason::StaleModel;
  if (m_arming.wanted() && !m_law.present()) return ServoReason::NoContact;
  return ServoReason::Plain;
}

void ServoCore::report(double now, double limit) noexcept
{
  const Eigen::Vector3d& force = m_limiter.force();
  m_figures.state = m_arming.state(m_law.present(), !force.isZero(0.0));
  m_figures.reason = reason();
  m_figures.position = m_lastPosition;
  m_figures.force = force;
  m_figures.forceLimit = limit;
  m_status.back() = m_figures;
  m_status.publish();
  m_trace.push({now, m_lastPosition, m_velocity, force});
}

} // namespace esm
