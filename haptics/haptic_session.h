// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/hand_over.h"
#include "core/base/result.h"
#include "haptics/arming.h"
#include "haptics/device/driver_profile.h"
#include "haptics/haptic_device.h"
#include "haptics/haptic_types.h"
#include "haptics/jitter_histogram.h"

#include <Eigen/Core>

#include <memory>
#include <string>
#include <vector>

namespace esm {

/// One English sentence without full stop; empty if plain.
std::string reasonText(ServoReason reason);

/// A device with its servo thread, as the window sees it. Forces are zero until arm().
/// @note Threads: all members on one thread (the GUI's). The destructor stops, sends zero force and joins.
class HapticSession {
public:
  /// Names to offer; "simulated" is always there.
  static std::vector<std::string> deviceNames();
  /// @param tool, contact the simulation's buffers; they must outlive the session.
  /// @param options what the user says about the device: profile, firmware, consent.
  static Result<std::unique_ptr<HapticSession>> open(const std::string& device, TripleBuffer<ToolState>& tool,
                                                     TripleBuffer<ContactModel>& contact,
                                                     const DeviceOptions& options = {});
  /// The same with a device that is open already.
  static Result<std::unique_ptr<HapticSession>> start(std::unique_ptr<HapticDevice> device,
                                                      TripleBuffer<ToolState>& tool,
                                                      TripleBuffer<ContactModel>& contact);
  ~HapticSession();

  void arm();
  void disarm(); ///< fades out
  /// Force falls to exactly zero at the slew limit from the next tick on (5 N: 5 ms); Fault until arm().
  void emergencyStop();
  void setForceLimit(double newtons); ///< the smaller one of this and the profile's holds
  void setForceScale(double scale);   ///< force felt over force of the tissue [1]
  /// Simulated device: where the mouse wants the hand. The hand pulls the device there with its own spring.
  void moveHand(const Eigen::Vector3d& target);
  void placeHand(const Eigen::Vector3d& position); ///< jumps there at rest: a new grab

  void requestHome(); ///< see HapticDevice::requestHome()

  HapticStatus status();
  DeviceReport report() const; ///< how far the device has come, and what it waits for
  const DeviceProfile& profile() const;
  bool ledByMouse() const;     ///< whether moveHand() moves anything
  JitterCounts jitter() const; ///< since the device was opened
  /// Appends the ticks since the last call, oldest first (the ring keeps the last 4 s).
  void takeTrace(std::vector<TraceSample>& samples);

private:
  struct Impl;
  explicit HapticSession(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> m_impl;
};

} // namespace esm
