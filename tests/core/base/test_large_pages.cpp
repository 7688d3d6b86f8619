// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/base/large_pages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

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

// Freed memory must serve the next array: that the library maps nothing anew shows in its own count.
TEST(LargePages, BigArraysComeFromTheHeapAndGoBackToIt)
{
#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  keepBigArraysInHeap();
  const std::size_t before = mallinfo2().hblks;
  const void* first = nullptr;
  for (int i = 0; i < 3; ++i) {
    const std::vector<double> values = largeVector(std::size_t{1} << 20, 1.0); // 8 MB
    EXPECT_EQ(mallinfo2().hblks, before);
    if (i == 0) first = values.data();
    EXPECT_EQ(values.data(), first);
    EXPECT_EQ(values.back(), 1.0);
  }
#else
  GTEST_SKIP() << "only the C library's own allocator has these settings";
#endif
}

} // namespace esm
