// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/net/spring_net.h"

#include <vector>

namespace esm {

/// Changes of a net's topology that keep all its arrays together, those that may be absent too.

/// Appends nodes and springs as resizeNet() makes them, with ids above those that there are. New nodes lie at
/// the origin, new springs have no ends yet: the caller sets both.
void growNet(SpringNet& net, Index nodes, Index springs);

/// What goes away, one flag per node and spring.
struct NetCut {
  std::vector<std::uint8_t> node, spring;
};
/// Removes the marked nodes, with their anchors and triangles, and the marked springs and those whose end
/// goes. A pressure body that loses a node is open, and goes as a whole. Ids of what stays stay. @return
/// old-to-new map of the nodes, kNoIndex for those that are gone.
std::vector<Index> shrinkNet(SpringNet& net, const NetCut& cut);
/// What shrinkNet() would leave of a net that stays whole. @param newOfNode  the map, if not null.
SpringNet remainingNet(const SpringNet& net, const NetCut& cut, std::vector<Index>* newOfNode = nullptr);

/// Leaves those anchors alone. @param stay their numbers, rising.
void keepAnchors(AnchorSet& anchors, const std::vector<Index>& stay);

} // namespace esm
