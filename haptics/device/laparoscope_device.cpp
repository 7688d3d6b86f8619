// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/device/laparoscope_device.h"

#include "haptics/simulated_device.h"

#include <algorithm>
#include <utility>

namespace esm {

namespace {

constexpr double kLongestTick = 0.02; ///< [s]

/// Where the handle must be for the tip to be where the mouse is.
class TrocarHand final : public Hand {
public:
  explicit TrocarHand(const Laparoscope4& instrument) : m_instrument(instrument) {}
  HandPose pose(double time) noexcept override
  {
    HandPose pose = m_mouse.pose(time);
    pose.target = m_instrument.handleOfTip(pose.target);
    pose.place = m_instrument.handleOfTip(pose.place);
    return pose;
  }
  MouseHand& mouse() noexcept { return m_mouse; }

private:
  Laparoscope4 m_instrument;
  MouseHand m_mouse;
};

} // namespace

LaparoscopeDevice::LaparoscopeDevice(std::unique_ptr<HapticDevice> device, const Laparoscope4& instrument)
  : m_device(std::move(device)),
    m_instrument(instrument),
    m_profile(m_device->profile()),
    m_handle(instrument.handleOfTip(Eigen::Vector3d::Zero()))
{
  m_profile.name += " as a laparoscope";
  const double reach = instrument.length() - Laparoscope4::kLeastInsertion;
  m_profile.workspaceMin = instrument.pivot() - Eigen::Vector3d(reach, reach, reach);
  m_profile.workspaceMax = instrument.pivot() + Eigen::Vector3d(reach, reach, 0.0);
}

std::unique_ptr<LaparoscopeDevice> LaparoscopeDevice::simulated(const Laparoscope4& instrument)
{
  auto hand = std::make_unique<TrocarHand>(instrument);
  MouseHand* mouse = &hand->mouse();
  auto base = std::make_unique<SimulatedDevice>(SimulatedDeviceSettings{}, std::move(hand));
  base->setMotion(instrument.handleOfTip(Eigen::Vector3d::Zero()), Eigen::Vector3d::Zero());
  auto device = std::make_unique<LaparoscopeDevice>(std::move(base), instrument);
  device->m_mouse = mouse;
  return device;
}

DeviceLink LaparoscopeDevice::read(double time, DeviceSample& sample) noexcept
{
  const DeviceLink link = m_device->read(time, sample);
  const double dt = m_started ? std::clamp(time - m_time, 0.0, kLongestTick) : 0.0;
  m_started = true;
  m_time = time;
  if (link != DeviceLink::Ready) return link;
  m_handle = sample.position;
  sample.position = m_instrument.tipOfHandle(m_handle);
  const int turn = ((sample.buttons & kRollRight) != 0 ? 1 : 0) - ((sample.buttons & kRollLeft) != 0 ? 1 : 0);
  m_roll += turn * kRollSpeed * dt;
  m_opening =
    std::clamp(m_opening + ((sample.buttons & kClose) != 0 ? -kJawSpeed : kJawSpeed) * dt, 0.0, 1.0);
  sample.roll = m_roll;
  sample.opening = m_opening;
  return link;
}

bool LaparoscopeDevice::write(const Eigen::Vector3d& force) noexcept
{
  Eigen::Vector3d felt = m_instrument.handleForce(m_handle, force);
  // Close to the trocar the lever makes much of little: the device's own limit holds at the handle too.
  const double size = felt.norm();
  if (size > m_profile.maxForce) felt *= m_profile.maxForce / size;
  return m_device->write(felt);
}

} // namespace esm
