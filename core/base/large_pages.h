// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

namespace esm {

/// Lets arrays of megabytes come from the heap, side by side, where large pages can reach from one into the
/// next, and freed ones serve the next stage of the same work. As it comes, the C library maps each of them
/// on its own: beginning and end lie in small pages, and all memory is fresh again. For the start of main();
/// it holds for the whole program, which keeps up to 256 MB that it no longer uses.
void keepBigArraysInHeap() noexcept;

/// Asks the system to back fresh memory with large pages. The first touch of a page costs more than the work
/// of an import on the bytes in it; in pages of 2 MB the same memory comes about five times cheaper. A hint:
/// where the system has no such pages nothing changes, and small arrays are left alone.
void useLargePages(void* data, std::size_t bytes) noexcept;

/// The same, and the memory reads as zero bytes. Of a big array only the edges are touched: the system hands
/// out zeros on first use anyway, so what stays zero costs neither time nor memory.
void zeroInLargePages(void* data, std::size_t bytes) noexcept;

/// For an array that was resized and not yet written to.
template <class Array>
void useLargePages(Array& fresh)
{
  useLargePages(fresh.data(), static_cast<std::size_t>(fresh.size()) * sizeof(*fresh.data()));
}
template <class Array>
void zeroInLargePages(Array& fresh)
{
  zeroInLargePages(fresh.data(), static_cast<std::size_t>(fresh.size()) * sizeof(*fresh.data()));
}

/// Room for `count` values in large pages.
template <class T>
void reserveLarge(std::vector<T>& values, std::size_t count)
{
  values.reserve(count);
  useLargePages(values.data(), values.capacity() * sizeof(T));
}
template <class T>
std::vector<T> largeVector(std::size_t count, const T& value)
{
  std::vector<T> values;
  reserveLarge(values, count);
  values.assign(count, value);
  return values;
}

} // namespace esm
