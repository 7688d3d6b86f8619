// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace esm {

/// FNV-1a, 64 bits: to see that two results are equal bit for bit, not against an adversary.
inline std::uint64_t hashBytes(const void* data, std::size_t size,
                               std::uint64_t seed = 14695981039346656037ull)
{
  const auto* byte = static_cast<const unsigned char*>(data);
  for (std::size_t i = 0; i < size; ++i) seed = (seed ^ byte[i]) * 1099511628211ull;
  return seed;
}

inline std::uint64_t hashBytes(std::string_view text)
{
  return hashBytes(text.data(), text.size());
}

} // namespace esm
