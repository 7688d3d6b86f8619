// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/forces/spring_law.h"

#include <cstddef>
#include <cstdint>

// How the ends of four springs come out of the nodes' arrays into lanes, and forces back.

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

/// Asks for what a pass will read of an array about sixty springs on, as much as `rows` from `here`: of nets
/// beyond the L2 cache the processor asks too late. That may lie behind the end, which asking may.
ESM_INLINE void foresee(const Lanes* here, std::size_t rows) noexcept
{
  constexpr std::size_t kAhead = 2048, kLine = 64; // bytes
  const auto* const ahead = reinterpret_cast<const char*>(here) + kAhead;
  for (std::size_t byte = 0; byte < rows * sizeof(Lanes); byte += kLine) __builtin_prefetch(ahead + byte);
}

static_assert(static_cast<std::size_t>(kMostNetNodes) * sizeof(Lanes) <= std::size_t{1} << 32);

/// A node's place in a NodeArray [bytes].
inline std::uint32_t placeOf(Index node) noexcept
{
  return static_cast<std::uint32_t>(static_cast<std::size_t>(node) * sizeof(Lanes));
}

/// A node's entry by its place.
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
  static constexpr std::size_t kCount = 4;
  std::size_t a0, a1, a2, a3, b0, b1, b2, b3;

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
  /// The same value to both ends.
  ESM_INLINE void addToBoth(Lanes* values, const Lanes& f0, const Lanes& f1, const Lanes& f2,
                            const Lanes& f3) const noexcept
  {
    at(values, a0) += f0;
    at(values, b0) += f0;
    at(values, a1) += f1;
    at(values, b1) += f1;
    at(values, a2) += f2;
    at(values, b2) += f2;
    at(values, a3) += f3;
    at(values, b3) += f3;
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
};

} // namespace esm::detail
