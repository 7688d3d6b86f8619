// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

// Internal to the reader of FCL.
#include "core/fuzzy/fis/source_text.h"

#include <string>
#include <string_view>

namespace esm::fis {

/// A FUNCTION of jFuzzyLogic in the language of Formula: names in any case, LN and LOG (to base 10), ^ and %
/// from the left and before * and /. Its x is the variable of that name. Throws Fault.
std::string formulaOfFcl(std::string_view text, const System& system);

} // namespace esm::fis
