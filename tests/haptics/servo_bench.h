// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "haptics/servo_loop.h"
#include "haptics/simulated_device.h"

#include <functional>
#include <memory>
#include <utility>

namespace esm {

inline constexpr double kTick = 0.001; ///< of the servo loop [s]

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

/// Of a device in a hand that hardly gives way: a force without springs behind it is energy that nobody had
/// put in, and more than 20 mJ of it would be a fault.
inline SimulatedDeviceSettings firmlyHeld()
{
  SimulatedDeviceSettings settings;
  settings.handStiffness = 3000.0;
  settings.handDamping = 30.0;
  return settings;
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
  /// Armed, and the wait for a small force is over.
  void armWithoutForce()
  {
    const auto rest = [this](int ticks) {
      for (int i = 0; i < ticks; ++i) {
        send({});
        tick();
      }
    };
    rest(60); // the last contact fades out
    order(ForceOrder::Arm);
    rest(Arming::kSafeTicks);
  }

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
