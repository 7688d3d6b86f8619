// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/planner/policy.h"
#include "core/dynamics/system/system.h"

#include <optional>

namespace esm {

/// Since the start of the stretch [J].
struct EnergyBalance {
  double gained = 0.0;     ///< without work; what dampers have taken counts as a loss
  double heat = 0.0;       ///< that they have taken
  double turnedOver = 0.0; ///< was there, has been worked and has fallen
  double high = 0.0;       ///< size of that of weight at the start, for the rounding of its differences
};

/// Sees energy that comes from nowhere, at once or slowly over many stretches. Where every node is held or led there is
/// none to come: what springs and dampers take is what the supports have been told to do.
class EnergyGuard {
public:
  explicit EnergyGuard(const Policy& policy) noexcept : m_policy(&policy) {}

  void forget() noexcept { m_grown = 0.0; }
  /// Whether any node may go where forces take it.
  void lookForFreeNodes(const System& system) noexcept;
  bool isLedAllOver() const noexcept { return m_isLedAllOver; }
  void beginStretch() noexcept;
  void keepStretch() noexcept { m_grown = m_growth; }
  void takeBack() noexcept { m_growth = m_grown; } ///< the stretch is done anew
  /// What has happened from `start` to `state`; remembers the energies of the start of the stretch.
  EnergyBalance balance(const System& system, const MotionState& start, const MotionState& state);
  /// Whether the net has more energy than at the start of the stretch without work that explains it, by more
  /// than this share of what was there, has been worked and has fallen.
  /// @param extent  of the net [m]
  bool hasAppeared(const System& system, const EnergyBalance& balance, double extent, double share) noexcept;
  /// Whether the net is so much faster than at the start that its energy is worth two passes: a few large steps may
  /// have missed how stiff it has become.
  bool hasQuickened(const System& system, const MotionState& start, const MotionState& state) const noexcept;
  /// How large the waves may have been that implicit steps of this length have damped away since the start of
  /// the stretch [m].
  static double lostWaves(const System& system, const EnergyBalance& balance, double step) noexcept;

private:
  struct Energies {
    double kinetic = 0.0, elastic = 0.0, height = 0.0; ///< [J]
  };
  const Policy* m_policy;
  std::optional<Energies> m_start; ///< of the stretch, once somebody asked
  bool m_isLedAllOver = false;
  double m_grown = 0.0, m_growth = 0.0; ///< energy that appeared up to the present stretch, up to its end [J]
};

} // namespace esm
