// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/simulation.h"
#include "core/dynamics/system/implicit_matrix.h"
#include "core/net/node_links.h"

#include <memory>
#include <vector>

namespace esm {

/// A point that hangs on nodes: x = sum of weight_i p_i, weights >= 0 with sum 1, as many as nodes.
struct NodeCombination {
  std::vector<Index> node;
  std::vector<double> weight;
};

/// How a point of the net gives way to a force that rests on it, once all motion has died down: the 3 x 3
/// compliance C = W^T K^-1 W, K the tangent stiffness of the whole net as it is deformed now. Three solutions
/// with a sparse factor.
///
/// This, not the stiffness of a time step, is what a hand should feel between two frames: a step's compliance
/// hides inertia and viscosity in it and gets worse the faster the simulation is.
///
/// Cost per frame is bounded: the factor is renewed every few frames, as few as a share of the frame allows
/// (counted, not timed, so equal commands give equal bits); the three solutions are made each time. In nets
/// of more than kMostNodes nodes only that many around the point count, the rest held: a little too stiff, by
/// the share that the far field yields. Springs under pressure count along their axis only, so C is positive.
/// A net that nothing holds is kept by its inertia over a second.
/// @note One thread.
class StaticCompliance {
public:
  static constexpr Index kMostNodes = 3000;

  void forget() noexcept { m_parts.reset(); } ///< another net, or other parameters anywhere
  /// Other parameters around these nodes, rising.
  void adapt(std::span<const Index> nodes) noexcept;
  /// @param links  of the simulation's net.
  /// @return C [m/N]; 0 if the point's nodes are all held, or K has no factor.
  Eigen::Matrix3d at(const Simulation& simulation, const NodeCombination& point, NodeLinks& links);

private:
  struct Parts {
    std::vector<Index> nodes; ///< of the net, rising; empty: all of them
    std::vector<Index> inner; ///< of them, rising: far enough from the rim that the part may be kept
    System system;
    MotionState motion;
    ImplicitMatrix matrix;
    NodeArray vector;
    int age = 0, interval = 1; ///< frames since the factor, frames between factors
    bool hasFactor = false;
    std::size_t placeOf(Index node) const noexcept; ///< system.nodeCount() if it is not in the part
  };
  void prepare(const Simulation& simulation, const NodeCombination& point, NodeLinks& links);
  void renew(const Simulation& simulation);

  std::unique_ptr<Parts> m_parts;
};

} // namespace esm
