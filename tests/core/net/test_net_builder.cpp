// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/net/net_builder.h"
#include "tests/core/net/meshes.h"

#include <gmock/gmock.h>

#include <cmath>

namespace {

using namespace esm;
using namespace esm::test;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::vector<std::pair<Index, Index>> endsOf(const SpringNet& net)
{
  std::vector<std::pair<Index, Index>> ends;
  for (Index s = 0; s < net.springCount(); ++s) ends.emplace_back(net.ends(0, s), net.ends(1, s));
  return ends;
}

Mesh tetrahedron()
{
  return makeMesh({{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}});
}

TEST(NetBuilder, tetrahedronHasSixSpringsInTheOrderOfTheirFirstAppearance)
{
  const Result<SpringNet> net = buildNet(tetrahedron());
  ASSERT_TRUE(net);
  EXPECT_THAT(endsOf(*net), ElementsAre(std::pair{0, 2}, std::pair{1, 2}, std::pair{0, 1}, std::pair{1, 3},
                                        std::pair{0, 3}, std::pair{2, 3}));
  EXPECT_EQ(net->restLength[0], 2);
  EXPECT_DOUBLE_EQ(net->restLength[1], std::sqrt(5.0));
  EXPECT_DOUBLE_EQ(net->restLength[5], std::sqrt(13.0));
  EXPECT_EQ(net->springId[5], SpringId{5});
  EXPECT_EQ(net->nodeId[3], NodeId{3});
  EXPECT_EQ(net->triangles, tetrahedron().triangles);
  EXPECT_TRUE(checkNet(*net));
}

TEST(NetBuilder, cubeKeepsVerticesInOrderAndWaitsForItsTissue)
{
  std::vector<Index> nodeOf;
  const Result<SpringNet> net = buildNet(cube(), &nodeOf);
  ASSERT_TRUE(net);
  EXPECT_EQ(net->nodeCount(), 8);
  EXPECT_EQ(net->springCount(), 18);
  EXPECT_EQ(net->restPosition, cube().position);
  EXPECT_THAT(nodeOf, ElementsAre(0, 1, 2, 3, 4, 5, 6, 7));
  EXPECT_TRUE((net->mass == 1.0).all());
  EXPECT_TRUE((net->stiffness == 0.0).all());
  EXPECT_EQ(std::count(net->kind.begin(), net->kind.end(), SpringKind::Edge), 18);
}

TEST(NetBuilder, linesComeAfterEdgesAndOnlyIfTheyAreNoEdge)
{
  Mesh mesh = tetrahedron();
  mesh.position.conservativeResize(3, 5);
  mesh.position.col(4) << 1, 1, 1;
  mesh.segments.resize(2, 3);
  mesh.segments << 4, 2, 0, /**/ 0, 1, 4; // 4-0, 2-1 (an edge), 0-4 (again)
  const Result<SpringNet> net = buildNet(mesh);
  ASSERT_TRUE(net);
  ASSERT_EQ(net->springCount(), 7);
  EXPECT_EQ(net->ends(0, 6), 0);
  EXPECT_EQ(net->ends(1, 6), 4);
  EXPECT_EQ(net->kind[5], SpringKind::Edge);
  EXPECT_EQ(net->kind[6], SpringKind::Line);
}

TEST(NetBuilder, defectsLeaveTheNetAndTheMapSaysWhere)
{
  // Vertex 0 isolated, 3 is NaN, 5 lies exactly on 1 (a spring of zero length between them).
  const Mesh mesh = makeMesh({{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {kNaN, 0, 0}, {0, 1, 0}, {0, 0, 0}},
                             {{1, 2, 4}, {4, 2, 1}, {1, 2, 3}, {1, 1, 2}, {1, 5, 2}});
  std::vector<Index> nodeOf;
  const Result<SpringNet> net = buildNet(mesh, &nodeOf);
  ASSERT_TRUE(net);
  EXPECT_THAT(nodeOf, ElementsAre(kNoIndex, 0, 1, kNoIndex, 2, 3));
  EXPECT_THAT(endsOf(*net), ElementsAre(std::pair{0, 1}, std::pair{1, 2}, std::pair{0, 2}, std::pair{1, 3}));
  EXPECT_EQ(net->triangleCount(), 2); // (1 2 4) and the thin but well-indexed (1 5 2)
  EXPECT_TRUE(checkNet(*net));
}

TEST(NetBuilder, nothingToBuildIsAnError)
{
  EXPECT_EQ(buildNet(Mesh{}).error().code, ErrorCode::EmptyResult);
  EXPECT_EQ(buildNet(makeMesh({{0, 0, 0}, {0, 0, 0}}, {{0, 1, 0}})).error().code, ErrorCode::EmptyResult);
}

TEST(NetBuilder, anIndexOutOfRangeIsNamed)
{
  const Error error = buildNet(makeMesh({{0, 0, 0}, {1, 0, 0}}, {{0, 1, 2}})).error();
  EXPECT_EQ(error.code, ErrorCode::InvalidValue);
  EXPECT_THAT(error.detail, HasSubstr("triangle 0 uses vertex 2"));
  EXPECT_EQ(buildNet(makeMesh({{0, 0, 0}, {1, 0, 0}}, {}, {{-1, 1}})).error().code, ErrorCode::InvalidValue);
}

TEST(NetBuilder, lengthsAtTheEdgesOfDoubleAreNeitherZeroNorInfinite)
{
  const Result<SpringNet> net =
    buildNet(makeMesh({{0, 0, 0}, {1e200, 0, 0}, {0, 1e-200, 0}}, {}, {{0, 1}, {0, 2}}));
  ASSERT_TRUE(net);
  EXPECT_DOUBLE_EQ(net->restLength[0], 1e200);
  EXPECT_DOUBLE_EQ(net->restLength[1], 1e-200);
  const Mesh apart = makeMesh({{-1.7e308, 0, 0}, {1.7e308, 0, 0}}, {}, {{0, 1}});
  EXPECT_EQ(buildNet(apart).error().code, ErrorCode::InvalidValue);
}

TEST(DualAreas, shareOutTheWholeSurface)
{
  const SpringNet net = *buildNet(cube());
  const Eigen::ArrayXd nodes = nodeDualAreas(net), edges = edgeTriangleAreas(net);
  EXPECT_NEAR(nodes.sum(), 6.0, 1e-14);      // six unit squares; rounding of 36 terms
  EXPECT_NEAR(edges.sum(), 3 * 6.0, 1e-14);  // every triangle adjoins three edges
  EXPECT_TRUE((edges == 1.0).all());         // each edge of the cube lies between two half squares
  EXPECT_DOUBLE_EQ(nodes[0], 5 * 0.5 / 3.0); // corner 0 meets five triangles
}

TEST(DualAreas, linesHaveNoSurface)
{
  Mesh mesh = tetrahedron();
  mesh.position.conservativeResize(3, 5);
  mesh.position.col(4) << 1, 1, 1;
  mesh.segments.resize(2, 1);
  mesh.segments << 0, 4;
  const SpringNet net = *buildNet(mesh);
  EXPECT_EQ(edgeTriangleAreas(net)[6], 0);
  EXPECT_EQ(nodeDualAreas(net)[4], 0);
  EXPECT_DOUBLE_EQ(edgeTriangleAreas(net)[2], 0.5 * 1 * 2 + 0.5 * 1 * 3); // edge 0-1
}

} // namespace
