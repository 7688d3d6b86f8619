// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/fuzzy/lexicon.h"

#include "core/fuzzy/rule_text.h"

#include <algorithm>
#include <array>
#include <functional>
#include <map>

namespace esm::fuzzy {

namespace {

struct KeywordEntry {
  Keyword keyword;
  const char *english, *german;
};
constexpr std::array<KeywordEntry, 7> kKeywords = {{{Keyword::If, "IF", "WENN"},
                                                    {Keyword::Then, "THEN", "DANN"},
                                                    {Keyword::Is, "IS", "IST"},
                                                    {Keyword::And, "AND", "UND"},
                                                    {Keyword::Or, "OR", "ODER"},
                                                    {Keyword::Not, "NOT", "NICHT"},
                                                    {Keyword::With, "WITH", "MIT"}}};

/// The first word of a hedge is the one it is written with; the others are what physicians also say.
struct HedgeEntry {
  std::vector<Hedge> hedges;
  std::vector<const char*> english, german;
};
const std::vector<HedgeEntry>& hedgeEntries()
{
  static const std::vector<HedgeEntry> entries = {
    {{Hedge::Not}, {"not"}, {"nicht"}},
    {{Hedge::Very}, {"very"}, {"sehr"}},
    {{Hedge::Extremely}, {"extremely"}, {"extrem", "äußerst"}},
    {{Hedge::Somewhat}, {"somewhat", "rather", "fairly", "a little"}, {"etwas", "ziemlich", "ein wenig"}},
    {{Hedge::Not, Hedge::Somewhat}, {"hardly"}, {"kaum"}}};
  return entries;
}

/// Whether the tokens start with these folded words, all of them unquoted.
bool startsWith(std::span<const Token> tokens, const std::vector<std::string>& words)
{
  if (words.empty() || words.size() > tokens.size()) return false;
  return std::equal(words.begin(), words.end(), tokens.begin(),
                    [](const std::string& word, const Token& token) {
                      return token.kind == Token::Kind::Word && token.folded == word;
                    });
}

} // namespace

std::optional<Keyword> keywordOf(const Token& token)
{
  static const std::map<std::string, Keyword, std::less<>> byText = [] {
    std::map<std::string, Keyword, std::less<>> table;
    for (const KeywordEntry& entry : kKeywords)
      for (const char* text : {entry.english, entry.german}) table[foldCase(text)] = entry.keyword;
    return table;
  }();
  if (token.kind != Token::Kind::Word) return std::nullopt;
  const auto found = byText.find(token.folded);
  return found == byText.end() ? std::nullopt : std::optional(found->second);
}

const char* keywordText(Keyword keyword, Language language)
{
  const auto& entry = kKeywords[static_cast<std::size_t>(keyword)];
  return language == Language::German ? entry.german : entry.english;
}

std::optional<HedgeMatch> matchHedge(std::span<const Token> tokens)
{
  struct Phrase {
    std::vector<std::string> words;
    const std::vector<Hedge>* hedges;
  };
  static const std::vector<Phrase> phrases = [] {
    std::vector<Phrase> all;
    for (const HedgeEntry& entry : hedgeEntries())
      for (const auto* spellings : {&entry.english, &entry.german})
        for (const char* spelling : *spellings) all.push_back({foldedWords(spelling), &entry.hedges});
    return all;
  }();
  for (const Phrase& phrase : phrases)
    if (startsWith(tokens, phrase.words)) return HedgeMatch{*phrase.hedges, phrase.words.size()};
  return std::nullopt;
}

const char* hedgeText(Hedge hedge, Language language)
{
  for (const HedgeEntry& entry : hedgeEntries())
    if (entry.hedges.size() == 1 && entry.hedges.front() == hedge)
      return language == Language::German ? entry.german.front() : entry.english.front();
  return "";
}

std::vector<std::string> keywordTexts(std::span<const Keyword> keywords)
{
  std::vector<std::string> texts;
  for (const Keyword keyword : keywords)
    for (const Language language : {Language::English, Language::German})
      texts.emplace_back(keywordText(keyword, language));
  return texts;
}

std::vector<std::string> hedgeTexts()
{
  std::vector<std::string> texts;
  for (const HedgeEntry& entry : hedgeEntries())
    for (const auto* spellings : {&entry.english, &entry.german})
      texts.insert(texts.end(), spellings->begin(), spellings->end());
  return texts;
}

Vocabulary vocabulary(Language language)
{
  Vocabulary result;
  for (const KeywordEntry& entry : kKeywords)
    result.keywords.emplace_back(keywordText(entry.keyword, language));
  for (const HedgeEntry& entry : hedgeEntries()) {
    const auto& spellings = language == Language::German ? entry.german : entry.english;
    result.hedges.insert(result.hedges.end(), spellings.begin(), spellings.end());
  }
  return result;
}

void NameTable::add(std::size_t index, const std::string& id, const Names& name)
{
  addEntries(index, name.english, m_names);
  addEntries(index, name.german, m_names);
  addEntries(index, id, m_ids);
}

void NameTable::addEntries(std::size_t index, const std::string& spelling, std::vector<Entry>& entries)
{
  Entry entry{foldedWords(spelling), foldCase(spelling), index};
  if (entry.words.empty()) return;
  m_spellings.push_back(spelling);
  m_mostWords = std::max(m_mostWords, entry.words.size());
  entries.push_back(std::move(entry));
}

std::optional<NameTable::Match> NameTable::match(std::span<const Token> tokens) const
{
  std::optional<Match> best;
  if (tokens.empty()) return best;
  const bool quoted = tokens.front().kind == Token::Kind::Quoted;
  auto plain = tokens.first(std::min(tokens.size(), m_mostWords));
  plain = plain.first(
    static_cast<std::size_t>(std::find_if(plain.begin(), plain.end(), keywordOf) - plain.begin()));
  for (const auto* entries : {&m_ids, &m_names})
    for (const Entry& entry : *entries) {
      const std::size_t length = quoted ? 1 : entry.words.size();
      const bool found = quoted ? tokens.front().folded == entry.folded : startsWith(plain, entry.words);
      if (found && (!best || length > best->tokens)) best = Match{entry.index, length};
    }
  return best;
}

} // namespace esm::fuzzy
