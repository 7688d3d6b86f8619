// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/jitter_histogram.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

constexpr double kFirstEdge = 1e-6; ///< [s]
constexpr double kBinsPerOctave = 4.0;

std::size_t binOf(double lateness) noexcept
{
  if (!(lateness > kFirstEdge)) return 0;
  const double bin = std::ceil(kBinsPerOctave * std::log2(lateness / kFirstEdge) - 1e-9);
  return std::min(static_cast<std::size_t>(bin), JitterCounts::kBins - 1);
}

/// One writer: a load and a store do.
void raise(std::atomic<std::uint64_t>& number, std::uint64_t by) noexcept
{
  number.store(number.load(std::memory_order_relaxed) + by, std::memory_order_relaxed);
}

} // namespace

double JitterCounts::upperEdge(std::size_t bin) noexcept
{
  return kFirstEdge * std::exp2(static_cast<double>(bin) / kBinsPerOctave);
}

double JitterCounts::percentile(double share) const noexcept
{
  const double wanted = share * static_cast<double>(ticks);
  std::uint64_t sum = 0;
  for (std::size_t bin = 0; bin < kBins; ++bin) {
    sum += count[bin];
    if (sum > 0 && static_cast<double>(sum) >= wanted) return std::min(upperEdge(bin), worst);
  }
  return worst;
}

void JitterHistogram::add(double lateness, std::uint64_t missed) noexcept
{
  raise(m_count[binOf(lateness)], 1);
  raise(m_missed, missed);
  if (lateness > m_worst.load(std::memory_order_relaxed)) m_worst.store(lateness, std::memory_order_relaxed);
}

JitterCounts JitterHistogram::counts() const noexcept
{
  JitterCounts counts;
  for (std::size_t bin = 0; bin < JitterCounts::kBins; ++bin) {
    counts.count[bin] = m_count[bin].load(std::memory_order_relaxed);
    counts.ticks += counts.count[bin];
  }
  counts.missed = m_missed.load(std::memory_order_relaxed);
  counts.worst = m_worst.load(std::memory_order_relaxed);
  return counts;
}

} // namespace esm
