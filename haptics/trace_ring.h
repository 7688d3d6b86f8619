// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "haptics/haptic_types.h"

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace esm {

/// The last 4 s of ticks for plots: the servo thread writes over the oldest and never waits; the reader takes
/// what it has not seen yet and skips what was lost.
///
/// Each slot carries the number of the tick in it, odd while it is being written. The reader believes a slot
/// only if that number is the same before and after copying. The words are atomic with release stores and
/// acquire loads, so a word of a newer tick cannot be seen without the newer number (fences would do too, but
/// the thread sanitizer does not follow them).
/// @note Threads: push() on one thread, takeNew() on one other. push() is wait-free.
class TraceRing {
public:
  static constexpr std::size_t kCapacity = 4096; ///< ticks, a power of two

  void push(const TraceSample& sample) noexcept;
  /// Appends the ticks since the last call, oldest first.
  void takeNew(std::vector<TraceSample>& samples);

private:
  static constexpr std::size_t kWords = 12;
  struct Slot {
    std::atomic<std::uint64_t> number{0}; ///< 2 n + 2 holds tick n, odd: in work
    std::array<std::atomic<double>, kWords> word{};
  };
  bool read(std::uint64_t tick, TraceSample& sample) const noexcept;

  std::vector<Slot> m_slots = std::vector<Slot>(kCapacity);
  std::atomic<std::uint64_t> m_count{0}; ///< ticks written so far
  std::uint64_t m_next = 0;              ///< the reader's
};

} // namespace esm
