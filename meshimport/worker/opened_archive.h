// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace esm {

/// What is known of a format that is an archive by design.
struct OpenedArchive {
  std::string text;  ///< of the scene in it, as far as unit and axes need it; empty if it is no archive
  std::string plain; ///< a 3MF of one model and without pictures, on which the library crashes; else empty
  std::vector<std::string> lost; ///< files that the scene names and the archive does not hold
  std::string fault; ///< what is broken, where the library would crash on it or find nothing; else empty

  std::string_view bytes(std::string_view whole) const { return plain.empty() ? whole : plain; }
};

/// @param ending of the format; "3mf" and "zae" are opened
OpenedArchive openArchive(std::string_view bytes, std::string_view ending);

/// Why the library found no mesh in a 3MF or ZAE; none if it is no archive or nothing is seen.
std::optional<Error> emptyArchive(std::string_view bytes, std::string_view ending, const std::string& origin);

} // namespace esm
