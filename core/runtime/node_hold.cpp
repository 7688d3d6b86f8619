// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/runtime/node_hold.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

constexpr double kRate = 1.25; ///< of the fastest node's, with the hand's spring [1]
/// Of the hand's spring to the node's own: stiffer leads hardly better [1].
constexpr double kMostRatio = 3.0;
constexpr double kDampingRatio = 0.5; ///< of the node's mass on the hand's spring [1]

} // namespace

std::vector<NodeHold> holdOfNodes(const SpringNet& net)
{
  std::vector<NodeHold> own(static_cast<std::size_t>(net.nodeCount()));
  const auto add = [&](Index node, double stiffness, double viscosity) {
    own[static_cast<std::size_t>(node)].stiffness += stiffness;
    own[static_cast<std::size_t>(node)].viscosity += viscosity;
  };
  for (Index s = 0; s < net.springCount(); ++s)
    for (int end = 0; end < 2; ++end) add(net.ends(end, s), net.stiffness[s], net.viscosity[s]);
  for (Index a = 0; a < net.anchors.count(); ++a)
    add(net.anchors.node[static_cast<std::size_t>(a)], net.anchors.stiffness[a], net.anchors.viscosity[a]);
  double fastest = 0.0, decay = 0.0; // [1/s^2], [1/s]
  for (std::size_t i = 0; i < own.size(); ++i) {
    if (net.fixed[i]) continue;
    fastest = std::max(fastest, own[i].stiffness / net.mass[static_cast<Index>(i)]);
    decay = std::max(decay, own[i].viscosity / net.mass[static_cast<Index>(i)]);
  }
  decay = std::max(kRate * decay, std::sqrt(fastest)); // dampers slower than the swing cost nothing
  std::vector<NodeHold> hold(own.size());
  for (std::size_t i = 0; i < own.size(); ++i) {
    const double stiffness = own[i].stiffness, mass = net.mass[static_cast<Index>(i)];
    if (!(stiffness > 0.0)) continue;
    // As damped as the node's own springs are: methods that know dampers slow the fast modes by them.
    const double relaxation = own[i].viscosity / stiffness, slack = decay * mass - own[i].viscosity;
    double room = kRate * kRate * fastest * mass - stiffness;
    if (relaxation > 0.0) room = std::min(room, slack / relaxation);
    hold[i].stiffness = std::clamp(room, 0.0, kMostRatio * stiffness);
    const double least = 2.0 * kDampingRatio * std::sqrt(hold[i].stiffness * mass);
    hold[i].viscosity = std::max(relaxation * hold[i].stiffness, std::clamp(slack, 0.0, least));
  }
  return hold;
}

} // namespace esm
