// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/runtime/node_hold.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

constexpr double kRate = 1.25; ///< of the fastest node's, with the hand's spring [1]
/// Of the hand's spring to the node's own: stiffer leads hardly better [1].
constexpr double kMostRatio = 3.0;
constexpr double kDampingRatio = 0.5; ///< of the node's mass on the hand's spring [1]

} // namespace

NodeHolds::NodeHolds(const SpringNet& net) : m_own(static_cast<std::size_t>(net.nodeCount()))
{
  const auto add = [&](Index node, double stiffness, double viscosity) {
    m_own[static_cast<std::size_t>(node)].stiffness += stiffness;
    m_own[static_cast<std::size_t>(node)].viscosity += viscosity;
  };
  for (Index s = 0; s < net.springCount(); ++s)
    for (int end = 0; end < 2; ++end) add(net.ends(end, s), net.stiffness[s], net.viscosity[s]);
  for (Index a = 0; a < net.anchors.count(); ++a)
    add(net.anchors.node[static_cast<std::size_t>(a)], net.anchors.stiffness[a], net.anchors.viscosity[a]);
  findFastest(net);
}

bool NodeHolds::Fastest::take(Index candidate, double candidateRate) noexcept
{
  if (candidate == node && candidateRate < rate) return false;
  if (candidateRate > rate) {
    rate = candidateRate;
    node = candidate;
  }
  return true;
}

bool NodeHolds::weigh(const SpringNet& net, Index node) noexcept
{
  const auto i = static_cast<std::size_t>(node);
  if (net.fixed[i]) return true;
  const bool swings = m_swing.take(node, m_own[i].stiffness / net.mass[node]);
  return m_decay.take(node, m_own[i].viscosity / net.mass[node]) && swings;
}

void NodeHolds::findFastest(const SpringNet& net) noexcept
{
  m_swing = m_decay = {};
  for (Index node = 0; node < net.nodeCount(); ++node) weigh(net, node);
}

void NodeHolds::adapt(const SpringNet& net, std::span<const Index> nodes, NodeLinks& links)
{
  bool isKnown = true;
  for (const Index node : nodes) {
    NodeHold& own = m_own[static_cast<std::size_t>(node)];
    own = {};
    for (const Index s : links.springsOf(net, node)) {
      own.stiffness += net.stiffness[s];
      own.viscosity += net.viscosity[s];
    }
    for (const Index a : links.anchorsOf(net, node)) {
      own.stiffness += net.anchors.stiffness[a];
      own.viscosity += net.anchors.viscosity[a];
    }
    isKnown = weigh(net, node) && isKnown;
  }
  if (!isKnown) findFastest(net);
}

NodeHold NodeHolds::at(const SpringNet& net, Index node) const
{
  const NodeHold& own = m_own[static_cast<std::size_t>(node)];
  const double stiffness = own.stiffness, mass = net.mass[node];
  NodeHold hold;
  if (!(stiffness > 0.0)) return hold;
  // Dampers slower than the swing cost nothing.
  const double decay = std::max(kRate * m_decay.rate, std::sqrt(m_swing.rate)); // [1/s]
  // As damped as the node's own springs are: methods that know dampers slow the fast modes by them.
  const double relaxation = own.viscosity / stiffness, slack = decay * mass - own.viscosity;
  double room = kRate * kRate * m_swing.rate * mass - stiffness;
  if (relaxation > 0.0) room = std::min(room, slack / relaxation);
  hold.stiffness = std::clamp(room, 0.0, kMostRatio * stiffness);
  const double least = 2.0 * kDampingRatio * std::sqrt(hold.stiffness * mass);
  hold.viscosity = std::max(relaxation * hold.stiffness, std::clamp(slack, 0.0, least));
  return hold;
}

} // namespace esm
