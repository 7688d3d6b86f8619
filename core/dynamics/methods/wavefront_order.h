// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/grouped.h"
#include "core/dynamics/system/system.h"

#include <span>
#include <vector>

namespace esm {

/// All nodes of a net, layer by layer from a start node over the springs; then, for what the springs do not
/// reach, from the first node left.
class WavefrontOrder {
public:
  struct Neighbour {
    Index node;
    std::uint32_t batch; ///< of ForceModel::batches()
    std::uint32_t place; ///< of the spring in it
  };
  void prepare(const System& system); ///< after any change of springs; allocates
  /// Does not allocate.
  void startAt(std::size_t node) noexcept;

  std::span<const Index> nodes() const noexcept { return m_nodes; }
  std::span<const Neighbour> neighboursOf(std::size_t node) const noexcept { return m_neighboursOf[node]; }

  /// Whether the front reaches `node` after `reached`.
  bool isAhead(std::size_t node, std::size_t reached) const noexcept
  {
    return m_rank[node] > m_rank[reached];
  }

private:
  Grouped<Neighbour> m_neighboursOf; ///< by node
  std::vector<Index> m_nodes;
  std::vector<Index> m_rank; ///< place of each node in m_nodes; kNoIndex while it is not reached
};

} // namespace esm
