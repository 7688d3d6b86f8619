// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/net/net_islands.h"

#include "core/geometry/union_find.h"
#include "core/net/net_edit.h"

#include <algorithm>
#include <numeric>

namespace esm {
namespace {

/// By node: the islands are numbered by their first nodes.
std::vector<Index> numberIslands(const SpringNet& net, Index& count)
{
  const Index nodes = net.nodeCount();
  UnionFind sets(nodes);
  std::vector<std::uint8_t> isJoined(static_cast<std::size_t>(nodes), 0);
  const auto join = [&](Index a, Index b) {
    sets.join(a, b);
    for (const Index node : {a, b}) isJoined[static_cast<std::size_t>(node)] = 1;
  };
  for (const auto& ends : net.ends.colwise()) join(ends[0], ends[1]);
  for (const PressureBody& body : net.pressure)
    for (const Index corner : body.triangles.reshaped()) join(body.triangles(0, 0), corner);
  Index lone = kNoIndex; // stands for all that nothing joins
  for (Index node = 0; node < nodes; ++node) {
    if (isJoined[static_cast<std::size_t>(node)]) continue;
    if (lone == kNoIndex) lone = node;
    sets.join(lone, node);
  }
  std::vector<Index> island(static_cast<std::size_t>(nodes), kNoIndex);
  count = 0;
  for (Index node = 0; node < nodes; ++node) { // the smallest member stands for its set
    const Index root = sets.root(node);
    island[static_cast<std::size_t>(node)] = root == node ? count++ : island[static_cast<std::size_t>(root)];
  }
  return island;
}

/// Puts together what has the fewest springs, until `most` are left.
void joinSmall(const SpringNet& net, std::size_t most, std::vector<Index>& island, Index& count)
{
  std::vector<Index> springs(static_cast<std::size_t>(count), 0), bySize(springs.size());
  for (Index s = 0; s < net.springCount(); ++s)
    ++springs[static_cast<std::size_t>(island[static_cast<std::size_t>(net.ends(0, s))])];
  std::iota(bySize.begin(), bySize.end(), 0);
  std::stable_sort(bySize.begin(), bySize.end(), [&](Index a, Index b) {
    return springs[static_cast<std::size_t>(a)] > springs[static_cast<std::size_t>(b)];
  });
  std::vector<std::uint8_t> isSmall(bySize.size(), 0);
  for (std::size_t i = most - 1; i < bySize.size(); ++i) isSmall[static_cast<std::size_t>(bySize[i])] = 1;
  std::vector<Index> number(bySize.size(), kNoIndex);
  Index next = 0, rest = kNoIndex;
  for (std::size_t i = 0; i < number.size(); ++i) {
    if (isSmall[i] && rest == kNoIndex) rest = next++;
    number[i] = isSmall[i] ? rest : next++;
  }
  for (Index& of : island) of = number[static_cast<std::size_t>(of)];
  count = next;
}

} // namespace

std::vector<NetIsland> findIslands(const SpringNet& net, std::size_t most)
{
  Index count = 0;
  std::vector<Index> island = numberIslands(net, count);
  if (static_cast<std::size_t>(count) > most) joinSmall(net, most, island, count);
  std::vector<NetIsland> islands(static_cast<std::size_t>(count));
  const auto of = [&](Index node) -> NetIsland& {
    return islands[static_cast<std::size_t>(island[static_cast<std::size_t>(node)])];
  };
  for (Index node = 0; node < net.nodeCount(); ++node) of(node).nodes.push_back(node);
  for (Index s = 0; s < net.springCount(); ++s) of(net.ends(0, s)).springs.push_back(s);
  return islands;
}

SpringNet islandNet(const SpringNet& net, const NetIsland& island)
{
  NetCut cut{std::vector<std::uint8_t>(static_cast<std::size_t>(net.nodeCount()), 1),
             std::vector<std::uint8_t>(static_cast<std::size_t>(net.springCount()), 1)};
  for (const Index node : island.nodes) cut.node[static_cast<std::size_t>(node)] = 0;
  for (const Index spring : island.springs) cut.spring[static_cast<std::size_t>(spring)] = 0;
  SpringNet part = remainingNet(net, cut);
  // What is nobody's here is left out, as it would be of a net that has always been alone.
  if ((part.massDamping == 0.0).all()) part.massDamping.resize(0);
  if (part.initialVelocity.isZero(0.0)) part.initialVelocity.resize(3, 0);
  return part;
}

} // namespace esm
