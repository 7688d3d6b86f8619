// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdio>
#include <cstdlib>

namespace esm {

/// Called when ESM_ASSERT finds a bug of ours; replace it in tests to catch the report. Any thread.
using AssertHandler = void (*)(const char* expression, const char* file, int line);

inline void abortOnAssert(const char* expression, const char* file, int line)
{
  std::fprintf(stderr, "%s:%d: internal error: %s\n", file, line, expression);
  std::abort();
}

inline AssertHandler assertHandler = abortOnAssert;

} // namespace esm

/// States what only a bug of ours can break (a shape, an index); never for input from the world, which
/// gets a Result. On in Debug builds and under sanitizers, off in release hot loops.
#if !defined(NDEBUG) || defined(ESM_SANITIZED)
#define ESM_ASSERT(expression)                                                                               \
  ((expression) ? static_cast<void>(0) : ::esm::assertHandler(#expression, __FILE__, __LINE__))
#else
#define ESM_ASSERT(expression) static_cast<void>(sizeof((expression) ? 1 : 0))
#endif
