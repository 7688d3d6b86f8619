// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "haptics/servo_loop.h"

#include "haptics/exit_guard.h"
#include "haptics/no_denormals.h"
#include "haptics/zero_reports.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace esm {

namespace {

constexpr double kLateShare = 0.5;      ///< of a period; a later tick counts as late
constexpr double kRateSmoothing = 0.5;  ///< [s]
constexpr double kLatenessWindow = 0.5; ///< [s]; the worst of the last two is shown
constexpr int kMostFallingTicks = 200;  ///< far more than the largest force needs

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
  m_thread = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

void ServoLoop::run(const std::stop_token& stop) noexcept
{
  const LiveServo alive([](void* core) noexcept { static_cast<ServoCore*>(core)->sendZero(); }, &m_core);
  m_priority.store(raiseThreadPriority(), std::memory_order_relaxed);
  dropDenormals();
  m_lastTick = m_deadline = m_clock->now();
  while (!stop.stop_requested() && !ExitGuard::requested()) nextTick();
  fallToZero();
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
  figures.tickTime = std::max(m_longestNow, m_longestBefore);
  figures.lateness = lateness;
  m_core.tick(now, dt);
  m_longestNow = std::max(m_longestNow, m_clock->now() - now);
}

void ServoLoop::countLateness(double now, double lateness) noexcept
{
  if (now >= m_windowEnd) {
    m_worstBefore = m_worstNow;
    m_worstNow = 0.0;
    m_longestBefore = std::exchange(m_longestNow, 0.0);
    m_windowEnd = now + kLatenessWindow;
  }
  m_worstNow = std::max(m_worstNow, lateness);
  if (lateness > kLateShare * m_period) ++m_core.figures().lateTicks;
  const double missed = std::floor(lateness / m_period);
  m_core.figures().lateTicks += static_cast<std::uint64_t>(missed);
  m_jitter.add(lateness, static_cast<std::uint64_t>(missed));
  m_deadline += missed * m_period; // the grid stays, the missed ticks are dropped
}

void ServoLoop::fallToZero() noexcept
{
  m_core.close();
  for (int i = 0; i < kMostFallingTicks; ++i) {
    nextTick();
    if (m_core.force().isZero(0.0)) break;
  }
  for (int i = 0; i < kZeroReports; ++i) m_core.sendZero();
}

} // namespace esm
