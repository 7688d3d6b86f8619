// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/forces/spring_law.h"

#include <algorithm>
#include <limits>

namespace esm {
namespace {

constexpr std::int64_t kDistance = 12; ///< springs in flight at once; beyond it nothing was gained
constexpr std::size_t kLookAhead = 64; ///< springs that a late one may be overtaken by

} // namespace

std::vector<std::size_t> conflictFreeOrder(std::size_t nodeCount,
                                           std::initializer_list<std::span<const Index>> nodes)
{
  const std::size_t count = nodes.begin()->size();
  std::vector<std::int64_t> lastUse(nodeCount, -kDistance);
  const auto use = [&](Index node) -> std::int64_t& { return lastUse[static_cast<std::size_t>(node)]; };
  std::vector<std::size_t> order, waiting; // those that were overtaken, oldest first
  order.reserve(count);
  waiting.reserve(kLookAhead);
  std::size_t next = 0;
  while (order.size() < count) {
    const auto place = static_cast<std::int64_t>(order.size());
    while (waiting.size() < kLookAhead && next < count) waiting.push_back(next++);
    // The first that is far enough from its neighbours, or else the one that is farthest.
    std::size_t best = 0;
    std::int64_t bestDistance = -1;
    for (std::size_t i = 0; i < waiting.size() && bestDistance < kDistance; ++i) {
      std::int64_t latest = -kDistance;
      for (const std::span<const Index> node : nodes) latest = std::max(latest, use(node[waiting[i]]));
      const std::int64_t distance = place - latest;
      if (distance <= bestDistance) continue;
      best = i;
      bestDistance = distance;
    }
    order.push_back(waiting[best]);
    waiting.erase(waiting.begin() + static_cast<std::ptrdiff_t>(best));
    for (const std::span<const Index> node : nodes) use(node[order.back()]) = place;
  }
  return order;
}

} // namespace esm
