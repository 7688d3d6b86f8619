// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "meshimport/text_cursor.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>

namespace esm {

namespace {

enum CharClass : unsigned char { Other = 0, Blank = 1, LineBreak = 2, Special = 4 };

/// What each byte means between words; one look in place of half a dozen comparisons.
constexpr auto kClass = [] {
  std::array<unsigned char, 256> classes{};
  for (const unsigned char c : {' ', '\t', '\v', '\f'}) classes[c] = Blank;
  for (const unsigned char c : {'\n', '\r'}) classes[c] = LineBreak;
  for (const unsigned char c : {'#', '\\'}) classes[c] = Special; // depends on the rules
  return classes;
}();

unsigned char classOf(char c)
{
  return kClass[static_cast<unsigned char>(c)];
}

bool isBlank(char c)
{
  return classOf(c) == Blank;
}

bool isLineBreak(char c)
{
  return classOf(c) == LineBreak;
}

/// What std::from_chars found beyond the range of double: endless or nothing?
double beyondRange(std::string_view digits)
{
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const bool negative = digits.front() == '-';
  const std::size_t exponent = digits.find_first_of("eE");
  const std::size_t significant = digits.find_first_of("123456789");
  const bool small = exponent != std::string_view::npos && exponent + 1 < digits.size()
                       ? digits[exponent + 1] == '-'
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

void TextCursor::skipBlanks()
{
  for (;;) {
    while (m_at != m_end && isBlank(*m_at)) ++m_at;
    if ((m_rules & BackslashJoins) == 0 || m_at == m_end || *m_at != '\\') return;
    const char* next = behindLineEnd(m_at + 1);
    if (!next) return;
    m_at = next;
    ++m_line;
  }
}

bool TextCursor::stopWanted(WorkControl* control) const
{
  if (!control) return false;
  tellDone(control, static_cast<double>(m_at - m_begin) / static_cast<double>(m_end - m_begin + 1));
  return esm::stopWanted(control);
}

bool TextCursor::atLineEnd()
{
  skipBlanks();
  return m_at == m_end || isLineBreak(*m_at) || ((m_rules & HashComments) && *m_at == '#');
}

bool TextCursor::inLastLine() const
{
  return std::none_of(m_at, m_end, isLineBreak);
}

void TextCursor::nextLine()
{
  while (m_at != m_end && !isLineBreak(*m_at)) ++m_at;
  if (const char* next = behindLineEnd(m_at)) {
    m_at = next;
    ++m_line;
  }
}

bool TextCursor::breaksHere(const char* at) const
{
  if (at == m_end) return true;
  const unsigned char kind = classOf(*at);
  if (kind != Special) return kind != Other;
  if (*at == '#') return (m_rules & HashComments) != 0;
  return (m_rules & BackslashJoins) != 0 && behindLineEnd(at + 1) != nullptr;
}

std::string_view TextCursor::word()
{
  skipBlanks();
  const char* from = m_at;
  while (!breaksHere(m_at)) ++m_at;
  return {from, static_cast<std::size_t>(m_at - from)};
}

bool TextCursor::number(double& value)
{
  skipBlanks();
  const char* from = skipPlus(m_at, m_end);
  const auto [to, code] = std::from_chars(from, m_end, value);
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

bool TextCursor::corner(long long& value)
{
  skipBlanks();
  auto [to, code] = std::from_chars(skipPlus(m_at, m_end), m_end, value);
  if (code != std::errc{}) return false;
  if (to != m_end && *to == '/')
    while (to != m_end && ((*to >= '0' && *to <= '9') || *to == '/' || *to == '-' || *to == '+')) ++to;
  if (!breaksHere(to)) return false;
  m_at = to;
  return true;
}

std::string TextCursor::wordForMessage()
{
  std::string text(word().substr(0, 30));
  const auto isControl = [](char c) { return static_cast<unsigned char>(c) < 32 || c == 127; };
  std::replace_if(text.begin(), text.end(), isControl, '?');
  return text;
}

} // namespace esm
