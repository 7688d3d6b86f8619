// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/fuzzy/rule_base.h"
#include "core/fuzzy/words.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace esm::fuzzy {

/// The words of the rule language in both languages, and the names of a rule base to be found in a text.

enum class Keyword { If, Then, Is, And, Or, Not, With };
/// Nothing for quoted tokens, parentheses and other words.
std::optional<Keyword> keywordOf(const Token& token);
const char* keywordText(Keyword keyword, Language language);

/// Hedges meant by one or two words: "very", "ein wenig"; "kaum" (hardly) means two, not somewhat.
struct HedgeMatch {
  std::vector<Hedge> hedges;
  std::size_t tokens = 0;
};
std::optional<HedgeMatch> matchHedge(std::span<const Token> tokens);
const char* hedgeText(Hedge hedge, Language language);
/// Every keyword and hedge of both languages, as candidates for what was meant.
std::vector<std::string> keywordTexts(std::span<const Keyword> keywords);
std::vector<std::string> hedgeTexts();

/// Finds the variables or terms of a list by id or by name in either language.
class NameTable {
public:
  template <class Named>
  explicit NameTable(const std::vector<Named>& things)
  {
    for (std::size_t i = 0; i < things.size(); ++i) add(i, things[i].id, things[i].name);
  }

  struct Match {
    std::size_t index = 0;  ///< into the list
    std::size_t tokens = 0; ///< that the name covers
  };
  /// The longest name at the start of `tokens`; at equal length an id goes before a name. A name that
  /// holds a keyword is found in quotes only.
  std::optional<Match> match(std::span<const Token> tokens) const;

  /// What can be written, for suggestions.
  const std::vector<std::string>& spellings() const noexcept { return m_spellings; }

private:
  struct Entry {
    std::vector<std::string> words;
    std::string folded;
    std::size_t index;
  };
  void add(std::size_t index, const std::string& id, const Names& name);
  void addEntries(std::size_t index, const std::string& spelling, std::vector<Entry>& entries);
  std::vector<Entry> m_ids, m_names;
  std::vector<std::string> m_spellings;
  std::size_t m_mostWords = 0; ///< of any one name
};

} // namespace esm::fuzzy
