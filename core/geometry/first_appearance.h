// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/types.h"
#include "core/base/work_control.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace esm {

/// For each of `count` items the first item with the same key; kNoIndex for items without a key.
///
/// A key is a small `bucket` number (an item's smallest vertex) and a `rest`. Items are dealt into their
/// buckets by a counting sort; on a mesh a bucket then holds a handful of items in neighbouring memory,
/// where plain search beats any hash table. Buckets of hubs are sorted instead: O(n log n) at worst.
/// @param keyOf item -> {bucket, rest}; bucket in [0, bucketCount) or kNoIndex for "no key".
/// @param control may be null; once it is cancelled the answer is of no use.
template <class Rest, class KeyOf>
std::vector<Index> firstAppearances(Index count, Index bucketCount, const KeyOf& keyOf,
                                    WorkControl* control = nullptr)
{
  struct Entry {
    Rest rest;
    Index item;
  };
  constexpr std::ptrdiff_t kSearchLimit = 24; // above it sorting is cheaper than searching

  std::vector<Index> bucketEnd(static_cast<std::size_t>(bucketCount) + 1, 0);
  for (Index i = 0; i < count; ++i)
    if (const Index bucket = keyOf(i).first; bucket != kNoIndex)
      ++bucketEnd[static_cast<std::size_t>(bucket)];
  if (stopWanted(control)) return {};
  Index total = 0;
  for (Index& end : bucketEnd) {
    const Index size = end;
    end = total; // the start for now; dealing the items moves it to the end
    total += size;
  }
  std::vector<Entry> entries(static_cast<std::size_t>(total));
  for (Index i = 0; i < count; ++i) {
    if (stopWantedAt(static_cast<std::size_t>(i), static_cast<std::size_t>(count), control)) return {};
    const auto [bucket, rest] = keyOf(i);
    if (bucket == kNoIndex) continue;
    Index& place = bucketEnd[static_cast<std::size_t>(bucket)];
    entries[static_cast<std::size_t>(place++)] = Entry{rest, i};
  }

  std::vector<Index> first(static_cast<std::size_t>(count), kNoIndex);
  Index begin = 0;
  for (Index bucket = 0; bucket < bucketCount; ++bucket) {
    if (stopWantedAt(static_cast<std::size_t>(bucket), static_cast<std::size_t>(bucketCount), control))
      return {};
    const Index end = bucketEnd[static_cast<std::size_t>(bucket)];
    Entry* const from = entries.data() + begin;
    Entry* const to = entries.data() + end;
    begin = end;
    if (to - from > kSearchLimit) {
      std::stable_sort(from, to, [](const Entry& a, const Entry& b) { return a.rest < b.rest; });
      for (Entry* e = from; e != to; ++e) {
        const bool same = e != from && (e - 1)->rest == e->rest;
        first[static_cast<std::size_t>(e->item)] =
          same ? first[static_cast<std::size_t>((e - 1)->item)] : e->item;
      }
    } else {
      for (Entry* e = from; e != to; ++e) {
        const Entry* same = from;
        while (same != e && same->rest != e->rest) ++same;
        first[static_cast<std::size_t>(e->item)] = same->item;
      }
    }
  }
  return first;
}

} // namespace esm
