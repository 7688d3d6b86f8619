// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/lanes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

// What a method that remembers forces does where its steps change, see Leapfrog.

namespace esm {

/// What the present force and those at one and two steps before count.
struct PastWeights {
  double now = 1.0, past = 0.0, older = 0.0;

  /// F + first F' + second F'', from forces that are `apart` [s].
  static PastWeights series(double first, double second, double apart) noexcept
  {
    const double slope = first / apart, bend = second / (apart * apart);
    return {1.0 + 1.5 * slope + bend, -2.0 * (slope + bend), 0.5 * slope + bend};
  }
  /// F `ratio` times as long ago as the past one.
  static PastWeights interpolated(double ratio) noexcept
  {
    const double bend = 0.5 * ratio * (ratio - 1.0);
    return {1.0 - ratio + bend, ratio - 2.0 * bend, bend};
  }
  ESM_INLINE void mean(const Lanes& f, const Lanes& p, const Lanes& o, Lanes& result) const noexcept
  {
    result = f * now + p * past + o * older;
  }
};

/// The instants of a run in equal steps h, the first of them in parts that double, the first two alike.
struct RunInstants {
  double begin, end, h;
  std::int64_t steps;
  int halvings; ///< of h, to the first part

  std::int64_t last() const noexcept { return steps + halvings; }
  double time(std::int64_t i) const noexcept
  {
    if (i == last()) return end;
    if (i > halvings) return begin + static_cast<double>(i - halvings) * h;
    return i > 0 ? begin + std::ldexp(h, static_cast<int>(i) - 1 - halvings) : begin;
  }
  double stepBefore(std::int64_t i) const noexcept ///< @pre i > 0
  {
    return i - 1 > halvings ? h : std::ldexp(h, std::max(static_cast<int>(i) - 2, 0) - halvings);
  }
  double stepAfter(std::int64_t i) const noexcept { return i == last() ? 0.0 : stepBefore(i + 1); }
};

} // namespace esm
