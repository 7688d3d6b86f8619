// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "bench/reference/condensed_matrix.h"

namespace esm::bench {

void CondensedMatrix::analyse(const FastNet& net)
{
  const auto count = static_cast<Eigen::Index>(net.nodeCount());
  std::vector<Eigen::Triplet<double>> entries;
  const auto block = [&](Eigen::Index i, Eigen::Index j) {
    for (Eigen::Index row = 0; row < 3; ++row)
      for (Eigen::Index column = 0; column < 3; ++column)
        if (i != j || row >= column) entries.emplace_back(3 * i + row, 3 * j + column, i == j ? 1.0 : 0.0);
  };
  for (Eigen::Index i = 0; i < count; ++i) block(i, i);
  for (const FastNet::Spring& spring : net.springs()) block(spring.b, spring.a); // a < b: below the diagonal
  m_matrix.resize(3 * count, 3 * count);
  m_matrix.setFromTriplets(entries.begin(), entries.end());
  m_matrix.makeCompressed();
  const auto find = [&](Eigen::Index row, Eigen::Index column) {
    const int* rows = m_matrix.innerIndexPtr();
    const int* start = m_matrix.outerIndexPtr();
    return static_cast<int>(
      std::lower_bound(rows + start[column], rows + start[column + 1], static_cast<int>(row)) - rows);
  };
  m_diagonal.clear();
  m_coupling.clear();
  for (Eigen::Index i = 0; i < count; ++i)
    m_diagonal.push_back({{find(3 * i, 3 * i), find(3 * i + 1, 3 * i + 1), find(3 * i + 2, 3 * i + 2)}});
  for (const FastNet::Spring& spring : net.springs()) {
    const Eigen::Index i = spring.b, j = spring.a;
    m_coupling.push_back({{find(3 * i, 3 * j), find(3 * i, 3 * j + 1), find(3 * i, 3 * j + 2)}});
  }
#if defined(ESM_BENCH_CHOLMOD)
  m_factor.setMode(Eigen::CholmodAuto);
#endif
  m_factor.analyzePattern(m_matrix);
  m_right.resize(3 * count);
}

bool CondensedMatrix::factor(const FastNet& net, const std::vector<FastNet::Tangent>& tangents, double gD,
                             double gK)
{
  double* values = m_matrix.valuePtr();
  std::fill(values, values + m_matrix.nonZeros(), 0.0);
  const auto addDiagonal = [&](int node, int row, int column, double value) {
    values[m_diagonal[static_cast<std::size_t>(node)].column[column] + row - column] += value;
  };
  for (int i = 0; i < static_cast<int>(net.nodeCount()); ++i)
    for (int row = 0; row < 3; ++row) addDiagonal(i, row, row, net.mass()[static_cast<std::size_t>(i)]);
  for (const FastNet::Anchor& anchor : net.anchors())
    if (!net.held(static_cast<std::size_t>(anchor.node)))
      for (int row = 0; row < 3; ++row)
        addDiagonal(anchor.node, row, row, gD * anchor.viscosity + gK * anchor.stiffness);
  for (std::size_t s = 0; s < tangents.size(); ++s) {
    const FastNet::Tangent& tangent = tangents[s];
    const FastNet::Spring& spring = net.springs()[s];
    const bool freeA = !net.held(static_cast<std::size_t>(spring.a));
    const bool freeB = !net.held(static_cast<std::size_t>(spring.b));
    const double lateral = gK * tangent.lateral, axial = gK * tangent.axial + gD * tangent.viscous - lateral;
    for (int column = 0; column < 3; ++column)
      for (int row = 0; row < 3; ++row) {
        const double value = axial * tangent.u[row] * tangent.u[column] + (row == column ? lateral : 0.0);
        if (row >= column && freeA) addDiagonal(spring.a, row, column, value);
        if (row >= column && freeB) addDiagonal(spring.b, row, column, value);
        if (freeA && freeB) values[m_coupling[s].column[column] + row] -= value;
      }
  }
  m_factor.factorize(m_matrix);
  return m_factor.info() == Eigen::Success;
}

void CondensedMatrix::solve(const Nodes& right, Nodes& solution)
{
  for (std::size_t i = 0; i < right.size(); ++i)
    for (int axis = 0; axis < 3; ++axis) m_right[static_cast<Eigen::Index>(3 * i) + axis] = right[i][axis];
  m_solution = m_factor.solve(m_right);
  solution.resize(right.size());
  for (std::size_t i = 0; i < right.size(); ++i) {
    const double* value = m_solution.data() + 3 * i;
    solution[i] = Vec4{value[0], value[1], value[2], 0.0};
  }
}

namespace {

BENCH_CLONES void addProducts(const std::vector<FastNet::Spring>& springs,
                              const std::vector<FastNet::Tangent>& tangents,
                              const std::vector<FastNet::Anchor>& anchors, double gD, double gK,
                              const Vec4* p, Vec4* y)
{
  for (std::size_t s = 0; s < springs.size(); ++s) {
    const FastNet::Tangent& tangent = tangents[s];
    const Vec4 d = p[springs[s].b] - p[springs[s].a], along = d * tangent.u;
    const double lateral = gK * tangent.lateral, axial = gK * tangent.axial + gD * tangent.viscous - lateral;
    const Vec4 value = tangent.u * (axial * (along[0] + along[1] + along[2])) + d * lateral;
    y[springs[s].a] -= value;
    y[springs[s].b] += value;
  }
  for (const FastNet::Anchor& anchor : anchors)
    y[anchor.node] += p[anchor.node] * (gD * anchor.viscosity + gK * anchor.stiffness);
}

} // namespace

void addStiffnessTimes(const FastNet& net, const std::vector<FastNet::Tangent>& tangents, double gD,
                       double gK, const Vec4* p, Vec4* y)
{
  addProducts(net.springs(), tangents, net.anchors(), gD, gK, p, y);
}

} // namespace esm::bench
