// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/methods/integrator.h"
#include "core/dynamics/planner/policy.h"

#include <memory>
#include <optional>

namespace esm {

/// A motion and a neighbour at a small distance, moved by plain steps at their limit over the same frames. The
/// distance is carried over from frame to frame, made small again each time.
/// @note One thread. Allocates in begin().
class NeighbourMotion {
public:
  explicit NeighbourMotion(const Policy::Growth& policy) noexcept : m_policy(&policy) {}

  bool isReady() const noexcept { return m_isReady; }
  void drop() noexcept { m_isReady = false; }
  /// The neighbour differs by its velocities, in this pattern.
  /// @param extent  of the net [m]
  void begin(const SpringNet& net, const Loads& loads, const NodeArray& pattern, double extent);
  void setMode(const FastestMode& mode) noexcept; ///< steps bear it from now on
  void remember(const MotionState& motion)
  {
    m_before = motion;
  } ///< where the frame begins; same size: no allocation
  /// What the frame up to `end` would take [force passes].
  double passesTo(double end, bool isDamped) const noexcept;
  double springs() const noexcept;
  /// Over the frame that has just been done. @param passes  receives what it took
  /// @return logarithm of what the distance has grown by; none if numbers ran away
  std::optional<double> carryOn(double end, bool isDamped, double& passes);

private:
  double stepFor(bool isDamped) const noexcept { return isDamped ? m_step : m_policy->fineness * m_step; }
  bool run(MotionState& state, double end, double step);
  double size() const noexcept;

  const Policy::Growth* m_policy;
  System m_system; ///< of the two neighbours, once there are two
  MotionState m_before, m_here, m_beside;
  NodeArray m_x, m_v; ///< the difference [m, m/s]
  std::unique_ptr<Integrator> m_integrator;
  double m_extent = 1.0; ///< [m]
  double m_step = 0.0;   ///< [s]
  bool m_isReady = false;
};

} // namespace esm
