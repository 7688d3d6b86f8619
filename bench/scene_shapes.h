// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/forces/loads.h"
#include "core/net/spring_net.h"

#include <random>
#include <utility>
#include <vector>

namespace esm::bench {

// What scenes are put together from.

using Edges = std::vector<std::pair<Index, Index>>;

/// To a grid of 2^-40 m: the C library's sine has other last bits on CPUs with FMA, and golden hashes see
/// them.
Eigen::Vector3d onGrid(const Eigen::Vector3d& x);
double uniform(std::mt19937& random, double low, double high);
double powerOfTen(double exponent);

/// Springs along the edges, slack; all else at its default.
SpringNet netOf(const std::vector<Eigen::Vector3d>& positions, const Edges& edges);
/// A soft bed: every node held to its rest position.
void anchorAll(SpringNet& net, double stiffness, double viscosity);
VectorCurve curve(std::vector<double> time, std::vector<Eigen::Vector3d> values);
/// Rings of 20 staggered nodes along 10 cm; the first and the last ring are fixed.
SpringNet tubeNet(Index rings);
/// 10 f^2 + 2 points on the unit sphere, 30 f^2 edges, five or six at a node.
void geodesicSphere(Index frequency, std::vector<Eigen::Vector3d>& positions, Edges& edges);

} // namespace esm::bench
