// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <string>

namespace esm {

class MouseHand;

/// What a device can bear; the servo keeps within it.
struct DeviceProfile {
  std::string name;
  double maxForce = 5.0;        ///< [N]
  double maxStiffness = 3000.0; ///< the maker's closed-loop limit [N/m]
  double maxDamping = 20.0;     ///< the same [N s/m]
  double ownDamping = 3.0;      ///< of the mechanism, viscous [N s/m]; sets the stiffness that stays stable
  double delay = 0.0;           ///< from taking the position to the force, beyond the tick itself [s]
  double period = 0.001;        ///< wanted tick [s]
  double armTime = 2.0;         ///< force fades in over this after arming [s]
  Eigen::Vector3d workspaceMin{-0.05, -0.05, -0.05}; ///< what the grip can reach, scene coordinates [m]
  Eigen::Vector3d workspaceMax{0.05, 0.05, 0.05};
};

/// How far a device has come on its way to work.
enum class DevicePhase : std::uint8_t { Opening, Upload, NeedsHome, Running, Fault, Lost };

/// The same for the user to read.
struct DeviceReport {
  DevicePhase phase = DevicePhase::Running;
  float progress = 0.0f;    ///< of the upload, 0 ... 1
  const char* reason = "";  ///< one English sentence without full stop, static; empty if plain
  std::uint8_t unhomed = 0; ///< NeedsHome: axes that do not know their place yet, bit 0 is the first
};

enum class DeviceLink : std::uint8_t {
  Ready,
  NeedsHome, ///< positions mean nothing yet: exactly 0 N
  NoReply,   ///< this time; the last sample stays
  Lost       ///< unplugged, for good
};

struct DeviceSample {
  Eigen::Vector3d position = Eigen::Vector3d::Zero(); ///< scene coordinates [m]
  std::uint32_t epoch = 0;   ///< another number: the coordinates have jumped, no motion lies between
  double age = 0.0;          ///< of the position when read() returns, as measured or known [s]
  std::uint32_t buttons = 0; ///< one bit each
  double roll = 0.0;         ///< of an instrument about its shaft [rad]
  double opening = 1.0;      ///< of its jaws: 0 closed, 1 open
};

/// One kind of device; adding one is one file and one line in device_registry.cpp.
///
/// A tick is read(), the force law, write(). The two are apart so that the force computed from a position
/// leaves in the same tick: a tick between them would cost two thirds of the stiffness that stays stable.
/// Velocity is the servo's to estimate, the limits are the servo's to keep.
/// @note Threads: profile() and mouseHand() any, before and while the servo runs; read() and write() on the
///       servo thread only, without locks, allocation, logging or exceptions. The destructor lets go of the
///       device; the servo has sent zero force before.
class HapticDevice {
public:
  virtual ~HapticDevice() = default;
  virtual const DeviceProfile& profile() const noexcept = 0;
  /// @param time servo clock [s], rising.
  virtual DeviceLink read(double time, DeviceSample& sample) noexcept = 0;
  /// @return whether the device has taken the force [N].
  virtual bool write(const Eigen::Vector3d& force) noexcept = 0;
  virtual DeviceReport report() const noexcept { return {}; } ///< any thread
  /// Takes where the grip is now for its home, on devices that cannot find it themselves. Any thread.
  virtual void requestHome() noexcept {}
  /// The hand to lead by mouse; null where a real hand holds the device.
  virtual MouseHand* mouseHand() noexcept { return nullptr; }
};

} // namespace esm
