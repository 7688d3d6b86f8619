// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/forces/loads.h"
#include "core/net/spring_net.h"

#include <cstdint>

namespace esm::test {

/// A block of nodes on a cubic lattice, `spacing` apart [m], every node joined to its 26 neighbours by linear
/// springs of k = modulus spacing^2 / L, the layer z = 0 fixed. Node (i, j, k) has the index
/// i + x (j + y k). With its surface, normals outwards.
struct BlockShape {
  Index x = 5, y = 4, z = 4;
  double spacing = 0.01; ///< [m]
  double modulus = 2e4;  ///< [Pa]
};
SpringNet block(const BlockShape& shape);

/// The same with stiffnesses within a factor of two of each other, rest lengths within 2 %, and the law with
/// parameters of a sign of their own where it allows for both.
SpringNet unevenBlock(const BlockShape& shape, SpringLaw law, std::uint32_t seed);

/// One force [N] shared by the nodes.
NodalForce sharedForce(std::vector<Index> nodes, const Eigen::Vector3d& force);
/// The free nodes within `radius` of a point.
std::vector<Index> nodesNear(const SpringNet& net, const Eigen::Vector3d& point, double radius);

} // namespace esm::test
