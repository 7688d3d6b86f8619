// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/linear/block_cholesky.h"

namespace esm {

/// Conjugate gradients for a sparse symmetric matrix of 3 x 3 blocks, preconditioned by the inverse of its
/// diagonal blocks: for nets so large that a factor costs more than it saves. In an implicit step mass holds
/// the condition down, so that some tens of passes over the springs do. Sums run in a fixed order.
class PreconditionedCg {
public:
  void prepare(Index nodes, const std::vector<NodePair>& pairs);
  /// The blocks as for BlockCholesky::factor(); not owned, to be kept until the next call.
  /// @return whether the diagonal blocks are positive definite.
  bool setMatrix(const NodeBlock* diagonal, const NodeBlock* coupling) noexcept;

  enum class Result { Converged, Indefinite, TooSlow };
  /// vector = A^-1 vector, until the preconditioned residual has shrunk to `reduction` of itself or after
  /// `most` iterations. Indefinite: a direction of negative curvature was met; the vector is what had been
  /// found until then, or the preconditioned right side, both directions of descent.
  Result solve(Lanes* vector, double reduction, int most) noexcept;
  int iterations() const noexcept { return m_iterations; } ///< of the last solve()

private:
  std::vector<NodePair> m_pairs;
  NodeBlocks m_inverse;
  const NodeBlock* m_diagonal = nullptr;
  const NodeBlock* m_coupling = nullptr;
  NodeArray m_residual, m_direction, m_product, m_scaled;
  int m_iterations = 0;
};

} // namespace esm
