// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/methods/stiff_nodes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace esm {
namespace {

constexpr std::size_t kMostStiff = 8; ///< their matrix is dense
/// Nodes for each of them: an error counts over all nodes, and what these few do fastest is not followed.
constexpr std::size_t kOthersEach = 16;
/// Of Verlet's limit; rows bound it from above, but directions turn until the next look.
constexpr double kOfLimit = 0.9;

/// Verlet's limit h^2 w2 / 4 + 3/5 h g < 1.
double verletLimit(double stiffness, double damping) noexcept
{
  const double linear = 0.6 * damping, sum = linear + std::sqrt(linear * linear + stiffness);
  return sum > 0.0 ? kOfLimit * 2.0 / sum : std::numeric_limits<double>::infinity();
}

/// What acts on single nodes: visit(node, k, c).
template <class Visit>
void forEachSingle(const System& system, const Visit& visit)
{
  for (const Anchor& anchor : system.forces().anchors())
    visit(anchor.node, anchor.stiffness, anchor.viscosity);
  for (const ToolSpring& tool : system.tools()) visit(tool.node, tool.stiffness, tool.viscosity);
  const auto& drag = system.forces().massDrag();
  for (std::size_t i = 0; i < drag.size(); ++i) visit(static_cast<Index>(i), 0.0, drag[i]);
}

/// join(a, b, k, c) by the springs' parameters.
template <class Join>
void forEachSpring(const System& system, const Join& join)
{
  for (const SpringBatch& batch : system.forces().batches())
    for (std::size_t i = 0; i < batch.count; ++i)
      join(batch.a[i], batch.b[i], batch.stiffness[i], batch.viscosity[i]);
}

} // namespace

std::vector<Index> StiffNodes::find(const System& system)
{
  const auto& inverseMass = system.inverseMass();
  const std::size_t count = inverseMass.size();
  if (count <= kOthersEach || !system.forces().pressure().isEmpty()) return {};
  std::vector<double> stiffness(count, 0.0), damping(count, 0.0);
  const auto add = [&](Index node, double k, double c) {
    stiffness[at(node)] += k * inverseMass[at(node)];
    damping[at(node)] += c * inverseMass[at(node)];
  };
  forEachSingle(system, add);
  forEachSpring(system, [&](Index a, Index b, double k, double c) {
    add(a, k, c);
    add(b, k, c);
  });
  // By their limits; the few end where two neighbours in this order are furthest apart.
  std::vector<Index> order(count);
  for (std::size_t i = 0; i < count; ++i) order[i] = static_cast<Index>(i);
  const auto limit = [&](Index node) { return verletLimit(stiffness[at(node)], damping[at(node)]); };
  const std::size_t most = std::min(kMostStiff, count / kOthersEach);
  std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(most + 1), order.end(),
                    [&](Index a, Index b) { return limit(a) < limit(b); });
  std::size_t few = 0;
  double widest = kGain;
  for (std::size_t i = 0; i < most; ++i)
    if (const double gap = limit(order[i + 1]) / limit(order[i]); gap >= widest) {
      widest = gap;
      few = i + 1;
    }
  order.resize(few);
  return order;
}

void StiffNodes::prepare(const System& system, std::vector<Index> nodes)
{
  m_nodes = std::move(nodes);
  m_placeOf.assign(system.nodeCount(), kNoIndex);
  for (std::size_t i = 0; i < m_nodes.size(); ++i) m_placeOf[at(m_nodes[i])] = static_cast<Index>(i);
  const auto size = static_cast<Eigen::Index>(3 * m_nodes.size());
  m_springs.setZero(size, size);
  m_dampers.setZero(size, size);
  m_rowStiffness.assign(system.nodeCount(), 0.0);
  m_rowDamping.assign(system.nodeCount(), 0.0);
  forEachSpring(system, [&](Index a, Index b, double k, double c) { addRows(system, a, b, k, c); });
  addSingles(system);
  findLimit();
}

/// Gershgorin's rows over the nodes that are not held.
void StiffNodes::addRows(const System& system, Index a, Index b, double k, double c)
{
  const auto& inverseMass = system.inverseMass();
  const double cross = isStiff(a) || isStiff(b) ? 0.0 : std::sqrt(inverseMass[at(a)] * inverseMass[at(b)]);
  for (const Index node : {a, b}) {
    m_rowStiffness[at(node)] += k * (inverseMass[at(node)] + cross);
    m_rowDamping[at(node)] += c * (inverseMass[at(node)] + cross);
  }
}

/// To K and D of the few.
void StiffNodes::addSpring(const SpringTangent& tangent, Index a, Index b)
{
  const Eigen::Matrix3d along = tangent.direction * tangent.direction.transpose(),
                        k = (tangent.axial - tangent.lateral) * along +
                            tangent.lateral * Eigen::Matrix3d::Identity(),
                        c = tangent.viscous * along;
  const auto add = [&](Index one, Index other, double sign) {
    if (!isStiff(one) || !isStiff(other)) return;
    const Index row = 3 * m_placeOf[at(one)], column = 3 * m_placeOf[at(other)];
    m_springs.block<3, 3>(row, column) += sign * k;
    m_dampers.block<3, 3>(row, column) += sign * c;
  };
  add(a, a, 1.0);
  add(b, b, 1.0);
  add(a, b, -1.0);
  add(b, a, -1.0);
}

void StiffNodes::addSingles(const System& system)
{
  forEachSingle(system, [&](Index node, double k, double c) {
    m_rowStiffness[at(node)] += k * system.inverseMass()[at(node)];
    m_rowDamping[at(node)] += c * system.inverseMass()[at(node)];
    if (!isStiff(node)) return;
    const Index place = 3 * m_placeOf[at(node)];
    m_springs.diagonal().segment<3>(place).array() += k;
    m_dampers.diagonal().segment<3>(place).array() += c;
  });
}

void StiffNodes::findLimit()
{
  m_stiffness = m_damping = 0.0;
  for (std::size_t i = 0; i < m_placeOf.size(); ++i) {
    if (m_placeOf[i] != kNoIndex) continue;
    m_stiffness = std::max(m_stiffness, m_rowStiffness[i]);
    m_damping = std::max(m_damping, m_rowDamping[i]);
  }
  m_step = verletLimit(m_stiffness, m_damping);
}

void StiffNodes::look(const System& system, const NodeArray& x, const NodeArray& v)
{
  m_springs.setZero();
  m_dampers.setZero();
  std::fill(m_rowStiffness.begin(), m_rowStiffness.end(), 0.0);
  std::fill(m_rowDamping.begin(), m_rowDamping.end(), 0.0);
  system.forces().springTangents(x.data(), v.data(), m_tangents);
  const auto& ends = system.forces().springEnds();
  for (std::size_t s = 0; s < ends.size(); ++s) {
    const SpringTangent& tangent = m_tangents[s];
    const double k = std::max(tangent.axial, 0.0) + std::abs(tangent.lateral);
    addRows(system, ends[s].a, ends[s].b, k, tangent.viscous);
    if (isStiff(ends[s].a) || isStiff(ends[s].b)) addSpring(tangent, ends[s].a, ends[s].b);
  }
  addSingles(system);
  findLimit();
}

bool StiffNodes::prepareAnswer(const System& system, double h)
{
  Eigen::MatrixXd matrix = m_springs + (2.0 / h) * m_dampers;
  for (std::size_t i = 0; i < m_nodes.size(); ++i)
    matrix.diagonal().segment<3>(static_cast<Eigen::Index>(3 * i)).array() +=
      4.0 / (h * h) * system.mass()[at(m_nodes[i])];
  const Eigen::LLT<Eigen::MatrixXd> factor(matrix);
  if (factor.info() != Eigen::Success) return false;
  m_answer = factor.solve(Eigen::MatrixXd::Identity(matrix.rows(), matrix.cols()));
  return true;
}

void StiffNodes::learn(const Eigen::VectorXd& displacement, const Eigen::VectorXd& force)
{
  constexpr double kLeast = 0.2; // of what was foretold: less is another branch, not another slope
  const Eigen::VectorXd expected = m_answer * force;
  const double along = displacement.dot(expected);
  if (!(along > kLeast * displacement.squaredNorm())) return;
  const Eigen::RowVectorXd row = displacement.transpose() * m_answer;
  m_answer += (displacement - expected) * row / along;
}

} // namespace esm
