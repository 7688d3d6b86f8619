// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/tissue/tissue_model.h"
#include "tests/core/tissue/test_nets.h"

#include <cmath>
#include <numbers>

namespace esm {
namespace {

using test::ellipsoidMesh;
using test::meshOf;
using test::netOf;

ApplyReport apply(const TissueModel& model, SpringNet& net)
{
  const auto report = applyTissue(model, net);
  if (!report) {
    ADD_FAILURE() << report.error().detail;
    return {};
  }
  const Status status = checkNet(net);
  if (!status) ADD_FAILURE() << status.error().detail;
  return *report;
}

Index springBetween(const SpringNet& net, Index a, Index b)
{
  for (Index s = 0; s < net.springCount(); ++s)
    if ((net.ends(0, s) == a && net.ends(1, s) == b) || (net.ends(0, s) == b && net.ends(1, s) == a))
      return s;
  ADD_FAILURE() << "no spring " << a << ' ' << b;
  return 0;
}

/// Two right triangles of legs 1 cm: the unit of the tests by hand.
Mesh square()
{
  const double a = 0.01;
  return meshOf({{0, 0, 0}, {a, 0, 0}, {a, a, 0}, {0, a, 0}}, {{0, 1, 2}, {0, 2, 3}});
}

// A band of the support layer stands for the node's share of the surface: k = E A / l, A = a^2 / 3 at a
// corner of two triangles. 1e-12 relative: rounding.
TEST(ApplyTissue, ABandHoldsItsShareOfTheSurface)
{
  const TissueModel model = defaultTissue();
  const TissueParameters tissue = TissueField::create(model)->base();
  SpringNet net = netOf(square());
  net.anchors.node = {0};
  net.anchors.point = Eigen::Vector3d(0, 0, -0.02);
  net.anchors.stiffness = net.anchors.viscosity = Eigen::ArrayXd::Zero(1);
  net.anchors.bandLength = Eigen::ArrayXd::Constant(1, 0.02);
  apply(model, net);
  ASSERT_EQ(net.anchors.count(), 5);
  EXPECT_NEAR(net.anchors.stiffness[4] / (tissue.youngsModulus * 1e-4 / 3.0 / 0.02), 1.0, 1e-12);
  EXPECT_NEAR(net.anchors.viscosity[4] / (tissue.viscosity * net.anchors.stiffness[4]), 1.0, 1e-12);
}

// k = E h A / L^2: a side (A = a^2/2, L = a) has E h / 2, the diagonal (A = a^2, L^2 = 2 a^2) too.
// Masses: density h a^2 / 6 per triangle corner. 1e-12 relative: rounding.
TEST(ApplyTissue, ASquareByHand)
{
  const TissueModel model = defaultTissue();
  const TissueParameters tissue = TissueField::create(model)->base();
  SpringNet net = netOf(square());
  const ApplyReport report = apply(model, net);
  const double half = 0.5 * tissue.youngsModulus * model.thickness;
  for (const double k : net.stiffness) EXPECT_NEAR(k / half, 1.0, 1e-12);
  for (Index s = 0; s < 5; ++s) EXPECT_NEAR(net.viscosity[s], tissue.viscosity * net.stiffness[s], 1e-12);
  const double corner = tissue.density * model.thickness * 1e-4 / 6.0;
  EXPECT_NEAR(net.mass[0] / corner, 2.0, 1e-12);
  EXPECT_NEAR(net.mass[1] / corner, 1.0, 1e-12);
  EXPECT_NEAR(report.totalMass, tissue.density * model.thickness * 1e-4, 1e-15);
  ASSERT_EQ(net.anchors.count(), 4);
  EXPECT_NEAR(net.anchors.stiffness.sum() / (tissue.anchoring * 1e-4), 1.0, 1e-12);
  EXPECT_NEAR(net.anchors.viscosity.sum() / net.anchors.stiffness.sum() / tissue.viscosity, 1.0, 1e-12);
  EXPECT_EQ(net.anchors.point, net.restPosition);
  EXPECT_EQ(report.springsChanged, 5);
  EXPECT_EQ(report.nodesChanged, 4);
  EXPECT_EQ(report.minYoungsModulus, tissue.youngsModulus);
  EXPECT_EQ(report.maxYoungsModulus, tissue.youngsModulus);
  for (std::size_t s = 0; s < 5; ++s) EXPECT_EQ(net.law[s], model.law);
  EXPECT_TRUE((net.lawParameter == tissue.stiffening).all());
}

// A strut between two nodes of the surface has the mean of their areas as section and no mass of its own.
TEST(ApplyTissue, AStrutTakesItsSectionFromTheSurface)
{
  Mesh mesh = meshOf({{0, 0, 0}, {0.01, 0, 0}, {0, 0.01, 0}, {0, 0, 0.02}, {0.02, 0, 0.02}, {0, 0.02, 0.02}},
                     {{0, 1, 2}, {3, 4, 5}}, {{0, 3}});
  const TissueModel model = defaultTissue();
  SpringNet net = netOf(mesh);
  apply(model, net);
  const double area = 0.5 * (0.5e-4 + 2e-4) / 3.0;
  const TissueParameters tissue = TissueField::create(model)->base();
  const double expected = tissue.youngsModulus * area / 0.02;
  EXPECT_NEAR(net.stiffness[springBetween(net, 0, 3)] / expected, 1.0, 1e-12);
  EXPECT_NEAR(net.mass.sum(), tissue.density * model.thickness * 2.5e-4, 1e-15);
}

// Without any surface a line is a round cord as thick as the wall, whose mass goes to its ends.
TEST(ApplyTissue, ANetOfLinesIsMadeOfCords)
{
  const TissueModel model = defaultTissue();
  SpringNet net = netOf(meshOf({{0, 0, 0}, {0.01, 0, 0}, {0.03, 0, 0}}, {}, {{0, 1}, {1, 2}}));
  apply(model, net);
  const double section = std::numbers::pi * model.thickness * model.thickness / 4.0;
  const TissueParameters tissue = TissueField::create(model)->base();
  EXPECT_NEAR(net.stiffness[0] / (tissue.youngsModulus * section / 0.01), 1.0, 1e-12);
  EXPECT_NEAR(net.mass[0] / (tissue.density * section * 0.005), 1.0, 1e-12);
  EXPECT_NEAR(net.mass[1] / (tissue.density * section * 0.015), 1.0, 1e-12);
  EXPECT_EQ(net.anchors.count(), 0) << "only a surface is held";
}

// A node inside hangs on struts alone: their section is the outer node's area, half their mass is its own.
TEST(ApplyTissue, ANodeInsideGetsItsMassFromItsStruts)
{
  Mesh mesh = square();
  mesh.position.conservativeResize(3, 5);
  mesh.position.col(4) = Eigen::Vector3d(0, 0, 0.01);
  mesh.segments.resize(2, 1);
  mesh.segments << 0, 4;
  const TissueModel model = defaultTissue();
  const TissueParameters tissue = TissueField::create(model)->base();
  SpringNet net = netOf(mesh);
  apply(model, net);
  EXPECT_NEAR(net.mass[4] / (0.5 * tissue.density * (1e-4 / 3.0) * 0.01), 1.0, 1e-12);
  EXPECT_EQ(net.anchors.count(), 4);
}

TEST(ApplyTissue, ALoneNodeGetsTheSmallestMassOfTheOthers)
{
  SpringNet net = netOf(square());
  SpringNet more;
  resizeNet(more, 5, 5);
  more.restPosition << net.restPosition, Eigen::Vector3d(1, 1, 1);
  more.ends = net.ends;
  more.restLength = net.restLength;
  more.kind = net.kind;
  more.triangles = net.triangles;
  apply(defaultTissue(), more);
  EXPECT_EQ(more.mass[4], more.mass.head(4).minCoeff());
}

TEST(ApplyTissue, KeepsTopologyFlagsAndIdsAndReplacesAnchors)
{
  SpringNet net = netOf(square());
  net.fixed[1] = 1;
  net.springId[2] = SpringId{77};
  net.tensionOnly[3] = 1;
  apply(defaultTissue(), net);
  const SpringNet once = net;
  apply(defaultTissue(), net);
  EXPECT_EQ(net.fixed[1], 1);
  EXPECT_EQ(net.springId[2], SpringId{77});
  EXPECT_EQ(net.tensionOnly[3], 1);
  EXPECT_EQ(net.ends, once.ends);
  EXPECT_EQ(net.anchors.count(), once.anchors.count());
  EXPECT_TRUE((net.mass == once.mass).all()) << "applying twice is applying once";
}

TEST(ApplyTissue, ARegionChangesOnlyItsPart)
{
  SpringNet net = netOf(ellipsoidMesh({0.04, 0.025, 0.02}, 3));
  apply(defaultTissue(), net);
  TissueModel model = defaultTissue();
  Region hard;
  hard.ellipsoid.centre = {0.04, 0, 0};
  hard.inputs = model.inputs;
  hard.inputs[0] = 0.9;
  model.regions.push_back(hard);
  SpringNet other = net;
  const ApplyReport report = apply(model, other);
  Index changed = 0;
  for (Index s = 0; s < net.springCount(); ++s) {
    const Eigen::Vector3d middle =
      0.5 * (net.restPosition.col(net.ends(0, s)) + net.restPosition.col(net.ends(1, s)));
    const bool inside = hard.ellipsoid.radius(middle) < 1.0;
    EXPECT_EQ(other.stiffness[s] > net.stiffness[s], inside) << s;
    changed += inside ? 1 : 0;
  }
  EXPECT_GT(changed, 10);
  EXPECT_LT(changed, net.springCount() / 2);
  EXPECT_GT(report.maxYoungsModulus, 5.0 * report.minYoungsModulus);
}

// f = k L/b (exp(b e) - 1) = k L (e + b e^2/2 + b^2 e^3/6 + ...) and f = k L (e + a e^3): the terms of third
// order agree for a = b^2/6. A rule base that does not speak of stiffening leaves it to the model.
TEST(ApplyTissue, StiffeningIsTheLawsParameter)
{
  TissueModel model = defaultTissue();
  const double b = TissueField::create(model)->base().stiffening;
  SpringNet net = netOf(square());
  model.law = SpringLaw::Cubic;
  apply(model, net);
  EXPECT_NEAR(net.lawParameter[0] / (b * b / 6.0), 1.0, 1e-14);
  EXPECT_EQ(net.law[4], SpringLaw::Cubic);

  model.rules.outputs.resize(3);
  std::erase_if(model.rules.rules, [&](const fuzzy::Rule& rule) {
    return !model.rules.findOutput(rule.consequents[0].variable);
  });
  model.lawParameter = 4.5;
  model.density = 987.0;
  apply(model, net);
  EXPECT_TRUE((net.lawParameter == 4.5).all());
  EXPECT_NEAR(net.mass.sum() / (987.0 * model.thickness * 1e-4), 1.0, 1e-12);
}

TEST(ApplyTissue, OnErrorTheNetIsAsBefore)
{
  SpringNet net = netOf(square());
  apply(defaultTissue(), net);
  const SpringNet before = net;
  TissueModel model = defaultTissue();
  model.density = -1.0;
  EXPECT_FALSE(applyTissue(model, net));
  net.restPosition.row(1).setZero(); // a surface without area
  const auto flat = applyTissue(defaultTissue(), net);
  ASSERT_FALSE(flat);
  EXPECT_NE(flat.error().detail.find("no area"), std::string::npos);
  EXPECT_TRUE((net.mass == before.mass).all());
  EXPECT_TRUE((net.stiffness == before.stiffness).all());
}

} // namespace
} // namespace esm
