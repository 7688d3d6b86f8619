// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/simulated_device.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

constexpr double kLongestSubstep = 0.00025; ///< [s]
constexpr double kLongestGap = 0.1;         ///< [s]; after a longer sleep of the computer the rest is skipped

} // namespace

SimulatedDevice::SimulatedDevice(const SimulatedDeviceSettings& settings, std::unique_ptr<Hand> hand)
  : m_settings(settings),
    m_hand(std::move(hand)),
    m_past(static_cast<std::size_t>(std::max(settings.delayTicks, 0)) + 1, Eigen::Vector3d::Zero())
{
  m_profile.name = "Simulated device";
  m_profile.ownDamping = settings.damping;
  m_profile.period = settings.period;
  m_profile.delay = settings.delayTicks * settings.period;
  m_profile.armTime = settings.armTime;
}

std::unique_ptr<SimulatedDevice> SimulatedDevice::withMouseHand(const SimulatedDeviceSettings& settings)
{
  auto hand = std::make_unique<MouseHand>();
  MouseHand* mouse = hand.get();
  auto device = std::make_unique<SimulatedDevice>(settings, std::move(hand));
  device->m_mouseHand = mouse;
  return device;
}

void SimulatedDevice::setMotion(const Eigen::Vector3d& position, const Eigen::Vector3d& velocity) noexcept
{
  m_position = position;
  m_velocity = velocity;
  std::fill(m_past.begin(), m_past.end(), position);
}

DeviceLink SimulatedDevice::read(double time, DeviceSample& sample) noexcept
{
  if (!m_started) m_time = time;
  m_started = true;
  const double gap = std::clamp(time - m_time, 0.0, kLongestGap);
  const int substeps = static_cast<int>(std::ceil(gap / kLongestSubstep - 1e-9));
  for (int i = 0; i < substeps; ++i) integrate(gap / substeps, time);
  m_time = time;
  if (m_link == DeviceLink::NoReply || m_link == DeviceLink::Lost) return m_link;
  sample.position = reported();
  sample.epoch = m_placeCount;
  return m_link;
}

bool SimulatedDevice::write(const Eigen::Vector3d& force) noexcept
{
  if (m_link == DeviceLink::Lost || !force.allFinite()) return false;
  m_force = force;
  return true;
}

void SimulatedDevice::integrate(double step, double time) noexcept
{
  Eigen::Vector3d target = m_position;
  double stiffness = 0.0, damping = 0.0;
  if (m_hand) {
    const HandPose pose = m_hand->pose(time);
    if (pose.placeCount != m_placeCount) {
      m_placeCount = pose.placeCount;
      setMotion(pose.place, Eigen::Vector3d::Zero());
    }
    target = pose.target;
    stiffness = m_settings.handStiffness;
    damping = m_settings.handDamping;
  }
  // Hand and damping as they are at the end of the step, the position with the mean velocity, which is exact
  // for the held force (the end velocity would be as if the servo looked an eighth of a tick ahead):
  //     x' = x + h (v + v')/2,   (m + h (b + c) + h^2 k/2) v' = m v + h (F + k (target - x - h v/2))
  const double mass = m_settings.mass;
  const double inertia = mass + step * (m_settings.damping + damping) + 0.5 * step * step * stiffness;
  const Eigen::Vector3d before = m_velocity;
  const Eigen::Vector3d pull = stiffness * (target - m_position - 0.5 * step * before);
  m_velocity = (mass * before + step * (m_force + pull)) / inertia;
  const double speed = m_velocity.norm();
  const double brake = step * m_settings.coulomb / inertia;
  m_velocity *= speed > brake ? 1.0 - brake / speed : 0.0;
  const Eigen::Vector3d way = 0.5 * step * (before + m_velocity);
  m_position += way;
  m_handWork += way.dot(stiffness * (target - m_position) - damping * m_velocity);
}

Eigen::Vector3d SimulatedDevice::reported() noexcept
{
  m_past[m_pastNext] = m_position;
  m_pastNext = (m_pastNext + 1) % m_past.size();
  const Eigen::Vector3d& old = m_past[m_pastNext];
  if (m_settings.quantum <= 0.0) return old;
  return (old / m_settings.quantum).array().round() * m_settings.quantum;
}

} // namespace esm
