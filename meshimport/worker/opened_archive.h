// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace esm {

/// What is known of a format that is an archive by design.
struct OpenedArchive {
  std::string text;    ///< of the scene in it, as far as unit and axes need it; empty if it is no archive
  std::string without; ///< a 3MF without its pictures, on which the library crashes; else empty

  std::string_view bytes(std::string_view whole) const { return without.empty() ? whole : without; }
};

/// @param ending of the format; "3mf" and "zae" are opened
OpenedArchive openArchive(std::string_view bytes, std::string_view ending);

} // namespace esm
