// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/implicit_matrix.h"
#include "core/dynamics/step_report.h"

namespace esm {

/// Takes a net the last part of its way to rest in one go.
///
/// Near its goal a net swings about it, or creeps towards it. With F the forces on nodes that stand still, K
/// the tangent stiffness and M the masses, the goal is d = K^-1 F away, and what the velocities carry the
/// net beyond it has y = K^-1 M v with |v| |y| >= the sum of squares of that part of the amplitude (one mode:
/// equal). So two solutions with one factor tell how far the net can still get, however slow its slowest
/// mode; speeds and accelerations at single nodes do not, as a slow sway hides behind them.
/// @note One thread. Allocates when a net is laid out.
class Settling {
public:
  static constexpr std::size_t kMostNodes = 10000; ///< a factor of 150 MB in a solid

  void forget() noexcept { m_isLaidOut = false; } ///< another net, other parameters
  bool isLaidOut() const noexcept { return m_isLaidOut; }
  void layOut(const System& system);
  /// Moves the net into balance and takes its velocity, if no more than `mostSquare` [m^2], a sum of squares
  /// of displacements over the nodes, is missed by that, nor at a single node more than five times the mean;
  /// its energy becomes heat. Nothing is done if more is missed, if the stiffness is not positive definite
  /// (what nothing holds is held by its inertia over ten seconds), or if the forces are not smaller there.
  /// @pre layOut(), and no load moves.
  /// @return what is missed over `mostSquare`; infinity where it cannot be told; done if <= 1.
  double settle(System& system, MotionState& motion, double mostSquare, StepReport& report);
  /// Of an attempt, in spring evaluations. @pre layOut()
  double cost() const noexcept { return m_matrix.factorCost() + 2.0 * m_matrix.solveCost(); }

private:
  double forcesAt(System& system, double time, NodeArray& x);

  ImplicitMatrix m_matrix;
  bool m_isLaidOut = false;
  NodeArray m_force, m_still, m_goal;
  NodeArray m_way, m_swing; ///< K^-1 F, K^-1 M v
};

} // namespace esm
