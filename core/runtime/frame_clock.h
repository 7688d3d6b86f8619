// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

namespace esm {

/// When the next frame is due, and how well the simulation keeps up with the wall clock.
///
/// Frames are due on a fixed grid, so that the small delays of waking up do not add up to drift. A frame that
/// comes late by less than a period is caught up by the next one starting at once. What is later than that is
/// let go: the grid moves, simulated time falls behind for good, and realTimeFactor() says by how much. So a
/// net that is too large runs in slow motion; it never runs after a debt that grows with each frame.
/// Only arithmetic: the caller brings the times, tests bring invented ones. All times in [s].
class FrameClock {
public:
  explicit FrameClock(double period) : m_period(period) {}

  /// Starts anew: the first frame is due at `now`.
  void start(double now) noexcept;
  void setPeriod(double period) noexcept { m_period = period; }
  double period() const noexcept { return m_period; }
  double deadline() const noexcept { return m_deadline; }

  /// A frame ended at `now`. It moved the simulation by `simulated` and took `processorTime`.
  void endFrame(double now, double simulated, double processorTime) noexcept;

  double realTimeFactor() const noexcept { return m_factor; } ///< simulated over wall time, smoothed [1]
  double frameCost() const noexcept { return m_cost; }        ///< processor time over period, smoothed [1]

private:
  double m_period;
  double m_deadline = 0.0;
  double m_lastEnd = 0.0;
  double m_factor = 0.0, m_cost = 0.0;
  bool m_first = true;
};

} // namespace esm
