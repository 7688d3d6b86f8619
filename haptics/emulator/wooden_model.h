// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "haptics/emulator/usb_device_model.h"
#include "haptics/kinematics/serial3r.h"
#include "haptics/simulated_device.h"

#include <array>
#include <cstdint>
#include <memory>

namespace esm {

/// WoodenHaptics in the computer: encoders from where the grip was at switch-on, motors that let go half a
/// second after the last report.
class WoodenModel final : public UsbDeviceModel {
public:
  static constexpr double kWatchdog = 0.5; ///< [s]

  explicit WoodenModel(const SimulatedDeviceSettings& mechanics = {}, std::unique_ptr<Hand> hand = nullptr);

  bool out(std::span<const std::uint8_t> bytes) override;
  int in(std::span<std::uint8_t> bytes) override;
  void advance(double now) override;

  Eigen::Vector3d force() const noexcept { return m_force; } ///< on the grip [N]
  const SimulatedDevice& grip() const noexcept { return m_grip; }
  std::uint64_t reports() const noexcept { return m_reports; }
  int zerosInRow() const noexcept { return m_zeros; }

protected:
  int ownControl(const UsbSetup& setup, std::span<std::uint8_t> data) override;

private:
  Serial3R m_arm;
  SimulatedDevice m_grip;
  Eigen::Vector3d m_force = Eigen::Vector3d::Zero(), m_angles = Eigen::Vector3d::Zero(), m_start;
  double m_now = 0.0, m_heard = 0.0, m_toldAt = -1.0;
  std::int16_t m_counter = 0;
  std::uint64_t m_reports = 0;
  int m_zeros = 0;
};

} // namespace esm
