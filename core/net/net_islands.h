// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/net/spring_net.h"

#include <cstddef>
#include <vector>

namespace esm {

/// Nodes of a net that hang together.
struct NetIsland {
  std::vector<Index> nodes, springs; ///< places in the whole net, rising
};

/// The parts of a net that neither a spring nor a pressure body joins: no part feels what happens in another.
/// In the order of their first nodes. Nodes without springs and pressure are one island.
/// @param most  islands, >= 1: if there are more, those with the fewest springs are put together.
std::vector<NetIsland> findIslands(const SpringNet& net, std::size_t most);

/// The island as a net of its own, with ids as they are.
SpringNet islandNet(const SpringNet& net, const NetIsland& island);

} // namespace esm
