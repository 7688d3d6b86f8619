// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Dense>

namespace esm {

/// What a few dense columns g_j (the pressure's dV/dx) add to a symmetric matrix A whose factor is at hand:
///
///     B = A + sum c_j g_j g_j^T,   B^-1 y = z - W S^-1 G^T z,   z = A^-1 y,   W = A^-1 G,
///     S = diag(1/c) + G^T W                                      (Sherman, Morrison and Woodbury 1950)
///
/// It holds S alone; the columns are the caller's, in whatever form he has vectors.
class LowRankUpdate {
public:
  /// @param gram  G^T W, m x m. @param c  m, > 0.
  void set(const Eigen::MatrixXd& gram, const Eigen::VectorXd& c)
  {
    Eigen::MatrixXd s = 0.5 * (gram + gram.transpose());
    s.diagonal() += c.cwiseInverse();
    m_inverse = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(s);
  }
  Eigen::Index rank() const noexcept { return m_inverse.eigenvalues().size(); }
  /// How much of each column of W goes off z. @param seen  G^T z.
  Eigen::VectorXd shares(const Eigen::VectorXd& seen) const
  {
    const Eigen::VectorXd& values = m_inverse.eigenvalues();
    const double least = 1e-14 * values.cwiseAbs().maxCoeff();
    Eigen::VectorXd along = m_inverse.eigenvectors().transpose() * seen;
    for (Eigen::Index i = 0; i < along.size(); ++i)
      along[i] = std::abs(values[i]) > least ? along[i] / values[i] : 0.0;
    return m_inverse.eigenvectors() * along;
  }
  /// How many negative eigenvalues of A are none of B: by Haynsworth's law of inertia as many as S has.
  Eigen::Index negativesGone() const noexcept { return (m_inverse.eigenvalues().array() < 0.0).count(); }

private:
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> m_inverse;
};

} // namespace esm
