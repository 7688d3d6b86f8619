// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

// Internal to the reader of FCL: what holds where a file says nothing.
#include "core/fuzzy/fis/system.h"

#include <string_view>

namespace esm::fis {

/// How a block names its norms of "and" and "or"; empty: not at all.
struct NormWords {
  std::string_view conjunction{}, disjunction{};
};
/// One of AND and OR follows from the other by De Morgan's law, as the standard has it; ACT is MIN.
void completeNorms(RuleBlock& block, const NormWords& words);

/// Without METHOD it is COG, over numbers COGS; without RANGE the terms span it; without ACCU it is MAX.
/// @return false if COG over numbers was taken as COGS
bool completeOutput(OutputVariable& output, bool hasMethod);

} // namespace esm::fis
