// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/net/spring_net.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace esm {

/// Nodes 0 .. N - 1 cut into ranges of equal size that meet at borders of cache lines.
class NodeRanges {
public:
  NodeRanges() = default;
  explicit NodeRanges(std::size_t nodes, std::size_t wanted = 1) noexcept;

  std::size_t count() const noexcept { return m_count; }
  std::size_t first(std::size_t range) const noexcept { return range * m_size; }
  std::size_t size(std::size_t range) const noexcept { return std::min(m_nodes - first(range), m_size); }
  std::size_t of(Index node) const noexcept { return static_cast<std::size_t>(node) / m_size; }

private:
  std::size_t m_nodes = 0, m_size = 1, m_count = 1;
};

/// How a pass over a net is divided, for several threads and for the caches of each. A pass has three phases;
/// parts of one phase share no node, so they can be done at the same time:
///
///     0   one part for each range of nodes: the springs with both ends in it
///     1   springs between ranges, even layers  }  of a breadth-first search through these springs,
///     2   springs between ranges, odd layers   }  see layeredParts()
///
/// In the order that meshes come in, a few per cent of the springs are between ranges; in a random one,
/// nearly all. The division depends on the net alone: sums over parts, added in the parts' order, have the
/// same bits on any number of threads. Small nets are one range and one part.
struct NetDivision {
  static constexpr std::size_t kMostParts = 512;

  NodeRanges ranges;
  std::vector<Index> springs;                ///< part by part, in each in the order in which they were given
  std::vector<std::size_t> first;            ///< part p has springs[first[p]] to springs[first[p + 1]]
  std::array<std::size_t, 4> firstPart = {}; ///< phase q has parts firstPart[q] to firstPart[q + 1]

  /// @param springs  places in `net`, in the order in which a pass should go through memory.
  NetDivision(const SpringNet& net, std::vector<Index> springs);
  std::size_t partCount() const noexcept { return first.size() - 1; }

private:
  void addPart(const std::vector<Index>& part);
  void endPhase(std::size_t phase) noexcept { firstPart[phase + 1] = partCount(); }
};

/// Parts of springs such that no two even ones share a node, nor do two odd ones. The layers of a
/// breadth-first search touch none but the next one; so a part holds the springs of some layers, each with
/// the springs to the following layer, and meets the parts before and after it only:
///
///     layer   0 -- 1 -- 2 -- 3 -- 4 -- 5 -- 6 -- 7
///     part    |   0    |   1    |   2    |   3
///
/// @param wanted  number of parts; there are fewer if there are few layers.
std::vector<std::vector<Index>> layeredParts(const SpringNet& net, const std::vector<Index>& springs,
                                             std::size_t wanted);

} // namespace esm
