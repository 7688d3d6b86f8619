// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/base/text_encoding.h"

#include <array>
#include <cstdint>

namespace esm {

namespace {

constexpr std::uint32_t kReplacement = 0xFFFD;

/// 0x80 to 0x9F of Windows-1252; 0: the control character of Latin-1.
constexpr std::array<std::uint16_t, 32> kWindows = {
  0x20AC, 0,      0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021, 0x02C6, 0x2030, 0x0160,
  0x2039, 0x0152, 0,      0x017D, 0,      0,      0x2018, 0x2019, 0x201C, 0x201D, 0x2022,
  0x2013, 0x2014, 0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0,      0x017E, 0x0178};

std::uint32_t byteAt(std::string_view bytes, std::size_t i)
{
  return static_cast<unsigned char>(bytes[i]);
}

void append(std::string& text, std::uint32_t code)
{
  const auto put = [&](std::uint32_t byte) { text += static_cast<char>(byte); };
  if (code < 0x80) {
    put(code);
  } else if (code < 0x800) {
    put(0xC0U | code >> 6U);
    put(0x80U | (code & 0x3FU));
  } else if (code < 0x10000) {
    put(0xE0U | code >> 12U);
    put(0x80U | (code >> 6U & 0x3FU));
    put(0x80U | (code & 0x3FU));
  } else {
    put(0xF0U | code >> 18U);
    put(0x80U | (code >> 12U & 0x3FU));
    put(0x80U | (code >> 6U & 0x3FU));
    put(0x80U | (code & 0x3FU));
  }
}

std::string fromUtf16(std::string_view bytes, bool bigEnd)
{
  const auto unit = [&](std::size_t i) {
    return bigEnd ? byteAt(bytes, i) << 8U | byteAt(bytes, i + 1)
                  : byteAt(bytes, i + 1) << 8U | byteAt(bytes, i);
  };
  std::string text;
  for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
    std::uint32_t code = unit(i);
    if (code >= 0xD800 && code < 0xE000) {
      const bool pair = code < 0xDC00 && i + 3 < bytes.size() && (unit(i + 2) & 0xFC00U) == 0xDC00U;
      code = pair ? 0x10000 + ((code & 0x3FFU) << 10U) + (unit(i + 2) & 0x3FFU) : kReplacement;
      if (pair) i += 2;
    }
    append(text, code);
  }
  return text;
}

} // namespace

std::size_t utf8Length(std::string_view text) noexcept
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

bool isControlCharacter(std::string_view character) noexcept
{
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(character[i]); };
  return (character.size() == 1 && (byte(0) < 0x20 || byte(0) == 0x7F)) ||
         (character.size() == 2 && byte(0) == 0xC2 && byte(1) < 0xA0);
}

bool isUtf8(std::string_view bytes) noexcept
{
  while (!bytes.empty()) {
    const std::size_t length = utf8Length(bytes);
    if (length == 0) return false;
    bytes.remove_prefix(length);
  }
  return true;
}

std::string_view withoutByteOrderMark(std::string_view bytes) noexcept
{
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (bytes.starts_with(kByteOrderMark)) bytes.remove_prefix(kByteOrderMark.size());
  return bytes;
}

std::string toUtf8(std::string_view bytes)
{
  bytes = withoutByteOrderMark(bytes);
  if (bytes.starts_with("\xFF\xFE")) return fromUtf16(bytes.substr(2), false);
  if (bytes.starts_with("\xFE\xFF")) return fromUtf16(bytes.substr(2), true);
  if (isUtf8(bytes)) return std::string(bytes);
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const std::uint32_t byte = byteAt(bytes, i);
    const bool special = byte >= 0x80 && byte < 0xA0 && kWindows[byte - 0x80] != 0;
    append(text, special ? kWindows[byte - 0x80] : byte);
  }
  return text;
}

} // namespace esm
