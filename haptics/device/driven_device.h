// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/triple_buffer.h"
#include "haptics/device/device_driver.h"
#include "haptics/haptic_device.h"
#include "haptics/servo_clock.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <thread>

namespace esm {

/// A real device as the servo sees it: newest position in, newest force out, never waiting for USB.
///
///     servo   read() <---- TripleBuffer <---- driver thread: waits for a transfer or a force,
///     DeviceDriver::step()
///             write() ---> TripleBuffer ----> and wakes it, so that the force leaves in the tick it was
///             computed in
///
/// If the servo thread itself falls silent, the driver thread sends zero force after kCommandTimeout.
class DrivenDevice final : public HapticDevice {
public:
  static constexpr double kCommandTimeout = 0.05; ///< [s]
  static constexpr double kQuietPeriods = 2.0; ///< without a sign of life after which a tick has had no reply

  /// Inline runs the driver within read() and write(), for a virtual clock and an emulated device.
  enum class Drive : std::uint8_t { OwnThread, Inline };

  explicit DrivenDevice(std::unique_ptr<DeviceDriver> driver, Drive drive = Drive::OwnThread);
  ~DrivenDevice() override;

  const DeviceProfile& profile() const noexcept override { return m_driver->profile(); }
  DeviceLink read(double time, DeviceSample& sample) noexcept override;
  bool write(const Eigen::Vector3d& force) noexcept override;
  DeviceReport report() const noexcept override;
  void requestHome() noexcept override { m_homeWanted.store(true, std::memory_order_relaxed); }

private:
  struct Force {
    Eigen::Vector3d newtons = Eigen::Vector3d::Zero();
    std::uint64_t sequence = 0;
  };

  void run(const std::stop_token& stop) noexcept;
  void runUntil(const std::stop_token& stop, SteadyClock& clock) noexcept;
  void step(double now, const Eigen::Vector3d& force, bool fresh) noexcept;

  std::unique_ptr<DeviceDriver> m_driver;
  Drive m_drive;
  double m_now = 0.0; ///< Inline: the servo's
  std::uint64_t m_sequence = 0;
  bool m_lost = false; ///< servo's
  TripleBuffer<Force> m_force;
  TripleBuffer<DriverState> m_states;
  std::atomic<DevicePhase> m_phase{DevicePhase::Opening}; ///< the four parts of the report
  std::atomic<float> m_progress{0.0f};
  std::atomic<const char*> m_reason{""};
  std::atomic<std::uint8_t> m_unhomed{0};
  std::atomic<bool> m_homeWanted{false};
  std::jthread m_thread; ///< last: joins before the rest goes
};

} // namespace esm
