// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/forces/spring_law.h"

#include <algorithm>
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

/// A node's entry by its place in bytes, as SpringBatch::record has it.
ESM_INLINE const Lanes& at(const Lanes* values, std::size_t offset) noexcept
{
  return *reinterpret_cast<const Lanes*>(reinterpret_cast<const char*>(values) + offset);
}
ESM_INLINE Lanes& at(Lanes* values, std::size_t offset) noexcept
{
  return *reinterpret_cast<Lanes*>(reinterpret_cast<char*>(values) + offset);
}

/// The ends of four springs, as places in bytes, and what is done in lanes with them.
struct FourEnds {
  using Values = Lanes;
  static constexpr std::size_t kCount = 4;
  std::size_t a0, a1, a2, a3, b0, b1, b2, b3;

  /// Of springs i .. i+3.
  ESM_INLINE FourEnds(const SpringBatch& batch, std::size_t i) noexcept
    : a0(offsetOf(batch.a[i])),
      a1(offsetOf(batch.a[i + 1])),
      a2(offsetOf(batch.a[i + 2])),
      a3(offsetOf(batch.a[i + 3])),
      b0(offsetOf(batch.b[i])),
      b1(offsetOf(batch.b[i + 1])),
      b2(offsetOf(batch.b[i + 2])),
      b3(offsetOf(batch.b[i + 3]))
  {}
  /// Of a group by the first row of its record.
  ESM_INLINE explicit FourEnds(const Lanes* row) noexcept
    : a0(entry(row, 0)),
      a1(entry(row, 1)),
      a2(entry(row, 2)),
      a3(entry(row, 3)),
      b0(entry(row, 4)),
      b1(entry(row, 5)),
      b2(entry(row, 6)),
      b3(entry(row, 7))
  {}
  ESM_INLINE static std::size_t offsetOf(Index node) noexcept
  {
    return static_cast<std::size_t>(node) * sizeof(Lanes);
  }
  ESM_INLINE static std::size_t entry(const Lanes* row, std::size_t place) noexcept
  {
    std::uint32_t offset;
    __builtin_memcpy(&offset, reinterpret_cast<const char*>(row) + place * sizeof(offset), sizeof(offset));
    return offset;
  }
  /// values[b] - values[a] of each.
  ESM_INLINE void difference(const Lanes* values, Lanes& d0, Lanes& d1, Lanes& d2, Lanes& d3) const noexcept
  {
    d0 = at(values, b0) - at(values, a0);
    d1 = at(values, b1) - at(values, a1);
    d2 = at(values, b2) - at(values, a2);
    d3 = at(values, b3) - at(values, a3);
  }
  /// A force on each end a, the opposite one on b.
  ESM_INLINE void pull(Lanes* force, const Lanes& f0, const Lanes& f1, const Lanes& f2,
                       const Lanes& f3) const noexcept
  {
    at(force, a0) += f0;
    at(force, b0) -= f0;
    at(force, a1) += f1;
    at(force, b1) -= f1;
    at(force, a2) += f2;
    at(force, b2) -= f2;
    at(force, a3) += f3;
    at(force, b3) -= f3;
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
  ESM_INLINE EightEnds(const Lanes* row, const Lanes* nextRow) noexcept : low(row), high(nextRow) {}
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
    difference(at(values, low.b0), at(values, low.b2), at(values, low.a0), at(values, low.a2), d02);
    difference(at(values, low.b1), at(values, low.b3), at(values, low.a1), at(values, low.a3), d13);
    difference(at(values, high.b0), at(values, high.b2), at(values, high.a0), at(values, high.a2), d46);
    difference(at(values, high.b1), at(values, high.b3), at(values, high.a1), at(values, high.a3), d57);
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

/// How many groups of springs are computed together, see passGroups(). With four lanes three are best: two
/// take 8 % longer, four 3 %. With eight lanes two and three took longer than one before springs had records,
/// and have not been measured since.
template <class Ends>
inline constexpr std::size_t kGroupsAtOnce = Ends::kCount == FourEnds::kCount ? 3 : 1;

/// The springs first .. first + Ends::kCount - 1 of a batch in a pass, by their records.
template <class Law, class Ends, bool damped>
struct SpringGroup {
  using Values = typename Ends::Values;
  static constexpr std::size_t kRows = 2 + lawRows(Law::kLaw) + (damped ? 1 : 0); ///< of one record
  const SpringBatch& batch;
  std::size_t first;
  const Lanes* record;

  ESM_INLINE SpringGroup(const SpringBatch& of, std::size_t i) noexcept
    : batch(of), first(i), record(of.record.data() + i / 4 * kRows)
  {}
  ESM_INLINE Ends ends() const noexcept
  {
    if constexpr (Ends::kCount == 4)
      return Ends(record);
    else
      return Ends(record, record + kRows);
  }
  ESM_INLINE void row(std::size_t k, Values& values) const noexcept
  {
    if constexpr (Ends::kCount == 4)
      values = record[k];
    else
      joinHalves(record[k], record[kRows + k], values);
  }
  ESM_INLINE void restLength(Values& values) const noexcept { row(1, values); }
  ESM_INLINE void lawRow(std::size_t k, Values& values) const noexcept { row(2 + k, values); }
  ESM_INLINE void viscosity(Values& values) const noexcept { row(kRows - 1, values); }
};

/// What the three parts of a pass over a group of springs hand on.
template <class Values>
struct GroupInFlight {
  Values d0, d1, d2, d3; ///< x[b] - x[a], in the order of Ends
  Values dx, dy, dz;     ///< the same in lanes
  Values square;         ///< |d|^2 [m^2]
  Values slip;           ///< (v[b] - v[a]).d [m^2/s]
  Values scale;          ///< tension over length [N/m]
};

/// First part: what the nodes say.
template <class Law, class Ends, bool damped, class Values>
ESM_INLINE void readGroup(const SpringGroup<Law, Ends, damped>& springs, const Lanes* x, const Lanes* v,
                          GroupInFlight<Values>& group) noexcept
{
  const Ends ends = springs.ends();
  ends.difference(x, group.d0, group.d1, group.d2, group.d3);
  transpose(group.d0, group.d1, group.d2, group.d3, group.dx, group.dy, group.dz);
  group.square = group.dx * group.dx + group.dy * group.dy + group.dz * group.dz;
  if constexpr (damped) {
    Values w0, w1, w2, w3, wx, wy, wz;
    ends.difference(v, w0, w1, w2, w3);
    transpose(w0, w1, w2, w3, wx, wy, wz);
    group.slip = wx * group.dx + wy * group.dy + wz * group.dz;
  }
}

/// Second part: how hard each spring pulls.
///
/// A spring without direction gets the reciprocal length 0: then its force, its damping and its heat vanish
/// without further tests. A NaN is not too short, and spreads. The reciprocal of the square is found beside
/// the length, not after it: the damping needs that one anyway, and no division waits for a root.
template <bool tensionOnly, bool keep, class Law, class Ends, bool damped, class Values>
ESM_INLINE void stretchGroup(const SpringGroup<Law, Ends, damped>& springs, GroupInFlight<Values>& group,
                             Lanes* damper, Lanes& heat, BitsOf<Values>& degenerate) noexcept
{
  const Values zero = {};
  const Values one = zero + 1.0;
  const Values shortest = one * (kMinSpringLength * kMinSpringLength);
  Values length = group.square, restLength, tension;
  squareRoot(length);
  const BitsOf<Values> tooShort = group.square < shortest; // all bits set where true
  degenerate -= tooShort;
  Values inverseSquare = one / group.square;
  inverseSquare = tooShort ? zero : inverseSquare;
  const Values inverse = length * inverseSquare;
  springs.restLength(restLength);
  const Values e = length - restLength;
  Law::tension(springs, e, tension);
  group.scale = tension * inverse;
  if constexpr (damped) {
    Values drag;
    springs.viscosity(drag);
    drag *= group.slip * inverseSquare;
    if constexpr (tensionOnly) drag = e <= zero ? zero : drag;
    Ends::addTo(heat, drag * group.slip);
    group.scale += drag;
    if constexpr (keep) {
      Values root;
      loadLanes(&springs.batch.rootViscosity[springs.first], root);
      root *= inverse;
      if constexpr (tensionOnly) root = e <= zero ? zero : root;
      Ends::store(damper + springs.first / 4 * 3, group.dx * root, group.dy * root, group.dz * root);
    }
  }
  if constexpr (tensionOnly) group.scale = e <= zero ? zero : group.scale;
}

/// The pass that all laws share, over springs begin .. end-1 in steps of `groups` groups of Ends::kCount;
/// @return where it stopped, less than a step before the end. `Law::tension(group, e, f)` gives f(e) of a
/// SpringGroup. With `keep` the damping is stored as well, see DamperArray.
///
/// From reading the nodes to pulling at them a spring takes a hundred cycles, most of them waiting for the
/// root and the quotient, and a processor looks only some 250 instructions ahead: not three groups. So the
/// groups of a step go through each part together, and wait together: a quarter of the time.
template <class Law, class Ends, std::size_t groups, bool damped, bool tensionOnly, bool keep>
ESM_INLINE std::size_t passGroups(const SpringBatch& batch, std::size_t begin, std::size_t end,
                                  const Lanes* x, const Lanes* v, Lanes* force, Lanes* damper, Lanes& heat,
                                  std::int64_t& degenerate) noexcept
{
  using Values = typename Ends::Values;
  BitsOf<Values> found = {};
  std::size_t i = begin;
  for (; i + groups * Ends::kCount <= end; i += groups * Ends::kCount) {
    using Springs = SpringGroup<Law, Ends, damped>;
    GroupInFlight<Values> group[groups];
    for (std::size_t g = 0; g < groups; ++g) readGroup(Springs(batch, i + g * Ends::kCount), x, v, group[g]);
    for (std::size_t g = 0; g < groups; ++g)
      stretchGroup<tensionOnly, keep>(Springs(batch, i + g * Ends::kCount), group[g], damper, heat, found);
    for (std::size_t g = 0; g < groups; ++g)
      Springs(batch, i + g * Ends::kCount)
        .ends()
        .pullAlong(force, group[g].d0, group[g].d1, group[g].d2, group[g].d3, group[g].scale);
  }
  for (std::size_t lane = 0; lane < Ends::kCount; ++lane) degenerate += found[lane];
  return i;
}

/// In the widest groups that the version of a function has, and what is left by fours.
template <class Law, class Widest, bool damped, bool tensionOnly, bool keep>
ESM_INLINE SpringSums springPass(const SpringBatch& batch, const Lanes* x, const Lanes* v, Lanes* force,
                                 Lanes* damper) noexcept
{
  const std::size_t count = batch.paddedCount();
  Lanes heat = {0, 0, 0, 0};
  SpringSums sums;
  sums.degenerate = static_cast<std::int64_t>(batch.count) - static_cast<std::int64_t>(count);
  const std::size_t done = passGroups<Law, Widest, kGroupsAtOnce<Widest>, damped, tensionOnly, keep>(
    batch, 0, count, x, v, force, damper, heat, sums.degenerate);
  passGroups<Law, FourEnds, 1, damped, tensionOnly, keep>(batch, done, count, x, v, force, damper, heat,
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
/// `Law::energy(group, e, result)` gives that of a SpringGroup at extensions e; what only fills up has no
/// stiffness, and none.
template <class Law, bool damped>
ESM_INLINE double energyPass(const SpringBatch& batch, const Lanes* x) noexcept
{
  const Lanes zero = {0, 0, 0, 0};
  Lanes sum = zero;
  for (std::size_t i = 0; i < batch.paddedCount(); i += FourEnds::kCount) {
    const SpringGroup<Law, FourEnds, damped> springs(batch, i);
    Lanes d0, d1, d2, d3, dx, dy, dz, restLength, energy;
    springs.ends().difference(x, d0, d1, d2, d3);
    transpose(d0, d1, d2, d3, dx, dy, dz);
    Lanes length = dx * dx + dy * dy + dz * dz;
    squareRoot(length);
    springs.restLength(restLength);
    const Lanes e = length - restLength;
    Law::energy(springs, e, energy);
    if (batch.tensionOnly) energy = e <= zero ? zero : energy;
    sum += energy;
  }
  return sumLanes(sum);
}

template <class Law>
ESM_INLINE double energyPass(const SpringBatch& batch, const Lanes* x) noexcept
{
  return batch.damped ? energyPass<Law, true>(batch, x) : energyPass<Law, false>(batch, x);
}

/// The largest absolute tension of a batch [N], four springs at a time; what only fills up has none.
template <class Law, bool damped>
ESM_INLINE double tensionPass(const SpringBatch& batch, const Lanes* x, const Lanes* v) noexcept
{
  const Lanes zero = {0, 0, 0, 0};
  Lanes largest = zero;
  for (std::size_t i = 0; i < batch.paddedCount(); i += FourEnds::kCount) {
    const SpringGroup<Law, FourEnds, damped> springs(batch, i);
    GroupInFlight<Lanes> group;
    readGroup(springs, x, v, group);
    Lanes length = group.square, restLength, tension;
    squareRoot(length);
    springs.restLength(restLength);
    const Lanes e = length - restLength;
    Law::tension(springs, e, tension);
    if constexpr (damped) {
      Lanes viscosity;
      springs.viscosity(viscosity);
      tension += viscosity * (group.slip / length);
    }
    if (batch.tensionOnly) tension = e <= zero ? zero : tension;
    tension = length < zero + kMinSpringLength ? zero : tension;
    tension = tension < zero ? -tension : tension;
    largest = tension > largest ? tension : largest;
  }
  return std::max(std::max(largest[0], largest[1]), std::max(largest[2], largest[3]));
}

template <class Law>
ESM_INLINE double tensionPass(const SpringBatch& batch, const Lanes* x, const Lanes* v) noexcept
{
  return batch.damped ? tensionPass<Law, true>(batch, x, v) : tensionPass<Law, false>(batch, x, v);
}

} // namespace esm::detail
