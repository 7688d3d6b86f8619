// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/runtime/frame_clock.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

constexpr double kSmoothing = 0.5; ///< [s]; long enough to read, short enough to follow

}

void FrameClock::start(double now) noexcept
{
  m_deadline = now;
  m_lastEnd = now;
  m_lag = m_unpaid = 0.0;
  m_first = true;
}

Pace FrameClock::paceAt(double now) const noexcept
{
  const double elapsed = std::max(now - m_lastEnd, m_period), most = m_period / elapsed;
  const double weight = 1.0 - std::exp(-elapsed / kSmoothing);
  const double factor = m_first ? most : std::min(m_factor, m_factor + weight * (most - m_factor));
  return {factor, std::max({0.0, m_lag, now - m_deadline - m_period}),
          std::max(0.0, now - std::max(m_deadline, m_lastEnd))};
}

void FrameClock::endFrame(double now, double simulated, double processorTime) noexcept
{
  m_unpaid += processorTime;
  if (!(simulated > 0.0)) return;
  // The pace over one whole cycle of waiting and working. The first frame has waited for nothing yet: it
  // counts as if it had taken a period at least.
  const double elapsed = std::max(now - m_lastEnd, m_first ? m_period : 1e-9);
  const double weight = m_first ? 1.0 : 1.0 - std::exp(-elapsed / kSmoothing);
  m_factor += weight * (simulated / elapsed - m_factor);
  m_cost += weight * (m_unpaid / m_period - m_cost);
  m_unpaid = 0.0;
  m_lastEnd = m_first ? m_deadline + elapsed : now;
  m_first = false;

  m_lag = std::max(0.0, now - m_deadline - simulated);
  m_deadline += m_period;
  if (now > m_deadline + m_period) m_deadline = now;
}

} // namespace esm
