// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <vector>

namespace esm {

/// From which to which value the colours run.
struct ValueRange {
  double low = 0.0, high = 1.0;
  bool logarithmic = false; ///< then low > 0

  /// 0 at low, 1 at high, beyond them outside [0, 1]; NaN for what a logarithm cannot show.
  double share(double value) const;
  bool operator==(const ValueRange&) const = default;
};

/// The smallest of 1, 2, 5 x 10^n that is >= value; 0 for value <= 0 or non-finite.
double niceCeil(double value);
double niceFloor(double value); ///< the largest that is <= value

/// A logarithmic range over the positive finite values, with ends at 1, 2 or 5 x 10^n. Equal values get a
/// range around them, none at all [1, 10].
ValueRange logRange(const Eigen::ArrayXd& values);

/// Values for the marks of a legend inside the range: round numbers, about `wanted` of them, rising.
/// Logarithmic: the decades, and 2 and 5 between them where there is room.
std::vector<double> legendTicks(const ValueRange& range, int wanted);

/// The range [0, high] for values that move. It grows at once when a larger value comes, and shrinks only
/// after the values have stayed clearly below for a while; `high` is always 1, 2 or 5 x 10^n, so the legend
/// stands still between the rare jumps and its colours can be compared from frame to frame.
class SteadyRange {
public:
  /// @param floor the smallest `high` that makes sense, so that noise at rest is not shown in full colour.
  explicit SteadyRange(double floor) : m_floor(floor) { reset(); }
  void reset();
  /// @param largest the largest value of this frame; non-finite is ignored.
  /// @param elapsed since the last frame [s].
  void add(double largest, double elapsed);
  ValueRange range() const { return {0.0, m_high, false}; }

private:
  double m_floor;
  double m_peak = 0.0; ///< running maximum, decaying
  double m_high = 0.0;
};

} // namespace esm
