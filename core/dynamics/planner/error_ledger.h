// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/assert.h"
#include "core/dynamics/planner/policy.h"

#include <algorithm>

namespace esm {

/// Says who may spend which share of the tolerance. There are two accounts while a net moves, steps and sleepers,
/// whose errors are of different nodes and times, so that their squares add up; and one when its motion ends as a
/// whole (Settling), which is paid from what those have left. All grants together are never more than the tolerance.
class ErrorLedger {
public:
  explicit ErrorLedger(const Policy::Shares& shares = {}) noexcept : m_shares(shares)
  {
    ESM_ASSERT(square(m_shares.steps) + square(m_shares.sleepers) <= 1.0);
    ESM_ASSERT(m_shares.beforeRelease <= 1.0 && m_shares.atEnd <= 1.0 &&
               m_shares.mostAtEnd <= m_shares.atEnd);
  }

  /// Of the tolerance, what steps may err.
  /// @param awaitsRelease  nodes that are held now will be let go
  double steps(bool awaitsRelease) const noexcept
  {
    return awaitsRelease ? m_shares.beforeRelease * m_shares.steps : m_shares.steps;
  }
  /// The same, what those miss who rest.
  double sleepers() const noexcept { return m_shares.sleepers; }
  /// Of the mean square that the tolerance allows, what may be missed where a motion ends as a whole: from then on
  /// nobody sleeps beside it, so that the sleepers' account is its own.
  /// @param spent  the same, that steps have erred so far
  double settling(double spent) const noexcept
  {
    const double own = square(m_shares.sleepers);
    const double grant = std::clamp(m_shares.atEnd - spent, own, m_shares.mostAtEnd);
    ESM_ASSERT(!(spent <= square(m_shares.steps)) || spent + grant <= 1.0);
    return grant;
  }

private:
  static double square(double value) noexcept { return value * value; }
  Policy::Shares m_shares;
};

} // namespace esm
