// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/structure/support.h"
#include "core/tissue/tissue_model.h"
#include "tests/core/structure/bodies.h"

#include <cmath>
#include <set>

namespace esm {
namespace {

using test::boxMesh;
using test::netOf;
using test::organMesh;
using test::supported;
using test::tubeMesh;
using Interior = SupportOptions::Interior;

SupportOptions interior(Interior kind)
{
  SupportOptions options;
  options.interior = kind;
  return options;
}

void expectSame(const SpringNet& a, const SpringNet& b)
{
  EXPECT_EQ(a.restPosition, b.restPosition);
  EXPECT_EQ(a.ends, b.ends);
  EXPECT_TRUE(a.restLength.size() == b.restLength.size() && (a.restLength == b.restLength).all());
  EXPECT_TRUE(a.stiffness.size() == b.stiffness.size() && (a.stiffness == b.stiffness).all());
  EXPECT_TRUE(a.mass.size() == b.mass.size() && (a.mass == b.mass).all());
  EXPECT_EQ(a.kind, b.kind);
  EXPECT_EQ(a.springId, b.springId);
  EXPECT_EQ(a.nodeId, b.nodeId);
  EXPECT_EQ(a.anchors.node, b.anchors.node);
  EXPECT_EQ(a.anchors.bandLength.size(), b.anchors.bandLength.size());
  EXPECT_EQ(a.section.size(), b.section.size());
  EXPECT_EQ(a.volume.size(), b.volume.size());
  EXPECT_EQ(a.supportNode, b.supportNode);
  EXPECT_EQ(a.triangles, b.triangles);
}

bool hasDoubles(const SpringNet& net)
{
  std::set<std::pair<Index, Index>> seen;
  for (Index s = 0; s < net.springCount(); ++s)
    if (!seen.emplace(net.ends.col(s).minCoeff(), net.ends.col(s).maxCoeff()).second) return true;
  return false;
}

TEST(Support, TheDefaultsAddNothing)
{
  const SpringNet before = netOf(boxMesh({0.02, 0.02, 0.02}, 0.005));
  SpringNet net = before;
  supported(net, {});
  expectSame(net, before);
}

// A box has its walls in right angles, so that the struts of the inner nodes of a face are as long as the
// box; nodes of edges look inwards along the diagonal. Rays that hit a vertex snap to it exactly.
TEST(Support, StrutsAlongTheNormalOfASlabCrossItStraight)
{
  SpringNet net = netOf(boxMesh({0.06, 0.05, 0.01}, 0.005));
  SupportOptions options = interior(Interior::Struts);
  options.strutsPerNode = 1;
  const Index before = net.springCount();
  const SupportReport report = supported(net, options);
  ASSERT_EQ(net.springCount(), before + report.springs);
  EXPECT_FALSE(hasDoubles(net));
  Index straight = 0;
  for (Index s = before; s < net.springCount(); ++s) {
    EXPECT_EQ(net.kind[static_cast<std::size_t>(s)], SpringKind::Strut);
    const Eigen::Vector3d along = net.restPosition.col(net.ends(1, s)) - net.restPosition.col(net.ends(0, s));
    straight += along.head<2>().norm() < 1e-12 && std::abs(std::abs(along[2]) - 0.01) < 1e-12;
  }
  EXPECT_GE(straight, 11 * 9); // one for each pair of inner nodes of the two large faces
}

// All struts of a slab together are as wide as its surface seen from both sides: half of it.
TEST(Support, SectionsAddUpToHalfTheSurface)
{
  SpringNet net = netOf(organMesh({0.03, 0.02, 0.015}, 8));
  const SupportReport report = supported(net, interior(Interior::Struts));
  EXPECT_TRUE(report.unsupported.empty());
  EXPECT_NEAR(net.section.sum() / (0.5 * nodeDualAreas(net).sum()), 1.0, 1e-12);
}

TEST(Support, WhatWasAddedGoesAwayWithoutATrace)
{
  for (const Interior kind : {Interior::Struts, Interior::Hub, Interior::Lattice}) {
    const SpringNet before = netOf(organMesh({0.03, 0.02, 0.015}, 8));
    SpringNet net = before;
    SupportOptions options = interior(kind);
    options.anchors = SupportOptions::Anchors::All;
    const SupportReport report = supported(net, options);
    EXPECT_GT(report.springs, 100);
    EXPECT_EQ(report.anchors, before.nodeCount());
    EXPECT_FALSE(hasDoubles(net));
    const SpringNet once = net;
    supported(net, options); // made anew, not twice
    expectSame(net, once);
    std::vector<Index> map;
    EXPECT_TRUE(removeSupport(net, &map));
    EXPECT_EQ(static_cast<Index>(map.size()), once.nodeCount());
    expectSame(net, before);
    EXPECT_FALSE(removeSupport(net));
  }
}

// Filled by either program the net is solid: all volume within the tetrahedra, the mass right, no mechanism;
// taken out again nothing is left. Where a program is absent the error names it.
TEST(Support, ProgramsFillABodyWithTetrahedra)
{
  for (const char* program : {"tetgen", "gmsh"}) {
    const SpringNet before = netOf(organMesh({0.03, 0.02, 0.015}, 6));
    SpringNet net = before;
    SupportOptions options = interior(Interior::Tetrahedra);
    options.program = program;
    const auto report = addSupport(net, options);
    if (!report) {
      EXPECT_EQ(report.error().code, ErrorCode::Unsupported) << report.error().detail;
      EXPECT_NE(report.error().detail.find(program), std::string::npos);
      continue;
    }
    if (const Status status = checkNet(net); !status) ADD_FAILURE() << status.error().detail;
    EXPECT_FALSE(hasDoubles(net));
    const double volume = test::volumeWithin(before.triangles, before.restPosition);
    EXPECT_NEAR(net.volume.sum() / volume, 1.0, 1e-9) << program;
    double shares = 0.0; // each tetrahedron has six edges: sum of section times length is 6 V
    for (Index s = 0; s < net.springCount(); ++s) shares += net.section[s] * net.restLength[s];
    EXPECT_NEAR(shares / (6.0 * volume), 1.0, 1e-9) << program;
    EXPECT_TRUE(removeSupport(net));
    expectSame(net, before);
  }
}

// tetgen leaves with exit 0 on an open surface: it is refused before.
TEST(Support, TetrahedraNeedAClosedSurface)
{
  SpringNet net = netOf(tubeMesh(0.005, 0.06, 12, 24));
  EXPECT_EQ(addSupport(net, interior(Interior::Tetrahedra)).error().code, ErrorCode::InvalidValue);
}

// Two boxes that cross each other are closed and clean each, but no program can fill them both: whatever it
// says at its end, the net stays as it was.
TEST(Support, ACrossingSurfaceIsRefusedWhateverTheProgramSays)
{
  const Mesh box = boxMesh({0.02, 0.02, 0.02}, 0.01);
  Mesh both = box;
  both.position.conservativeResize(Eigen::NoChange, 2 * box.position.cols());
  both.position.rightCols(box.position.cols()) =
    box.position.colwise() + Eigen::Vector3d(0.011, 0.007, 0.005);
  both.triangles.conservativeResize(Eigen::NoChange, 2 * box.triangles.cols());
  both.triangles.rightCols(box.triangles.cols()) = box.triangles.array() + box.vertexCount();
  const SpringNet before = netOf(both);
  for (const char* program : {"tetgen", "gmsh"}) {
    SpringNet net = before;
    SupportOptions options = interior(Interior::Tetrahedra);
    options.program = program;
    options.timeLimit = 20.0;
    EXPECT_FALSE(addSupport(net, options)) << program;
    expectSame(net, before);
  }
}

// Whatever way the file's triangles run, struts go inwards: none leaves a sphere, and each crosses more than
// half of it along the normal (a chord at lean angle a is 2 r cos a long).
TEST(Support, StrutsGoInwardsWhateverTheOrientation)
{
  Mesh mesh = organMesh({0.02, 0.02, 0.02}, 8);
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); t += 3)
    std::swap(mesh.triangles(0, t), mesh.triangles(1, t));
  SpringNet net = netOf(mesh);
  const SupportReport report = supported(net, interior(Interior::Struts));
  EXPECT_TRUE(report.unsupported.empty());
  EXPECT_GT(report.shortest, 2.0 * 0.02 * std::cos(0.6) * 0.85); // snapping moves an end by half a cell
  EXPECT_LE(report.longest, 0.04 * (1.0 + 1e-12));
}

TEST(Support, AnOpenTubeGetsStrutsAcrossItsLumen)
{
  SpringNet net = netOf(tubeMesh(0.005, 0.06, 20, 40));
  const SupportReport report = supported(net, interior(Interior::Struts));
  EXPECT_LT(report.unsupported.size(), 5U);
  EXPECT_GT(report.shortest, 0.005);
}

// Of a thick wall between an outer and an inner surface the struts cross the wall, not the cavity.
TEST(Support, StrutsOfAHollowBodyStayInItsWall)
{
  const Mesh outer = organMesh({0.03, 0.03, 0.03}, 10), inner = organMesh({0.02, 0.02, 0.02}, 8);
  Mesh mesh;
  mesh.position.resize(3, outer.position.cols() + inner.position.cols());
  mesh.position << outer.position, inner.position;
  mesh.triangles.resize(3, outer.triangles.cols() + inner.triangles.cols());
  mesh.triangles << outer.triangles, (inner.triangles.array() + outer.vertexCount()).matrix();
  SpringNet net = netOf(mesh);
  const SupportReport report = supported(net, interior(Interior::Struts));
  EXPECT_LT(report.longest, 2.0 * std::sqrt(0.03 * 0.03 - 0.02 * 0.02)); // a chord that touches the cavity
  for (Index s = 0; s < net.springCount(); ++s) {
    if (net.kind[static_cast<std::size_t>(s)] != SpringKind::Strut) continue;
    const Eigen::Vector3d middle =
      0.5 * (net.restPosition.col(net.ends(0, s)) + net.restPosition.col(net.ends(1, s)));
    EXPECT_GT(middle.norm(), 0.0185);
  }
}

// Tissue gives struts k = E section / L and bands k = E A / length, and leaves the bands where they are.
TEST(Support, TissueGivesTheLayerItsNumbers)
{
  SpringNet net = netOf(organMesh({0.03, 0.02, 0.015}, 6));
  SupportOptions options = interior(Interior::Struts);
  options.anchors = SupportOptions::Anchors::Part;
  options.anchorPart = {{0.03, 0, 0}, {0.01, 0.03, 0.03}, Eigen::Quaterniond::Identity()};
  options.anchorLength = 0.03;
  const SupportReport report = supported(net, options);
  EXPECT_GT(report.anchors, 0);
  EXPECT_LT(report.anchors, net.nodeCount() / 3);
  const TissueModel model = defaultTissue();
  ASSERT_TRUE(applyTissue(model, net));
  const TissueParameters tissue = TissueField::create(model)->base();
  const Index last = net.springCount() - 1;
  EXPECT_NEAR(net.stiffness[last] / (tissue.youngsModulus * net.section[last] / net.restLength[last]), 1.0,
              1e-12);
  const Eigen::ArrayXd area = nodeDualAreas(net);
  Index bands = 0;
  for (Index i = 0; i < net.anchors.count(); ++i) {
    if (!net.anchors.isBand(i)) continue;
    ++bands;
    const Index node = net.anchors.node[static_cast<std::size_t>(i)];
    EXPECT_NEAR(net.anchors.stiffness[i] / (tissue.youngsModulus * area[node] / 0.03), 1.0, 1e-12);
    EXPECT_GT(net.restPosition(0, node), 0.02 - 1e-12);
  }
  EXPECT_EQ(bands, report.anchors);
  if (const Status status = checkNet(net); !status) ADD_FAILURE() << status.error().detail;
}

TEST(Support, WrongWishesAreRefusedAndNothingChanges)
{
  const SpringNet before = netOf(boxMesh({0.02, 0.02, 0.02}, 0.01));
  SpringNet net = before;
  SupportOptions options = interior(Interior::Struts);
  options.strutsPerNode = 0;
  EXPECT_EQ(addSupport(net, options).error().code, ErrorCode::InvalidValue);
  options = {};
  options.anchors = SupportOptions::Anchors::Part;
  options.anchorPart.centre = {1, 1, 1};
  EXPECT_EQ(addSupport(net, options).error().code, ErrorCode::EmptyResult);
  WorkControl control;
  control.cancelled = true;
  EXPECT_EQ(addSupport(net, interior(Interior::Struts), &control).error().code, ErrorCode::Cancelled);
  expectSame(net, before);
}

} // namespace
} // namespace esm
