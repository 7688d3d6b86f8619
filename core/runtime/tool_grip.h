// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/simulation.h"
#include "core/forces/spring_law.h"
#include "core/runtime/hand_over.h"

#include <Eigen/Core>

#include <vector>

namespace esm {

/// The hold of a hand on one node: a spring-damper between the two.
///
///     node  o--/\/\/--o  hand          on the hand:  F = k (p - h) + c (v - vh)
///           p, v      h, vh
///
/// k is a few times what the net itself opposes at that node (so the node follows the hand rather than
/// lagging behind), c damps the node's own mass on k. The pull is limited by moving the end of the spring
/// closer, to where it pulls with maxForce. From twice that distance on the spring also softens, by octaves:
/// so the force changes little while the node moves within a frame, and k changes rarely, which spares the
/// solver new preparations. The spring is never stiffer than k.
class ToolGrip {
public:
  /// @pre node in range.
  ToolGrip(const SpringNet& net, Index node, const Eigen::Vector3d& target, double maxForce);

  /// Takes the stiffness anew after the net's parameters have changed.
  void adapt(const SpringNet& net);
  void moveTo(const Eigen::Vector3d& target, const Eigen::Vector3d& velocity); ///< non-finite: stays

  Index node() const noexcept { return m_node; }
  const Eigen::Vector3d& target() const noexcept { return m_target; }
  double stiffness() const noexcept { return m_stiffness; } ///< at its largest [N/m]

  /// The spring for the coming frame: with the limit's force at the state's distance, if that is far.
  ToolSpring spring(const NetState& state) const;
  /// Force on the hand [N], norm <= maxForce.
  Eigen::Vector3d forceOnHand(const NetState& state) const;

  /// How the force on the hand answers small motions of the hand within the next frame: the tool spring in
  /// series with what the springs and anchors at the node oppose while its neighbours stay where they are.
  /// That is stiffer than the whole net is in the long run (condensing the net would give that); the next
  /// frame's force brings the difference. A spring under compression counts along its axis only, so the
  /// result is positive semidefinite. `sequence` is the caller's.
  ContactModel contactModel(const SpringNet& net, const NetState& state) const;

private:
  Eigen::Matrix3d nodeStiffness(const SpringNet& net, const Eigen::Matrix3Xd& position) const;
  bool isFar(const Eigen::Vector3d& nodePosition) const; ///< the limit holds

  Index m_node;
  Eigen::Vector3d m_target;
  Eigen::Vector3d m_targetVelocity = Eigen::Vector3d::Zero();
  double m_maxForce;
  double m_stiffness = 0.0, m_viscosity = 0.0;
  bool m_held = false;          ///< the node is fixed: nothing gives but the tool spring
  SpringBatch m_springs;        ///< at the node, of any law
  std::vector<Index> m_anchors; ///< at the node
};

} // namespace esm
