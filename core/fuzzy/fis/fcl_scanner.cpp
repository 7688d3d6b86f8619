// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/fuzzy/fis/fcl_scanner.h"

#include <algorithm>

namespace esm::fis {

namespace {

bool isWordByte(char c)
{
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         static_cast<unsigned char>(c) >= 0x80;
}

} // namespace

void blankComments(std::string& text)
{
  const auto blank = [&](std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i)
      if (text[i] != '\n' && text[i] != '\r') text[i] = ' ';
    return to;
  };
  bool lineBegins = true;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    const std::string_view pair = std::string_view(text).substr(i, 2);
    if (c == '#' || pair == "//" || (c == '%' && lineBegins)) {
      i = blank(i, std::min(text.find_first_of("\r\n", i), text.size()));
    } else if (pair == "(*" || pair == "/*") {
      const std::size_t end = text.find(c == '(' ? "*)" : "*/", i + 2);
      if (end == std::string::npos) throw Fault{text.data() + i, "this comment never ends"};
      i = blank(i, end + 2);
    } else {
      if (static_cast<unsigned char>(c) > ' ') lineBegins = false;
      if (c == '\n' || c == '\r') lineBegins = true;
      ++i;
    }
  }
}

bool FclScanner::accept(std::string_view word)
{
  if (!is(word)) return false;
  advance();
  return true;
}

void FclScanner::expect(std::string_view word)
{
  if (!accept(word))
    throw Fault{m_word.data(),
                "here '" + std::string(word) + "' was expected" + (atEnd() ? "" : ", not " + shown(m_word))};
}

std::string_view FclScanner::take()
{
  const std::string_view word = m_word;
  if (word.empty()) throw Fault{m_word.data(), "the text ends too early"};
  advance();
  return word;
}

double FclScanner::number()
{
  const bool negative = accept("-");
  if (!negative) accept("+");
  const double value = readNumber(take());
  return negative ? -value : value;
}

std::string_view FclScanner::upTo(char sign)
{
  const std::size_t from = place();
  while (!atEnd() && !(m_word.size() == 1 && m_word[0] == sign)) advance();
  return trimmed(m_text.substr(from, place() - from));
}

std::string_view FclScanner::restOfStatement()
{
  const std::size_t from = place();
  std::size_t end = from;
  while (!atEnd() && !is(";") && !is("RULE") && !is("END_RULEBLOCK")) {
    end = place() + m_word.size();
    advance();
  }
  return m_text.substr(from, end - from);
}

void FclScanner::advance()
{
  while (m_next < m_text.size() && static_cast<unsigned char>(m_text[m_next]) <= ' ') ++m_next;
  std::size_t end = m_next;
  while (end < m_text.size() && (isWordByte(m_text[end]) || isInnerByte(end))) ++end;
  if (end == m_next && end < m_text.size()) {
    const std::string_view pair = m_text.substr(end, 2);
    end += pair == ":=" || pair == ".." ? 2 : 1;
  }
  m_word = m_text.substr(m_next, end - m_next);
  m_next = end;
}

/// A point within a number or name ("1.5", but not "0..10"), the sign of an exponent ("1e-5").
bool FclScanner::isInnerByte(std::size_t at) const
{
  if (m_text[at] == '.') return m_text.substr(at, 2) != ".." && (at == 0 || m_text[at - 1] != '.');
  if ((m_text[at] != '-' && m_text[at] != '+') || at < m_next + 2 ||
      (m_text[at - 1] != 'e' && m_text[at - 1] != 'E'))
    return false;
  const char first = m_text[m_next];
  return (first >= '0' && first <= '9') || first == '.';
}

} // namespace esm::fis
