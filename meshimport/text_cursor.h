// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/work_control.h"

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
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

/// Reads digits at `at` on to `value`, which becomes value * 10^n + digits; of more than 15 only the
/// first 16.
/// @return behind the last one read
inline const char* takeDigits(const char* at, const char* end, std::uint64_t& value)
{
  static constexpr std::uint64_t kPower[] = {1, 10, 100, 1000, 10000, 100000, 1000000, 10000000, 100000000};
  const char* const from = at;
  if constexpr (std::endian::native == std::endian::little) {
    // Eight bytes as one word: a loop over digits is left at another place each time, which the processor
    // cannot foresee.
    for (int word = 0; word < 2 && end - at >= 8; ++word) {
      std::uint64_t d = 0;
      std::memcpy(&d, at, sizeof d);
      d ^= 0x3030303030303030;                                                          // '0' becomes 0
      const std::uint64_t others = ((d + 0x7676767676767676) | d) & 0x8080808080808080; // above 9
      const int count = others == 0 ? 8 : std::countr_zero(others) / 8;
      if (count == 0) return at;
      d <<= 8 * (8 - count); // zeros in front
      d = 10 * d + (d >> 8); // pairs, then fours, then all
      d = ((d & 0x000000FF000000FF) * 0x000F424000000064 +
           ((d >> 16 & 0x000000FF000000FF) * 0x0000271000000001)) >>
          32;
      value = kPower[count] * value + d;
      at += count;
      if (count < 8) return at;
    }
  }
  while (at != end && at - from < 16 && isDigit(*at))
    value = 10 * value + static_cast<std::uint64_t>(*at++ - '0');
  return at;
}

} // namespace text

/// Walks through the bytes of a text mesh file, word by word and line by line, in one pass and without
/// copies. Lines end with LF, CR LF or CR. Numbers have a point whatever the locale, and may have
/// Fortran's exponents.
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
  void nextLine()
  {
    if (m_at == m_end || *m_at != '\n') return skipLine();
    ++m_at; // as a rule all of the line has been read
    ++m_line;
  }

  std::string_view word(); ///< up to the next blank; empty at the line's end
  /// Goes behind the next word on this line if it is this one, letter by letter.
  template <std::size_t kSize>
  bool take(const char (&keyword)[kSize])
  {
    constexpr std::size_t kLetters = kSize - 1; // known here, so that they are compared as one number
    skipBlanks();
    if (static_cast<std::size_t>(m_end - m_at) < kLetters || std::memcmp(m_at, keyword, kLetters) != 0 ||
        !breaksHere(m_at + kLetters))
      return false;
    m_at += kLetters;
    return true;
  }

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
    std::uint64_t digits = 0;
    const char* const at = text::takeDigits(m_at, m_end, digits);
    if (at == m_at || !breaksHere(at)) return anyCorner(value);
    value = static_cast<long long>(digits);
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
  void skipLine();
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

/// What to say of the lines from here up to one that begins with `end` (to the last one if that is empty), where a
/// count promised no more than what was read; empty if there are none.
/// @param promised "3 promised faces"
std::string linesBehind(TextCursor cursor, const std::string& promised, std::string_view end = {});

/// Nearly all numbers of mesh files: an optional minus, at most 15 digits, a point somewhere, no exponent.
/// Both the digits and the power of ten are exact as double, so one division rounds as std::from_chars does
/// (W. D. Clinger, How to read floating point numbers accurately, PLDI 1990), in a third of its time.
inline bool TextCursor::shortNumber(double& value)
{
  static constexpr double kPower[] = {1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                      1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
  constexpr std::ptrdiff_t kMostDigits = 15;
  const char* at = m_at;
  const bool negative = at != m_end && *at == '-';
  if (negative) ++at;
  const char* const first = at;
  std::uint64_t digits = 0;
  at = text::takeDigits(at, m_end, digits);
  std::ptrdiff_t count = at - first, decimals = 0;
  if (at != m_end && *at == '.') {
    const char* const behindPoint = ++at;
    at = text::takeDigits(at, m_end, digits);
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
