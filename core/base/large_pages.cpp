// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/base/large_pages.h"

#include <cstdint>
#include <cstring>
#include <sys/mman.h>

namespace esm {

namespace {

constexpr std::size_t kWorthwhile = std::size_t{1} << 22; // two large pages

/// The whole small pages in a piece of memory.
struct WholePages {
  char* begin;
  std::size_t bytes;
};
[[maybe_unused]] WholePages pagesIn(void* data, std::size_t bytes) noexcept
{
  constexpr std::uintptr_t kPage = 4096;
  const auto begin = reinterpret_cast<std::uintptr_t>(data);
  const std::uintptr_t first = (begin + kPage - 1) / kPage * kPage, last = (begin + bytes) / kPage * kPage;
  return {static_cast<char*>(data) + (first - begin), last - first};
}

} // namespace

void useLargePages([[maybe_unused]] void* data, [[maybe_unused]] std::size_t bytes) noexcept
{
#if defined(MADV_HUGEPAGE)
  if (bytes < kWorthwhile) return;
  const WholePages pages = pagesIn(data, bytes);
  madvise(pages.begin, pages.bytes, MADV_HUGEPAGE); // a refusal costs only time
#endif
}

void zeroInLargePages(void* data, std::size_t bytes) noexcept
{
  char* const from = static_cast<char*>(data);
#if defined(__linux__) // elsewhere the pages may keep what was in them
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
