// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/base/csv_reader.h"

#include "core/base/ascii_case.h"
#include "core/base/text_encoding.h"
#include "core/base/text_number.h"

#include <algorithm>

namespace esm {

namespace {

bool isDigits(std::string_view text)
{
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

std::string_view withoutSign(std::string_view text)
{
  if (!text.empty() && (text[0] == '-' || text[0] == '+')) text.remove_prefix(1);
  return text;
}

/// "2,500", which may be 2.5 or 2500; "0,125" cannot.
bool mayBeThousands(std::string_view text)
{
  text = withoutSign(text);
  const std::size_t comma = text.find(',');
  const std::string_view whole = text.substr(0, comma), rest = text.substr(comma + 1);
  return isDigits(whole) && whole.size() <= 3 && whole[0] != '0' && isDigits(rest) && rest.size() == 3;
}

/// "1,002.5", "1.002,5", "1 002,5", "1'002.5": groups of three digits and a decimal sign of another kind, or
/// more than one group.
bool hasThousands(std::string_view text)
{
  text = withoutSign(text);
  const std::size_t first = std::min(text.find_first_not_of("0123456789"), text.size());
  constexpr std::string_view kSigns[] = {",", ".", "'", " ", "\u00A0", "\u202F", "\u2019"};
  const auto* const sign = std::find_if(std::begin(kSigns), std::end(kSigns), [&](std::string_view known) {
    return text.substr(first, known.size()) == known;
  });
  if (first == 0 || first > 3 || sign == std::end(kSigns)) return false;
  const auto isGroup = [&] {
    const std::string_view digits = text.substr(std::min(sign->size(), text.size()), 3);
    return text.substr(0, sign->size()) == *sign && digits.size() == 3 && isDigits(digits);
  };
  int groups = 0;
  text.remove_prefix(first);
  for (; isGroup(); ++groups) text.remove_prefix(sign->size() + 3);
  const bool isDecimalSign = *sign == "," || *sign == ".";
  const bool hasFraction = !text.empty() && (text[0] == ',' || text[0] == '.') && isDigits(text.substr(1));
  return hasFraction ? groups > 0 : text.empty() && groups > (isDecimalSign ? 1 : 0);
}

std::string inQuotes(std::string_view text)
{
  return '\'' + std::string(text.substr(0, 60)) + (text.size() > 60 ? "...'" : "'");
}

} // namespace

Result<CsvReader> CsvReader::open(std::string_view bytes, std::string fileName)
{
  CsvReader reader(toUtf8(bytes), std::move(fileName));
  if (const Status status = reader.readHeader(); !status) return status.error();
  return reader;
}

Status CsvReader::readHeader()
{
  const std::size_t lineEnd = std::min(m_text.find_first_of("\r\n"), m_text.size());
  const std::string_view first = std::string_view(m_text).substr(0, lineEnd);
  if (first.size() == 5 && equalIgnoringCase(first.substr(0, 4), "sep=")) { // as Excel writes and asks for
    m_separator = first[4];
    m_next = lineEnd;
  } else {
    chooseSeparator();
  }
  while (readRecord(m_header, m_separator)) {
    while (!m_header.cells.empty() && m_header.cells.back().empty()) m_header.cells.pop_back();
    if (!m_header.cells.empty()) return {};
  }
  if (!m_fault.empty()) return error(m_header, m_fault);
  return Error{ErrorCode::EmptyResult, m_file + ": holds no table"};
}

/// The sign in the header with which most of the rows that follow are as wide as it is.
void CsvReader::chooseSeparator()
{
  constexpr int kRows = 50;
  int bestScore = -1;
  for (const char candidate : {';', ',', '\t'}) {
    CsvReader trial(m_text.substr(0, std::min<std::size_t>(m_text.size(), 1U << 16U)), m_file);
    CsvRow head, row;
    while (trial.readRecord(head, candidate) && head.cells.size() == 1 && head.cells[0].empty()) continue;
    if (head.cells.size() < 2) continue;
    int score = 0;
    for (int i = 0; i < kRows && trial.readRecord(row, candidate); ++i)
      score += row.cells.size() == head.cells.size() ? 1 : 0;
    if (score > bestScore) bestScore = score, m_separator = candidate;
  }
}

Result<bool> CsvReader::next(CsvRow& row)
{
  while (readRecord(row, m_separator)) {
    const bool blank =
      std::all_of(row.cells.begin(), row.cells.end(), [](const std::string& cell) { return cell.empty(); });
    if (blank) continue;
    m_lastLine = row.line;
    const std::size_t width = m_header.cells.size();
    while (row.cells.size() > width && row.cells.back().empty()) row.cells.pop_back();
    if (row.cells.size() == width) return true;
    return error(row, std::min(row.cells.size(), width),
                 "the row has " + std::to_string(row.cells.size()) + " cells, the header " +
                   std::to_string(width) + hintAtCommas(row));
  }
  if (!m_fault.empty()) return error(row, m_fault);
  return false;
}

std::string CsvReader::hintAtCommas(const CsvRow& row) const
{
  if (m_separator != ',') return {};
  for (std::size_t i = 0; i + 1 < row.cells.size(); ++i)
    if (isDigits(withoutSign(row.cells[i])) && isDigits(row.cells[i + 1]))
      return "; are there decimal commas? Then put such cells in quotes, separate cells by semicolons, or "
             "write points";
  return {};
}

/// One record from m_next on; false at the end, or with m_fault.
bool CsvReader::readRecord(CsvRow& row, char separator)
{
  const std::string_view text = m_text;
  const auto isBlank = [&](char c) { return c == ' ' || (c == '\t' && separator != '\t'); };
  const auto endsLine = [&] { return m_next >= text.size() || text[m_next] == '\n' || text[m_next] == '\r'; };
  if (m_next >= text.size()) return false;
  row.cells.clear();
  row.line = m_line;
  for (;;) {
    while (!endsLine() && isBlank(text[m_next])) ++m_next;
    std::string cell;
    if (!endsLine() && text[m_next] == '"') {
      for (++m_next;; ++m_next) {
        if (m_next >= text.size()) {
          m_fault = "a quote begins a cell here that never ends";
          return false;
        }
        if (text[m_next] == '"' && text.substr(m_next, 2) != "\"\"") break;
        if (text[m_next] == '"') ++m_next;
        if (text[m_next] == '\n') ++m_line;
        cell += text[m_next];
      }
      ++m_next;
      while (!endsLine() && isBlank(text[m_next])) ++m_next;
      if (!endsLine() && text[m_next] != separator) {
        m_fault = "behind a cell in quotes more text follows";
        m_next = text.size();
        return false;
      }
    } else {
      while (!endsLine() && text[m_next] != separator) cell += text[m_next++];
      while (!cell.empty() && isBlank(cell.back())) cell.pop_back();
    }
    row.cells.push_back(std::move(cell));
    if (endsLine()) break;
    ++m_next; // the separator
  }
  if (m_next < text.size()) m_next += text.substr(m_next, 2) == "\r\n" ? 2 : 1;
  ++m_line;
  return true;
}

CsvNumber CsvReader::number(std::string_view text)
{
  using Kind = CsvNumber::Kind;
  const std::size_t comma = text.find(',');
  if (hasThousands(text))
    return {Kind::Unclear, 0.0, inQuotes(text) + " has signs between its thousands; write it without them"};
  if (comma == std::string_view::npos) {
    const auto value = parseForeignDouble(text);
    if (!value) return {Kind::Text};
    if (text.find('.') == std::string_view::npos) return {Kind::Number, *value};
    if (m_pointLine == 0) m_pointLine = m_lastLine;
    if (m_commaLine == 0) return {Kind::Number, *value};
    return {Kind::Unclear, 0.0,
            inQuotes(text) + " has a decimal point, line " + std::to_string(m_commaLine) +
              " a decimal comma; write one of both throughout"};
  }
  std::string withPoint(text);
  withPoint[comma] = '.';
  const auto value = text.find('.') == std::string_view::npos ? parseForeignDouble(withPoint) : std::nullopt;
  if (!value) return {Kind::Text};
  if (m_separator != ';' && m_separator != '\t' && mayBeThousands(text)) {
    std::string joined(text);
    joined.erase(comma, 1);
    return {Kind::Unclear, 0.0,
            inQuotes(text) + " may be " + formatDouble(*value) + " or " + joined +
              "; write a decimal point, or separate cells by semicolons"};
  }
  if (m_commaLine == 0) m_commaLine = m_lastLine;
  if (m_pointLine == 0) return {Kind::Number, *value};
  return {Kind::Unclear, 0.0,
          inQuotes(text) + " has a decimal comma, line " + std::to_string(m_pointLine) +
            " a decimal point; write one of both throughout"};
}

Error CsvReader::error(const CsvRow& row, std::size_t column, const std::string& what) const
{
  return error(row, "column " + std::to_string(column + 1) + ": " + what);
}

Error CsvReader::error(const CsvRow& row, const std::string& what) const
{
  return {ErrorCode::BadFormat, m_file + ':' + std::to_string(row.line) + ": " + what};
}

char CsvReader::separatorToWrite() const noexcept
{
  if (m_separator != '\0') return m_separator;
  return decimalComma() ? ';' : ',';
}

std::string csvCell(std::string_view cell, char separator)
{
  const bool plain = cell.find_first_of("\"\r\n") == std::string_view::npos &&
                     cell.find(separator) == std::string_view::npos &&
                     (cell.empty() || (cell.front() != ' ' && cell.back() != ' '));
  if (plain) return std::string(cell);
  std::string text = "\"";
  for (const char c : cell) text += c == '"' ? std::string("\"\"") : std::string(1, c);
  return text + '"';
}

} // namespace esm
