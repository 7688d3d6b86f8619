// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "haptics/haptic_device.h"
#include "haptics/transport/wakeup.h"

#include <Eigen/Core>

#include <cstdint>
#include <memory>

namespace esm {

/// What a driver has to tell after each step. Plain data.
struct DriverState {
  DeviceLink link = DeviceLink::NeedsHome; ///< Ready, NeedsHome or Lost; silence is for DrivenDevice to judge
  DeviceSample sample;
  double heard = 0.0; ///< when the device last gave a sign of life [s]
  DeviceReport report;
};

/// The state machine of one real device: opens it, uploads, homes, exchanges force for position.
///
///     Opening -> Upload -> NeedsHome -> Running;   any -- fault --> Fault;   any -- unplugged --> Lost
///
/// @note One thread calls step() and close(); neither throws. Force leaves only in Running.
class DeviceDriver {
public:
  virtual ~DeviceDriver() = default;
  virtual const DeviceProfile& profile() const noexcept = 0;
  /// Takes what has come, sends what is due. Called when a transfer has ended, when there is a new force, and
  /// every few milliseconds.
  /// @param fresh whether `force` [N] is new; an old one is not sent again before the device needs to hear of
  /// us.
  virtual void step(double now, const Eigen::Vector3d& force, bool fresh) noexcept = 0;
  /// Sends zero force at least three times and lets the device go.
  virtual void close(double now) noexcept = 0;
  /// From a signal handler, on whatever thread is dying while step() may be anywhere: brings zero force to
  /// the device by UsbHandle::sendAtLast(), three times.
  virtual void sendLastZero() noexcept = 0;
  virtual void requestHome() noexcept {} ///< on the same thread
  const DriverState& state() const noexcept { return m_state; }
  Wakeup& wakeup() noexcept { return *m_wakeup; } ///< posted when a transfer has ended

protected:
  DriverState m_state;
  std::unique_ptr<Wakeup> m_wakeup = std::make_unique<Wakeup>();
};

} // namespace esm
