// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/runtime/static_compliance.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

constexpr double kBudget = 3e5;           ///< of a frame, in spring evaluations: about a millisecond
constexpr double kLongestInterval = 30.0; ///< frames

/// Nodes in the order of their distance from the point, in springs; at most `most`.
std::vector<Index> nodesAround(const SpringNet& net, const NodeCombination& point, Index most)
{
  std::vector<Index> first(static_cast<std::size_t>(net.nodeCount()) + 1, 0);
  for (Index s = 0; s < net.springCount(); ++s)
    for (int end = 0; end < 2; ++end) ++first[static_cast<std::size_t>(net.ends(end, s)) + 1];
  for (std::size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
  std::vector<Index> neighbour(2 * static_cast<std::size_t>(net.springCount())), place(first);
  for (Index s = 0; s < net.springCount(); ++s)
    for (int end = 0; end < 2; ++end)
      neighbour[static_cast<std::size_t>(place[static_cast<std::size_t>(net.ends(end, s))]++)] =
        net.ends(1 - end, s);
  std::vector<std::uint8_t> met(static_cast<std::size_t>(net.nodeCount()), 0);
  std::vector<Index> nodes;
  const auto meet = [&](Index node) {
    if (met[static_cast<std::size_t>(node)] || std::ssize(nodes) >= most) return;
    met[static_cast<std::size_t>(node)] = 1;
    nodes.push_back(node);
  };
  for (const Index node : point.node) meet(node);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const auto node = static_cast<std::size_t>(nodes[i]);
    for (Index n = first[node]; n < first[node + 1]; ++n) meet(neighbour[static_cast<std::size_t>(n)]);
  }
  return nodes;
}

} // namespace

void StaticCompliance::prepare(const Simulation& simulation, const NodeCombination& point)
{
  m_parts = std::make_unique<Parts>();
  const SpringNet& net = simulation.net();
  if (net.nodeCount() > kMostNodes) {
    SpringNet part = net;
    std::fill(part.fixed.begin(), part.fixed.end(), std::uint8_t{1});
    m_parts->inner.assign(part.fixed.size(), 0);
    const std::vector<Index> nodes = nodesAround(net, point, kMostNodes);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const auto node = static_cast<std::size_t>(nodes[i]);
      part.fixed[node] = net.fixed[node];
      m_parts->inner[node] = i < nodes.size() / 8; // on a surface: a third of the way to the rim
    }
    m_parts->system = System(part, simulation.loads());
  } else {
    m_parts->system = System(net, simulation.loads());
  }
  const auto count = static_cast<std::size_t>(net.nodeCount());
  m_parts->vector.resize(count);
  m_parts->motion.x.resize(count);
  m_parts->motion.v.resize(count);
}

void StaticCompliance::renew(const Simulation& simulation)
{
  Parts& parts = *m_parts;
  copyNodes(simulation.state().position, parts.motion.x);
  copyNodes(simulation.state().velocity, parts.motion.v);
  parts.motion.time = simulation.state().time;
  const bool isFirst = !parts.hasFactor;
  const bool changed = parts.system.enter(parts.motion, true);
  if (isFirst)
    parts.matrix.prepare(parts.system);
  else if (changed)
    parts.matrix.constraintsChanged(parts.system);
  parts.hasFactor = parts.matrix.factor(parts.system, parts.motion.x, parts.motion.v, {1.0, 0.0, 1.0}, true);
  parts.age = 0;
  parts.interval =
    static_cast<int>(std::clamp(std::ceil(parts.matrix.factorCost() / kBudget), 1.0, kLongestInterval));
}

Eigen::Matrix3d StaticCompliance::at(const Simulation& simulation, const NodeCombination& point)
{
  const bool leaves =
    m_parts && !m_parts->inner.empty() && m_parts->inner[static_cast<std::size_t>(point.node[0])] == 0;
  if (!m_parts || leaves) prepare(simulation, point);
  if (!m_parts->hasFactor || ++m_parts->age >= m_parts->interval) renew(simulation);
  Eigen::Matrix3d compliance = Eigen::Matrix3d::Zero();
  if (!m_parts->hasFactor || m_parts->matrix.freeCount() == 0) return compliance;
  for (int axis = 0; axis < 3; ++axis) {
    std::fill(m_parts->vector.begin(), m_parts->vector.end(), Lanes{0, 0, 0, 0});
    for (std::size_t i = 0; i < point.node.size(); ++i)
      m_parts->vector[static_cast<std::size_t>(point.node[i])][axis] += point.weight[i];
    m_parts->matrix.solve(m_parts->vector);
    for (std::size_t i = 0; i < point.node.size(); ++i)
      compliance.col(axis) +=
        point.weight[i] * toVector(m_parts->vector[static_cast<std::size_t>(point.node[i])]);
  }
  if (!compliance.allFinite()) return Eigen::Matrix3d::Zero();
  return 0.5 * (compliance + compliance.transpose());
}

} // namespace esm
