// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <ctime>

#include <semaphore.h>

namespace esm {

/// Wakes the one thread that waits. post() neither locks nor waits: the servo thread may call it.
class Wakeup {
public:
  Wakeup() noexcept { sem_init(&m_semaphore, 0, 0); }
  ~Wakeup() { sem_destroy(&m_semaphore); }
  Wakeup(const Wakeup&) = delete;
  Wakeup& operator=(const Wakeup&) = delete;

  void post() noexcept { sem_post(&m_semaphore); } ///< any thread

  /// Until a post() since the last wait, or so long.
  void wait(double seconds) noexcept
  {
    timespec until{};
    clock_gettime(CLOCK_MONOTONIC, &until);
    const double whole = std::floor(seconds);
    until.tv_sec += static_cast<std::time_t>(whole);
    until.tv_nsec += static_cast<long>((seconds - whole) * 1e9);
    if (until.tv_nsec >= 1000000000) {
      ++until.tv_sec;
      until.tv_nsec -= 1000000000;
    }
    if (sem_clockwait(&m_semaphore, CLOCK_MONOTONIC, &until) != 0) return;
    while (sem_trywait(&m_semaphore) == 0) {
    } // many posts, one wake
  }

private:
  sem_t m_semaphore;
};

} // namespace esm
