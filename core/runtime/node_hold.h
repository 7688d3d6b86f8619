// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/runtime/node_links.h"

#include <vector>

namespace esm {

/// How stiff and how damped a hand's spring may be on a node that it holds wholly.
struct NodeHold {
  double stiffness = 0.0; ///< [N/m]
  double viscosity = 0.0; ///< [N s/m]
};

/// For each node as stiff that with the hand's spring it swings and decays no faster than 1.25 times the fastest
/// one of the net: explicit steps get shorter by that at most. A hand holds many nodes on a fine mesh, so its
/// springs need not be stiffer to lead them. The damping is that of the node's own springs, or half critical for
/// its mass where that is more, within the same bound.
class NodeHolds {
public:
  explicit NodeHolds(const SpringNet& net);

  /// The net has other parameters at these nodes, or at their springs and anchors; to the bit as if made anew.
  void adapt(const SpringNet& net, std::span<const Index> nodes, NodeLinks& links);
  NodeHold at(const SpringNet& net, Index node) const;

private:
  struct Fastest {
    double rate = 0.0; ///< [1/s^2] or [1/s]
    Index node = kNoIndex;
    /// @return false if the fastest one has become slower: then somebody else may be it.
    bool take(Index candidate, double candidateRate) noexcept;
  };
  bool weigh(const SpringNet& net, Index node) noexcept;
  void findFastest(const SpringNet& net) noexcept;

  std::vector<NodeHold> m_own; ///< sums over a node's springs and anchors
  Fastest m_swing, m_decay;
};

} // namespace esm
