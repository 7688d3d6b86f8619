// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// Drawings (DXF): what becomes of each entity, what does not show, and what is refused in one sentence.
#include "tests/meshimport/dxf_text.h"
#include "tests/meshimport/import_bytes.h"

#include <gmock/gmock.h>

namespace {

using namespace esm;
using namespace esm::test;
using ::testing::HasSubstr;

TEST(Dxf, aPolylineOfFourVerticesHasThreeSegmentsAndFourIfClosed)
{
  EXPECT_EQ(contents(importBytes("a.dxf", dxf("0\nPOLYLINE\n70\n8\n" + kFourVertices))),
            "4 vertices, 3 segments, 0 triangles, 0 tetrahedra");
  EXPECT_EQ(contents(importBytes("a.dxf", dxf("0\nPOLYLINE\n70\n9\n" + kFourVertices))),
            "4 vertices, 4 segments, 0 triangles, 0 tetrahedra");
}

TEST(Dxf, aLightPolylineLiesAtItsElevation)
{
  const auto imported =
    importBytes("a.dxf", dxf("  0\nLWPOLYLINE\n 90\n3\n 70\n1\n 38\n2.5\n 10\n0\n 20\n0\n 10\n1\n"
                             " 20\n0\n 42\n0.5\n 10\n0\n 20\n1\n"));
  EXPECT_EQ(contents(imported), "3 vertices, 3 segments, 0 triangles, 0 tetrahedra");
  EXPECT_EQ(imported->mesh.position.row(2).minCoeff(), 2.5);
  EXPECT_THAT(allNotes(imported), HasSubstr("1 arcs of polylines became their chords"));
}

TEST(Dxf, facesPolyfacesAndMeshesAreFaces)
{
  const std::string face =
    "0\n3DFACE\n10\n0\n20\n0\n30\n0\n11\n1\n21\n0\n31\n0\n12\n1\n22\n1\n32\n0\n13\n1\n23\n1\n33\n0\n";
  EXPECT_EQ(contents(importBytes("a.dxf", dxf(face))), "3 vertices, 0 segments, 1 triangles, 0 tetrahedra");
  const auto corner = [](const char* x, const char* y) { return dxfVertex(x, y, "0", "70\n192\n"); };
  const std::string polyface =
    "0\nPOLYLINE\n70\n64\n71\n4\n72\n1\n" + corner("0", "0") + corner("1", "0") + corner("1", "1") +
    corner("0", "1") + dxfVertex("0", "0", "0", "70\n128\n71\n1\n72\n-2\n73\n3\n74\n4\n") + "0\nSEQEND\n";
  EXPECT_EQ(contents(importBytes("a.dxf", dxf(polyface))),
            "4 vertices, 0 segments, 2 triangles, 0 tetrahedra");
  EXPECT_EQ(contents(importBytes("a.dxf", dxf("0\nPOLYLINE\n70\n16\n71\n2\n72\n2\n" + kFourVertices))),
            "4 vertices, 0 segments, 2 triangles, 0 tetrahedra");
}

TEST(Dxf, anInsertIsScaledTurnedAndMoved)
{
  const std::string block =
    "0\nBLOCK\n2\nB\n10\n1\n20\n0\n30\n0\n0\nLINE\n10\n1\n20\n0\n30\n0\n11\n2\n21\n0\n31\n0\n"
    "0\nENDBLK\n";
  const auto imported =
    importBytes("a.dxf", dxf("0\nINSERT\n2\nB\n10\n5\n20\n5\n30\n0\n41\n3\n50\n90\n", block));
  ASSERT_EQ(contents(imported), "2 vertices, 1 segments, 0 triangles, 0 tetrahedra");
  EXPECT_TRUE(imported->mesh.position.col(0).isApprox(Eigen::Vector3d(5, 5, 0), 1e-12)); // a few roundings
  EXPECT_TRUE(imported->mesh.position.col(1).isApprox(Eigen::Vector3d(5, 8, 0), 1e-12));
}

TEST(Dxf, anInsertInRowsAndColumnsIsPlacedAtEach)
{
  const std::string block = "0\nBLOCK\n2\nB\n0\nLINE\n10\n0\n20\n0\n30\n0\n11\n1\n21\n1\n31\n0\n0\nENDBLK\n";
  const auto imported =
    importBytes("a.dxf", dxf("0\nINSERT\n2\nB\n10\n0\n20\n0\n30\n0\n70\n2\n71\n3\n44\n10\n45\n100\n", block));
  ASSERT_EQ(contents(imported), "12 vertices, 6 segments, 0 triangles, 0 tetrahedra");
  EXPECT_EQ(imported->report.boxMax, Eigen::Vector3d(11, 201, 0));
}

/// The arbitrary axis algorithm of the DXF reference: near the world's z the x axis is y cross the extrusion,
/// else z cross the extrusion.
TEST(Dxf, theExtrusionDirectionTurnsAPlanePolyline)
{
  const auto corners = [](const std::string& extrusion) {
    return importBytes(
      "a.dxf", dxf("0\nLWPOLYLINE\n90\n3\n70\n0\n10\n0\n20\n0\n10\n1\n20\n0\n10\n1\n20\n1\n" + extrusion));
  };
  const auto below = corners("210\n0\n220\n0\n230\n-1\n");
  ASSERT_EQ(contents(below), "3 vertices, 2 segments, 0 triangles, 0 tetrahedra");
  EXPECT_EQ(below->mesh.position.col(1), Eigen::Vector3d(-1, 0, 0));
  EXPECT_EQ(below->mesh.position.col(2), Eigen::Vector3d(-1, 1, 0));
  for (const bool inXz : {true, false}) { // leaning in one direction is not near the world's z
    const auto leaning = corners(inXz ? "210\n0.6\n220\n0\n230\n0.8\n" : "210\n0\n220\n0.6\n230\n0.8\n");
    const Eigen::Vector3d x = inXz ? Eigen::Vector3d(0, 1, 0) : Eigen::Vector3d(-1, 0, 0);
    const Eigen::Vector3d y = inXz ? Eigen::Vector3d(-0.8, 0, 0.6) : Eigen::Vector3d(0, -0.8, 0.6);
    EXPECT_TRUE(leaning->mesh.position.col(1).isApprox(x, 1e-15)) << inXz; // a few roundings
    EXPECT_TRUE(leaning->mesh.position.col(2).isApprox(x + y, 1e-15)) << inXz;
  }
}

TEST(Dxf, aBlockInsideItselfAndABombOfBlocksAreRefused)
{
  const std::string line = "0\nLINE\n10\n0\n20\n0\n30\n0\n11\n1\n21\n0\n31\n0\n";
  const std::string self = "0\nBLOCK\n2\nB\n" + line + "0\nINSERT\n2\nB\n0\nENDBLK\n";
  EXPECT_THAT(contents(importBytes("a.dxf", dxf("0\nINSERT\n2\nB\n", self))), HasSubstr("nested too deep"));
  std::string bomb = "0\nBLOCK\n2\nB0\n" + line + "0\nENDBLK\n";
  for (int i = 1; i < 12; ++i) { // 10^11 lines
    bomb += "0\nBLOCK\n2\nB" + std::to_string(i) + "\n";
    for (int k = 0; k < 10; ++k) bomb += "0\nINSERT\n2\nB" + std::to_string(i - 1) + "\n";
    bomb += "0\nENDBLK\n";
  }
  EXPECT_THAT(contents(importBytes("a.dxf", dxf("0\nINSERT\n2\nB11\n", bomb))),
              HasSubstr("explode them first"));
}

// === What does not show

/// A line of length 1 that begins at (x, 0, 0), with more groups.
std::string line(int x, const std::string& groups = "")
{
  return "0\nLINE\n" + groups + "10\n" + std::to_string(x) + "\n20\n0\n30\n0\n11\n" + std::to_string(x) +
         "\n21\n1\n31\n0\n";
}
/// A table of layers before the drawing: what a name is followed by are its flags and its colour.
std::string withLayers(const std::string& drawing)
{
  const auto layer = [](const char* name, const char* flags, const char* colour) {
    return std::string("0\nLAYER\n2\n") + name + "\n70\n" + flags + "\n62\n" + colour + "\n6\nCONTINUOUS\n";
  };
  return "0\nSECTION\n2\nTABLES\n0\nTABLE\n2\nLAYER\n70\n4\n" + layer("0", "0", "7") +
         layer("Frozen", "1", "7") + layer("Off", "64", "-3") + layer("Locked", "4", "5") +
         "0\nENDTAB\n0\nENDSEC\n" + drawing;
}

TEST(Dxf, theFrameInPaperSpaceIsNoPartOfTheModel)
{
  const auto imported =
    importMesh(kMeshData / "paper_space_frame.dxf"); // three lines of a model, four of a frame
  EXPECT_EQ(contents(imported), "3 vertices, 3 segments, 0 triangles, 0 tetrahedra");
  EXPECT_EQ(imported->report.boxMax.x(), 10.0);
  EXPECT_EQ(allNotes(imported).find("paper space"), allNotes(imported).find("4 entities") + 14);
}

TEST(Dxf, everyKindOfEntityInPaperSpaceIsPassedOverWithWhatBelongsToIt)
{
  const std::string block = "0\nBLOCK\n2\nB\n" + line(7) + "0\nENDBLK\n0\nBLOCK\n2\n*Paper_Space0\n" +
                            line(8) + line(9) + "0\nVIEWPORT\n67\n1\n0\nENDBLK\n";
  const auto imported =
    importBytes("a.dxf", dxf(line(0) + "0\nPOLYLINE\n67\n1\n70\n8\n" + kFourVertices +
                               "0\nLWPOLYLINE\n67\n1\n10\n0\n20\n0\n10\n5\n20\n5\n0\nINSERT\n67\n1\n2\nB\n" +
                               "0\nTEXT\n67\n1\n1\ntitle\n0\nVIEWPORT\n67\n1\n" +
                               "0\n3DFACE\n67\n1\n10\n0\n20\n0\n11\n1\n21\n0\n12\n1\n22\n1\n",
                             block));
  EXPECT_EQ(contents(imported), "2 vertices, 1 segments, 0 triangles, 0 tetrahedra");
  // five here, two on a sheet that is not at the front; a viewport is only the window to the model
  EXPECT_EQ(allNotes(imported), "7 entities in paper space were passed over.");
}

TEST(Dxf, aViewportAloneIsNotWorthANote)
{
  EXPECT_EQ(allNotes(importBytes("a.dxf", dxf(line(0) + "0\nVIEWPORT\n67\n1\n"))), "");
}

TEST(Dxf, invisibleEntitiesAndThoseOfHiddenLayersAreNoSprings)
{
  const auto imported =
    importBytes("a.dxf", withLayers(dxf(line(0) + line(1, "60\n1\n") + line(2, "8\nFROZEN\n") +
                                        line(3, "8\nOff\n") + line(4, "8\nLocked\n60\n0\n67\n0\n") +
                                        line(5, "8\nunheard of\n") + line(6, "8\nfrozen\n"))));
  EXPECT_EQ(contents(imported), "6 vertices, 3 segments, 0 triangles, 0 tetrahedra");
  EXPECT_THAT(allNotes(imported), HasSubstr("1 invisible entities were passed over."));
  EXPECT_THAT(allNotes(imported),
              HasSubstr("3 entities on layers that are frozen or off (FROZEN, Off, frozen)"));
}

/// Layer 0 of a block means the layer of its insert. A frozen insert hides all, one that is off only that.
TEST(Dxf, whatABlockShowsDependsOnTheLayerOfItsInsert)
{
  const std::string block = "0\nBLOCK\n2\nB\n" + line(0, "8\n0\n") + line(1, "8\nOwn\n") +
                            line(2, "8\nOwn\n") + line(3, "8\nOff\n") + "0\nENDBLK\n";
  const auto segments = [&](const std::string& layer) {
    return contents(
      importBytes("a.dxf", withLayers(dxf(line(9) + "0\nINSERT\n2\nB\n8\n" + layer + "\n", block))));
  };
  EXPECT_THAT(segments("0"), HasSubstr(" 4 segments"));
  EXPECT_THAT(segments("Off"), HasSubstr(" 3 segments"));
  EXPECT_THAT(segments("Frozen"), HasSubstr(" 1 segments"));
}

// === What is refused, and why

TEST(Dxf, aDrawingOfCurvesAloneIsRefusedWithTheirKindsAndAWayOut)
{
  const auto imported = importMesh(kMeshData / "only_curves.dxf");
  ASSERT_FALSE(imported);
  EXPECT_THAT(imported.error().detail, HasSubstr("only 1 CIRCLE, 1 SPLINE; convert curves to polylines"));
  const std::string solids = refusalOf("x.dxf", dxf("0\n3DSOLID\n0\n3DSOLID\n0\nTEXT\n"));
  EXPECT_THAT(solids, HasSubstr("only 2 3DSOLID, 1 TEXT; save solids and surfaces as STL"));
  EXPECT_EQ(solids.find("curves"), std::string::npos);
}

TEST(Dxf, aDrawingThatShowsNothingIsRefusedWithWhatHidesIt)
{
  EXPECT_THAT(
    refusalOf("x.dxf", withLayers(dxf(line(0, "67\n1\n") + line(1, "8\nOff\n") + line(2, "60\n1\n")))),
    HasSubstr("only 1 entities in paper space, 1 invisible entities, 1 entities on layers that are "
              "frozen or off (Off); move what is wanted to model space and show it"));
}

TEST(Dxf, damagedAndForeignDrawingsSayWhatIsWrong)
{
  EXPECT_THAT(refusalOf("x.dxf", std::string("AutoCAD Binary DXF\r\n\x1a\0 and so on", 31)),
              HasSubstr("binary DXF is not read"));
  EXPECT_THAT(refusalOf("x.dxf", dxf("0\nPOLYLINE\n70\n8\n" + kFourVertices).substr(0, 110)),
              HasSubstr("cut short"));
  EXPECT_THAT(refusalOf("x.dxf", dxf("0\nLINE\n10\n0,5\n20\n0\n30\n0\n11\n1\n21\n0\n31\n0\n")),
              HasSubstr("written with a point"));
}

} // namespace
