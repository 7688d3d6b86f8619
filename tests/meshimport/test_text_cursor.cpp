// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "meshimport/text_cursor.h"

#include <gtest/gtest.h>

#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <random>

namespace {

using namespace esm;

std::optional<double> numberOf(std::string_view text)
{
  TextCursor cursor(text, TextCursor::HashComments);
  double value = 0.0;
  return cursor.number(value) ? std::optional(value) : std::nullopt;
}

TEST(TextCursor, readsEveryDialectOfNumbersWithAPoint)
{
  EXPECT_EQ(numberOf("1.5"), 1.5);
  EXPECT_EQ(numberOf("  +.5 7"), 0.5);
  EXPECT_EQ(numberOf("4.#"), 4.0);
  EXPECT_EQ(numberOf("-1E-3\r\n"), -1e-3);
  EXPECT_EQ(numberOf("0.1"), 0.1);        // to the last bit
  EXPECT_EQ(numberOf("1.0D+01\n"), 10.0); // as Fortran writes them
  EXPECT_EQ(numberOf("-2.5d-3 D"), -2.5e-3);
  EXPECT_EQ(numberOf("1D-999"), 0.0);
  EXPECT_EQ(numberOf("1.0-101"), 1e-101); // with three digits they lack the letter
  EXPECT_EQ(numberOf("-1.5+101 2"), -1.5e101);
  EXPECT_EQ(numberOf("1.0-999"), 0.0);
  EXPECT_TRUE(std::isinf(*numberOf("-1.0+999")));
  EXPECT_TRUE(std::isinf(*numberOf("1D+999")));
  EXPECT_TRUE(std::isnan(*numberOf("nan")));
}

// Digits are read by eights, with their own rounding where that is certain: the standard library is the
// judge.
TEST(TextCursor, numbersOfAnyLengthAreReadToTheLastBit)
{
  std::mt19937 random(3);
  for (int i = 0; i < 100'000; ++i) {
    std::string text = random() % 2 ? "-" : "";
    const auto addDigits = [&](std::size_t count) {
      for (; count > 0; --count) text += static_cast<char>('0' + random() % 10);
    };
    addDigits(1 + random() % 18);
    if (random() % 4) text += '.', addDigits(random() % 18);
    double expected = 0.0;
    std::from_chars(text.data(), text.data() + text.size(), expected);
    const char* const behind[] = {"", " ", "\n1", "\t12345678", " 1.5 2.5\r\n"};
    EXPECT_EQ(numberOf(text + behind[random() % 5]), expected) << text;
    EXPECT_EQ(numberOf(text + "\xB0"), std::nullopt) << text; // a digit but for its highest bit
  }
}

TEST(TextCursor, whatIsNoWholeNumberIsRefused)
{
  for (const char* text : {"1,5", "1.5mm", "x", "", "+-1", "--1", "1e5e5", "0x10", "1D", "1D+", "1.0D+01mm"})
    EXPECT_FALSE(numberOf(text)) << text;
}

TEST(TextCursor, numbersBeyondDoubleAreEndlessOrNothing)
{
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(numberOf("1e999"), kInfinity);
  EXPECT_EQ(numberOf("-1e999"), -kInfinity);
  EXPECT_EQ(numberOf("1e-999"), 0.0);
  EXPECT_EQ(numberOf("0." + std::string(400, '0') + "1"), 0.0);
  EXPECT_EQ(numberOf("1" + std::string(400, '0')), kInfinity);
  EXPECT_EQ(numberOf("1" + std::string(400, '0') + ".5"), kInfinity);
}

TEST(TextCursor, countsLinesWhateverEndsThem)
{
  TextCursor cursor("a\nb\r\nc\rd", TextCursor::Plain);
  for (const char* expected : {"a", "b", "c", "d"}) {
    EXPECT_EQ(cursor.word(), expected);
    EXPECT_TRUE(cursor.atLineEnd());
    EXPECT_EQ(cursor.inLastLine(), cursor.line() == 4);
    cursor.nextLine();
  }
  EXPECT_TRUE(cursor.atEnd());
  EXPECT_EQ(cursor.line(), 4);
}

TEST(TextCursor, cornersTakeTheVertexAndPassOverTheRest)
{
  for (const char* text : {"7", "7/1", "7//3", "7/1/3", "7/-1/-3", "+7"}) {
    TextCursor cursor(text);
    long long vertex = 0;
    EXPECT_TRUE(cursor.corner(vertex)) << text;
    EXPECT_EQ(vertex, 7);
    EXPECT_TRUE(cursor.atEnd());
  }
  for (const char* text : {"7a", "/1", "7/1/x", "7.5", ""}) {
    TextCursor cursor(text);
    long long vertex = 0;
    EXPECT_FALSE(cursor.corner(vertex)) << text;
  }
}

TEST(TextCursor, messagesShowHarmlessWordsOnly)
{
  const std::string text = std::string("a\x01\x1b[31m") + std::string(100, 'x');
  TextCursor cursor(text);
  EXPECT_EQ(cursor.wordForMessage(), "a??[31m" + std::string(23, 'x'));
}

} // namespace
