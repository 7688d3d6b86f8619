// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"

#include <string>
#include <string_view>

namespace esm {

/// The error for a file that a foreign library cannot read. What the libraries are known to say becomes a sentence
/// of our own, with the line or byte where it can be told; anything else is quoted as theirs.
/// @param complaint the library's own words, one or several lines
/// @param bytes of the file: where XML, JSON or a number is damaged, libraries do not say the place
Error libraryRefusal(std::string_view complaint, std::string_view bytes, std::string_view ending,
                     const std::string& origin);

/// The error for a file of which our own look has found what is broken, with the same ways out.
Error damagedFile(const std::string& what, bool mayBeCut, const std::string& origin);

/// The clause of libraryRefusal() alone, with its place, for a note; empty for words that are not known.
std::string libraryFinding(std::string_view complaint, std::string_view bytes, std::string_view ending);

/// Whether tags end what has not begun, or do not end: libraries may pass over all that follows.
bool hasTornTags(std::string_view xml);

} // namespace esm
