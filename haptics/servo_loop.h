// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "haptics/haptic_device.h"
#include "haptics/jitter_histogram.h"
#include "haptics/servo_clock.h"
#include "haptics/servo_core.h"
#include "haptics/thread_priority.h"

#include <atomic>
#include <memory>
#include <thread>

namespace esm {

/// Calls ServoCore once per period, by absolute deadlines, and owns the device meanwhile.
///
/// A tick measures the time since the last one; late ticks are counted, missed ones dropped, never made up
/// for: two forces in quick succession help nobody. Ending the loop, for whatever reason (see ExitGuard too),
/// lets the force fall at the slew rate and then sends zero three times, since a packet may be lost.
///
///     ServoLoop loop(std::move(device), std::make_unique<SteadyClock>(), tool, contact);
///     loop.start();        // own thread
///     VirtualClock: loop.runTicks(1000) on this thread instead, the same code and equal results each time
class ServoLoop {
public:
  ServoLoop(std::unique_ptr<HapticDevice> device, std::unique_ptr<ServoClock> clock,
            TripleBuffer<ToolState>& tool, TripleBuffer<ContactModel>& contact);
  ~ServoLoop(); ///< finish(), if that has not happened yet
  ServoLoop(const ServoLoop&) = delete;
  ServoLoop& operator=(const ServoLoop&) = delete;

  void start();                      ///< in its own thread
  void runTicks(int count) noexcept; ///< on the calling thread. @pre not started
  void finish() noexcept;            ///< ends the loop with zero force; joins the thread

  ServoCore& core() noexcept { return m_core; }
  HapticDevice& device() noexcept { return *m_device; }
  JitterCounts jitter() const noexcept { return m_jitter.counts(); } ///< any thread
  ServoPriority priority() const noexcept { return m_priority.load(std::memory_order_relaxed); }

private:
  void nextTick() noexcept;
  void run(const std::stop_token& stop) noexcept;
  void countLateness(double now, double lateness) noexcept;
  void fallToZero() noexcept;

  std::unique_ptr<HapticDevice> m_device;
  std::unique_ptr<ServoClock> m_clock;
  ServoCore m_core;
  double m_period;
  double m_deadline, m_lastTick;
  double m_meanTick;                                         ///< smoothed [s]
  double m_worstNow = 0.0, m_worstBefore = 0.0, m_windowEnd; ///< half-second windows
  double m_longestNow = 0.0, m_longestBefore = 0.0;
  JitterHistogram m_jitter;
  std::atomic<ServoPriority> m_priority{ServoPriority::Normal};
  bool m_finished = false;
  std::jthread m_thread; ///< last: joins before the rest goes
};

} // namespace esm
