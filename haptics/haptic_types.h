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
  double generated = 0.0; ///< energy that nobody had put in and that damping has not taken out yet [J]
  double tickTime = 0.0;  ///< longest tick of the last second: device, law and device again [s]
};

/// One tick for plots and records.
struct TraceSample {
  double time = 0.0;                                  ///< servo clock [s]
  Eigen::Vector3d position = Eigen::Vector3d::Zero(); ///< [m]
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero(); ///< [m/s]
  Eigen::Vector3d force = Eigen::Vector3d::Zero();    ///< [N]
  double work = 0.0;                                  ///< done on the hand since the device was opened [J]
  double lateness = 0.0;                              ///< of the tick's begin [s]
};

} // namespace esm
