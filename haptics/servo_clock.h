// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <thread>

namespace esm {

/// What the servo loop takes for time [s]. Real devices run on SteadyClock; tests run the very same loop on
/// VirtualClock, one thread, no waiting, equal results each time.
class ServoClock {
public:
  virtual ~ServoClock() = default;
  virtual double now() noexcept = 0;
  virtual void sleepUntil(double time) noexcept = 0; ///< may return late, never early
};

class SteadyClock final : public ServoClock {
public:
  double now() noexcept override
  {
    return std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
  }
  void sleepUntil(double time) noexcept override
  {
    // Rounded up: waking before the deadline would count as a negative delay.
    std::this_thread::sleep_until(
      Clock::time_point(std::chrono::ceil<Clock::duration>(std::chrono::duration<double>(time))));
  }

private:
  using Clock = std::chrono::steady_clock;
};

/// Time that moves only when somebody sleeps.
class VirtualClock final : public ServoClock {
public:
  double now() noexcept override { return m_now; }
  void sleepUntil(double time) noexcept override
  {
    if (time > m_now) m_now = time;
    m_now += m_delay;
    m_delay = 0.0;
  }
  void delayNextWake(double seconds) noexcept { m_delay = seconds; } ///< as a busy system would

private:
  double m_now = 0.0, m_delay = 0.0;
};

} // namespace esm
