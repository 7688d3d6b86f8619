// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "bench/skip_scenes.h"

#include "core/net/net_builder.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace esm::bench {
namespace {

constexpr double kSpacing = 7e-4;    ///< [m]
constexpr double kStiffness = 100.0; ///< of springs [N/m]
constexpr double kBedding = 5.0;     ///< of anchors [N/m]
constexpr double kSpeed = 0.02;      ///< of the tool [m/s]

/// Rings of nodes around the x axis, staggered, with a node at each pole.
SpringNet ellipsoid(Index wanted)
{
  const auto rings = static_cast<Index>(std::lround(std::sqrt(static_cast<double>(wanted) / 1.6)));
  const Index around = wanted / rings;
  const double radius = kSpacing * around / (2 * std::numbers::pi), half = 0.5 * kSpacing * rings;
  SpringNet net;
  resizeNet(net, rings * around + 2, 3 * rings * around);
  Index spring = 0;
  const auto join = [&](Index a, Index b) { net.ends.col(spring++) << a, b; };
  for (Index r = 0; r < rings; ++r)
    for (Index a = 0; a < around; ++a) {
      const double theta = std::numbers::pi * (r + 1) / (rings + 1);
      const double phi = 2 * std::numbers::pi * (a + 0.5 * (r % 2)) / around;
      const Index here = r * around + a, next = r * around + (a + 1) % around;
      net.restPosition.col(here) << half * std::cos(theta), radius * std::sin(theta) * std::cos(phi),
        radius * std::sin(theta) * std::sin(phi);
      join(here, next);
      if (r + 1 < rings) {
        join(here, here + around);
        join(r % 2 ? here : next, (r % 2 ? next : here) + around);
      } else {
        join(here, rings * around + 1);
      }
      if (r == 0) join(rings * around, here);
    }
  net.restPosition.col(rings * around) << half, 0, 0;
  net.restPosition.col(rings * around + 1) << -half, 0, 0;
  for (Index s = 0; s < net.springCount(); ++s)
    net.restLength[s] =
      0.95 * (net.restPosition.col(net.ends(0, s)) - net.restPosition.col(net.ends(1, s))).norm();
  std::fill(net.law.begin(), net.law.end(), SpringLaw::Cubic);
  net.lawParameter.setConstant(2.0);
  net.stiffness.setConstant(kStiffness);
  net.mass.setConstant(3e-6);
  net.mass.tail(2).setConstant(3e-6 * around / 6.0); // a pole has many springs: else it would set all steps
  return net;
}

/// Anchors that hold every node where it is against the pull of the stretched springs.
void bed(SpringNet& net, double viscosity)
{
  const Index count = net.nodeCount();
  Eigen::Matrix3Xd pull = Eigen::Matrix3Xd::Zero(3, count);
  for (Index s = 0; s < net.springCount(); ++s) {
    const Index a = net.ends(0, s), b = net.ends(1, s);
    const Eigen::Vector3d d = net.restPosition.col(b) - net.restPosition.col(a);
    const double e = d.norm() - net.restLength[s], strain = e / net.restLength[s];
    const Eigen::Vector3d force =
      net.stiffness[s] * e * (1 + net.lawParameter[s] * strain * strain) * d.normalized();
    pull.col(a) += force;
    pull.col(b) -= force;
  }
  net.anchors.node.resize(static_cast<std::size_t>(count));
  for (Index i = 0; i < count; ++i) net.anchors.node[static_cast<std::size_t>(i)] = i;
  net.anchors.point = net.restPosition - pull / kBedding;
  net.anchors.stiffness = Eigen::ArrayXd::Constant(count, kBedding);
  net.anchors.viscosity = Eigen::ArrayXd::Constant(count, viscosity);
}

/// The node on the equator, and from it to the tool's way along x.
Index touchedNode(const SpringNet& net)
{
  Index best = 0;
  const auto square = [&](Index i) {
    const auto p = net.restPosition.col(i);
    return p.x() * p.x() + p.y() * p.y() + (p.z() < 0 ? 1.0 : 0.0);
  };
  for (Index i = 1; i < net.nodeCount(); ++i)
    if (square(i) < square(best)) best = i;
  return best;
}

/// Nodes that feel the tool at the same times share a load. The tool comes within the first 1/10 s; then the
/// force on a node rises and falls linearly while the tool passes.
void press(SkipScene& scene, double radius)
{
  const Eigen::Vector3d centre = scene.net.restPosition.col(scene.touched);
  const double reach = radius * kSpacing, perFrame = kSpeed / kFrameRate;
  const int passing = std::max(2 * static_cast<int>(std::lround(reach / perFrame / 2)), 2); // frames
  std::map<int, std::vector<Index>> byFrame; // when it is nearest
  for (Index i = 0; i < scene.net.nodeCount(); ++i) {
    const Eigen::Vector3d away = scene.net.restPosition.col(i) - centre;
    const bool reached = std::hypot(away.y(), away.z()) <= reach && away.x() >= -reach &&
                         away.x() <= kSpeed * scene.duration + reach;
    if (reached) byFrame[2 * static_cast<int>(std::lround(away.x() / perFrame / 2))].push_back(i);
  }
  const Eigen::Vector3d most(0.01, 0.0, -0.02); // [N]
  for (const auto& [top, nodes] : byFrame) {
    std::vector<int> frames{0, 6, top - passing, top, top + passing};
    std::erase_if(frames, [](int frame) { return frame < 0; });
    std::sort(frames.begin(), frames.end());
    frames.erase(std::unique(frames.begin(), frames.end()), frames.end());
    NodalForce force;
    force.nodes = nodes;
    force.force.value.resize(3, static_cast<Eigen::Index>(frames.size()));
    for (const int frame : frames) {
      const double passed = std::max(0.0, 1.0 - std::abs(frame - top) / static_cast<double>(passing));
      force.force.value.col(static_cast<Eigen::Index>(force.force.time.size())) =
        most * (passed * std::min(1.0, frame / 6.0));
      force.force.time.push_back(frame / kFrameRate);
    }
    scene.loads.forces.push_back(std::move(force));
  }
}

} // namespace

SkipScene pressedOrgan(Index nodes, double radius, double duration)
{
  SkipScene scene;
  scene.name = "pressed_r" + std::to_string(static_cast<int>(radius));
  scene.net = ellipsoid(nodes);
  scene.duration = duration;
  scene.finestStep = 3e-5;
  scene.reference = "verlet"; // so strongly damped that its error at this step is 1e-7
  bed(scene.net, 0.05);
  scene.touched = touchedNode(scene.net);
  press(scene, radius);
  return scene;
}

SkipScene struckOrgan(Index nodes, double duration)
{
  SkipScene scene;
  scene.name = "struck";
  scene.net = ellipsoid(nodes);
  scene.duration = duration;
  scene.finestStep = 2e-5;
  bed(scene.net, 1.5e-4);
  scene.net.viscosity.setConstant(5e-3);
  scene.touched = touchedNode(scene.net);
  NodalForce blow;
  const Eigen::Vector3d centre = scene.net.restPosition.col(scene.touched);
  for (Index i = 0; i < scene.net.nodeCount(); ++i)
    if ((scene.net.restPosition.col(i) - centre).norm() < 5 * kSpacing) blow.nodes.push_back(i);
  blow.force.time = {0.0, 0.0025, 0.005}; // a blow is shorter than a frame
  blow.force.value = Eigen::Matrix3Xd::Zero(3, 3);
  blow.force.value.col(1) << 0.0, 0.0, -0.05;
  scene.loads.forces.push_back(std::move(blow));
  return scene;
}

} // namespace esm::bench
