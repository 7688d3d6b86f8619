// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/system/system.h"
#include "core/forces/spring_matrix.h"

namespace esm {

/// Conjugate gradients with K, the tangent stiffness over the free nodes: solutions, and bounds of b.K^-1 b
/// from below, without a factor of K.
///
/// They add a positive term to b.x_k in every iteration, and end at b.K^-1 b (Hestenes and Stiefel 1952); one
/// iteration costs a product with K, less than a force pass. Preconditioned by what holds each node itself, a
/// few iterations find most of it, also where stiffness spreads over decades. Bedded tissue takes ten to
/// thirty, whatever its size.
class StiffnessCg {
public:
  /// K at x while all nodes stand still, without the pressure of closed surfaces.
  /// @param inertia  K + inertia M is taken [1/s^2]
  void prepare(const System& system, const NodeArray& x, double inertia);
  /// @param b       an entry per node [N]; held nodes do not count
  /// @param enough  no need to go on beyond it [J]
  /// @param most    iterations
  /// @param first   N entries, or null: where much of K^-1 b is looked for before the first of them, in this
  ///                direction
  /// @return the bound [J], as far as it was found before a direction of negative curvature was met
  double below(const System& system, const NodeArray& b, double enough, int most,
               const NodeArray* first = nullptr);
  enum class Result { Solved, GivesWay, TooSlow };
  /// vector = K^-1 vector, to about a hundredth of its length; an entry per node, those of held nodes become
  /// 0. Unless it is Solved, what had been found until then: GivesWay if a direction of negative curvature
  /// was met, TooSlow after `most` iterations.
  Result solve(const System& system, NodeArray& vector, int most);
  /// Whether K is not positive definite, as far as some ten products tell; none if no spring is pressed or
  /// softens.
  /// @param former  a pattern in which it did before: looked at first, and for longer; or null
  bool givesWay(const System& system, const NodeArray* former = nullptr);
  const NodeArray& direction() const noexcept { return m_direction; } ///< that was met last; 0 at held nodes
  int products() const noexcept
  {
    return m_products;
  } ///< with K since prepare(), each less than a force pass
  /// Whether the last function since prepare() met a direction of negative curvature: K^-1 then bounds
  /// nothing there.
  bool metNegative() const noexcept { return m_metNegative; }

private:
  double multiply(const System& system) noexcept;
  double iterate(const System& system, NodeArray* solution) noexcept;

  std::vector<SpringTangent> m_tangents; ///< of prepare(), of a small net kept as room
  bool m_hasNegative = false;            ///< one of them was
  SpringMatrix m_springs;
  std::vector<double> m_diagonal;                        ///< inertia, anchors, tools [N/m]
  std::vector<double> m_inverse;                         ///< of all that holds a node; 0 if a support does
  NodeArray m_residual, m_direction, m_product, m_still; ///< N entries each
  double m_square = 0.0;                                 ///< of the residual, under the preconditioner [J]
  bool m_metNegative = false;
  int m_products = 0;
};

} // namespace esm
