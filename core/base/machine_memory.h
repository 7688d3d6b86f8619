// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <unistd.h>
#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace esm {

/// What is built into the machine [bytes]; SIZE_MAX where the system does not tell. Any thread.
inline std::size_t machineMemory() noexcept
{
  const long pages = ::sysconf(_SC_PHYS_PAGES), size = ::sysconf(_SC_PAGESIZE);
  return pages > 0 && size > 0 ? static_cast<std::size_t>(pages) * static_cast<std::size_t>(size) : SIZE_MAX;
}

/// Gives freed memory back to the system, which the C library would keep for later. Takes milliseconds: for when
/// something large is over. Any thread.
inline void giveBackFreeMemory() noexcept
{
#if defined(__GLIBC__)
  ::malloc_trim(0);
#endif
}

} // namespace esm
