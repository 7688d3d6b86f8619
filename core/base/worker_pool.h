// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <thread>
#include <vector>

namespace esm {

/// Threads that share the parts of one piece of work, for pieces of some ten microseconds that follow each
/// other closely.
///
///     pool.forEach(parts.size(), [&](std::size_t i) noexcept { work(parts[i]); });
///
/// The caller is one of the threads. Each begins with a run of neighbouring parts that is its own, the same
/// every time, so that its caches know them; who is done takes over what others have not begun. A worker that
/// gets no processor therefore delays nobody. Between two pieces workers look out for the next one for some
/// tens of microseconds, then sleep.
///
/// Which thread does a part depends on chance: results are the same bits on any number of threads only if
/// parts write to different places and sums over parts are taken afterwards, in the order of the parts.
/// @note Threads: one caller at a time. forEach() does not allocate.
class WorkerPool {
public:
  /// @param threads  >= 1, the caller included; fewer if the system gives no more.
  explicit WorkerPool(int threads);
  ~WorkerPool();
  WorkerPool(const WorkerPool&) = delete;
  WorkerPool& operator=(const WorkerPool&) = delete;

  int threads() const noexcept { return static_cast<int>(m_workers.size()) + 1; }

  /// Calls task(i) for i = 0 .. count - 1 and returns when all are done. What the caller wrote before, tasks
  /// see; what they write, the caller sees. Tasks must not throw, nor call forEach().
  template <class Task>
  void forEach(std::size_t count, const Task& task) noexcept
  {
    run(
      static_cast<std::uint32_t>(count),
      [](const void* context, std::uint32_t i) noexcept { (*static_cast<const Task*>(context))(i); }, &task);
  }

private:
  using Call = void (*)(const void*, std::uint32_t) noexcept;
  /// The parts that one thread begins with and that nobody has taken yet: first in the low half, end in the
  /// high half.
  struct alignas(64) Share {
    std::atomic<std::uint64_t> range{0};
  };

  void run(std::uint32_t count, Call call, const void* context) noexcept;
  void serve(std::size_t self) noexcept;
  void takeParts(std::size_t self) noexcept;

  std::vector<Share> m_shares; ///< one for each thread, the caller's first
  // The present piece; written while no part is to be had.
  Call m_call = nullptr;
  const void* m_context = nullptr;
  alignas(64) std::atomic<std::uint32_t> m_left{0};  ///< parts not done
  alignas(64) std::atomic<std::uint32_t> m_piece{0}; ///< counts the pieces; workers wait for it to change
  std::atomic<bool> m_stop{false};
  std::vector<std::jthread> m_workers;
};

/// The same with or without a pool.
template <class Task>
void forEachPart(WorkerPool* pool, std::size_t count, const Task& task) noexcept
{
  if (pool != nullptr && count > 1)
    pool->forEach(count, task);
  else
    for (std::size_t i = 0; i < count; ++i) task(i);
}

} // namespace esm
