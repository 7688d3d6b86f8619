// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/forces/spring_law.h"

#include <type_traits>

namespace esm::detail {

/// Four springs' x, y, z back to four nodes' (x, y, z, 0).
ESM_INLINE void transposeBack(const Lanes& x, const Lanes& y, const Lanes& z, Lanes& r0, Lanes& r1, Lanes& r2,
                              Lanes& r3) noexcept
{
  const Lanes zero = {0, 0, 0, 0};
  const Lanes xyEven = __builtin_shufflevector(x, y, 0, 4, 2, 6); // x0 y0 x2 y2
  const Lanes xyOdd = __builtin_shufflevector(x, y, 1, 5, 3, 7);
  const Lanes zEven = __builtin_shufflevector(z, zero, 0, 4, 2, 6); // z0 0 z2 0
  const Lanes zOdd = __builtin_shufflevector(z, zero, 1, 5, 3, 7);
  r0 = __builtin_shufflevector(xyEven, zEven, 0, 1, 4, 5);
  r1 = __builtin_shufflevector(xyOdd, zOdd, 0, 1, 4, 5);
  r2 = __builtin_shufflevector(xyEven, zEven, 2, 3, 6, 7);
  r3 = __builtin_shufflevector(xyOdd, zOdd, 2, 3, 6, 7);
}

/// The same for eight, to what transpose() for eight takes.
ESM_INLINE void transposeBack(const WideLanes& x, const WideLanes& y, const WideLanes& z, WideLanes& r02,
                              WideLanes& r13, WideLanes& r46, WideLanes& r57) noexcept
{
  const WideLanes zero = {0, 0, 0, 0, 0, 0, 0, 0};
  const WideLanes xyEven = __builtin_shufflevector(x, y, 0, 8, 2, 10, 4, 12, 6, 14); // x0 y0 x2 y2 x4 ...
  const WideLanes xyOdd = __builtin_shufflevector(x, y, 1, 9, 3, 11, 5, 13, 7, 15);
  const WideLanes zEven = __builtin_shufflevector(z, zero, 0, 8, 2, 10, 4, 12, 6, 14); // z0 0 z2 0 z4 ...
  const WideLanes zOdd = __builtin_shufflevector(z, zero, 1, 9, 3, 11, 5, 13, 7, 15);
  r02 = __builtin_shufflevector(xyEven, zEven, 0, 1, 8, 9, 2, 3, 10, 11);
  r13 = __builtin_shufflevector(xyOdd, zOdd, 0, 1, 8, 9, 2, 3, 10, 11);
  r46 = __builtin_shufflevector(xyEven, zEven, 4, 5, 12, 13, 6, 7, 14, 15);
  r57 = __builtin_shufflevector(xyOdd, zOdd, 4, 5, 12, 13, 6, 7, 14, 15);
}

template <class Values>
ESM_INLINE void loadLanes(const double* from, Values& to) noexcept
{
  __builtin_memcpy(&to, from, sizeof(to));
}

/// The ends of springs i .. i+3 of a batch, and what is done in lanes with them.
struct FourEnds {
  using Values = Lanes;
  static constexpr std::size_t kCount = 4;
  Index a0, a1, a2, a3, b0, b1, b2, b3;

  ESM_INLINE FourEnds(const SpringBatch& batch, std::size_t i) noexcept
    : a0(batch.a[i]),
      a1(batch.a[i + 1]),
      a2(batch.a[i + 2]),
      a3(batch.a[i + 3]),
      b0(batch.b[i]),
      b1(batch.b[i + 1]),
      b2(batch.b[i + 2]),
      b3(batch.b[i + 3])
  {}
  /// values[b] - values[a] of each.
  ESM_INLINE void difference(const Lanes* values, Lanes& d0, Lanes& d1, Lanes& d2, Lanes& d3) const noexcept
  {
    d0 = values[b0] - values[a0];
    d1 = values[b1] - values[a1];
    d2 = values[b2] - values[a2];
    d3 = values[b3] - values[a3];
  }
  /// A force on each end a, the opposite one on b.
  ESM_INLINE void pull(Lanes* force, const Lanes& f0, const Lanes& f1, const Lanes& f2,
                       const Lanes& f3) const noexcept
  {
    force[a0] += f0;
    force[b0] -= f0;
    force[a1] += f1;
    force[b1] -= f1;
    force[a2] += f2;
    force[b2] -= f2;
    force[a3] += f3;
    force[b3] -= f3;
  }
  /// The same with forces along the differences.
  ESM_INLINE void pullAlong(Lanes* force, const Lanes& d0, const Lanes& d1, const Lanes& d2, const Lanes& d3,
                            const Lanes& scale) const noexcept
  {
    pull(force, d0 * scale[0], d1 * scale[1], d2 * scale[2], d3 * scale[3]);
  }
  ESM_INLINE static void addTo(Lanes& sum, const Lanes& values) noexcept { sum += values; }
  /// The x, y, z of a DamperArray.
  ESM_INLINE static void store(Lanes* damper, const Lanes& x, const Lanes& y, const Lanes& z) noexcept
  {
    damper[0] = x;
    damper[1] = y;
    damper[2] = z;
  }
  ESM_INLINE static void load(const Lanes* damper, Lanes& x, Lanes& y, Lanes& z) noexcept
  {
    x = damper[0];
    y = damper[1];
    z = damper[2];
  }
};

/// The same for springs i .. i+7, two in a register; nodes and sums see them in the order of two FourEnds.
struct EightEnds {
  using Values = WideLanes;
  static constexpr std::size_t kCount = 8;
  FourEnds low, high;

  ESM_INLINE EightEnds(const SpringBatch& batch, std::size_t i) noexcept : low(batch, i), high(batch, i + 4)
  {}
  ESM_INLINE static void difference(const Lanes& b, const Lanes& nextB, const Lanes& a, const Lanes& nextA,
                                    WideLanes& d) noexcept
  {
    WideLanes to, from;
    joinHalves(b, nextB, to);
    joinHalves(a, nextA, from);
    d = to - from;
  }
  ESM_INLINE void difference(const Lanes* values, WideLanes& d02, WideLanes& d13, WideLanes& d46,
                             WideLanes& d57) const noexcept
  {
    difference(values[low.b0], values[low.b2], values[low.a0], values[low.a2], d02);
    difference(values[low.b1], values[low.b3], values[low.a1], values[low.a3], d13);
    difference(values[high.b0], values[high.b2], values[high.a0], values[high.a2], d46);
    difference(values[high.b1], values[high.b3], values[high.a1], values[high.a3], d57);
  }
  ESM_INLINE static void pull(Lanes* force, const FourEnds& ends, const WideLanes& even,
                              const WideLanes& odd) noexcept
  {
    Lanes f0, f1, f2, f3;
    lowerHalf(even, f0);
    lowerHalf(odd, f1);
    upperHalf(even, f2);
    upperHalf(odd, f3);
    ends.pull(force, f0, f1, f2, f3);
  }
  ESM_INLINE void pull(Lanes* force, const WideLanes& f02, const WideLanes& f13, const WideLanes& f46,
                       const WideLanes& f57) const noexcept
  {
    pull(force, low, f02, f13);
    pull(force, high, f46, f57);
  }
  ESM_INLINE void pullAlong(Lanes* force, const WideLanes& d02, const WideLanes& d13, const WideLanes& d46,
                            const WideLanes& d57, const WideLanes& scale) const noexcept
  {
    pull(force, d02 * __builtin_shufflevector(scale, scale, 0, 0, 0, 0, 2, 2, 2, 2),
         d13 * __builtin_shufflevector(scale, scale, 1, 1, 1, 1, 3, 3, 3, 3),
         d46 * __builtin_shufflevector(scale, scale, 4, 4, 4, 4, 6, 6, 6, 6),
         d57 * __builtin_shufflevector(scale, scale, 5, 5, 5, 5, 7, 7, 7, 7));
  }
  ESM_INLINE static void addTo(Lanes& sum, const WideLanes& values) noexcept
  {
    Lanes half;
    lowerHalf(values, half);
    sum += half;
    upperHalf(values, half);
    sum += half;
  }
  ESM_INLINE static void store(Lanes* damper, const WideLanes& x, const WideLanes& y,
                               const WideLanes& z) noexcept
  {
    lowerHalf(x, damper[0]);
    lowerHalf(y, damper[1]);
    lowerHalf(z, damper[2]);
    upperHalf(x, damper[3]);
    upperHalf(y, damper[4]);
    upperHalf(z, damper[5]);
  }
  ESM_INLINE static void load(const Lanes* damper, WideLanes& x, WideLanes& y, WideLanes& z) noexcept
  {
    joinHalves(damper[0], damper[3], x);
    joinHalves(damper[1], damper[4], y);
    joinHalves(damper[2], damper[5], z);
  }
};

/// For a version of ESM_WIDE_CLONES.
template <std::size_t lanes>
using EndsOf = std::conditional_t<lanes == EightEnds::kCount, EightEnds, FourEnds>;

/// How many springs of a batch are in whole groups.
template <class Ends>
ESM_INLINE std::size_t inWholeGroups(const SpringBatch& batch) noexcept
{
  return batch.paddedCount() / Ends::kCount * Ends::kCount;
}

/// The pass that all laws share, over springs begin .. end-1 in groups of Ends::kCount.
/// `Law::tension(batch, i, e, f)` gives f(e) of springs i, i+1, ... With `keep` the damping is stored as
/// well, see DamperArray.
///
/// A spring without direction gets the reciprocal length 0: then its force, its damping and its heat vanish
/// without further tests. A NaN is not too short, and spreads.
template <class Law, class Ends, bool damped, bool tensionOnly, bool keep>
ESM_INLINE void passGroups(const SpringBatch& batch, std::size_t begin, std::size_t end, const Lanes* x,
                           const Lanes* v, Lanes* force, Lanes* damper, Lanes& heat,
                           std::int64_t& degenerate) noexcept
{
  using Values = typename Ends::Values;
  using Bits = BitsOf<Values>;
  const Values zero = {};
  const Values one = zero + 1.0;
  const Values shortest = one * (kMinSpringLength * kMinSpringLength);
  Bits found = {};
  for (std::size_t i = begin; i < end; i += Ends::kCount) {
    const Ends ends(batch, i);
    Values d0, d1, d2, d3, dx, dy, dz, length, restLength, tension;
    ends.difference(x, d0, d1, d2, d3);
    transpose(d0, d1, d2, d3, dx, dy, dz);
    const Values square = dx * dx + dy * dy + dz * dz;
    length = square;
    squareRoot(length);
    const Bits tooShort = square < shortest; // all bits set where true
    found -= tooShort;
    Values inverse = one / length;
    inverse = tooShort ? zero : inverse;
    loadLanes(&batch.restLength[i], restLength);
    const Values e = length - restLength;
    Law::tension(batch, i, e, tension);
    if constexpr (damped) {
      Values w0, w1, w2, w3, wx, wy, wz, viscosity;
      ends.difference(v, w0, w1, w2, w3);
      transpose(w0, w1, w2, w3, wx, wy, wz);
      const Values rate = (wx * dx + wy * dy + wz * dz) * inverse;
      loadLanes(&batch.viscosity[i], viscosity);
      Values drag = viscosity * rate;
      if constexpr (tensionOnly) drag = e <= zero ? zero : drag;
      Ends::addTo(heat, drag * rate);
      tension += drag;
      if constexpr (keep) {
        Values root;
        loadLanes(&batch.rootViscosity[i], root);
        root *= inverse;
        if constexpr (tensionOnly) root = e <= zero ? zero : root;
        Ends::store(damper + i / 4 * 3, dx * root, dy * root, dz * root);
      }
    }
    if constexpr (tensionOnly) tension = e <= zero ? zero : tension;
    ends.pullAlong(force, d0, d1, d2, d3, tension * inverse);
  }
  for (std::size_t lane = 0; lane < Ends::kCount; ++lane) degenerate += found[lane];
}

/// In the widest groups that the version of a function has, and what is left by fours.
template <class Law, class Widest, bool damped, bool tensionOnly, bool keep>
ESM_INLINE SpringSums springPass(const SpringBatch& batch, const Lanes* x, const Lanes* v, Lanes* force,
                                 Lanes* damper) noexcept
{
  const std::size_t count = batch.paddedCount(), whole = inWholeGroups<Widest>(batch);
  Lanes heat = {0, 0, 0, 0};
  SpringSums sums;
  sums.degenerate = static_cast<std::int64_t>(batch.count) - static_cast<std::int64_t>(count);
  passGroups<Law, Widest, damped, tensionOnly, keep>(batch, 0, whole, x, v, force, damper, heat,
                                                     sums.degenerate);
  if (whole < count)
    passGroups<Law, FourEnds, damped, tensionOnly, keep>(batch, whole, count, x, v, force, damper, heat,
                                                         sums.degenerate);
  sums.heat = sumLanes(heat);
  return sums;
}

/// Chooses among the kinds of batch, once per batch.
template <class Law, class Widest>
ESM_INLINE SpringSums springPass(const SpringBatch& batch, const Lanes* x, const Lanes* v, Lanes* force,
                                 Lanes* damper) noexcept
{
  if (!batch.damped)
    return batch.tensionOnly ? springPass<Law, Widest, false, true, false>(batch, x, v, force, nullptr)
                             : springPass<Law, Widest, false, false, false>(batch, x, v, force, nullptr);
  if (damper != nullptr)
    return batch.tensionOnly ? springPass<Law, Widest, true, true, true>(batch, x, v, force, damper)
                             : springPass<Law, Widest, true, false, true>(batch, x, v, force, damper);
  return batch.tensionOnly ? springPass<Law, Widest, true, true, false>(batch, x, v, force, nullptr)
                           : springPass<Law, Widest, true, false, false>(batch, x, v, force, nullptr);
}

/// The energy of a batch [J], four springs at a time on every CPU: sums in another order have other bits.
/// `Law::energy(batch, i, e, result)` gives that of springs i .. i+3 at extensions e; what only fills up has
/// no stiffness, and none.
template <class Law>
ESM_INLINE double energyPass(const SpringBatch& batch, const Lanes* x) noexcept
{
  const Lanes zero = {0, 0, 0, 0};
  Lanes sum = zero;
  for (std::size_t i = 0; i < batch.paddedCount(); i += FourEnds::kCount) {
    Lanes d0, d1, d2, d3, dx, dy, dz, restLength, energy;
    FourEnds(batch, i).difference(x, d0, d1, d2, d3);
    transpose(d0, d1, d2, d3, dx, dy, dz);
    Lanes length = dx * dx + dy * dy + dz * dz;
    squareRoot(length);
    loadLanes(&batch.restLength[i], restLength);
    const Lanes e = length - restLength;
    Law::energy(batch, i, e, energy);
    if (batch.tensionOnly) energy = e <= zero ? zero : energy;
    sum += energy;
  }
  return sumLanes(sum);
}

} // namespace esm::detail
