// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/forces/spring_law.h"

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

ESM_INLINE void loadLanes(const double* from, Lanes& to) noexcept
{
  __builtin_memcpy(&to, from, sizeof(to));
}

/// The ends of springs i .. i+3 of a batch.
struct FourEnds {
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
};

/// The pass that all laws share. `Law::tension(batch, i, e, f)` gives f(e) of springs i .. i+3. With `keep`
/// the damping is stored as well, see DamperArray.
///
/// A spring without direction gets the reciprocal length 0: then its force, its damping and its heat vanish
/// without further tests. A NaN is not too short, and spreads.
template <class Law, bool damped, bool tensionOnly, bool keep>
ESM_INLINE SpringSums springPass(const SpringBatch& batch, const Lanes* x, const Lanes* v, Lanes* force,
                                 Lanes* damper) noexcept
{
  const Lanes zero = {0, 0, 0, 0};
  const Lanes one = {1, 1, 1, 1};
  const Lanes shortest = one * (kMinSpringLength * kMinSpringLength);
  Lanes heat = zero;
  LaneBits degenerate = {0, 0, 0, 0};
  const std::size_t count = batch.paddedCount();
  for (std::size_t i = 0; i < count; i += 4) {
    const FourEnds ends(batch, i);
    Lanes d0, d1, d2, d3, dx, dy, dz, length, restLength, tension;
    ends.difference(x, d0, d1, d2, d3);
    transpose(d0, d1, d2, d3, dx, dy, dz);
    const Lanes square = dx * dx + dy * dy + dz * dz;
    length = square;
    squareRoot(length);
    const LaneBits tooShort = square < shortest; // all bits set where true
    degenerate -= tooShort;
    Lanes inverse = one / length;
    inverse = tooShort ? zero : inverse;
    loadLanes(&batch.restLength[i], restLength);
    const Lanes e = length - restLength;
    Law::tension(batch, i, e, tension);
    if constexpr (damped) {
      Lanes w0, w1, w2, w3, wx, wy, wz, viscosity;
      ends.difference(v, w0, w1, w2, w3);
      transpose(w0, w1, w2, w3, wx, wy, wz);
      const Lanes rate = (wx * dx + wy * dy + wz * dz) * inverse;
      loadLanes(&batch.viscosity[i], viscosity);
      Lanes drag = viscosity * rate;
      if constexpr (tensionOnly) drag = e <= zero ? zero : drag;
      heat += drag * rate;
      tension += drag;
      if constexpr (keep) {
        Lanes root;
        loadLanes(&batch.rootViscosity[i], root);
        root *= inverse;
        if constexpr (tensionOnly) root = e <= zero ? zero : root;
        damper[0] = dx * root;
        damper[1] = dy * root;
        damper[2] = dz * root;
        damper += 3;
      }
    }
    if constexpr (tensionOnly) tension = e <= zero ? zero : tension;
    const Lanes scale = tension * inverse;
    ends.pull(force, d0 * scale[0], d1 * scale[1], d2 * scale[2], d3 * scale[3]);
  }
  SpringSums sums;
  sums.heat = sumLanes(heat);
  sums.degenerate = degenerate[0] + degenerate[1] + degenerate[2] + degenerate[3] -
                    static_cast<std::int64_t>(count - batch.count);
  return sums;
}

/// Chooses among the kinds of batch, once per batch.
template <class Law>
ESM_INLINE SpringSums springPass(const SpringBatch& batch, const Lanes* x, const Lanes* v, Lanes* force,
                                 Lanes* damper) noexcept
{
  if (!batch.damped)
    return batch.tensionOnly ? springPass<Law, false, true, false>(batch, x, v, force, nullptr)
                             : springPass<Law, false, false, false>(batch, x, v, force, nullptr);
  if (damper != nullptr)
    return batch.tensionOnly ? springPass<Law, true, true, true>(batch, x, v, force, damper)
                             : springPass<Law, true, false, true>(batch, x, v, force, damper);
  return batch.tensionOnly ? springPass<Law, true, true, false>(batch, x, v, force, nullptr)
                           : springPass<Law, true, false, false>(batch, x, v, force, nullptr);
}

} // namespace esm::detail
