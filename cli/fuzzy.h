// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "cli/messages.h"
#include "core/fuzzy/fis/system.h"

#include <string>
#include <vector>

namespace esm::cli {

/// The works of `esm fuzzy`, which fuzzy.cpp describes to the parser.

/// Which system a command works on.
struct FuzzySource {
  std::string file;
  std::string block; ///< of FCL: name or number of a function block; empty: the first one
};

struct FuzzyEvalOptions {
  FuzzySource source;
  std::string input, output;
  std::string resolution = "exact"; ///< or "file", or a number
};
Exit evaluateFuzzy(const FuzzyEvalOptions& options);

/// By the ending of its name: FLL, FCL or FIS. Errors name the place. Says what was passed over.
Result<fis::System> readFuzzySystem(const FuzzySource& source);
/// The same; hands over what was passed over instead of saying it.
Result<fis::System> readFuzzySystem(const FuzzySource& source, std::vector<std::string>& notes);

} // namespace esm::cli
