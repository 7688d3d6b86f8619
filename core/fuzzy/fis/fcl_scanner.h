// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

// Internal to the reader of FCL.
#include "core/fuzzy/fis/source_text.h"

#include <string>
#include <string_view>

namespace esm::fis {

/// Puts blanks in the place of comments, so that every word keeps its place: (* *), /* */, // and # up to the
/// end of the line, and lines that begin with %, which within a line is the remainder. Throws Fault.
void blankComments(std::string& text);

/// Words, numbers and signs of an FCL text without comments, one after the other.
class FclScanner {
public:
  explicit FclScanner(std::string_view text) : m_text(text) { advance(); }

  std::string_view word() const { return m_word; }
  bool atEnd() const { return m_word.empty(); }
  bool is(std::string_view word) const { return equalIgnoringCase(m_word, word); }
  bool accept(std::string_view word);
  void expect(std::string_view word); ///< throws Fault, as do those below
  std::string_view take();
  double number();
  /// Everything up to the sign, trimmed; the sign is next.
  std::string_view upTo(char sign);
  /// The rest of the line of the last word, or up to a semicolon.
  std::string_view restOfStatement();
  /// Where the next word begins.
  std::size_t place() const { return static_cast<std::size_t>(m_word.data() - m_text.data()); }

private:
  void advance();
  bool isInnerByte(std::size_t at) const;

  std::string_view m_text, m_word;
  std::size_t m_next = 0;
};

} // namespace esm::fis
