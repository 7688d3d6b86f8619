// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/fuzzy/fis/system.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace esm::fis {

/// Fuzzy systems as files:
///
///     FLL   fuzzylite's language; holds a System without loss (what fuzzylite does not know stands in
///           comments that begin with "#!", or is named in Written::losses)
///     FCL   IEC 61131-7, with the additions of fuzzylite and jFuzzyLogic where real files carry them
///     FIS   MATLAB's and Octave's, with the additions of fuzzylite
enum class Format : std::uint8_t { Fll, Fcl, Fis };
std::optional<Format> formatOf(const std::filesystem::path& path); ///< by the name's ending
std::string_view nameOf(Format format) noexcept;

/// Reads a whole text. What real files carry is taken: CR LF, comments, byte order marks, surplus parameters
/// and expressions in FIS, names in quotes (blanks are left out of names), keys of older versions.
/// Errors: one, "file:line:column: what". Any bytes give a checked System or an error.
Result<System> readFll(std::string_view text, std::string_view fileName);
Result<System> readFcl(std::string_view text, std::string_view fileName);
Result<System> readFis(std::string_view text, std::string_view fileName);
Result<System> readSystem(Format format, std::string_view text, std::string_view fileName);

/// A text and what it could not hold, one sentence each; empty: nothing is lost.
struct Written {
  std::string text;
  std::vector<std::string> losses;
};
/// @pre checkSystem(system)
Written writeFll(const System& system);
Written writeFcl(const System& system);
Written writeFis(const System& system);
Written writeSystem(Format format, const System& system);

} // namespace esm::fis
