// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/types.h"

#include <cstddef>
#include <span>
#include <vector>

namespace esm {

/// Items by key in one array, those of a key one after the other in the order in which they came: the springs
/// of each node, say.
///
///     springsOf.build(nodeCount, [&](const auto& add) {
///       for (Index s = 0; s < springCount; ++s)
///         for (const Index node : {a[s], b[s]}) add(node, s);
///     });
///     for (const Index s : springsOf[node]) ...
template <class Item>
class Grouped {
public:
  /// @param keys   they are 0 .. keys - 1.
  /// @param visit  called twice, to count and to fill; calls add(key, item) alike both times.
  template <class Visit>
  void build(std::size_t keys, const Visit& visit)
  {
    m_first.assign(keys + 1, 0);
    visit([&](Index key, const Item&) { ++m_first[static_cast<std::size_t>(key) + 1]; });
    for (std::size_t key = 0; key < keys; ++key) m_first[key + 1] += m_first[key];
    m_items.resize(m_first.back());
    std::vector<std::size_t> next(m_first.begin(), m_first.end() - 1);
    visit([&](Index key, const Item& item) { m_items[next[static_cast<std::size_t>(key)]++] = item; });
  }

  std::span<const Item> operator[](std::size_t key) const noexcept
  {
    return {m_items.data() + m_first[key], m_first[key + 1] - m_first[key]};
  }

private:
  std::vector<std::size_t> m_first = {0}; ///< key k has m_items[m_first[k]] to m_items[m_first[k + 1]]
  std::vector<Item> m_items;
};

} // namespace esm
