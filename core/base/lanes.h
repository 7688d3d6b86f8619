// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

// Loops that deserve the CPU's wide registers: the same arithmetic lane by lane on every CPU, so that all
// give the same bits (contraction is off in the whole build).

// g++ notes that such a type is passed otherwise in code that is built for AVX as a whole. All of ESM is
// built for plain x86-64, and the AVX2 versions of a kernel pass it only to what is inlined into them.
#pragma GCC diagnostic ignored "-Wpsabi"

/// Put before a function that deserves a further version for CPUs with AVX2; the loader chooses. Off under
/// sanitizers, which cannot run before the choice is made, and where there is no such choice.
///
/// A loop over nodes takes the numbers of a struct that it gets by reference from a local copy: each store of
/// Lanes might change the struct, so they would be read and spread anew for every node.
///
/// ESM_CPU_CLONES_AVX512 adds one for AVX-512, of whose 32 registers g++ makes use in tiles of a matrix (a
/// factor takes a tenth less). Elsewhere such a version loses: its shuffles are other instructions. On a
/// Genoa the viscous forces alone took half as long again, whole motions up to a fifth longer; lanes of eight
/// were slower still.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(ESM_SANITIZED) &&            \
  !defined(ESM_NO_CLONES)
#define ESM_CPU_CLONES __attribute__((target_clones("default", "arch=x86-64-v3")))
#define ESM_CPU_CLONES_AVX512 __attribute__((target_clones("default", "arch=x86-64-v3", "arch=x86-64-v4")))
#else
#define ESM_CPU_CLONES
#define ESM_CPU_CLONES_AVX512
#endif

#define ESM_INLINE [[gnu::always_inline]] inline

namespace esm {

/// Four doubles that the compiler keeps in one AVX register, or in two SSE2 ones.
using Lanes = double __attribute__((vector_size(32)));
using LaneBits = std::int64_t __attribute__((vector_size(32)));

/// From memory that is aligned to single doubles only. (Attributes that say so of a type mean it to g++ or to
/// clang, not to both.)
ESM_INLINE void loadLanes(const double* from, Lanes& to) noexcept
{
  __builtin_memcpy(&to, from, sizeof(to));
}

/// In a file without math errno: else it is a call for each.
ESM_INLINE void squareRoot(Lanes& value) noexcept
{
  for (std::size_t lane = 0; lane < 4; ++lane) value[lane] = __builtin_sqrt(value[lane]);
}

/// Four places' (x, y, z, any) to four x, y, z. In such pairs of lanes that each line is one instruction:
/// other pairs cost three times as many, and a whole force pass a third more.
ESM_INLINE void transpose(const Lanes& r0, const Lanes& r1, const Lanes& r2, const Lanes& r3, Lanes& x,
                          Lanes& y, Lanes& z) noexcept
{
  const Lanes low = __builtin_shufflevector(r0, r1, 0, 4, 2, 6);  // x0 x1 z0 z1
  const Lanes high = __builtin_shufflevector(r2, r3, 0, 4, 2, 6); // x2 x3 z2 z3
  const Lanes lowY = __builtin_shufflevector(r0, r1, 1, 5, 3, 7);
  const Lanes highY = __builtin_shufflevector(r2, r3, 1, 5, 3, 7);
  x = __builtin_shufflevector(low, high, 0, 1, 4, 5);
  y = __builtin_shufflevector(lowY, highY, 0, 1, 4, 5);
  z = __builtin_shufflevector(low, high, 2, 3, 6, 7);
}

/// sum = what `take(i, to)` adds to `to` for all i < count. Four sums at a time, for one would wait for
/// itself. (By reference: functions with versions for several CPUs cannot return Lanes.)
template <class Take>
ESM_INLINE void sumOver(std::size_t count, const Take& take, Lanes& sum) noexcept
{
  Lanes part[4] = {};
  std::size_t i = 0;
  for (; i + 4 <= count; i += 4)
    for (std::size_t k = 0; k < 4; ++k) take(i + k, part[k]);
  for (; i < count; ++i) take(i, part[0]);
  sum = (part[0] + part[1]) + (part[2] + part[3]);
}

} // namespace esm
