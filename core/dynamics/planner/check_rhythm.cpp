// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/planner/check_rhythm.h"

#include <algorithm>
#include <cmath>

namespace esm {

void CheckRhythm::reset(double time) noexcept
{
  anew();
  m_error = m_power = m_errorOverLocal = 0.0;
  m_time = time;
  m_growing = 1.0;
  m_isRough = false;
}

double CheckRhythm::expectedError(double length, double power) const noexcept
{
  if (m_localError > 0.0 && m_errorOverLocal > 0.0) return m_errorOverLocal * m_localError;
  const double grown = m_power > 0.0 ? std::sqrt(std::max(power, 0.0) / m_power) : 1.0;
  return m_error * length * grown;
}

/// Fast waves lose most of what is left of local errors on the way: in nets with stiffness over six decades a
/// fiftieth to a fifth is left, the least where a part of them snaps through. So one check moves what is known by
/// half of the way, in logarithms.
void CheckRhythm::learnOverLocal(double error, double length) noexcept
{
  const bool isFirst = !(m_errorOverLocal > 0.0);
  const double found = error / m_localError;
  if (!(found > 0.0) || !std::isfinite(found) || (length < m_policy->checks.leastProof && !isFirst)) return;
  m_errorOverLocal = isFirst ? found : std::sqrt(found * m_errorOverLocal);
}

/// What the effort keeps from shrinking gains nothing by checks. A step that has grown is looked at at once.
void CheckRhythm::learn(const Found& found) noexcept
{
  const Policy::Checks& policy = m_policy->checks;
  m_share = found.share;
  m_error = found.error / found.length;
  m_power = found.power;
  const bool isKept = found.share <= policy.mostShareKept;
  if (!isKept) {
    m_gap = found.isHeld ? std::min(2 * m_gap, policy.longestRoughGap) : std::max(1, m_gap / 4);
  } else {
    const int wider = found.length < policy.leastProof ? m_gap : 2 * m_gap;
    m_gap = std::min(wider, found.grows ? 2 : policy.longestGap);
  }
  m_until = isKept && found.grows ? 1 : m_gap;
  const double left = std::ceil(found.timeLeft / kFrame); // stretches
  if (found.share <= policy.sureShare && left <= policy.gapsBeforeEnd * m_until)
    m_until = static_cast<int>(left) + 1;
}

double CheckRhythm::passCheck(double time) noexcept
{
  const double since = (time - m_time) / kFrame; // stretches
  m_time = time;
  return std::clamp(since / m_policy->probes.waitedPerCheck, 1.0,
                    static_cast<double>(m_policy->probes.longestGap));
}

} // namespace esm
