// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "haptics/hand.h"
#include "haptics/haptic_device.h"
#include "haptics/kinematics/laparoscope4.h"

#include <memory>

namespace esm {

/// Any device with three axes as the handle of a laparoscopic instrument through a trocar: positions are
/// those of the tip, forces at the tip come to the hand over the lever. Roll and jaws, which such devices
/// lack, follow its buttons: the first and the last turn the shaft, the third closes the jaws.
///
///     handle (device) o----------( pivot )------> tip (scene)
///
/// @note Threads: as HapticDevice.
class LaparoscopeDevice final : public HapticDevice {
public:
  static constexpr std::uint32_t kRollLeft = 1, kClose = 4, kRollRight = 8; ///< buttons
  static constexpr double kRollSpeed = 1.6;                                 ///< [rad/s]
  static constexpr double kJawSpeed = 4.0;                                  ///< [1/s]

  LaparoscopeDevice(std::unique_ptr<HapticDevice> device, const Laparoscope4& instrument);
  /// One that needs no hardware: the mouse leads its tip.
  static std::unique_ptr<LaparoscopeDevice> simulated(const Laparoscope4& instrument);

  const DeviceProfile& profile() const noexcept override { return m_profile; }
  DeviceLink read(double time, DeviceSample& sample) noexcept override;
  bool write(const Eigen::Vector3d& force) noexcept override;
  DeviceReport report() const noexcept override { return m_device->report(); }
  void requestHome() noexcept override { m_device->requestHome(); }
  MouseHand* mouseHand() noexcept override { return m_mouse; }

private:
  std::unique_ptr<HapticDevice> m_device;
  Laparoscope4 m_instrument;
  DeviceProfile m_profile;
  MouseHand* m_mouse = nullptr;
  Eigen::Vector3d m_handle;
  double m_roll = 0.0, m_opening = 1.0, m_time = 0.0;
  bool m_started = false;
};

} // namespace esm
