// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/fuzzy/rule_draft.h"
#include "core/project/json_view.h"

/// The lines of a journal, as they stand in its file. Internal to core/project.
namespace esm::json {

inline constexpr const char* kJournalFormat = "esm-journal";
inline constexpr int kJournalVersion = 1;

/// The object on one line, with a sum over its bytes as last member.
std::string sealedLine(const Json& object);
/// Without the sum. Nothing if the line is not what sealedLine() wrote.
std::optional<Json> openedLine(std::string_view line, const std::string& origin);

Json draftOf(const RuleDraft& draft); ///< null if it is empty
RuleDraft readDraft(const View& value);

std::string fingerprintText(std::uint64_t fingerprint); ///< 16 hexadecimal digits

} // namespace esm::json
