// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace esm {

/// Watches that the loop gives the hand no more energy than the tissue's springs hold, damps what it gives
/// beyond that, and calls for a stop when damping is not enough.
///
/// Each tick the device has moved by dx under the force F that it was sent. W, the sum of F.dx, is work done
/// on the hand; V is the energy of the tissue's springs (ContactLaw::stored()), s the share of their force
/// that is sent (arming, limit). At no time may the hand get more than the springs held at any time before:
///
///     G(t) = W(t) - min over r <= t of (W(r) + s V(r)),   G >= 0
///
/// What is more was generated, by the tick's hold, by delay or by models that come late. Springs that are
/// tightened by the tissue's own motion or by a rising share count as energy that may come back; a steady
/// leak forgives what a tissue that moves by itself does slowly. (Passivity observer and controller after
/// Hannaford and Ryu 2002; the sum F.dx is exact for a held force, Stramigioli et al. 2005.)
/// @note Threads: servo only. Never allocates or throws.
class EnergyGuard {
public:
  static constexpr double kTrip = 0.02;     ///< [J]
  static constexpr double kLeak = 0.001;    ///< [W]
  static constexpr double kFree = 0.0005;   ///< below it nothing is damped [J]
  static constexpr double kDampTime = 0.02; ///< in which damping takes out what is too much [s]

  /// @param mostDamping [N s/m].
  explicit EnergyGuard(double mostDamping) noexcept : m_mostDamping(mostDamping) {}

  /// @param force   held since the last call [N].
  /// @param motion  of the device since then [m].
  /// @param stored  by the tissue's springs now [J].
  /// @param share   of the tissue's force that `force` is [1].
  /// @return false if G has passed the trip.
  bool account(const Eigen::Vector3d& force, const Eigen::Vector3d& motion, double stored, double share,
               double dt) noexcept;
  /// What takes out of the hand's motion what was generated [N].
  Eigen::Vector3d damping(const Eigen::Vector3d& velocity) const noexcept;

  double generated() const noexcept { return m_generated; } ///< G [J]
  double work() const noexcept { return m_work; }           ///< done on the hand since the start [J]
  void forget() noexcept { m_balance = m_generated = 0.0; } ///< a new account

private:
  double m_mostDamping;
  double m_balance = 0.0; ///< W + s V over its lowest value so far [J]
  double m_generated = 0.0, m_work = 0.0, m_stored = 0.0;
};

} // namespace esm
