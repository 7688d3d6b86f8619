// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/quality/hinges.h"
#include "core/quality/quality.h"
#include "core/structure/support.h"
#include "core/tissue/tissue_model.h"
#include "tests/core/structure/bodies.h"

#include <cmath>

namespace esm {
namespace {

using test::boxMesh;
using test::netOf;
using test::organMesh;
using test::tubeMesh;
using FindingKind = QualityFinding::Kind;

QualityReport judge(const SpringNet& net)
{
  const auto report = judgeNet(net);
  if (!report) {
    ADD_FAILURE() << report.error().detail;
    return {};
  }
  return *report;
}

bool has(const QualityReport& report, FindingKind kind)
{
  for (const QualityFinding& finding : report.findings)
    if (finding.kind == kind) return true;
  return false;
}

/// Tissue without any bed around it.
SpringNet tissueNet(const Mesh& mesh, bool withStruts)
{
  SpringNet net = netOf(mesh);
  if (withStruts) {
    SupportOptions options;
    options.interior = SupportOptions::Interior::Struts;
    EXPECT_TRUE(addSupport(net, options));
  }
  EXPECT_TRUE(applyTissue(defaultTissue(), net));
  net.anchors = {};
  return net;
}

/// Two tetrahedra of six springs that share `shared` nodes.
SpringNet twoTetrahedra(int shared)
{
  SpringNet net;
  std::vector<std::array<Index, 2>> springs;
  const Index nodes = 8 - shared;
  resizeNet(net, nodes, 0);
  Eigen::Matrix3Xd corners(3, 4);
  corners << 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 1; // 0, y, x, z
  net.restPosition.leftCols(4) = corners;
  for (Index i = 4; i < nodes; ++i)
    net.restPosition.col(i) = -corners.col(i - 4 + shared) + Eigen::Vector3d(0.1, 0, 0);
  for (Index t = 0; t < 2; ++t)
    for (Index i = 0; i < 4; ++i)
      for (Index j = i + 1; j < 4; ++j) {
        const auto nodeOf = [&](Index corner) {
          return t == 0 || corner < shared ? corner : corner + 4 - shared;
        };
        if (t == 1 && j < shared) continue; // theirs already
        springs.push_back({nodeOf(i), nodeOf(j)});
      }
  const Eigen::Matrix3Xd position = net.restPosition;
  resizeNet(net, nodes, static_cast<Index>(springs.size()));
  net.restPosition = position;
  for (std::size_t s = 0; s < springs.size(); ++s) {
    net.ends.col(static_cast<Eigen::Index>(s)) << springs[s][0], springs[s][1];
    net.restLength[static_cast<Eigen::Index>(s)] =
      (position.col(springs[s][0]) - position.col(springs[s][1])).norm();
  }
  net.stiffness.setConstant(100.0);
  return net;
}

// Maxwell's count: two tetrahedra that share an edge have one motion besides the rigid ones (the hinge), that
// share a node three, that share nothing none (but two rigid bodies).
TEST(Quality, CountsMechanismsExactly)
{
  EXPECT_EQ(judge(twoTetrahedra(3)).mechanisms, 0);
  EXPECT_EQ(judge(twoTetrahedra(2)).mechanisms, 1);
  EXPECT_EQ(judge(twoTetrahedra(1)).mechanisms, 3);
  EXPECT_EQ(judge(twoTetrahedra(0)).mechanisms, 0);
}

TEST(Quality, FindsTheNodeThatTwoPartsHangAt)
{
  EXPECT_EQ(hingeNodes(twoTetrahedra(1)), (std::vector<Index>{0}));
  EXPECT_TRUE(hingeNodes(twoTetrahedra(2)).empty());
  EXPECT_TRUE(has(judge(twoTetrahedra(1)), FindingKind::HingeNode));
}

// Two boxes that share one edge of their surface.
TEST(Quality, FindsTheLineThatTwoPartsSwingAbout)
{
  const Mesh box = boxMesh({0.02, 0.02, 0.02}, 0.01);
  Mesh both = box;
  both.position.conservativeResize(Eigen::NoChange, 2 * box.position.cols());
  both.position.rightCols(box.position.cols()) = box.position.colwise() - Eigen::Vector3d(0.02, 0.02, 0);
  both.triangles.conservativeResize(Eigen::NoChange, 2 * box.triangles.cols());
  both.triangles.rightCols(box.triangles.cols()) = box.triangles.array() + box.vertexCount();
  for (Eigen::Index i = 0; i < both.triangles.size(); ++i) { // weld
    Index& vertex = both.triangles.data()[i];
    for (Index v = 0; v < vertex; ++v)
      if ((both.position.col(v) - both.position.col(vertex)).norm() < 1e-9) vertex = v;
  }
  const SpringNet net = netOf(both);
  const auto lines = hingeLines(net);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0].size(), 3U);
  EXPECT_TRUE(hingeLines(netOf(box)).empty());
}

// Faces of a box are flat: nothing holds their inner nodes across. With struts all nodes are held.
TEST(Quality, ABoxWithoutStrutsIsWarnedAboutWithStrutsItCarries)
{
  const QualityReport bare = judge(tissueNet(boxMesh({0.03, 0.03, 0.03}, 0.005), false));
  EXPECT_FALSE(bare.carriesLoad());
  EXPECT_TRUE(has(bare, FindingKind::NothingInside));
  EXPECT_TRUE(has(bare, FindingKind::FlatNodes));
  EXPECT_TRUE(has(bare, FindingKind::Mechanisms));
  EXPECT_TRUE(has(bare, FindingKind::Unheld));
  const QualityReport braced = judge(tissueNet(boxMesh({0.03, 0.03, 0.03}, 0.005), true));
  EXPECT_TRUE(braced.carriesLoad()) << braced.findings.front().text;
  EXPECT_TRUE(has(braced, FindingKind::Carries));
  EXPECT_EQ(braced.mechanisms, 0);
  EXPECT_LT(braced.dent, 0.1 * bare.dent);
  EXPECT_GT(braced.frequency, 1.0);
}

TEST(Quality, ANetWithoutStiffnessIsNotJudged)
{
  EXPECT_EQ(judgeNet(netOf(boxMesh({0.02, 0.02, 0.02}, 0.01))).error().code, ErrorCode::InvalidValue);
}

} // namespace
} // namespace esm
