// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/system.h"

#include <cstdint>
#include <span>
#include <vector>

namespace esm {

/// Finds the nodes that have come to rest. Looked at once a frame, a node is quiet if the way that it still
/// has to go is below a limit, as three predictions have it: at its present speed for a frame; at its present
/// acceleration for eight frames (a slow sway at its turning point has no speed, but an acceleration); and by
/// the geometric series that its displacements from look to look begin (a slow creep has neither). A node is
/// calm after several quiet looks in a row.
class RestWatch {
public:
  void prepare(std::size_t nodes);
  /// Begins to watch nodes that have woken.
  void watch(std::span<const Index> nodes, const MotionState& motion);
  /// @param limit  way to go [m].
  void look(const std::vector<Index>& nodes, const MotionState& motion, double limit);
  /// A short look in the middle of a frame, at the speed only: an oscillation in step with the frames stands
  /// still at every full look.
  void glance(const std::vector<Index>& nodes, const MotionState& motion, double limit);

  bool lookIsDue(double time) const noexcept;
  std::size_t calmCount() const noexcept { return m_calmCount; }   ///< at the last look
  std::size_t quietCount() const noexcept { return m_quietCount; } ///< at the last look
  /// N flags: calm at the last look.
  const std::vector<std::uint8_t>& calm() const noexcept { return m_calm; }
  /// The nodes are not calm, whatever they do: a load moves them.
  void pin(const std::vector<Index>& nodes);

private:
  double m_lookTime = 0.0;
  NodeArray m_x, m_v; ///< at the last look
  struct Watched {
    double speed = -1.0; ///< between the last two looks [m/s]; negative: unknown
    std::uint8_t quietLooks = 0;
  };
  std::vector<Watched> m_nodes;
  std::vector<std::uint8_t> m_calm;
  std::size_t m_calmCount = 0, m_quietCount = 0;
};

} // namespace esm
