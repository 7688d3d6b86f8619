// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/base/csv_reader.h"
#include "core/base/text_encoding.h"

#include <gtest/gtest.h>

#include <random>

namespace esm {

namespace {

using Rows = std::vector<std::vector<std::string>>;

/// The header and all rows, or the error as the only cell.
Rows rowsOf(std::string_view text)
{
  Result<CsvReader> reader = CsvReader::open(text, "t.csv");
  if (!reader) return {{reader.error().detail}};
  Rows rows = {reader->header().cells};
  for (CsvRow row;;) {
    const Result<bool> more = reader->next(row);
    if (!more) return {{more.error().detail}};
    if (!*more) return rows;
    rows.push_back(row.cells);
  }
}

/// The numbers of all cells below the header, "?" for text, or why one is unclear.
std::string numbersOf(std::string_view text)
{
  Result<CsvReader> reader = CsvReader::open(text, "t.csv");
  std::string result;
  for (CsvRow row; reader && *reader->next(row);)
    for (const std::string& cell : row.cells) {
      const CsvNumber number = reader->number(cell);
      if (number.kind == CsvNumber::Kind::Unclear) return number.why;
      result += number.kind == CsvNumber::Kind::Text ? "? " : std::to_string(number.value).substr(0, 5) + ' ';
    }
  return result;
}

} // namespace

// One table in the styles of spreadsheets: which program and region wrote it does not change what it says.
TEST(CsvReader, StylesOfSpreadsheetsSayTheSame)
{
  const Rows table = {{"a", "b c"}, {"1", "x, y"}, {"2", "say \"so\""}};
  for (const char* text :
       {"a,b c\n1,\"x, y\"\n2,\"say \"\"so\"\"\"\n", "a;b c\n1;x, y\n2;say \"so\"\n",
        "a\tb c\r\n1\tx, y\r\n2\tsay \"so\"\r\n", "sep=;\r\na;b c\r\n1;x, y\r\n2;say \"so\"",
        "\xEF\xBB\xBF\"a\",\"b c\"\n\"1\",\"x, y\"\n\"2\",\"say \"\"so\"\"\"",
        "\n\n a , b c \n\n 1 , \"x, y\" \n,\n  \n2, \"say \"\"so\"\"\" ,\n\n",
        "a;b c;;\n1;x, y;;\n2;say \"so\";;\n", "a;b c\r1;x, y\r2;say \"so\"\r"})
    EXPECT_EQ(rowsOf(text), table) << text;
  std::string wide = "\xFF\xFE";
  for (const char c : std::string_view("a\tb c\r\n1\tx, y\r\n2\tsay \"so\"\r\n")) (wide += c) += '\0';
  EXPECT_EQ(rowsOf(wide), table) << "UTF-16 with tabs, Excel's \"Unicode text\"";
}

TEST(CsvReader, CellsInQuotesHoldLinesAndFaultsNameTheirLine)
{
  EXPECT_EQ(rowsOf("a,b\n\"1\n2\",3\n"), (Rows{{"a", "b"}, {"1\n2", "3"}}));
  EXPECT_EQ(rowsOf("a,b\n\"1\n2\",3\n4\n")[0][0], "t.csv:4: column 2: the row has 1 cells, the header 2");
  EXPECT_EQ(rowsOf("a,b\n\"1,2\n")[0][0], "t.csv:2: a quote begins a cell here that never ends");
  EXPECT_EQ(rowsOf("a,b\n\"1\"x,2\n")[0][0], "t.csv:2: behind a cell in quotes more text follows");
  EXPECT_EQ(rowsOf("\n\n")[0][0], "t.csv: holds no table");
}

// A comma in a header of semicolons, or the reverse: the rows decide.
TEST(CsvReader, TheSeparatorIsTheOneThatFitsTheRows)
{
  EXPECT_EQ(rowsOf("x, m;y, m;note\n1;2;3\n")[1].size(), 3U);
  EXPECT_EQ(rowsOf("x,y; old\n1,2\n")[0], (std::vector<std::string>{"x", "y; old"}));
  EXPECT_EQ(rowsOf("a\tb, c\n1\t2\n")[0], (std::vector<std::string>{"a", "b, c"}));
}

TEST(CsvReader, NumbersHavePointsOrCommasButNotBoth)
{
  EXPECT_EQ(numbersOf("a;b\n2,5;-0,125\n5;1,5E-1\n"), "2.500 -0.12 5.000 0.150 ");
  EXPECT_EQ(numbersOf("a\n2,5\n5\n"), "2.500 5.000 ");
  EXPECT_EQ(numbersOf("a;b\n2.5D+00;1\n1.25d-1;1\n"), "2.500 1.000 0.125 1.000 "); // of a Fortran program
  EXPECT_EQ(numbersOf("a\n\"2,5\"\n5\n"), "2.500 5.000 ");
  EXPECT_EQ(numbersOf("a,b\n2.5,x\n+5,1e-1\n"), "2.500 ? 5.000 0.100 ");
  EXPECT_EQ(numbersOf("a;b\n1,23,4;1,2,3\n"), "? ? ");
  EXPECT_EQ(numbersOf("a;b\n2,5;1\n1.5;1\n"),
            "'1.5' has a decimal point, line 2 a decimal comma; write one of both throughout");
  EXPECT_EQ(numbersOf("a;b\n2.5;1\n1,5;1\n"),
            "'1,5' has a decimal comma, line 2 a decimal point; write one of both throughout");
}

// "2,500" is two and a half in Berlin and two thousand five hundred in Boston.
TEST(CsvReader, AmbiguousCommasAreNamedNotGuessed)
{
  EXPECT_EQ(numbersOf("a,b\n\"2,500\",1\n"), "'2,500' may be 2.5 or 2500; write a decimal point, or separate "
                                             "cells by semicolons");
  EXPECT_EQ(numbersOf("a;b\n2,500;1\n"), "2.500 1.000 ");
  EXPECT_EQ(numbersOf("a,b\n\"0,125\",1\n"), "0.125 1.000 ");
  EXPECT_EQ(
    rowsOf("a,b\n2,5,x\n")[0][0],
    "t.csv:2: column 3: the row has 3 cells, the header 2; are there decimal commas? Then put such cells "
    "in quotes, separate cells by semicolons, or write points");
}

// Groups of three digits with a sign of their own between them.
TEST(CsvReader, ThousandsSetApartAreNamedNotGuessed)
{
  for (const std::string number : {"1.234,5", "1,234.5", "1'234.5", "1 234,5", "1\u00A0234", "-12\u202F345,6",
                                   "1.234.567", "1\u2019234.5"})
    EXPECT_EQ(numbersOf("a;b\n" + number + ";1\n"),
              "'" + number + "' has signs between its thousands; write it without them");
  EXPECT_EQ(numbersOf("a;b\n1.234;1\n"), "1.234 1.000 ");
  EXPECT_EQ(numbersOf("a;b\n1 23;12 3456\n"), "? ? ");
}

TEST(CsvReader, CellsAreWrittenSoThatTheyAreReadBack)
{
  for (const char separator : {',', ';', '\t'})
    for (const std::string cell : {"plain", "a, b", "a;b", "a\tb", "say \"so\"", "two\nlines", " blank "}) {
      const std::string sign(1, separator);
      const Rows rows = rowsOf("a" + sign + "b\n" + csvCell(cell, separator) + sign + "1\n");
      EXPECT_EQ(rows.at(1), (std::vector<std::string>{cell, "1"})) << cell;
    }
}

// Whatever the bytes are, reading ends, and every row is as wide as the header.
TEST(CsvReader, AnyBytesEndInRowsOrAnError)
{
  std::mt19937 random(5);
  constexpr std::string_view kBits = "\"\"\"ab12.;,,\t\r\n\n -e\xE4\xC3\xFF";
  int read = 0;
  for (int i = 0; i < 4000; ++i) {
    std::string text = i % 3 == 0 ? "a;b\n" : i % 3 == 1 ? "a,b\n" : "";
    for (auto length = random() % 60; length > 0; --length) text += kBits[random() % kBits.size()];
    Result<CsvReader> reader = CsvReader::open(text, "t.csv");
    if (!reader) continue;
    CsvRow row;
    for (Result<bool> more = reader->next(row); more && *more; more = reader->next(row), ++read) {
      ASSERT_EQ(row.cells.size(), reader->header().cells.size()) << text;
      for (const std::string& cell : row.cells) {
        EXPECT_TRUE(isUtf8(cell));
        (void)reader->number(cell);
      }
    }
  }
  EXPECT_GT(read, 300);
}

// The euro sign, an umlaut and a clef beyond 16 bits, as each encoding has them.
TEST(TextEncoding, EveryEncodingBecomesUtf8)
{
  EXPECT_EQ(toUtf8("h\xE4rte \x80"), "h\xC3\xA4rte \xE2\x82\xAC");
  EXPECT_EQ(toUtf8("h\xC3\xA4rte"), "h\xC3\xA4rte");
  EXPECT_EQ(toUtf8("\xEF\xBB\xBFx"), "x");
  EXPECT_EQ(toUtf8(std::string_view("\xFF\xFE\xE4\0\x34\xD8\x1E\xDD", 8)), "\xC3\xA4\xF0\x9D\x84\x9E");
  EXPECT_EQ(toUtf8(std::string_view("\xFE\xFF\0\xE4\xD8\x34", 6)), "\xC3\xA4\xEF\xBF\xBD") << "half a pair";
  for (const char* wrong : {"\xC0\xAF", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\xE2\x82", "\x80"})
    EXPECT_FALSE(isUtf8(wrong));
  EXPECT_TRUE(isUtf8("\xF4\x8F\xBF\xBF"));
}

} // namespace esm
