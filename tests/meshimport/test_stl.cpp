// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "tests/meshimport/import_bytes.h"

#include <gmock/gmock.h>

#include <limits>

namespace {

using namespace esm;
using namespace esm::test;
using ::testing::HasSubstr;

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

const std::string kAscii = "solid a square\n"
                           "facet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n  vertex 0 1 0\n"
                           " endloop\nendfacet\n"
                           "facet normal 0 0 1\n outer loop\n  vertex 1 0 0\n  vertex 1 1 0\n  vertex 0 1 0\n"
                           " endloop\nendfacet\nendsolid a square\n";

std::string upperCase(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c; });
  return text;
}

TEST(Stl, binaryIsWelded)
{
  const auto imported = importBytes("x.stl", binaryStl(kTwoFacets, 2));
  EXPECT_EQ(summary(imported), "4/5/2");
  EXPECT_EQ(imported->format, "STL (binary)");
  EXPECT_EQ(imported->vertexOfFile.size(), 6u);
}

TEST(Stl, theWordSolidAtTheStartOfABinaryProvesNothing)
{
  const auto imported = importBytes("x.stl", binaryStl(kTwoFacets, 2, "solid made by some exporter"));
  EXPECT_EQ(summary(imported), "4/5/2");
  EXPECT_EQ(imported->format, "STL (binary)");
}

TEST(Stl, asciiInAnyCaseAndWithAnyLineEnd)
{
  for (const std::string& bytes :
       {kAscii, upperCase(kAscii), replaced(kAscii, "\n", "\r\n"), replaced(upperCase(kAscii), "\n", "\r\n"),
        replaced(kAscii, "\n", "\r"), "\xEF\xBB\xBF" + kAscii, "\n\n  " + kAscii, kAscii + kAscii,
        replaced(kAscii, "normal 0 0 1", "normal nan nan nan"),
        replaced(kAscii, "solid a square", "solid facet vertex 1 2 3")}) {
    const auto imported = importBytes("x.stl", bytes);
    ASSERT_TRUE(imported) << imported.error().detail;
    EXPECT_EQ(imported->format, "STL (ASCII)");
    EXPECT_EQ(imported->report.nodes, 4);
    EXPECT_EQ(imported->report.springs, 5);
  }
}

TEST(Stl, asciiFacetsMayHaveMoreCorners)
{
  const auto imported =
    importBytes("x.stl", "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                         "vertex 1 1 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n");
  EXPECT_EQ(summary(imported), "4/5/2");
}

TEST(Stl, bytesBehindTheLastFacetAreNoted)
{
  const auto imported = importBytes("x.stl", binaryStl(kTwoFacets, 2) + "some colour table");
  EXPECT_EQ(summary(imported), "4/5/2");
  EXPECT_THAT(imported->notes[0], HasSubstr("17 bytes behind the last facet"));
}

class StlRefused : public ::testing::TestWithParam<Refused> {};

TEST_P(StlRefused, saysFileAndCauseInOneLine)
{
  const Result<ImportedMesh> imported = importBytes("x.stl", GetParam().bytes);
  ASSERT_FALSE(imported);
  EXPECT_EQ(imported.error().code, GetParam().code);
  EXPECT_THAT(imported.error().detail, HasSubstr("x.stl: "));
  EXPECT_THAT(imported.error().detail, HasSubstr(GetParam().message));
  EXPECT_EQ(imported.error().detail.find('\n'), std::string::npos);
}

const Refused kRefusedStl[] = {
  {"truncated", binaryStl(kTwoFacets, 2).substr(0, 150), ErrorCode::BadFormat,
   "promises 2 facets in 184 bytes, but it has 150"},
  {"truncatedSolid", binaryStl(kTwoFacets, 2, "solid x").substr(0, 150), ErrorCode::BadFormat,
   "promises 2 facets"},
  {"truncatedHeader", binaryStl(kTwoFacets, 2).substr(0, 60), ErrorCode::BadFormat,
   "60 bytes, less than the 84"},
  {"countOfAllOnesCut", binaryStl(kTwoFacets, 0xFFFFFFFF).substr(0, 150), ErrorCode::BadFormat,
   "promises 4294967295 facets"},
  {"countOfZeroCut", binaryStl(kTwoFacets, 0).substr(0, 150), ErrorCode::BadFormat,
   "nor do these hold a whole number of facets"},
  {"nothingBehindACount", binaryStl({}, 7), ErrorCode::BadFormat, "promises 7 facets in 434 bytes"},
  {"nan", binaryStl({{0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 0, kNaN, 1, 0, 0, 0, 1, 0}}, 2),
   ErrorCode::InvalidValue, "facet 2 has a coordinate that is not a finite number"},
  {"noFacets", binaryStl({}, 0), ErrorCode::EmptyResult, "without a single facet"},
  {"asciiNoFacets", "solid nothing\nendsolid nothing\n", ErrorCode::EmptyResult, "without a single facet"},
  {"asciiEndsInFacet", kAscii.substr(0, kAscii.rfind("endfacet")), ErrorCode::BadFormat,
   "the file ends within a facet; it is cut short"},
  {"asciiEndsInNumber", kAscii.substr(0, kAscii.find("vertex 0 1 0") + 9), ErrorCode::BadFormat,
   "line 6: a vertex needs three coordinates"},
  {"asciiNan", replaced(kAscii, "vertex 1 1 0", "vertex 1 nan 0"), ErrorCode::InvalidValue,
   "line 12: vertex 5 has"},
  {"asciiDecimalComma", replaced(kAscii, "vertex 1 1 0", "vertex 1,5 1 0"), ErrorCode::BadFormat,
   "line 12: a vertex needs three coordinates, written with a point, not '1,5'"},
  {"asciiTwoVertices", replaced(kAscii, "  vertex 1 1 0\n", ""), ErrorCode::BadFormat,
   "line 13: a facet has 2 vertices"},
  {"asciiOddWord", replaced(kAscii, "endfacet", "endface"), ErrorCode::BadFormat,
   "line 8: 'endface' is no word"},
};
INSTANTIATE_TEST_SUITE_P(Files, StlRefused, ::testing::ValuesIn(kRefusedStl),
                         [](const auto& file) { return std::string(file.param.name); });

} // namespace
