// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/net/node_links.h"

#include <vector>

namespace esm {

/// What springs and anchors hold a node with.
struct NodeHold {
  double stiffness = 0.0; ///< sum [N/m]
  double viscosity = 0.0; ///< sum [N s/m]
};

/// How firmly a net holds each of its nodes.
class NodeHolds {
public:
  explicit NodeHolds(const SpringNet& net);

  /// The net has other parameters at these nodes' springs and anchors; to the bit as if made anew.
  void adapt(const SpringNet& net, std::span<const Index> nodes, NodeLinks& links);
  const NodeHold& at(Index node) const { return m_holds[static_cast<std::size_t>(node)]; }

private:
  std::vector<NodeHold> m_holds;
};

} // namespace esm
