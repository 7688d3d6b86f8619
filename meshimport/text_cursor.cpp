// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "meshimport/text_cursor.h"

#include "core/base/text_number.h"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <limits>

namespace esm {

namespace {

using text::classOf;

bool isBlank(char c)
{
  return classOf(c) == text::Blank;
}

bool isLineBreak(char c)
{
  return classOf(c) == text::LineBreak;
}

/// What std::from_chars found beyond the range of double: endless or nothing?
double beyondRange(std::string_view digits)
{
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const bool negative = digits.front() == '-';
  const std::size_t exponent = digits.find_first_of("eEdD+-", 1); // Fortran's may lack the letter
  const std::size_t significant = digits.find_first_of("123456789");
  const bool small = exponent != std::string_view::npos ? digits.find('-', exponent) != std::string_view::npos
                                                        : significant > digits.find('.');
  if (small) return negative ? -0.0 : 0.0;
  return negative ? -kInfinity : kInfinity;
}

/// std::from_chars knows no leading '+', which many exporters write.
const char* skipPlus(const char* at, const char* end)
{
  const bool plus = at + 1 < end && *at == '+' && at[1] != '-';
  return plus ? at + 1 : at;
}

} // namespace

TextCursor::TextCursor(std::string_view text, unsigned rules)
  : m_begin(text.data()), m_at(text.data()), m_end(text.data() + text.size()), m_rules(rules)
{
  if (text.substr(0, 3) == "\xEF\xBB\xBF") m_at += 3;
}

/// Just behind the line end at `at`, or null if there is none.
const char* TextCursor::behindLineEnd(const char* at) const
{
  if (at == m_end || !isLineBreak(*at)) return nullptr;
  const bool pair = *at == '\r' && at + 1 != m_end && at[1] == '\n';
  return at + (pair ? 2 : 1);
}

/// Past joints of lines and the blanks behind them.
void TextCursor::skipJoints()
{
  while (m_at != m_end && *m_at == '\\') {
    const char* next = behindLineEnd(m_at + 1);
    if (!next) return;
    m_at = next;
    ++m_line;
    while (m_at != m_end && isBlank(*m_at)) ++m_at;
  }
}

bool TextCursor::stopWanted(WorkControl* control) const
{
  if (!control) return false;
  tellDone(control, static_cast<double>(m_at - m_begin) / static_cast<double>(m_end - m_begin + 1));
  return esm::stopWanted(control);
}

bool TextCursor::inLastLine() const
{
  return std::none_of(m_at, m_end, isLineBreak);
}

void TextCursor::skipLine()
{
  // Short rests are passed byte by byte; a long one by the library's vector code, first to LF, then back to a
  // CR.
  const char* const nearby = m_end - m_at > 8 ? m_at + 8 : m_end;
  while (m_at != nearby && !isLineBreak(*m_at)) ++m_at;
  if (m_at == nearby && m_at != m_end && !isLineBreak(*m_at)) {
    const auto find = [this](char c, const char* end) {
      const void* found = std::memchr(m_at, c, static_cast<std::size_t>(end - m_at));
      return found ? static_cast<const char*>(found) : end;
    };
    m_at = find('\r', std::min(m_end, find('\n', m_end)));
  }
  if (const char* next = behindLineEnd(m_at)) {
    m_at = next;
    ++m_line;
  }
}

std::string_view TextCursor::word()
{
  skipBlanks();
  const char* from = m_at;
  while (!breaksHere(m_at)) ++m_at;
  return {from, static_cast<std::size_t>(m_at - from)};
}

bool TextCursor::anyNumber(double& value)
{
  const char* from = skipPlus(m_at, m_end);
  const auto [to, code] = foreignDoubleFromChars(from, m_end, value);
  if (code == std::errc::invalid_argument || !breaksHere(to)) return false;
  if (code == std::errc::result_out_of_range)
    value = beyondRange({from, static_cast<std::size_t>(to - from)});
  m_at = to;
  return true;
}

bool TextCursor::integer(long long& value)
{
  skipBlanks();
  const auto [to, code] = std::from_chars(skipPlus(m_at, m_end), m_end, value);
  if (code != std::errc{} || !breaksHere(to)) return false;
  m_at = to;
  return true;
}

bool TextCursor::anyCorner(long long& value)
{
  auto [to, code] = std::from_chars(skipPlus(m_at, m_end), m_end, value);
  if (code != std::errc{}) return false;
  if (to != m_end && *to == '/')
    while (to != m_end && ((*to >= '0' && *to <= '9') || *to == '/' || *to == '-' || *to == '+')) ++to;
  if (!breaksHere(to)) return false;
  m_at = to;
  return true;
}

std::string linesBehind(TextCursor cursor, const std::string& promised, std::string_view end)
{
  std::size_t count = 0;
  long first = 0;
  for (; !cursor.atEnd(); cursor.nextLine()) {
    if (cursor.atLineEnd()) continue;
    if (!end.empty() && cursor.rest().substr(0, end.size()) == end) break;
    if (count++ == 0) first = cursor.line();
  }
  if (count == 0) return {};
  return std::to_string(count) + " lines behind the " + promised + " were passed over, the first is line " +
         std::to_string(first);
}

std::string TextCursor::wordForMessage()
{
  std::string text(word().substr(0, 30));
  const auto isControl = [](char c) { return static_cast<unsigned char>(c) < 32 || c == 127; };
  std::replace_if(text.begin(), text.end(), isControl, '?');
  return text;
}

} // namespace esm
