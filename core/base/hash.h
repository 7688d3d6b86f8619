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

/// fingerprintOf() a text that is still growing, for who reads it piece by piece and wants to hash each piece
/// while it is in the cache.
class Fingerprint {
public:
  /// Takes in what has come to `text` since the last call, as far as it is certain.
  void follow(std::string_view text) noexcept
  {
    for (; m_at + kLanes * kWord <= text.size(); m_at += kLanes * kWord)
      for (std::size_t i = 0; i < kLanes; ++i)
        m_lane[i] = mix(m_lane[i], text.data() + m_at + i * kWord, kWord);
  }
  /// The fingerprint of `text`, which is complete now.
  std::uint64_t finish(std::string_view text) noexcept
  {
    follow(text);
    for (; m_at < text.size(); m_at += kWord)
      m_lane[0] = mix(m_lane[0], text.data() + m_at, std::min(kWord, text.size() - m_at));
    std::uint64_t hash = text.size();
    for (const std::uint64_t value : m_lane) hash = std::rotl((hash ^ value) * kPrime, 31);
    hash ^= hash >> 32;
    return hash != 0 ? hash : 1;
  }

private:
  static constexpr std::uint64_t kPrime = 0x9E3779B97F4A7C15ull;
  static constexpr std::size_t kLanes = 4, kWord = sizeof(std::uint64_t);
  static std::uint64_t mix(std::uint64_t hash, const char* from, std::size_t size) noexcept
  {
    std::uint64_t word = 0;
    std::memcpy(&word, from, size);
    return std::rotl((hash ^ word) * kPrime, 29);
  }

  // Word by word in four lanes, for a mesh of a gigabyte shall not wait for its fingerprint.
  std::uint64_t m_lane[kLanes] = {1, 2, 3, 4};
  std::size_t m_at = 0;
};

/// Tells whether a file is still the one that was read, quickly enough for a gigabyte. Never 0. As
/// hashBytes(), no match for an adversary. The value is kept in files: it must not change.
inline std::uint64_t fingerprintOf(std::string_view bytes) noexcept
{
  return Fingerprint().finish(bytes);
}

} // namespace esm
