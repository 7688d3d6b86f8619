// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/runtime/hand_over.h"

#include <Eigen/Core>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace esm {

enum class DeviceState : std::uint8_t {
  Absent,
  Idle,   ///< connected, exactly 0 N
  Arming, ///< force fades in
  Active,
  Fading, ///< force fades out (stale model, pause, disarm)
  Fault   ///< 0 N until the user re-arms; `reason` says why
};

struct HapticStatus {
  DeviceState state = DeviceState::Absent;
  std::string device;         ///< display name
  std::string reason;         ///< why it is in this state; empty if plain
  double rate = 0.0;          ///< servo ticks per second, smoothed
  double worstLateness = 0.0; ///< [s] in the last second
  std::uint64_t lateTicks = 0, ticks = 0;
  Eigen::Vector3d position = Eigen::Vector3d::Zero(); ///< scene [m]
  Eigen::Vector3d force = Eigen::Vector3d::Zero();    ///< sent to the device last [N]
  double forceLimit = 0.0;                            ///< [N] in force: the smaller of user's and profile's
};

/// One tick for plots and records.
struct TraceSample {
  double time = 0.0;                         ///< servo clock [s]
  Eigen::Vector3d position, velocity, force; ///< [m], [m/s], [N]
};

/// A device with its servo thread, as the window sees it. Forces are zero until arm().
/// @note Threads: all members on one thread (the GUI's). The destructor stops, sends zero force and joins.
class HapticSession {
public:
  /// Names to offer; "simulated" is always there.
  static std::vector<std::string> deviceNames();
  /// @param tool, contact the simulation's buffers; they must outlive the session.
  static Result<std::unique_ptr<HapticSession>> open(const std::string& device, TripleBuffer<ToolState>& tool,
                                                     TripleBuffer<ContactModel>& contact);
  ~HapticSession();

  void arm();
  void disarm();        ///< fades out
  void emergencyStop(); ///< zero force at the next tick; stays in Fault until arm()
  void setForceLimit(double newtons);
  /// Simulated device: where the mouse wants the hand. The hand pulls the device there with its own spring.
  void moveHand(const Eigen::Vector3d& target);
  void placeHand(const Eigen::Vector3d& position); ///< jumps there at rest: a new grab

  HapticStatus status();
  /// Appends the ticks since the last call, oldest first (the ring keeps the last 4 s).
  void takeTrace(std::vector<TraceSample>& samples);

private:
  struct Impl;
  explicit HapticSession(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> m_impl;
};

} // namespace esm
