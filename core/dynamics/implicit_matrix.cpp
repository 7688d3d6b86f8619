// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/implicit_matrix.h"

#include <algorithm>

namespace esm {

void ImplicitMatrix::prepare(const System& system)
{
  Index free = 0;
  m_blockOf.assign(system.nodeCount(), kNoIndex);
  for (std::size_t i = 0; i < system.nodeCount(); ++i)
    if (system.isFree(i)) m_blockOf[i] = free++;
  m_matrix = Eigen::SparseMatrix<double>(3 * free, 3 * free);
  layOut(system);
  if (free > 0) m_cholesky.analyzePattern(m_matrix);
  estimateCost();
}

void ImplicitMatrix::layOut(const System& system)
{
  const auto& ends = system.forces().springEnds();
  const auto block = [&](Index node) { return m_blockOf[static_cast<std::size_t>(node)]; };
  std::vector<Eigen::Triplet<double>> entries;
  for (const Index b : m_blockOf)
    for (Index c = 0; b != kNoIndex && c < 3; ++c)
      for (Index r = c; r < 3; ++r) entries.emplace_back(3 * b + r, 3 * b + c, 1.0);
  for (const auto& end : ends) {
    const Index row = std::max(block(end.a), block(end.b)), column = std::min(block(end.a), block(end.b));
    for (Index c = 0; column != kNoIndex && c < 3; ++c)
      for (Index r = 0; r < 3; ++r) entries.emplace_back(3 * row + r, 3 * column + c, 1.0);
  }
  m_matrix.setFromTriplets(entries.begin(), entries.end());
  m_matrix.makeCompressed();

  // The three rows of a block stand together in each column, so its first row's place is enough.
  const auto slot = [&](Index row, Index column) {
    const int* rows = m_matrix.innerIndexPtr();
    const int* outer = m_matrix.outerIndexPtr();
    return static_cast<Eigen::Index>(std::lower_bound(rows + outer[column], rows + outer[column + 1], row) -
                                     rows);
  };
  m_diagonal.assign(static_cast<std::size_t>(m_matrix.rows() / 3), {});
  for (Index b = 0; b < static_cast<Index>(m_diagonal.size()); ++b)
    for (Index c = 0; c < 3; ++c)
      m_diagonal[static_cast<std::size_t>(b)].column[c] = slot(3 * b + c, 3 * b + c);
  m_coupling.assign(ends.size(), {});
  for (std::size_t s = 0; s < ends.size(); ++s) {
    const Index row = std::max(block(ends[s].a), block(ends[s].b)),
                column = std::min(block(ends[s].a), block(ends[s].b));
    for (Index c = 0; column != kNoIndex && c < 3; ++c)
      m_coupling[s].column[c] = slot(3 * row, 3 * column + c);
  }
}

/// The elimination tree under the same ordering tells the length of each column of the factor; its square is
/// the work of that column.
void ImplicitMatrix::estimateCost()
{
  m_factorCost = 0.0;
  const Eigen::Index n = m_matrix.rows();
  if (n == 0) return;
  Eigen::SparseMatrix<double> permuted(n, n);
  permuted.selfadjointView<Eigen::Upper>() =
    m_matrix.selfadjointView<Eigen::Lower>().twistedBy(m_cholesky.permutationP());
  std::vector<Eigen::Index> parent(static_cast<std::size_t>(n), -1), mark(static_cast<std::size_t>(n), -1),
    length(static_cast<std::size_t>(n), 1);
  for (Eigen::Index k = 0; k < n; ++k) {
    mark[static_cast<std::size_t>(k)] = k;
    for (Eigen::SparseMatrix<double>::InnerIterator entry(permuted, k); entry; ++entry)
      for (auto i = static_cast<std::size_t>(entry.row()); mark[i] != k;
           i = static_cast<std::size_t>(parent[i])) {
        if (parent[i] == -1) parent[i] = k;
        ++length[i];
        mark[i] = k;
      }
  }
  for (const Eigen::Index column : length)
    m_factorCost += static_cast<double>(column) * static_cast<double>(column);
}

void ImplicitMatrix::addDiagonal(Index block, const Eigen::Matrix3d& values)
{
  if (block == kNoIndex) return;
  double* value = m_matrix.valuePtr();
  for (Index c = 0; c < 3; ++c)
    for (Index r = c; r < 3; ++r)
      value[m_diagonal[static_cast<std::size_t>(block)].column[c] + (r - c)] += values(r, c);
}

bool ImplicitMatrix::factor(const System& system, const NodeArray& x, const NodeArray& v, double s,
                            bool convex)
{
  double* value = m_matrix.valuePtr();
  std::fill(value, value + m_matrix.nonZeros(), 0.0);
  const auto block = [&](Index node) { return m_blockOf[static_cast<std::size_t>(node)]; };
  const auto scalar = [&](Index node, double amount) {
    addDiagonal(block(node), amount * Eigen::Matrix3d::Identity());
  };
  const auto& massDrag = system.forces().massDrag();
  for (std::size_t i = 0; i < system.nodeCount(); ++i)
    scalar(static_cast<Index>(i), system.mass()[i] + (massDrag.empty() ? 0.0 : s * massDrag[i]));
  for (const auto& anchor : system.forces().anchors())
    scalar(anchor.node, s * anchor.viscosity + s * s * anchor.stiffness);
  for (const ToolSpring& tool : system.tools())
    scalar(tool.node, s * tool.viscosity + s * s * tool.stiffness);

  system.forces().springTangents(x.data(), v.data(), m_tangents);
  const auto& ends = system.forces().springEnds();
  for (std::size_t e = 0; e < ends.size(); ++e) {
    const SpringTangent& tangent = m_tangents[e];
    const double axialStiffness = convex ? std::max(tangent.axial, 0.0) : tangent.axial;
    const double lateral = s * s * (convex ? std::max(tangent.lateral, 0.0) : tangent.lateral);
    const double axial = s * s * axialStiffness + s * tangent.viscous;
    const Eigen::Matrix3d uu = tangent.direction * tangent.direction.transpose();
    Eigen::Matrix3d values = (axial - lateral) * uu;
    if (!uu.isZero(0.0)) values += lateral * Eigen::Matrix3d::Identity();
    if (!convex) {
      const Eigen::Matrix3d turn = (0.5 * s * s) * tangent.direction * tangent.shear.transpose();
      values += turn + turn.transpose();
    }
    addDiagonal(block(ends[e].a), values);
    addDiagonal(block(ends[e].b), values);
    if (m_coupling[e].column[0] < 0) continue;
    for (Index c = 0; c < 3; ++c)
      for (Index r = 0; r < 3; ++r) value[m_coupling[e].column[c] + r] -= values(r, c);
  }
  const Eigen::Map<const Eigen::ArrayXd> numbers(value, m_matrix.nonZeros());
  if (!numbers.isFinite().all()) return false;
  if (m_matrix.rows() == 0) return true;
  m_cholesky.factorize(m_matrix);
  return m_cholesky.info() == Eigen::Success;
}

} // namespace esm
