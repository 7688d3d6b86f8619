// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/trace_ring.h"

#include <gtest/gtest.h>

#include <thread>

namespace esm {

namespace {

TraceSample sampleOf(double number)
{
  return {number, Eigen::Vector3d::Constant(number), Eigen::Vector3d::Constant(number),
          Eigen::Vector3d::Constant(number)};
}

} // namespace

TEST(TraceRing, GivesEachTickOnceOldestFirst)
{
  TraceRing ring;
  std::vector<TraceSample> taken;
  for (int i = 0; i < 3; ++i) ring.push(sampleOf(i));
  ring.takeNew(taken);
  ring.push(sampleOf(3));
  ring.takeNew(taken);
  ring.takeNew(taken);
  ASSERT_EQ(taken.size(), 4u);
  for (int i = 0; i < 4; ++i) EXPECT_EQ(taken[static_cast<std::size_t>(i)].force.z(), i);
}

TEST(TraceRing, KeepsTheNewestWhenNobodyReads)
{
  TraceRing ring;
  constexpr int kCount = 10000;
  for (int i = 0; i < kCount; ++i) ring.push(sampleOf(i));
  std::vector<TraceSample> taken;
  ring.takeNew(taken);
  ASSERT_EQ(taken.size(), TraceRing::kCapacity);
  EXPECT_EQ(taken.front().time, kCount - static_cast<double>(TraceRing::kCapacity));
  EXPECT_EQ(taken.back().time, kCount - 1.0);
}

// The writer is far faster than 1 kHz, so slots are overwritten while they are read: what comes out is whole
// and in order all the same.
TEST(TraceRing, TicksAreNeverTornUnderAFastWriter)
{
  TraceRing ring;
  constexpr int kCount = 200000;
  std::jthread writer([&] {
    for (int i = 1; i <= kCount; ++i) ring.push(sampleOf(i));
  });
  double last = 0.0;
  std::vector<TraceSample> taken;
  while (last < kCount) {
    taken.clear();
    ring.takeNew(taken);
    for (const TraceSample& sample : taken) {
      ASSERT_GT(sample.time, last);
      last = sample.time;
      for (const Eigen::Vector3d* part : {&sample.position, &sample.velocity, &sample.force})
        ASSERT_TRUE((part->array() == sample.time).all()) << "tick " << sample.time;
    }
  }
}

} // namespace esm
