// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/system.h"

#include <Eigen/SparseCholesky>

namespace esm {

/// The matrix of an implicit step over the free nodes, and its Cholesky factor:
///
///     A = M + s D + s^2 K,   D = - dF/dv,   K = - sym dF/dx,   s the step's implicit share [s]
///
/// D and K are sums of 3 x 3 blocks (SpringTangent, anchors, tools, mass damping), both symmetric. The
/// pattern is laid out and analysed once by prepare().
class ImplicitMatrix {
public:
  void prepare(const System& system);

  /// Fills in the numbers at x, v and factors. With `convex`, softening, pressed and turning springs lend no
  /// negative stiffness, so that A is positive definite whatever the net does. The true A leads faster to a
  /// solution, even where a net that buckles makes it indefinite; the convex one is the safeguard.
  /// @return whether the factor exists.
  bool factor(const System& system, const NodeArray& x, const NodeArray& v, double s, bool convex);
  /// solution = A^-1 right; both 3 F.
  void solve(const Eigen::VectorXd& right, Eigen::VectorXd& solution) const
  {
    solution = m_cholesky.solve(right);
  }

  /// Free node -> block row; kNoIndex for held nodes.
  const std::vector<Index>& blockOf() const noexcept { return m_blockOf; }
  Eigen::Index size() const noexcept { return m_matrix.rows(); }
  /// Multiplications of one factorization, about.
  double factorCost() const noexcept { return m_factorCost; }
  /// The matrix of the last factor(), lower half; for tests.
  const Eigen::SparseMatrix<double>& lower() const noexcept { return m_matrix; }

private:
  struct BlockSlots { ///< places of column 0, 1, 2 in the value array; a diagonal block holds its lower half
    Eigen::Index column[3] = {-1, -1, -1};
  };
  void layOut(const System& system);
  void estimateCost();
  void addDiagonal(Index block, const Eigen::Matrix3d& values);

  std::vector<Index> m_blockOf;
  std::vector<BlockSlots> m_diagonal; ///< per free node
  std::vector<BlockSlots> m_coupling; ///< per active spring; -1 unless both ends are free
  std::vector<SpringTangent> m_tangents;
  Eigen::SparseMatrix<double> m_matrix;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower> m_cholesky;
  double m_factorCost = 0.0;
};

} // namespace esm
