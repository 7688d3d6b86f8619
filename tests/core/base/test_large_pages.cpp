// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/base/large_pages.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace esm {

// Small pieces are overwritten, of big ones the pages are exchanged: both read as zeros, whatever was there
// and wherever they begin, and nothing beside them changes.
TEST(LargePages, UsedMemoryBecomesZerosAndItsNeighboursStay)
{
  for (const std::size_t size : {std::size_t{0}, std::size_t{100}, std::size_t{9'000'001}}) {
    std::vector<char> memory(size + 20'000, 'x');
    char* const from = memory.data() + 7'777;
    zeroInLargePages(from, size);
    EXPECT_TRUE(std::all_of(memory.data(), from, [](char c) { return c == 'x'; }));
    EXPECT_TRUE(std::all_of(from, from + size, [](char c) { return c == 0; }));
    EXPECT_TRUE(std::all_of(from + size, memory.data() + memory.size(), [](char c) { return c == 'x'; }));
  }
}

} // namespace esm
