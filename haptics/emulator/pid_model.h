// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "haptics/emulator/usb_device_model.h"
#include "haptics/protocol/pid_layout.h"
#include "haptics/simulated_device.h"

#include <array>
#include <cstdint>
#include <memory>

namespace esm {

/// A two-axis force-feedback stick in the computer, with a report descriptor that Linux' own hid-pidff
/// accepts. Its motors move a grip with mass and friction; an effect that is not started again ends after its
/// duration.
class PidModel final : public UsbDeviceModel {
public:
  struct Settings {
    SimulatedDeviceSettings mechanics;
    Eigen::Vector2d stroke{0.1, 0.1}; ///< [m]
    double newtonsAtFull = 2.0;       ///< [N]
    int busyAnswers = 0;              ///< block loads that say nothing first
    bool noOutEndpoint = false;
    bool full = false; ///< no room for any effect
  };

  explicit PidModel(const Settings& settings, std::unique_ptr<Hand> hand = nullptr);

  bool out(std::span<const std::uint8_t> bytes) override;
  int in(std::span<std::uint8_t> bytes) override;
  void advance(double now) override;

  Eigen::Vector3d force() const noexcept { return m_force; } ///< on the grip [N]
  const SimulatedDevice& grip() const noexcept { return m_grip; }
  int effects() const noexcept; ///< created and not freed
  int runningEffects() const noexcept;
  bool enabled() const noexcept { return m_enabled; }
  std::int32_t magnitude(int effect) const noexcept
  {
    return m_effects[static_cast<std::size_t>(effect)].magnitude;
  }
  std::uint64_t reports() const noexcept { return m_reports; } ///< force reports so far
  int zerosInRow() const noexcept { return m_zeros; }          ///< of them, without force

protected:
  int ownControl(const UsbSetup& setup, std::span<std::uint8_t> data) override;

private:
  struct Effect {
    bool used = false, started = false;
    std::int32_t magnitude = 0;
    double duration = 0.0, direction = 0.0, startedAt = 0.0; ///< [s], [rad], [s]
  };

  bool take(std::span<const std::uint8_t> report);
  void create();
  Effect* effect(std::span<const std::uint8_t> report, const hid::Slot& block);
  std::int32_t axisValue(int axis) const noexcept;

  Settings m_settings;
  std::unique_ptr<hid::ReportDescriptor> m_descriptor;
  pid::Layout m_layout;
  SimulatedDevice m_grip;
  std::array<Effect, 8> m_effects;
  Eigen::Vector3d m_force = Eigen::Vector3d::Zero(), m_position = Eigen::Vector3d::Zero();
  std::array<std::int32_t, 2> m_told{-1, -1};
  double m_now = 0.0;
  int m_created = 0, m_busy = 0, m_zeros = 0;
  std::uint64_t m_reports = 0;
  bool m_enabled = false;
};

} // namespace esm
