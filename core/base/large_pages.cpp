// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/base/large_pages.h"

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <sys/mman.h>
#include <unistd.h>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace esm {

namespace {

constexpr std::uintptr_t kPage = 4096;

/// The whole small pages in a piece of memory.
struct WholePages {
  char* begin;
  std::size_t bytes;
};
[[maybe_unused]] WholePages pagesIn(void* data, std::size_t bytes) noexcept
{
  const auto begin = reinterpret_cast<std::uintptr_t>(data);
  const std::uintptr_t first = (begin + kPage - 1) / kPage * kPage, last = (begin + bytes) / kPage * kPage;
  return {static_cast<char*>(data) + (first - begin), last - first};
}

} // namespace

void useLargePages([[maybe_unused]] void* data, [[maybe_unused]] std::size_t bytes) noexcept
{
#if defined(MADV_HUGEPAGE)
  constexpr std::size_t kWorthwhile = std::size_t{1} << 20; // with its neighbours in the heap
  if (bytes < kWorthwhile) return;
  const auto begin = reinterpret_cast<std::uintptr_t>(data);
  std::uintptr_t end = begin + bytes;
  // In the heap with all that follows: the library writes behind each array where the next one will be, and
  // after that it would be too late for a large page there.
  if (const auto heapEnd = reinterpret_cast<std::uintptr_t>(sbrk(0)); end < heapEnd) end = heapEnd;
  const std::uintptr_t first = begin / kPage * kPage, behind = (end + kPage - 1) / kPage * kPage;
  // A refusal costs only time.
  madvise(static_cast<char*>(data) - (begin - first), behind - first, MADV_HUGEPAGE);
#endif
}

void keepBigArraysInHeap() noexcept
{
#if defined(__GLIBC__)
  constexpr std::size_t kMegabyte = std::size_t{1} << 20;
  mallopt(M_MMAP_THRESHOLD, 32 * kMegabyte); // the most that the library takes
  mallopt(M_TRIM_THRESHOLD, 256 * kMegabyte);
  mallopt(M_TOP_PAD, 64 * kMegabyte); // addresses only: pages come with their first use
  void* const first = std::malloc(2 * kMegabyte);
  if (first) useLargePages(first, 2 * kMegabyte);
  std::free(first);
#endif
}

void zeroInLargePages(void* data, std::size_t bytes) noexcept
{
  char* const from = static_cast<char*>(data);
#if defined(__linux__)
  // Elsewhere the pages may keep what was in them.
  constexpr std::size_t kWorthwhile = std::size_t{1} << 22; // two large pages
  if (bytes >= kWorthwhile) {
    const WholePages pages = pagesIn(data, bytes);
    if (madvise(pages.begin, pages.bytes, MADV_DONTNEED) == 0) {
      char* const behind = pages.begin + pages.bytes;
      std::memset(from, 0, static_cast<std::size_t>(pages.begin - from));
      std::memset(behind, 0, static_cast<std::size_t>(from + bytes - behind));
      useLargePages(data, bytes);
      return;
    }
  }
#endif
  if (bytes > 0) std::memset(from, 0, bytes);
}

} // namespace esm
