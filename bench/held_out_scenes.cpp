// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "bench/held_out_scenes.h"

#include "bench/scene_shapes.h"
#include "bench/skip_scenes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace esm::bench {
namespace {

/// Nodes in a row, the first one held.
SpringNet row(const std::vector<Eigen::Vector3d>& positions, double stiffness, double viscosity, double mass)
{
  Edges edges;
  for (std::size_t i = 0; i + 1 < positions.size(); ++i)
    edges.emplace_back(static_cast<Index>(i), static_cast<Index>(i + 1));
  SpringNet net = netOf(positions, edges);
  net.stiffness.setConstant(stiffness);
  net.viscosity.setConstant(viscosity);
  net.mass.setConstant(mass);
  net.fixed[0] = 1;
  return net;
}

/// Two rods, let go from the horizontal, out of one plane.
HeldOutScene doublePendulum()
{
  HeldOutScene scene{
    {"double-pendulum", row({{0, 0, 0}, {0.1, 0, 0}, {0.13, 0.08, 0}}, 3e4, 0.0, 0.03), {}, 3.0}, true};
  scene.loads.gravity = {0, 0, -9.81};
  return scene;
}

/// Three rods of 10 cm and 50 g, let go a little beside the upright.
HeldOutScene triplePendulum()
{
  HeldOutScene scene{
    {"triple-pendulum",
     row({{0, 0, 0}, {0.01, 0, 0.0995}, {0.0, 0.012, 0.198}, {0.02, 0, 0.297}}, 2e4, 0.0, 0.05),
     {},
     3.0},
    true};
  scene.loads.gravity = {0, 0, -9.81};
  return scene;
}

/// A chain of fourteen links, let go in a flat zigzag.
HeldOutScene whip()
{
  std::vector<Eigen::Vector3d> positions;
  for (int i = 0; i <= 14; ++i) positions.emplace_back(0.02 * i, 0.004 * (i % 3), 0.003 * (i % 2));
  HeldOutScene scene{{"whip", row(positions, 500.0, 1e-3, 2e-3), {}, 1.5}, true};
  scene.loads.gravity = {0, 0, -9.81};
  return scene;
}

/// Rings of nodes on a shallow cap whose rim is held; `push` [N] on the top in 0.2 s.
HeldOutScene roof(const std::string& name, int rings, int around, double rise, double push, double viscosity)
{
  constexpr double kRadius = 0.05;
  std::vector<Eigen::Vector3d> positions{onGrid({0, 0, rise})};
  Edges edges;
  for (int r = 1; r <= rings; ++r)
    for (int a = 0; a < around; ++a) {
      const double share = static_cast<double>(r) / rings,
                   angle = 2 * std::numbers::pi * (a + 0.5 * r) / around;
      positions.push_back(onGrid({kRadius * share * std::cos(angle), kRadius * share * std::sin(angle),
                                  rise * (1.0 - share * share)}));
      const Index first = 1 + (r - 1) * around, here = first + a, next = first + (a + 1) % around;
      edges.emplace_back(here, next);
      if (r == 1) {
        edges.emplace_back(here, 0);
        continue;
      }
      edges.emplace_back(here, here - around); // rings are staggered
      edges.emplace_back(here, next - around);
    }
  HeldOutScene scene{{name, netOf(positions, edges), {}, 0.8}, true};
  SpringNet& net = scene.net;
  net.stiffness.setConstant(400.0);
  net.viscosity.setConstant(viscosity);
  net.mass.setConstant(2e-4);
  std::fill(net.fixed.end() - around, net.fixed.end(), std::uint8_t{1}); // the outermost ring
  NodalForce press;
  press.nodes = {0};
  press.force = curve({0.0, 0.2}, {{0, 0, 0}, {0, 0, -push}});
  scene.loads.forces.push_back(press);
  return scene;
}

/// Six balls in a cage of nodes that stand: each is held off from the others and from the cage by springs that
/// pull hardly and stiffen steeply once they are pressed.
HeldOutScene balls()
{
  const auto table = [] {
    ForceTable bumper; // no force from touching on, and hard before
    bumper.strain = {-1.0, -0.6, -0.5, 1.0};
    bumper.force = {-20.0, -1.0, 0.0, 0.0};
    return bumper;
  };
  std::vector<Eigen::Vector3d> positions;
  positions.reserve(14);
  for (int corner = 0; corner < 8; ++corner)
    positions.emplace_back(corner & 1 ? 0.1 : 0.0, corner & 2 ? 0.1 : 0.0, corner & 4 ? 0.1 : 0.0);
  for (int i = 0; i < 6; ++i)
    positions.emplace_back(0.03 + 0.04 * (i % 2), 0.025 + 0.05 * (i / 2 % 2), 0.03 + 0.01 * i);
  Edges edges;
  for (Index a = 8; a < 14; ++a)
    for (Index b = 0; b < a; ++b) edges.emplace_back(a, b);
  HeldOutScene scene{{"balls", netOf(positions, edges), {}, 1.0}, true};
  SpringNet& net = scene.net;
  net.tables.push_back(table());
  for (Index s = 0; s < net.springCount(); ++s) {
    net.law[static_cast<std::size_t>(s)] = SpringLaw::Table;
    net.lawParameter[s] = 0.0;
    net.restLength[s] = net.ends(1, s) < 8 ? 0.1 : 0.06; // they touch at half of it
  }
  net.stiffness.setConstant(40.0);
  net.mass.setConstant(5e-3);
  std::fill(net.fixed.begin(), net.fixed.begin() + 8, std::uint8_t{1});
  anchorAll(net, 2.0, 0.0); // a soft pull to the middle keeps them inside
  net.anchors.point.colwise() = Eigen::Vector3d(0.05, 0.05, 0.05);
  net.initialVelocity = Eigen::Matrix3Xd::Zero(3, net.nodeCount());
  for (Index i = 8; i < 14; ++i)
    net.initialVelocity.col(i) =
      Eigen::Vector3d(0.8 - 0.3 * static_cast<double>(i % 4), 0.5 * (i % 3 - 1.0), 0.4);
  return scene;
}

HeldOutScene tame(Scene scene, const std::string& name)
{
  scene.name = name;
  return {std::move(scene), false};
}

/// A block of 6 x 6 x 6 nodes that stands on a table and sags, springs to all neighbours of a cube.
HeldOutScene block()
{
  constexpr Index kSide = 6;
  std::vector<Eigen::Vector3d> positions;
  Edges edges;
  const auto at = [](Index i, Index j, Index k) { return (k * kSide + j) * kSide + i; };
  for (Index k = 0; k < kSide; ++k)
    for (Index j = 0; j < kSide; ++j)
      for (Index i = 0; i < kSide; ++i) positions.emplace_back(0.01 * i, 0.01 * j, 0.01 * k);
  for (Index k = 0; k < kSide; ++k)
    for (Index j = 0; j < kSide; ++j)
      for (Index i = 0; i < kSide; ++i)
        for (Index n = 1; n < 8; ++n) {
          const Index di = n & 1, dj = n >> 1 & 1, dk = n >> 2 & 1;
          if (i + di < kSide && j + dj < kSide && k + dk < kSide)
            edges.emplace_back(at(i, j, k), at(i + di, j + dj, k + dk));
        }
  HeldOutScene scene{{"block", netOf(positions, edges), {}, 1.5}, false};
  scene.net.stiffness.setConstant(60.0);
  scene.net.viscosity.setConstant(0.05);
  scene.net.mass.setConstant(1e-3);
  std::fill(scene.net.fixed.begin(), scene.net.fixed.begin() + kSide * kSide, std::uint8_t{1});
  scene.loads.gravity = {0, 0, -9.81};
  return scene;
}

/// A net of 16 x 16 nodes between two bars, slack by nothing, that sags by its weight.
HeldOutScene hammock()
{
  constexpr Index kSide = 16;
  std::vector<Eigen::Vector3d> positions;
  Edges edges;
  for (Index j = 0; j < kSide; ++j)
    for (Index i = 0; i < kSide; ++i) {
      positions.emplace_back(0.01 * i, 0.01 * j, 0.0);
      if (i > 0) edges.emplace_back(j * kSide + i - 1, j * kSide + i);
      if (j > 0) edges.emplace_back((j - 1) * kSide + i, j * kSide + i);
    }
  HeldOutScene scene{{"hammock", netOf(positions, edges), {}, 1.5}, false};
  scene.net.stiffness.setConstant(30.0);
  scene.net.viscosity.setConstant(0.02);
  scene.net.mass.setConstant(2e-4);
  for (std::size_t i = 0; i < scene.net.fixed.size(); ++i)
    if (i % kSide == 0 || i % kSide == kSide - 1) scene.net.fixed[i] = 1;
  scene.loads.gravity = {0, 0, -9.81};
  return scene;
}

/// Ten links that hang with a bob and swing by ten degrees.
HeldOutScene rope()
{
  std::vector<Eigen::Vector3d> positions;
  for (int i = 0; i <= 10; ++i) positions.emplace_back(0.0174 * i, 0.0, -0.0985 * i);
  HeldOutScene scene{{"rope", row(positions, 2e3, 0.5, 0.01), {}, 2.0}, false};
  scene.net.mass[10] = 0.5;
  scene.net.restLength *= 0.98;
  scene.loads.gravity = {0, 0, -9.81};
  return scene;
}

SceneOptions drawn(unsigned seed, double size, double duration)
{
  return {seed, size, duration};
}

} // namespace

std::vector<HeldOutScene> heldOutScenes()
{
  // The first twelve were run when following was made cheaper, and the poked organ told how long to look.
  std::vector<HeldOutScene> scenes = {triplePendulum(),
                                      whip(),
                                      roof("roof", 4, 9, 0.008, 0.4, 1e-3),
                                      roof("small-roof", 2, 5, 0.012, 1.5, 0.0),
                                      balls(),
                                      doublePendulum(),
                                      roof("wide-roof", 5, 7, 0.006, 0.25, 5e-4),
                                      tame(organ100k(drawn(91, 0.02, 1.0)), "poked organ"),
                                      tame(struckOrgan(1500, 1.0), "struck organ"),
                                      block(),
                                      hammock(),
                                      rope(),
                                      tame(tube(drawn(77, 2.0, 1.5)), "long tube"),
                                      tame(tube(drawn(31, 1.0, 1.5)), "other tube"),
                                      tame(uterus(drawn(12, 0.5, 1.0)), "small uterus"),
                                      tame(struckOrgan(600, 0.8), "small struck organ"),
                                      tame(sheet(drawn(8, 0.09, 1.5)), "drawn sheet"),
                                      tame(sheet(), "sheet")};
  for (HeldOutScene& scene : scenes)
    for (const char* name :
         {"double-pendulum", "wide-roof", "other tube", "small uterus", "small struck organ", "drawn sheet"})
      scene.isFresh = scene.isFresh || scene.name == name;
  return scenes;
}

} // namespace esm::bench
