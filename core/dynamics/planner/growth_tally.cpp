// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/planner/growth_tally.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace esm {

void GrowthTally::restart() noexcept
{
  m_size = m_least = m_burstStart = 0.0;
  m_frames = 0;
}

/// Marks stand at powers of two of the frames, so the former one at a half to a quarter of the way.
bool GrowthTally::add(double growth) noexcept
{
  m_size += growth;
  if (m_frames == 0 || m_size < m_least) {
    m_least = std::min(m_least, m_size);
    m_frames = m_mark = 1;
    m_mostSoFar = m_mostAtMark = m_mostAtFormerMark = m_least;
    return true;
  }
  if (++m_frames >= 2 * m_mark) {
    m_mark *= 2;
    m_mostAtFormerMark = std::exchange(m_mostAtMark, m_mostSoFar);
  }
  m_mostSoFar = std::max(m_mostSoFar, m_size);
  const double share = 2.0 * m_frames / m_mark; // of now over the former mark
  return m_size - m_mostAtFormerMark <= m_driftPower * std::log(share);
}

} // namespace esm
