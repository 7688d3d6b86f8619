// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/methods/wavefront_order.h"

#include <algorithm>

namespace esm {

void WavefrontOrder::prepare(const System& system)
{
  const std::vector<SpringBatch>& batches = system.forces().batches();
  m_neighboursOf.build(system.nodeCount(), [&](const auto& add) {
    for (std::uint32_t k = 0; k < batches.size(); ++k)
      for (std::uint32_t i = 0; i < batches[k].count; ++i) {
        const Index a = batches[k].a[i], b = batches[k].b[i];
        add(a, {b, k, i});
        add(b, {a, k, i});
      }
  });
  m_nodes.clear();
  m_nodes.reserve(system.nodeCount());
  m_rank.assign(system.nodeCount(), kNoIndex);
}

void WavefrontOrder::startAt(std::size_t start) noexcept
{
  const std::size_t count = m_rank.size();
  if (m_nodes.size() == count && (count == 0 || m_nodes[0] == static_cast<Index>(start))) return;
  m_nodes.clear(); // keeps its memory
  std::fill(m_rank.begin(), m_rank.end(), kNoIndex);
  const auto reach = [&](std::size_t node) {
    if (m_rank[node] != kNoIndex) return;
    m_rank[node] = static_cast<Index>(m_nodes.size());
    m_nodes.push_back(static_cast<Index>(node));
  };
  if (start < count) reach(start);
  std::size_t done = 0;
  for (std::size_t island = 0; island <= count; ++island) {
    for (; done < m_nodes.size(); ++done)
      for (const Neighbour& neighbour : neighboursOf(static_cast<std::size_t>(m_nodes[done])))
        reach(static_cast<std::size_t>(neighbour.node));
    if (island < count) reach(island);
  }
}

} // namespace esm
