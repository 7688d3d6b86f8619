// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/types.h"

#include <algorithm>
#include <vector>

namespace esm {

/// The largest tension among springs that rest, without looking at all of them: a heap in which springs that
/// have woken stay until they come to the top.
class SleepingTensions {
public:
  void prepare(std::size_t springs)
  {
    m_value.assign(springs, kAwake);
    m_heap.clear();
  }
  /// @param tension  absolute [N].
  void add(Index spring, double tension)
  {
    m_value[static_cast<std::size_t>(spring)] = tension;
    m_heap.push_back({tension, spring});
    std::push_heap(m_heap.begin(), m_heap.end());
    if (m_heap.size() <= 2 * m_value.size()) return;
    std::erase_if(m_heap, [&](const Entry& entry) { return !isValid(entry); });
    std::make_heap(m_heap.begin(), m_heap.end());
  }
  void remove(Index spring) noexcept { m_value[static_cast<std::size_t>(spring)] = kAwake; }
  double largest()
  {
    while (!m_heap.empty() && !isValid(m_heap.front())) {
      std::pop_heap(m_heap.begin(), m_heap.end());
      m_heap.pop_back();
    }
    return m_heap.empty() ? 0.0 : m_heap.front().tension;
  }

private:
  static constexpr double kAwake = -1.0;
  struct Entry {
    double tension;
    Index spring;
    bool operator<(const Entry& other) const noexcept { return tension < other.tension; }
  };
  bool isValid(const Entry& entry) const noexcept
  {
    return m_value[static_cast<std::size_t>(entry.spring)] == entry.tension;
  }

  std::vector<double> m_value; ///< S, kAwake if the spring does not rest
  std::vector<Entry> m_heap;
};

} // namespace esm
