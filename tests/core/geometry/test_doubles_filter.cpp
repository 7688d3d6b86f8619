// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/geometry/doubles_filter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <unordered_map>

namespace esm {
namespace {

std::uint64_t mixed(std::uint64_t value)
{
  value *= 0x9e3779b97f4a7c15ull;
  return value ^ (value >> 29);
}

// A filter may name too many, but none that has an equal may be missing: a count by hand says which have.
TEST(DoublesFilter, namesAllThatHaveAnEqualAndFewOthers)
{
  constexpr Index kItems = 50'000;
  std::mt19937 random(5);
  std::vector<std::uint64_t> values(kItems);
  for (std::uint64_t& value : values) value = random() % (8 * kItems); // about one in nine has an equal
  std::unordered_map<std::uint64_t, int> times;
  for (const std::uint64_t value : values) ++times[value];

  std::vector<Index> room(kItems);
  const std::vector<Index> found = possibleDoubles(
    kItems, [&](Index i) { return mixed(values[static_cast<std::size_t>(i)]); }, room, nullptr);
  EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
  Index others = 0;
  std::vector<bool> isFound(kItems);
  for (const Index i : found) {
    isFound[static_cast<std::size_t>(i)] = true;
    others += times[values[static_cast<std::size_t>(i)]] == 1;
  }
  for (std::size_t i = 0; i < kItems; ++i) EXPECT_TRUE(times[values[i]] == 1 || isFound[i]) << "item " << i;
  // 16 to 32 bits an item: a free place is taken by another one with a chance of 1/16 at most.
  EXPECT_LT(others, kItems / 12);
}

// Hashes that are all the same are the worst there is: then every item may have an equal.
TEST(DoublesFilter, namesAllWhereHashesSayNothing)
{
  std::vector<Index> room(100);
  EXPECT_EQ(possibleDoubles(
              100, [](Index) { return std::uint64_t{7}; }, room, nullptr)
              .size(),
            100u);
  EXPECT_TRUE(possibleDoubles(
                1, [](Index) { return std::uint64_t{7}; }, room, nullptr)
                .empty());
}

} // namespace
} // namespace esm
