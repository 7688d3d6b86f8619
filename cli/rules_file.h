// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/tissue/tissue_model.h"

#include <string>

namespace esm::cli {

/// Puts the rules of a file in place of the tissue's: from a text of rules (over the tissue's variables), or
/// from a project (its variables and rules; inputs and regions start from their defaults where the variables
/// differ). Errors name file, line and word.
Status takeRules(const std::string& file, TissueModel& tissue);

/// A rule as typed: "IF hardness IS hard THEN youngs_modulus IS high". Errors name the word.
Result<fuzzy::Rule> readRule(const std::string& text, const fuzzy::RuleBase& rules);

} // namespace esm::cli
