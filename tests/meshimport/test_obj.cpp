// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "tests/meshimport/import_bytes.h"

#include <gmock/gmock.h>

namespace {

using namespace esm;
using namespace esm::test;
using ::testing::HasSubstr;

struct Readable {
  const char* name;
  std::string bytes;
  const char* summary; ///< nodes/springs/triangles
};
void PrintTo(const Readable& file, std::ostream* out)
{
  *out << file.name;
}
class ObjReadable : public ::testing::TestWithParam<Readable> {};

TEST_P(ObjReadable, holdsWhatItSays)
{
  EXPECT_EQ(summary(importBytes("x.obj", GetParam().bytes)), GetParam().summary);
}

const std::string kThree = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
const std::string kFour = kThree + "v 1 1 0\n";

const Readable kReadable[] = {
  {"plain", kThree + "f 1 2 3\n", "3/3/1"},
  {"noLastLineEnd", kThree + "f 1 2 3", "3/3/1"},
  {"textureAndNormals", kFour + "f 1/1 2/2 3/3\nf 1//1 2//1 4//1\nf 2/1/1 3/2/1 4/3/1\n", "4/6/3"},
  {"negativeIndices", kThree + "f -3 -2 -1\nv 5 5 5\nf -1 -2 -3\n", "4/5/2"},
  {"byteOrderMark", "\xEF\xBB\xBF" + kThree + "f 1 2 3\n", "3/3/1"},
  {"crLf", "v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n", "3/3/1"},
  {"lonelyCr", "v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r", "3/3/1"},
  {"comments", "# first\n" + kThree + "f 1 2 3 # the only one\n#f 1 2 4\n", "3/3/1"},
  {"commentWithoutBlank", kThree + "f 1 2 3#x\n", "3/3/1"},
  {"joinedLines", kThree + "f 1 \\\n 2 \\\r\n 3\n", "3/3/1"},
  {"dialectsOfNumbers", "v .0 0. +0.0\nv 1e0 0 0 1.0\nv\t0  1E+0 -0 0.5 0.5 0.5\nf 1 2 3\n", "3/3/1"},
  {"tinyNumberIsZero", "v 1e-999 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "3/3/1"},
  {"polyline", kFour + "l 1 2 3 4\n", "4/3/0"},
  {"polylineWithTexture", kFour + "l 1/1 2/2 4/3\n", "3/2/0"},
  {"strutOnAnEdgeIsNoSecondSpring", kFour + "f 1 2 3\nl 2 1\nl 3 4\n", "4/4/1"},
  {"lineWrittenAsFace", kThree + "f 1 2\nf 2 3\n", "3/2/0"},
  {"faceBeforeItsVertices", "f 1 2 3\n" + kThree, "3/3/1"},
  {"quad", kFour + "f 1 2 4 3\n", "4/5/2"},
  {"quadWithCornerTwice", kFour + "f 1 2 2 3\n", "3/3/1"},
  {"otherStatements",
   "mtllib a b.mtl\no x\ng y\ns off\nvn 0 0 1\nvt 0 0\nusemtl z\n" + kThree + "p 1\nf 1 2 3\nwhat 1\n",
   "3/3/1"},
  {"weldsEqualPositions", kThree + "v 1 -0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 4 6 5\n", "4/5/2"},
};
INSTANTIATE_TEST_SUITE_P(Files, ObjReadable, ::testing::ValuesIn(kReadable),
                         [](const auto& file) { return std::string(file.param.name); });

class ObjRefused : public ::testing::TestWithParam<Refused> {};

TEST_P(ObjRefused, saysFileLineAndCauseInOneLine)
{
  const Result<ImportedMesh> imported = importBytes("x.obj", GetParam().bytes);
  ASSERT_FALSE(imported);
  EXPECT_EQ(imported.error().code, GetParam().code);
  EXPECT_THAT(imported.error().detail, HasSubstr("x.obj: "));
  EXPECT_THAT(imported.error().detail, HasSubstr(GetParam().message));
  EXPECT_EQ(imported.error().detail.find('\n'), std::string::npos);
}

const Refused kRefusedObj[] = {
  {"indexTooLarge", kThree + "\nf 1 2 4\n", ErrorCode::InvalidValue, "line 5: there is no vertex 4"},
  {"indexZero", kThree + "f 0 1 2\n", ErrorCode::InvalidValue, "line 4: there is no vertex 0"},
  {"indexTooNegative", kThree + "f -4 1 2\n", ErrorCode::InvalidValue, "line 4: there is no vertex -4"},
  {"indexHuge", kThree + "f 99999999999999999999 1 2\n", ErrorCode::BadFormat, "line 4"},
  {"indexOfLine", kThree + "l 1 9\n", ErrorCode::InvalidValue, "line 4: there is no vertex 9"},
  {"decimalComma", "v 0,5 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", ErrorCode::BadFormat,
   "line 1: '0,5' is no coordinate"},
  {"nan", "v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n", ErrorCode::InvalidValue,
   "line 2: vertex 2 has a coordinate that is not a finite number"},
  {"infinite", "v 0 0 0\nv 1 0 0\nv 0 1e999 0\nl 1 3\n", ErrorCode::InvalidValue, "line 3: vertex 3 has"},
  {"twoCoordinates", "v 0 0\nf 1 1 1\n", ErrorCode::BadFormat, "line 1: a vertex needs three coordinates"},
  {"endsInAFace", kThree + "f 1 2", ErrorCode::BadFormat, "line 4: the file ends in the middle"},
  {"endsInAVertex", kThree + "v 1", ErrorCode::BadFormat, "line 4"},
  {"oddCorner", kThree + "f 1 2 3x\n", ErrorCode::BadFormat, "line 4: '3x' is no corner"},
  {"verticesOnly", kThree, ErrorCode::EmptyResult, "3 vertices but no face"},
  {"commentsOnly", "# nothing\n# more of it\n", ErrorCode::EmptyResult, "no face"},
  {"whitespaceOnly", " \n\t\r\n  ", ErrorCode::EmptyResult, "nothing but blanks"},
  {"empty", "", ErrorCode::EmptyResult, "the file is empty (0 bytes)"},
  {"allInOnePlace", "v 1 1 1\nv 1 1 1\nv 1 1 1\nf 1 2 3\n", ErrorCode::EmptyResult, "no spring"},
};
INSTANTIATE_TEST_SUITE_P(Files, ObjRefused, ::testing::ValuesIn(kRefusedObj),
                         [](const auto& file) { return std::string(file.param.name); });

TEST(Obj, verticesKeepTheOrderOfTheFileAndTheirDoublePrecision)
{
  const auto imported = importBytes("x.obj", "v 5000000.01 0 0\nv 5000000.02 0 0\nv 0.1 0.2 0.3\nf 3 2 1\n");
  ASSERT_TRUE(imported);
  EXPECT_EQ(imported->mesh.position(0, 0), 5000000.01); // float32 would join the first two
  EXPECT_EQ(imported->mesh.position(0, 1), 5000000.02);
  EXPECT_EQ(imported->mesh.position(1, 2), 0.2);
  EXPECT_EQ(imported->format, "OBJ");
}

TEST(Obj, vertexOfFileLeadsToTheWeldedVertex)
{
  const std::string bytes = "v 1 0 0\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\nf 3 2 4\n";
  const auto welded = importBytes("x.obj", bytes);
  ASSERT_TRUE(welded);
  EXPECT_THAT(welded->vertexOfFile, ::testing::ElementsAre(0, 1, 0, 2));
  ImportOptions asItIs;
  asItIs.weld = false;
  const auto loose = importBytes("x.obj", bytes, asItIs);
  ASSERT_TRUE(loose);
  EXPECT_THAT(loose->vertexOfFile, ::testing::ElementsAre(0, 1, 2, 3));
  EXPECT_EQ(loose->report.nodes, 4);
}

TEST(Obj, trianglesKeepTheirOrderAroundAPolygon)
{
  const auto imported = importBytes("x.obj", kFour + "v 2 0 1\nf 1 2 5\nf 1 2 4 3\nf 2 4 5\nf 3 4 5\n");
  ASSERT_TRUE(imported);
  ASSERT_EQ(imported->mesh.triangleCount(), 5);
  EXPECT_EQ(imported->mesh.triangles.col(0), Eigen::Vector3i(0, 1, 4));
  EXPECT_EQ(imported->mesh.triangles.col(3), Eigen::Vector3i(1, 3, 4));
  EXPECT_EQ(imported->mesh.triangles.col(4), Eigen::Vector3i(2, 3, 4));
  EXPECT_EQ(imported->mesh.diagonals.cols(), 1);
}

TEST(Obj, anUnusedVertexWithoutANumberIsNotedOnly)
{
  const auto imported = importBytes("x.obj", kThree + "v nan 0 0\nf 1 2 3\n");
  ASSERT_TRUE(imported);
  EXPECT_EQ(imported->report.nonFiniteVertices, 1);
  ASSERT_FALSE(imported->notes.empty());
  EXPECT_THAT(imported->notes[0], HasSubstr("not finite"));
}

TEST(Obj, whatIsPassedOverIsNoted)
{
  const auto imported = importBytes("x.obj", kThree + "p 1\nblah 7\nf 1 2 3\nf 1 2\n");
  ASSERT_TRUE(imported);
  const std::string notes = ::testing::PrintToString(imported->notes);
  EXPECT_THAT(notes, HasSubstr("1 statements for points"));
  EXPECT_THAT(notes, HasSubstr("first is line 5"));
  EXPECT_THAT(notes, HasSubstr("read as lines"));
}

} // namespace
