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
  m_first = true;
}

void FrameClock::endFrame(double now, double simulated, double processorTime) noexcept
{
  // The pace over one whole cycle of waiting and working. The first frame has waited for nothing yet: it
  // counts as if it had taken a period at least.
  const double elapsed = std::max(now - m_lastEnd, m_first ? m_period : 1e-9);
  const double weight = m_first ? 1.0 : 1.0 - std::exp(-elapsed / kSmoothing);
  m_factor += weight * (simulated / elapsed - m_factor);
  m_cost += weight * (processorTime / m_period - m_cost);
  m_lastEnd = m_first ? m_deadline + elapsed : now;
  m_first = false;

  m_deadline += m_period;
  if (now > m_deadline + m_period) m_deadline = now;
}

} // namespace esm
