// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/types.h"
#include "core/base/work_control.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace esm {

/// Of many items those that may have an equal one, by their hashes alone: a set of bits marks each hash that
/// came, so whoever finds its own bit set may be a double. With some sixteen bits per item one in thirty of
/// those without an equal is taken for one. The bits stay in the cache where a table of all items would not.
/// @param hashOf item -> 64 bits, of which all should be good; equal items have equal ones.
/// @param room   of `count` numbers, for own use
/// @param control may be null; once it is cancelled the answer is of no use.
/// @return all items that have an equal one, and some others; ascending
template <class HashOf>
std::vector<Index> possibleDoubles(Index count, const HashOf& hashOf, std::vector<Index>& room,
                                   WorkControl* control)
{
  constexpr std::size_t kWord = 64, kBitsPerItem = 16, kFewest = 1024;
  constexpr std::size_t kAtOnce = 64;                 // a power of two, so that stopWantedAt() gets its turns
  constexpr std::size_t kMost = std::size_t{1} << 31; // for the places are kept as an Index
  const std::size_t items = static_cast<std::size_t>(count);
  const std::size_t bits = std::bit_ceil(std::clamp(kBitsPerItem * items, kFewest, kMost));
  std::vector<std::uint64_t> came(bits / kWord, 0), wanted(bits / kWord, 0);
  const auto bitOf = [](std::size_t place) { return std::uint64_t{1} << (place % kWord); };
  for (std::size_t first = 0; first < items; first += kAtOnce) {
    if (stopWantedAt(first, items, control)) return {};
    const std::size_t end = std::min(items, first + kAtOnce);
    for (std::size_t i = first; i < end; ++i) { // their memory is on its way while the next ones are hashed
      const std::size_t place = hashOf(static_cast<Index>(i)) & (bits - 1);
      room[i] = static_cast<Index>(place);
      __builtin_prefetch(&came[place / kWord], 1);
    }
    for (std::size_t i = first; i < end; ++i) {
      const auto place = static_cast<std::size_t>(room[i]);
      std::uint64_t& word = came[place / kWord];
      if (word & bitOf(place)) wanted[place / kWord] |= bitOf(place);
      word |= bitOf(place);
    }
  }
  // Grown from nothing it would leave small pieces behind, and keep a file's freed memory from serving again.
  std::vector<Index> doubles;
  doubles.reserve(items / 16 + 1024);
  // The first of each pair of doubles found its bit free: it is one of those whose bit is wanted now.
  for (std::size_t i = 0; i < items; ++i) {
    const auto place = static_cast<std::size_t>(room[i]);
    if (wanted[place / kWord] & bitOf(place)) doubles.push_back(static_cast<Index>(i));
  }
  return doubles;
}

} // namespace esm
