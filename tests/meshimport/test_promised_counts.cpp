// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// Counts in a file that the rest of it does not keep: nothing is lost without a word.
#include "tests/meshimport/import_bytes.h"

#include <gmock/gmock.h>

namespace {

using namespace esm;
using namespace esm::test;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

std::string told(const Result<ImportedMesh>& imported)
{
  return imported ? allNotes(imported) : imported.error().detail;
}

/// Elements behind a count that is too small are lost, which is said with how many and where.
TEST(PromisedCounts, whatStandsBehindACountThatIsTooSmallIsSaid)
{
  const std::string off = "OFF\n4 1 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n";
  EXPECT_THAT(told(importBytes("x.off", off + "# that is all\n\n")), Not(HasSubstr("promised")));
  EXPECT_THAT(told(importBytes("x.off", off + "3 0 1 3\n\n3 0 2 3\n")),
              HasSubstr("2 lines behind the 1 promised faces were passed over, the first is line 8."));

  const std::string old = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n",
                    nodes = "1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n", end = "$EndElements\n";
  const auto oldMesh = [&](const char* nodeCount, const char* elements) {
    return old + "$Nodes\n" + nodeCount + nodes + "$EndNodes\n$Elements\n" + elements + "$EndElements\n";
  };
  EXPECT_THAT(told(importBytes("x.msh", oldMesh("4\n", "1\n1 2 2 0 1 1 2 3\n"))), Not(HasSubstr("promised")));
  EXPECT_THAT(
    told(importBytes("x.msh", oldMesh("4\n", "1\n1 2 2 0 1 1 2 3\n2 2 2 0 1 1 2 4\n3 2 2 0 1 1 3 4\n"))),
    HasSubstr("2 lines behind the 1 promised elements were passed over, the first is line 14."));
  EXPECT_THAT(told(importBytes("x.msh", oldMesh("3\n", "1\n1 2 2 0 1 1 2 3\n"))),
              HasSubstr("1 lines behind the 3 promised nodes were passed over, the first is line 9."));
  // an element that needs a lost node: the way to the fault
  EXPECT_THAT(
    told(importBytes("x.msh", oldMesh("3\n", "1\n1 2 2 0 1 1 2 4\n"))),
    HasSubstr("line 13: there is no node 4, but an element uses it; 1 lines behind the 3 promised nodes "
              "were passed over, the first is line 9"));

  EXPECT_THAT(told(importBytes("x.msh", oldMesh("4\n", "0\n1 2 2 0 1 1 2 4\n"))),
              HasSubstr("face or tetrahedron; 1 lines behind the 0 promised elements were passed over"));

  const auto newMesh = [](const char* head, const char* blocks) {
    return std::string(
             "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 4 1 4\n2 1 0 4\n1\n2\n3\n4\n0 0 0\n1 0 0\n0 1 "
             "0\n0 0 1\n$EndNodes\n$Elements\n") +
           head + blocks + "$EndElements\n";
  };
  EXPECT_THAT(told(importBytes("x.msh", newMesh("1 1 1 1\n", "2 1 2 1\n1 1 2 3\n"))),
              Not(HasSubstr("promise")));
  EXPECT_THAT(
    told(importBytes("x.msh", newMesh("1 2 1 2\n", "2 1 2 1\n1 1 2 3\n2 1 2 4\n"))),
    AllOf(HasSubstr("1 lines behind the 1 promised elements were passed over, the first is line 20."),
          HasSubstr("The section promises 2 elements, but 1 are there; all of these were read.")));

  std::string binary = "$MeshFormat\n2.2 1 8\n";
  const auto put = [&binary](auto value) {
    binary.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  put(std::int32_t{1});
  binary += "\n$EndMeshFormat\n$Nodes\n3\n";
  for (std::int32_t node = 1; node <= 3; ++node) {
    put(node);
    put(node == 2 ? 1.0 : 0.0);
    put(node == 3 ? 1.0 : 0.0);
    put(0.0);
  }
  binary += "\n$EndNodes\n$Elements\n1\n";
  for (int twice = 0; twice < 2; ++twice)
    for (const std::int32_t number : {2, 1, 0, 1, 1, 2, 3}) put(number);
  EXPECT_THAT(told(importBytes("x.msh", binary + "\n" + end)),
              HasSubstr("28 bytes behind the last element were passed over."));
}

/// In the old VTK format the next word would have to be a keyword: there is no telling where the cells begin.
TEST(PromisedCounts, aVtkCountThatIsTooSmallIsNamedAsWhatItIs)
{
  const std::string start = "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS ",
                    points = " float\n0 0 0\n1 0 0\n0 1 0\nPOLYGONS ";
  EXPECT_THAT(told(importBytes("x.vtk", start + "2" + points + "1 4\n3 0 1 2\n")),
              HasSubstr("line 8: '0' stands behind as many numbers as were promised; is a count too small?"));
  EXPECT_THAT(
    told(importBytes("x.vtk", start + "3" + points + "1 4\n3 0 1 2\n3 0 2 1\n")),
    HasSubstr("line 11: '3' stands behind as many numbers as were promised; is a count too small?"));
  EXPECT_THAT(told(importBytes("x.vtk", start + "3" + points + "2 4\n3 0 1 2\n")),
              HasSubstr("it promises 2 cells, but it has 1; the file is damaged"));
}

/// VTU and VTP state their counts beside the arrays that hold the cells.
TEST(PromisedCounts, cellCountsThatAPieceDoesNotKeepAreSaid)
{
  const auto piece = [](const std::string& counts) {
    return "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"0.1\"><PolyData><Piece "
           "NumberOfPoints=\"3\" " +
           counts +
           "><Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">0 0 0 1 0 0 0 1 0"
           "</DataArray></Points><Polys><DataArray type=\"Int32\" Name=\"connectivity\" format=\"ascii\">0 1 "
           "2"
           "</DataArray><DataArray type=\"Int32\" Name=\"offsets\" "
           "format=\"ascii\">3</DataArray></Polys></Piece>"
           "</PolyData></VTKFile>\n";
  };
  EXPECT_THAT(told(importBytes("x.vtp", piece("NumberOfPolys=\"1\" NumberOfLines=\"0\""))),
              Not(HasSubstr("promises")));
  EXPECT_THAT(told(importBytes("x.vtp", piece(""))), Not(HasSubstr("promises"))); // many write none
  EXPECT_THAT(
    told(importBytes("x.vtp", piece("NumberOfPolys=\"7\" NumberOfLines=\"2\""))),
    AllOf(
      HasSubstr("The attribute NumberOfPolys promises 7 cells, but 1 are there; all of these were read."),
      HasSubstr("The attribute NumberOfLines promises 2 cells, but 0 are there; all of these were read.")));
}

} // namespace
