// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/contact/node_hold.h"

namespace esm {

NodeHolds::NodeHolds(const SpringNet& net) : m_holds(static_cast<std::size_t>(net.nodeCount()))
{
  const auto add = [&](Index node, double stiffness, double viscosity) {
    m_holds[static_cast<std::size_t>(node)].stiffness += stiffness;
    m_holds[static_cast<std::size_t>(node)].viscosity += viscosity;
  };
  for (Index s = 0; s < net.springCount(); ++s)
    for (int end = 0; end < 2; ++end) add(net.ends(end, s), net.stiffness[s], net.viscosity[s]);
  for (Index a = 0; a < net.anchors.count(); ++a)
    add(net.anchors.node[static_cast<std::size_t>(a)], net.anchors.stiffness[a], net.anchors.viscosity[a]);
}

void NodeHolds::adapt(const SpringNet& net, std::span<const Index> nodes, NodeLinks& links)
{
  for (const Index node : nodes) {
    NodeHold& hold = m_holds[static_cast<std::size_t>(node)];
    hold = {};
    for (const Index s : links.springsOf(net, node)) {
      hold.stiffness += net.stiffness[s];
      hold.viscosity += net.viscosity[s];
    }
    for (const Index a : links.anchorsOf(net, node)) {
      hold.stiffness += net.anchors.stiffness[a];
      hold.viscosity += net.anchors.viscosity[a];
    }
  }
}

} // namespace esm
