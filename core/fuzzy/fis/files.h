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

struct ReadOptions {
  /// One sentence each about what was passed over or taken otherwise than written: "file:line:column: what".
  std::vector<std::string>* notes = nullptr;
  std::string_view block = {}; ///< of FCL, the function block to read: a name or number; empty: the first one
};

/// Reads a whole text. What real files carry is taken: CR LF, comments, byte order marks, UTF-8, UTF-16 and
/// Latin-1, surplus parameters and expressions in FIS, names in quotes (blanks are left out of names), keys
/// of older versions. Errors: one, "file:line:column: what". Any bytes give a checked System or an error.
Result<System> readFll(std::string_view text, std::string_view fileName, const ReadOptions& options = {});
Result<System> readFcl(std::string_view text, std::string_view fileName, const ReadOptions& options = {});
Result<System> readFis(std::string_view text, std::string_view fileName, const ReadOptions& options = {});
Result<System> readSystem(Format format, std::string_view text, std::string_view fileName,
                          const ReadOptions& options = {});

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
