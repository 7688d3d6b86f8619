// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "bench/scenes.h"

#include "core/net/net_builder.h"

#include <cmath>
#include <numbers>
#include <random>
#include <utility>

namespace esm::bench {
namespace {

/// To a grid of 2^-40 m: the C library's sine has other last bits on CPUs with FMA, and golden hashes see
/// them.
Eigen::Vector3d onGrid(const Eigen::Vector3d& x)
{
  return x.unaryExpr(
    [](double value) { return std::ldexp(std::round(std::ldexp(value, 40)), -40) + 0.0; }); // no -0
}

using Edges = std::vector<std::pair<Index, Index>>;

double uniform(std::mt19937& random, double low, double high)
{
  return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
}

SpringNet netOf(const std::vector<Eigen::Vector3d>& positions, const Edges& edges)
{
  SpringNet net;
  resizeNet(net, static_cast<Index>(positions.size()), static_cast<Index>(edges.size()));
  for (std::size_t i = 0; i < positions.size(); ++i)
    net.restPosition.col(static_cast<Index>(i)) = positions[i];
  for (std::size_t s = 0; s < edges.size(); ++s) {
    const auto place = static_cast<Index>(s);
    net.ends.col(place) << edges[s].first, edges[s].second;
    net.restLength[place] = (positions[static_cast<std::size_t>(edges[s].first)] -
                             positions[static_cast<std::size_t>(edges[s].second)])
                              .norm();
  }
  return net;
}

void anchorAll(SpringNet& net, double stiffness, double viscosity)
{
  const Index count = net.nodeCount();
  net.anchors.node.resize(static_cast<std::size_t>(count));
  for (Index i = 0; i < count; ++i) net.anchors.node[static_cast<std::size_t>(i)] = i;
  net.anchors.point = net.restPosition;
  net.anchors.stiffness = Eigen::ArrayXd::Constant(count, stiffness);
  net.anchors.viscosity = Eigen::ArrayXd::Constant(count, viscosity);
}

VectorCurve curve(std::vector<double> time, std::vector<Eigen::Vector3d> values)
{
  VectorCurve result;
  result.time = std::move(time);
  result.value.resize(3, static_cast<Eigen::Index>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i) result.value.col(static_cast<Eigen::Index>(i)) = values[i];
  return result;
}

} // namespace

Scene tube()
{
  constexpr Index kRings = 20, kAround = 20;
  constexpr double kLength = 0.10, kRadius = 0.006;
  std::vector<Eigen::Vector3d> positions;
  Edges edges;
  for (Index r = 0; r < kRings; ++r)
    for (Index a = 0; a < kAround; ++a) {
      const double angle = 2 * std::numbers::pi * (a + 0.5 * (r % 2)) / kAround;
      positions.push_back(
        onGrid({kLength * r / (kRings - 1), kRadius * std::cos(angle), kRadius * std::sin(angle)}));
      const Index here = r * kAround + a, next = r * kAround + (a + 1) % kAround;
      edges.emplace_back(here, next);
      if (r + 1 == kRings) continue;
      edges.emplace_back(here, here + kAround);
      edges.emplace_back(r % 2 ? here : next, (r % 2 ? next : here) + kAround);
    }
  Scene scene{"tube", netOf(positions, edges), {}, 2.0, 1e-5};
  SpringNet& net = scene.net;
  std::mt19937 random(1);
  for (Index s = 0; s < net.springCount(); ++s) net.stiffness[s] = uniform(random, 23.0, 75.0);
  net.viscosity = 5e-4 * net.stiffness;
  net.restLength *= 0.97; // a little pre-stretch keeps the wall from buckling
  net.mass.setConstant(1.25e-5);
  anchorAll(net, 0.1, 5e-5);
  PrescribedMotion pull;
  for (Index a = 0; a < kAround; ++a) {
    net.fixed[static_cast<std::size_t>(a)] = 1;
    net.fixed[static_cast<std::size_t>((kRings - 1) * kAround + a)] = 1;
    pull.nodes.push_back(kRings / 2 * kAround + a);
  }
  pull.displacement = curve({0.0, 0.2}, {{0, 0, 0}, {0, 0.02, 0}});
  pull.release = 0.2;
  scene.loads.motions.push_back(pull);
  return scene;
}

Scene uterus()
{
  constexpr Index kRings = 26, kAround = 48;
  const Eigen::Vector3d axes(0.04, 0.025, 0.02);
  std::vector<Eigen::Vector3d> positions;
  Edges edges;
  const auto place = [&](double theta, double phi) {
    const Eigen::Vector3d unit(std::cos(theta), std::sin(theta) * std::cos(phi),
                               std::sin(theta) * std::sin(phi));
    positions.push_back(onGrid(axes.cwiseProduct(unit)));
  };
  for (Index r = 0; r < kRings; ++r)
    for (Index a = 0; a < kAround; ++a) {
      place(std::numbers::pi * (r + 1) / (kRings + 1), 2 * std::numbers::pi * (a + 0.5 * (r % 2)) / kAround);
      const Index here = r * kAround + a, next = r * kAround + (a + 1) % kAround;
      edges.emplace_back(here, next);
      if (r + 1 < kRings) {
        edges.emplace_back(here, here + kAround);
        edges.emplace_back(r % 2 ? here : next, (r % 2 ? next : here) + kAround);
      } else {
        edges.emplace_back(here, kRings * kAround + 1);
      }
      if (r == 0) edges.emplace_back(kRings * kAround, here);
    }
  place(0.0, 0.0);
  place(std::numbers::pi, 0.0);
  Scene scene{"uterus", netOf(positions, edges), {}, 1.0, 1e-5};
  SpringNet& net = scene.net;
  std::mt19937 random(2);
  for (Index s = 0; s < net.springCount(); ++s) {
    net.stiffness[s] = uniform(random, 150.0, 250.0);
    net.law[static_cast<std::size_t>(s)] = SpringLaw::Exponential;
    net.lawParameter[s] = 3.0;
  }
  net.viscosity = 2e-4 * net.stiffness;
  net.mass.setConstant(4.8e-5);
  net.restLength *=
    0.9; // stretched over its content, as the organ is: a slack closed surface buckles chaotically
  anchorAll(net, 5.0, 1e-3);
  NodalForce press;
  const Eigen::Vector3d centre(0.0, 0.0, axes.z());
  for (Index i = 0; i < net.nodeCount(); ++i)
    if ((net.restPosition.col(i) - centre).norm() < 0.01) press.nodes.push_back(i);
  const double share = 1.0 / static_cast<double>(press.nodes.size());
  press.force = curve({0.0, 0.1}, {{0, 0, 0}, {0, 0, -share}});
  scene.loads.forces.push_back(press);
  return scene;
}

Scene smallSheet()
{
  constexpr Index kSide = 25;
  std::vector<Eigen::Vector3d> positions;
  Edges edges;
  for (Index j = 0; j < kSide; ++j)
    for (Index i = 0; i < kSide; ++i) {
      positions.emplace_back(0.004 * i, 0.0, -0.004 * j);
      const Index here = j * kSide + i;
      if (i + 1 < kSide) edges.emplace_back(here, here + 1);
      if (j + 1 < kSide) edges.emplace_back(here, here + kSide);
      if (i + 1 < kSide && j + 1 < kSide) edges.emplace_back(here, here + kSide + 1);
    }
  Scene scene{"sheet", netOf(positions, edges), {}, 1.0, 1e-5};
  SpringNet& net = scene.net;
  net.stiffness.setConstant(200.0);
  net.viscosity.setConstant(0.02);
  net.mass.setConstant(3e-5);
  for (Index i = 0; i < kSide; ++i) net.fixed[static_cast<std::size_t>(i)] = 1;
  for (Index j = 0; j < kSide; ++j) // a frame: side edges held too, or the sheet would fold chaotically
    net.fixed[static_cast<std::size_t>(j * kSide)] =
      net.fixed[static_cast<std::size_t>(j * kSide + kSide - 1)] = 1;
  net.restLength *= 0.95;
  scene.loads.gravity = {0, 0, -9.81};
  NodalForce wind;
  for (Index i = 0; i < net.nodeCount(); ++i) wind.nodes.push_back(i);
  wind.force = curve({0.0, 0.1, 0.2}, {{0, 0, 0}, {0, 1e-3, 0}, {0, 0, 0}});
  scene.loads.forces.push_back(wind);
  return scene;
}

std::vector<Scene> allScenes()
{
  return {tube(), uterus(), smallSheet()};
}

} // namespace esm::bench
