// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/fuzzy/words.h"

#include <algorithm>

namespace esm::fuzzy {

namespace {

/// Bytes of the blank that starts at `at`; 0 if none does. A byte order mark counts as a blank.
std::size_t blankLength(std::string_view text, std::size_t at)
{
  const char c = text[at];
  if (c == ' ' || (c >= '\t' && c <= '\r')) return 1;
  if (text.substr(at, 2) == "\xC2\xA0") return 2; // no-break space
  if (text.substr(at, 3) == "\xEF\xBB\xBF" || text.substr(at, 3) == "\xE2\x80\xAF") return 3;
  return 0;
}

bool endsWord(std::string_view text, std::size_t at)
{
  const char c = text[at];
  return c == '(' || c == ')' || c == '"' || blankLength(text, at) > 0;
}

Token makeToken(Token::Kind kind, std::string_view text, std::size_t from, std::size_t to)
{
  std::string_view content = text.substr(from, to - from);
  if (kind == Token::Kind::Quoted) content = content.substr(1, content.size() - 2);
  return {kind, from, to - from, foldCase(content)};
}

/// Splits into characters; a byte that starts none is one by itself.
std::vector<std::string_view> characters(std::string_view text)
{
  std::vector<std::string_view> result;
  for (std::size_t i = 0; i < text.size();) {
    std::size_t next = i + 1;
    while (next < text.size() && (static_cast<unsigned char>(text[next]) & 0xC0U) == 0x80U) ++next;
    result.push_back(text.substr(i, next - i));
    i = next;
  }
  return result;
}

/// Appends the folded form of the character at `at`; returns its bytes.
std::size_t appendFolded(std::string_view text, std::size_t at, std::string& folded)
{
  const char c = text[at];
  const auto next = at + 1 < text.size() ? static_cast<unsigned char>(text[at + 1]) : 0U;
  if (c >= 'A' && c <= 'Z') {
    folded += static_cast<char>(c - 'A' + 'a');
    return 1;
  }
  if (text.substr(at, 3) == "\xE1\xBA\x9E" || text.substr(at, 2) == "\xC3\x9F") { // capital ß, ß
    folded += "ss";
    return c == '\xC3' ? 2 : 3;
  }
  if (c == '\xC3' && next >= 0x80U && next <= 0x9EU && next != 0x97U) { // À to Þ without the times sign
    folded += c;
    folded += static_cast<char>(next + 0x20U);
    return 2;
  }
  if (text.substr(at, 2) == "\xCC\x88" && !folded.empty()) { // combining diaeresis
    const char* umlaut = folded.back() == 'a'   ? "\xC3\xA4"
                         : folded.back() == 'o' ? "\xC3\xB6"
                         : folded.back() == 'u' ? "\xC3\xBC"
                                                : nullptr;
    if (umlaut) {
      folded.pop_back();
      folded += umlaut;
      return 2;
    }
  }
  folded += c;
  return 1;
}

} // namespace

std::vector<Token> tokenize(std::string_view text)
{
  std::vector<Token> tokens;
  for (std::size_t i = 0; i < text.size();) {
    if (const std::size_t blank = blankLength(text, i); blank > 0) {
      i += blank;
      continue;
    }
    if (text[i] == '(' || text[i] == ')') {
      const auto kind = text[i] == '(' ? Token::Kind::Open : Token::Kind::Close;
      tokens.push_back(makeToken(kind, text, i, i + 1));
      ++i;
      continue;
    }
    const std::size_t closing = text[i] == '"' ? text.find('"', i + 1) : std::string_view::npos;
    if (closing != std::string_view::npos) {
      tokens.push_back(makeToken(Token::Kind::Quoted, text, i, closing + 1));
      i = closing + 1;
      continue;
    }
    std::size_t end = i + 1; // an unclosed quote is an (unknown) word like others
    while (end < text.size() && !endsWord(text, end)) ++end;
    std::size_t last = end;
    while (last > i && (text[last - 1] == ',' || text[last - 1] == ';' || text[last - 1] == '.')) --last;
    if (last > i) tokens.push_back(makeToken(Token::Kind::Word, text, i, last));
    i = end;
  }
  return tokens;
}

std::string foldCase(std::string_view text)
{
  std::string folded;
  bool pendingBlank = false;
  for (std::size_t i = 0; i < text.size();) {
    if (const std::size_t blank = blankLength(text, i); blank > 0) {
      pendingBlank = !folded.empty();
      i += blank;
      continue;
    }
    if (pendingBlank) folded += ' ';
    pendingBlank = false;
    i += appendFolded(text, i, folded);
  }
  return folded;
}

std::vector<std::string> foldedWords(std::string_view name)
{
  std::vector<std::string> words;
  const std::string folded = foldCase(name);
  for (std::size_t from = 0; from < folded.size();) {
    const std::size_t to = std::min(folded.find(' ', from), folded.size());
    words.push_back(folded.substr(from, to - from));
    from = to + 1;
  }
  return words;
}

int editDistance(std::string_view a, std::string_view b, int limit)
{
  // A character has at most 4 bytes, so very different byte counts decide alone.
  if (a.size() > 4 * (b.size() + static_cast<std::size_t>(limit)) + 4) return limit + 1;
  const auto x = characters(a), y = characters(b);
  std::vector<int> beforeLast, last(y.size() + 1), row(y.size() + 1);
  for (std::size_t j = 0; j <= y.size(); ++j) last[j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= x.size(); ++i) {
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= y.size(); ++j) {
      const int change = last[j - 1] + (x[i - 1] == y[j - 1] ? 0 : 1);
      row[j] = std::min({change, last[j] + 1, row[j - 1] + 1});
      if (i > 1 && j > 1 && x[i - 1] == y[j - 2] && x[i - 2] == y[j - 1])
        row[j] = std::min(row[j], beforeLast[j - 2] + 1);
    }
    beforeLast = last;
    std::swap(last, row);
  }
  return std::min(last[y.size()], limit + 1);
}

std::string nearestWord(std::string_view word, const std::vector<std::string>& candidates)
{
  const std::string folded = foldCase(word);
  const std::size_t length = characters(folded).size();
  const int limit = length <= 4 ? 1 : length <= 7 ? 2 : 3; // a slip, not another word
  std::string nearest;
  int least = limit + 1;
  for (const std::string& candidate : candidates) {
    const int distance = editDistance(folded, foldCase(candidate), limit);
    if (distance >= least) continue;
    least = distance;
    nearest = candidate;
  }
  return nearest;
}

} // namespace esm::fuzzy
