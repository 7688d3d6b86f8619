// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/contact/static_compliance.h"

#include "core/net/net_builder.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

constexpr double kBudget = 3e5;           ///< of a frame, in spring evaluations: about a millisecond
constexpr double kLongestInterval = 30.0; ///< frames

/// Nodes in the order of their distance from the point, in springs; at most `most`.
std::vector<Index> nodesAround(const SpringNet& net, const NodeCombination& point, Index most,
                               NodeLinks& links)
{
  std::vector<std::uint8_t> met(static_cast<std::size_t>(net.nodeCount()), 0);
  std::vector<Index> nodes;
  const auto meet = [&](Index node) {
    if (met[static_cast<std::size_t>(node)] || std::ssize(nodes) >= most) return;
    met[static_cast<std::size_t>(node)] = 1;
    nodes.push_back(node);
  };
  for (const Index node : point.node) meet(node);
  for (std::size_t i = 0; i < nodes.size() && std::ssize(nodes) < most; ++i)
    for (const Index s : links.springsOf(net, nodes[i]))
      meet(net.ends(net.ends(0, s) == nodes[i] ? 1 : 0, s));
  return nodes;
}

void sortOnce(std::vector<Index>& list)
{
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

/// Some nodes of a net with all that pulls at them, closed by those at the other ends, which are held.
class PartNet {
public:
  SpringNet net;
  std::vector<Index> nodes; ///< of the whole net, rising

  PartNet(const SpringNet& whole, std::vector<Index> inside, NodeLinks& links)
  {
    sortOnce(inside);
    std::vector<Index> springs, anchors;
    for (const Index node : inside) {
      const auto own = links.springsOf(whole, node), held = links.anchorsOf(whole, node);
      springs.insert(springs.end(), own.begin(), own.end());
      anchors.insert(anchors.end(), held.begin(), held.end());
    }
    sortOnce(springs);
    sortOnce(anchors);
    nodes = inside;
    for (const Index s : springs) nodes.insert(nodes.end(), {whole.ends(0, s), whole.ends(1, s)});
    for (const PressureBody& body : whole.pressure)
      for (const Index node : body.triangles.reshaped()) nodes.push_back(node);
    sortOnce(nodes);
    resizeNet(net, static_cast<Index>(nodes.size()), static_cast<Index>(springs.size()));
    takeNodes(whole, inside);
    takeSprings(whole, springs);
    takeAnchors(whole, anchors);
    net.pressure = whole.pressure;
    for (PressureBody& body : net.pressure)
      for (Index& node : body.triangles.reshaped()) node = placeOf(node);
  }
  Index placeOf(Index node) const
  {
    return static_cast<Index>(std::lower_bound(nodes.begin(), nodes.end(), node) - nodes.begin());
  }

private:
  void takeNodes(const SpringNet& whole, const std::vector<Index>& inside)
  {
    if (whole.massDamping.size() > 0) net.massDamping.resize(net.nodeCount());
    for (Index i = 0; i < net.nodeCount(); ++i) {
      const Index node = nodes[static_cast<std::size_t>(i)];
      const bool isInside = std::binary_search(inside.begin(), inside.end(), node);
      net.restPosition.col(i) = whole.restPosition.col(node);
      net.mass[i] = whole.mass[node];
      if (whole.massDamping.size() > 0) net.massDamping[i] = whole.massDamping[node];
      net.fixed[static_cast<std::size_t>(i)] =
        isInside ? whole.fixed[static_cast<std::size_t>(node)] : std::uint8_t{1};
    }
  }
  void takeSprings(const SpringNet& whole, const std::vector<Index>& springs)
  {
    net.tables = whole.tables;
    for (Index s = 0; s < net.springCount(); ++s) {
      const auto to = static_cast<std::size_t>(s);
      const Index from = springs[to];
      const auto place = static_cast<std::size_t>(from);
      for (const int end : {0, 1}) net.ends(end, s) = placeOf(whole.ends(end, from));
      net.restLength[s] = whole.restLength[from];
      net.stiffness[s] = whole.stiffness[from];
      net.viscosity[s] = whole.viscosity[from];
      net.law[to] = whole.law[place];
      net.lawParameter[s] = whole.lawParameter[from];
      net.tensionOnly[to] = whole.tensionOnly[place];
    }
  }
  void takeAnchors(const SpringNet& whole, const std::vector<Index>& anchors)
  {
    AnchorSet& set = net.anchors;
    const auto count = static_cast<Eigen::Index>(anchors.size());
    set.point.resize(3, count);
    set.stiffness.resize(count);
    set.viscosity.resize(count);
    for (Eigen::Index k = 0; k < count; ++k) {
      const Index from = anchors[static_cast<std::size_t>(k)];
      set.node.push_back(placeOf(whole.anchors.node[static_cast<std::size_t>(from)]));
      set.point.col(k) = whole.anchors.point.col(from);
      set.stiffness[k] = whole.anchors.stiffness[from];
      set.viscosity[k] = whole.anchors.viscosity[from];
    }
  }
};

/// The loads on the part: what holds its nodes matters, what pulls at them does not.
Loads loadsOn(const PartNet& part, const Loads& loads)
{
  Loads own;
  own.gravity = loads.gravity;
  for (const PrescribedMotion& motion : loads.motions) {
    std::vector<Index> places;
    for (const Index node : motion.nodes)
      if (std::binary_search(part.nodes.begin(), part.nodes.end(), node))
        places.push_back(part.placeOf(node));
    if (!places.empty()) own.motions.push_back({std::move(places), motion.displacement, motion.release});
  }
  return own;
}

} // namespace

std::size_t StaticCompliance::Parts::placeOf(Index node) const noexcept
{
  if (nodes.empty()) return static_cast<std::size_t>(node);
  const auto found = std::lower_bound(nodes.begin(), nodes.end(), node);
  return found != nodes.end() && *found == node ? static_cast<std::size_t>(found - nodes.begin())
                                                : system.nodeCount();
}

void StaticCompliance::adapt(std::span<const Index> nodes) noexcept
{
  if (!m_parts) return;
  const auto isIn = [this](Index node) { return m_parts->placeOf(node) < m_parts->system.nodeCount(); };
  if (std::any_of(nodes.begin(), nodes.end(), isIn)) forget();
}

void StaticCompliance::prepare(const Simulation& simulation, const NodeCombination& point, NodeLinks& links)
{
  m_parts = std::make_unique<Parts>();
  const SpringNet& net = simulation.net();
  if (net.nodeCount() > kMostNodes) {
    const std::vector<Index> nodes = nodesAround(net, point, kMostNodes, links);
    m_parts->inner.assign(nodes.begin(),
                          nodes.begin() + std::ssize(nodes) / 8); // a third of the way to the rim
    std::sort(m_parts->inner.begin(), m_parts->inner.end());
    PartNet part(net, nodes, links);
    m_parts->system = System(part.net, loadsOn(part, simulation.loads()));
    m_parts->nodes = std::move(part.nodes);
  } else {
    m_parts->system = System(net, simulation.loads());
  }
  const std::size_t count = m_parts->system.nodeCount();
  m_parts->vector.resize(count);
  m_parts->motion.x.resize(count);
  m_parts->motion.v.resize(count);
}

void StaticCompliance::renew(const Simulation& simulation)
{
  Parts& parts = *m_parts;
  const NetState& state = simulation.state();
  if (parts.nodes.empty()) {
    copyNodes(state.position, parts.motion.x);
    copyNodes(state.velocity, parts.motion.v);
  }
  for (std::size_t i = 0; i < parts.nodes.size(); ++i) {
    parts.motion.x[i] = toLanes(state.position.col(parts.nodes[i]));
    parts.motion.v[i] = toLanes(state.velocity.col(parts.nodes[i]));
  }
  parts.motion.time = state.time;
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

Eigen::Matrix3d StaticCompliance::at(const Simulation& simulation, const NodeCombination& point,
                                     NodeLinks& links)
{
  const bool leaves = m_parts && !m_parts->nodes.empty() &&
                      !std::binary_search(m_parts->inner.begin(), m_parts->inner.end(), point.node[0]);
  if (!m_parts || leaves) prepare(simulation, point, links);
  if (!m_parts->hasFactor || ++m_parts->age >= m_parts->interval) renew(simulation);
  Eigen::Matrix3d compliance = Eigen::Matrix3d::Zero();
  if (!m_parts->hasFactor || m_parts->matrix.freeCount() == 0) return compliance;
  NodeArray& vector = m_parts->vector;
  for (int axis = 0; axis < 3; ++axis) {
    std::fill(vector.begin(), vector.end(), Lanes{0, 0, 0, 0});
    const auto forEachNode = [&](const auto& visit) {
      for (std::size_t i = 0; i < point.node.size(); ++i)
        if (const std::size_t place = m_parts->placeOf(point.node[i]); place < vector.size())
          visit(vector[place], point.weight[i]);
    };
    forEachNode([&](Lanes& entry, double weight) { entry[axis] += weight; });
    m_parts->matrix.solve(vector);
    forEachNode([&](const Lanes& entry, double weight) { compliance.col(axis) += weight * toVector(entry); });
  }
  if (!compliance.allFinite()) return Eigen::Matrix3d::Zero();
  return 0.5 * (compliance + compliance.transpose());
}

} // namespace esm
