// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

// Internal to the reader of FIS.
#include "core/fuzzy/fis/source_text.h"

#include <string_view>

namespace esm::fis {

/// A row of [Rules], "1 -2, 1 (0.5) : 1": the numbers of terms, weight, 1 (and) or 2 (or). A row of zeros
/// gives an empty condition. Throws Fault.
Rule readRuleRow(std::string_view line, const System& system);

} // namespace esm::fis
