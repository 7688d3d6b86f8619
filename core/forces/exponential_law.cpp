// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/forces/spring_pass.h"

#include <algorithm>

namespace esm {
namespace {

/// Beyond this exponent, either way, exp() goes on along its tangent: e^100 is far past any tissue, and the
/// force stays a number that the step control can reject.
constexpr double kLargestExponent = 100.0;

/// exp(s) = power (1 + r + beyond)
template <class Values>
struct ExpParts {
  Values power, r, beyond;
};

/// For |s| <= kLargestExponent, with plain arithmetic only: the C library's exp() has other last bits on CPUs
/// with FMA. s = n ln 2 + r with |r| <= ln 2 / 2, power = 2^n; the Taylor series of exp(r) - 1 to r^13 leaves
/// 4e-18.
template <class Values>
ESM_INLINE void expParts(const Values& s, ExpParts<Values>& parts) noexcept
{
  constexpr double kRound = 0x1.8p52; // adding it rounds to an integer, which then stands in the low bits
  constexpr double kLn2High = 0x1.62e42fefa3800p-1;
  constexpr double kLn2Low = 0x1.ef35793c76730p-45;
  const Values shifted = s * 0x1.71547652b82fep+0 + kRound;
  const Values n = shifted - kRound;
  const Values r = (s - n * kLn2High) - n * kLn2Low;
  // (exp(r) - 1 - r)/r^2 in pairs of terms (Estrin): a chain of five operations instead of a dozen, so that
  // the springs of several groups overlap.
  const Values r2 = r * r, r4 = r2 * r2, r8 = r4 * r4;
  const Values low = (r * (1.0 / 6.0) + 0.5) + r2 * (r * (1.0 / 120.0) + (1.0 / 24.0));
  const Values middle = (r * (1.0 / 5040.0) + (1.0 / 720.0)) + r2 * (r * (1.0 / 362880.0) + (1.0 / 40320.0));
  const Values high =
    (r * (1.0 / 39916800.0) + (1.0 / 3628800.0)) + r2 * (r * (1.0 / 6227020800.0) + (1.0 / 479001600.0));
  parts.r = r;
  parts.beyond = r2 * (low + r4 * middle + r8 * high);
  BitsOf<Values> bits;
  __builtin_memcpy(&bits, &shifted, sizeof(bits));
  bits = (bits + 1023) << 52; // the high bits of kRound leave on the left
  __builtin_memcpy(&parts.power, &bits, sizeof(bits));
}

/// exp(s) - 1 = 2^n (exp(r) - 1) + (2^n - 1) loses nothing near 0.
template <class Values>
ESM_INLINE void minusOne(const ExpParts<Values>& parts, Values& result) noexcept
{
  result = parts.power * (parts.beyond + parts.r) + (parts.power - 1.0);
}

template <class Values>
ESM_INLINE void expMinusOne(const Values& s, Values& result) noexcept
{
  ExpParts<Values> parts;
  expParts(s, parts);
  minusOne(parts, result);
}

/// s, or the limit that it is beyond.
template <class Values>
ESM_INLINE void keepInside(const Values& s, Values& inside) noexcept
{
  const Values most = Values{} + kLargestExponent;
  const Values belowMost = s > most ? most : s;
  inside = belowMost < -most ? -most : belowMost;
}

/// f = k L/b (exp(b e/L) - 1)
struct Exponential {
  static constexpr SpringLaw kLaw = SpringLaw::Exponential;
  template <class Group, class Values>
  ESM_INLINE static void tension(const Group& group, const Values& e, Values& f) noexcept
  {
    Values factor, rate, inside, growth;
    group.lawRow(0, factor);
    group.lawRow(1, rate);
    const Values s = rate * e;
    keepInside(s, inside);
    expMinusOne(inside, growth);
    growth += (growth + 1.0) * (s - inside);
    f = factor * growth;
  }
  /// k (L/b)^2 (exp(s) - 1 - s): the difference is a power series near 0, where it would cancel.
  template <class Group, class Values>
  ESM_INLINE static void energy(const Group& group, const Values& e, Values& result) noexcept
  {
    Values factor, rate, inside, growth;
    group.lawRow(0, factor);
    group.lawRow(1, rate);
    const Values s = rate * e;
    keepInside(s, inside);
    ExpParts<Values> parts;
    expParts(inside, parts);
    minusOne(parts, growth);
    const Values outside = s - inside;
    const Values line = parts.power == 1.0 ? parts.beyond : growth - inside;
    result = factor / rate * (line + growth * outside + 0.5 * (growth + 1.0) * outside * outside);
  }
};

ESM_WIDE_CLONES(double exponentialPass(const SpringBatch& batch, const Lanes* x, const Lanes* v, Lanes* force,
                                       Lanes* damper) noexcept,
                return detail::springPass<Exponential, detail::EndsOf<kLanes>>(batch, x, v, force, damper))

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

class ExponentialLaw final : public SpringLawKernel {
public:
  double addForces(const SpringBatch& batch, const Lanes* x, const Lanes* v, Lanes* force,
                   Lanes* damper) const noexcept override
  {
    return exponentialPass(batch, x, v, force, damper);
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

  SpringResponse respond(const SpringBatch& batch, std::size_t i, double e) const noexcept override
  {
    const double k = batch.stiffness[i], b = batch.parameter[i], scale = batch.restLength[i] / b;
    const double s = e / scale;
    const double inside = std::min(std::max(s, -kLargestExponent), kLargestExponent);
    const double outside = s - inside; // along the tangent
    const double growth = expMinusOne(inside), slope = growth + 1.0;
    return {k * scale * (growth + slope * outside), k * slope};
  }
};

} // namespace

const SpringLawKernel& exponentialLaw() noexcept
{
  static const ExponentialLaw law;
  return law;
}

} // namespace esm
