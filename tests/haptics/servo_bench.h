// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "haptics/servo_loop.h"
#include "haptics/simulated_device.h"

#include <functional>
#include <memory>
#include <utility>

namespace esm {

/// A hand that follows a formula.
class PathHand final : public Hand {
public:
  explicit PathHand(std::function<Eigen::Vector3d(double)> path) : m_path(std::move(path)) {}
  HandPose pose(double time) noexcept override { return {m_path(time), Eigen::Vector3d::Zero(), 0}; }

private:
  std::function<Eigen::Vector3d(double)> m_path;
};

inline std::unique_ptr<Hand> handAlong(std::function<Eigen::Vector3d(double)> path)
{
  return std::make_unique<PathHand>(std::move(path));
}

/// A simulated device on a servo loop in virtual time, with both buffers at hand: the test is the simulation.
struct ServoBench {
  explicit ServoBench(const SimulatedDeviceSettings& settings = {}, std::unique_ptr<Hand> hand = nullptr)
    : ServoBench(std::make_unique<SimulatedDevice>(settings, std::move(hand)),
                 std::make_unique<VirtualClock>())
  {}

  void tick(int count = 1) { loop.runTicks(count); }
  double now() { return clock.now(); }
  Eigen::Vector3d force() const { return device.force(); } ///< what has arrived at the device
  const ServoStatus& status() { return loop.core().status(); }
  void order(ForceOrder what) { loop.core().orders().give(what); }

  void send(ContactModel model)
  {
    model.sequence = ++sequence;
    contact.back() = model;
    contact.publish();
  }

  TripleBuffer<ToolState> tool;
  TripleBuffer<ContactModel> contact;
  std::uint64_t sequence = 0;
  SimulatedDevice& device;
  VirtualClock& clock;
  ServoLoop loop;

private:
  ServoBench(std::unique_ptr<SimulatedDevice> newDevice, std::unique_ptr<VirtualClock> newClock)
    : device(*newDevice), clock(*newClock), loop(std::move(newDevice), std::move(newClock), tool, contact)
  {}
};

/// A force that does not depend on the hand.
inline ContactModel constantForce(const Eigen::Vector3d& force)
{
  ContactModel model;
  model.active = true;
  model.force = force;
  return model;
}

/// A spring from the hand to `anchor`.
inline ContactModel springTo(const Eigen::Vector3d& anchor, double stiffness)
{
  ContactModel model;
  model.active = true;
  model.position = anchor;
  model.stiffness = stiffness * Eigen::Matrix3d::Identity();
  return model;
}

} // namespace esm
