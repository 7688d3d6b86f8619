// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace esm {

/// How many bytes the character at the beginning of `text` takes as UTF-8 (RFC 3629); 0 if it is none: a byte
/// out of place, an overlong form, a surrogate, beyond U+10FFFF, or `text` is empty.
std::size_t utf8Length(std::string_view text) noexcept;

/// Whether a character of utf8Length() bytes steers a terminal: U+0000 ... U+001F, U+007F ... U+009F.
bool isControlCharacter(std::string_view character) noexcept;

/// Whether the bytes are well-formed UTF-8 (no overlong forms, no surrogates).
bool isUtf8(std::string_view bytes) noexcept;

/// The text without the byte-order mark that editors of Windows put before UTF-8.
std::string_view withoutByteOrderMark(std::string_view bytes) noexcept;

/// A text file's bytes as UTF-8 without a byte order mark: UTF-16 by its mark, UTF-8, else the characters
/// of Windows-1252, of which Latin-1 is a part. Any bytes give a text.
std::string toUtf8(std::string_view bytes);

} // namespace esm
