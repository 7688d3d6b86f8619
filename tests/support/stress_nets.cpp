// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "tests/support/stress_nets.h"

#include "tests/support/dice.h"
#include "tests/support/nets.h"

#include <algorithm>
#include <cmath>

namespace esm::test {
namespace {

constexpr double kFrame = 1.0 / 60.0; // [s]

/// Stiffness and viscosity are drawn later.
void join(SpringNet& net, Index a, Index b)
{
  addSpring(net, a, b, 1.0);
}

/// Every node joined to up to three earlier ones.
SpringNet heap(Dice& dice, Index nodes, double size)
{
  SpringNet net;
  for (Index i = 0; i < nodes; ++i) addNode(net, dice.vector(size));
  const Index start = dice.oneIn(4) ? nodes / 2 : 0; // or in two pieces
  for (Index i = 1; i < nodes; ++i) {
    const Index first = i > start ? start : 0;
    if (i == first) continue;
    for (Index k = std::min<Index>(3, i - first); k > 0; --k) join(net, i, first + dice.below(i - first));
  }
  return net;
}

/// All nodes joined to the first.
SpringNet star(Dice& dice, Index nodes, double size)
{
  SpringNet net;
  for (Index i = 0; i < nodes; ++i) addNode(net, dice.vector(size));
  for (Index i = 1; i < nodes; ++i) join(net, 0, i);
  return net;
}

SpringNet ringTube(Index rings, double size)
{
  SpringNet net;
  constexpr Index kAround = 5;
  for (Index j = 0; j < rings; ++j)
    for (Index i = 0; i < kAround; ++i) {
      const double angle = (i + 0.5 * (j % 2)) * 1.2566370614359172;
      addNode(net, {size * j, size * std::cos(angle), size * std::sin(angle)});
    }
  for (Index j = 0; j < rings; ++j)
    for (Index i = 0; i < kAround; ++i) {
      const Index here = j * kAround + i, next = j * kAround + (i + 1) % kAround;
      join(net, here, next);
      if (j + 1 == rings) continue;
      join(net, here, here + kAround);
      join(net, here, j % 2 ? next + kAround : (j + 1) * kAround + (i + kAround - 1) % kAround);
    }
  return net;
}

/// A cube of n^3 nodes, joined to all neighbours, the diagonal ones included.
SpringNet block(Index n, double size)
{
  SpringNet net;
  for (Index k = 0; k < n * n * n; ++k)
    addNode(net, {size * (k % n), size * (k / n % n), size * (k / n / n)});
  for (Index b = 0; b < n * n * n; ++b)
    for (Index a = 0; a < b; ++a)
      if ((net.restPosition.col(a) - net.restPosition.col(b)).cwiseAbs().maxCoeff() < 1.5 * size)
        join(net, a, b);
  return net;
}

SpringNet shape(Dice& dice)
{
  const double size = dice.decades(-3, 0);
  switch (dice.below(6)) {
  case 0:
    return star(dice, 5 + dice.below(30), size);
  case 1:
    return chain(5 + dice.below(56), size);
  case 2:
    return ringTube(2 + dice.below(10), size);
  case 3:
    return block(2 + dice.below(2), size);
  case 4:
    return sheet(3 + dice.below(5), size, 1.0);
  default:
    return heap(dice, 5 + dice.below(56), size);
  }
}

void drawMasses(Dice& dice, SpringNet& net)
{
  const double common = dice.decades(-6, 0);
  const Index kind = dice.below(4);
  for (Index i = 0; i < net.nodeCount(); ++i) {
    if (kind == 0) net.mass[i] = dice.decades(-9, 3);
    if (kind == 1) net.mass[i] = dice.oneIn(8) ? 1e-9 : common;
    if (kind == 2) net.mass[i] = common * dice.decades(-1, 1);
    if (kind == 3) net.mass[i] = common;
  }
  if (!dice.oneIn(4)) return;
  net.massDamping = Eigen::ArrayXd::Zero(net.nodeCount());
  for (double& alpha : net.massDamping) alpha = dice.oneIn(2) ? 0.0 : dice.decades(-1, 4);
}

void drawLaws(Dice& dice, SpringNet& net)
{
  net.tables = {{{-0.5, 0.0, 0.1, 0.4}, {-0.3, 0.0, 0.1, 1.2}}, {{-0.1, 0.05, 0.3}, {-0.2, 0.02, 0.5}}};
  const Index kind = dice.below(6); // 4, 5: all mixed
  for (std::size_t s = 0; s < net.law.size(); ++s) {
    const auto i = static_cast<Index>(s);
    net.law[s] = static_cast<SpringLaw>(kind < 4 ? kind : dice.below(4));
    if (net.law[s] == SpringLaw::Cubic) net.lawParameter[i] = dice.decades(-1, 2);
    if (net.law[s] == SpringLaw::Exponential) net.lawParameter[i] = dice.uniform(0.5, 15.0);
    if (net.law[s] == SpringLaw::Table) net.lawParameter[i] = dice.below(2);
  }
}

void drawStrengths(Dice& dice, SpringNet& net)
{
  const double common = dice.decades(0, 3), times = dice.decades(0, 9), spread = dice.oneIn(3) ? 9.0 : 0.3;
  const Index kind = dice.below(5);
  const double ratio = dice.decades(-6, -1);
  for (Index s = 0; s < net.springCount(); ++s) {
    net.stiffness[s] = std::min(
      common * (spread > 1.0 ? dice.decades(0, spread) : times * dice.decades(-spread, spread)), 1e12);
    net.viscosity[s] = kind == 0                    ? 0.0
                       : kind == 1 && dice.oneIn(2) ? dice.decades(0, 6)
                       : kind == 2                  ? dice.decades(-4, 2)
                                                    : net.stiffness[s] * ratio * dice.decades(-0.5, 0.5);
    if (dice.oneIn(40)) net.stiffness[s] = 0.0;
  }
}

/// Pre-stretched, slack, of length zero and of rest length zero.
void drawLengths(Dice& dice, SpringNet& net)
{
  const double stretch = dice.oneIn(2) ? 0.0 : dice.uniform(0.0, 0.4);
  for (double& length : net.restLength) length *= dice.uniform(1.0 - stretch, 1.0 + stretch);
  if (dice.oneIn(4)) { // two nodes in one place
    const Index s = dice.below(net.springCount());
    net.restPosition.col(net.ends(0, s)) = net.restPosition.col(net.ends(1, s));
  }
  for (Index s = 0; s < net.springCount(); ++s)
    if (net.law[static_cast<std::size_t>(s)] == SpringLaw::Linear && dice.oneIn(30)) net.restLength[s] = 0.0;
  for (Index s = 0; s < net.springCount(); ++s) // by chance, in a heap
    if (net.law[static_cast<std::size_t>(s)] != SpringLaw::Linear)
      net.restLength[s] = std::max(net.restLength[s], 1e-4);
  if (dice.oneIn(4))
    for (std::uint8_t& slack : net.tensionOnly) slack = dice.oneIn(2);
}

void hold(Dice& dice, SpringNet& net)
{
  const Index kind = dice.below(4); // 3: flies freely
  for (Index i = 0; i < net.nodeCount(); ++i) {
    if (kind == 0 && (i == 0 || i + 1 == net.nodeCount())) net.fixed[static_cast<std::size_t>(i)] = 1;
    if (kind == 1 && dice.oneIn(5)) net.fixed[static_cast<std::size_t>(i)] = 1;
    if (kind == 2)
      addAnchor(net, i, net.restPosition.col(i), dice.decades(-1, dice.oneIn(8) ? 9 : 3),
                dice.oneIn(3) ? 0.0 : dice.decades(-4, 2));
  }
  if (dice.oneIn(3)) return;
  net.initialVelocity = Eigen::Matrix3Xd::Zero(3, net.nodeCount());
  for (Index i = 0; i < net.nodeCount(); ++i) net.initialVelocity.col(i) = dice.vector(0.3);
}

/// Corners at multiples of a third of a frame, some of them jumps.
VectorCurve drawCurve(Dice& dice, double size)
{
  VectorCurve curve;
  const Index points = 1 + dice.below(4);
  curve.value.resize(3, points);
  double time = 0.0;
  for (Index i = 0; i < points; ++i) {
    curve.time.push_back(time);
    curve.value.col(i) = dice.oneIn(3) ? Eigen::Vector3d::Zero() : dice.vector(size);
    if (i > 0 && dice.oneIn(3)) continue; // the next value in no time
    time += (1 + dice.below(5)) * kFrame / 3.0;
  }
  return curve;
}

Loads drawLoads(Dice& dice, const SpringNet& net, double size)
{
  Loads loads;
  if (dice.oneIn(2)) loads.gravity = {0, 0, -9.81};
  if (dice.oneIn(2)) {
    const double force = dice.decades(-3, dice.oneIn(3) ? 6 : 1);
    loads.forces.push_back({{dice.below(net.nodeCount())}, drawCurve(dice, force)});
    if (dice.oneIn(2)) loads.forces.back().nodes.push_back(dice.below(net.nodeCount()));
  }
  if (dice.oneIn(3)) {
    PrescribedMotion motion;
    motion.nodes = {dice.below(net.nodeCount())};
    // An exponential spring of twenty times its length would hold more joules than numbers have digits.
    motion.displacement = drawCurve(dice, std::min(0.3 * size, net.restLength.mean()));
    if (dice.oneIn(2)) motion.release = (1 + dice.below(9)) * kFrame / 3.0;
    loads.motions.push_back(motion);
  }
  return loads;
}

std::vector<ToolSpring> drawTools(Dice& dice, const SpringNet& net, double size)
{
  std::vector<ToolSpring> tools(static_cast<std::size_t>(dice.below(3)));
  for (ToolSpring& tool : tools) {
    tool.node = dice.below(net.nodeCount());
    tool.target = net.restPosition.col(tool.node) + dice.vector(size);
    tool.targetVelocity = dice.vector(size);
    tool.stiffness = dice.decades(-1, dice.oneIn(5) ? 7 : 3);
    tool.viscosity = dice.oneIn(2) ? 0.0 : dice.decades(-4, 2);
  }
  return tools;
}

/// A cut, a slider, or all sliders at once.
SpringNet changed(Dice& dice, SpringNet net)
{
  const Index kind = dice.below(4);
  if (kind == 0) {
    const Index rarity = 2 + dice.below(10);
    for (Index s = 0; s < net.springCount(); ++s)
      if (dice.oneIn(rarity)) net.stiffness[s] = net.viscosity[s] = 0.0;
  }
  if (kind == 1) net.stiffness = (net.stiffness * dice.decades(-4, 4)).min(1e12);
  if (kind == 2) net.viscosity *= dice.oneIn(3) ? 0.0 : dice.decades(-4, 4);
  if (kind == 3) {
    drawMasses(dice, net);
    drawStrengths(dice, net);
  }
  return net;
}

} // namespace

StressCase stressCase(std::uint32_t seed)
{
  Dice dice(seed);
  StressCase result;
  SpringNet& net = result.net;
  net = shape(dice);
  const double size = (net.restPosition.rowwise().maxCoeff() - net.restPosition.rowwise().minCoeff()).norm();
  drawMasses(dice, net);
  drawLaws(dice, net);
  drawStrengths(dice, net);
  drawLengths(dice, net);
  hold(dice, net);
  result.loads = drawLoads(dice, net, size);
  result.frames = 4 + dice.below(5);
  SpringNet now = net;
  for (int frame = 0; frame < result.frames; ++frame) {
    StressCase::Change change{frame, {}, {}};
    if (dice.oneIn(4)) change.tools = drawTools(dice, net, 0.3 * size);
    if (frame > 0 && dice.oneIn(6)) change.net = now = changed(dice, now);
    if (change.tools || change.net) result.changes.push_back(std::move(change));
  }
  return result;
}

} // namespace esm::test
