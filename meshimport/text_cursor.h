// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/work_control.h"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace esm {

namespace text {

enum CharClass : unsigned char { Other = 0, Blank = 1, LineBreak = 2, Special = 4 };

/// What each byte means between words; one look in place of half a dozen comparisons.
inline constexpr auto kClass = [] {
  std::array<unsigned char, 256> classes{};
  for (const unsigned char c : {' ', '\t', '\v', '\f'}) classes[c] = Blank;
  for (const unsigned char c : {'\n', '\r'}) classes[c] = LineBreak;
  for (const unsigned char c : {'#', '\\'}) classes[c] = Special; // depends on the rules
  return classes;
}();

inline unsigned char classOf(char c)
{
  return kClass[static_cast<unsigned char>(c)];
}

inline bool isDigit(char c)
{
  return static_cast<unsigned char>(c - '0') < 10;
}

} // namespace text

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

  /// Over bytes that are no text. @pre so many are left
  void skipBytes(std::size_t count) { m_at += count; }

  /// Tells which share of the text is done and asks whether to stop; `control` may be null.
  bool stopWanted(WorkControl* control) const;

  bool atLineEnd() ///< whether nothing but blanks and a comment is left on this line
  {
    skipBlanks();
    return m_at == m_end || text::classOf(*m_at) == text::LineBreak ||
           ((m_rules & HashComments) && *m_at == '#');
  }
  bool inLastLine() const; ///< whether no line end follows
  void nextLine();

  std::string_view word(); ///< up to the next blank; empty at the line's end

  /// Each returns whether a whole word of that kind came; if not, the cursor stays before it. Numbers too
  /// large for double become infinite, too small ones zero; "nan" and "inf" are numbers here.
  bool number(double& value)
  {
    skipBlanks();
    return shortNumber(value) || anyNumber(value);
  }
  bool integer(long long& value);
  /// An OBJ corner "7", "7/1", "7//3" or "7/1/3": the first number; the others are passed over.
  bool corner(long long& value)
  {
    skipBlanks();
    long long digits = 0;
    const char* at = m_at;
    while (at != m_end && text::isDigit(*at) && at - m_at < 18) digits = 10 * digits + (*at++ - '0');
    if (at == m_at || !breaksHere(at)) return anyCorner(value);
    value = digits;
    m_at = at;
    return true;
  }

  /// The next word for a message: cut to 30 characters, control characters replaced.
  std::string wordForMessage();

private:
  void skipBlanks()
  {
    while (m_at != m_end && text::classOf(*m_at) == text::Blank) ++m_at;
    if (m_at != m_end && *m_at == '\\' && (m_rules & BackslashJoins)) skipJoints();
  }
  void skipJoints();
  bool breaksHere(const char* at) const;
  bool shortNumber(double& value);
  bool anyNumber(double& value);
  bool anyCorner(long long& value);
  const char* behindLineEnd(const char* at) const;

  const char *m_begin, *m_at, *m_end;
  unsigned m_rules;
  long m_line = 1;
};

/// Nearly all numbers of mesh files: an optional minus, at most 15 digits, a point somewhere, no exponent.
/// Both the digits and the power of ten are exact as double, so one division rounds as std::from_chars does
/// (W. D. Clinger, How to read floating point numbers accurately, PLDI 1990), in a third of its time.
inline bool TextCursor::shortNumber(double& value)
{
  constexpr double kPower[] = {1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                               1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
  constexpr std::ptrdiff_t kMostDigits = 15;
  const char* at = m_at;
  const bool negative = at != m_end && *at == '-';
  if (negative) ++at;
  const char* const first = at;
  std::uint64_t digits = 0;
  while (at != m_end && text::isDigit(*at) && at - first <= kMostDigits)
    digits = 10 * digits + static_cast<std::uint64_t>(*at++ - '0');
  std::ptrdiff_t count = at - first, decimals = 0;
  if (at != m_end && *at == '.') {
    const char* const behindPoint = ++at;
    while (at != m_end && text::isDigit(*at) && at - first <= kMostDigits + 1)
      digits = 10 * digits + static_cast<std::uint64_t>(*at++ - '0');
    decimals = at - behindPoint;
    count += decimals;
  }
  if (count == 0 || count > kMostDigits || !breaksHere(at)) return false;
  const double number = static_cast<double>(digits) / kPower[decimals];
  value = negative ? -number : number;
  m_at = at;
  return true;
}

/// Whether a word may end at `at`.
inline bool TextCursor::breaksHere(const char* at) const
{
  if (at == m_end) return true;
  const unsigned char kind = text::classOf(*at);
  if (kind != text::Special) return kind != text::Other;
  if (*at == '#') return (m_rules & HashComments) != 0;
  return (m_rules & BackslashJoins) != 0 && behindLineEnd(at + 1) != nullptr;
}

} // namespace esm
