// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "tests/meshimport/import_bytes.h"

#include <gmock/gmock.h>

namespace {

using namespace esm;
using namespace esm::test;
using ::testing::HasSubstr;

TEST(Raw, eachLineIsATriangle)
{
  const auto imported = importMesh(kMeshData / "triangles.raw"); // a square of two
  EXPECT_EQ(summary(imported), "4/5/2");
  EXPECT_EQ(imported->format, "RAW triangles");
  EXPECT_EQ(imported->report.boxMax, Eigen::Vector3d(10, 10, 0));
}

TEST(Raw, namesOfObjectsAndTexturesAreNoNumbers)
{
  const auto imported = importBytes("x.RAW", "Body_1\r\n0 0 0 1 0 0 0 1 0\r\n\r\n  lid 2\r\n"
                                             "1 0 0\t1 1 0 0 1 0 \"wood.png\"\r\n");
  EXPECT_EQ(summary(imported), "4/5/2");
}

/// As Blender writes quads: the first corner of one is a corner of others, too.
TEST(Raw, twelveNumbersAreFourCorners)
{
  const auto imported =
    importBytes("x.raw", "0 0 0 1 0 0 1 1 0 0 1 0\n1 0 0 2 0 0 2 1 0 1 1 0\n0 0 0 0 1 0 0 0 1\n");
  EXPECT_EQ(contents(imported), "7 vertices, 0 segments, 5 triangles, 0 tetrahedra");
  EXPECT_THAT(allNotes(imported), HasSubstr("2 lines with twelve numbers were read as quads"));
  // alone in the unit cube: the four lie in a plane, one after the other around it
  EXPECT_EQ(importBytes("x.raw", "0 0 1 1 0 1 1 1 1 0 1 1\n")->report.triangles, 2);
}

/// As tools for POV-Ray write them: red, green and blue, then a triangle.
TEST(Raw, orAColourAndATriangle)
{
  const auto imported =
    importBytes("x.raw", "0.8 0.2 0.1 0 0 0 10 0 0 0 10 0\n0.8 0.2 0.1 10 0 0 10 10 0 0 10 0\n");
  EXPECT_EQ(summary(imported), "4/5/2");
  EXPECT_THAT(allNotes(imported), HasSubstr("2 lines begin with a colour, which was passed over"));
  // black is a corner of the mesh, too; but so many faces do not begin in one corner
  std::string black;
  for (int i = 0; i < 7; ++i)
    black += "0 0 0 0 0 0 1 0 " + std::to_string(i) + " 1 0 " + std::to_string(i + 1) + "\n";
  EXPECT_EQ(importBytes("x.raw", black)->report.triangles, 7);
}

TEST(Raw, otherNumbersAreRefused)
{
  const std::string good = "0 0 0 1 0 0 0 1 0\n";
  EXPECT_THAT(refusalOf("x.raw", good + "0 0 0 1 0 0 0 1\n" + good),
              HasSubstr("line 2: a line of a RAW file has 9 or 12 numbers, this one has 8"));
  EXPECT_EQ(refusalOf("x.raw", good + "0 0 0 1 0 0 0 1\n" + good).find("cut short"), std::string::npos);
  EXPECT_THAT(refusalOf("x.raw", good + "0 0 0 1 0"), HasSubstr("this one has 5; the file is cut short"));
  EXPECT_THAT(refusalOf("x.raw", good + "0 0 0 1 0 0 0 1 0 0 0 0 0\n"), HasSubstr("this one has more"));
  EXPECT_THAT(refusalOf("x.raw", good + "0 0 0 1 0 0 0 1,5 0\n"),
              HasSubstr("line 2: '1,5' is no coordinate"));
  EXPECT_THAT(refusalOf("x.raw", good + "0 0 0 1 0 0 0 nan 0\n"), HasSubstr("not a finite number"));
  EXPECT_THAT(refusalOf("x.raw", "0 0 0\n1 0 0\n0 1 0\n"), HasSubstr("a table of numbers, perhaps points"));
  EXPECT_THAT(refusalOf("x.raw", std::string("\1\2\0\4", 4)), HasSubstr("binary data of an unknown kind"));
}

/// Nothing but its name tells it from a table.
TEST(Raw, tablesUnderOtherNamesAreNoTriangles)
{
  EXPECT_FALSE(importBytes("x.txt", "0 0 0 1 0 0 0 1 0\n"));
}

} // namespace
