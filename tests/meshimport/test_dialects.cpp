// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// Small deviations of wide-spread writers, which other programs read: the mesh arrives and what was odd is
// said.
#include "tests/meshimport/dxf_text.h"
#include "tests/meshimport/import_bytes.h"

#include <gmock/gmock.h>

#include <algorithm>

namespace {

using namespace esm;
using namespace esm::test;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

// === STL

/// A stream whose writer never went back to fill in the count; VTK and others read by the size of the file.
TEST(Dialects, aBinaryStlWithoutACountIsReadByItsSize)
{
  const auto cube = importMesh(kMeshData / "count_all_ones.stl");
  EXPECT_EQ(summary(cube), "8/18/12");
  EXPECT_THAT(allNotes(cube),
              AllOf(HasSubstr("promises 4294967295 facets, but 12 are there"), Not(HasSubstr("cut short"))));
  const auto zero = importBytes("x.stl", binaryStl(kTwoFacets, 0));
  EXPECT_EQ(summary(zero), "4/5/2");
  EXPECT_THAT(allNotes(zero), HasSubstr("promises 0 facets, but 2 are there"));
}

TEST(Dialects, aWrongCountBeforeWholeFacetsIsSaid)
{
  const auto more = importBytes("x.stl", binaryStl(kTwoFacets, 1));
  EXPECT_EQ(summary(more), "4/5/2");
  EXPECT_THAT(allNotes(more),
              AllOf(HasSubstr("promises 1 facets, but 2 are there"), Not(HasSubstr("cut short"))));
  const auto fewer = importBytes("x.stl", binaryStl(kTwoFacets, 3));
  EXPECT_EQ(summary(fewer), "4/5/2");
  EXPECT_THAT(allNotes(fewer), HasSubstr("promises 3 facets, but 2 are there; all of these were read. The "
                                         "file may be cut short."));
  // 84 + 50 * 85899346 = 2^32 + 88: in 32 bits the promise wraps to fewer bytes than there are
  EXPECT_THAT(allNotes(importBytes("x.stl", binaryStl(kTwoFacets, 85899346))),
              HasSubstr("promises 85899346 facets, but 2 are there"));
}

TEST(Dialects, whatIsNoFacetBehindTheLastOneStaysOutEvenIfItFillsWholeFacets)
{
  const std::string text = "fifty letters of a remark by the program, and more ";
  for (const std::string& tail :
       {std::string(100, '\0'), (text + text).substr(0, 100), std::string(50, '\xFF')}) {
    const auto imported = importBytes("x.stl", binaryStl(kTwoFacets, 2) + tail);
    EXPECT_EQ(summary(imported), "4/5/2");
    EXPECT_THAT(allNotes(imported), HasSubstr(std::to_string(tail.size()) + " bytes behind the last facet"));
  }
}

const std::string kFacet =
  "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";

TEST(Dialects, anAsciiStlMayWriteItsEndsInTwoWords)
{
  const auto file = importMesh(kMeshData / "end_solid_two_words.stl");
  EXPECT_EQ(summary(file), "3/3/1");
  EXPECT_THAT(allNotes(file), HasSubstr("'endsolid' is written in two"));
  const auto all = importBytes(
    "x.stl",
    "SOLID a\n" + replaced(replaced(kFacet, "endloop", "End Loop"), "endfacet", "END FACET") + "end solid\n");
  EXPECT_EQ(summary(all), "3/3/1");
  EXPECT_THAT(allNotes(all), AllOf(HasSubstr("'endfacet'"), HasSubstr("'endloop'"), HasSubstr("'endsolid'")));
}

TEST(Dialects, anAsciiStlMayLackItsSolid)
{
  for (const std::string& text : {kFacet, "\n " + kFacet + "endsolid\n", "solid\n" + kFacet + "endsolid\n",
                                  replaced("solid " + kFacet, "solid facet", "solid\nfacet") + "endsolid",
                                  "# by hand\n" + kFacet, "solid x\n" + replaced(kFacet, "\n", " ")}) {
    const auto imported = importBytes("x.stl", text);
    EXPECT_EQ(summary(imported), "3/3/1") << text;
  }
  EXPECT_EQ(allNotes(importBytes("x.stl", kFacet)), "");
}

TEST(Dialects, anAsciiStlThatEndsBehindAFacetIsReadAndDoubted)
{
  const auto imported = importBytes("x.stl", "solid x\n" + kFacet);
  EXPECT_EQ(summary(imported), "3/3/1");
  EXPECT_THAT(allNotes(imported), HasSubstr("ends without 'endsolid'; it may be cut short"));
}

TEST(Dialects, linesBetweenFacetsOfAnAsciiStlArePassedOver)
{
  const auto imported =
    importBytes("x.stl", "solid x\n color 0.5 0.5 0.5\n" + kFacet + "; half\n" + kFacet + "endsolid x\n");
  EXPECT_EQ(imported->report.triangles, 2);
  EXPECT_THAT(allNotes(imported),
              HasSubstr("2 lines between facets were passed over (the first begins with 'color')"));
}

TEST(Dialects, aFacetOfAnAsciiStlEndsWithOrWithoutItsWords)
{
  const std::string both = kFacet + replaced(kFacet, "vertex 0 0 0", "vertex 1 1 0");
  for (const char* word : {"endloop\n", "endfacet\n", "endloop\nendfacet\n"})
    EXPECT_EQ(summary(importBytes("x.stl", "solid\n" + replaced(both, word, "") + "endsolid\n")), "4/5/2")
      << word;
}

TEST(Dialects, outerLoopMayBeOneWord)
{
  EXPECT_EQ(
    summary(importBytes("x.stl", "solid\n" + replaced(kFacet, "outer loop", "outerloop") + "endsolid\n")),
    "3/3/1");
}

// === Texts

TEST(Dialects, aTextMayBePaddedBehindItsEnd)
{
  const std::string off = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  for (const std::string& padding :
       {std::string(1, '\x1A'), std::string(512, '\0'), std::string("\x1A\0\0", 3)}) {
    EXPECT_EQ(summary(importBytes("x.off", off + padding)), "3/3/1");
    EXPECT_EQ(summary(importBytes("x.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n" + padding)), "3/3/1");
    EXPECT_EQ(summary(importBytes("x.stl", "solid\n" + kFacet + "endsolid\n" + padding)), "3/3/1");
    EXPECT_EQ(summary(importBytes("x.stl", binaryStl(kTwoFacets, 2) + padding)),
              "4/5/2"); // a note, as before
  }
}

TEST(Dialects, theWordOffMayBeSmallOrMissing)
{
  const std::string counts = "3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  EXPECT_EQ(summary(importBytes("x.off", "off\n" + counts)), "3/3/1");
  EXPECT_EQ(summary(importBytes("x.off", "# by hand\n" + counts)), "3/3/1");
  EXPECT_FALSE(importBytes("x.txt", counts));
  EXPECT_FALSE(importBytes("x.off", "0 0 0\n1 0 0\n0 1 0\n")); // points
}

// === PLY

TEST(Dialects, aPlyHeaderLineWithoutTheWordCommentIsPassedOver)
{
  const auto file = importMesh(kMeshData / "header_line_without_comment.ply");
  EXPECT_EQ(summary(file), "4/6/4");
  EXPECT_THAT(
    allNotes(file),
    HasSubstr("1 header lines without the word comment were passed over (the first begins with 'Created')"));
}

std::string ply(const std::string& head, const std::string& body)
{
  return "ply\nformat ascii 1.0\n" + head + "end_header\n" + body;
}
const std::string kXyz = "property float x\nproperty float y\nproperty float z\n";
const std::string kFourPoints = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

TEST(Dialects, remarksOfAPlyMayBeginInOtherWays)
{
  for (const char* remark : {"Comment by hand\n", "COMMENT: x\n", "comments\n", "# x\n", "#x\n"})
    EXPECT_EQ(summary(importBytes("x.ply", ply("element vertex 3\n" + kXyz + remark +
                                                 "element face 1\nproperty list uchar int vertex_indices\n",
                                               "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"))),
              "3/3/1")
      << remark;
}

/// Further on an unknown word may be half of a property, and then nothing behind it is where it seems to be.
TEST(Dialects, aPlyHeaderLineAfterAnElementMustBeKnown)
{
  const auto imported =
    importBytes("x.ply", ply("element vertex 3\n" + kXyz +
                               "propert uchar red\nelement face 1\nproperty list uchar int vertex_indices\n",
                             "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"));
  ASSERT_FALSE(imported);
  EXPECT_THAT(imported.error().detail,
              AllOf(HasSubstr("line 7: a PLY header line begins with 'propert', which is no word of PLY"),
                    Not(HasSubstr("cut short"))));
}

TEST(Dialects, aPlyMayHaveNumbersOfEightBytesAndCapitals)
{
  std::string bytes =
    "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty double X\nproperty double Y\n"
    "property double Z\nelement face 1\nproperty list uint64 int64 Vertex_Indices\nend_header\n";
  for (const double x : {0., 0., 0., 1., 0., 0., 0., 1., 0.}) bytes += bytesOf(x);
  for (const std::int64_t i : {3, 0, 1, 2}) bytes += bytesOf(i);
  EXPECT_EQ(summary(importBytes("x.ply", bytes)), "3/3/1");
}

// === VTK

/// Written by VTK 9.1 itself: arrays of texts, bits, variants and ids before the points, annotations behind.
TEST(Dialects, whatVtkWritesBeforeThePointsIsPassedOver)
{
  EXPECT_EQ(contents(importMesh(kMeshData / "metadata_fielddata.vtk")),
            "6 vertices, 3 segments, 2 triangles, 0 tetrahedra");
  EXPECT_EQ(importMesh(kMeshData / "metadata_fielddata.vtk")->report.springs, 8);
  for (const char* name : {"field_arrays_ascii.vtk", "field_arrays_binary.vtk"}) {
    const auto imported = importMesh(kMeshData / name);
    ASSERT_EQ(contents(imported), "4 vertices, 0 segments, 2 triangles, 0 tetrahedra") << name;
    EXPECT_EQ(imported->report.boxMax, Eigen::Vector3d(10, 10, 0)) << name;
  }
}

/// VTK has four bytes for a vtkIdType in its files, whatever it has in memory.
TEST(Dialects, aBinaryVtkIdTypeHasFourBytes)
{
  std::string bytes = "# vtk DataFile Version 5.1\nx\nBINARY\nDATASET POLYDATA\nPOINTS 3 float\n";
  for (const float x : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f}) bytes += bytesOf(x, std::endian::big);
  bytes += "\nPOLYGONS 2 3\nOFFSETS vtkIdType\n";
  for (const int i : {0, 3}) bytes += bytesOf(i, std::endian::big);
  bytes += "\nCONNECTIVITY vtkIdType\n";
  for (const int i : {0, 1, 2}) bytes += bytesOf(i, std::endian::big);
  EXPECT_EQ(summary(importBytes("x.vtk", bytes)), "3/3/1");
}

TEST(Dialects, fieldDataThatEndsEarlyOrIsUnknownIsRefused)
{
  const std::string head = "# vtk DataFile Version 5.1\nx\nASCII\nDATASET POLYDATA\nFIELD FieldData 1\n";
  const std::string points = "POINTS 3 float\n0 0 0 1 0 0 0 1 0\nPOLYGONS 1 4\n3 0 1 2\n";
  EXPECT_EQ(summary(importBytes("x.vtk", head + "a 1 2 string\n\n\n" + points)), "3/3/1");
  EXPECT_THAT(refusalOf("x.vtk", head + "a 1 9 string\nx\n"), HasSubstr("it ends early; it is cut short"));
  EXPECT_THAT(refusalOf("x.vtk", head + "a 1 2 colour\nx\n" + points), HasSubstr("of the type 'colour'"));
  EXPECT_THAT(refusalOf("x.vtk", head + "a 1 1 double\nred\n" + points),
              AllOf(HasSubstr("'red' stands where a number should be"), Not(HasSubstr("cut short"))));
}

// === Gmsh

/// Format 1 has no line of its version: number, type, regions, count of nodes, nodes.
const std::string kMsh1 =
  "$NOD\n5\n1 0 0 0\n2 1 0 0\n7 1 1 0\n4 0 1 0\n5 0 0 1\n$ENDNOD\n$ELM\n4\n1 4 1 1 4 1 2 4 5\n"
  "2 3 1 1 4 1 2 7 4\n3 1 1 1 2 7 5\n4 15 1 1 1 1\n$ENDELM\n";

TEST(Dialects, gmshFilesOfFormatOneAreRead)
{
  const auto imported = importBytes("x.msh", kMsh1);
  EXPECT_EQ(contents(imported), "5 vertices, 1 segments, 2 triangles, 1 tetrahedra");
  EXPECT_EQ(imported->format, "Gmsh 1 (ASCII)");
  EXPECT_THAT(allNotes(imported), HasSubstr("1 single points were passed over"));
  EXPECT_EQ(contents(importBytes("x.msh", replaced(kMsh1, "NOD", "NOE"))), contents(imported));
  EXPECT_EQ(contents(importBytes("x.msh", replaced(kMsh1, "\n", "\r\n"))), contents(imported));
}

TEST(Dialects, damagedGmshFilesOfFormatOneSayWhatIsWrong)
{
  EXPECT_THAT(refusalOf("x.msh", replaced(kMsh1, "2 3 1 1 4", "2 3 1 1 3")),
              HasSubstr("element 2 has 3 nodes, its type wants 4"));
  EXPECT_THAT(refusalOf("x.msh", replaced(kMsh1, "1 2 4 5", "1 2 4 6")), HasSubstr("there is no node 6"));
  EXPECT_THAT(refusalOf("x.msh", replaced(kMsh1, "$ELM\n4", "$ELM\n4000000")),
              HasSubstr("promises 4000000 elements"));
  EXPECT_THAT(refusalOf("x.msh", kMsh1.substr(0, kMsh1.find("3 1 1 1 2"))), HasSubstr("cut short"));
  EXPECT_THAT(refusalOf("x.msh", "$NOD\n1\n1 0 0 0\n$ENDNOD\n"), HasSubstr("1 points but no line"));
}

// === DXF

TEST(Dialects, aDrawingThatEndsBehindItsEntitiesIsReadAndDoubted)
{
  const std::string drawing = "0\nSECTION\n2\nENTITIES\n0\nLINE\n10\n0\n20\n0\n11\n1\n21\n0\n0\nENDSEC\n";
  const auto imported = importBytes("x.dxf", drawing);
  EXPECT_EQ(summary(imported), "2/1/0");
  EXPECT_THAT(allNotes(imported), HasSubstr("ends without EOF; it may be cut short"));
  EXPECT_EQ(allNotes(importBytes("x.dxf", drawing + "0\nEOF\n")), "");
}

// === What is said of the end

/// "Cut short" only where something may truly be missing behind.
TEST(CutShort, isNotSaidOfFilesThatGoOn)
{
  const std::pair<const char*, std::string> whole[] = {
    {"x.off", "OFF\n3 1 0\n0 0 0\n1 zero 0\n0 1 0\n3 0 1 2\n"},
    {"x.off", "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1\n3 0 1 2\n"},
    {"x.obj", "v 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n"},
    {"x.obj", "v 0 0 0\nv 1 0 0\nf 1 2 9\nv 1 1 0\n"},
    {"x.obj", "v 0 0 0\nv 1 0 0\n"},
    {"x.ply", ply("element vertex 4\n" + kXyz + "element face 1\nproperty list uchar int vertex_indices\n",
                  "0 0 0\n1 0 0\none 1 0\n0 1 0\n3 0 1 2\n")},
    {"x.ply", ply("element vertex 4\n" + kXyz + "element face 1\nproperty list uchar int vertex_indices\n",
                  "0 0 0\n1 0 0\n1 1\n0 1 0\n3 0 1 2\n")},
    {"x.vtk", "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n0 0 0 1 0 0 0 "
              "1\nPOLYGONS 1 4\n3 0 1 2\n"},
    {"x.stl", "solid x\nfacet normal 0 0 1\nouter lop\nvertex 0 0 0\nendloop\nendfacet\nendsolid\n"},
    {"x.dae", "<?xml version=\"1.0\"?><COLLADA "
              "version=\"1.4.1\"><asset><up_axis>Q</up_axis></asset><scene/></COLLADA>"},
    {"x.3ds", "no 3DS at all"}};
  for (const auto& [name, bytes] : whole) {
    const std::string text = refusalOf(name, bytes);
    EXPECT_THAT(text, AllOf(HasSubstr(name), Not(HasSubstr("cut short")))) << bytes;
  }
}

TEST(CutShort, isSaidOfFilesThatEndTooEarly)
{
  const std::pair<const char*, std::string> cut[] = {
    {"x.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1"},
    {"x.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 9"},
    {"x.obj", "v 0 0 0\nv 1 0"},
    {"x.ply", ply("element vertex 3\n" + kXyz + "element face 2\nproperty list uchar int vertex_indices\n",
                  "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 1 ")},
    {"x.vtk", "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n0 0 0 1 0 0 0 1\n"},
    {"x.stl", "solid x\n" + kFacet.substr(0, 60)},
    {"x.dxf", "0\nSECTION\n2\nENTITIES\n0\nLINE\n10\n0\n20\n0\n"}};
  for (const auto& [name, bytes] : cut) EXPECT_THAT(refusalOf(name, bytes), HasSubstr("cut short")) << bytes;
}

// === Numbers of any format

/// Programs in Fortran write numbers of double precision with D, or without a letter where the exponent has three
/// digits: all text formats that have readers of their own.
TEST(Dialects, exponentsAsFortranWritesThemAreRead)
{
  const std::string a = "0.0D+00 0.0D+00 0.0D+00\n", b = "1.0D+01 0.0D+00 0.0D+00\n",
                    c = "1.0-101 2.5d-1 0.0D+00\n", all = a + b + c;
  const auto oneLine = [](std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text + "\n";
  };
  const std::pair<const char*, std::string> files[] = {
    {"x.stl", "solid x\nfacet normal 0.0D+00 0.0D+00 1.0D+00\nouter loop\nvertex " + a + "vertex " + b +
                "vertex " + c + "endloop\nendfacet\nendsolid x\n"},
    {"x.obj", "v " + a + "v " + b + "v " + c + "f 1 2 3\n"},
    {"x.off", "OFF\n3 1 3\n" + all + "3 0 1 2\n"},
    {"x.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\n"
              "property double z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n" +
                all + "3 0 1 2\n"},
    {"x.vtk", "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 3 double\n" + all +
                "POLYGONS 1 4\n3 0 1 2\n"},
    {"x.vtp",
     "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"0.1\"><PolyData><Piece "
     "NumberOfPoints=\"3\" NumberOfPolys=\"1\"><Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" "
     "format=\"ascii\">" +
       all +
       "</DataArray></Points><Polys><DataArray type=\"Int32\" Name=\"connectivity\" format=\"ascii\">0 1 2"
       "</DataArray><DataArray type=\"Int32\" Name=\"offsets\" format=\"ascii\">3</DataArray></Polys></Piece>"
       "</PolyData></VTKFile>\n"},
    {"x.msh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n3\n1 " + a + "2 " + b + "3 " + c +
                "$EndNodes\n$Elements\n1\n1 2 2 0 1 1 2 3\n$EndElements\n"},
    {"x.raw", oneLine(all)},
    {"x.dxf", dxf("0\n3DFACE\n8\n0\n10\n0.0D+00\n20\n0.0D+00\n30\n0.0D+00\n11\n1.0D+01\n21\n0.0D+00\n31\n"
                  "0.0D+00\n12\n1.0-101\n22\n2.5d-1\n32\n0.0D+00\n13\n1.0-101\n23\n2.5d-1\n33\n0.0D+00\n")}};
  for (const auto& [name, bytes] : files) {
    const auto imported = importBytes(name, bytes);
    EXPECT_EQ(summary(imported), "3/3/1") << name;
    if (!imported) continue;
    EXPECT_EQ(imported->report.boxMin, Eigen::Vector3d(0, 0, 0)) << name;
    EXPECT_EQ(imported->report.boxMax, Eigen::Vector3d(10, 0.25, 0)) << name;
  }
}

} // namespace
