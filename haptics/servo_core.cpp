// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/servo_core.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace esm {

namespace {

constexpr double kVelocityCutoff = 200.0; ///< [Hz]; above it encoder steps show, below it damping comes late
constexpr double kNoSpeed = 1e-12;        ///< [m/s], along an axis
constexpr double kMostScale = 10.0;
constexpr double kMostOfHold = 0.25 * EnergyGuard::kTrip; ///< generated while a late model holds [J]

} // namespace

ServoCore::ServoCore(HapticDevice& device, TripleBuffer<ToolState>& tool, TripleBuffer<ContactModel>& contact)
  : m_device(device),
    m_toolBuffer(tool),
    m_contactBuffer(contact),
    m_arming(device.profile().armTime),
    m_law(device.profile()),
    m_energy(device.profile().maxDamping)
{}

void ServoCore::tick(double now, double dt) noexcept
{
  m_arming.obey(m_orders.latest());
  const DeviceLink link = m_device.read(now, m_sample);
  m_arming.watch(link, dt);
  m_motion.setZero();
  if (link == DeviceLink::Ready && m_sample.position.allFinite()) {
    take(m_sample, dt);
    sendTool(now);
  }
  const DeviceProfile& profile = m_device.profile();
  const double limit = std::min(profile.maxForce, m_userLimit.load(std::memory_order_relaxed));
  const Eigen::Vector3d wanted = wish(now, dt, limit);
  // A late tick earns no larger step, one that follows it closely only a part; a clock's rounding is neither.
  const double slewTime = dt < 0.999 * profile.period ? dt : profile.period;
  const Eigen::Vector3d& force = m_limiter.limit(wanted, limit, slewTime);
  if (!m_device.write(force) && link != DeviceLink::Lost) m_arming.fail(ServoReason::NoReply);
  report(now, limit);
}

/// What the device should be sent, but for the limiter; zero for what is no number.
Eigen::Vector3d ServoCore::wish(double now, double dt, double limit) noexcept
{
  if (!m_law.take(m_contactBuffer.latest(), now, m_scale.load(std::memory_order_relaxed)))
    m_arming.fail(ServoReason::BadModel);
  Eigen::Vector3d force = m_law.force(now, dt, m_lastPosition, m_velocity, m_sample.age);
  if (!force.allFinite()) {
    m_arming.fail(ServoReason::BadModel);
    force.setZero(); // 0 x NaN would be NaN
  }
  if (m_law.begins()) m_share = 0.0; // the old one was another contact's
  if (!m_energy.account(m_limiter.force(), m_motion, m_law.stored(), m_share, dt)) {
    // What fades out anyway gives nothing that its springs did not hold.
    if (m_law.present() && m_arming.opens()) m_arming.fail(ServoReason::EnergyTooHigh);
    m_energy.forget();
  }
  watchHold();
  const double size = force.stableNorm();
  force += m_energy.damping(m_velocity);
  if (const double norm = force.stableNorm(); norm > limit) force *= std::max(limit, 0.0) / norm;
  m_arming.advance(dt, m_law.size(), m_law.scene(), m_law.begins());
  const double gain = m_arming.gain();
  m_share = m_law.presence() * gain * (size > limit ? std::max(limit, 0.0) / size : 1.0);
  if (gain == 0.0) return Eigen::Vector3d::Zero();
  return gain * force - m_arming.dampingShare() * m_device.profile().maxDamping * m_velocity;
}

/// What a late model gives beyond its springs is an early sign: it ends long before the guard would trip.
void ServoCore::watchHold() noexcept
{
  const double generated = m_energy.generated();
  m_beforeHold = m_law.holds() ? std::min(m_beforeHold, generated) : generated;
  if (generated > m_beforeHold + kMostOfHold) m_law.endHold();
}

void ServoCore::sendZero() noexcept
{
  m_device.write(Eigen::Vector3d::Zero());
}

void ServoCore::setForceLimit(double newtons) noexcept
{
  if (std::isfinite(newtons)) m_userLimit.store(std::max(newtons, 0.0), std::memory_order_relaxed);
}

void ServoCore::setForceScale(double scale) noexcept
{
  if (std::isfinite(scale)) m_scale.store(std::clamp(scale, 0.0, kMostScale), std::memory_order_relaxed);
}

/// The velocity is a first-order low-pass on the difference quotient.
void ServoCore::take(const DeviceSample& sample, double dt) noexcept
{
  if (!m_hasSample || sample.epoch != m_epoch) {
    m_velocity.setZero();
    m_law.forget(); // made for another place
    m_arming.fadeInAnew();
  } else {
    m_motion = sample.position - m_lastPosition;
    const double lag = 1.0 / (2.0 * std::numbers::pi * kVelocityCutoff);
    m_velocity += (m_motion - dt * m_velocity) / (dt + lag);
    m_velocity = (m_velocity.array().abs() < kNoSpeed).select(0.0, m_velocity); // or it would take for ever
  }
  m_hasSample = true;
  m_epoch = sample.epoch;
  m_lastPosition = sample.position;
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
  if (!m_arming.wanted()) return ServoReason::Plain;
  if (m_law.stale()) return ServoReason::StaleModel;
  if (m_law.scene() == 0) return ServoReason::NoScene;
  if (!m_law.present()) return ServoReason::NoContact;
  if (m_arming.waits()) return ServoReason::ForceTooLarge;
  return m_law.late() ? ServoReason::LateModel : ServoReason::Plain;
}

void ServoCore::report(double now, double limit) noexcept
{
  const Eigen::Vector3d& force = m_limiter.force();
  m_figures.state = m_arming.state(m_law.present(), !force.isZero(0.0));
  m_figures.reason = reason();
  m_figures.position = m_lastPosition;
  m_figures.force = force;
  m_figures.forceLimit = limit;
  m_figures.generated = m_energy.generated();
  m_status.back() = m_figures;
  m_status.publish();
  m_trace.push({now, m_lastPosition, m_velocity, force, m_energy.work(), m_figures.lateness});
}

} // namespace esm
