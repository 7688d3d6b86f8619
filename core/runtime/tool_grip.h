// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/simulation.h"
#include "core/runtime/hand_over.h"

#include <Eigen/Core>

namespace esm {

/// The hold of a hand on one node: a spring-damper between the two.
///
///     node  o--/\/\/--o  hand          on the hand:  F = k (p - h) + c (v - vh)
///           p, v      h, vh
///
/// k is a few times what the net itself opposes at that node (so the node follows the hand rather than
/// lagging behind), c damps the node's own mass on k. The pull is limited, see LimitedPull; the spring is
/// never stiffer than k.
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

  /// How the force on the hand answers motions of the hand: the tool spring in series with what the net
  /// opposes in the long run, and the tool's damping by the share of the motion that the spring takes.
  /// @param compliance  of the net at the node [m/N], see StaticCompliance. `sequence` is the caller's.
  ContactModel contactModel(const NetState& state, const Eigen::Matrix3d& compliance) const;

private:
  Index m_node;
  Eigen::Vector3d m_target;
  Eigen::Vector3d m_targetVelocity = Eigen::Vector3d::Zero();
  double m_maxForce;
  double m_stiffness = 0.0, m_viscosity = 0.0;
};

/// Stiffness of a tool's spring with a compliant point behind it: T (I + C T)^-1, symmetric and positive
/// semidefinite for such T [N/m] and C [m/N].
Eigen::Matrix3d inSeries(const Eigen::Matrix3d& tool, const Eigen::Matrix3d& compliance);

/// What the net's springs and anchors at a node oppose at most [N/m].
double stiffnessAround(const SpringNet& net, Index node);

/// How stiff a tool's spring is on that [N/m], and its damping with a mass behind it [N s/m].
double toolStiffness(double own);
double toolViscosity(double stiffness, double mass);

} // namespace esm
