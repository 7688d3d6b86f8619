// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
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

/// Tells whether a file is still the one that was read, quickly enough for a gigabyte: word by word in four
/// lanes. Never 0. As hashBytes(), no match for an adversary. The value is kept in files: it must not change.
inline std::uint64_t fingerprintOf(std::string_view bytes) noexcept
{
  // Word by word in four lanes, for a mesh of a gigabyte shall not wait for its fingerprint.
  constexpr std::uint64_t kPrime = 0x9E3779B97F4A7C15ull;
  constexpr std::size_t kLanes = 4, kWord = sizeof(std::uint64_t);
  std::uint64_t lane[kLanes] = {1, 2, 3, 4};
  const auto mix = [](std::uint64_t hash, const char* from, std::size_t size) {
    std::uint64_t word = 0;
    std::memcpy(&word, from, size);
    return std::rotl((hash ^ word) * kPrime, 29);
  };
  std::size_t at = 0;
  for (; at + kLanes * kWord <= bytes.size(); at += kLanes * kWord)
    for (std::size_t i = 0; i < kLanes; ++i) lane[i] = mix(lane[i], bytes.data() + at + i * kWord, kWord);
  for (; at < bytes.size(); at += kWord)
    lane[0] = mix(lane[0], bytes.data() + at, std::min(kWord, bytes.size() - at));
  std::uint64_t hash = bytes.size();
  for (const std::uint64_t value : lane) hash = std::rotl((hash ^ value) * kPrime, 31);
  hash ^= hash >> 32;
  return hash != 0 ? hash : 1;
}

} // namespace esm
