// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/rest/active_region.h"

#include <algorithm>

namespace esm {

ActiveRegion::ActiveRegion(const SpringNet& net)
  : m_fixed(net.fixed), m_awake(static_cast<std::size_t>(net.nodeCount()), 0), m_stamp(m_awake.size(), 0)
{
  m_ends.assign(net.ends.data(), net.ends.data() + net.ends.size());
  m_springsOf.build(m_awake.size(), [&](const auto& add) {
    for (std::size_t k = 0; k < m_ends.size(); ++k) add(m_ends[k], static_cast<Index>(k / 2));
  });
  m_freeCount = static_cast<Index>(std::count(m_fixed.begin(), m_fixed.end(), std::uint8_t{0}));
}

std::uint32_t ActiveRegion::newStamp()
{
  if (++m_lastStamp == 0) { // after four thousand million searches
    std::fill(m_stamp.begin(), m_stamp.end(), 0u);
    m_lastStamp = 1;
  }
  return m_lastStamp;
}

std::span<const Index> ActiveRegion::wake(std::span<const Index> seeds, int layers)
{
  const std::uint32_t stamp = newStamp();
  std::vector<Index> front, next;
  m_woken.clear();
  const auto visit = [&](Index node, std::vector<Index>& to) {
    const auto i = static_cast<std::size_t>(node);
    if (m_stamp[i] == stamp || m_fixed[i]) return;
    m_stamp[i] = stamp;
    to.push_back(node);
    if (m_awake[i]) return;
    m_awake[i] = 1;
    m_woken.push_back(node);
  };
  for (const Index seed : seeds) visit(seed, front);
  for (int layer = 0; layer < layers && !front.empty(); ++layer) {
    next.clear();
    for (const Index node : front)
      for (const Index spring : springsOf(node)) visit(otherEnd(spring, node), next);
    front.swap(next);
  }
  m_list.insert(m_list.end(), m_woken.begin(), m_woken.end());
  return m_woken;
}

void ActiveRegion::sleep(std::span<const Index> nodes)
{
  for (const Index node : nodes) m_awake[static_cast<std::size_t>(node)] = 0;
  std::erase_if(m_list, [&](Index node) { return !isAwake(node); });
}

void ActiveRegion::update(const std::vector<std::uint8_t>& fresh)
{
  const std::uint32_t stamp = newStamp();
  std::sort(m_list.begin(), m_list.end());
  m_rim.clear();
  for (const Index node : m_list)
    for (const Index spring : springsOf(node)) {
      const Index other = otherEnd(spring, node);
      const auto i = static_cast<std::size_t>(other);
      if (m_awake[i] || m_stamp[i] == stamp) continue;
      m_stamp[i] = stamp;
      m_rim.push_back(other);
    }
  std::sort(m_rim.begin(), m_rim.end());
  m_layers.clear();
  const auto visit = [&](Index from, int depth, bool nearFresh) {
    for (const Index spring : springsOf(from)) {
      const Index node = otherEnd(spring, from);
      const auto i = static_cast<std::size_t>(node);
      if (!m_awake[i] || m_stamp[i] == stamp) continue;
      m_stamp[i] = stamp;
      m_layers.push_back({node, depth, nearFresh});
    }
  };
  for (const Index sleeper : m_rim)
    if (const auto i = static_cast<std::size_t>(sleeper); !m_fixed[i]) visit(sleeper, 1, fresh[i] != 0);
  for (std::size_t k = 0; k < m_layers.size(); ++k) {
    const Layered from = m_layers[k];
    visit(from.node, from.depth + 1, from.nearFresh);
  }
  m_radius = m_layers.empty() ? 0 : m_layers.back().depth;
}

std::vector<Index> ActiveRegion::inside(const std::vector<std::uint8_t>& isCandidate, int layers,
                                        std::size_t least)
{
  const std::uint32_t stamp = newStamp();
  std::vector<Index> front, next;
  std::size_t left = m_list.size();
  for (const Index node : m_list) {
    const auto i = static_cast<std::size_t>(node);
    if (isCandidate[i]) continue;
    m_stamp[i] = stamp;
    front.push_back(node);
  }
  left -= front.size();
  for (int layer = 0; layer < layers && !front.empty(); ++layer) {
    next.clear();
    for (const Index node : front) {
      if (left - next.size() < least) return {};
      for (const Index spring : springsOf(node)) {
        const auto i = static_cast<std::size_t>(otherEnd(spring, node));
        if (!m_awake[i] || m_stamp[i] == stamp) continue;
        m_stamp[i] = stamp;
        next.push_back(static_cast<Index>(i));
      }
    }
    left -= next.size();
    front.swap(next);
  }
  if (left < least) return {};
  std::vector<Index> result;
  for (const Index node : m_list)
    if (m_stamp[static_cast<std::size_t>(node)] != stamp) result.push_back(node);
  return result;
}

} // namespace esm
