// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// The PLY format fixes no names: faces, lines and tetrahedra in the elements of several writers.
#include "tests/meshimport/import_bytes.h"

#include <Eigen/Geometry>
#include <gmock/gmock.h>

namespace {

using namespace esm;
using namespace esm::test;
using ::testing::HasSubstr;

/// An ASCII PLY over the corners of a unit square and a point above it.
std::string squarePly(const std::string& elements, const std::string& rows,
                      const std::string& vertex = "vertex")
{
  return "ply\nformat ascii 1.0\nelement " + vertex +
         " 5\nproperty float x\nproperty float y\nproperty float z\n" + elements +
         "end_header\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n" + rows;
}
std::string listElement(const std::string& name, int count, const std::string& list = "vertex_indices",
                        const std::string& types = "int int")
{
  return "element " + name + " " + std::to_string(count) + "\nproperty list " + types + " " + list + "\n";
}

TEST(PlyElements, stripsOfTrianglesBeginAnewAtMinusOne)
{
  const auto imported = importMesh(kMeshData / "tristrips.ply"); // ten corners in one strip, four in another
  EXPECT_EQ(summary(imported), "14/22/10");
  EXPECT_THAT(allNotes(imported), HasSubstr("1 of the element 'tristrips' were read as strips of triangles"));
}

TEST(PlyElements, everyOtherTriangleOfAStripIsTurnedRound)
{
  for (const std::string& bytes :
       {squarePly(listElement("tristrips", 1), "4 0 1 2 3\n"),
        squarePly(listElement("TriStrip", 2), "4 0 1 2 3\n1 -1\n"),
        squarePly(listElement("strip", 1, "indices"), "9 -1 0 1 2 3 -1 4 4 -1\n")}) {
    const auto imported = importBytes("x.ply", bytes);
    ASSERT_EQ(contents(imported), "5 vertices, 0 segments, 2 triangles, 0 tetrahedra") << bytes;
    const Mesh& mesh = imported->mesh;
    for (Index t = 0; t < 2; ++t) { // both look up
      const Eigen::Vector3d a = mesh.position.col(mesh.triangles(0, t));
      const Eigen::Vector3d b = mesh.position.col(mesh.triangles(1, t));
      const Eigen::Vector3d c = mesh.position.col(mesh.triangles(2, t));
      EXPECT_EQ((b - a).cross(c - a), Eigen::Vector3d(0, 0, 1)) << t;
    }
  }
}

/// A corner twice makes no triangle but keeps the turn: 0 1 2 | 2 1 3 becomes 0 1 2 2 ... in one strip.
TEST(PlyElements, stitchesInAStripAreNoTriangles)
{
  const auto imported = importBytes("x.ply", squarePly(listElement("tristrips", 1), "7 0 1 2 2 2 1 3\n"));
  EXPECT_EQ(contents(imported), "5 vertices, 0 segments, 2 triangles, 0 tetrahedra");
}

TEST(PlyElements, aStripRestartsAtMinusOneInUnsignedNumbersToo)
{
  std::string bytes =
    "ply\nformat binary_big_endian 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
    "property float z\nelement tristrips 1\nproperty list int uint vertex_indices\nend_header\n";
  for (const float x : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f, 1.f, 1.f, 0.f})
    bytes += bytesOf(x, std::endian::big);
  for (const int i : {8, 0, 1, 2, -1, 1, 3, 2, -1}) bytes += bytesOf(i, std::endian::big);
  EXPECT_EQ(contents(importBytes("x.ply", bytes)), "4 vertices, 0 segments, 2 triangles, 0 tetrahedra");
}

TEST(PlyElements, facesMayHaveOtherNames)
{
  const std::string row = "3 0 1 2\n3 1 3 2\n";
  for (const char* name :
       {"face", "faces", "Face", "polygon", "polygons", "triangle", "triangles", "tri", "facet"})
    for (const char* list : {"vertex_indices", "vertex_index", "indices", "vertices"})
      EXPECT_EQ(contents(importBytes("x.ply", squarePly(listElement(name, 2, list), row))),
                "5 vertices, 0 segments, 2 triangles, 0 tetrahedra")
        << name << " " << list;
  const auto surface =
    importBytes("x.ply", squarePly(listElement("surface_patch", 2), row)); // its list says enough
  EXPECT_EQ(contents(surface), "5 vertices, 0 segments, 2 triangles, 0 tetrahedra");
  EXPECT_THAT(allNotes(surface), HasSubstr("2 of the element 'surface_patch' were read as faces"));
  EXPECT_EQ(contents(importBytes("x.ply", squarePly(listElement("quads", 1), "4 0 1 3 2\n"))),
            "5 vertices, 0 segments, 2 triangles, 0 tetrahedra");
  EXPECT_EQ(contents(importBytes("x.ply", squarePly(listElement("trifans", 1), "4 0 1 3 2\n"))),
            "5 vertices, 0 segments, 2 triangles, 0 tetrahedra");
}

TEST(PlyElements, facesBesideStripsAreBothRead)
{
  const auto imported = importBytes(
    "x.ply", squarePly(listElement("face", 1) + listElement("tristrips", 1), "3 0 1 4\n4 0 1 2 3\n"));
  EXPECT_EQ(contents(imported), "5 vertices, 0 segments, 3 triangles, 0 tetrahedra");
}

TEST(PlyElements, verticesAndLinesMayHaveOtherNames)
{
  EXPECT_EQ(contents(importBytes("x.ply", squarePly(listElement("face", 1), "3 0 1 2\n", "vertices"))),
            "5 vertices, 0 segments, 1 triangles, 0 tetrahedra");
  for (const char* ends : {"vertex1 vertex2", "v1 v2", "start end"}) {
    const std::string names(ends);
    const std::string first = names.substr(0, names.find(' ')), second = names.substr(names.find(' ') + 1);
    EXPECT_EQ(contents(importBytes("x.ply", squarePly("element lines 2\nproperty int " + first +
                                                        "\nproperty int " + second + "\n",
                                                      "0 1\n1 3\n"))),
              "5 vertices, 2 segments, 0 triangles, 0 tetrahedra")
      << ends;
  }
  EXPECT_EQ(contents(importBytes("x.ply", squarePly(listElement("polyline", 2), "3 0 1 3\n2 4 0\n"))),
            "5 vertices, 3 segments, 0 triangles, 0 tetrahedra");
}

TEST(PlyElements, tetrahedraAreRead)
{
  const auto imported = importBytes("x.ply", squarePly(listElement("voxel", 2), "4 0 1 2 4\n3 0 1 2\n"));
  EXPECT_EQ(contents(imported), "5 vertices, 0 segments, 0 triangles, 1 tetrahedra");
  EXPECT_THAT(allNotes(imported), HasSubstr("1 cells that are no tetrahedra were passed over"));
}

TEST(PlyElements, whatHoldsNoFacesIsNamedForWhatItHolds)
{
  EXPECT_THAT(refusalOf("x.ply", squarePly("", "")),
              HasSubstr("5 vertices but no face and no edge; a point cloud makes no net"));
  EXPECT_THAT(refusalOf("x.ply", squarePly("element camera 1\nproperty float f\n", "1\n")),
              HasSubstr("a point cloud makes no net"));
  // scans of laser scanners: each place of a grid holds no point or one
  EXPECT_THAT(refusalOf("x.ply", squarePly(listElement("range_grid", 6), "1 0\n1 1\n0\n1 2\n1 3\n1 4\n")),
              HasSubstr("a range grid is a scan that must be triangulated first"));
  EXPECT_THAT(refusalOf("x.ply", squarePly(listElement("surfel", 1, "neighbours"), "3 0 1 2\n")),
              HasSubstr("it has lists in the element 'surfel', which is none of those that are known"));
  EXPECT_THAT(refusalOf("x.ply", squarePly(listElement("tristrips", 1), "4 0 1 2 9\n")),
              HasSubstr("tristrips 1: there is no vertex 9"));
}

} // namespace
