// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace esm {

/// What has been typed into the rules and is no rule yet. No part of the project, but of what would be lost.
struct RuleDraft {
  std::string text; ///< all lines of the rules as text, if one of them is not applied; else empty
  int row = -1;     ///< of the table's cell whose text is no rule; -1: none
  int column = 0;
  std::string cell;
  bool isEmpty() const noexcept { return text.empty() && row < 0; }
  bool operator==(const RuleDraft&) const = default;
};

} // namespace esm
