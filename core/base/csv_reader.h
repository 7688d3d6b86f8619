// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"

#include <string>
#include <string_view>
#include <vector>

namespace esm {

/// One row of a table: its cells as UTF-8, without quotes and without blanks beside separators.
struct CsvRow {
  std::vector<std::string> cells;
  int line = 0; ///< where it begins, from 1
};

/// What a cell says when a number is wanted.
struct CsvNumber {
  enum class Kind {
    Number,
    Text,   ///< no number
    Unclear ///< a number, but which: `why` tells, with the way out
  } kind = Kind::Text;
  double value = 0.0;
  std::string why{};
};

/// Reads a table with a header as spreadsheets write it, row by row (RFC 4180 and what is usual beside it):
///
///     cells      between commas, semicolons or tabs, which the header decides ("sep=;" before it, too)
///     quotes     "a, b" and "say ""hard""", over several lines
///     passed over   byte order marks, blanks beside separators, blank lines, empty columns at the end
///     encoding   UTF-8, UTF-16 with its mark, else Windows-1252
///     numbers    with a decimal point, or with a decimal comma; one of both in one table
///
/// A comma that may separate cells, decimals or thousands is never guessed: CsvNumber::Kind::Unclear.
class CsvReader {
public:
  /// Reads the header. Errors: EmptyResult without one; BadFormat, "file:line: ...", for quotes that do not
  /// end.
  static Result<CsvReader> open(std::string_view bytes, std::string fileName);

  const CsvRow& header() const noexcept { return m_header; }
  /// The next row that is not blank, with as many cells as the header; false at the end. Errors: BadFormat.
  Result<bool> next(CsvRow& row);
  /// A cell, or a part of one, as a number.
  CsvNumber number(std::string_view text);

  /// "file:line: column N: what", the column from 0.
  Error error(const CsvRow& row, std::size_t column, const std::string& what) const;
  /// "file:line: what".
  Error error(const CsvRow& row, const std::string& what) const;

  /// Whether numbers so far had decimal commas.
  bool decimalComma() const noexcept { return m_commaLine > 0; }
  /// What separates cells when a table in the same style is written.
  char separatorToWrite() const noexcept;

private:
  CsvReader(std::string text, std::string fileName) : m_text(std::move(text)), m_file(std::move(fileName)) {}
  Status readHeader();
  void chooseSeparator();
  bool readRecord(CsvRow& row, char separator);
  std::string hintAtCommas(const CsvRow& row) const;

  std::string m_text, m_file;
  std::size_t m_next = 0;
  int m_line = 1;
  CsvRow m_header;
  char m_separator = '\0';              ///< none: the table has one column
  int m_lastLine = 1;                   ///< of the row read last
  int m_pointLine = 0, m_commaLine = 0; ///< where such a decimal sign was seen first
  std::string m_fault;
};

/// A cell as it stands in a table: in quotes where it needs them.
std::string csvCell(std::string_view cell, char separator);

} // namespace esm
