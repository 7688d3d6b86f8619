// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/net/spring_net.h"

#include <cstdint>

namespace esm::test {

/// Small nets for physics tests. All have nodes of 1 kg, free, linear springs at rest length, without
/// viscosity; the test changes what it is about.

/// n nodes on the x axis from 0, `spacing` [m] apart, joined in a row by springs of stiffness k [N/m].
SpringNet chain(Index nodes, double spacing = 1.0, double k = 1.0);

/// A net of random positions in a cube of 1 m, n nodes, each joined to a few others; stiffness, viscosity,
/// rest length, mass and law parameter random within a decade. The seed fixes everything.
SpringNet randomNet(std::uint32_t seed, Index nodes, SpringLaw law = SpringLaw::Linear);

/// The same, each spring as long as it rests.
SpringNet relaxed(std::uint32_t seed, Index nodes = 40);

/// A square sheet of n x n nodes in the plane z = 0, with edges along x, y and one diagonal.
SpringNet sheet(Index n, double spacing, double k);

/// Appends a node and returns its index; appends a spring of rest length = distance.
Index addNode(SpringNet& net, const Eigen::Vector3d& position);
Index addSpring(SpringNet& net, Index a, Index b, double k, double c = 0.0);
void addAnchor(SpringNet& net, Index node, const Eigen::Vector3d& point, double k, double c = 0.0);

} // namespace esm::test
