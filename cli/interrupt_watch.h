// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <mutex>
#include <thread>

namespace esm::cli {

/// In its life, Ctrl-C (SIGINT), kill (SIGTERM) and the end of the terminal (SIGHUP) clean up before they end
/// the program, however long the present frame takes: a thread of its own waits for them, calls `cleanUp`
/// under the mutex and then lets the signal do what it does to any program. Whoever touches what cleanUp
/// touches holds the mutex. Signals that the caller of the program ignores (nohup) stay ignored.
/// @note One at a time; to be made before other threads, which inherit that the signals do not end them.
class InterruptWatch {
public:
  /// @param cleanUp  runs on the watching thread; must not wait for the mutex, which is held.
  explicit InterruptWatch(std::function<void()> cleanUp);
  ~InterruptWatch();
  InterruptWatch(const InterruptWatch&) = delete;
  InterruptWatch& operator=(const InterruptWatch&) = delete;

  std::mutex& mutex() noexcept { return m_mutex; }

private:
  void wait(const std::stop_token& stop);

  std::function<void()> m_cleanUp;
  std::mutex m_mutex;
  std::jthread m_thread;
};

} // namespace esm::cli
