// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace esm {

/// Numbers in packets, byte by byte, whatever this machine's order. The caller has checked the length.

inline std::uint16_t getLe16(const std::uint8_t* p) noexcept
{
  return static_cast<std::uint16_t>(p[0] | p[1] << 8);
}
inline void putLe16(std::uint8_t* p, std::uint16_t value) noexcept
{
  p[0] = static_cast<std::uint8_t>(value);
  p[1] = static_cast<std::uint8_t>(value >> 8);
}
inline std::uint16_t getBe16(const std::uint8_t* p) noexcept
{
  return static_cast<std::uint16_t>(p[0] << 8 | p[1]);
}
inline void putBe16(std::uint8_t* p, std::uint16_t value) noexcept
{
  p[0] = static_cast<std::uint8_t>(value >> 8);
  p[1] = static_cast<std::uint8_t>(value);
}
inline std::uint32_t getBe32(const std::uint8_t* p) noexcept
{
  return static_cast<std::uint32_t>(getBe16(p)) << 16 | getBe16(p + 2);
}
inline void putBe32(std::uint8_t* p, std::uint32_t value) noexcept
{
  putBe16(p, static_cast<std::uint16_t>(value >> 16));
  putBe16(p + 2, static_cast<std::uint16_t>(value));
}

} // namespace esm
