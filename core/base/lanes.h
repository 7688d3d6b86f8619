// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>

// Loops that deserve the CPU's wide registers: the same arithmetic lane by lane on every CPU, so that all
// give the same bits (contraction is off in the whole build).

// g++ notes that such a type is passed otherwise in code that is built for AVX as a whole. All of ESM is
// built for plain x86-64, and the AVX2 versions of a kernel pass it only to what is inlined into them.
#pragma GCC diagnostic ignored "-Wpsabi"

/// Put before a function that deserves further versions for CPUs with AVX2 and with AVX-512 (whose 32
/// registers spare the spills; lanes stay four wide); the loader chooses. Off under sanitizers, which cannot
/// run before the choice is made, and where there is no such choice.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(ESM_SANITIZED) &&            \
  !defined(ESM_NO_CLONES)
#define ESM_CPU_CLONES __attribute__((target_clones("default", "arch=x86-64-v3", "arch=x86-64-v4")))
/// Defines a function with versions of different width: kLanes, for its body, is 4, or 8 with AVX-512. For
/// calls in the same file: others would always get the first one.
#define ESM_WIDE_CLONES(signature, ...)                                                                      \
  __attribute__((target("default"))) ESM_WIDE_VERSION(4, signature, __VA_ARGS__)                             \
    __attribute__((target("arch=x86-64-v3"))) ESM_WIDE_VERSION(4, signature, __VA_ARGS__)                    \
      __attribute__((target("arch=x86-64-v4"))) ESM_WIDE_VERSION(8, signature, __VA_ARGS__)
#else
#define ESM_CPU_CLONES
#ifndef ESM_LANES_WITHOUT_CLONES // a test wants eight of the plain version, too
#define ESM_LANES_WITHOUT_CLONES 4
#endif
#define ESM_WIDE_CLONES(signature, ...) ESM_WIDE_VERSION(ESM_LANES_WITHOUT_CLONES, signature, __VA_ARGS__)
#endif
#define ESM_WIDE_VERSION(lanes, signature, ...)                                                              \
  signature                                                                                                  \
  {                                                                                                          \
    constexpr std::size_t kLanes = lanes;                                                                    \
    __VA_ARGS__;                                                                                             \
  }

#define ESM_INLINE [[gnu::always_inline]] inline

namespace esm {

/// Four doubles that the compiler keeps in one AVX register, or in two SSE2 ones.
using Lanes = double __attribute__((vector_size(32)));
using LaneBits = std::int64_t __attribute__((vector_size(32)));
/// Eight of them in one AVX-512 register; for the last version of ESM_WIDE_CLONES only.
using WideLanes = double __attribute__((vector_size(64)));
/// What comparing two of them gives: all bits of a lane, or none.
template <class Values>
using BitsOf = decltype(std::declval<Values>() < std::declval<Values>());

/// From memory that is aligned to single doubles only. (Attributes that say so of a type mean it to g++ or to
/// clang, not to both.)
template <class Values>
ESM_INLINE void loadLanes(const double* from, Values& to) noexcept
{
  __builtin_memcpy(&to, from, sizeof(to));
}

/// In a file without math errno: else it is a call for each.
template <class Values>
ESM_INLINE void squareRoot(Values& value) noexcept
{
  for (std::size_t lane = 0; lane < sizeof(Values) / sizeof(double); ++lane)
    value[lane] = __builtin_sqrt(value[lane]);
}

ESM_INLINE void lowerHalf(const WideLanes& value, Lanes& half) noexcept
{
  half = __builtin_shufflevector(value, value, 0, 1, 2, 3);
}
ESM_INLINE void upperHalf(const WideLanes& value, Lanes& half) noexcept
{
  half = __builtin_shufflevector(value, value, 4, 5, 6, 7);
}
/// Two of four side by side. In assembly, as g++ would read the upper half into another register, and
/// shuffle.
ESM_INLINE void joinHalves(const Lanes& low, const Lanes& high, WideLanes& both) noexcept
{
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(ESM_NO_CLONES)
  const WideLanes lower = __builtin_shufflevector(low, Lanes{0, 0, 0, 0}, 0, 1, 2, 3, 4, 5, 6, 7);
  asm("vinsertf64x4 $1, %2, %1, %0" : "=v"(both) : "v"(lower), "vm"(high));
#else
  both = __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
#endif
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

/// The same for eight, of which each argument has two: 0 and 2, 1 and 3, 4 and 6, 5 and 7.
ESM_INLINE void transpose(const WideLanes& r02, const WideLanes& r13, const WideLanes& r46,
                          const WideLanes& r57, WideLanes& x, WideLanes& y, WideLanes& z) noexcept
{
  const WideLanes low = __builtin_shufflevector(r02, r13, 0, 8, 2, 10, 4, 12, 6, 14);  // x0 x1 z0 z1 x2 ...
  const WideLanes high = __builtin_shufflevector(r46, r57, 0, 8, 2, 10, 4, 12, 6, 14); // x4 x5 z4 z5 x6 ...
  const WideLanes lowY = __builtin_shufflevector(r02, r13, 1, 9, 3, 11, 5, 13, 7, 15);
  const WideLanes highY = __builtin_shufflevector(r46, r57, 1, 9, 3, 11, 5, 13, 7, 15);
  x = __builtin_shufflevector(low, high, 0, 1, 4, 5, 8, 9, 12, 13);
  y = __builtin_shufflevector(lowY, highY, 0, 1, 4, 5, 8, 9, 12, 13);
  z = __builtin_shufflevector(low, high, 2, 3, 6, 7, 10, 11, 14, 15);
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
