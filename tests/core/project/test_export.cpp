// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/project/export.h"

#include "core/base/file_io.h"
#include "meshimport/mesh_importer.h"
#include "tests/core/project/random_project.h"

#include <gmock/gmock.h>

#include <limits>

namespace esm {
namespace {

using testing::HasSubstr;

/// The small net, pulled out of shape.
struct Deformed {
  Project project = test::smallProject();
  Eigen::Matrix3Xd position = project.net.restPosition * 1.1 + Eigen::Matrix3Xd::Constant(3, 5, 1.0 / 3.0);
  Eigen::ArrayXd tension = Eigen::ArrayXd::LinSpaced(8, -1.0, 1.0);
  Frame frame() const { return {&project.net, &position, nullptr, &tension, 0.25}; }
};

class ReadAgain : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Formats, ReadAgain, testing::Values("obj", "ply"));

// What our importer reads back is the same shape: counts, order and every coordinate bit for bit.
TEST_P(ReadAgain, SameCountsAndPositions)
{
  const test::Scratch scratch;
  const Deformed net;
  const auto path = scratch / (std::string("net.") + GetParam());
  ASSERT_TRUE(exportFrame(net.frame(), path));
  const Result<ImportedMesh> back = importMesh(path, {false, 0.0});
  ASSERT_TRUE(back) << back.error().detail;
  EXPECT_EQ(back->mesh.position, net.position);
  EXPECT_EQ(back->mesh.triangles, net.project.net.triangles);
  EXPECT_EQ(back->report.springs, net.project.net.springCount());
}

// STL holds single precision and repeats its corners: after welding the shape is the same to 1e-7 relative.
TEST(Export, StlHoldsTheSurface)
{
  const test::Scratch scratch;
  const Deformed net;
  const auto path = scratch / "net.stl";
  ASSERT_TRUE(exportFrame(net.frame(), path));
  EXPECT_EQ(std::filesystem::file_size(path), 84u + 50u * 4u);
  const Result<ImportedMesh> back = importMesh(path);
  ASSERT_TRUE(back) << back.error().detail;
  EXPECT_EQ(back->report.nodes, 4) << "the inner node is on no triangle";
  EXPECT_EQ(back->report.triangles, 4);
  EXPECT_NEAR(back->report.boxMax[0], net.position.row(0).head(4).maxCoeff(), 1e-7);
}

TEST(Export, StlWithoutTrianglesIsRefused)
{
  const test::Scratch scratch;
  Deformed net;
  net.project.net.triangles.resize(3, 0);
  const Status status = exportFrame(net.frame(), scratch / "net.stl");
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, ErrorCode::EmptyResult);
  EXPECT_EQ(scratch.fileCount(), 0u);
}

// Struts are lines; edges of triangles would only be doubled.
TEST(Export, ObjHoldsStrutsAsLines)
{
  const test::Scratch scratch;
  const Deformed net;
  ASSERT_TRUE(exportFrame(net.frame(), scratch / "net.obj"));
  const std::string text = *readFile(scratch / "net.obj");
  EXPECT_THAT(text, testing::EndsWith("f 1 4 3\nl 1 5\nl 2 5\n"));
  EXPECT_EQ(text.find("\nl 1 2"), std::string::npos);
  EXPECT_THAT(text, HasSubstr("0.3333333333333333"));
}

TEST(Export, CsvHoldsBothTablesOverIds)
{
  const test::Scratch scratch;
  Deformed net;
  net.project.net.nodeId[0] = NodeId{40};
  net.project.net.fixed[1] = 1;
  ASSERT_TRUE(exportFrame(net.frame(), scratch / "net.csv"));
  const std::string nodes = *readFile(scratch / "net.csv"), springs = *readFile(scratch / "net_springs.csv");
  EXPECT_THAT(nodes, testing::StartsWith("id,x,y,z,mass,fixed\n40,0.3333333333333333,"));
  EXPECT_THAT(springs, testing::StartsWith("id,a,b,rest,stiffness,damping,strain,force\n0,40,2,0.01,"));
  EXPECT_EQ(std::count(nodes.begin(), nodes.end(), '\n'), 6);
  EXPECT_EQ(std::count(springs.begin(), springs.end(), '\n'), 9);
  EXPECT_EQ(nodes.find('\r'), std::string::npos);
}

TEST(Export, UnknownEndingsAndNonFiniteShapesAreRefused)
{
  const test::Scratch scratch;
  Deformed net;
  const Status ending = exportFrame(net.frame(), scratch / "net.max");
  ASSERT_FALSE(ending);
  EXPECT_EQ(ending.error().code, ErrorCode::Unsupported);
  EXPECT_THAT(ending.error().detail, HasSubstr(".obj, .ply, .stl, .glb, .gltf, .vtu, .csv, .scn, .xsp"));

  net.position(1, 3) = std::numeric_limits<double>::infinity();
  for (const char* name :
       {"net.obj", "net.ply", "net.stl", "net.glb", "net.gltf", "net.vtu", "net.csv", "net.scn", "net.xsp"}) {
    const Status status = exportFrame(net.frame(), scratch / name);
    ASSERT_FALSE(status) << name;
    EXPECT_EQ(status.error().code, ErrorCode::Numerics);
    EXPECT_THAT(status.error().detail, HasSubstr("node 3"));
  }
  EXPECT_EQ(scratch.fileCount(), 0u);
  EXPECT_FALSE(exportFrame(Deformed().frame(), scratch / "absent/net.obj"));
}

} // namespace
} // namespace esm
