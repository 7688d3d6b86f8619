// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <stop_token>
#include <utility>
#include <vector>

namespace esm {

/// Orders from one thread to another: every one arrives, in order, whatever its size.
///
/// A vector behind a mutex, emptied by a swap, rather than a ring: a ring must be bounded, and when it is
/// full either an order is lost or the sender waits; here neither happens. The lock is held for one push_back
/// or one swap (well under a microsecond), never while an order is carried out, so the window does not feel
/// it. The servo thread does not use this; it talks through triple buffers.
/// @note Threads: push() on any, the rest on the receiver.
template <class Command>
class CommandQueue {
public:
  using Clock = std::chrono::steady_clock;

  void push(Command command)
  {
    {
      const std::lock_guard lock(m_mutex);
      m_waiting.push_back(std::move(command));
      m_hasNews.store(true, std::memory_order_relaxed);
    }
    m_wake.notify_one();
  }

  /// Replaces `batch` by all that waits, oldest first.
  void take(std::vector<Command>& batch)
  {
    batch.clear();
    const std::lock_guard lock(m_mutex);
    std::swap(batch, m_waiting);
    m_hasNews.store(false, std::memory_order_relaxed);
  }

  /// Whether take() would bring something; a hint without a lock, to break off long work.
  bool hasNews() const noexcept { return m_hasNews.load(std::memory_order_relaxed); }

  /// Sleeps until there is a command or a stop is asked for.
  void waitForNews(const std::stop_token& stop)
  {
    std::unique_lock lock(m_mutex);
    m_wake.wait(lock, stop, [this] { return !m_waiting.empty(); });
  }

  /// Sleeps until `deadline`, whatever is pushed meanwhile; returns early only if a stop is asked for.
  void sleepUntil(Clock::time_point deadline, const std::stop_token& stop)
  {
    std::unique_lock lock(m_mutex);
    m_wake.wait_until(lock, stop, deadline, [] { return false; });
  }

private:
  std::mutex m_mutex;
  std::condition_variable_any m_wake;
  std::vector<Command> m_waiting;
  std::atomic<bool> m_hasNews{false};
};

} // namespace esm
