// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <string>

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
  std::string priority;       ///< what the system granted the servo thread: "real-time", "raised" or "normal"
  double rate = 0.0;          ///< servo ticks per second, smoothed
  double worstLateness = 0.0; ///< [s] in the last second
  std::uint64_t lateTicks = 0, ticks = 0;
  Eigen::Vector3d position = Eigen::Vector3d::Zero(); ///< scene [m]
  Eigen::Vector3d force = Eigen::Vector3d::Zero();    ///< sent to the device last [N]
  double forceLimit = 0.0;                            ///< [N] in force: the smaller of user's and profile's
};

/// One tick for plots and records.
struct TraceSample {
  double time = 0.0;                                  ///< servo clock [s]
  Eigen::Vector3d position = Eigen::Vector3d::Zero(); ///< [m]
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero(); ///< [m/s]
  Eigen::Vector3d force = Eigen::Vector3d::Zero();    ///< [N]
};

} // namespace esm
