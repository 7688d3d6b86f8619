// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/forces/node_array.h"
#include "core/net/spring_net.h"

#include <vector>

namespace esm {

/// An elastic bedding of one node: - k (p - p0) - c v.
struct Anchor {
  Index node;
  Lanes point;                 ///< p0 [m]
  double stiffness, viscosity; ///< k [N/m], c [N s/m]
};

/// The forces that act on single nodes: weight, anchors, mass damping. They open each force pass, so that one
/// sweep over the nodes clears the forces and sets these. A net whose nodes are bedded throughout, as organs
/// are, keeps its anchors as one array per property; where few are, the list of them follows the weight.
class NodeForces {
public:
  NodeForces() = default;
  /// @param anchors   those that pull at all.
  /// @param massDrag  N, alpha m [kg/s]; empty without mass damping.
  NodeForces(const SpringNet& net, const Eigen::Vector3d& gravity, const std::vector<Anchor>& anchors,
             const std::vector<double>& massDrag);

  /// Sets force (N entries) at x, v. @return the power that the dampers turn into heat [W].
  double set(const Lanes* x, const Lanes* v, Lanes* force) const noexcept;
  /// Adds the viscous part at velocities v of what viscosity() does not hold.
  void addFewDampers(const Lanes* v, Lanes* force) const noexcept;
  /// c of every node, anchors and mass damping together [N s/m]; N entries, or empty where few or none have
  /// any.
  const std::vector<double>& viscosity() const noexcept { return m_viscosity; }
  const NodeArray& weight() const noexcept { return m_weight; } ///< m g [N]

private:
  NodeArray m_weight;
  std::vector<Anchor> m_few; ///< empty if bedded throughout
  // N entries each if bedded throughout, or else empty. Several anchors of a node act as one.
  NodeArray m_point;
  std::vector<double> m_stiffness, m_viscosity; ///< mass damping included
};

} // namespace esm
