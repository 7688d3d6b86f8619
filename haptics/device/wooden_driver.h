// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "haptics/device/device_driver.h"
#include "haptics/device/driver_profile.h"
#include "haptics/kinematics/serial3r.h"
#include "haptics/protocol/wooden_packet.h"
#include "haptics/transport/usb_transport.h"

#include <memory>

namespace esm {

/// WoodenHaptics 1.5. Its encoders count from where it was switched on, so the user puts the grip to the
/// origin and says so (requestHome()); until then there is no force. The firmware drops the motors after half
/// a second without a report, and takes the oldest one queued: exactly one leaves per force, or per
/// kKeepAlive.
class WoodenDriver final : public DeviceDriver {
public:
  static constexpr double kKeepAlive = 0.02; ///< [s]

  WoodenDriver(DriverProfile profile, std::unique_ptr<Wakeup> wakeup, std::unique_ptr<UsbHandle> handle);

  const DeviceProfile& profile() const noexcept override { return m_profile.device; }
  void step(double now, const Eigen::Vector3d& force, bool fresh) noexcept override;
  void close(double now) noexcept override;
  void sendLastZero() noexcept override;
  void requestHome() noexcept override { m_homeWanted = true; }

private:
  void drain(double now) noexcept;
  void take(std::span<const std::uint8_t> report, double now) noexcept;
  void keepListening() noexcept;
  void lose() noexcept;

  DriverProfile m_profile;
  std::unique_ptr<UsbHandle> m_handle;
  Serial3R m_arm;
  Eigen::Vector3d m_zero = Eigen::Vector3d::Zero(), m_angles = Eigen::Vector3d::Zero();
  UsbCompletion m_completion;
  int m_listening = 0, m_outUnderWay = 0;
  double m_sentAt = 0.0;
  bool m_homeWanted = false, m_homed = false;
};

} // namespace esm
