// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/system/system.h"
#include "core/forces/spring_matrix.h"
#include "core/linear/block_cholesky.h"

namespace esm {

/// Conjugate gradients with the convex matrix of an implicit Euler step of length h,
///
///     A = M + h D + h^2 K,
///
/// K without what springs that are pressed, softening or turning take from it, so that A is positive definite
/// whatever the net does. Nothing is factored: each iteration is a product with the springs' blocks, less than
/// a force pass, and a descent of every node by its own 3 x 3 block. The blocks see what a sliver's or a
/// gripped node's springs hold, so that few stiff nodes do not slow the others down. Pressure joins as its
/// gradient. Stopped after any number of iterations the result still points downhill.
/// @note One thread. Allocates in prepare(), and in set() when it is called for the first time.
class StepGradients {
public:
  struct Solved {
    int iterations = 0;
    double left = 1.0; ///< of what A^-1 would lower the potential by, as the latest terms tell [1]
  };
  void prepare(const System& system);
  /// The numbers at x and v. @return whether they are finite.
  bool set(const System& system, const NodeArray& x, const NodeArray& v, double h);
  /// vector = A^-1 vector, an entry per node, 0 at held ones. Each iteration lowers the quadratic potential by
  /// a term that falls in the long run; ends when the last four are together less than `smallPart` of all, after
  /// `most` iterations, or at the system's work limit.
  /// @param first  the direction that is tried first, or null
  Solved solve(System& system, NodeArray& vector, const NodeArray* first, double smallPart,
               int most) noexcept;

  // Costs in spring evaluations of the force pass.
  static constexpr double kPerSet = 4.0, kPerIteration = 1.0; ///< and spring

private:
  double multiply(System& system) noexcept;

  SpringMatrix m_springs;
  std::vector<double> m_diagonal; ///< mass, anchors, tools, mass damping [kg]
  NodeArray m_straight, m_mixed;  ///< of the blocks on the diagonal: xx, yy, zz and xy, xz, yz
  NodeBlocks m_inverse;
  struct PressureColumn {
    NodeArray gradient; ///< 0 at held nodes [m^2]
    double stiffness = 0.0;
  };
  std::vector<PressureColumn> m_pressure; ///< one per body
  NodeArray m_residual, m_direction, m_product, m_scaled;
};

} // namespace esm
