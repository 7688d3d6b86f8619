// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

// Internal to the readers of core/fuzzy/fis.
#include "core/base/ascii_case.h"
#include "core/fuzzy/fis/system.h"

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace esm::fis {

/// Thrown within a reader, never out of it: what is wrong, and at which byte of the source.
struct Fault {
  const char* at;
  std::string message;
};

/// A source text of which all words are views, so that each knows its line and column.
class SourceText {
public:
  SourceText(std::string_view text, std::string_view fileName) : m_text(text), m_fileName(fileName) {}

  /// The next line without its end, or nothing. CR LF, CR and LF end a line.
  bool nextLine(std::string_view& line);
  /// "file:line:column: message", the column in characters from 1.
  Error error(const Fault& fault) const;
  std::string_view text() const { return m_text; }
  std::string_view fileName() const { return m_fileName; }

private:
  std::string_view m_text, m_fileName;
  std::size_t m_next = 0;
};

/// Gathers what a reader passed over or took otherwise than written, each with its place.
class Notes {
public:
  Notes(const SourceText& source, std::vector<std::string>* list) : m_source(source), m_list(list) {}
  /// @param at a byte of the source; null for the whole file
  void add(const char* at, const std::string& what);

private:
  const SourceText& m_source;
  std::vector<std::string>* m_list;
};

/// Keys that count once. Of one that is given again the last value holds, as with the programs whose formats
/// these are, and a note names the one that is passed over.
class OnceKeys {
public:
  explicit OnceKeys(Notes& notes) : m_notes(notes) {}
  /// @param owner what the key belongs to, as "'tip'"; empty: the whole system
  /// @param value its place is that of the note
  void give(std::string_view key, const std::string& owner, std::string_view value);
  void forget() { m_given.clear(); }

private:
  Notes& m_notes;
  std::map<std::pair<std::string, std::string>, std::string_view> m_given;
};

std::string_view trimmed(std::string_view text);
/// Cuts the first word (up to a blank) off the text.
std::string_view takeWord(std::string_view& text);
/// A name in a message, not too long.
std::string shown(std::string_view text);

double readNumber(std::string_view word); ///< throws Fault
int readCount(std::string_view word);     ///< a whole number from 0 on, maybe written 1.000
/// A number or an expression without variables: "-pi/4".
double readExpression(std::string_view text);

/// Runs a reader: what it returns is checked, a Fault becomes the error with its place.
template <class Read>
Result<System> runReader(const SourceText& source, const Read& read)
{
  try {
    System system = read();
    if (Status status = checkSystem(system); !status)
      return source.error({source.text().data() + source.text().size(), status.error().detail});
    return system;
  } catch (const Fault& fault) {
    return source.error(fault);
  }
}

/// Reads "if ... then ... with 0.5" over the variables of a system, which must be complete.
///
///     any         := all (or all)*
///     all         := one (and one)*
///     one         := not one | '(' any ')' | proposition
///     proposition := variable is hedge* term
///
/// "not" before a variable is the hedge before its term. @param asFcl keywords and hedges in any case, commas
/// between conclusions. @param mixed gets the place of an "and" behind an "or" without brackets, if there is
/// one
Rule readRule(std::string_view text, const System& system, bool asFcl, const char** mixed = nullptr);

} // namespace esm::fis
