// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "tests/meshimport/import_bytes.h"

#include <gmock/gmock.h>

namespace {

using namespace esm;
using namespace esm::test;
using ::testing::HasSubstr;

TEST(Off, polygonsColoursCommentsAndLines)
{
  const std::string body = "4 2 0\n0 0 0\n1 0 0 # a comment\n\n1 1 0\n0 1 0\n4 0 1 2 3 255 0 0\n2 1 3\n";
  EXPECT_EQ(summary(importBytes("x.off", "OFF\n" + body)), "4/5/2"); // the line 1-3 is the diagonal
  EXPECT_EQ(summary(importBytes("x.off", "OFF " + body)), "4/5/2");
  EXPECT_EQ(summary(importBytes("x.off", "# first\nCOFF\r\n" + body)), "4/5/2");
}

TEST(Off, faultsAreNamedWithTheirLine)
{
  const auto errorOf = [](const std::string& bytes) {
    const auto imported = importBytes("x.off", bytes);
    return imported ? std::string("read") : imported.error().detail;
  };
  const std::string three = "0 0 0\n1 0 0\n0 1 0\n";
  EXPECT_THAT(errorOf("OFF\n3 1 0\n" + three + "3 0 1 3\n"),
              HasSubstr("x.off: line 6: there is no vertex 3"));
  EXPECT_THAT(errorOf("OFF\n1000000000 1 0\n" + three), HasSubstr("promise more"));
  EXPECT_THAT(errorOf("OFF\n3 1000000000 0\n" + three), HasSubstr("promise more"));
  EXPECT_THAT(errorOf("OFF\n3 1 0\n" + three + "3 0 1\n"), HasSubstr("fewer corners"));
  EXPECT_THAT(errorOf("OFF\n3 1 0\n0 0 0\n1 0 nan\n0 1 0\n3 0 1 2\n"), HasSubstr("line 4: vertex 2 has"));
  EXPECT_THAT(errorOf("OFF BINARY\n3 1 0\n"), HasSubstr("binary OFF"));
  EXPECT_THAT(errorOf("OFF\n3 0 0\n" + three), HasSubstr("no face"));
}

} // namespace
