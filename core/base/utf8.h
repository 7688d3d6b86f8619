// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string_view>

namespace esm {

/// How many bytes the character at the beginning of `text` takes as UTF-8 (RFC 3629); 0 if it is none: a byte
/// out of place, an overlong form, a surrogate, beyond U+10FFFF, or `text` is empty.
inline std::size_t utf8Length(std::string_view text) noexcept
{
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  if (text.empty()) return 0;
  if (byte(0) < 0x80) return 1;
  const std::size_t length = byte(0) >= 0xF0 ? 4 : byte(0) >= 0xE0 ? 3 : 2;
  if (byte(0) < 0xC2 || byte(0) > 0xF4 || text.size() < length) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(i) & 0xC0) != 0x80) return 0;
  const bool outside = (byte(0) == 0xE0 && byte(1) < 0xA0) || (byte(0) == 0xED && byte(1) > 0x9F) ||
                       (byte(0) == 0xF0 && byte(1) < 0x90) || (byte(0) == 0xF4 && byte(1) > 0x8F);
  return outside ? 0 : length;
}

/// Whether a character of utf8Length() bytes steers a terminal: U+0000 ... U+001F, U+007F ... U+009F.
inline bool isControlCharacter(std::string_view character) noexcept
{
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(character[i]); };
  return (character.size() == 1 && (byte(0) < 0x20 || byte(0) == 0x7F)) ||
         (character.size() == 2 && byte(0) == 0xC2 && byte(1) < 0xA0);
}

} // namespace esm
