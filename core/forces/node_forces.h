// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/forces/net_division.h"
#include "core/forces/node_array.h"
#include "core/net/spring_net.h"

#include <span>
#include <vector>

namespace esm {

/// An elastic bedding of one node: - k (p - p0) - c v.
struct Anchor {
  Lanes point;                 ///< p0 [m]
  double stiffness, viscosity; ///< k [N/m], c [N s/m]
  Index node;
  Index place = kNoIndex; ///< among the net's
};

/// The forces that act on single nodes: weight, anchors, mass damping. They open each force pass, so that one
/// sweep over the nodes clears the forces and sets these. A net whose nodes are bedded throughout, as organs
/// are, keeps its anchors as one array per property; where few are, the list of them follows the weight.
class NodeForces {
public:
  NodeForces() = default;
  /// @param anchors   those that pull at all; by rising nodes if there are several ranges.
  /// @param massDrag  N, alpha m [kg/s]; empty without mass damping.
  /// @param ranges    of the nodes, for set() and addFewDampers().
  NodeForces(const SpringNet& net, const Eigen::Vector3d& gravity, const std::vector<Anchor>& anchors,
             const std::vector<double>& massDrag, const NodeRanges& ranges);

  void setMass(Index node, double mass) noexcept { m_mass[static_cast<std::size_t>(node)] = mass; }
  /// Other numbers for the anchors of a node, and for its mass damping: as many pull at all as before.
  /// @param anchors   those given to the constructor, with the new numbers.
  /// @param own       places in them, of the node's.
  void setBed(Index node, double massDrag, const std::vector<Anchor>& anchors, std::span<const Index> own);

  const NodeRanges& ranges() const noexcept { return m_ranges; }
  /// Sets the forces of the nodes of a range at x, v; the arrays are those of all nodes.
  /// @return the power that the dampers turn into heat [W].
  double set(std::size_t range, const Lanes* x, const Lanes* v, Lanes* force) const noexcept;
  /// Adds the viscous part at velocities v of what viscosity() does not hold, for the nodes of a range.
  void addFewDampers(std::size_t range, const Lanes* v, Lanes* force) const noexcept;
  /// c of every node, anchors and mass damping together [N s/m]; N entries, or empty where few or none have
  /// any.
  const std::vector<double>& viscosity() const noexcept { return m_viscosity; }
  std::size_t nodeCount() const noexcept { return m_mass.size(); }
  Lanes weight(std::size_t node) const noexcept { return m_gravity * m_mass[node]; } ///< m g [N]

private:
  /// Anchors of a range in m_few.
  std::span<const Anchor> few(std::size_t range) const noexcept
  {
    return {m_few.data() + m_firstFew[range], m_few.data() + m_firstFew[range + 1]};
  }

  void addToBed(const Anchor& anchor) noexcept;

  NodeRanges m_ranges;
  std::vector<double> m_mass; ///< [kg]
  Lanes m_gravity = {0, 0, 0, 0};
  std::vector<Anchor> m_few; ///< empty if bedded throughout
  std::vector<std::size_t> m_firstFew = {0, 0};
  // N entries each if bedded throughout, or else empty. Several anchors of a node act as one.
  NodeArray m_point;
  std::vector<double> m_stiffness, m_viscosity; ///< mass damping included
};

} // namespace esm
