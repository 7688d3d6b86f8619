// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// After the modulus fit a body is the same at every mesh size: what a mesh changes is how fine things are.
#include "core/quality/linear_net.h"
#include "core/quality/poke.h"
#include "tests/core/structure/bodies.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

namespace esm {
namespace {

using test::bodyOf;
using test::kFittedSolid;
using test::kFittedWall;
using test::organMesh;
using test::tetrahedraBox;
using test::tubeMesh;
using Interior = SupportOptions::Interior;

struct Refined {
  double dent = 0.0, frequency = 0.0; ///< [m], [Hz]
};

/// A net with what is fixed, ready to be poked anywhere.
class Poked {
public:
  explicit Poked(const SpringNet& net) : m_net(net), m_linear(net)
  {
    EXPECT_TRUE(m_linear.factor(1e-10 * m_linear.stiffestRate()));
  }
  /// Depth of a poke of 0.1 N around a place, 10 mm wide to each side [m].
  double dentOf(const Eigen::Vector3d& place, const Eigen::Vector3d& direction)
  {
    const Eigen::Matrix3Xd poke = pokePatch(m_net, place, 0.1 * direction, 0.01);
    return poke.cwiseProduct(m_linear.solve(poke)).sum() / 0.1;
  }

private:
  const SpringNet& m_net;
  LinearNet m_linear;
};

/// The first eigenfrequency [Hz].
double frequencyOf(const SpringNet& net)
{
  LinearNet linear(net);
  const SlowModes modes = slowestModes(linear, 1);
  if (modes.frequency.size() == 1) return modes.frequency[0];
  ADD_FAILURE() << "no mode";
  return 0.0;
}

/// Both of one poke.
Refined measured(const SpringNet& net, const Eigen::Vector3d& place, const Eigen::Vector3d& direction)
{
  const Refined is{Poked(net).dentOf(place, direction), frequencyOf(net)};
  std::printf("  %d nodes, %d springs: poke %.4f mm, first frequency %.3f Hz\n", net.nodeCount(),
              net.springCount(), 1e3 * is.dent, is.frequency);
  return is;
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
        block(test::boxMesh({0.04, 0.03, 0.02}, cell), Interior::Struts, turn.toRotationMatrix()));
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

/// Where a closed organ has the point that lies at a direction on the unit sphere [m].
using Shape = Eigen::Vector3d (*)(const Eigen::Vector3d& direction);

Eigen::Vector3d ellipsoid(const Eigen::Vector3d& s)
{
  return {0.018 * s[0], 0.02 * s[1], 0.03 * s[2]};
}
/// 70 mm long, 40 mm wide; radius of curvature 4 mm at the tip, 29 mm at the other end.
Eigen::Vector3d pear(const Eigen::Vector3d& s)
{
  const double wide = 0.022 * (1.0 - 0.45 * s[2]);
  return {wide * s[0], 0.9 * wide * s[1], 0.035 * s[2]};
}
/// As the sample: 75 mm long, fundus 45 mm wide, cervix 20 mm, bent forward.
Eigen::Vector3d uterus(const Eigen::Vector3d& s)
{
  const double wide = 0.019 + 0.008 * std::tanh(2.2 * (s[2] - 0.05)) +
                      0.003 * std::exp(-std::pow((s[2] + 0.75) / 0.25, 2)),
               high = 0.0375 * (1.0 + s[2]);
  return {wide * s[0], 0.75 * wide * s[1] + 1.6 * high * high, high};
}

/// The lower end lies in a bed that fades over 20 mm of height, and is the same at each mesh size: which
/// nodes lie below a plane is not.
void bedDown(SpringNet& net)
{
  constexpr double kReach = 0.02, kBed = 3e6; // [m], [Pa/m]
  const Eigen::ArrayXd area = nodeDualAreas(net);
  const double low = net.restPosition.row(2).minCoeff();
  std::vector<double> stiffness;
  for (Index node = 0; node < net.nodeCount(); ++node) {
    const double share = (net.restPosition(2, node) - low) / kReach;
    if (share >= 1.0) continue;
    net.anchors.node.push_back(node);
    stiffness.push_back(kBed * area[node] * std::pow(std::cos(0.5 * std::numbers::pi * share), 2));
  }
  const auto count = static_cast<Eigen::Index>(stiffness.size());
  net.anchors.stiffness = Eigen::Map<Eigen::ArrayXd>(stiffness.data(), count);
  net.anchors.viscosity.setZero(count);
  net.anchors.point.resize(3, count);
  for (Eigen::Index i = 0; i < count; ++i)
    net.anchors.point.col(i) = net.restPosition.col(net.anchors.node[static_cast<std::size_t>(i)]);
}

/// The organ at three mesh sizes, their poles turned against the body, poked from the side and onto the top.
void expectSameOrgan(Shape shape)
{
  const Eigen::AngleAxisd turns[] = {Eigen::AngleAxisd::Identity(),
                                     {0.7, Eigen::Vector3d(1, 2, 3).normalized()}};
  for (const Eigen::AngleAxisd& turn : turns) {
    std::vector<Refined> side, top;
    for (const int n : {12, 16, 21}) {
      Mesh mesh = organMesh({1, 1, 1}, n);
      const Eigen::Matrix3Xd sphere = turn.toRotationMatrix() * mesh.position;
      for (Eigen::Index i = 0; i < sphere.cols(); ++i) mesh.position.col(i) = shape(sphere.col(i));
      SpringNet net = bodyOf(mesh, Interior::Struts, kFittedSolid);
      bedDown(net);
      Poked poked(net);
      const double frequency = frequencyOf(net);
      side.push_back({poked.dentOf(shape({0, 1, 0}), {0, -1, 0}), frequency});
      top.push_back({poked.dentOf(shape({0, 0, 1}), {0, 0, -1}), frequency});
    }
    expectAlike(side);
    expectAlike(top);
  }
}

// Closed organs with round ends, also a pointed one. A test that holds the ends for the fit makes them 9 %
// stiffer or softer; nodes fixed below a plane make frequencies of the pear differ by 18 %.
TEST(Refinement, AnEllipsoidIsTheSameBodyAtThreeMeshSizes)
{
  expectSameOrgan(ellipsoid);
}
TEST(Refinement, APearIsTheSameBodyAtThreeMeshSizes)
{
  expectSameOrgan(pear);
}
TEST(Refinement, AUterusIsTheSameBodyAtThreeMeshSizes)
{
  expectSameOrgan(uterus);
}

} // namespace
} // namespace esm
