// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace esm::fuzzy {

/// Words of a UTF-8 text, for the controlled language of rules. Bytes that are no UTF-8 stay as they are.
/// Any thread.

/// One word, parenthesis or quoted name, and where it stands.
struct Token {
  enum class Kind { Word, Quoted, Open, Close } kind = Kind::Word;
  std::size_t offset = 0, length = 0; ///< bytes in the text, quotes included
  std::string folded;                 ///< foldCase() of the content
};

/// Blanks part words; a comma, semicolon or full stop at a word's end is passed over, as in
/// "WENN Härte IST hart, DANN ...". "..." is one name, whatever it holds.
std::vector<Token> tokenize(std::string_view text);

/// Lower case for comparing: A-Z and the Latin letters with marks (ÄÖÜÉ...), ß as ss, a letter followed by a
/// combining diaeresis as the umlaut, runs of blanks as one blank.
std::string foldCase(std::string_view text);

/// The folded words of a name.
std::vector<std::string> foldedWords(std::string_view name);

/// Insertions, deletions, changes and swaps of neighbours (in characters, not bytes) from one folded word
/// to the other; `limit` + 1 if there are more than `limit`.
int editDistance(std::string_view a, std::string_view b, int limit);

/// The candidate nearest to `word`, if it is near enough to have been meant; else empty.
std::string nearestWord(std::string_view word, const std::vector<std::string>& candidates);

} // namespace esm::fuzzy
