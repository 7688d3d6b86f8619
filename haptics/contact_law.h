// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/runtime/hand_over.h"
#include "haptics/haptic_device.h"

#include <Eigen/Core>

#include <cstdint>

namespace esm {

/// The force that the tissue exerts on the hand, each tick, from models that come at the simulation's pace.
///
/// Each model is a plane, F = c - K x - C v. The newest one takes over within a quarter of the time between
/// models, so that no jump is felt. K and C are first capped to what the device can render without
/// oscillating: 2 (b + B) / (T + 2 tau) is where a held spring begins to gain energy (b own damping, B added
/// damping, T tick, tau delay); half of it leaves room for irregular ticks.
///
/// Presence fades in over 50 ms when a contact begins and out when it ends or when no model has come for
/// 100 ms: a dead simulation is not a wall.
/// @note Threads: servo only. Never allocates or throws.
class ContactLaw {
public:
  static constexpr double kStaleAfter = 0.1; ///< [s]
  static constexpr double kFadeTime = 0.05;  ///< [s]
  static constexpr double kStabilityShare = 0.5;

  explicit ContactLaw(const DeviceProfile& profile) noexcept;

  /// Takes a model if its sequence is new.
  /// @return false for one with a NaN, an infinity or a number beyond 1e9; it is not taken.
  bool take(const ContactModel& model, double now) noexcept;

  /// Advances fading and blending by `dt` [s] and evaluates. Not limited: that is ForceLimiter's.
  Eigen::Vector3d force(double now, double dt, const Eigen::Vector3d& position,
                        const Eigen::Vector3d& velocity) noexcept;

  void forget() noexcept; ///< ends the contact at once; a model that was already seen does not come back

  bool present() const noexcept { return m_active && !m_stale; }
  bool stale() const noexcept { return m_active && m_stale; }
  double presence() const noexcept { return m_presence; } ///< 0 ... 1
  /// Largest stiffness [N/m] that goes with an added damping [N s/m].
  double stiffnessCap(double damping) const noexcept;

private:
  struct Plane {
    Eigen::Vector3d constant = Eigen::Vector3d::Zero();  ///< [N]
    Eigen::Matrix3d stiffness = Eigen::Matrix3d::Zero(); ///< [N/m]
    Eigen::Matrix3d viscosity = Eigen::Matrix3d::Zero(); ///< [N s/m]
  };
  Plane planeOf(const ContactModel& model) const noexcept;
  Plane blended() const noexcept;

  double m_maxStiffness, m_maxDamping, m_ownDamping, m_delay;
  double m_tick; ///< as measured, smoothed [s]
  Plane m_from, m_to;
  double m_blend = 1.0;           ///< 0 = m_from, 1 = m_to
  double m_interval = 1.0 / 60.0; ///< between models, smoothed [s]
  double m_arrival = 0.0;         ///< of the newest model [s]
  std::uint64_t m_sequence = 0;
  double m_presence = 0.0;
  bool m_active = false, m_stale = false;
};

} // namespace esm
