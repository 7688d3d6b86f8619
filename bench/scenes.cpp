// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "bench/scenes.h"

#include "bench/scene_shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>

namespace esm::bench {
namespace {

unsigned seedOr(const SceneOptions& options, unsigned own)
{
  return options.seed ? options.seed : own;
}

double durationOr(const SceneOptions& options, double own)
{
  return options.duration > 0.0 ? options.duration : own;
}

/// A count of nodes along one side, made to fit the wanted size; even, as staggered rings ask for.
Index evenCount(double count)
{
  return std::max<Index>(4, static_cast<Index>(2 * std::lround(count / 2)));
}

std::vector<Index> middleRing(Index rings)
{
  std::vector<Index> nodes(20);
  for (Index a = 0; a < 20; ++a) nodes[static_cast<std::size_t>(a)] = rings / 2 * 20 + a;
  return nodes;
}

/// A force [N] shared by the nodes within 1 cm of the top of an organ, grown over `ramp` [s].
NodalForce poke(const SpringNet& net, double height, double force, double ramp)
{
  NodalForce press;
  const Eigen::Vector3d centre(0.0, 0.0, height);
  for (Index i = 0; i < net.nodeCount(); ++i)
    if ((net.restPosition.col(i) - centre).norm() < 0.01) press.nodes.push_back(i);
  const double share = force / static_cast<double>(press.nodes.size());
  press.force = curve({0.0, ramp}, {{0, 0, 0}, {0, 0, -share}});
  return press;
}

/// Every spring a stiffness of its own [N/m].
void drawStiffness(SpringNet& net, unsigned seed, double low, double high)
{
  std::mt19937 random(seed);
  for (Index s = 0; s < net.springCount(); ++s) net.stiffness[s] = uniform(random, low, high);
}

} // namespace

long Scene::frames() const noexcept
{
  return std::lround(duration * kFrameRate);
}

Scene tube(const SceneOptions& options)
{
  const Index rings = evenCount(20 * options.size);
  Scene scene{"tube", tubeNet(rings), {}, durationOr(options, 2.0)};
  SpringNet& net = scene.net;
  drawStiffness(net, seedOr(options, 1), 23.0, 75.0);
  net.viscosity = 5e-4 * net.stiffness;
  net.restLength *= 0.97; // a little pre-stretch keeps the wall from buckling
  net.mass.setConstant(1.25e-5);
  anchorAll(net, 0.1, 5e-5);
  PrescribedMotion pull;
  pull.nodes = middleRing(rings);
  pull.displacement = curve({0.0, 0.2}, {{0, 0, 0}, {0, 0.02, 0}});
  pull.release = 0.2;
  scene.loads.motions.push_back(pull);
  return scene;
}

Scene uterus(const SceneOptions& options)
{
  const Index rings = evenCount(26 * std::sqrt(options.size)),
              around = evenCount(48 * std::sqrt(options.size));
  const Eigen::Vector3d axes(0.04, 0.025, 0.02);
  std::vector<Eigen::Vector3d> positions;
  Edges edges;
  const auto place = [&](double theta, double phi) {
    const Eigen::Vector3d unit(std::cos(theta), std::sin(theta) * std::cos(phi),
                               std::sin(theta) * std::sin(phi));
    positions.push_back(onGrid(axes.cwiseProduct(unit)));
  };
  for (Index r = 0; r < rings; ++r)
    for (Index a = 0; a < around; ++a) {
      place(std::numbers::pi * (r + 1) / (rings + 1), 2 * std::numbers::pi * (a + 0.5 * (r % 2)) / around);
      const Index here = r * around + a, next = r * around + (a + 1) % around;
      edges.emplace_back(here, next);
      if (r + 1 < rings) {
        edges.emplace_back(here, here + around);
        edges.emplace_back(r % 2 ? here : next, (r % 2 ? next : here) + around);
      } else {
        edges.emplace_back(here, rings * around + 1);
      }
      if (r == 0) edges.emplace_back(rings * around, here);
    }
  place(0.0, 0.0);
  place(std::numbers::pi, 0.0);
  Scene scene{"uterus", netOf(positions, edges), {}, durationOr(options, 1.0)};
  SpringNet& net = scene.net;
  drawStiffness(net, seedOr(options, 2), 150.0, 250.0);
  for (Index s = 0; s < net.springCount(); ++s) {
    net.law[static_cast<std::size_t>(s)] = SpringLaw::Exponential;
    net.lawParameter[s] = 3.0;
  }
  net.viscosity = 2e-4 * net.stiffness;
  net.mass.setConstant(4.8e-5);
  net.restLength *=
    0.9; // stretched over its content, as the organ is: a slack closed surface buckles chaotically
  anchorAll(net, 5.0, 1e-3);
  scene.loads.forces.push_back(poke(net, axes.z(), 1.0, 0.1));
  return scene;
}

Scene uterusLinear()
{
  Scene scene = uterus();
  scene.name = "uterus-linear";
  std::fill(scene.net.law.begin(), scene.net.law.end(), SpringLaw::Linear);
  return scene;
}

namespace {

Scene sheetOf(Index side, const SceneOptions& options)
{
  constexpr double spacing = 0.004;
  std::vector<Eigen::Vector3d> positions;
  Edges edges;
  for (Index j = 0; j < side; ++j)
    for (Index i = 0; i < side; ++i) {
      positions.emplace_back(spacing * i, 0.0, -spacing * j);
      const Index here = j * side + i;
      if (i + 1 < side) edges.emplace_back(here, here + 1);
      if (j + 1 < side) edges.emplace_back(here, here + side);
      if (i + 1 < side && j + 1 < side) edges.emplace_back(here, here + side + 1);
    }
  Scene scene{"sheet", netOf(positions, edges), {}, durationOr(options, 1.0)};
  SpringNet& net = scene.net;
  net.stiffness.setConstant(200.0);
  if (options.seed) drawStiffness(net, options.seed, 150.0, 250.0);
  net.viscosity.setConstant(0.02);
  net.mass.setConstant(3e-5);
  for (Index i = 0; i < side; ++i) // a frame: a free edge would recoil, and the sheet fold chaotically
    for (const Index node : {i, (side - 1) * side + i, i * side, i * side + side - 1})
      net.fixed[static_cast<std::size_t>(node)] = 1;
  // Tight enough that gravity presses no spring, and blown at the more softly the wider: a sheet that buckles
  // is chaotic.
  net.restLength *= side > 25 ? 0.9 : 0.95;
  const double wider = side / 25.0;
  const double blow = 1e-3 / (wider * wider);
  scene.loads.gravity = {0, 0, -9.81};
  NodalForce wind;
  for (Index i = 0; i < net.nodeCount(); ++i) wind.nodes.push_back(i);
  wind.force = curve({0.0, 0.1, 0.2}, {{0, 0, 0}, {0, blow, 0}, {0, 0, 0}});
  scene.loads.forces.push_back(wind);
  return scene;
}

} // namespace

Scene sheet(const SceneOptions& options)
{
  return sheetOf(evenCount(100 * std::sqrt(options.size)), options);
}

Scene smallSheet()
{
  Scene scene = sheetOf(25, {});
  scene.name = "small-sheet";
  return scene;
}

Scene stiff(const SceneOptions& options)
{
  const Index rings = evenCount(20 * options.size);
  Scene scene{"stiff", tubeNet(rings), {}, durationOr(options, 1.0)};
  SpringNet& net = scene.net;
  std::mt19937 random(seedOr(options, 4));
  constexpr double kPull = 1.5e-3; // [N] in every spring at the start
  anchorAll(net, 0.5, 2e-3);
  for (Index i = 0; i < net.nodeCount(); ++i) net.mass[i] = powerOfTen(uniform(random, -6.0, -2.0));
  for (Index s = 0; s < net.springCount(); ++s) {
    const Index a = net.ends(0, s), b = net.ends(1, s);
    net.stiffness[s] = powerOfTen(uniform(random, 0.0, 6.0));
    const double reduced = net.mass[a] * net.mass[b] / (net.mass[a] + net.mass[b]);
    net.viscosity[s] =
      std::clamp(0.1 * std::sqrt(net.stiffness[s] * reduced), 1e-4, 5.0); // damping ratio 1/20
    const Eigen::Vector3d along = net.restPosition.col(b) - net.restPosition.col(a);
    const double length = along.norm();
    net.restLength[s] = length - kPull / net.stiffness[s];
    net.anchors.point.col(a) -= along * (kPull / length / 0.5); // the bedding balances it
    net.anchors.point.col(b) += along * (kPull / length / 0.5);
  }
  NodalForce push;
  push.nodes = middleRing(rings);
  push.force = curve({0.0, 0.1, 0.5, 0.6}, {{0, 0, 0}, {0, 0.01, 0}, {0, 0.01, 0}, {0, 0, 0}});
  scene.loads.forces.push_back(push);
  return scene;
}

Scene organ100k(const SceneOptions& options)
{
  const auto frequency = static_cast<Index>(std::max(1L, std::lround(100 * std::sqrt(options.size))));
  std::vector<Eigen::Vector3d> positions;
  Edges edges;
  const Eigen::Vector3d axes(0.04, 0.025, 0.02);
  geodesicSphere(frequency, positions, edges);
  for (Eigen::Vector3d& x : positions) x = onGrid(axes.cwiseProduct(x));
  Scene scene{"organ100k", netOf(positions, edges), {}, durationOr(options, 0.2)};
  SpringNet& net = scene.net;
  net.stiffness.setConstant(100.0);
  if (options.seed) drawStiffness(net, options.seed, 75.0, 125.0);
  net.viscosity.setConstant(0.01);
  net.mass.setConstant(3e-6);
  std::fill(net.law.begin(), net.law.end(), SpringLaw::Cubic);
  net.lawParameter.setConstant(2.0);
  net.restLength *= 0.95;
  anchorAll(net, 0.2, 1e-4);
  scene.loads.forces.push_back(poke(net, axes.z(), 1.0, 0.05));
  return scene;
}

} // namespace esm::bench
