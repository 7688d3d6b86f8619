// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "cli/messages.h"
#include "core/fuzzy/fis/system.h"

#include <string>

namespace esm::cli {

/// The works of `esm fuzzy`, which fuzzy.cpp describes to the parser.

struct FuzzyEvalOptions {
  std::string file, input, output;
  std::string resolution = "exact"; ///< or a number
};
Exit evaluateFuzzy(const FuzzyEvalOptions& options);

/// By the ending of its name: FLL, FCL or FIS. Errors name the place.
Result<fis::System> readFuzzySystem(const std::string& file);

} // namespace esm::cli
