// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/simulation.h"
#include "core/net/net_builder.h"

namespace esm {

/// Nodes 1 cm apart along x, the first one fixed, each of 10 g, springs of 100 N/m with some viscosity.
inline SpringNet chain(Index nodes, double stiffness = 100.0)
{
  SpringNet net;
  resizeNet(net, nodes, nodes - 1);
  for (Index i = 0; i < nodes; ++i) net.restPosition.col(i) = Eigen::Vector3d(0.01 * i, 0.0, 0.0);
  for (Index s = 0; s + 1 < nodes; ++s) net.ends.col(s) << s, s + 1;
  net.restLength.setConstant(0.01);
  net.stiffness.setConstant(stiffness);
  net.viscosity.setConstant(0.2);
  net.mass.setConstant(0.01);
  net.fixed[0] = 1;
  return net;
}

inline NetState atRest(const SpringNet& net)
{
  return {net.restPosition, Eigen::Matrix3Xd::Zero(3, net.nodeCount()), 0.0};
}

} // namespace esm
