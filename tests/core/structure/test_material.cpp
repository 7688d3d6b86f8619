// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/net/outward_surface.h"
#include "core/quality/linear_net.h"
#include "core/structure/material.h"
#include "core/structure/support.h"
#include "core/tissue/tissue_model.h"
#include "tests/core/structure/bodies.h"

#include <numbers>

namespace esm {
namespace {

using test::boxMesh;
using test::netOf;
using test::organMesh;
using test::tetrahedraBox;
using test::tubeMesh;

MaterialReport material(SpringNet& net, const MaterialOptions& options, double thickness = 0.002)
{
  const auto report = setMaterial(net, options, thickness);
  if (!report) {
    ADD_FAILURE() << report.error().detail;
    return {};
  }
  if (const Status status = checkNet(net); !status) ADD_FAILURE() << status.error().detail;
  return *report;
}

constexpr MaterialOptions kSolid{MaterialOptions::Body::Solid, EdgeFormula::VanGelder, false};
constexpr MaterialOptions kFitted{MaterialOptions::Body::Solid, EdgeFormula::VanGelder, true};

TEST(Material, TheDefaultsChangeNothing)
{
  SpringNet net = netOf(organMesh({0.03, 0.02, 0.015}, 6)), same = net;
  material(net, {});
  ASSERT_TRUE(applyTissue(defaultTissue(), net));
  ASSERT_TRUE(applyTissue(defaultTissue(), same));
  EXPECT_TRUE((net.stiffness == same.stiffness).all());
  EXPECT_TRUE((net.mass == same.mass).all());
}

// Mass of a solid is density times volume, to rounding: of a closed surface, with struts and without, of a
// body with a cavity, and of tetrahedra.
TEST(Material, MassIsDensityTimesVolume)
{
  const double density = TissueField::create(defaultTissue())->base().density;
  const auto massOf = [&](SpringNet& net) {
    material(net, kSolid);
    EXPECT_TRUE(applyTissue(defaultTissue(), net));
    return net.mass.sum();
  };
  SpringNet box = netOf(boxMesh({0.04, 0.03, 0.02}, 0.005));
  EXPECT_NEAR(massOf(box) / (density * 24e-6), 1.0, 1e-12);
  SupportOptions struts;
  struts.interior = SupportOptions::Interior::Struts;
  ASSERT_TRUE(addSupport(box, struts));
  EXPECT_NEAR(massOf(box) / (density * 24e-6), 1.0, 1e-12);
  EXPECT_GT(box.mass.minCoeff(), 0.0);
  SpringNet tetrahedra = netOf(tetrahedraBox({0.04, 0.03, 0.02}, 0.01));
  EXPECT_NEAR(massOf(tetrahedra) / (density * 24e-6), 1.0, 1e-12);
}

// Back to the wall: density times thickness times area, as without any material.
TEST(Material, AWallAfterASolidIsTheWallAgain)
{
  SpringNet net = netOf(boxMesh({0.04, 0.03, 0.02}, 0.005)), wall = net;
  material(net, kSolid);
  material(net, {});
  ASSERT_TRUE(applyTissue(defaultTissue(), net));
  ASSERT_TRUE(applyTissue(defaultTissue(), wall));
  EXPECT_TRUE((net.mass == wall.mass).all());
}

TEST(Material, AnOpenSurfaceHasNoVolume)
{
  SpringNet net = netOf(tubeMesh(0.005, 0.06, 12, 24));
  EXPECT_EQ(setMaterial(net, kSolid, 0.002).error().code, ErrorCode::InvalidValue);
}

// Tetrahedra: their edges are springs, each once; their outer faces the surface, normals outwards; and
// k = E sum V / L^2.
TEST(Material, TetrahedraBecomeASolidNet)
{
  const SpringNet net = netOf(tetrahedraBox({0.02, 0.01, 0.01}, 0.01));
  EXPECT_EQ(net.nodeCount(), 12);
  EXPECT_EQ(net.springCount(), 20 + 11 + 2); // edges, diagonals of faces, diagonals of cubes
  EXPECT_EQ(net.triangleCount(), 20);
  EXPECT_NEAR(OutwardSurface(net).volume(), 2e-6, 1e-18);
  EXPECT_EQ(OutwardSurface(net).triangles(), net.triangles);
  EXPECT_NEAR(net.volume.sum(), 2e-6, 1e-18);
  double shares = 0.0; // sum over springs of k L^2 = 6 V E
  for (Index s = 0; s < net.springCount(); ++s) shares += net.section[s] * net.restLength[s];
  EXPECT_NEAR(shares, 12e-6, 1e-17);
}

// Van Gelder's and Lloyd's edges are the same where the triangles are regular.
TEST(Material, BothFormulasAgreeOnRegularTriangles)
{
  const Mesh mesh = [] {
    Mesh tetrahedron;
    tetrahedron.position.resize(3, 4);
    tetrahedron.position << 1, 1, -1, -1, 1, -1, 1, -1, 1, -1, -1, 1;
    tetrahedron.triangles.resize(3, 4);
    tetrahedron.triangles << 0, 0, 0, 1, 1, 3, 2, 3, 2, 1, 3, 2;
    return tetrahedron;
  }();
  SpringNet a = netOf(mesh), b = a;
  material(b, {MaterialOptions::Body::Wall, EdgeFormula::Regular, false});
  ASSERT_TRUE(applyTissue(defaultTissue(), a));
  ASSERT_TRUE(applyTissue(defaultTissue(), b));
  for (Index s = 0; s < a.springCount(); ++s) EXPECT_NEAR(b.stiffness[s] / a.stiffness[s], 1.0, 1e-12);
}

// A modulus and a density that are asked for come from the rules' inputs, within the 1 % that InputChange
// promises: from hardness and heaviness, which is what a modeler would move, and from nothing else.
TEST(Material, NumbersSetTheInputsOfTheRules)
{
  const TissueModel usual = defaultTissue();
  for (const double modulus : {2e3, 30e3, 400e3}) {
    MaterialOptions options;
    options.youngsModulus = modulus;
    options.density = 1020.0;
    options.thickness = 0.003;
    const auto wished = tissueOf(options, usual);
    ASSERT_TRUE(wished) << wished.error().detail;
    const TissueParameters base = TissueField::create(*wished)->base();
    EXPECT_NEAR(base.youngsModulus / modulus, 1.0, 0.01);
    EXPECT_NEAR(base.density / 1020.0, 1.0, 0.01);
    EXPECT_EQ(wished->thickness, 0.003);
    for (std::size_t i = 0; i < usual.inputs.size(); ++i) {
      const std::string& id = usual.rules.inputs[i].id;
      EXPECT_EQ(wished->inputs[i] != usual.inputs[i], id == "hardness" || id == "heaviness") << id;
    }
  }
}

// What no input reaches is refused with what is near.
TEST(Material, ImpossibleNumbersAreRefused)
{
  MaterialOptions steel;
  steel.youngsModulus = 210e9;
  const auto refused = tissueOf(steel, defaultTissue());
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::InvalidValue);
  EXPECT_NE(refused.error().detail.find("nearest"), std::string::npos);
  MaterialOptions negative;
  negative.thickness = -1.0;
  EXPECT_FALSE(tissueOf(negative, defaultTissue()));
}

/// Pulls a box along x between rollers at its end faces with the net's own numbers. @return E of the body
/// [Pa].
double modulusOfBox(const SpringNet& net, const Eigen::Vector3d& size)
{
  LinearNet linear(net, net.stiffness, false);
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX();
  const double roller = 1e5 * net.stiffness.maxCoeff();
  Eigen::Matrix3Xd force = Eigen::Matrix3Xd::Zero(3, net.nodeCount());
  for (Index node = 0; node < net.nodeCount(); ++node) {
    const double at = net.restPosition(0, node);
    if (at < 1e-9 || at > size[0] - 1e-9) linear.addSupport(node, x, roller);
    if (at > size[0] - 1e-9) force(0, node) = roller;
  }
  EXPECT_TRUE(linear.factor(1e-9 * linear.stiffestRate()));
  const Eigen::Matrix3Xd moved = linear.solve(force);
  double pull = 0.0;
  for (Index node = 0; node < net.nodeCount(); ++node)
    if (net.restPosition(0, node) > size[0] - 1e-9) pull += roller * (1.0 - moved(0, node));
  return pull * size[0] / (size[1] * size[2]);
}

// After the fit a bar pulled end to end has the tissue's Young's modulus. The fit draws all of the
// surface, the test its ends alone: 3 % for what lies between (the coarse mesh is two cells thick).
TEST(Material, AfterTheFitYoungsModulusMeansYoungsModulus)
{
  const Eigen::Vector3d size(0.06, 0.02, 0.02);
  const double modulus = TissueField::create(defaultTissue())->base().youngsModulus;
  for (const double cell : {0.01, 0.005}) {
    SpringNet solid = netOf(tetrahedraBox(size, cell));
    const MaterialReport report = material(solid, kFitted);
    EXPECT_NE(report.scale, 1.0);
    EXPECT_GT(std::abs(report.axis[0]), 0.999);
    ASSERT_TRUE(applyTissue(defaultTissue(), solid));
    EXPECT_NEAR(modulusOfBox(solid, size) / modulus, 1.0, 0.03) << cell;

    SpringNet braced = netOf(boxMesh(size, cell));
    SupportOptions struts;
    struts.interior = SupportOptions::Interior::Struts;
    ASSERT_TRUE(addSupport(braced, struts));
    material(braced, kFitted);
    ASSERT_TRUE(applyTissue(defaultTissue(), braced));
    EXPECT_NEAR(modulusOfBox(braced, size) / modulus, 1.0, 0.08) << cell;
  }
}

// The first bending frequency of a free bar of steel-like slenderness is not asked for: a chain of masses on
// a line has its exact frequencies, 2 sqrt(k/m) sin(pi i / 2n) / 2 pi between free ends.
TEST(LinearNet, FindsTheFrequenciesOfAFreeChain)
{
  constexpr Index kNodes = 12;
  SpringNet net;
  resizeNet(net, kNodes, kNodes - 1);
  for (Index i = 0; i < kNodes; ++i) net.restPosition(0, i) = 0.1 * i;
  for (Index s = 0; s + 1 < kNodes; ++s) net.ends.col(s) << s, s + 1;
  net.restLength.setConstant(0.1);
  net.stiffness.setConstant(400.0);
  // Anchored across, so that only the motions along the line are slow.
  for (Index i = 0; i < kNodes; ++i) net.mass[i] = 4.0;
  LinearNet linear(net);
  for (Index i = 0; i < kNodes; ++i) {
    linear.addSupport(i, Eigen::Vector3d::UnitY(), 1e6);
    linear.addSupport(i, Eigen::Vector3d::UnitZ(), 1e6);
  }
  const SlowModes modes = slowestModes(linear, 3);
  ASSERT_EQ(modes.frequency.size(), 3);
  for (int i = 0; i < 3; ++i) {
    const double exact = 2.0 * std::sqrt(100.0) * std::sin(std::numbers::pi * (i + 1) / (2.0 * kNodes)) /
                         (2.0 * std::numbers::pi);
    EXPECT_NEAR(modes.frequency[i] / exact, 1.0, 1e-5);
  }
}

} // namespace
} // namespace esm
