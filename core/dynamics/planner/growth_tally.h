// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

namespace esm {

/// How a small difference has grown from frame to frame, in logarithms. What it grows by from any time to any later
/// one is what becomes of an error; but a phase or a place that drifts grows in proportion to time, without end, and
/// multiplies nothing: what counts must have come faster than that.
class GrowthTally {
public:
  explicit GrowthTally(double driftPower) noexcept : m_driftPower(driftPower) {}

  void restart() noexcept; ///< frames that follow upon no others
  void beginBurst() noexcept { m_burstStart = m_size; }
  /// A frame more. @return whether the difference has grown no faster than with that power of the frames that were
  /// followed, since it was at its least
  bool add(double growth) noexcept;
  double sinceLeast() const noexcept { return m_size - m_least; }
  double inBurst() const noexcept { return m_size - m_burstStart; }

private:
  double m_driftPower;
  double m_size = 0.0;       ///< now, as it would be had it not been made small
  double m_least = 0.0;      ///< so far
  double m_burstStart = 0.0; ///< when the present frames began
  int m_frames = 0;          ///< since it was at its least
  int m_mark = 1;            ///< a power of two of them, the last that was passed
  double m_mostSoFar = 0.0, m_mostAtMark = 0.0, m_mostAtFormerMark = 0.0; ///< since then
};

} // namespace esm
