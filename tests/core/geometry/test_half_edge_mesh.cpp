// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/geometry/repair/sheets.h"
#include "tests/core/geometry/shapes.h"
#include "tests/core/net/meshes.h"

#include <gtest/gtest.h>

namespace {

using namespace esm;
using namespace esm::test;

/// Twins are each other's, run in opposite directions, and every vertex' first half-edge starts at it, on
/// borders at the border.
void expectConsistent(const HalfEdgeMesh& mesh)
{
  Index live = 0;
  for (Index h = 0; h < mesh.halfEdges(); ++h) {
    if (!mesh.isLive(h)) continue;
    live += h % 3 == 0;
    const Index twin = mesh.twinOf(h);
    if (twin == kNoIndex) {
      EXPECT_EQ(mesh.firstOut[static_cast<std::size_t>(mesh.from(h))], h);
      EXPECT_TRUE(mesh.isCurve[static_cast<std::size_t>(h)]);
      continue;
    }
    ASSERT_TRUE(mesh.isLive(twin));
    EXPECT_EQ(mesh.twinOf(twin), h);
    EXPECT_EQ(mesh.from(twin), mesh.to(h));
    EXPECT_EQ(mesh.to(twin), mesh.from(h));
    EXPECT_EQ(mesh.isCurve[static_cast<std::size_t>(h)], mesh.isCurve[static_cast<std::size_t>(twin)]);
  }
  EXPECT_EQ(live, mesh.liveTriangles);
  for (Index v = 0; v < mesh.vertices(); ++v) {
    const Index out = mesh.firstOut[static_cast<std::size_t>(v)];
    if (out != kNoIndex) {
      ASSERT_TRUE(mesh.isLive(out));
      EXPECT_EQ(mesh.from(out), v);
    }
  }
}

Mesh plainMesh(const HalfEdgeMesh& surface)
{
  Mesh mesh;
  mesh.position.resize(3, surface.vertices());
  for (Index v = 0; v < surface.vertices(); ++v)
    mesh.position.col(v) = surface.position[static_cast<std::size_t>(v)];
  mesh.triangles.resize(3, surface.liveTriangles);
  Index t = 0;
  for (Index h = 0; h < surface.halfEdges(); h += 3)
    if (surface.isLive(h)) mesh.triangles.col(t++) << surface.from(h), surface.to(h), surface.apex(h);
  return mesh;
}

// Thousands of random splits, collapses and flips: the topology stays, and so do all links.
TEST(HalfEdgeMesh, randomChangesKeepTopology)
{
  std::mt19937_64 random(9);
  for (const Mesh& start : {sphere(4), torus(8, 6), tube(8, 4, 1.0), grid(5), cube()}) {
    HalfEdgeMesh surface =
      cutToSheets(start, std::vector<std::uint8_t>(static_cast<std::size_t>(start.vertexCount()), 0)).surface;
    markCurves(surface, 0.5);
    const Index euler = eulerCharacteristic(start);
    for (int i = 0; i < 3000; ++i) {
      const auto h = static_cast<Index>(random() % static_cast<unsigned>(surface.halfEdges()));
      if (!surface.isLive(h)) continue;
      const auto kind = random() % 3;
      if (kind == 0 && surface.liveTriangles < 400)
        surface.split(h, 0.5 * (surface.position[static_cast<std::size_t>(surface.from(h))] +
                                surface.position[static_cast<std::size_t>(surface.to(h))]));
      const Index gone = random() & 1 ? surface.from(h) : surface.to(h);
      const bool mayGo = surface.twinOf(h) == kNoIndex || !surface.isOnBorder(gone);
      if (kind == 1 && mayGo && surface.canCollapse(h, gone)) surface.collapse(h, gone);
      if (kind == 2 && surface.canFlip(h)) surface.flip(h);
      if (i % 500 == 0) expectConsistent(surface);
    }
    expectConsistent(surface);
    EXPECT_EQ(eulerCharacteristic(plainMesh(surface)), euler);
  }
}

TEST(HalfEdgeMesh, aTetrahedronCannotBecomeLess)
{
  const Mesh mesh =
    makeMesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
  HalfEdgeMesh surface = cutToSheets(mesh, std::vector<std::uint8_t>(4, 0)).surface;
  for (Index h = 0; h < 12; ++h) {
    EXPECT_FALSE(surface.canCollapse(h, surface.from(h)));
    EXPECT_FALSE(surface.canFlip(h)); // the other diagonal is there already
  }
}

// Three triangles on one edge become three sheets, whose copies of its ends know where they come from.
TEST(HalfEdgeMesh, pagesOfABookAreThreeSheets)
{
  const Mesh mesh =
    makeMesh({{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}}, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
  const Sheets sheets = cutToSheets(mesh, std::vector<std::uint8_t>(5, 0));
  EXPECT_EQ(sheets.surface.vertices(), 9);
  for (Index v = 0; v < 9; ++v)
    EXPECT_EQ(sheets.surface.position[static_cast<std::size_t>(v)],
              mesh.position.col(sheets.origin[static_cast<std::size_t>(v)]));
}

} // namespace
