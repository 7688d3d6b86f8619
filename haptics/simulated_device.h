// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "haptics/hand.h"
#include "haptics/haptic_device.h"

#include <Eigen/Core>

#include <memory>
#include <vector>

namespace esm {

struct SimulatedDeviceSettings {
  double mass = 0.25;           ///< [kg]
  double damping = 3.0;         ///< [N s/m]
  double coulomb = 0.3;         ///< dry friction [N]
  double quantum = 0.0;         ///< positions are multiples of this [m]; 0 = exact
  int delayTicks = 0;           ///< a position is this many reads old
  double period = 0.001;        ///< wanted tick [s]
  double handStiffness = 300.0; ///< the hand's spring to its target [N/m]
  double handDamping = 8.0;     ///< [N s/m]
  double armTime = 0.3;         ///< no fingers in the way: shorter than a real device's [s]
};

/// A haptic device that needs no hardware:
///
///     m a = F + k_h (target - x) - c_h v - b v - F_c v/|v|
///
/// F is the servo's force, held between two ticks; the hand is a spring-damper to where it wants to be.
/// Integrated at 4 kHz or finer, implicitly in hand and damping, with the friction as an impulse that
/// never reverses the motion, so no setting makes the device itself gain energy.
class SimulatedDevice final : public HapticDevice {
public:
  /// @param hand null: nobody holds the device.
  explicit SimulatedDevice(const SimulatedDeviceSettings& settings, std::unique_ptr<Hand> hand = nullptr);
  /// One that the mouse leads; see mouseHand().
  static std::unique_ptr<SimulatedDevice> withMouseHand(const SimulatedDeviceSettings& settings = {});

  const DeviceProfile& profile() const noexcept override { return m_profile; }
  DeviceLink read(double time, DeviceSample& sample) noexcept override;
  bool write(const Eigen::Vector3d& force) noexcept override;
  MouseHand* mouseHand() noexcept override { return m_mouseHand; }

  // === For tests; servo thread
  void setMotion(const Eigen::Vector3d& position, const Eigen::Vector3d& velocity) noexcept;
  void setLink(DeviceLink link) noexcept { m_link = link; } ///< plays a fault
  const Eigen::Vector3d& position() const noexcept { return m_position; }
  const Eigen::Vector3d& velocity() const noexcept { return m_velocity; }
  const Eigen::Vector3d& force() const noexcept { return m_force; } ///< written last [N]
  double handWork() const noexcept { return m_handWork; } ///< done by the hand on the device so far [J]

private:
  void integrate(double step, double time) noexcept;
  Eigen::Vector3d reported() noexcept;

  SimulatedDeviceSettings m_settings;
  DeviceProfile m_profile;
  std::unique_ptr<Hand> m_hand;
  MouseHand* m_mouseHand = nullptr; ///< m_hand, if it is one
  DeviceLink m_link = DeviceLink::Ready;
  Eigen::Vector3d m_position = Eigen::Vector3d::Zero(), m_velocity = Eigen::Vector3d::Zero();
  Eigen::Vector3d m_force = Eigen::Vector3d::Zero();
  double m_time = 0.0, m_handWork = 0.0;
  bool m_started = false;
  std::uint32_t m_placeCount = 0;
  std::vector<Eigen::Vector3d> m_past; ///< ring of the last delayTicks + 1 positions
  std::size_t m_pastNext = 0;
};

} // namespace esm
