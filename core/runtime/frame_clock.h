// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

namespace esm {

/// How a run stands with the wall clock at a moment.
struct Pace {
  double realTimeFactor = 0.0; ///< simulated over wall time, smoothed [1]
  double lag = 0.0;            ///< of simulated time behind the wall clock, see FrameClock [s]
  double frameTime = 0.0;      ///< for how long the frame under way has been computed; 0: none is [s]
  bool isSlow() const noexcept { return realTimeFactor < 0.95; }
};

/// When the next frame is due, and how well the simulation keeps up with the wall clock.
///
/// Frames are due on a fixed grid, so that the small delays of waking up do not add up to drift. A frame that
/// comes late by less than a period is caught up by the next one starting at once. What is later than that is
/// let go: the grid moves, simulated time falls behind for good, and realTimeFactor() says by how much. So a
/// net that is too large runs in slow motion; it never runs after a debt that grows with each frame.
///
/// Whoever holds a copy knows how the run stands at any later time, without a word from the thread that
/// computes: paceAt() takes what is overdue for not yet done. The factor is then the best that it can still
/// be, as if the frame under way ended at that moment with all that it was to simulate: at 60 Hz it falls from
/// 1 below 0.95 within 45 ms of the last frame's end. The lag is by how much simulated time is behind the
/// grid: that of the last frame's end, or more once the next one is later; a frame in time forgets it.
/// Only arithmetic: the caller brings the times, tests bring invented ones. All times in [s].
class FrameClock {
public:
  explicit FrameClock(double period) : m_period(period) {}

  /// Starts anew: the first frame is due at `now`.
  void start(double now) noexcept;
  void setPeriod(double period) noexcept { m_period = period; }
  double period() const noexcept { return m_period; }
  double deadline() const noexcept { return m_deadline; }

  /// A frame ended at `now`. It moved the simulation by `simulated` and took `processorTime`. One that got nowhere
  /// is no end: what it was to do is still under way, and the longer late.
  void endFrame(double now, double simulated, double processorTime) noexcept;

  /// @param now  not before the last endFrame() or start().
  Pace paceAt(double now) const noexcept;
  double realTimeFactor() const noexcept
  {
    return m_factor;
  } ///< as the last frame ended: simulated over wall time [1]
  double frameCost() const noexcept { return m_cost; } ///< processor time over period, smoothed [1]

private:
  double m_period;
  double m_deadline = 0.0;
  double m_lastEnd = 0.0;
  double m_factor = 0.0, m_cost = 0.0;
  double m_unpaid = 0.0; ///< processor time of frames that got nowhere, since the last that did [s]
  double m_lag = 0.0;    ///< with which the last frame ended [s]
  bool m_first = true;
};

} // namespace esm
