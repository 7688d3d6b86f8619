// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/methods/chebyshev_damping.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace esm {
namespace {

/// T_s(w0) for order 1: 1/1.85 = 0.54 is how far P swings below zero. Smaller swings cost stages, larger ones
/// bring P near -1, where leapfrog bears no stiffness at all.
constexpr double kPeak = 1.85;
constexpr double kShift = 2.0 / 13.0; ///< s^2 (w0 - 1) for order 2 (Verwer et al.)

/// T_n(w) and its first two derivatives.
struct ChebyshevValue {
  double value, slope, curvature;
};

ChebyshevValue chebyshev(int n, double w) noexcept
{
  ChebyshevValue before{1.0, 0.0, 0.0}, now{w, 1.0, 0.0};
  if (n == 0) return before;
  for (int j = 2; j <= n; ++j) {
    const ChebyshevValue next{2.0 * w * now.value - before.value,
                              2.0 * (now.value + w * now.slope) - before.slope,
                              2.0 * (2.0 * now.slope + w * now.curvature) - before.curvature};
    before = std::exchange(now, next);
  }
  return now;
}

/// w0 with T_s(w0) = kPeak, by bisection: only + - * /, so that the bits are the same everywhere.
double peakPlace(int stages) noexcept
{
  double low = 1.0, high = 2.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (chebyshev(stages, middle).value < kPeak ? low : high) = middle;
  }
  return low;
}

} // namespace

ChebyshevDamping::ChebyshevDamping(int stages, int order, bool inPhase)
  : m_stages(stages), m_alternating(inPhase ? 4.0 / 3.0 : 1.0)
{
  if (stages == 1) { // P = 1 - z
    m_w0 = 0.0;
    m_base = 1.0;
    sampleRoom();
    return;
  }
  m_w0 = order == 1 ? peakPlace(stages) : 1.0 + kShift / (stages * stages);
  // b_j: the scale of the polynomial after stage j; it starts from 1 at z = 0 and, for order 2, has the right
  // curvature there.
  const auto scaleAt = [&](int j) {
    const ChebyshevValue at = chebyshev(order == 1 ? j : std::max(j, 2), m_w0);
    return order == 1 ? 1.0 / at.value : at.curvature / (at.slope * at.slope);
  };
  const auto baseAt = [&](int j) { return order == 1 ? 0.0 : 1.0 - scaleAt(j) * chebyshev(j, m_w0).value; };
  const ChebyshevValue last = chebyshev(stages, m_w0);
  m_w1 = order == 1 ? last.value / last.slope : last.slope / last.curvature;
  m_base = baseAt(stages);
  m_swing = scaleAt(stages);
  m_reach = (1.0 + m_w0) / m_w1;
  for (int j = 2; j <= stages; ++j) {
    const double ratio = scaleAt(j) / scaleAt(j - 1), kick = 2.0 * m_w1 * ratio;
    m_stage[static_cast<std::size_t>(j)] = {2.0 * m_w0 * ratio, -scaleAt(j) / scaleAt(j - 2),
                                            kick * (1.0 - baseAt(j - 1)), kick};
  }
  const double first = scaleAt(1) * m_w1; // of a
  Stage &second = m_stage[2], &third = m_stage[3];
  second = {0.0, 0.0, second.mu * first + second.push, second.kick * first};
  third = {third.mu, 0.0, third.nu * first + third.push, third.kick};
  sampleRoom();
}

void ChebyshevDamping::sampleRoom() noexcept
{
  for (std::size_t i = 0; i < kSamples; ++i) m_room[i] = roomAt(rateOf(i));
}

double ChebyshevDamping::value(double z) const noexcept
{
  return m_base + m_swing * chebyshev(m_stages, m_w0 - m_w1 * z).value;
}

/// For h^2 M^-1 K, at the rate z; not a number where z is none, and nothing is stable then.
double ChebyshevDamping::roomAt(double z) const noexcept
{
  if (z < 1e-9) return 4.0 / m_alternating; // the difference would be one of roundings
  const double p = value(z);
  if (p >= 1.0) return std::numeric_limits<double>::infinity();
  return 2.0 * (2.0 / m_alternating - 1.0 + p) * z / (1.0 - p);
}

/// Whether a mean of two bounds is below the room for all rates: the room need not be convex.
bool ChebyshevDamping::isStable(double h, double damping, const StiffnessBound& one,
                                const StiffnessBound& other) const noexcept
{
  double least = 0.0, most = 1.0; // the weights of the other that serve
  const auto serve = [&](double z, double room) {
    const double all = h * (h * one.rest + z * one.perDamping);
    const double more = h * (h * other.rest + z * other.perDamping) - all, left = room - all;
    if (more > 0.0)
      most = std::min(most, left / more);
    else if (more < 0.0)
      least = std::max(least, left / more);
    else
      return left > 0.0;
    return least <= most;
  };
  const double top = h * damping;
  for (std::size_t i = 0; i < kSamples && rateOf(i) < top; ++i)
    if (!serve(rateOf(i), m_room[i])) return false;
  return serve(top, roomAt(top));
}

bool ChebyshevDamping::isStable(double h, const FastestMode& mode) const noexcept
{
  const StiffnessBound all{mode.stiffness, 0.0};
  if (!(mode.leastDamping > 0.0)) return isStable(h, mode.damping, all, all);
  const StiffnessBound owed{mode.undamped, 1.0 / mode.leastDamping};
  if (!(mode.owedShare < 1.0)) return isStable(h, mode.damping, all, owed);
  const StiffnessBound share{mode.undampedByShare, mode.owedShare / mode.leastDamping};
  return isStable(h, mode.damping, all, share) || isStable(h, mode.damping, share, owed);
}

double ChebyshevDamping::stableStep(const FastestMode& mode) const noexcept
{
  constexpr int kRungs = 24, kHalvings = 6;
  const auto elastic = [](double stiffness) {
    return stiffness > 0.0 ? 2.0 / std::sqrt(stiffness) : std::numeric_limits<double>::infinity();
  };
  const double viscous =
    mode.damping > 0.0 ? m_reach / mode.damping : std::numeric_limits<double>::infinity();
  // Where dampers go with the stiffness, only what has none is held to 2/w.
  const double bare = mode.leastDamping > 0.0 ? std::min(mode.undamped, mode.stiffness) : mode.stiffness;
  const double high = std::min(elastic(bare), viscous);
  if (!std::isfinite(high)) return high;
  // Beyond a step that is not stable there may be others that are: no step up to the limit may fail.
  double low = 0.0, failed = high;
  for (int i = 1; i <= kRungs; ++i) {
    const double h = high * (1.0 - 1e-6) * i / kRungs;
    if (!isStable(h, mode)) {
      failed = h;
      break;
    }
    low = h;
    if (i == kRungs) return high;
  }
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + failed);
    (isStable(middle, mode) ? low : failed) = middle;
  }
  return low;
}

} // namespace esm
