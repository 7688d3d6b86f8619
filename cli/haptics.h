// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "cli/messages.h"
#include "haptics/device/driver_profile.h"

#include <optional>
#include <string>

namespace esm::cli {

/// What the commands of `esm haptics` share.
struct HapticRunOptions {
  std::string device = "simulated", project, path, csv, output;
  DeviceOptions own; ///< what the user says about the device
  std::optional<double> seconds, forceLimit, gain, frameRate, stopAfter;
  std::optional<int> node;
  double radius = 0.003; ///< of the tip [m]
  bool arm = false, json = false;
  bool compare = false; ///< with the force at 5 kHz
};

/// A device on the wall clock, with or without a net to touch; says how even its ticks were.
Exit runDevice(const HapticRunOptions& options);
/// Where the hand on a device goes, as a path.
Exit recordPath(const HapticRunOptions& options);
/// A path against a net on a virtual clock: the same forces each time.
Exit replayPath(const HapticRunOptions& options);

} // namespace esm::cli
