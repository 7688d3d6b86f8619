// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/system/implicit_matrix.h"

#include "core/base/assert.h"
#include "core/linear/gradient_sweeps.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace esm {
namespace {

// Measured against a linear spring with viscosity in the force pass on the same machine (3.5 ns): tangent and
// block of a spring, a product of the factorization, a product of the solution.
constexpr double kPerSpring = 10.0, kPerFactorProduct = 0.035, kPerSolveProduct = 0.035;
constexpr double kPerIteration = 6.0; ///< of conjugate gradients, per spring

/// Of analysis and factor of a surface of N nodes over N^1.5; what the gradients may cost before both are
/// made.
constexpr double kFactorPrice = 20.0;
constexpr std::size_t kMostNumbers = std::size_t{1} << 27; ///< of such a factor: 1 GB

constexpr double kReduction = 1e-3;    ///< of the residual, by conjugate gradients
constexpr int kMostCgIterations = 150; ///< more would be slower than a factor

ESM_INLINE Lanes unit(int axis, double length) noexcept
{
  Lanes lanes = {0, 0, 0, 0};
  lanes[axis] = length;
  return lanes;
}

void addScalar(NodeBlock& block, double amount) noexcept
{
  for (int axis = 0; axis < 3; ++axis) block.column[axis] += unit(axis, amount);
}

} // namespace

void ImplicitMatrix::prepare(const System& system, bool mayIterate)
{
  const bool sameWay = std::exchange(m_mayIterate, mayIterate) == mayIterate;
  const std::vector<Index> formerBlocks = std::move(m_blockOf);
  m_blockOf.assign(system.nodeCount(), kNoIndex);
  m_nodeOf.clear();
  for (std::size_t i = 0; i < system.nodeCount(); ++i)
    if (system.isFree(i)) {
      m_blockOf[i] = static_cast<Index>(m_nodeOf.size());
      m_nodeOf.push_back(static_cast<Index>(i));
    }
  // Other parameters are no other springs: to find an order for the factor costs hundreds of force passes.
  if (!(sameWay && formerBlocks == m_blockOf && isLaidOut(system))) layOut(system);
  m_spent = 0.0;
  constraintsChanged(system);
}

/// For these springs between these blocks, by a factor.
bool ImplicitMatrix::isLaidOut(const System& system) const noexcept
{
  const auto& ends = system.forces().springEnds();
  if (m_pairOf.size() != ends.size() || m_isIterative || m_isTooLarge || m_nodeOf.empty() ||
      (m_mayIterate && m_nodeOf.size() > kManyNodes))
    return false;
  for (std::size_t e = 0; e < ends.size(); ++e) {
    const Index a = m_blockOf[static_cast<std::size_t>(ends[e].a)],
                b = m_blockOf[static_cast<std::size_t>(ends[e].b)], pair = m_pairOf[e];
    const bool isPair = a != kNoIndex && b != kNoIndex && a != b;
    if (isPair != (pair != kNoIndex)) return false;
    if (isPair &&
        (m_pairs[static_cast<std::size_t>(pair)].a != a || m_pairs[static_cast<std::size_t>(pair)].b != b))
      return false;
  }
  return true;
}

void ImplicitMatrix::layOut(const System& system)
{
  const auto& ends = system.forces().springEnds();
  m_springs = ends.size();
  m_pairs.clear();
  m_pairOf.assign(ends.size(), kNoIndex);
  for (std::size_t e = 0; e < ends.size(); ++e) {
    const Index a = m_blockOf[static_cast<std::size_t>(ends[e].a)],
                b = m_blockOf[static_cast<std::size_t>(ends[e].b)];
    if (a == kNoIndex || b == kNoIndex || a == b) continue;
    m_pairOf[e] = static_cast<Index>(m_pairs.size());
    m_pairs.push_back({a, b});
  }
  m_isTooLarge = false;
  m_isIterative = m_mayIterate && m_nodeOf.size() > kManyNodes;
  if (!m_isIterative) m_cholesky.analyze(static_cast<Index>(m_nodeOf.size()), m_pairs);
  m_hasRoom = false;
}

void ImplicitMatrix::makeRoom()
{
  if (std::exchange(m_hasRoom, true)) return;
  if (m_isIterative) m_gradients.prepare(static_cast<Index>(m_nodeOf.size()), m_pairs);
  m_diagonal.assign(m_nodeOf.size(), {});
  m_coupling.assign(m_pairs.size(), {});
  m_vector.assign(m_nodeOf.size(), Lanes{0, 0, 0, 0});
}

void ImplicitMatrix::constraintsChanged(const System& system)
{
  for (std::size_t i = 0; i < system.nodeCount(); ++i)
    if (system.isFree(i) && m_blockOf[i] == kNoIndex) return prepare(system, m_mayIterate);
  m_free.clear();
  m_isFree.assign(m_nodeOf.size(), 0);
  for (std::size_t block = 0; block < m_nodeOf.size(); ++block)
    if (system.isFree(static_cast<std::size_t>(m_nodeOf[block]))) {
      m_free.push_back(static_cast<Index>(block));
      m_isFree[block] = 1;
    }
}

bool ImplicitMatrix::factor(const System& system, const NodeArray& x, const NodeArray& v,
                            const Shares& shares, bool convex)
{
  fill(system, x, v, shares, convex);
  m_metNegative = 0;
  const bool exists = m_isIterative
                        ? m_gradients.setMatrix(m_diagonal.data(), m_coupling.data())
                        : m_cholesky.factor(m_diagonal.data(), m_coupling.data(), system.interruption);
  if (exists) fillPressure(system, x, shares);
  return exists;
}

/// Columns and update of the pressure, by the factor at hand.
void ImplicitMatrix::fillPressure(const System& system, const NodeArray& x, const Shares& shares)
{
  const Pressure& pressure = system.forces().pressure();
  m_pressure.resize(shares.stiffness > 0.0 ? pressure.bodyCount() : 0);
  m_negativesGone = 0;
  if (m_pressure.empty()) return;
  const auto rank = static_cast<Eigen::Index>(m_pressure.size());
  Eigen::VectorXd stiffness(rank);
  NodeArray gradient(system.nodeCount());
  for (std::size_t body = 0; body < m_pressure.size(); ++body) {
    PressureColumn& column = m_pressure[body];
    column.stiffness = shares.stiffness * pressure.stiffness(body);
    stiffness[static_cast<Eigen::Index>(body)] = column.stiffness;
    std::fill(gradient.begin(), gradient.end(), Lanes{0, 0, 0, 0});
    pressure.addGradient(body, x.data(), gradient.data());
    for (std::size_t block = 0; block < m_nodeOf.size(); ++block)
      m_vector[block] =
        m_isFree[block] ? gradient[static_cast<std::size_t>(m_nodeOf[block])] : Lanes{0, 0, 0, 0};
    column.gradient = m_vector;
    solveBlocks();
    column.solved = m_vector;
  }
  Eigen::MatrixXd gram(rank, rank);
  for (Eigen::Index i = 0; i < rank; ++i)
    for (Eigen::Index j = 0; j < rank; ++j)
      gram(i, j) = sumOfProducts(m_pressure[static_cast<std::size_t>(i)].gradient,
                                 m_pressure[static_cast<std::size_t>(j)].solved);
  m_update.set(gram, stiffness);
  m_negativesGone = m_update.negativesGone();
}

double ImplicitMatrix::stiffestRate(const System& system, const NodeArray& x, const NodeArray& v)
{
  fill(system, x, v, {0.0, 0.0, 1.0}, true);
  double rate = 0.0;
  for (const Index block : m_free) {
    const NodeBlock& k = m_diagonal[static_cast<std::size_t>(block)];
    const auto node = static_cast<std::size_t>(m_nodeOf[static_cast<std::size_t>(block)]);
    rate = std::max(rate, (k.column[0][0] + k.column[1][1] + k.column[2][2]) / (3.0 * system.mass()[node]));
  }
  return rate > 0.0 ? rate : 1.0;
}

void ImplicitMatrix::fill(const System& system, const NodeArray& x, const NodeArray& v, const Shares& shares,
                          bool convex)
{
  makeRoom();
  std::fill(m_diagonal.begin(), m_diagonal.end(), NodeBlock{});
  const auto scalar = [&](Index node, double amount) {
    if (const Index block = m_blockOf[static_cast<std::size_t>(node)]; block != kNoIndex)
      addScalar(m_diagonal[static_cast<std::size_t>(block)], amount);
  };
  const auto& massDrag = system.forces().massDrag();
  for (const Index node : m_nodeOf) {
    const auto i = static_cast<std::size_t>(node);
    scalar(node, shares.mass * system.mass()[i] + (massDrag.empty() ? 0.0 : shares.viscosity * massDrag[i]));
  }
  for (const auto& anchor : system.forces().anchors())
    scalar(anchor.node, shares.viscosity * anchor.viscosity + shares.stiffness * anchor.stiffness);
  for (const ToolSpring& tool : system.tools())
    scalar(tool.node, shares.viscosity * tool.viscosity + shares.stiffness * tool.stiffness);
  system.forces().springTangents(x.data(), v.data(), m_tangents);
  addSprings(system, shares, convex);
  if (m_free.size() < m_nodeOf.size()) { // a held node: a row of its own
    for (std::size_t block = 0; block < m_nodeOf.size(); ++block)
      if (!m_isFree[block])
        for (int axis = 0; axis < 3; ++axis) m_diagonal[block].column[axis] = unit(axis, 1.0);
    for (std::size_t pair = 0; pair < m_pairs.size(); ++pair)
      if (!m_isFree[static_cast<std::size_t>(m_pairs[pair].a)] ||
          !m_isFree[static_cast<std::size_t>(m_pairs[pair].b)])
        m_coupling[pair] = NodeBlock{};
  }
}

ESM_CPU_CLONES void ImplicitMatrix::addSprings(const System& system, const Shares& shares,
                                               bool convex) noexcept
{
  const auto& ends = system.forces().springEnds();
  const auto addTo = [&](Index node, const NodeBlock& values) {
    const Index place = m_blockOf[static_cast<std::size_t>(node)];
    if (place == kNoIndex) return;
    NodeBlock& block = m_diagonal[static_cast<std::size_t>(place)];
    for (int axis = 0; axis < 3; ++axis) block.column[axis] += values.column[axis];
  };
  for (std::size_t e = 0; e < ends.size(); ++e) {
    const SpringTangent& tangent = m_tangents[e];
    const double axialStiffness = convex ? std::max(tangent.axial, 0.0) : tangent.axial;
    const double lateral = shares.stiffness * (convex ? std::max(tangent.lateral, 0.0) : tangent.lateral);
    const double axial = shares.stiffness * axialStiffness + shares.viscosity * tangent.viscous;
    const Lanes u = toLanes(tangent.direction), along = u * (axial - lateral);
    const bool isSlack = tangent.direction.isZero(0.0);
    NodeBlock values;
    for (int axis = 0; axis < 3; ++axis) {
      values.column[axis] = along * u[axis];
      if (!isSlack) values.column[axis] += unit(axis, lateral);
    }
    if (!convex) {
      const Lanes turn = toLanes(tangent.shear) * (0.5 * shares.stiffness);
      for (int axis = 0; axis < 3; ++axis) values.column[axis] += u * turn[axis] + turn * u[axis];
    }
    addTo(ends[e].a, values);
    addTo(ends[e].b, values);
    if (m_pairOf[e] == kNoIndex) continue;
    NodeBlock& coupling = m_coupling[static_cast<std::size_t>(m_pairOf[e])];
    for (int axis = 0; axis < 3; ++axis) coupling.column[axis] = -values.column[axis];
  }
}

void ImplicitMatrix::solve(NodeArray& vector)
{
  ESM_ASSERT(m_hasRoom); // there was a factor()
  for (std::size_t block = 0; block < m_nodeOf.size(); ++block)
    m_vector[block] = m_isFree[block] ? vector[static_cast<std::size_t>(m_nodeOf[block])] : Lanes{0, 0, 0, 0};
  solveBlocks();
  if (!m_pressure.empty()) {
    Eigen::VectorXd seen(static_cast<Eigen::Index>(m_pressure.size()));
    for (std::size_t body = 0; body < m_pressure.size(); ++body)
      seen[static_cast<Eigen::Index>(body)] = sumOfProducts(m_pressure[body].gradient, m_vector);
    const Eigen::VectorXd shares = m_update.shares(seen);
    for (std::size_t body = 0; body < m_pressure.size(); ++body)
      for (std::size_t block = 0; block < m_vector.size(); ++block)
        m_vector[block] -= m_pressure[body].solved[block] * shares[static_cast<Eigen::Index>(body)];
  }
  scatter(vector);
}

/// m_vector = (A without pressure)^-1 m_vector.
void ImplicitMatrix::solveBlocks()
{
  if (m_isIterative) {
    const auto result = m_gradients.solve(m_vector.data(), kReduction, kMostCgIterations);
    m_metNegative = m_metNegative != 0 || result == PreconditionedCg::Result::Indefinite;
    m_meanIterations += 0.1 * (m_gradients.iterations() - m_meanIterations);
    m_spent += m_gradients.iterations() * kPerIteration * static_cast<double>(m_springs);
    const double nodes = static_cast<double>(m_nodeOf.size());
    if (result == PreconditionedCg::Result::TooSlow || m_spent > kFactorPrice * nodes * std::sqrt(nodes))
      giveUpIterating();
  } else {
    m_cholesky.solve(m_vector.data());
  }
}

/// The vector at hand, solved as far as the gradients came, is still a direction of descent. If the factor
/// does not exist or not fit into memory, they go on.
void ImplicitMatrix::giveUpIterating()
{
  m_spent = 0.0;
  if (m_isTooLarge) return;
  m_isTooLarge = !m_cholesky.analyze(static_cast<Index>(m_nodeOf.size()), m_pairs, kMostNumbers);
  m_isIterative = m_isTooLarge || !m_cholesky.factor(m_diagonal.data(), m_coupling.data());
}

void ImplicitMatrix::scatter(NodeArray& vector) const noexcept
{
  std::fill(vector.begin(), vector.end(), Lanes{0, 0, 0, 0});
  for (std::size_t block = 0; block < m_nodeOf.size(); ++block)
    vector[static_cast<std::size_t>(m_nodeOf[block])] = m_vector[block];
}

bool ImplicitMatrix::negativeDirection(NodeArray& direction) noexcept
{
  if (m_isIterative || !m_cholesky.negativeDirection(m_vector.data())) return false;
  scatter(direction);
  return true;
}

void ImplicitMatrix::multiply(const NodeArray& vector, NodeArray& product) const noexcept
{
  std::fill(product.begin(), product.end(), Lanes{0, 0, 0, 0});
  const auto node = [&](Index block) {
    return static_cast<std::size_t>(m_nodeOf[static_cast<std::size_t>(block)]);
  };
  for (const Index block : m_free)
    product[node(block)] = times(m_diagonal[static_cast<std::size_t>(block)], vector[node(block)]);
  for (std::size_t pair = 0; pair < m_pairs.size(); ++pair) {
    const std::size_t a = node(m_pairs[pair].a), b = node(m_pairs[pair].b);
    product[a] += times(m_coupling[pair], vector[b]);
    product[b] += times(m_coupling[pair], vector[a]);
  }
  for (const PressureColumn& column : m_pressure) {
    double along = 0.0;
    for (const Index block : m_free)
      along += dot(column.gradient[static_cast<std::size_t>(block)], vector[node(block)]);
    for (const Index block : m_free)
      product[node(block)] += column.gradient[static_cast<std::size_t>(block)] * (column.stiffness * along);
  }
}

double ImplicitMatrix::factorCost() const noexcept
{
  if (m_isIterative) return kPerSpring * static_cast<double>(m_springs);
  return kPerSpring * static_cast<double>(m_springs) + kPerFactorProduct * m_cholesky.factorWork();
}

double ImplicitMatrix::solveCost() const noexcept
{
  if (m_isIterative) return m_meanIterations * kPerIteration * static_cast<double>(m_springs);
  return kPerSolveProduct * m_cholesky.solveWork();
}

} // namespace esm
