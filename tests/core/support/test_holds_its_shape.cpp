// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/simulation.h"
#include "core/support/material.h"
#include "core/support/poke.h"
#include "core/support/quality.h"
#include "core/support/support.h"
#include "core/tissue/tissue_model.h"
#include "tests/core/support/bodies.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace esm {
namespace {

using testing::netOf;
using testing::organMesh;
using testing::tetrahedraBox;
using testing::tubeMesh;
using testing::volumeWithin;
using Interior = SupportOptions::Interior;

/// Tissue of little springiness, so that what swings comes to rest within the seconds of a test; no bed
/// around it.
SpringNet bodyOf(const Mesh& mesh, Interior interior, MaterialOptions material)
{
  SpringNet net = netOf(mesh);
  SupportOptions support;
  support.interior = interior;
  const auto added = addSupport(net, support);
  if (!added) ADD_FAILURE() << added.error().detail;
  TissueModel tissue = defaultTissue();
  for (std::size_t i = 0; i < tissue.rules.inputs.size(); ++i)
    if (tissue.rules.inputs[i].id == "elasticity") tissue.inputs[i] = 0.0;
  const auto made = setMaterial(net, material, tissue.thickness);
  if (!made) ADD_FAILURE() << made.error().detail;
  const auto applied = applyTissue(tissue, net);
  if (!applied) ADD_FAILURE() << applied.error().detail;
  net.anchors = {};
  return net;
}

void fixEnds(SpringNet& net, int axis, bool both)
{
  const double low = net.restPosition.row(axis).minCoeff(), high = net.restPosition.row(axis).maxCoeff();
  for (Index node = 0; node < net.nodeCount(); ++node) {
    const double share = (net.restPosition(axis, node) - low) / (high - low);
    if (share < 0.05 || (both && share > 0.95)) net.fixed[static_cast<std::size_t>(node)] = 1;
  }
}

Index nearestNode(const SpringNet& net, const Eigen::Vector3d& place)
{
  Eigen::Index nearest = 0;
  (net.restPosition.colwise() - place).colwise().squaredNorm().minCoeff(&nearest);
  return static_cast<Index>(nearest);
}

struct Story {
  double leastVolume = 1.0, mostVolume = 1.0; ///< over the volume at rest, from start to end
  double depth = 0.0;                         ///< of the poke [m]
  double left = 0.0, speed = 0.0; ///< at the end: distance from where gravity alone had it, velocity
};

/// Gravity from the start; from 1.5 s on a poke of 0.1 N along -y that rises for 0.2 s and is taken away
/// at 2.5 s; then `rest` seconds.
Story live(const SpringNet& net, Index node, double rest)
{
  Loads loads;
  loads.gravity = {0, 0, -9.81};
  const Eigen::Matrix3Xd poke = pokePatch(net, node, {0, -0.1, 0}, 0.008);
  for (Index i = 0; i < net.nodeCount(); ++i) {
    if (poke.col(i).isZero(0.0)) continue;
    NodalForce force{{i}, {{1.5, 1.7, 2.5, 2.5}, Eigen::Matrix3Xd::Zero(3, 4)}};
    force.force.value.col(1) = force.force.value.col(2) = poke.col(i);
    loads.forces.push_back(force);
  }
  auto simulation = Simulation::create(net, loads, {});
  Story story;
  if (!simulation) {
    ADD_FAILURE() << simulation.error().detail;
    return story;
  }
  const double whole = volumeWithin(net.triangles, net.restPosition);
  Eigen::Matrix3Xd hanging;
  const int frames = static_cast<int>(60.0 * (2.5 + rest));
  for (int frame = 1; frame <= frames; ++frame) {
    if (!simulation->advance(1.0 / 60.0).good()) {
      ADD_FAILURE() << simulation->why();
      return story;
    }
    const Eigen::Matrix3Xd& now = simulation->state().position;
    const double volume = volumeWithin(net.triangles, now) / whole;
    story.leastVolume = std::min(story.leastVolume, volume);
    story.mostVolume = std::max(story.mostVolume, volume);
    if (frame == 90) hanging = now;
    if (frame == 149) story.depth = (now.col(node) - hanging.col(node)).norm();
  }
  story.left = (simulation->state().position - hanging).colwise().norm().maxCoeff();
  story.speed = simulation->state().velocity.colwise().norm().maxCoeff();
  std::printf("  volume %.4f to %.4f, poke %.2f mm, left %.4f mm, speed %.1e m/s\n", story.leastVolume,
              story.mostVolume, 1e3 * story.depth, 1e3 * story.left, story.speed);
  return story;
}

void expectHolds(const Story& story)
{
  EXPECT_GT(story.leastVolume, 0.9);
  EXPECT_LT(story.mostVolume, 1.1);
  EXPECT_GT(story.depth, 2e-4); // the poke was felt
  EXPECT_LT(story.left, 0.05 * story.depth);
  EXPECT_LT(story.speed, 0.01);
}

bool warns(const SpringNet& net)
{
  const auto report = judgeNet(net);
  return report && !report->carriesLoad();
}

constexpr MaterialOptions kFittedWall{MaterialOptions::Body::Wall, EdgeFormula::VanGelder, true};
constexpr MaterialOptions kFittedSolid{MaterialOptions::Body::Solid, EdgeFormula::VanGelder, true};

TEST(HoldsItsShape, ATubeWithStrutsUnderGravityAndAPoke)
{
  const Mesh mesh = tubeMesh(0.008, 0.05, 12, 14);
  SpringNet net = bodyOf(mesh, Interior::Struts, kFittedWall);
  fixEnds(net, 2, true);
  EXPECT_FALSE(warns(net));
  expectHolds(live(net, nearestNode(net, {0, 0.008, 0.025}), 1.5));
}

TEST(HoldsItsShape, AClosedOrganWithStrutsUnderGravityAndAPoke)
{
  const Mesh mesh = organMesh({0.03, 0.02, 0.018}, 5);
  SpringNet net = bodyOf(mesh, Interior::Struts, kFittedSolid);
  fixEnds(net, 2, false);
  EXPECT_FALSE(warns(net));
  expectHolds(live(net, nearestNode(net, {0, 0.02, 0}), 2.5));
}

// The same bodies without anything inside: the report warns before, and rightly so: they lose more than a
// tenth of their volume.
TEST(HoldsItsShape, WithoutStrutsTheReportWarnsAndTheBodiesCollapse)
{
  SpringNet tube = bodyOf(tubeMesh(0.008, 0.05, 12, 14), Interior::None, kFittedWall);
  fixEnds(tube, 2, true);
  EXPECT_TRUE(warns(tube));
  EXPECT_LT(live(tube, nearestNode(tube, {0, 0.008, 0.025}), 0.0).leastVolume, 0.9);
  SpringNet organ = bodyOf(organMesh({0.03, 0.02, 0.018}, 5), Interior::None, {});
  fixEnds(organ, 2, false);
  EXPECT_TRUE(warns(organ));
  EXPECT_LT(live(organ, nearestNode(organ, {0, 0.02, 0}), 0.0).leastVolume, 0.9);
}

struct Refined {
  double dent, frequency;
};

/// Depth of a poke of 0.1 N around a place, 10 mm wide to each side, and first eigenfrequency. What is fixed
/// stays.
Refined measured(const SpringNet& net, const Eigen::Vector3d& place, const Eigen::Vector3d& direction)
{
  LinearNet linear(net);
  EXPECT_TRUE(linear.factor(1e-10 * linear.stiffestRate()));
  const Eigen::Matrix3Xd poke = pokePatch(net, nearestNode(net, place), 0.1 * direction, 0.01);
  const double dent = poke.cwiseProduct(linear.solve(poke)).sum() / 0.1;
  const SlowModes modes = slowestModes(linear, 1);
  EXPECT_EQ(modes.frequency.size(), 1);
  std::printf("  %d nodes, %d springs: poke %.4f mm, first frequency %.3f Hz\n", net.nodeCount(),
              net.springCount(), 1e3 * dent, modes.frequency[0]);
  return {dent, modes.frequency[0]};
}

/// A block of 40 x 30 x 20 mm, turned, its base fixed, poked onto the middle of the top.
Refined block(Mesh mesh, Interior interior, const Eigen::Matrix3d& turn = Eigen::Matrix3d::Identity())
{
  const Eigen::Matrix3Xd straight = mesh.position;
  mesh.position = turn * straight;
  SpringNet net = bodyOf(mesh, interior, kFittedSolid);
  for (Index node = 0; node < net.nodeCount(); ++node)
    if (straight(2, node) < 1e-9) net.fixed[static_cast<std::size_t>(node)] = 1;
  return measured(net, turn * Eigen::Vector3d(0.02, 0.015, 0.02), -turn.col(2));
}

void expectAlike(const std::vector<Refined>& meshes)
{
  for (const auto figure : {&Refined::dent, &Refined::frequency}) {
    double low = meshes[0].*figure, high = low;
    for (const Refined& mesh : meshes) {
      low = std::min(low, mesh.*figure);
      high = std::max(high, mesh.*figure);
    }
    EXPECT_LT(high / low, 1.05);
  }
}

// After the modulus fit finer meshes of a body are not softer, harder, faster or slower.
TEST(Refinement, ABlockOfTetrahedraIsTheSameBodyAtThreeMeshSizes)
{
  std::vector<Refined> meshes;
  for (const double cell : {0.005, 1.0 / 300.0, 0.0025})
    meshes.push_back(block(tetrahedraBox({0.04, 0.03, 0.02}, cell), Interior::None));
  expectAlike(meshes);
}

// With the struts that a net gets unless told otherwise; whatever way the body lies, so that no lucky
// direction passes the test.
TEST(Refinement, ABlockWithStrutsIsTheSameBodyAtThreeMeshSizes)
{
  const Eigen::AngleAxisd turns[] = {Eigen::AngleAxisd::Identity(),
                                     {0.7, Eigen::Vector3d(1, 2, 3).normalized()},
                                     {2.1, Eigen::Vector3d(-3, 1, 2).normalized()}};
  for (const Eigen::AngleAxisd& turn : turns) {
    std::vector<Refined> meshes;
    for (const double cell : {1.0 / 300.0, 0.0025, 0.002})
      meshes.push_back(
        block(testing::boxMesh({0.04, 0.03, 0.02}, cell), Interior::Struts, turn.toRotationMatrix()));
    expectAlike(meshes);
  }
}

// A tube of 50 mm held at both ends; the meshes lie turned about its axis against each other.
TEST(Refinement, ATubeWithStrutsIsTheSameBodyAtThreeMeshSizes)
{
  for (const double start : {0.0, 0.37, 0.74}) {
    std::vector<Refined> meshes;
    for (const int around : {16, 22, 30}) {
      Mesh mesh = tubeMesh(0.008, 0.05, around, (around * 23 / 20) / 2 * 2);
      const Eigen::Matrix3Xd straight = mesh.position;
      mesh.position = Eigen::AngleAxisd(start, Eigen::Vector3d::UnitZ()).toRotationMatrix() * straight;
      SpringNet net = bodyOf(mesh, Interior::Struts, kFittedWall);
      for (Index node = 0; node < net.nodeCount(); ++node)
        if (const double z = net.restPosition(2, node); z < 1e-9 || z > 0.05 - 1e-9)
          net.fixed[static_cast<std::size_t>(node)] = 1;
      meshes.push_back(measured(net, {0, 0.008, 0.025}, {0, -1, 0}));
    }
    expectAlike(meshes);
  }
}

} // namespace
} // namespace esm
