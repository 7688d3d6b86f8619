// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "tests/support/extreme_nets.h"

#include "tests/support/dice.h"
#include "tests/support/nets.h"

#include <algorithm>

namespace esm::test {
namespace {

constexpr double kEvent = 1.0 / 180.0; // loads turn and jump at multiples of it [s]

/// Nodes and springs of one more part; strengths and masses come later.
void addPart(Dice& dice, SpringNet& net, double size)
{
  const Index first = net.nodeCount(), kind = dice.below(6);
  const Index count = kind == 0 ? 2 : 3 + dice.below(30);
  const Eigen::Vector3d place = net.nodeCount() == 0 ? Eigen::Vector3d::Zero() : dice.vector(3.0 * size);
  const auto at = [&](Index i) -> Eigen::Vector3d {
    if (kind == 2) return {size * i, 0, 0};                                                 // chain
    if (kind == 4) return {size * (i / 4), 0.5 * size * (i % 4 / 2), 0.5 * size * (i % 2)}; // tube
    return dice.vector(size);
  };
  for (Index i = 0; i < count; ++i) addNode(net, place + at(i));
  if (kind == 5 && dice.oneIn(2)) return; // dust
  for (Index i = 1; i < count; ++i) {
    const Index few = kind == 1 || kind == 2 ? 1 : std::min<Index>(i, kind == 4 ? 6 : 4);
    for (Index k = 0; k < few; ++k) {
      const Index other = kind == 1 ? 0 : kind == 3 || kind == 5 ? dice.below(i) : i - 1 - k;
      addSpring(net, first + i, first + other, 1.0);
    }
  }
}

void extremeMasses(Dice& dice, SpringNet& net)
{
  const Index kind = dice.below(3);
  const double common = dice.decades(-12, 6);
  for (double& mass : net.mass)
    mass = kind == 0       ? common
           : kind == 1     ? dice.decades(-12, 6)
           : dice.oneIn(6) ? dice.decades(-12, 6)
                           : common;
}

void extremeSprings(Dice& dice, SpringNet& net)
{
  const Index kind = dice.below(3), damping = dice.below(4), law = dice.below(6);
  const double common = dice.decades(-6, 12), ratio = dice.decades(-6, -1), zero = dice.oneIn(3) ? 0.2 : 0.0;
  const double misfit = dice.oneIn(3) ? 0.0 : dice.uniform(0.0, 0.6);
  net.tables = {{{-0.5, 0.0, 0.1, 0.4}, {-0.3, 0.0, 0.1, 1.2}}};
  for (Index s = 0; s < net.springCount(); ++s) {
    const auto i = static_cast<std::size_t>(s);
    net.stiffness[s] = kind == 0   ? common
                       : kind == 1 ? dice.decades(-6, 12)
                                   : common * dice.uniform(0.5, 1.5);
    net.stiffness[s] = dice.oneIn(50) ? 0.0 : std::min(net.stiffness[s], 1e12);
    net.viscosity[s] = damping == 0 ? 0.0 : damping == 1 ? net.stiffness[s] * ratio : dice.decades(-9, 6);
    net.restLength[s] *= dice.uniform(1.0 - misfit, 1.0 + misfit);
    net.law[i] = static_cast<SpringLaw>(law < 4 ? law : dice.below(4));
    if (net.law[i] == SpringLaw::Linear && zero > 0.0 && dice.uniform(0, 1) < zero) net.restLength[s] = 0.0;
    if (net.law[i] == SpringLaw::Cubic) net.lawParameter[s] = std::pow(10.0, dice.below(8) - 1.0);
    if (net.law[i] == SpringLaw::Exponential) net.lawParameter[s] = dice.uniform(0.5, 15.0);
    if (net.law[i] == SpringLaw::Table) net.lawParameter[s] = 0;
    net.tensionOnly[i] = dice.oneIn(12);
  }
  if (net.springCount() > 0 && dice.oneIn(4)) { // two nodes in one place
    const Index s = dice.below(net.springCount());
    net.restPosition.col(net.ends(0, s)) = net.restPosition.col(net.ends(1, s));
  }
  for (Index s = 0; s < net.springCount(); ++s)
    if (net.law[static_cast<std::size_t>(s)] != SpringLaw::Linear)
      net.restLength[s] = std::max(net.restLength[s], 1e-6);
}

void holdSome(Dice& dice, SpringNet& net)
{
  const Index kind = dice.below(6); // most fly
  for (Index i = 0; i < net.nodeCount(); ++i) {
    if (kind == 0 && dice.oneIn(6)) net.fixed[static_cast<std::size_t>(i)] = 1;
    if (kind == 1 && dice.oneIn(3))
      addAnchor(net, i, net.restPosition.col(i), dice.decades(-6, 12),
                dice.oneIn(2) ? 0.0 : dice.decades(-9, 6));
  }
  if (dice.oneIn(3)) return;
  net.initialVelocity = Eigen::Matrix3Xd::Zero(3, net.nodeCount());
  const double speed = dice.decades(-6, 6);
  const Eigen::Vector3d common = dice.oneIn(2) ? dice.vector(speed) : Eigen::Vector3d::Zero();
  const bool isOne = dice.oneIn(4);
  for (Index i = 0; i < net.nodeCount(); ++i)
    net.initialVelocity.col(i) = common + (isOne ? Eigen::Vector3d::Zero() : dice.vector(speed));
}

VectorCurve extremeCurve(Dice& dice, double size)
{
  VectorCurve curve;
  const Index points = 1 + dice.below(4);
  curve.value.resize(3, points);
  double time = 0.0;
  for (Index i = 0; i < points; ++i) {
    curve.time.push_back(time);
    curve.value.col(i) = dice.oneIn(3) ? Eigen::Vector3d::Zero() : dice.vector(size);
    if (!dice.oneIn(3)) time += (1 + dice.below(9)) * kEvent; // else the next one in no time
  }
  return curve;
}

Loads extremeLoads(Dice& dice, const SpringNet& net)
{
  Loads loads;
  if (dice.oneIn(2)) loads.gravity = {0, 0, dice.oneIn(3) ? -98100.0 : -9.81};
  if (dice.oneIn(4)) { // wind
    NodalForce wind{{}, extremeCurve(dice, dice.decades(-9, 6))};
    for (Index i = 0; i < net.nodeCount(); ++i) wind.nodes.push_back(i);
    loads.forces.push_back(std::move(wind));
  }
  for (Index pulls = dice.below(3); pulls > 0; --pulls)
    loads.forces.push_back({{dice.below(net.nodeCount())}, extremeCurve(dice, dice.decades(-6, 9))});
  if (dice.oneIn(4)) {
    PrescribedMotion motion{{dice.below(net.nodeCount())}, extremeCurve(dice, dice.decades(-3, 2)), {}};
    if (dice.oneIn(2)) motion.release = (1 + dice.below(12)) * kEvent;
    loads.motions.push_back(std::move(motion));
  }
  return loads;
}

} // namespace

ExtremeCase extremeCase(std::uint32_t seed)
{
  Dice dice(seed);
  ExtremeCase result;
  SpringNet& net = result.net;
  const double size = dice.decades(-3, 0);
  for (Index parts = dice.oneIn(3) ? 2 + dice.below(2) : 1; parts > 0; --parts) addPart(dice, net, size);
  extremeMasses(dice, net);
  extremeSprings(dice, net);
  holdSome(dice, net);
  result.loads = extremeLoads(dice, net);
  return result;
}

} // namespace esm::test
