// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/large_pages.h"
#include "core/geometry/pair_key.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace esm {

/// Edges by their two ends. Each vertex has a bucket for the edges that lead up from it, to vertices of a
/// higher number: half a line of the cache or a whole one, searched in the order in which edges came. (To
/// compare all at once is slower: in ordered meshes the bucket was written to just before.) What finds no
/// room goes to a hash table, so that no hub makes the search slow.
/// @tparam kSize room for edges that lead up from a vertex: three as a rule, and seldom more than four where
/// the numbers follow the surface; anything up to the number of its neighbours where they do not
template <int kSize>
class EdgeBuckets {
public:
  explicit EdgeBuckets(Index vertexCount)
    : m_buckets(std::make_unique_for_overwrite<Bucket[]>(static_cast<std::size_t>(vertexCount)))
  {
    const auto count = static_cast<std::size_t>(vertexCount);
    useLargePages(m_buckets.get(), count * sizeof(Bucket));
    std::fill_n(m_buckets.get(), count, Bucket{}); // nearly all will be used, and the memory was, as a rule
  }

  /// Fetches the memory of a later findOrAdd(low, ...).
  void foresee(Index low) const { __builtin_prefetch(m_buckets.get() + low, 1); }

  /// The number of the edge between two vertices; `next` if it was none yet and now is. @pre low < high
  Index findOrAdd(Index low, Index high, Index next)
  {
    Bucket& bucket = m_buckets[static_cast<std::size_t>(low)];
    for (int place = 0; place < kSize; ++place) {
      if (bucket.high[place] == high) return bucket.edge[place];
      if (bucket.high[place] == kFree) {
        bucket.high[place] = high;
        bucket.edge[place] = next;
        return next;
      }
    }
    return findOrAddMore(low, high, next);
  }

private:
  static constexpr Index kFree = 0; ///< no edge leads up to vertex 0
  struct alignas(2 * kSize * sizeof(Index)) Bucket {
    Index high[kSize] = {}, edge[kSize] = {}; ///< in use from the front
  };
  struct Entry {
    std::uint64_t key = 0; ///< pairKey(); 0 is none, for no edge leads up to vertex 0
    Index edge = 0;
  };

  /// For a full bucket: open addressing, at most half full. Kept out of the loops that seldom come here.
  [[gnu::noinline, gnu::cold]] Index findOrAddMore(Index low, Index high, Index next)
  {
    if (2 * (m_moreCount + 1) > m_more.size()) growMore();
    const std::uint64_t key = pairKey(low, high);
    Entry& entry = placeOf(key);
    if (entry.key != key) {
      entry = {key, next};
      ++m_moreCount;
    }
    return entry.edge;
  }
  Entry& placeOf(std::uint64_t key)
  {
    const std::size_t mask = m_more.size() - 1;
    std::uint64_t hash = key * 0x9e3779b97f4a7c15ull; // 2^64 / golden ratio
    hash ^= hash >> 32;
    std::size_t i = hash & mask;
    while (m_more[i].key != 0 && m_more[i].key != key) i = (i + 1) & mask;
    return m_more[i];
  }
  void growMore()
  {
    std::vector<Entry> old(m_more.empty() ? 1024 : 4 * m_more.size());
    old.swap(m_more);
    for (const Entry& entry : old)
      if (entry.key != 0) placeOf(entry.key) = entry;
  }

  std::unique_ptr<Bucket[]> m_buckets; ///< per vertex
  std::vector<Entry> m_more;           ///< a power of two of them, or none
  std::size_t m_moreCount = 0;
};

} // namespace esm
