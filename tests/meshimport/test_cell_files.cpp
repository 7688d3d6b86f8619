// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// Files of finite-element and visualization programs (VTK, VTU, Gmsh): what becomes of each cell, and what is
// refused in one sentence.
#include "tests/meshimport/dxf_text.h"
#include "tests/meshimport/import_bytes.h"

#include <Eigen/Geometry>

#include <gmock/gmock.h>

#include <cmath>

namespace {

using namespace esm;
using namespace esm::test;
using ::testing::HasSubstr;

// === VTK

const std::string kVtkGrid = "# vtk DataFile Version 3.0\na tetrahedron, a quad and a line\nASCII\n"
                             "DATASET UNSTRUCTURED_GRID\nPOINTS 5 float\n0 0 0 1 0 0\n1 1 0 0 1 0 0 0 1\n"
                             "CELLS 3 13\n4 0 1 2 4\n4 0 1 2 3\n2 3 4\nCELL_TYPES 3\n10\n9\n3\n"
                             "CELL_DATA 3\nSCALARS s float\nLOOKUP_TABLE default\n1 2 3\n";

TEST(Vtk, tetrahedraQuadsAndLinesOfAGridArrive)
{
  const auto imported = importBytes("grid.vtk", kVtkGrid);
  EXPECT_EQ(contents(imported), "5 vertices, 1 segments, 2 triangles, 1 tetrahedra");
  EXPECT_EQ(imported->format, "VTK (ASCII)");
}

TEST(Vtk, aGridOfVersionFiveWithFieldDataSaysTheSame)
{
  const std::string text =
    "# vtk DataFile Version 5.1\nv5\nASCII\nDATASET UNSTRUCTURED_GRID\nFIELD FieldData 1\nTimeValue 1 1 "
    "double\n0.5\n"
    "POINTS 5 double\n0 0 0 1 0 0 1 1 0 0 1 0 0 0 1\nMETADATA\nINFORMATION 0\n\nCELLS 4 10\nOFFSETS "
    "vtktypeint64\n"
    "0 4 8 10\nCONNECTIVITY vtktypeint64\n0 1 2 4 0 1 2 3 3 4\nCELL_TYPES 3\n10\n9\n3\n";
  EXPECT_EQ(contents(importBytes("grid.vtk", text)), contents(importBytes("grid.vtk", kVtkGrid)));
}

TEST(Vtk, aBinaryPolyDataIsBigEndian)
{
  std::string bytes = "# vtk DataFile Version 2.0\nx\nBINARY\nDATASET POLYDATA\nPOINTS 4 float\n";
  for (const float x : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 1.f, 1.f, 0.f, 0.f, 1.f, 0.f})
    bytes += bytesOf(x, std::endian::big);
  bytes += "\nPOLYGONS 1 4\n";
  for (const int i : {3, 0, 1, 2}) bytes += bytesOf(i, std::endian::big);
  bytes += "\nLINES 1 4\n";
  for (const int i : {3, 2, 3, 0}) bytes += bytesOf(i, std::endian::big);
  EXPECT_EQ(contents(importBytes("poly.vtk", bytes)), "4 vertices, 2 segments, 1 triangles, 0 tetrahedra");
}

// A strip turns every other triangle round, a pixel counts its corners in rows: the unit square, seen from
// above, is 1 m^2 upwards whichever of the three says it.
TEST(Vtk, stripsAndPixelsFaceTheSameWayAsQuads)
{
  for (const char* cell :
       {"4 0 1 2 3\nCELL_TYPES 1\n6\n", "4 0 1 2 3\nCELL_TYPES 1\n8\n", "4 0 1 3 2\nCELL_TYPES 1\n9\n"}) {
    const auto imported = importBytes("square.vtk", "# vtk DataFile Version 3.0\nx\nASCII\n"
                                                    "DATASET UNSTRUCTURED_GRID\nPOINTS 4 float\n"
                                                    "0 0 0 1 0 0 0 1 0 1 1 0\nCELLS 1 5\n" +
                                                      std::string(cell));
    ASSERT_TRUE(imported) << cell;
    const Mesh& mesh = imported->mesh;
    ASSERT_EQ(mesh.triangleCount(), 2) << cell;
    for (const auto& triangle : mesh.triangles.colwise()) {
      const Eigen::Vector3d a = mesh.position.col(triangle[0]), b = mesh.position.col(triangle[1]),
                            c = mesh.position.col(triangle[2]);
      EXPECT_NEAR((b - a).cross(c - a).z(), 1.0, 1e-12) << cell; // twice half of the square
    }
  }
}

TEST(Vtk, aHexahedronBecomesItsTwelveEdgesAndQuadraticCellsTheirCorners)
{
  const std::string text = "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 8 float\n"
                           "0 0 0 1 0 0 1 1 0 0 1 0 0 0 1 1 0 1 1 1 1 0 1 1\nCELLS 2 16\n"
                           "8 0 1 2 3 4 5 6 7\n6 0 1 2 4 5 6\nCELL_TYPES 2\n12\n22\n";
  const auto imported = importBytes("hexa.vtk", text);
  EXPECT_EQ(contents(imported), "8 vertices, 12 segments, 1 triangles, 0 tetrahedra");
  EXPECT_THAT(allNotes(imported), HasSubstr("1 hexahedra, wedges and pyramids became their edges"));
  EXPECT_THAT(allNotes(imported), HasSubstr("1 cells of higher order were reduced to their corners"));
}

/// Pixels and voxels count their corners row by row, not round the outline.
TEST(Vtk, pixelsAndVoxelsAreRows)
{
  const std::string head = "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 8 float\n"
                           "0 0 0 1 0 0 0 1 0 1 1 0 0 0 1 1 0 1 0 1 1 1 1 1\n";
  const auto sum = [](const Result<ImportedMesh>& imported) {
    return imported ? sumRestLength(imported->mesh, imported->edges) : 0.0;
  };
  const auto pixel = importBytes("pixel.vtk", head + "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n8\n");
  EXPECT_EQ(contents(pixel), "8 vertices, 0 segments, 2 triangles, 0 tetrahedra");
  EXPECT_NEAR(sum(pixel), 4.0 + std::sqrt(2.0), 1e-15); // four sides and a diagonal; one rounding
  const auto voxel = importBytes("voxel.vtk", head + "CELLS 1 9\n8 0 1 2 3 4 5 6 7\nCELL_TYPES 1\n11\n");
  EXPECT_EQ(contents(voxel), "8 vertices, 12 segments, 0 triangles, 0 tetrahedra");
  EXPECT_EQ(sum(voxel), 12.0);
}

// === VTU

std::string vtu(const std::string& head, const std::string& points, const std::string& lists)
{
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" byte_order=\"LittleEndian\"" + head +
         ">\n<UnstructuredGrid><Piece NumberOfPoints=\"4\" NumberOfCells=\"2\">\n<Points>" + points +
         "</Points>\n<Cells>" + lists + "</Cells></Piece></UnstructuredGrid>\n";
}

TEST(Vtu, textArraysArrive)
{
  const std::string text =
    vtu("",
        "<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">0 0 0 1 0 0 0 1 0 0 0 "
        "1</DataArray>",
        "<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">0 1 2 3 0 3</DataArray>"
        "<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">4 6</DataArray>"
        "<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">10 3</DataArray>") +
    "</VTKFile>\n";
  EXPECT_EQ(contents(importBytes("a.vtu", text)), "4 vertices, 1 segments, 0 triangles, 1 tetrahedra");
}

std::string base64(const std::string& bytes)
{
  constexpr const char* kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits = bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k <= bytes.size() ? kLetters[bits >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

/// The size before the data may be a text of its own, with padding at its end, or part of one text.
TEST(Vtu, inlineBase64WithItsSizeApartOrInOne)
{
  std::string points, nodes, ends;
  for (const double x : {0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.}) points += bytesOf(x);
  for (const std::int64_t i : {0, 1, 2, 3, 0, 3}) nodes += bytesOf(i);
  for (const std::int64_t i : {4, 6}) ends += bytesOf(i);
  for (const bool isApart : {false, true}) {
    const auto array = [isApart](const std::string& head, const std::string& data) {
      const std::string size = bytesOf(static_cast<std::uint32_t>(data.size()));
      return "<DataArray " + head + " format=\"binary\">" +
             (isApart ? base64(size) + base64(data) : base64(size + data)) + "</DataArray>";
    };
    const std::string text = vtu("", array("type=\"Float64\" NumberOfComponents=\"3\"", points),
                                 array("type=\"Int64\" Name=\"connectivity\"", nodes) +
                                   array("type=\"Int64\" Name=\"offsets\"", ends) +
                                   array("type=\"UInt8\" Name=\"types\"", "\x0a\x03")) +
                             "</VTKFile>\n";
    EXPECT_EQ(contents(importBytes("a.vtu", text)), "4 vertices, 1 segments, 0 triangles, 1 tetrahedra")
      << isApart;
  }
}

std::string appendedVtu()
{
  std::string data;
  const auto block = [&data](const std::string& bytes) {
    data += bytesOf(std::uint64_t{bytes.size()}) + bytes;
  };
  std::string points, nodes, ends, types = "\x0a\x03";
  for (const double x : {0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.}) points += bytesOf(x);
  for (const std::int64_t i : {0, 1, 2, 3, 0, 3}) nodes += bytesOf(i);
  for (const std::int64_t i : {4, 6}) ends += bytesOf(i);
  std::string offsets[4];
  int i = 0;
  for (const std::string* bytes : {&points, &nodes, &ends, &types}) {
    offsets[i++] = "\" format=\"appended\" offset=\"" + std::to_string(data.size()) + "\"/>";
    block(*bytes);
  }
  return vtu(" header_type=\"UInt64\"", "<DataArray type=\"Float64" + offsets[0],
             "<DataArray Name=\"connectivity\" type=\"Int64" + offsets[1] +
               "<DataArray Name=\"offsets\" type=\"Int64" + offsets[2] +
               "<DataArray Name=\"types\" type=\"UInt8" + offsets[3]) +
         "<AppendedData encoding=\"raw\">_" + data + "</AppendedData></VTKFile>";
}

TEST(Vtu, rawAppendedDataArrives)
{
  EXPECT_EQ(contents(importBytes("a.vtu", appendedVtu())),
            "4 vertices, 1 segments, 0 triangles, 1 tetrahedra");
}

TEST(Vtu, aSizeBeyondTheFileIsRefusedBeforeMemoryIsTaken)
{
  std::string bytes = appendedVtu();
  const std::size_t size = bytes.find(">_") + 2;
  bytes.replace(size, 8, bytesOf(std::uint64_t{1} << 50));
  EXPECT_THAT(contents(importBytes("a.vtu", bytes)), HasSubstr("promises more than the file holds"));
}

// === Gmsh

const std::string kMsh2 =
  "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n10 0 0 0\n3 1 0 0\n7 0 1 0\n5 0 0 1\n$EndNodes\n"
  "$Elements\n3\n1 4 2 1 1 10 3 7 5\n2 2 2 1 1 10 3 7\n3 1 2 1 1 3 5\n$EndElements\n";

TEST(Gmsh, tagsInAnyOrderAreFollowed)
{
  const auto imported = importBytes("a.msh", kMsh2);
  EXPECT_EQ(contents(imported), "4 vertices, 1 segments, 1 triangles, 1 tetrahedra");
  EXPECT_EQ(imported->mesh.position.col(1), Eigen::Vector3d(1, 0, 0))
    << "vertices keep the order of the file";
  EXPECT_EQ(imported->mesh.tetrahedra.col(0), (Eigen::Matrix<Index, 4, 1>(0, 1, 2, 3)));
}

std::string binaryMsh4(std::endian order)
{
  const auto i4 = [order](int value) { return bytesOf(value, order); };
  const auto i8 = [order](std::uint64_t value) { return bytesOf(value, order); };
  std::string bytes = "$MeshFormat\n4.1 1 8\n" + i4(1) + "\n$EndMeshFormat\n$Nodes\n";
  bytes += i8(1) + i8(4) + i8(1) + i8(4) + i4(3) + i4(1) + i4(0) + i8(4);
  for (const std::uint64_t tag : {1, 2, 3, 4}) bytes += i8(tag);
  for (const double x : {0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.}) bytes += bytesOf(x, order);
  bytes += "\n$EndNodes\n$Elements\n" + i8(1) + i8(1) + i8(1) + i8(1) + i4(3) + i4(1) + i4(4) + i8(1) + i8(1);
  for (const std::uint64_t tag : {1, 2, 3, 4}) bytes += i8(tag);
  return bytes + "\n$EndElements\n";
}

/// Nodes may have their place on a curve or surface behind their coordinates.
TEST(Gmsh, parametersOfNodesArePassedOver)
{
  const std::string text =
    "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n2 4 1 4\n2 1 1 3\n1\n2\n3\n0 0 0 0.5 0.25\n"
    "1 0 0 0.5 0.25\n0 1 0 0.5 0.25\n1 1 1 1\n4\n0 0 7 0.5\n$EndNodes\n$Elements\n2 2 1 2\n"
    "2 1 2 1\n1 1 2 3\n1 1 1 1\n2 1 4\n$EndElements\n";
  const auto imported = importBytes("a.msh", text);
  ASSERT_EQ(contents(imported), "4 vertices, 1 segments, 1 triangles, 0 tetrahedra");
  EXPECT_EQ(imported->report.boxMax, Eigen::Vector3d(1, 1, 7));
}

TEST(Gmsh, binaryFilesOfBothByteOrdersArrive)
{
  for (const std::endian order : {std::endian::little, std::endian::big})
    EXPECT_EQ(contents(importBytes("b.msh", binaryMsh4(order))),
              "4 vertices, 0 segments, 0 triangles, 1 tetrahedra");
}

// === Open Inventor and VRML

TEST(Inventor, facesAndLinesOfBothFormatsArriveWhereTheirTransformsPutThem)
{
  const std::string inventor =
    "#Inventor V2.1 ascii\nSeparator { Transform { translation 5 0 0 }\nCoordinate3 { point [ 0 0 0, 1 0 0, "
    "0 1 0, 0 0 1 ] }\n"
    "IndexedFaceSet { coordIndex [ 0, 1, 2, -1 ] } IndexedLineSet { coordIndex [ 2, 3, 0, -1 ] } }\n";
  const std::string vrml = "#VRML V2.0 utf8\nTransform { translation 5 0 0 children [ Shape { geometry "
                           "IndexedFaceSet { coord Coordinate { point "
                           "[ 0 0 0, 1 0 0, 0 1 0 ] } coordIndex [ 0, 1, 2, -1 ] } }\nShape { geometry "
                           "IndexedLineSet { coord Coordinate { point "
                           "[ 0 0 0, 0 1 0, 0 0 1 ] } coordIndex [ 1, 2, 0, -1 ] } } ] }\n";
  for (const auto& [name, bytes] : {std::pair{"a.iv", inventor}, {"a.wrl", vrml}}) {
    const auto imported = importBytes(name, bytes);
    if (!imported && imported.error().detail.find("without the Coin library") != std::string::npos)
      GTEST_SKIP() << imported.error().detail;
    ASSERT_EQ(contents(imported), "4 vertices, 2 segments, 1 triangles, 0 tetrahedra");
    EXPECT_EQ(imported->report.boxMin, Eigen::Vector3d(5, 0, 0));
    EXPECT_EQ(imported->report.boxMax, Eigen::Vector3d(6, 1, 1));
  }
}

// === What is refused, and why

struct RefusedCells {
  const char* test;
  const char* name;
  std::string bytes;
  const char* message;
};

std::string without(std::string text, const std::string& part, const std::string& with = "")
{
  return text.replace(text.find(part), part.size(), with);
}

class CellFileRefused : public ::testing::TestWithParam<RefusedCells> {};

TEST_P(CellFileRefused, saysFileAndCauseInOneLine)
{
  const auto imported = importBytes(GetParam().name, GetParam().bytes);
  ASSERT_FALSE(imported);
  EXPECT_THAT(imported.error().detail, HasSubstr(std::string(GetParam().name) + ": "));
  EXPECT_THAT(imported.error().detail, HasSubstr(GetParam().message));
  EXPECT_EQ(imported.error().detail.find('\n'), std::string::npos);
}

const RefusedCells kRefused[] = {
  {"vtkLyingPoints", "x.vtk", without(kVtkGrid, "POINTS 5", "POINTS 1000000000"), "too small"},
  {"vtkLyingCells", "x.vtk", without(kVtkGrid, "CELLS 3 13", "CELLS 3 2000000000"), "too small"},
  {"vtkIndex", "x.vtk", without(kVtkGrid, "4 0 1 2 4", "4 0 1 2 9"), "there is no point 9"},
  {"vtkCut", "x.vtk", kVtkGrid.substr(0, kVtkGrid.find("CELL_TYPES")), "no CELL_TYPES"},
  {"vtkImage", "x.vtk", without(kVtkGrid, "UNSTRUCTURED_GRID", "STRUCTURED_POINTS"), "no mesh of cells"},
  {"mshLyingNodes", "x.msh", without(kMsh2, "$Nodes\n4", "$Nodes\n900000000"), "promises 900000000 nodes"},
  {"mshNode", "x.msh", without(kMsh2, "10 3 7 5", "10 3 7 6"), "there is no node 6"},
  {"mshVersion", "x.msh", without(kMsh2, "2.2 0 8", "4 0 8"), "format 4.1 or 2.2"},
  {"mshCut", "x.msh", binaryMsh4(std::endian::little).substr(0, 120), "cut short"},
  {"vtuCut", "x.vtu", appendedVtu().substr(0, 300), "cut short"},
  {"vtuLz4", "x.vtu",
   without(appendedVtu(), " header_type", " compressor=\"vtkLZ4DataCompressor\" header_type"),
   "vtkLZ4DataCompressor is not read"},
  {"x3dLines", "x.x3d",
   "<X3D><Scene><Shape><IndexedLineSet coordIndex='0 1 2 -1'><Coordinate point='0 0 0 1 0 0 1 1 "
   "0'/></IndexedLineSet>"
   "</Shape></Scene></X3D>",
   "X3D line sets are not read"},
  {"inventorCut", "x.iv", "#Inventor V2.1 ascii\nSeparator { Coordinate3 { point [ 0 0", ""},
};
INSTANTIATE_TEST_SUITE_P(Files, CellFileRefused, ::testing::ValuesIn(kRefused),
                         [](const auto& file) { return std::string(file.param.test); });

// === Watched and stopped

TEST(ImportControl, aWishToStopBeforehandIsAnsweredByEveryReader)
{
  WorkControl control;
  control.cancelled = true;
  const TempFolder folder;
  for (const auto& [name, bytes] : {std::pair<const char*, std::string>{"a.vtk", kVtkGrid},
                                    {"a.vtu", appendedVtu()},
                                    {"a.msh", kMsh2},
                                    {"a.dxf", dxf("0\nPOLYLINE\n70\n8\n" + kFourVertices)},
                                    {"a.stl", binaryStl(kTwoFacets, 2)},
                                    {"a.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n"}}) {
    const auto imported = importMesh(folder.write(name, bytes), {}, &control);
    ASSERT_FALSE(imported) << name;
    EXPECT_EQ(imported.error().code, ErrorCode::Cancelled) << name;
  }
}

} // namespace
