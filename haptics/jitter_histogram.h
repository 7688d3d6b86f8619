// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

namespace esm {

/// How often which lateness came; a plain copy for whoever reads.
struct JitterCounts {
  static constexpr std::size_t kBins = 68;
  /// Bins grow by 2^(1/4): the first holds all below 1 us, the last all above 0.1 s.
  static double upperEdge(std::size_t bin) noexcept; ///< [s]

  std::array<std::uint64_t, kBins> count{};
  std::uint64_t ticks = 0, missed = 0;
  double worst = 0.0; ///< [s]
  /// The lateness that this share of the ticks keeps within, to a bin's upper edge [s]; 0 without ticks.
  double percentile(double share) const noexcept;
};

/// Counts how late the ticks of a servo loop begin.
/// @note Threads: add() on one thread, wait-free; counts() on any: each number is right, and no older than
///       the one before it.
class JitterHistogram {
public:
  void add(double lateness, std::uint64_t missed) noexcept;
  JitterCounts counts() const noexcept;

private:
  std::array<std::atomic<std::uint64_t>, JitterCounts::kBins> m_count{};
  std::atomic<std::uint64_t> m_missed{0};
  std::atomic<double> m_worst{0.0};
};

} // namespace esm
