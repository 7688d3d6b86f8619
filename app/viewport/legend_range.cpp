// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/viewport/legend_range.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace esm {

namespace {

constexpr double kHalfLife = 3.0;       ///< of the running maximum [s]
constexpr double kShrinkBelow = 0.4;    ///< of `high`: below this it takes the next smaller one
constexpr double kRoundingGuard = 1e-9; ///< so that 0.1 * 10 counts as 1

/// All 1, 2, 5 x 10^n in [low, high]; `mantissas` says how many of the three.
std::vector<double> decadeSteps(double low, double high, int mantissas)
{
  static constexpr double kMantissa[] = {1.0, 2.0, 5.0};
  std::vector<double> steps;
  for (int n = static_cast<int>(std::floor(std::log10(low))); std::pow(10.0, n) <= high * 1.000001; ++n)
    for (int m = 0; m < mantissas; ++m) {
      const double step = kMantissa[m] * std::pow(10.0, n);
      if (step >= low * 0.999999 && step <= high * 1.000001) steps.push_back(step);
    }
  return steps;
}

} // namespace

double ValueRange::share(double value) const
{
  if (!logarithmic) return (value - low) / (high - low);
  if (!(value > 0.0)) return std::numeric_limits<double>::quiet_NaN();
  return std::log(value / low) / std::log(high / low);
}

double niceCeil(double value)
{
  if (!(value > 0.0) || !std::isfinite(value)) return 0.0;
  const double decade = std::pow(10.0, std::floor(std::log10(value)));
  for (const double step : {1.0, 2.0, 5.0})
    if (value <= step * decade * (1.0 + kRoundingGuard)) return step * decade;
  return 10.0 * decade;
}

double niceFloor(double value)
{
  if (!(value > 0.0) || !std::isfinite(value)) return 0.0;
  const double decade = std::pow(10.0, std::floor(std::log10(value)));
  for (const double step : {10.0, 5.0, 2.0})
    if (value >= step * decade * (1.0 - kRoundingGuard)) return step * decade;
  return decade;
}

ValueRange logRange(const Eigen::ArrayXd& values)
{
  double low = std::numeric_limits<double>::infinity(), high = 0.0;
  for (const double value : values) {
    if (!(value > 0.0) || !std::isfinite(value)) continue;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  if (high <= 0.0) return {1.0, 10.0, true};
  low = niceFloor(low);
  high = niceCeil(high);
  if (high < 2.5 * low) { // nearly one value: show it in the middle, not as an extreme
    low = niceFloor(low * 0.5);
    high = niceCeil(high * 2.0);
  }
  return {low, high, true};
}

std::vector<double> legendTicks(const ValueRange& range, int wanted)
{
  wanted = std::max(wanted, 2);
  if (!range.logarithmic) {
    const double step = niceCeil((range.high - range.low) / wanted);
    std::vector<double> ticks;
    if (step <= 0.0) return ticks;
    const auto first = static_cast<long>(std::ceil(range.low / step - 1e-6));
    const auto last = static_cast<long>(std::floor(range.high / step + 1e-6));
    for (long i = first; i <= last; ++i) ticks.push_back(static_cast<double>(i) * step);
    return ticks;
  }
  std::vector<double> ticks = decadeSteps(range.low, range.high, 3);
  if (static_cast<int>(ticks.size()) <= wanted + 2) return ticks;
  ticks = decadeSteps(range.low, range.high, 1);
  const std::size_t stride =
    (ticks.size() + static_cast<std::size_t>(wanted)) / static_cast<std::size_t>(wanted + 1);
  std::vector<double> thinned;
  for (std::size_t i = 0; i < ticks.size(); i += std::max<std::size_t>(stride, 1))
    thinned.push_back(ticks[i]);
  return thinned;
}

void SteadyRange::reset()
{
  m_peak = 0.0;
  m_high = niceCeil(m_floor);
}

void SteadyRange::add(double largest, double elapsed)
{
  if (!std::isfinite(largest)) return;
  m_peak = std::max(largest, m_peak * std::exp2(-std::max(elapsed, 0.0) / kHalfLife));
  const double wanted = std::max(niceCeil(m_peak), niceCeil(m_floor));
  if (wanted > m_high || m_peak < kShrinkBelow * m_high) m_high = wanted;
}

} // namespace esm
