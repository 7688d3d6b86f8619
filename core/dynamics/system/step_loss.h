// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/system/system.h"

namespace esm {

/// What a step, or a stretch of them, takes away without heat, by quadrature: the work of the net's
/// conservative forces along the straight way from its start to its end, its own work and heat, and the
/// kinetic energy that should have become of them. Those forces have the same work on every way, and
/// Simpson's rule is exact for springs that are linear there, however fast the waves. No energy of a spring
/// enters: what the balance of energies leaves over judges this, too.
class StepLoss {
public:
  /// Another net. So that steps need not allocate room is made at once; of a large net, which may never move, by the
  /// first find().
  void prepare(const System& system);
  void restart() noexcept { m_isKnown = false; } ///< the next start is not the last end
  /// Of what led from `start` to x and v [J].
  /// @param precision  of the forces' work, relative to itself and to the changes of the others; a very
  /// curved way is given up at some point.
  double find(const System& system, const MotionState& start, const NodeArray& x, const NodeArray& v,
              double work, double heat, double precision = 1.0);

private:
  void makeRoom(std::size_t nodes);
  void findForces(const System& system, const NodeArray& x, NodeArray& force) noexcept;
  double powerAt(const System& system, const NodeArray& from, const NodeArray& to, double share) noexcept;

  NodeArray m_still; ///< velocities, 0
  NodeArray m_place, m_first, m_last, m_between;
  bool m_isKnown = false; ///< m_first
};

} // namespace esm
