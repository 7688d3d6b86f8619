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

std::vector<Index> conflictFreeOrder(const SpringNet& net, const std::vector<Index>& springs)
{
  std::vector<std::int64_t> lastUse(static_cast<std::size_t>(net.nodeCount()), -kDistance);
  const auto use = [&](Index spring, int end) -> std::int64_t& {
    return lastUse[static_cast<std::size_t>(net.ends(end, spring))];
  };
  std::vector<Index> order, waiting; // those that were overtaken, oldest first
  order.reserve(springs.size());
  waiting.reserve(kLookAhead);
  auto next = springs.begin();
  while (order.size() < springs.size()) {
    const auto place = static_cast<std::int64_t>(order.size());
    while (waiting.size() < kLookAhead && next != springs.end()) waiting.push_back(*next++);
    // The first that is far enough from its neighbours, or else the one that is farthest.
    std::size_t best = 0;
    std::int64_t bestDistance = -1;
    for (std::size_t i = 0; i < waiting.size() && bestDistance < kDistance; ++i) {
      const std::int64_t distance = place - std::max(use(waiting[i], 0), use(waiting[i], 1));
      if (distance <= bestDistance) continue;
      best = i;
      bestDistance = distance;
    }
    const Index spring = waiting[best];
    waiting.erase(waiting.begin() + static_cast<std::ptrdiff_t>(best));
    use(spring, 0) = use(spring, 1) = place;
    order.push_back(spring);
  }
  return order;
}

} // namespace esm
