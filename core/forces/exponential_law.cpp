// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/forces/spring_pass.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace esm {
namespace {

/// Beyond this exponent, either way, exp() goes on along its tangent: e^100 is far past any tissue, and the
/// force stays a number that the step control can reject.
constexpr double kLargestExponent = 100.0;

/// Up to here exp(s) needs no power of two: half of ln 2, less a little for rounding.
constexpr double kSmallExponent = 0.3465;

/// exp(s) = power (1 + r + beyond)
struct ExpParts {
  Lanes power, r, beyond;
};

/// exp(r) - 1 - r for |r| <= ln 2 / 2 as r^2 times a polynomial, which interpolates at Chebyshev's points:
/// within 4e-17 of exp(r) - 1, relative to it, with two terms less than Taylor's series. In pairs of terms
/// (Estrin): a chain of five operations instead of a dozen, so that the springs of several groups overlap.
ESM_INLINE void beyondLine(const Lanes& r, Lanes& result) noexcept
{
  const Lanes r2 = r * r, r4 = r2 * r2, r8 = r4 * r4;
  const Lanes low = (r * 0x1.5555555555556p-3 + 0x1.0000000000001p-1) +
                    r2 * (r * 0x1.11111111109a6p-7 + 0x1.5555555553d37p-5);
  const Lanes middle = (r * 0x1.a01a01a7cebcdp-13 + 0x1.6c16c1789d1d7p-10) +
                       r2 * (r * 0x1.71de0d85293b8p-19 + 0x1.a019b8ca26fcfp-16);
  const Lanes high = r * 0x1.af390ba7e6f47p-26 + 0x1.2891d4ffbb0f9p-22;
  result = r2 * (low + r4 * middle + r8 * high);
}

/// For |s| <= kLargestExponent, with plain arithmetic only: the C library's exp() has other last bits on CPUs
/// with FMA. s = n ln 2 + r with |r| <= ln 2 / 2, power = 2^n.
ESM_INLINE void expParts(const Lanes& s, ExpParts& parts) noexcept
{
  constexpr double kRound = 0x1.8p52; // adding it rounds to an integer, which then stands in the low bits
  constexpr double kLn2High = 0x1.62e42fefa3800p-1;
  constexpr double kLn2Low = 0x1.ef35793c76730p-45;
  const Lanes shifted = s * 0x1.71547652b82fep+0 + kRound;
  const Lanes n = shifted - kRound;
  parts.r = (s - n * kLn2High) - n * kLn2Low;
  beyondLine(parts.r, parts.beyond);
  LaneBits bits;
  __builtin_memcpy(&bits, &shifted, sizeof(bits));
  bits = (bits + 1023) << 52; // the high bits of kRound leave on the left
  __builtin_memcpy(&parts.power, &bits, sizeof(bits));
}

/// exp(s) - 1 = 2^n (exp(r) - 1) + (2^n - 1) loses nothing near 0.
ESM_INLINE void minusOne(const ExpParts& parts, Lanes& result) noexcept
{
  result = parts.power * (parts.beyond + parts.r) + (parts.power - 1.0);
}

ESM_INLINE void expMinusOne(const Lanes& s, Lanes& result) noexcept
{
  ExpParts parts;
  expParts(s, parts);
  minusOne(parts, result);
}

/// s, or the limit that it is beyond.
ESM_INLINE void keepInside(const Lanes& s, Lanes& inside) noexcept
{
  const Lanes most = Lanes{} + kLargestExponent;
  const Lanes belowMost = s > most ? most : s;
  inside = belowMost < -most ? -most : belowMost;
}

/// exp(s) - 1, along the tangent beyond kLargestExponent.
ESM_INLINE void growthOf(const Lanes& s, Lanes& growth) noexcept
{
  Lanes inside;
  keepInside(s, inside);
  expMinusOne(inside, growth);
  growth += (growth + 1.0) * (s - inside);
}

/// The same, not inlined: in the middle of a pass it takes registers from the springs that can do without, a
/// tenth of their time.
ESM_CPU_CLONES void growthsOf(std::size_t groups, const Lanes* s, Lanes* growth) noexcept
{
  for (std::size_t g = 0; g < groups; ++g) growthOf(s[g], growth[g]);
}

/// f = k L/b (exp(b e/L) - 1)
struct Exponential {
  static constexpr SpringLaw kLaw = SpringLaw::Exponential;
  template <class Group>
  ESM_INLINE static void tension(const Group& group, const Lanes& e, Lanes& f) noexcept
  {
    Lanes factor, rate, growth;
    group.lawRow(0, factor);
    group.lawRow(1, rate);
    growthOf(rate * e, growth);
    f = factor * growth;
  }
  template <class Group>
  ESM_INLINE static void tangent(const Group& group, const Lanes& e, Lanes& f, Lanes& slope) noexcept
  {
    Lanes factor, rate, inside, growth;
    group.lawRow(0, factor);
    group.lawRow(1, rate);
    const Lanes s = rate * e;
    keepInside(s, inside);
    expMinusOne(inside, growth);
    const Lanes steepness = growth + 1.0;
    f = factor * (growth + steepness * (s - inside));
    slope = factor * rate * steepness;
  }
  /// The same bits. Springs of tissue that strains by a tenth need no more than beyondLine(), half of the
  /// work, and whether all of several groups are such is asked once.
  static constexpr bool kTakesGroupsTogether = true;
  template <std::size_t groups, class Springs>
  ESM_INLINE static void tensions(const Springs& springs, const detail::Stretch* stretch, Lanes* f) noexcept
  {
    Lanes s[groups];
    LaneBits large{};
    for (std::size_t g = 0; g < groups; ++g) {
      Lanes rate;
      springs(g).lawRow(1, rate);
      s[g] = rate * stretch[g].extension;
      large |= s[g] * s[g] > Lanes{} + kSmallExponent * kSmallExponent;
    }
    Lanes growth[groups], factor;
    if ((large[0] | large[1] | large[2] | large[3]) == 0) {
      for (std::size_t g = 0; g < groups; ++g) {
        beyondLine(s[g], growth[g]);
        springs(g).lawRow(0, factor);
        f[g] = factor * (growth[g] + s[g]);
      }
      return;
    }
    Lanes copy[groups]; // else s itself would be in memory, for small ones, too
    for (std::size_t g = 0; g < groups; ++g) copy[g] = s[g];
    growthsOf(groups, copy, growth);
    for (std::size_t g = 0; g < groups; ++g) {
      springs(g).lawRow(0, factor);
      f[g] = factor * growth[g];
    }
  }
  /// k (L/b)^2 (exp(s) - 1 - s): the difference is a power series near 0, where it would cancel.
  template <class Group>
  ESM_INLINE static void energy(const Group& group, const Lanes& e, Lanes& result) noexcept
  {
    Lanes factor, rate, inside, growth;
    group.lawRow(0, factor);
    group.lawRow(1, rate);
    const Lanes s = rate * e;
    keepInside(s, inside);
    ExpParts parts;
    expParts(inside, parts);
    minusOne(parts, growth);
    const Lanes outside = s - inside;
    const Lanes line = parts.power == 1.0 ? parts.beyond : growth - inside;
    result = factor / rate * (line + growth * outside + 0.5 * (growth + 1.0) * outside * outside);
  }
};

ESM_CPU_CLONES double exponentialPass(const SpringBatch& batch, const Lanes* x, const Lanes* v, Lanes* force,
                                      Lanes* damper, const Lateness& late) noexcept
{
  return detail::springPass<Exponential>(batch, x, v, force, {damper, late});
}

ESM_CPU_CLONES double exponentialEnergy(const SpringBatch& batch, const Lanes* x) noexcept
{
  return detail::energyPass<Exponential>(batch, x);
}

/// For one number, with the same bits as in the kernel.
double expMinusOne(double s) noexcept
{
  Lanes result;
  expMinusOne(Lanes{s, s, s, s}, result);
  return result[0];
}

ESM_CPU_CLONES double exponentialTensions(const SpringBatch& batch, const Lanes* x, const Lanes* v,
                                          double* tension) noexcept
{
  return detail::tensionPass<Exponential>(batch, x, v, tension);
}

ESM_CPU_CLONES void exponentialTangents(const SpringBatch& batch, const Lanes* x, const Lanes* v,
                                        const TangentShares& shares, Lanes* rows) noexcept
{
  detail::tangentPass<Exponential>(batch, x, v, shares, rows);
}

/// The slope of (exp(s) - 1)/s, with the tangent of exp() beyond kLargestExponent; a power series near 0, where
/// the closed form cancels.
double slopeOfGrowth(double s) noexcept
{
  if (std::abs(s) < 0.5) {
    double sum = 0.0, power = 1.0; // s^n / (n + 2)!
    for (int n = 0; n < 16; ++n) {
      power *= n == 0 ? 0.5 : s / (n + 2);
      sum += (n + 1) * power;
    }
    return sum;
  }
  const double inside = std::min(std::max(s, -kLargestExponent), kLargestExponent);
  const double growth = expMinusOne(inside), slope = growth + 1.0;
  return (s * slope - (growth + slope * (s - inside))) / (s * s);
}

class ExponentialLaw final : public SpringLawKernel {
public:
  double addForces(const SpringBatch& batch, const Lanes* x, const Lanes* v, Lanes* force, Lanes* damper,
                   const Lateness& late) const noexcept override
  {
    return exponentialPass(batch, x, v, force, damper, late);
  }

  double energy(const SpringBatch& batch, const Lanes* x) const noexcept override
  {
    return exponentialEnergy(batch, x);
  }

  double tensions(const SpringBatch& batch, const Lanes* x, const Lanes* v,
                  double* tension) const noexcept override
  {
    return exponentialTensions(batch, x, v, tension);
  }

  void tangents(const SpringBatch& batch, const Lanes* x, const Lanes* v, const TangentShares& shares,
                Lanes* rows) const noexcept override
  {
    exponentialTangents(batch, x, v, shares, rows);
  }

  SpringResponse respond(const SpringBatch& batch, std::size_t i, double e) const noexcept override
  {
    const double k = batch.stiffness[i], b = batch.parameter[i], scale = batch.restLength[i] / b;
    const double s = e / scale;
    const double inside = std::min(std::max(s, -kLargestExponent), kLargestExponent);
    const double outside = s - inside; // along the tangent
    const double growth = expMinusOne(inside), slope = growth + 1.0;
    return {k * scale * (growth + slope * outside), k * slope};
  }

  double parameterSlope(double stiffness, double restLength, double parameter,
                        double e) const noexcept override
  {
    return stiffness * e * e / restLength * slopeOfGrowth(parameter * e / restLength);
  }
};

} // namespace

const SpringLawKernel& exponentialLaw() noexcept
{
  static const ExponentialLaw law;
  return law;
}

} // namespace esm
