// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace esm {

/// From now on this thread takes numbers too small for full precision (below 2e-308) for zero: they mean
/// nothing, and a processor may need a hundred times as long for each.
inline void dropDenormals() noexcept
{
#if defined(__SSE2__)
  constexpr unsigned kFlushResults = 0x8000, kZeroOperands = 0x0040;
  _mm_setcsr(_mm_getcsr() | kFlushResults | kZeroOperands);
#elif defined(__aarch64__)
  unsigned long state = 0;
  asm volatile("mrs %0, fpcr" : "=r"(state));
  asm volatile("msr fpcr, %0" : : "r"(state | (1ul << 24)));
#endif
}

} // namespace esm
