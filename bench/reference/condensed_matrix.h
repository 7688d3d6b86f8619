// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "bench/reference/fast_net.h"

#include <Eigen/Sparse>
#if defined(ESM_BENCH_CHOLMOD)
#include <Eigen/CholmodSupport>
#endif

namespace esm::bench {

/// A = M + gD D + gK K of a net, 3N x 3N, D and K the negative derivatives of the forces by velocity and
/// position; held nodes keep the row of M alone. Analysed once; the factor is CHOLMOD's where it was found,
/// else Eigen's simplicial one.
class CondensedMatrix {
public:
  void analyse(const FastNet& net);
  /// New values and a new factor. @return false if A is not positive definite.
  bool factor(const FastNet& net, const std::vector<FastNet::Tangent>& tangents, double gD, double gK);
  /// solution = A^-1 right-hand side, both over nodes.
  void solve(const Nodes& right, Nodes& solution);

private:
#if defined(ESM_BENCH_CHOLMOD)
  Eigen::CholmodDecomposition<Eigen::SparseMatrix<double>> m_factor;
#else
  Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> m_factor;
#endif
  Eigen::SparseMatrix<double> m_matrix; ///< lower triangle
  struct Place { ///< of a 3 x 3 block: the first of three values in each of three columns
    int column[3];
  };
  std::vector<Place> m_diagonal, m_coupling; ///< per node (rows from the diagonal on), per spring
  Eigen::VectorXd m_right, m_solution;
};

/// y += (gD D + gK K) p, of springs and anchors; held nodes are not asked for.
void addStiffnessTimes(const FastNet& net, const std::vector<FastNet::Tangent>& tangents, double gD,
                       double gK, const Vec4* p, Vec4* y);

} // namespace esm::bench
