// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/net/spring_net.h"

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
std::vector<NodeHold> holdOfNodes(const SpringNet& net);

} // namespace esm
