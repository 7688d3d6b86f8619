// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/base/worker_pool.h"

#include "core/base/assert.h"

#include <chrono>
#include <system_error>

namespace esm {
namespace {

/// Longer than the pauses between the passes of a step, much shorter than a frame.
constexpr std::chrono::microseconds kPatience{50};

/// Tells the processor that this is a loop which waits.
void relax() noexcept
{
#if defined(__x86_64__)
  __builtin_ia32_pause();
#endif
}

/// Waits until `value` is no longer `old`: at first by looking, then asleep.
void waitForChange(const std::atomic<std::uint32_t>& value, std::uint32_t old) noexcept
{
  constexpr int kLooks = 16; // between two looks at the clock
  const auto begin = std::chrono::steady_clock::now();
  do {
    for (int look = 0; look < kLooks; ++look) {
      if (value.load(std::memory_order_acquire) != old) return;
      relax();
    }
  } while (std::chrono::steady_clock::now() - begin < kPatience);
  value.wait(old, std::memory_order_acquire);
}

std::uint64_t rangeOf(std::uint64_t first, std::uint64_t end) noexcept
{
  return end << 32 | first;
}

/// Takes the first part of a range, or the last one. @return whether there was one.
bool take(std::atomic<std::uint64_t>& range, bool isOwn, std::uint32_t& part) noexcept
{
  std::uint64_t now = range.load(std::memory_order_acquire);
  for (;;) {
    const std::uint64_t first = now & 0xffffffffu, end = now >> 32;
    if (first >= end) return false;
    const std::uint64_t rest = isOwn ? rangeOf(first + 1, end) : rangeOf(first, end - 1);
    if (!range.compare_exchange_weak(now, rest, std::memory_order_acq_rel, std::memory_order_acquire))
      continue;
    part = static_cast<std::uint32_t>(isOwn ? first : end - 1);
    return true;
  }
}

} // namespace

WorkerPool::WorkerPool(int threads) : m_shares(static_cast<std::size_t>(threads))
{
  ESM_ASSERT(threads >= 1);
  m_workers.reserve(m_shares.size() - 1);
  try {
    for (std::size_t self = 1; self < m_shares.size(); ++self)
      m_workers.emplace_back([this, self] { serve(self); });
  } catch (const std::system_error&) {
    // The system gives no more threads: those that are here take over the shares of the others.
  }
}

WorkerPool::~WorkerPool()
{
  m_stop.store(true, std::memory_order_relaxed);
  m_piece.fetch_add(1, std::memory_order_release);
  m_piece.notify_all();
}

void WorkerPool::run(std::uint32_t count, Call call, const void* context) noexcept
{
  if (count == 0) return;
  m_call = call;
  m_context = context;
  m_left.store(count, std::memory_order_relaxed);
  // Whoever takes a part has seen all that stands above.
  const std::uint64_t threads = m_shares.size();
  for (std::uint64_t t = 0; t < threads; ++t)
    m_shares[t].range.store(rangeOf(count * t / threads, count * (t + 1) / threads),
                            std::memory_order_release);
  m_piece.fetch_add(1, std::memory_order_release);
  m_piece.notify_all();
  takeParts(0);
  for (std::uint32_t left; (left = m_left.load(std::memory_order_acquire)) > 0;) waitForChange(m_left, left);
}

void WorkerPool::serve(std::size_t self) noexcept
{
  for (std::uint32_t seen = 0;;) {
    waitForChange(m_piece, seen);
    seen = m_piece.load(std::memory_order_acquire);
    if (m_stop.load(std::memory_order_relaxed)) return;
    takeParts(self);
  }
}

/// Its own parts from the front, then those of others from the back.
void WorkerPool::takeParts(std::size_t self) noexcept
{
  std::uint32_t done = 0, part = 0;
  for (std::size_t t = 0; t < m_shares.size(); ++t) {
    const std::size_t owner = (self + t) % m_shares.size();
    while (take(m_shares[owner].range, t == 0, part)) {
      m_call(m_context, part);
      ++done;
    }
  }
  if (done == 0) return;
  m_left.fetch_sub(done, std::memory_order_acq_rel);
  m_left.notify_one();
}

} // namespace esm
