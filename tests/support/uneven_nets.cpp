// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "tests/support/dice.h"
#include "tests/support/extreme_nets.h"
#include "tests/support/nets.h"

#include <Eigen/Geometry>

namespace esm::test {
namespace {

constexpr double kThirdOfFrame = 1.0 / 180.0; // [s]

/// A row of 2 to 40 nodes, straight or bent, now and then closed to a ring.
void addRow(Dice& dice, SpringNet& net, const Eigen::Vector3d& place, double size)
{
  const Index first = net.nodeCount(), count = 2 + dice.below(39);
  Eigen::Vector3d at = place;
  const Eigen::Vector3d way = dice.vector(size);
  const double bend = dice.oneIn(2) ? 0.0 : size;
  for (Index i = 0; i < count; ++i, at += way + dice.vector(bend)) addNode(net, at);
  for (Index i = 1; i < count; ++i) addSpring(net, first + i - 1, first + i, 1.0);
  if (count > 2 && dice.oneIn(3)) addSpring(net, first, first + count - 1, 1.0);
}

/// A block of nodes in a grid, with springs along it and across its cells.
void addLattice(Dice& dice, SpringNet& net, const Eigen::Vector3d& place, double size)
{
  const Index first = net.nodeCount(), sides[3] = {1 + dice.below(4), 2 + dice.below(3), 1 + dice.below(3)};
  const double flat = dice.oneIn(3) ? 1e-6 : 1.0;
  for (Index x = 0; x < sides[0]; ++x)
    for (Index y = 0; y < sides[1]; ++y)
      for (Index z = 0; z < sides[2]; ++z)
        addNode(net, place + size * Eigen::Vector3d(x, y, flat * static_cast<double>(z)));
  const Index count = net.nodeCount() - first;
  for (Index i = 0; i < count; ++i)
    for (Index k = 0; k < i; ++k) {
      const Eigen::Vector3d apart =
        (net.restPosition.col(first + i) - net.restPosition.col(first + k)).cwiseAbs() / size;
      if (apart.maxCoeff() < 1.5 && (apart.sum() < 1.5 || dice.oneIn(2)))
        addSpring(net, first + i, first + k, 1.0);
    }
}

/// Nodes that all but share a place, each joined to the next two.
void addCluster(Dice& dice, SpringNet& net, const Eigen::Vector3d& place, double size)
{
  const Index first = net.nodeCount(), count = 3 + dice.below(8);
  const double apart = size * dice.decades(-14, -2);
  for (Index i = 0; i < count; ++i)
    addNode(net, place + (dice.oneIn(4) ? dice.vector(size) : dice.vector(apart)));
  for (Index i = 1; i < count; ++i)
    for (Index k = 1; k <= std::min<Index>(i, 2); ++k) addSpring(net, first + i, first + i - k, 1.0);
}

void addBody(Dice& dice, SpringNet& net, double size)
{
  const double far = dice.oneIn(4) ? size * dice.decades(2, 5) : 3.0 * size;
  const Eigen::Vector3d place =
    net.nodeCount() == 0 && !dice.oneIn(4) ? Eigen::Vector3d::Zero() : dice.vector(far);
  const Index kind = dice.below(3);
  if (kind == 0) addRow(dice, net, place, size);
  if (kind == 1) addLattice(dice, net, place, size);
  if (kind == 2) addCluster(dice, net, place, size);
}

/// Masses, springs and speeds of the nodes from `first` on, of one body.
void fillBody(Dice& dice, SpringNet& net, Index first, Index firstSpring)
{
  const double mass = dice.decades(-8, 3), stiffness = dice.decades(-3, 9), spread = dice.uniform(0.0, 3.0);
  const double damping = dice.oneIn(2) ? 0.0 : dice.decades(-5, 0);
  const Index law = dice.below(3); // all but tables
  for (Index i = first; i < net.nodeCount(); ++i)
    net.mass[i] = dice.oneIn(8) ? dice.decades(-12, 6) : mass * dice.decades(-spread, spread);
  for (Index s = firstSpring; s < net.springCount(); ++s) {
    const auto i = static_cast<std::size_t>(s);
    net.stiffness[s] = stiffness * dice.decades(-spread, spread);
    const double swing = std::sqrt(net.stiffness[s] * net.mass[net.ends(0, s)]);
    net.viscosity[s] = damping * swing;
    net.restLength[s] *= dice.oneIn(3) ? dice.uniform(0.3, 1.7) : 1.0;
    net.law[i] = static_cast<SpringLaw>(law);
    if (net.law[i] == SpringLaw::Cubic) net.lawParameter[s] = dice.decades(-1, 3);
    if (net.law[i] == SpringLaw::Exponential) net.lawParameter[s] = dice.uniform(0.5, 8.0);
    if (net.law[i] != SpringLaw::Linear) net.restLength[s] = std::max(net.restLength[s], 1e-9);
  }
}

/// Flight, a turn about an axis, and some noise.
void throwBody(Dice& dice, SpringNet& net, Index first)
{
  const Eigen::Vector3d flight = dice.oneIn(2) ? Eigen::Vector3d::Zero() : dice.vector(dice.decades(-6, 3));
  const Eigen::Vector3d spin = dice.oneIn(2) ? Eigen::Vector3d::Zero() : dice.vector(dice.decades(-2, 4));
  const double noise = dice.oneIn(2) ? 0.0 : dice.decades(-8, 2);
  const Eigen::Vector3d middle = net.restPosition.rightCols(net.nodeCount() - first).rowwise().mean();
  for (Index i = first; i < net.nodeCount(); ++i) {
    const Eigen::Vector3d arm = net.restPosition.col(i) - middle;
    net.initialVelocity.col(i) = flight + spin.cross(arm) + dice.vector(noise);
  }
}

VectorCurve curveOf(Dice& dice, double size)
{
  VectorCurve curve;
  const Index points = 1 + dice.below(5);
  curve.value.resize(3, points);
  Index third = 0; // whole ones: a release at a corner is at the same time to the bit
  for (Index i = 0; i < points; ++i, third += dice.below(4)) {
    curve.time.push_back(kThirdOfFrame * third);
    curve.value.col(i) = dice.vector(size);
  }
  return curve;
}

} // namespace

ExtremeCase unevenCase(std::uint32_t seed)
{
  Dice dice(seed);
  ExtremeCase result;
  SpringNet& net = result.net;
  const double size = dice.decades(-4, 1);
  std::vector<Index> firsts;
  net.initialVelocity.resize(3, 0);
  for (Index bodies = 1 + dice.below(3); bodies > 0; --bodies) {
    const Index first = net.nodeCount(), firstSpring = net.springCount();
    addBody(dice, net, size);
    fillBody(dice, net, first, firstSpring);
    net.initialVelocity.conservativeResize(3, net.nodeCount());
    throwBody(dice, net, first);
    firsts.push_back(first);
  }
  for (std::size_t b = 1; b < firsts.size(); ++b) // one spring or two between bodies, of any stiffness
    for (Index k = dice.below(3); k > 0; --k)
      addSpring(net, dice.below(firsts[b]), firsts[b] + dice.below(net.nodeCount() - firsts[b]),
                dice.decades(-6, 12), dice.oneIn(2) ? 0.0 : dice.decades(-6, 4));
  if (dice.oneIn(4)) net.fixed[static_cast<std::size_t>(dice.below(net.nodeCount()))] = 1;
  if (dice.oneIn(2)) result.loads.gravity = dice.vector(dice.decades(-3, 4));
  for (Index pairs = dice.below(3); pairs > 0; --pairs) { // pulls that cancel out, or do not quite
    NodalForce pull{{dice.below(net.nodeCount())}, curveOf(dice, dice.decades(-6, 6))}, back = pull;
    back.nodes = {dice.below(net.nodeCount())};
    back.force.value *= dice.oneIn(2) ? -1.0 : -1.0 + dice.decades(-12, -1);
    result.loads.forces.push_back(std::move(pull));
    result.loads.forces.push_back(std::move(back));
  }
  if (dice.oneIn(6)) {
    PrescribedMotion motion{{dice.below(net.nodeCount())}, curveOf(dice, size), {}};
    if (dice.oneIn(2)) motion.release = (1 + dice.below(9)) * kThirdOfFrame;
    result.loads.motions.push_back(std::move(motion));
  }
  return result;
}

} // namespace esm::test
