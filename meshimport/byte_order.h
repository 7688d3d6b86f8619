// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>

namespace esm {

/// The T whose bytes start at `from`, of any alignment, in the given byte order.
template <class T, std::endian order>
T load(const char* from)
{
  std::array<char, sizeof(T)> bytes;
  std::copy_n(from, sizeof(T), bytes.begin());
  if constexpr (order != std::endian::native) std::reverse(bytes.begin(), bytes.end());
  return std::bit_cast<T>(bytes);
}

template <class T>
T loadLittle(const char* from)
{
  return load<T, std::endian::little>(from);
}

} // namespace esm
