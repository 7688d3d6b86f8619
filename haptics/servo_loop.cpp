// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/servo_loop.h"

#include <algorithm>
#include <cmath>

#include <pthread.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/resource.h>

namespace esm {

namespace {

constexpr int kRealTimePriority = 15; ///< above ordinary programs, below the kernel's own threads
constexpr int kRaisedNice = -11;
constexpr unsigned long kTimerSlack = 1000; ///< [ns]
constexpr double kLateShare = 0.5;          ///< of a period; a later tick counts as late
constexpr double kRateSmoothing = 0.5;      ///< [s]
constexpr double kLatenessWindow = 0.5;     ///< [s]; the worst of the last two is shown
constexpr int kMostFallingTicks = 200;      ///< far more than the largest force needs
constexpr int kZeroPackets = 3;

/// The best that the system allows this thread; most users are allowed none of it, and the loop then runs
/// with what it has.
ServoPriority raisePriority() noexcept
{
  prctl(PR_SET_TIMERSLACK, kTimerSlack); // by default sleeping may take 50 us longer to spare power
  sched_param parameter{};
  parameter.sched_priority = kRealTimePriority;
  if (pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameter) == 0) return ServoPriority::RealTime;
  // On Linux this sets the calling thread only.
  if (setpriority(PRIO_PROCESS, 0, kRaisedNice) == 0) return ServoPriority::Raised;
  return ServoPriority::Normal;
}

} // namespace

ServoLoop::ServoLoop(std::unique_ptr<HapticDevice> device, std::unique_ptr<ServoClock> clock,
                     TripleBuffer<ToolState>& tool, TripleBuffer<ContactModel>& contact)
  : m_device(std::move(device)),
    m_clock(std::move(clock)),
    m_core(*m_device, tool, contact),
    m_period(m_device->profile().period),
    m_deadline(m_clock->now()),
    m_lastTick(m_deadline),
    m_meanTick(m_period),
    m_windowEnd(m_deadline + kLatenessWindow)
{}

ServoLoop::~ServoLoop()
{
  finish();
}

void ServoLoop::start()
{
  m_thread = std::jthread([this](const std::stop_token& stop) {
    m_priority.store(raisePriority(), std::memory_order_relaxed);
    m_lastTick = m_deadline = m_clock->now();
    while (!stop.stop_requested()) nextTick();
    fallToZero();
  });
}

void ServoLoop::runTicks(int count) noexcept
{
  for (int i = 0; i < count; ++i) nextTick();
}

void ServoLoop::finish() noexcept
{
  if (m_finished) return;
  m_finished = true;
  if (m_thread.joinable()) {
    m_thread.request_stop();
    m_thread.join();
  } else {
    fallToZero();
  }
}

void ServoLoop::nextTick() noexcept
{
  m_deadline += m_period;
  m_clock->sleepUntil(m_deadline);
  const double now = m_clock->now();
  const double lateness = std::max(now - m_deadline, 0.0);
  countLateness(now, lateness);
  const double dt = std::max(now - m_lastTick, 1e-6);
  m_lastTick = now;
  m_meanTick += (1.0 - std::exp(-dt / kRateSmoothing)) * (dt - m_meanTick);
  ServoStatus& figures = m_core.figures();
  ++figures.ticks;
  figures.rate = 1.0 / m_meanTick;
  figures.worstLateness = std::max(m_worstNow, m_worstBefore);
  m_core.tick(now, dt);
}

void ServoLoop::countLateness(double now, double lateness) noexcept
{
  if (now >= m_windowEnd) {
    m_worstBefore = m_worstNow;
    m_worstNow = 0.0;
    m_windowEnd = now + kLatenessWindow;
  }
  m_worstNow = std::max(m_worstNow, lateness);
  if (lateness > kLateShare * m_period) ++m_core.figures().lateTicks;
  const double missed = std::floor(lateness / m_period);
  m_core.figures().lateTicks += static_cast<std::uint64_t>(missed);
  m_deadline += missed * m_period; // the grid stays, the missed ticks are dropped
}

void ServoLoop::fallToZero() noexcept
{
  m_core.close();
  for (int i = 0; i < kMostFallingTicks; ++i) {
    nextTick();
    if (m_core.force().isZero(0.0)) break;
  }
  for (int i = 0; i < kZeroPackets; ++i) m_core.sendZero();
}

} // namespace esm
