// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/base/text_number.h"

#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

namespace esm {

// The shortest text must read back to the same bits: the property that makes equal documents equal files.
TEST(TextNumber, RoundTripsBitForBit)
{
  std::mt19937_64 random(1);
  for (int i = 0; i < 100000; ++i) {
    const std::uint64_t bits = random();
    double value;
    std::memcpy(&value, &bits, sizeof value);
    if (!std::isfinite(value)) continue;
    const auto back = parseDouble(formatDouble(value));
    ASSERT_TRUE(back.has_value());
    ASSERT_EQ(std::memcmp(&value, &*back, sizeof value), 0) << formatDouble(value);
  }
}

// Qt calls setlocale(); where numbers have a comma, files must still have a point. Under the suite's de_DE
// run the locale exists and this really bites.
TEST(TextNumber, IgnoresTheLocale)
{
  const char* germanLocale = std::setlocale(LC_ALL, "");
  EXPECT_EQ(parseDouble("1.5"), 1.5) << (germanLocale ? germanLocale : "no locale");
  EXPECT_EQ(formatDouble(1.5), "1.5");
  std::setlocale(LC_ALL, "C");
}

// Fortran writes double precision with the letter D, which numbers of our own files and commands never have.
TEST(TextNumber, FortransExponentsAreReadInForeignFilesOnly)
{
  EXPECT_EQ(parseForeignDouble("1.0D+01"), 10.0);
  EXPECT_EQ(parseForeignDouble("-2.5d-3"), -2.5e-3);
  EXPECT_EQ(parseForeignDouble("+.1D0"), 0.1); // to the last bit
  EXPECT_EQ(parseForeignDouble("12345678901234567D-16"), 1.2345678901234567);
  EXPECT_EQ(parseForeignDouble("1.5e2"), 150.0);
  EXPECT_EQ(parseForeignDouble("1.0-101"), 1.0e-101); // no room for the letter
  EXPECT_EQ(parseForeignDouble("-.25+100"), -0.25e100);
  for (const char* text : {"1.0D", "1.0D+", "D+01", "1.0D+01D", "1.0DE1", "1.0E1D1", "1.0 D1", "1D99999",
                           "1-101", "1.0-11", "1.0-1011", "1.0-", "1.0E1-101", "1.0--101", "2024-101"})
    EXPECT_FALSE(parseForeignDouble(text)) << text;
  EXPECT_FALSE(parseDouble("1.0D+01"));
}

TEST(TextNumber, TakesTheWholeTextOrNothing)
{
  for (const char* bad : {"", " 1", "1 ", "1,5", "0x10", "1e", "--1", "+-1", "1.5m"})
    EXPECT_FALSE(parseDouble(bad).has_value()) << bad;
  EXPECT_EQ(parseDouble("+2.5e-3"), 2.5e-3);
  EXPECT_EQ(parseDouble(".5"), 0.5);
  EXPECT_EQ(parseInteger("+17"), 17);
  EXPECT_FALSE(parseInteger("17.0").has_value());
}

} // namespace esm
