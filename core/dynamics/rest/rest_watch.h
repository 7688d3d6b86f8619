// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/planner/policy.h"
#include "core/dynamics/system/system.h"

#include <cstdint>
#include <span>
#include <vector>

namespace esm {

/// Finds the nodes that have come to rest. It looks at them once a frame, and says of each whether it is
///
///     slow   it moves less than a limit in some frames, at its present speed and by what it did last
///     calm   the way that it still has to go is below the limit, as two more predictions have it: at its
///            present acceleration for eight frames (a slow sway at its turning point has no speed, but an
///            acceleration), and by the geometric series that its displacements from look to look begin
///            (a slow creep has neither)
///
/// for several looks in a row. Slow is enough for a node that has awake neighbours, whose motion will wake it
/// again; the last ones to sleep have nobody to wake them, and must be calm.
class RestWatch {
public:
  explicit RestWatch(const Policy& policy = kPolicy) noexcept : m_policy(&policy.rest) {}

  void prepare(std::size_t nodes);
  /// Begins to watch nodes that have woken.
  void watch(std::span<const Index> nodes, const MotionState& motion);
  /// @param limit  way to go [m].
  void look(const std::vector<Index>& nodes, const MotionState& motion, double limit);
  /// A short look in the middle of a frame, at the speed only: an oscillation in step with the frames stands
  /// still at every full look.
  void glance(const std::vector<Index>& nodes, const MotionState& motion, double limit);
  /// These nodes are neither slow nor calm, whatever they do: a load moves them.
  void pin(std::span<const Index> nodes);
  bool lookIsDue(double time) const noexcept;

  // At the last look
  const std::vector<std::uint8_t>& slow() const noexcept { return m_slow; } ///< N flags
  const std::vector<std::uint8_t>& calm() const noexcept { return m_calm; } ///< N flags
  std::size_t slowCount() const noexcept { return m_slowCount; }
  std::size_t calmCount() const noexcept { return m_calmCount; }
  std::size_t firstSlowCount() const noexcept { return m_firstSlowCount; } ///< slow in this look

private:
  const Policy::Rest* m_policy;
  double m_lookTime = 0.0;
  NodeArray m_x, m_v; ///< at the last look
  struct Watched {
    double speed = -1.0; ///< between the last two looks [m/s]; negative: unknown
    std::uint8_t slowLooks = 0, calmLooks = 0;
  };
  std::vector<Watched> m_nodes;
  std::vector<std::uint8_t> m_slow, m_calm;
  std::size_t m_slowCount = 0, m_calmCount = 0, m_firstSlowCount = 0;
};

} // namespace esm
