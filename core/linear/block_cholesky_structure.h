// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/linear/block_cholesky.h"

#include <span>

namespace esm {

/// Who is coupled with whom, both ways, without repetitions.
class NodeGraph {
public:
  NodeGraph(Index nodes, const std::vector<NodePair>& pairs);
  std::size_t nodeCount() const noexcept { return m_first.size() - 1; }
  std::span<const Index> neighbours(Index node) const noexcept
  {
    const auto i = static_cast<std::size_t>(node);
    return {m_neighbours.data() + m_first[i], m_first[i + 1] - m_first[i]};
  }

private:
  std::vector<std::size_t> m_first;
  std::vector<Index> m_neighbours; ///< rising for each node
};

/// The elimination tree (Liu 1990) of a graph under an order: parent of a place is the first later place that
/// its column of the factor reaches.
struct EliminationTree {
  EliminationTree(const NodeGraph& graph, const std::vector<Index>& order);
  double work() const noexcept; ///< multiplications of a factor, over nodes

  std::vector<Index> nodeAt, placeOf; ///< order and its inverse
  std::vector<Index> parent;          ///< kNoIndex at a root
  std::vector<Index> length;          ///< nodes in the column of the factor, diagonal included

private:
  void findParents(const NodeGraph& graph);
  void countColumns(const NodeGraph& graph);
};

} // namespace esm
