// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/forces/spring_law.h"

#include <cstddef>
#include <cstdint>
#include <type_traits>

// How the ends of four or eight springs come out of the nodes' arrays into lanes, and forces back.

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

/// Asks for what a pass will read of an array about sixty springs on, as much as `rows` from `here`: of nets
/// beyond the L2 cache the processor asks too late. That may lie behind the end, which asking may.
ESM_INLINE void foresee(const Lanes* here, std::size_t rows) noexcept
{
  constexpr std::size_t kAhead = 2048, kLine = 64; // bytes
  const auto* const ahead = reinterpret_cast<const char*>(here) + kAhead;
  for (std::size_t byte = 0; byte < rows * sizeof(Lanes); byte += kLine) __builtin_prefetch(ahead + byte);
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

  /// Of a group by the first row of its record; how many rows that has matters to EightEnds.
  ESM_INLINE explicit FourEnds(const Lanes* row, std::size_t /*rows*/ = 1) noexcept
    : a0(entry(row, 0)),
      a1(entry(row, 1)),
      a2(entry(row, 2)),
      a3(entry(row, 3)),
      b0(entry(row, 4)),
      b1(entry(row, 5)),
      b2(entry(row, 6)),
      b3(entry(row, 7))
  {}
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
  /// The same with the forces group.d{x,y,z} * group.scale, transposed: products of the differences, which
  /// have to wait on the stack, and a broadcast for each took 4 % longer.
  template <class Group>
  ESM_INLINE void pullAlong(Lanes* force, const Group& group) const noexcept
  {
    Lanes f0, f1, f2, f3;
    transposeBack(group.dx * group.scale, group.dy * group.scale, group.dz * group.scale, f0, f1, f2, f3);
    pull(force, f0, f1, f2, f3);
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

  /// Of two groups whose records have `rows` rows each.
  ESM_INLINE EightEnds(const Lanes* row, std::size_t rows) noexcept : low(row), high(row + rows) {}
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
  /// The same with the forces along the differences d0 to d3, which are still in registers here.
  template <class Group>
  ESM_INLINE void pullAlong(Lanes* force, const Group& group) const noexcept
  {
    const WideLanes& scale = group.scale;
    pull(force, group.d0 * __builtin_shufflevector(scale, scale, 0, 0, 0, 0, 2, 2, 2, 2),
         group.d1 * __builtin_shufflevector(scale, scale, 1, 1, 1, 1, 3, 3, 3, 3),
         group.d2 * __builtin_shufflevector(scale, scale, 4, 4, 4, 4, 6, 6, 6, 6),
         group.d3 * __builtin_shufflevector(scale, scale, 5, 5, 5, 5, 7, 7, 7, 7));
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

} // namespace esm::detail
