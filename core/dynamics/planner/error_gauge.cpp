// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/planner/error_gauge.h"

#include "core/dynamics/system/frame.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace esm {
namespace {

/// An error that is there, and how it fades: S = (spent + rate t) exp(-t/life).
struct LivingError {
  double spent = 0.0; ///< [m]
  double life = 0.0;  ///< [s], may be infinite

  /// The rate [m/s] with which S stays below `most` [m] for the time `left` [s].
  double rateForPeak(double most, double left) const noexcept
  {
    const double share = spent / most;
    if (share < 1.0) { // S is largest where t = life - spent/rate; within 2 % of the solution
      const double rate = (1.0 + (std::numbers::e - 1.0) * std::sqrt(1.0 - share)) * most / life;
      if (life - spent / rate < left) return rate;
    } else if (life < left) {
      return most / (share * share * life);
    }
    return (most * std::exp(left / life) - spent) / left;
  }

  /// The rate [m/s] with which the integral of S^2 over the time `left` [s] is `room` [m^2 s].
  double rateForMean(double room, double left) const noexcept
  {
    const double a = 2.0 / life, x = a * left, fade = std::exp(-x);
    double i0 = left, i1 = left * left / 2.0, i2 = left * left * left / 3.0; // of t^n exp(-a t)
    if (x > 1e-3) {
      i0 = (1.0 - fade) / a;
      i1 = (1.0 - fade * (1.0 + x)) / (a * a);
      i2 = (2.0 - fade * (2.0 + x * (2.0 + x))) / (a * a * a);
    }
    room -= spent * spent * i0;
    return room > 0.0 ? room / (spent * i1 + std::sqrt(spent * spent * i1 * i1 + i2 * room)) : 0.0;
  }
};

/// How far a net is beyond those in which the errors of a few waves count most: 0 up to there.
double doublingsOfMany(std::size_t nodes, const Policy::Errors& policy) noexcept
{
  return std::log2(std::max(static_cast<double>(nodes) / policy.manyNodes, 1.0));
}

/// Over `count` nodes, of which those that were not summed have the value 0.
double rms(double sum, std::size_t count) noexcept
{
  return std::sqrt(sum / static_cast<double>(std::max<std::size_t>(count, 1)));
}

} // namespace

double fadingTime(const ErrorScale& scale) noexcept
{
  constexpr double kNever = std::numeric_limits<double>::infinity();
  const auto time = [](double kinetic, double heat) { return heat > 0.0 ? 8.0 * kinetic / heat : kNever; };
  return std::max(time(scale.recentKinetic, scale.recentHeat), time(scale.latestKinetic, scale.latestHeat));
}

double dampersPower(const ErrorScale& scale, const Policy::Errors& policy) noexcept
{
  return std::min(scale.recentHeat / policy.memory, scale.latestHeat / policy.shortMemory);
}

double creepingTime(const ErrorScale& scale, const Policy::Errors& policy) noexcept
{
  if (!(scale.recentPath > 0.0)) return std::numeric_limits<double>::infinity();
  return 2.0 * scale.displacement * std::sqrt(policy.memory / scale.recentPath);
}

void ErrorGauge::begin(const NodeArray& x, double extent, double duration, bool isDriven)
{
  m_rest = x;
  m_count = x.size();
  m_squareElsewhere = 0.0;
  m_extent = extent;
  m_duration = duration;
  m_isDriven = isDriven;
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

/// Steps at their limit err in the fastest waves, which are the smaller a part of the motion the larger the
/// net. By the guess for small nets an organ of 100,000 nodes began with dearer methods.
double ErrorGauge::typicalShare() const noexcept
{
  return std::exp2(-doublingsOfMany(m_rest.size(), m_policy) / m_policy.halving);
}

double ErrorGauge::shareOfWhole(std::size_t nodes) const noexcept
{
  return std::sqrt(static_cast<double>(m_count) / std::max(static_cast<double>(nodes), 1.0));
}

double ErrorGauge::rmsOfWhole(double root) const noexcept
{
  return rms(root * root, m_count);
}

ErrorScale ErrorGauge::scaleAfter(const System& system, const MotionState& start, const MotionState& end,
                                  double error, double beyond) const noexcept
{
  const double length = end.time - start.time, heat = std::max(end.heat - start.heat, 0.0);
  const double kinetic = system.kineticEnergy(end.v) * length;
  const double fade = std::exp(-length / m_policy.memory),
               quickFade = std::exp(-length / m_policy.shortMemory);
  ErrorScale next = m_scale;
  next.calm += length;
  next.displacement = displacementOf(end.x);
  const double most = std::max(next.displacement, floor()); // no error is larger than that for long
  next.spent = std::min(m_scale.spent * std::exp(-m_policy.faster * length / lifetime()) + error, most);
  next.beyond = std::min(m_scale.beyond * std::exp(-length / m_policy.shortestLife) + beyond, most);
  next.spentSquare += next.spent * next.spent * length;
  next.squareOverTime += next.displacement * next.displacement * length;
  next.speed = speedOf(end.v);
  next.topSpeed = std::max(next.topSpeed, next.speed);
  next.latestHeat = quickFade * next.latestHeat + heat;
  next.latestKinetic = quickFade * next.latestKinetic + kinetic;
  next.recentHeat = fade * next.recentHeat + heat;
  next.recentKinetic = fade * next.recentKinetic + kinetic;
  next.recentPath = fade * next.recentPath + next.speed * next.speed * length;
  return next;
}

void ErrorGauge::guessLifetime(const System& system, const MotionState& start,
                               const MotionState& end) noexcept
{
  if (m_scale.recentPath > 0.0) return;
  m_guessedLifetime = m_policy.slowerThanFirst * fadingTime(scaleAfter(system, start, end, 0.0));
}

/// Error that the motion before `state` or after it may have [m].
double ErrorGauge::allowance(double tolerance, const MotionState& state) const noexcept
{
  double scale = presentScale(state);
  if (state.time > 0.0) scale = std::max(scale, std::sqrt(m_scale.squareOverTime / state.time));
  return m_ledger.steps(awaitsRelease(state.time)) * tolerance * std::max(scale, floor());
}

/// Displacement about `state` [m]. In the first moments it is not yet what the motion will make of it.
double ErrorGauge::presentScale(const MotionState& state) const noexcept
{
  const double scale = std::max(m_scale.displacement, displacementOf(state.x));
  if (state.time >= m_policy.unfolding) return scale;
  return std::max(scale, std::max(m_scale.speed, speedOf(state.v)) * m_policy.unfolding);
}

/// What will have been the mean square of displacement at the end, over the square that allowance() reckons
/// with: less than 1 only where all forces are gone within the first frame, the end is known and the motion fades. Of struck organs
/// it had been a fifth in length, so that they erred up to nine tolerances.
double ErrorGauge::meanShare(const MotionState& state, double left) const noexcept
{
  const double time = state.time;
  if (!(m_quiet <= kFrame) || !std::isfinite(expectedEnd(time))) return 1.0;
  const double now = std::max(presentScale(state), floor());
  const double driven = std::clamp(m_quiet - time, 0.0, left), life = lifetime();
  const double fading =
    std::isfinite(life) ? 0.5 * life * -std::expm1(-2.0 * (left - driven) / life) : left - driven;
  const double coming = now * now * (driven + fading);
  const double mean = (m_scale.squareOverTime + coming) / (time + left);
  const double reckoned = std::max(now, time > 0.0 ? std::sqrt(m_scale.squareOverTime / time) : 0.0);
  return std::min(m_policy.afterBlow * m_policy.afterBlow * mean / (reckoned * reckoned), 1.0);
}

double ErrorGauge::unspent(double tolerance, const MotionState& state) const noexcept
{
  return std::max(allowance(tolerance, state) - m_scale.spent, 0.0);
}

/// Sheets of a thousand nodes that wind blew at had spent what they might by the time it fell, and the mean
/// displacement with it: at 1e-6 six of seven ended above, up to 1.32 times, and one at 1e-4; with this share
/// of the budget none of ten above 0.85. At coarser tolerances steps end at their limit before errors do.
double ErrorGauge::lastingShare(double tolerance, double time) const noexcept
{
  if (awaitsRelease(time)) return 1.0; // allowance() sees to that
  const double few = std::max(1.0 - doublingsOfMany(m_rest.size(), m_policy), 0.0);
  return std::min(1.0, std::pow(tolerance / m_policy.tight, m_policy.tightPower * few));
}

double ErrorGauge::budget(double tolerance, const MotionState& state, double length) const noexcept
{
  const double all = allowance(tolerance, state);
  const bool mayPeak = m_isDriven && std::isfinite(expectedEnd(state.time));
  const double left = std::max(timeLeft(state.time), length);
  const LivingError error{m_scale.spent, lifetime()};
  const double share = meanShare(state, left);
  const double whole = share * all * all * (state.time + left);
  const double ofMean = error.rateForMean(whole - m_scale.spentSquare, left);
  const double most = mayPeak ? peak(left, m_scale.spentSquare / whole) : 1.0;
  const double rate = std::min(error.rateForPeak(most * all, left), ofMean);
  // An even share goes on when all is spent: smaller steps would cost without end and gain little. Two of
  // them where errors spread over many waves, which do not add up in line; if they did, and stayed, their
  // mean would still be below the tolerance.
  const double shares =
    m_isDriven ? std::min(1.0 + doublingsOfMany(m_rest.size(), m_policy), m_policy.mostShares) : 1.0;
  const double least = (ofMean > 0.0 ? 1.0 : m_policy.beyond) * std::sqrt(share) * all /
                       std::min(error.life, (state.time + left) / shares);
  return std::min(all, std::max(rate, least) * length);
}

/// A random walk has the power 1/2, and an error that fades has less. But slow modes err as well, unseen
/// beside the fast ones: with 1/2 the error of a small net was seen up to four times above the tolerance. The
/// more nodes move, the more waves there are for errors to spread over, and these are what fades: sheets of
/// 3,000 to 10,000 nodes and organs of 20,000 and 100,000 kept their tolerances with the least powers below,
/// sheets of 1,000 and tubes of 200 to 400 did not. But that is for many stretches of errors alike: the first
/// ones after an event err the most, and there are few of them. Counted as if they were many, struck organs
/// of 5,000 and 10,000 nodes ended at 1.3 and 2.2 times a tolerance of 1e-3.
double ErrorGauge::growing(double time, double length, double early, double late, double share) const noexcept
{
  if (!(early > 0.0) || !(late > 0.0)) return 1.0;
  // Nothing fades yet where all begins to move at once; sheets that began with a speed ended 1.1 times above.
  if (!m_isDriven && !(time > 0.0)) return 1.0;
  const double many = m_scale.calm <= m_policy.fresh ? 0.0 : doublingsOfMany(m_rest.size(), m_policy);
  const double least = std::max(m_policy.leastPower - m_policy.lessPerDoubling * many, m_policy.leastOfAll);
  const double power = std::clamp(std::log(late / early) / -std::log(share), least, 1.0);
  return std::pow(std::max(std::min(lifetime(), timeLeft(time)) / length, 1.0), power - 1.0);
}

double ErrorGauge::distance(const NodeArray& otherX, const MotionState& state) const noexcept
{
  return rms(sumOfSquares(otherX, state.x), m_count);
}

void ErrorGauge::prepareSwing(const System& system, const MotionState& state)
{
  m_stiffness.prepare(system, state.x, 1.0 / (m_policy.slowest * m_policy.slowest));
  m_momentum.resize(state.x.size());
  m_displacement.resize(state.x.size());
  for (std::size_t i = 0; i < state.x.size(); ++i) m_displacement[i] = state.x[i] - m_rest[i];
}

/// What one mode errs is now in its place and now in its velocity: d^2 + (w/omega)^2 stays. Over all modes
/// the latter is w.M K^-1 M w, weighted by mass as w.M w is; conjugate gradients bound it from below, with
/// the displacement, which slow motion has made, as their first direction. What they do not reach in a few
/// steps is slow motion that waves hide. So what of w lies along the displacement counts with that motion's
/// own time (displacement over speed), in the mean over its swing. (Modes are orthogonal under the masses, so
/// the projection leaves out other waves than the displacement holds.)
double ErrorGauge::swing(const System& system, double distance, const NodeArray& otherV,
                         const MotionState& state)
{
  constexpr int kIterations = 3;
  double energy = 0.0, along = 0.0, all = 0.0; // the first one twice
  for (std::size_t i = 0; i < otherV.size(); ++i) {
    const Lanes apart = otherV[i] - state.v[i], displacement = m_displacement[i];
    m_momentum[i] = apart * system.mass()[i];
    energy += dot(m_momentum[i], apart);
    along += dot(m_momentum[i], displacement);
    all += system.mass()[i] * dot(displacement, displacement);
  }
  if (!(energy > 0.0)) return distance;
  const double bound = m_stiffness.below(system, m_momentum, std::numeric_limits<double>::infinity(),
                                         kIterations, &m_displacement);
  const double speed = rms(sumOfSquares(otherV, state.v), m_count);
  const double squaredTime = bound / energy; // not a number where tangents are infinite
  const double time =
    squaredTime < m_policy.slowest * m_policy.slowest ? std::sqrt(squaredTime) : m_policy.slowest;
  const double amplitude = std::hypot(distance, time * speed);
  if (!(m_scale.recentPath > 0.0 && all > 0.0)) return amplitude;
  const bool isSmall = otherV.size() < kFewNodes; // all its motion is slow
  const double slow = isSmall ? speed : std::abs(along) / all * rms(sumOfSquares(m_displacement), m_count);
  const double ofMotion = std::min(0.5 * creepingTime(m_scale, m_policy), m_policy.slowest);
  return std::max(amplitude, slow * ofMotion / std::numbers::sqrt2);
}

double ErrorGauge::alongMotion(const System& system, const NodeArray& otherX, const NodeArray& otherV,
                               const MotionState& state) const noexcept
{
  double xx = 0.0, ww = 0.0, vv = 0.0, uu = 0.0, xv = 0.0, xu = 0.0, wu = 0.0;
  for (std::size_t i = 0; i < otherX.size(); ++i) {
    const Lanes x = otherX[i] - state.x[i], w = otherV[i] - state.v[i];
    const Lanes u = m_displacement[i], v = state.v[i];
    const Lanes mx = x * system.mass()[i], mu = u * system.mass()[i];
    xx += dot(mx, x);
    ww += system.mass()[i] * dot(w, w);
    vv += system.mass()[i] * dot(v, v);
    uu += dot(mu, u);
    xv += dot(mx, v);
    xu += dot(mx, u);
    wu += dot(w, mu);
  }
  const auto cosine = [](double both, double one, double other) {
    return one > 0.0 && other > 0.0 ? std::abs(both) / std::sqrt(one * other) : 0.0;
  };
  return std::max({cosine(xv, xx, vv), cosine(xu, xx, uu), cosine(wu, ww, uu)});
}

/// How long a motion like the present one takes to fade [s]; infinity without damping. What oscillates does
/// so in its fadingTime(), what creeps in the time that it takes to its goal, displacement over speed.
double ErrorGauge::fading() const noexcept
{
  if (!(m_scale.recentPath > 0.0)) return m_guessedLifetime;
  return std::max(fadingTime(m_scale), creepingTime(m_scale, m_policy));
}

/// How long an error lives [s]: it fades as the motion itself does.
double ErrorGauge::lifetime() const noexcept
{
  return std::max(fading(), m_policy.shortestLife);
}

/// Of what may be spent, for some of the time that is left [s].
/// @param meanSpent  of the mean square up to the end
double ErrorGauge::peak(double left, double meanSpent) const noexcept
{
  const double most =
    std::clamp(m_policy.peakOfMean * std::sqrt(2.0 * left / fading()), m_policy.leastPeak, m_policy.mostPeak);
  return m_policy.leastPeak +
         (most - m_policy.leastPeak) * std::max(1.0 - meanSpent / m_policy.spentEarly, 0.0);
}

/// Time over which errors may still add up, seen at `time` [s].
double ErrorGauge::timeLeft(double time) const noexcept
{
  const double end = expectedEnd(time);
  return std::isfinite(end) ? end - time : std::max(m_policy.horizon, time);
}

/// What budgets reckon with. At the very start of a motion whose end nobody knows it is the start itself: the
/// first stretch may spend all once, which counts from then on. With a smaller share a struck organ began in
/// small parts, and what these erred nobody saw: with checks of a third of a frame 2.2 times the tolerance of
/// 1e-2, three times that of 1e-3.
double ErrorGauge::expectedEnd(double time) const noexcept
{
  return time > 0.0 ? knownEnd(time) : m_duration;
}

double ErrorGauge::knownEnd(double time) const noexcept
{
  return time < m_duration * (1.0 + 1e-9) ? m_duration : std::numeric_limits<double>::infinity();
}

} // namespace esm
