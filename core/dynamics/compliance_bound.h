// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/system.h"
#include "core/forces/spring_matrix.h"

namespace esm {

/// Bounds from below of b.K^-1 b without a factor of K, the tangent stiffness over the free nodes.
///
/// Conjugate gradients from 0 add a positive term to b.x_k in every iteration, and end at b.K^-1 b (Hestenes
/// and Stiefel 1952); one iteration costs a product with K, less than a force pass. Preconditioned by the
/// masses they see the squared frequencies of the net, of which a motion that has gone on for a while holds
/// few: some ten iterations find most of it.
class ComplianceBound {
public:
  /// K at x while all nodes stand still, without the pressure of closed surfaces.
  /// @param inertia  K + inertia M is taken [1/s^2]
  void prepare(const System& system, const NodeArray& x, double inertia);
  /// @param b       an entry per node [N]; held nodes do not count
  /// @param enough  no need to go on beyond it [J]
  /// @param most    iterations
  /// @return the bound [J]; infinity if a direction of negative curvature was met, where K^-1 bounds nothing.
  double below(const System& system, const NodeArray& b, double enough, int most);

private:
  std::vector<SpringTangent> m_tangents;
  SpringMatrix m_springs;
  std::vector<double> m_diagonal;                        ///< inertia, anchors, tools [N/m]
  NodeArray m_residual, m_direction, m_product, m_still; ///< N entries each
};

} // namespace esm
