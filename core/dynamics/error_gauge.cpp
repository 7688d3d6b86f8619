// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/error_gauge.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace esm {
namespace {

constexpr double kErrorHorizon = 2.0; ///< motion over which errors add up at least, if nothing damps them [s]
constexpr double kShortestHorizon = 0.1; ///< [s]
constexpr double kMemory = 0.2;          ///< over which the net's damping is averaged [s]
constexpr double kSafety = 0.8;          ///< share of the tolerance that is spent on purpose
/// In which a displacement becomes what the motion makes of it [s]. With 0.03 a struck organ ended 5 % above
/// a tolerance of 1e-2, and with 0.017 more: a blow does not last.
constexpr double kUnfolding = 0.01;
/// What earlier stretches have left goes at this rate [s], and to no stretch more than some times its even
/// share: errors of lively motion are the least sure.
constexpr double kSpending = 0.3, kMostShare = 3.0;
/// What a net errs while it is held bent grows when it is let go: errors in its stiff patterns, which are
/// small in length but not in energy, become such of soft ones. In tubes they grew up to twentyfold, and 12
/// of 200 runs of 40 tubes ended up to three times above the tolerance; with this share of it, none.
constexpr double kShareBeforeRelease = 0.25;
constexpr double kForGood = 10.0; ///< lifetime of an error that is spent for good [s]
/// What follows the first motion, which dampers brake the most, lives longer than that tells.
constexpr double kSlowerThanFirst = 4.0;

/// Over `count` nodes, of which those that were not summed have the value 0.
double rms(double sum, std::size_t count) noexcept
{
  return std::sqrt(sum / static_cast<double>(std::max<std::size_t>(count, 1)));
}

} // namespace

double fadingTime(const ErrorScale& scale) noexcept
{
  return scale.recentHeat > 0.0 ? 16.0 * scale.recentKinetic / scale.recentHeat
                                : std::numeric_limits<double>::infinity();
}

void ErrorGauge::begin(const NodeArray& x, double extent, double duration)
{
  m_rest = x;
  m_count = x.size();
  m_squareElsewhere = 0.0;
  m_extent = extent;
  m_duration = duration;
  m_guessedLifetime = std::numeric_limits<double>::infinity();
  m_scale = ErrorScale{};
}

void ErrorGauge::setPart(NodeArray& rest, std::size_t wholeCount, double squareElsewhere) noexcept
{
  m_rest.swap(rest);
  m_count = wholeCount;
  m_squareElsewhere = squareElsewhere;
}

double ErrorGauge::displacementOf(const NodeArray& x) const noexcept
{
  return rms(sumOfSquares(x, m_rest) + m_squareElsewhere, m_count);
}

double ErrorGauge::speedOf(const NodeArray& v) const noexcept
{
  return rms(sumOfSquares(v), m_count);
}

double ErrorGauge::shareOfWhole(std::size_t nodes) const noexcept
{
  return std::sqrt(static_cast<double>(m_count) / std::max(static_cast<double>(nodes), 1.0));
}

ErrorScale ErrorGauge::scaleAfter(const System& system, const MotionState& start, const MotionState& end,
                                  double error, double power) const noexcept
{
  const double length = end.time - start.time, fade = std::exp(-length / kMemory);
  ErrorScale next = m_scale;
  next.calm += length;
  next.displacement = displacementOf(end.x);
  const double alive = std::pow(m_scale.spent, 1.0 / power) * std::exp(-length / horizon(start.time));
  next.spent = std::min(std::pow(alive + std::pow(error, 1.0 / power), power),
                        std::max(next.displacement, floor())); // no error is larger than that for long
  next.squareOverTime += next.displacement * next.displacement * length;
  next.speed = speedOf(end.v);
  next.topSpeed = std::max(next.topSpeed, next.speed);
  next.recentHeat = fade * next.recentHeat + std::max(end.heat - start.heat, 0.0);
  next.recentKinetic = fade * next.recentKinetic + system.kineticEnergy(end.v) * length;
  next.recentPath = fade * next.recentPath + next.speed * next.speed * length;
  return next;
}

void ErrorGauge::guessLifetime(const System& system, const MotionState& start,
                               const MotionState& end) noexcept
{
  if (m_scale.recentPath > 0.0) return;
  m_guessedLifetime = kSlowerThanFirst * fadingTime(scaleAfter(system, start, end, 0.0, 1.0));
}

/// Error that the motion before `state` or after it may have [m].
double ErrorGauge::allowance(double tolerance, const MotionState& state) const noexcept
{
  double scale = std::max(m_scale.displacement, displacementOf(state.x));
  if (state.time > 0.0) scale = std::max(scale, std::sqrt(m_scale.squareOverTime / state.time));
  // In the first moments the displacement is not yet what the motion will make of it.
  if (state.time < kUnfolding)
    scale = std::max(scale, std::max(m_scale.speed, speedOf(state.v)) * kUnfolding);
  const double share = m_release < knownEnd(state.time) ? kShareBeforeRelease : 1.0;
  return share * kSafety * tolerance * std::max(scale, floor());
}

double ErrorGauge::unspent(double tolerance, const MotionState& state) const noexcept
{
  return std::max(allowance(tolerance, state) - m_scale.spent, 0.0);
}

double ErrorGauge::budget(double tolerance, const MotionState& state, double length,
                          double power) const noexcept
{
  const double all = allowance(tolerance, state);
  const double even = all * std::min(1.0, std::pow(length / horizon(state.time), power));
  if (lifetime() > kForGood) return even;
  const double left = std::max(std::pow(all, 1.0 / power) - std::pow(m_scale.spent, 1.0 / power), 0.0);
  const double lively = std::pow(left * std::min(1.0, length / kSpending), power);
  return std::clamp(lively, even, std::min(all, kMostShare * even));
}

/// A random walk has 1/2, and an error that fades has less. But slow modes err as well, unseen beside the
/// fast ones: with 1/2 the error of a run was seen up to four times above the tolerance, with 0.7 at it.
double ErrorGauge::errorPower(double early, double late, double share) noexcept
{
  constexpr double kLeastPower = 0.85;
  if (!(early > 0.0) || !(late > 0.0)) return 1.0;
  return std::clamp(std::log(late / early) / -std::log(share), kLeastPower, 1.0);
}

double ErrorGauge::distance(const NodeArray& otherX, const MotionState& state) const noexcept
{
  return rms(sumOfSquares(otherX, state.x), m_count);
}

/// Where the velocities part along the displacement, which slow motion has made, the error is one of slow
/// motion: it shows in the positions only after a part of the motion's own time (displacement over speed),
/// while fast waves hide it now. Modes are orthogonal under the masses, so the projection leaves the waves
/// out.
double ErrorGauge::slowDistance(const System& system, const NodeArray& otherV,
                                const MotionState& state) const noexcept
{
  constexpr double kSlowest = 0.08; ///< [s]
  if (!(m_scale.recentPath > 0.0)) return 0.0;
  const double time = std::min(m_scale.displacement * std::sqrt(kMemory / m_scale.recentPath), kSlowest);
  if (otherV.size() < kFewNodes) return time * rms(sumOfSquares(otherV, state.v), m_count);
  double along = 0.0, all = 0.0;
  for (std::size_t i = 0; i < otherV.size(); ++i) {
    const Lanes displacement = state.x[i] - m_rest[i];
    along += system.mass()[i] * dot(otherV[i] - state.v[i], displacement);
    all += system.mass()[i] * dot(displacement, displacement);
  }
  if (!(all > 0.0)) return 0.0;
  return time * std::abs(along) / all * rms(sumOfSquares(state.x, m_rest), m_count);
}

/// How long an error lives [s]; infinity without damping. It fades as the motion itself does: what oscillates
/// in its fadingTime(), what creeps in the time that it takes to its goal, displacement over speed. Both are
/// averaged over the last fifth of a second.
double ErrorGauge::lifetime() const noexcept
{
  if (!(m_scale.recentPath > 0.0)) return m_guessedLifetime;
  const double creeping = 2.0 * m_scale.displacement * std::sqrt(kMemory / m_scale.recentPath);
  return std::max(fadingTime(m_scale), creeping);
}

/// The end of the motion as seen at `time` before it [s]; infinity if nobody knows it.
double ErrorGauge::knownEnd(double time) const noexcept
{
  return time < m_duration ? m_duration : std::numeric_limits<double>::infinity();
}

/// Time over which errors add up [s]: without damping from the start on, and not beyond a known end.
double ErrorGauge::horizon(double time) const noexcept
{
  const double longest = std::clamp(knownEnd(time), kShortestHorizon, std::max(kErrorHorizon, time));
  return std::clamp(lifetime(), kShortestHorizon, longest);
}

} // namespace esm
