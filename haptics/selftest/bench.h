// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "haptics/servo_loop.h"
#include "haptics/simulated_device.h"

#include <functional>
#include <limits>
#include <memory>
#include <utility>

namespace esm {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A hand that follows a formula.
class FormulaHand final : public Hand {
public:
  explicit FormulaHand(std::function<Eigen::Vector3d(double)> path) : m_path(std::move(path)) {}
  HandPose pose(double time) noexcept override { return {m_path(time), m_path(0.0), 1}; }

private:
  std::function<Eigen::Vector3d(double)> m_path;
};

/// A device that is exactly where a formula has it, whatever force it gets.
class LedDevice final : public HapticDevice {
public:
  explicit LedDevice(std::function<Eigen::Vector3d(double)> path) : m_path(std::move(path))
  {
    m_profile.armTime = 0.01;
    m_profile.maxForce = 20.0;
  }
  const DeviceProfile& profile() const noexcept override { return m_profile; }
  DeviceLink read(double time, DeviceSample& sample) noexcept override
  {
    sample.position = m_path(time);
    return DeviceLink::Ready;
  }
  bool write(const Eigen::Vector3d& force) noexcept override
  {
    m_force = force;
    return true;
  }
  const Eigen::Vector3d& force() const noexcept { return m_force; }

private:
  std::function<Eigen::Vector3d(double)> m_path;
  DeviceProfile m_profile;
  Eigen::Vector3d m_force = Eigen::Vector3d::Zero();
};

/// A device on a servo loop in virtual time, with both buffers at hand: the caller is the simulation.
template <class Device>
class VirtualServo {
public:
  explicit VirtualServo(std::unique_ptr<Device> newDevice)
    : VirtualServo(std::move(newDevice), std::make_unique<VirtualClock>())
  {}
  void send(ContactModel model)
  {
    model.sequence = ++m_sequence;
    m_contact.back() = model;
    m_contact.publish();
  }
  void tick() noexcept { m_loop.runTicks(1); }
  void arm()
  {
    m_loop.core().orders().give(ForceOrder::Arm);
    for (int i = 0; i < 2 * Arming::kSafeTicks; ++i) {
      send({});
      tick();
    }
  }
  Device& device;
  VirtualClock& clock;
  ServoCore& core() noexcept { return m_loop.core(); }
  TripleBuffer<ToolState>& tool() noexcept { return m_tool; }

private:
  VirtualServo(std::unique_ptr<Device> newDevice, std::unique_ptr<VirtualClock> newClock)
    : device(*newDevice),
      clock(*newClock),
      m_loop(std::move(newDevice), std::move(newClock), m_tool, m_contact)
  {}
  TripleBuffer<ToolState> m_tool;
  TripleBuffer<ContactModel> m_contact;
  std::uint64_t m_sequence = 0;
  ServoLoop m_loop;
};

/// A wall in the plane x = 0 that pushes back below it.
inline ContactModel wallModel(double stiffness)
{
  ContactModel model;
  model.active = true;
  model.stiffness(0, 0) = stiffness;
  model.normal = Eigen::Vector3d::UnitX();
  return model;
}

} // namespace esm
