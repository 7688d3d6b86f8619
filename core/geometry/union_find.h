// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/types.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace esm {

/// Sets that grow together: union-find with path halving; the smallest member stands for its set.
class UnionFind {
public:
  explicit UnionFind(Index count) : m_parent(static_cast<std::size_t>(count))
  {
    std::iota(m_parent.begin(), m_parent.end(), 0);
  }
  /// Whether the two were apart until now.
  bool join(Index a, Index b)
  {
    if (at(a) == at(b)) return false; // as a rule, where they come in the order of the surface
    a = root(a);
    b = root(b);
    if (a == b) return false;
    at(std::max(a, b)) = std::min(a, b);
    return true;
  }
  Index root(Index i)
  {
    while (at(i) != i) i = at(i) = at(at(i));
    return i;
  }

private:
  Index& at(Index i) { return m_parent[static_cast<std::size_t>(i)]; }
  std::vector<Index> m_parent;
};

} // namespace esm
