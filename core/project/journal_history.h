// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/project/journal_reader.h"
#include "core/project/json_tree.h"

#include <functional>
#include <map>

/// The states that the lines of a journal went through. Internal to core/project.
namespace esm::json {

/// Collects them from the lines, in order.
class JournalHistory {
public:
  /// What the lines begin from. @param tree without its net
  JournalHistory(Json tree, std::string copy, bool derived, int model, int index, bool isSaved);
  /// The next line. May throw where its patch does not fit.
  void take(const Json& line);
  using NetReader = std::function<std::shared_ptr<const SpringNet>(const std::string& copy)>; ///< null: fault
  /// The states next to the last one, without a gap. Empty where the lines do not tell or one cannot be read.
  RecoveredHistory states(const NetReader& netOf, const std::string& origin) const;

private:
  struct State {
    Json tree;
    std::string copy;
    bool derived = false;
    int model = 0;
    std::optional<Json> fixed; ///< nodes held, where they differ from the copy's
  };
  std::optional<RecoveredState> read(const State& state, const NetReader& netOf,
                                     const std::string& origin) const;

  State m_now;
  int m_index = 0;
  std::optional<int> m_saved; ///< index of what the file holds
  std::map<int, State> m_states;
  std::map<int, std::string> m_texts; ///< of the step that leads to the index
};

} // namespace esm::json
