// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/linear/preconditioned_cg.h"

#include "core/forces/spring_pass.h"
#include "core/linear/gradient_sweeps.h"

#include <Eigen/Dense>

#include <algorithm>

namespace esm {
namespace {

/// product = A p. @return p.A p
ESM_CPU_CLONES double multiply(std::size_t nodes, const NodeBlock* diagonal, std::size_t pairCount,
                               const NodePair* pairs, const NodeBlock* coupling, const Lanes* p,
                               Lanes* product) noexcept
{
  for (std::size_t i = 0; i < nodes; ++i) product[i] = times(diagonal[i], p[i]);
  for (std::size_t k = 0; k < pairCount; ++k) {
    const Index a = pairs[k].a, b = pairs[k].b;
    const Lanes toA = times(coupling[k], p[b]), toB = times(coupling[k], p[a]);
    product[a] += toA;
    product[b] += toB;
  }
  Lanes sum = {0, 0, 0, 0};
  for (std::size_t i = 0; i < nodes; ++i) sum += p[i] * product[i];
  return sumLanes(sum);
}

} // namespace

void PreconditionedCg::prepare(Index nodes, const std::vector<NodePair>& pairs)
{
  m_pairs = pairs;
  m_inverse.assign(static_cast<std::size_t>(nodes), {});
  for (NodeArray* array : {&m_residual, &m_direction, &m_product, &m_scaled})
    array->assign(static_cast<std::size_t>(nodes), Lanes{0, 0, 0, 0});
}

bool PreconditionedCg::setMatrix(const NodeBlock* diagonal, const NodeBlock* coupling) noexcept
{
  m_diagonal = diagonal;
  m_coupling = coupling;
  for (std::size_t i = 0; i < m_inverse.size(); ++i) {
    Eigen::Matrix3d block;
    for (int column = 0; column < 3; ++column) block.col(column) = toVector(diagonal[i].column[column]);
    const double corner = block.topLeftCorner<2, 2>().determinant(), all = block.determinant();
    if (!(block(0, 0) > 0.0) || !(corner > 0.0) || !(all > 0.0)) return false; // Sylvester; false for NaN
    const Eigen::Matrix3d inverse = block.inverse();
    if (!inverse.allFinite()) return false;
    for (int column = 0; column < 3; ++column) m_inverse[i].column[column] = toLanes(inverse.col(column));
  }
  return true;
}

PreconditionedCg::Result PreconditionedCg::solve(Lanes* vector, double reduction, int most) noexcept
{
  const std::size_t nodes = m_inverse.size();
  std::copy(vector, vector + nodes, m_residual.begin());
  std::fill(vector, vector + nodes, Lanes{0, 0, 0, 0});
  std::fill(m_product.begin(), m_product.end(), Lanes{0, 0, 0, 0});
  double square = takeStep(nodes, 0.0, m_product.data(), m_product.data(), m_inverse.data(), vector,
                           m_residual.data(), m_scaled.data());
  m_direction = m_scaled; // same size: no allocation
  const double enough = reduction * reduction * square;
  for (m_iterations = 0; m_iterations < most; ++m_iterations) {
    if (square <= enough) return Result::Converged;
    const double curvature = multiply(nodes, m_diagonal, m_pairs.size(), m_pairs.data(), m_coupling,
                                      m_direction.data(), m_product.data());
    if (!(curvature > 0.0)) {
      if (m_iterations == 0) std::copy(m_scaled.begin(), m_scaled.end(), vector);
      return Result::Indefinite;
    }
    const double next = takeStep(nodes, square / curvature, m_direction.data(), m_product.data(),
                                 m_inverse.data(), vector, m_residual.data(), m_scaled.data());
    const double keep = next / square;
    for (std::size_t i = 0; i < nodes; ++i) m_direction[i] = m_scaled[i] + m_direction[i] * keep;
    square = next;
  }
  return Result::TooSlow;
}

} // namespace esm
