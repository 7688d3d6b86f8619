// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/forces/net_division.h"

#include "core/base/grouped.h"

#include <utility>

namespace esm {
namespace {

/// With fewer springs two threads halve a pass nearly as well, but a step hardly: what they gain goes into
/// handing nodes from one processor's cache to the other's.
constexpr std::size_t kLeastSprings = 30'000;
/// With their nodes half a megabyte: in a processor's own cache.
constexpr std::size_t kSpringsPerRange = 8'000;
/// So that a few threads share them evenly.
constexpr std::size_t kLeastRanges = 8;
/// Some microseconds.
constexpr std::size_t kSpringsPerLayeredPart = 750;

std::size_t place(Index i) noexcept
{
  return static_cast<std::size_t>(i);
}

/// The layers of breadth-first searches, one component after the other.
class Layers {
public:
  Layers(const SpringNet& net, const std::vector<Index>& springs) : m_layer(place(net.nodeCount()), kNoIndex)
  {
    m_neighboursOf.build(m_layer.size(), [&](const auto& add) {
      for (const Index s : springs)
        for (const int end : {0, 1}) add(net.ends(end, s), net.ends(1 - end, s));
    });
    for (Index node = 0; node < net.nodeCount(); ++node) {
      if (m_layer[place(node)] != kNoIndex || m_neighboursOf[place(node)].empty()) continue;
      const Index begin = m_count;
      const Index farOut = search(node); // twice: layers are smaller if they begin far out
      for (const Index seen : m_seen) m_layer[place(seen)] = kNoIndex;
      m_count = begin;
      search(farOut);
    }
  }

  std::size_t count() const noexcept { return place(m_count); }
  /// Of the end that was reached first.
  std::size_t ofSpring(const SpringNet& net, Index s) const noexcept
  {
    return place(std::min(m_layer[place(net.ends(0, s))], m_layer[place(net.ends(1, s))]));
  }

private:
  /// Gives layers from m_count on to the component of `start`. @return a node of the last one.
  Index search(Index start)
  {
    m_seen.assign(1, start);
    m_layer[place(start)] = m_count;
    for (std::size_t i = 0; i < m_seen.size(); ++i) {
      const std::size_t node = place(m_seen[i]);
      for (const Index neighbour : m_neighboursOf[node]) {
        Index& layer = m_layer[place(neighbour)];
        if (layer != kNoIndex) continue;
        layer = m_layer[node] + 1;
        m_seen.push_back(neighbour);
      }
    }
    m_count = m_layer[place(m_seen.back())] + 1;
    return m_seen.back();
  }

  Grouped<Index> m_neighboursOf; ///< by node
  std::vector<Index> m_layer;    ///< by node; kNoIndex without springs
  std::vector<Index> m_seen;     ///< nodes of the present component
  Index m_count = 0;
};

} // namespace

NodeRanges::NodeRanges(std::size_t nodes, std::size_t wanted) noexcept : m_nodes(nodes)
{
  constexpr std::size_t kPerLine = 8; // numbers, the smallest entries that nodes have
  const std::size_t size = (nodes + wanted - 1) / wanted;
  m_size = std::max<std::size_t>((size + kPerLine - 1) / kPerLine * kPerLine, 1);
  m_count = std::max<std::size_t>((nodes + m_size - 1) / m_size, 1);
}

NetDivision::NetDivision(const SpringNet& net, std::vector<Index> given)
  : ranges(place(net.nodeCount())), first{0}
{
  if (given.size() >= kLeastSprings)
    ranges = NodeRanges(place(net.nodeCount()),
                        std::clamp(given.size() / kSpringsPerRange, kLeastRanges, kMostParts / 2));
  std::vector<std::vector<Index>> inside(ranges.count());
  std::vector<Index> between;
  for (const Index s : given) {
    const std::size_t range = ranges.of(net.ends(0, s));
    (range == ranges.of(net.ends(1, s)) ? inside[range] : between).push_back(s);
  }
  for (const std::vector<Index>& part : inside) addPart(part);
  endPhase(0);
  const std::size_t wanted = std::min(kMostParts / 2, between.size() / kSpringsPerLayeredPart);
  const auto layered = layeredParts(net, between, wanted);
  for (const std::size_t odd : {0u, 1u}) {
    for (std::size_t p = odd; p < layered.size(); p += 2) addPart(layered[p]);
    endPhase(1 + odd);
  }
}

void NetDivision::addPart(const std::vector<Index>& part)
{
  springs.insert(springs.end(), part.begin(), part.end());
  first.push_back(springs.size());
}

std::vector<std::vector<Index>> layeredParts(const SpringNet& net, const std::vector<Index>& springs,
                                             std::size_t wanted)
{
  if (springs.empty()) return {};
  const Layers layers(net, springs);
  std::vector<std::size_t> springsOf(layers.count(), 0), partOf(layers.count());
  for (const Index s : springs) ++springsOf[layers.ofSpring(net, s)];
  std::size_t count = 1, inside = 0;
  for (std::size_t layer = 0; layer < partOf.size(); ++layer) {
    if (inside * wanted >= springs.size() && count < wanted) {
      ++count;
      inside = 0;
    }
    partOf[layer] = count - 1;
    inside += springsOf[layer];
  }
  std::vector<std::vector<Index>> parts(count);
  for (const Index s : springs) parts[partOf[layers.ofSpring(net, s)]].push_back(s);
  return parts;
}

} // namespace esm
