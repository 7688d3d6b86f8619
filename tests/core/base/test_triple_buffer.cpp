// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/base/triple_buffer.h"

#include <gtest/gtest.h>

#include <array>
#include <thread>

namespace esm {

TEST(TripleBuffer, TheReaderGetsTheNewestAndThenTheSameAgain)
{
  TripleBuffer<int> buffer(7);
  EXPECT_EQ(buffer.latest(), 7);
  buffer.back() = 1;
  buffer.publish();
  buffer.back() = 2;
  buffer.publish();
  EXPECT_TRUE(buffer.hasNews());
  EXPECT_EQ(buffer.latest(), 2);
  EXPECT_FALSE(buffer.hasNews());
  EXPECT_EQ(buffer.latest(), 2);
}

// A torn value would show as unequal parts, a stale one as a count that falls. Under TSan a missing order is
// an error even when the values happen to come out right.
TEST(TripleBuffer, ValuesAreNeverTornAndNeverGoBack)
{
  using Value = std::array<int, 16>;
  TripleBuffer<Value> buffer;
  constexpr int kCount = 100000;
  std::jthread writer([&] {
    for (int i = 1; i <= kCount; ++i) {
      buffer.back().fill(i);
      buffer.publish();
    }
  });
  int last = 0;
  while (last < kCount) {
    const Value& value = buffer.latest();
    for (int part : value) ASSERT_EQ(part, value[0]);
    ASSERT_GE(value[0], last);
    last = value[0];
  }
}

} // namespace esm
