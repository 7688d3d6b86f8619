// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

// Internal to the reader of FCL.
#include "core/fuzzy/fis/source_text.h"

#include <string>
#include <string_view>
#include <vector>

namespace esm::fis {

/// The text of one FUNCTION_BLOCK, from its name to its end.
struct FunctionBlock {
  std::string name;
  std::string_view text;
};

/// All of a text without comments; one without a name where no FUNCTION_BLOCK is written. Throws Fault.
std::vector<FunctionBlock> functionBlocksOf(std::string_view text);
/// The block of that name or number, else the first one with a word about the others. Throws Fault.
const FunctionBlock& chooseBlock(const std::vector<FunctionBlock>& blocks, std::string_view wanted,
                                 Notes& notes);

} // namespace esm::fis
