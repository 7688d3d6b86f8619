// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "bench/fast_limits.h"

#include <benchmark/benchmark.h>

namespace esm::bench {
namespace {

constexpr std::size_t kGroups = 128;        ///< of four springs: 36 kB, within L1 of most machines
constexpr std::size_t kArrays = 9;          ///< d, w (3 each), L, k, c
constexpr std::size_t kStream = 24'000'000; ///< doubles
/// Two ends, three parameters, and a third of what a node costs: x, v read, force read and written.
constexpr double kBytesPerSpring = 2 * 4 + 3 * 8 + 4 * 32 / 3.0;

BENCH_CLONES double arithmetic(const Vec4* from)
{
  Vec4 sum = {0, 0, 0, 0};
  for (std::size_t i = 0; i < kGroups; ++i, from += kArrays) {
    const Vec4 dx = from[0], dy = from[1], dz = from[2];
    Vec4 length = dx * dx + dy * dy + dz * dz;
    for (int lane = 0; lane < 4; ++lane) length[lane] = __builtin_sqrt(length[lane]);
    const Vec4 inverse = 1.0 / length;
    const Vec4 rate = (from[3] * dx + from[4] * dy + from[5] * dz) * inverse;
    const Vec4 scale = (from[7] * (length - from[6]) + from[8] * rate) * inverse;
    sum += dx * scale;
    sum += dy * scale;
    sum += dz * scale;
  }
  return sum[0] + sum[1] + sum[2] + sum[3];
}

BENCH_CLONES double divideAndRoot(const Vec4* from)
{
  Vec4 sum = {0, 0, 0, 0};
  for (std::size_t i = 0; i < kGroups; ++i, from += kArrays) {
    Vec4 length = from[0];
    for (int lane = 0; lane < 4; ++lane) length[lane] = __builtin_sqrt(length[lane]);
    sum += 1.0 / length;
  }
  return sum[0] + sum[1] + sum[2] + sum[3];
}

BENCH_CLONES double stream(const double* from)
{
  Vec4 sums[4] = {};
  for (std::size_t i = 0; i < kStream; i += 16)
    for (std::size_t j = 0; j < 4; ++j) {
      Vec4 value;
      __builtin_memcpy(&value, from + i + 4 * j, sizeof value);
      sums[j] += value;
    }
  const Vec4 sum = sums[0] + sums[1] + sums[2] + sums[3];
  return sum[0] + sum[1] + sum[2] + sum[3];
}

} // namespace

Limits::Limits() : m_lanes(kGroups * kArrays, Vec4{1.0, 1.1, 1.2, 1.3}), m_stream(kStream, 1.0)
{
  m_springs = {{"arithmetic", 4.0 * kGroups},
               {"divide and square root", 4.0 * kGroups},
               {"streaming memory", 8.0 * kStream / kBytesPerSpring}};
}

void Limits::registerAll()
{
  benchmark::RegisterBenchmark(m_springs[0].first.c_str(), [this](benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(arithmetic(m_lanes.data()));
  });
  benchmark::RegisterBenchmark(m_springs[1].first.c_str(), [this](benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(divideAndRoot(m_lanes.data()));
  });
  benchmark::RegisterBenchmark(m_springs[2].first.c_str(), [this](benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(stream(m_stream.data()));
  });
}

} // namespace esm::bench
