// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "tests/meshimport/import_bytes.h"

#include <gmock/gmock.h>

namespace {

using namespace esm;
using namespace esm::test;
using ::testing::HasSubstr;

const std::string kHeader = "ply\nformat ascii 1.0\ncomment made by a test\n"
                            "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
                            "element face 1\nproperty list uchar int vertex_indices\n";
const std::string kPlyVertices = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
const std::string kSquare = kHeader + "end_header\n" + kPlyVertices + "4 0 1 2 3\n";

/// A square with one edge across, each number in another type, in the given byte order.
std::string binarySquare(std::endian order, const std::string& lineEnd = "\n")
{
  const std::string head = "ply\nformat binary_" +
                           std::string(order == std::endian::little ? "little" : "big") +
                           "_endian 1.0\nelement vertex 4\nproperty uchar red\nproperty double x\n"
                           "property int16 y\nproperty int8 z\nelement edge 1\nproperty uint vertex1\n"
                           "property ushort vertex2\nelement face 1\nproperty list uint16 float weight\n"
                           "property list int uint8 vertex_index\nend_header\n";
  std::string bytes = replaced(head, "\n", lineEnd);
  const double x[4] = {0.1, 1.1, 1.1, 0.1};
  for (int i = 0; i < 4; ++i)
    bytes += bytesOf(std::uint8_t{10}, order) + bytesOf(x[i], order) +
             bytesOf(static_cast<std::int16_t>(i < 2 ? -300 : -299), order) + bytesOf(std::int8_t{-7}, order);
  bytes += bytesOf(std::uint32_t{1}, order) + bytesOf(std::uint16_t{3}, order);
  bytes += bytesOf(std::uint16_t{2}, order) + bytesOf(1.5f, order) + bytesOf(2.5f, order);
  bytes += bytesOf(std::int32_t{4}, order);
  bytes += std::string("\0\1\2\3", 4);
  return bytes;
}

TEST(Ply, asciiPolygonsAreCutIntoTriangles)
{
  const auto imported = importBytes("x.ply", kSquare);
  EXPECT_EQ(summary(imported), "4/5/2");
  EXPECT_EQ(imported->format, "PLY (ASCII)");
}

TEST(Ply, binaryOfBothOrdersAllTypesAndLineEnds)
{
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    for (const std::string lineEnd : {"\n", "\r\n", "\r"}) {
      const auto imported = importBytes("x.ply", binarySquare(order, lineEnd));
      ASSERT_TRUE(imported) << imported.error().detail;
      EXPECT_EQ(imported->report.nodes, 4);
      EXPECT_EQ(imported->mesh.segmentCount(), 1);
      EXPECT_EQ(imported->mesh.position.col(0), Eigen::Vector3d(0.1, -300, -7)); // double stays double
      EXPECT_EQ(imported->mesh.position.col(2), Eigen::Vector3d(1.1, -299, -7));
    }
  }
}

TEST(Ply, aBodyThatBeginsWithTheByteOfALineFeedKeepsIt)
{
  const std::string header = "ply\rformat binary_little_endian 1.0\relement vertex 2\rproperty uchar x\r"
                             "property uchar y\rproperty uchar z\relement edge 1\rproperty uchar vertex1\r"
                             "property uchar vertex2\rend_header\r";
  const auto imported = importBytes("x.ply", header + std::string("\n\x01\x02\x03\x04\x05\x00\x01", 8));
  ASSERT_TRUE(imported) << imported.error().detail;
  EXPECT_EQ(imported->mesh.position.col(0), Eigen::Vector3d(10, 1, 2));
}

TEST(Ply, edgesBecomeSegments)
{
  const std::string bytes = kHeader +
                            "element edge 2\nproperty int vertex1\nproperty int vertex2\nend_header\n" +
                            kPlyVertices + "3 0 1 2\n0 3\n3 2\n";
  EXPECT_EQ(summary(importBytes("x.ply", bytes)), "4/5/1");
}

TEST(Ply, crLfBlankLinesAndExtraNumbersDoNoHarm)
{
  EXPECT_EQ(summary(importBytes("x.ply", replaced(kSquare, "\n", "\r\n"))), "4/5/2");
  EXPECT_EQ(summary(importBytes("x.ply", replaced(kSquare, "1 1 0\n", "1 1 0 99\n\n"))), "4/5/2");
  EXPECT_EQ(summary(importBytes("x.ply", kSquare.substr(0, kSquare.size() - 1))), "4/5/2");
}

TEST(Ply, facesMayComeBeforeTheirVertices)
{
  const std::string bytes =
    "ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int vertex_indices\n"
    "element vertex 3\nproperty float x\nproperty float y\nproperty float z\nend_header\n"
    "3 0 1 2\n0 0 0\n1 0 0\n0 1 0\n";
  EXPECT_EQ(summary(importBytes("x.ply", bytes)), "3/3/1");
}

TEST(Ply, otherElementsAndTrailingBytesAreNoted)
{
  const std::string bytes =
    replaced(kHeader, "element face", "element marker 1\nproperty int a\nelement face") + "end_header\n" +
    kPlyVertices + "17\n3 0 1 2\nmore\n";
  const auto imported = importBytes("x.ply", bytes);
  ASSERT_TRUE(imported) << imported.error().detail;
  const std::string notes = ::testing::PrintToString(imported->notes);
  EXPECT_THAT(notes, HasSubstr("'marker'"));
  EXPECT_THAT(notes, HasSubstr("5 bytes behind the last element"));
}

/// A grid of squares, two triangles each, in the usual binary form.
struct UsualBinary {
  static constexpr std::uint32_t kSide = 80; // 12,800 triangles: several batches of the reader
  std::vector<std::vector<std::uint32_t>> faces;

  UsualBinary()
  {
    for (std::uint32_t row = 0; row < kSide; ++row)
      for (std::uint32_t column = 0; column < kSide; ++column) {
        const std::uint32_t a = row * (kSide + 1) + column, b = a + 1, c = a + kSide + 1, d = c + 1;
        faces.push_back({a, b, d});
        faces.push_back({a, d, c});
      }
  }
  std::string bytes(std::endian order) const
  {
    std::string text = "ply\nformat binary_" + std::string(order == std::endian::little ? "little" : "big") +
                       "_endian 1.0\nelement vertex " + std::to_string((kSide + 1) * (kSide + 1)) +
                       "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
                       std::to_string(faces.size()) +
                       "\nproperty list uchar int vertex_indices\nend_header\n";
    for (std::uint32_t row = 0; row <= kSide; ++row)
      for (std::uint32_t column = 0; column <= kSide; ++column)
        text += bytesOf(static_cast<float>(column), order) + bytesOf(static_cast<float>(row), order) +
                bytesOf(0.0f, order);
    for (const auto& face : faces) {
      text += static_cast<char>(face.size());
      for (const std::uint32_t corner : face) text += bytesOf(corner, order);
    }
    return text;
  }
};

TEST(Ply, trianglesInBatchesAndOtherFacesBetweenThemAllArrive)
{
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    UsualBinary file;
    const auto plain = importBytes("x.ply", file.bytes(order));
    ASSERT_TRUE(plain) << plain.error().detail;
    ASSERT_EQ(plain->mesh.triangleCount(), 12800);
    for (std::size_t t = 0; t < file.faces.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k)
        ASSERT_EQ(plain->mesh.triangles(static_cast<Index>(k), static_cast<Index>(t)),
                  static_cast<Index>(file.faces[t][k]));
    // A line of two corners and a square in the middle of a batch, and a square as the last face.
    file.faces[5000].pop_back();
    file.faces[9000].push_back(file.faces[9001][2]);
    file.faces.back().push_back(file.faces.back()[0] + 1);
    const auto mixed = importBytes("x.ply", file.bytes(order));
    ASSERT_TRUE(mixed) << mixed.error().detail;
    EXPECT_EQ(mixed->mesh.triangleCount(), 12801); // one less, two more
    EXPECT_EQ(mixed->mesh.segmentCount(), 1);
    EXPECT_EQ(mixed->report.nodes, plain->report.nodes);
  }
}

TEST(Ply, aFaultInAnyBatchNamesItsFace)
{
  UsualBinary file;
  const std::string whole = file.bytes(std::endian::little);
  const auto cut = importBytes("x.ply", whole.substr(0, whole.size() - 13 * 800 - 5));
  ASSERT_FALSE(cut);
  EXPECT_THAT(cut.error().detail, HasSubstr("face 12000: it ends early"));
  file.faces[10000][1] = 81 * 81;
  const auto outside = importBytes("x.ply", file.bytes(std::endian::little));
  ASSERT_FALSE(outside);
  EXPECT_THAT(outside.error().detail, HasSubstr("face 10001: there is no vertex 6561"));
  file.faces[10000][1] = 0xFFFFFFFF;
  EXPECT_FALSE(importBytes("x.ply", file.bytes(std::endian::little)));
}

class PlyRefused : public ::testing::TestWithParam<Refused> {};

TEST_P(PlyRefused, saysFileAndCauseInOneLine)
{
  const Result<ImportedMesh> imported = importBytes("x.ply", GetParam().bytes);
  ASSERT_FALSE(imported);
  EXPECT_EQ(imported.error().code, GetParam().code);
  EXPECT_THAT(imported.error().detail, HasSubstr("x.ply: "));
  EXPECT_THAT(imported.error().detail, HasSubstr(GetParam().message));
  EXPECT_EQ(imported.error().detail.find('\n'), std::string::npos);
}

const std::string kBinary = binarySquare(std::endian::little);
const Refused kRefusedPly[] = {
  {"headerCutShort", kSquare.substr(0, kSquare.find("end_header")), ErrorCode::BadFormat, "no 'end_header'"},
  {"bodyCutShort", kSquare.substr(0, kSquare.size() - 4), ErrorCode::BadFormat,
   "line 15: face 1: a list of impossible length"},
  {"verticesCutShort", kSquare.substr(0, kSquare.find("end_header") + 17), ErrorCode::BadFormat, "too small"},
  {"binaryCutShort", kBinary.substr(0, kBinary.size() - 1), ErrorCode::BadFormat, "face 1"},
  {"lyingVertices", replaced(kSquare, "vertex 4", "vertex 1000000000"), ErrorCode::BadFormat,
   "promises 1000000000 of 'vertex'"},
  {"lyingFaces", replaced(kSquare, "face 1", "face 1000000000"), ErrorCode::BadFormat,
   "promises 1000000000 of 'face'"},
  {"lyingBinary", replaced(kBinary, "vertex 4", "vertex 1000000000"), ErrorCode::BadFormat,
   "promises 1000000000"},
  {"lyingBeyond64Bits", replaced(kBinary, "vertex 4", "vertex 9223372036854775807"), ErrorCode::BadFormat,
   "promises 9223372036854775807"},
  {"negativeCount", replaced(kSquare, "vertex 4", "vertex -4"), ErrorCode::BadFormat,
   "line 4: an element needs"},
  {"lyingList", replaced(kSquare, "4 0 1 2 3", "400000000 0 1 2 3"), ErrorCode::BadFormat,
   "line 15: face 1: a list of impossible length"},
  {"indexOutOfRange", replaced(kSquare, "4 0 1 2 3", "4 0 1 2 4"), ErrorCode::InvalidValue,
   "face 1: there is no vertex 4"},
  {"indexNegative", replaced(kSquare, "4 0 1 2 3", "4 0 1 2 -1"), ErrorCode::InvalidValue, "no vertex -1"},
  {"indexNan", replaced(kSquare, "4 0 1 2 3", "4 0 1 2 nan"), ErrorCode::InvalidValue, "no vertex"},
  {"nan", replaced(kSquare, "1 1 0", "1 nan 0"), ErrorCode::InvalidValue,
   "vertex 3 has a coordinate that is not a finite number"},
  {"word", replaced(kSquare, "1 1 0", "1 one 0"), ErrorCode::BadFormat, "line 13: vertex 3"},
  {"noZ", replaced(kSquare, "float z", "float w"), ErrorCode::BadFormat, "no x, y and z"},
  {"noFormat", replaced(kSquare, "format ascii 1.0\n", ""), ErrorCode::BadFormat, "no 'format'"},
  {"oddType", replaced(kSquare, "float x", "real x"), ErrorCode::BadFormat, "line 5: a property has a type"},
  {"vertexTwice", replaced(kSquare, "element face 1", "element vertex 4"), ErrorCode::BadFormat,
   "comes twice"},
  {"pointCloud", replaced(replaced(kSquare, "face 1", "face 0"), "4 0 1 2 3\n", ""), ErrorCode::EmptyResult,
   "point cloud"},
};
INSTANTIATE_TEST_SUITE_P(Files, PlyRefused, ::testing::ValuesIn(kRefusedPly),
                         [](const auto& file) { return std::string(file.param.name); });

} // namespace
