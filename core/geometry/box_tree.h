// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/types.h"

#include <Eigen/Geometry>

#include <functional>
#include <vector>

namespace esm {

/// A binary tree of boxes around items, split at the median of their middles along the longest side.
/// Deterministic; any thread.
class BoxTree {
public:
  /// A leaf has the items order()[first ... first + count - 1], an inner node (count 0) the children first and
  /// first + 1. The first node is the root; without items there is none.
  struct Node {
    Eigen::AlignedBox3d box; ///< around its items, larger by the margin
    Index first = 0, count = 0;
  };

  /// @param boxes of the items, finite
  /// @param margin by which each node is larger to all sides [share of its longest side]
  /// @param isOver asked at each node; once it says so the tree is whole, but its leaves may be large
  BoxTree(const std::vector<Eigen::AlignedBox3d>& boxes, double margin, const std::function<bool()>& isOver);

  const std::vector<Node>& nodes() const noexcept { return m_nodes; }
  const std::vector<Index>& order() const noexcept { return m_order; }

private:
  std::vector<Node> m_nodes;
  std::vector<Index> m_order;
};

} // namespace esm
