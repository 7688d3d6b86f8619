// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace esm {

/// Whether the bytes are well-formed UTF-8 (no overlong forms, no surrogates).
bool isUtf8(std::string_view bytes) noexcept;

/// A text file's bytes as UTF-8 without a byte order mark: UTF-16 by its mark, UTF-8, else the characters
/// of Windows-1252, of which Latin-1 is a part. Any bytes give a text.
std::string toUtf8(std::string_view bytes);

} // namespace esm
