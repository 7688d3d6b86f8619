// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "haptics/device/device_driver.h"
#include "haptics/device/driver_profile.h"
#include "haptics/kinematics/planar2.h"
#include "haptics/protocol/pid_session.h"
#include "haptics/transport/usb_transport.h"

#include <memory>

namespace esm {

/// A force-feedback stick or wheel of the USB PID class: one or two axes, no z. Knows where it is from
/// power-on, so it has no home; sends its position when it changes, so silence is no fault: a force that
/// cannot be sent is.
class PidDriver final : public DeviceDriver, public pid::Port {
public:
  PidDriver(DriverProfile profile, std::unique_ptr<Wakeup> wakeup, std::unique_ptr<UsbHandle> handle,
            int interface);

  const DeviceProfile& profile() const noexcept override { return m_profile.device; }
  void step(double now, const Eigen::Vector3d& force, bool fresh) noexcept override;
  void close(double now) noexcept override;
  void sendLastZero() noexcept override;
  const pid::Layout& layout() const noexcept { return m_layout; }

private:
  bool output(std::span<const std::uint8_t> report) noexcept override;
  bool setFeature(std::span<const std::uint8_t> report) noexcept override;
  bool getFeature(std::uint8_t id, std::span<std::uint8_t> report) noexcept override;

  void open(double now) noexcept;
  void drain(double now) noexcept;
  void take(std::span<const std::uint8_t> report, double now) noexcept;
  void keepListening() noexcept;
  bool waitForOut() noexcept;
  UsbSetup outputSetup(std::span<const std::uint8_t> report) const noexcept;
  bool control(const UsbSetup& setup, std::span<std::uint8_t> data) noexcept;
  void fail(const char* reason) noexcept;
  void lose() noexcept;

  DriverProfile m_profile;
  std::unique_ptr<UsbHandle> m_handle;
  std::uint16_t m_interface;
  Planar2 m_plane;
  std::unique_ptr<hid::ReportDescriptor> m_descriptor;
  pid::Layout m_layout;
  std::unique_ptr<pid::Session> m_session;
  UsbCompletion m_completion;
  Eigen::Vector2d m_axes = Eigen::Vector2d::Zero();
  double m_now = 0.0, m_outSince = 0.0;
  int m_listening = 0, m_outUnderWay = 0;
  bool m_outFailed = false, m_started = false, m_waits = true;
};

} // namespace esm
