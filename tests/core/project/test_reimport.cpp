// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/project/reimport.h"

#include "core/net/net_builder.h"
#include "tests/core/project/random_project.h"

#include <gmock/gmock.h>

namespace esm {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

VectorCurve still()
{
  VectorCurve curve;
  curve.time = {0.0};
  curve.value = Eigen::Vector3d(0.0, 0.0, -1.0);
  return curve;
}

/// The small project as if from a file, with node 4 pushed and node 0 fixed.
Project projectOfAFile()
{
  Project project = test::smallProject();
  project.source.files = {{"small.obj", 1}};
  project.net.fixed[0] = 1;
  project.net.nodeId[4] = NodeId{70};
  project.net.springId[2] = SpringId{90};
  project.net.tensionOnly[6] = 1;
  project.loads.forces.push_back({{4}, still()});
  return project;
}

/// The net of the project's mesh without node `gone`, made anew: all behind it move up.
SpringNet without(const Project& project, Index gone)
{
  Mesh mesh;
  const SpringNet& net = project.net;
  std::vector<Index> newOf;
  for (Index node = 0, next = 0; node < net.nodeCount(); ++node)
    newOf.push_back(node == gone ? kNoIndex : next++);
  mesh.position.resize(3, net.nodeCount() - 1);
  for (Index node = 0; node < net.nodeCount(); ++node)
    if (node != gone) mesh.position.col(newOf[static_cast<std::size_t>(node)]) = net.restPosition.col(node);
  for (const auto& ends : net.ends.colwise()) {
    const Index a = newOf[static_cast<std::size_t>(ends[0])], b = newOf[static_cast<std::size_t>(ends[1])];
    if (a == kNoIndex || b == kNoIndex) continue;
    mesh.segments.conservativeResize(2, mesh.segments.cols() + 1);
    mesh.segments.rightCols(1) << a, b;
  }
  mesh.triangles.resize(3, 1);
  mesh.triangles << 0, 1, 2;
  return buildNet(mesh).value();
}

// The same mesh again: everything is as it was, ids among it.
TEST(Reimport, TheSameNetGivesTheSameProject)
{
  const Project before = projectOfAFile();
  SpringNet net = before.net;
  for (std::size_t i = 0; i < net.nodeId.size(); ++i) net.nodeId[i] = NodeId{static_cast<Index>(i)};
  net.fixed.assign(net.fixed.size(), 0);
  const Result<Reimported> result = reimport(before, net, before.source);
  ASSERT_TRUE(result) << result.error().detail;
  EXPECT_EQ(result->unchanged, 5);
  EXPECT_THAT(result->notes, IsEmpty());
  EXPECT_EQ(result->project.net.nodeId, before.net.nodeId);
  EXPECT_EQ(result->project.net.springId, before.net.springId);
  EXPECT_EQ(result->project.net.fixed, before.net.fixed);
  EXPECT_EQ(result->project.net.tensionOnly, before.net.tensionOnly);
  EXPECT_EQ(result->project.net.stiffness.matrix(), before.net.stiffness.matrix());
  EXPECT_THAT(result->project.loads.forces.at(0).nodes, ElementsAre(4));
}

// Nodes are found by their place though every number is another one.
TEST(Reimport, LoadsFollowTheirNodes)
{
  const Project before = projectOfAFile();
  const Result<Reimported> result = reimport(before, without(before, 3), before.source);
  ASSERT_TRUE(result) << result.error().detail;
  EXPECT_EQ(result->unchanged, 4);
  EXPECT_EQ(result->gone, 1);
  EXPECT_EQ(result->added, 0);
  EXPECT_THAT(result->project.loads.forces.at(0).nodes, ElementsAre(3));
  EXPECT_EQ(result->project.net.nodeId[3], NodeId{70});
  EXPECT_THAT(result->notes, IsEmpty());
}

// What stood on a node that is gone is named, not dropped in silence.
TEST(Reimport, LostThingsAreNamed)
{
  const Project before = projectOfAFile();
  const Result<Reimported> result = reimport(before, without(before, 4), before.source);
  ASSERT_TRUE(result) << result.error().detail;
  EXPECT_THAT(result->project.loads.forces, IsEmpty());
  EXPECT_THAT(result->notes, ElementsAre("1 tension-only springs are not there any more",
                                         "force 1 is left out: none of its nodes is there any more"));
}

TEST(Reimport, NetsWithoutAFileAreRefused)
{
  Project before = projectOfAFile();
  before.source.files.clear();
  const Result<Reimported> result = reimport(before, before.net, {});
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::InvalidValue);
}

} // namespace
} // namespace esm
