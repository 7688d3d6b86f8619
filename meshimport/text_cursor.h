// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/work_control.h"

#include <string>
#include <string_view>

namespace esm {

/// Walks through the bytes of a text mesh file, word by word and line by line, in one pass and without
/// copies. Lines end with LF, CR LF or CR. Numbers have a point whatever the locale.
class TextCursor {
public:
  enum Rules : unsigned {
    Plain = 0,
    HashComments = 1,   ///< '#' ends a line early
    BackslashJoins = 2, ///< a backslash at the end of a line joins the next one to it
  };

  /// A UTF-8 byte-order mark at the start is skipped.
  explicit TextCursor(std::string_view text, unsigned rules = Plain);

  long line() const noexcept { return m_line; } ///< from 1
  bool atEnd() const noexcept { return m_at == m_end; }
  std::string_view rest() const noexcept { return {m_at, static_cast<std::size_t>(m_end - m_at)}; }

  /// Tells which share of the text is done and asks whether to stop; `control` may be null.
  bool stopWanted(WorkControl* control) const;

  bool atLineEnd();        ///< whether nothing but blanks and a comment is left on this line
  bool inLastLine() const; ///< whether no line end follows
  void nextLine();

  std::string_view word(); ///< up to the next blank; empty at the line's end

  /// Each returns whether a whole word of that kind came; if not, the cursor stays before it. Numbers too
  /// large for double become infinite, too small ones zero; "nan" and "inf" are numbers here.
  bool number(double& value);
  bool integer(long long& value);
  /// An OBJ corner "7", "7/1", "7//3" or "7/1/3": the first number; the others are passed over.
  bool corner(long long& value);

  /// The next word for a message: cut to 30 characters, control characters replaced.
  std::string wordForMessage();

private:
  void skipBlanks();
  bool breaksHere(const char* at) const;
  const char* behindLineEnd(const char* at) const;

  const char *m_begin, *m_at, *m_end;
  unsigned m_rules;
  long m_line = 1;
};

} // namespace esm
