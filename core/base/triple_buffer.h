// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstdint>

namespace esm {

/// Hands the newest T from one writer thread to one reader thread without locks or waiting.
/// The writer always owns one slot, the reader one, the third waits in `m_shared`.
///
///     writer --back()/publish()--> [ slot | slot | slot ] --latest()--> reader
///
/// @note Threads: back()/publish() only on the writer, latest() only on the reader. All wait-free.
template <class T>
class TripleBuffer {
public:
  TripleBuffer() = default;
  explicit TripleBuffer(const T& initial)
  {
    for (Slot& slot : m_slots) slot.value = initial;
  }

  /// The writer's slot. It holds an old value: overwrite all of it.
  T& back() noexcept { return m_slots[m_write].value; }

  void publish() noexcept
  {
    const std::uint8_t fresh = static_cast<std::uint8_t>(m_write | kFresh);
    m_write = m_shared.exchange(fresh, std::memory_order_acq_rel) & kIndex;
  }

  /// Valid until the next latest(); the same value again if nothing new came.
  const T& latest() noexcept
  {
    if (m_shared.load(std::memory_order_relaxed) & kFresh)
      m_read = m_shared.exchange(m_read, std::memory_order_acq_rel) & kIndex;
    return m_slots[m_read].value;
  }

  /// Whether latest() would bring something new. Reader only.
  bool hasNews() const noexcept { return (m_shared.load(std::memory_order_relaxed) & kFresh) != 0; }

private:
  static constexpr std::uint8_t kIndex = 3, kFresh = 4;
  struct alignas(64) Slot {
    T value{};
  };
  Slot m_slots[3];
  alignas(64) std::atomic<std::uint8_t> m_shared{1};
  alignas(64) std::uint8_t m_write = 0; ///< writer's
  alignas(64) std::uint8_t m_read = 2;  ///< reader's
};

} // namespace esm
