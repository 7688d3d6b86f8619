// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/hand_over.h"
#include "core/contact/limited_pull.h"
#include "core/contact/node_hold.h"
#include "core/contact/node_patch.h"
#include "core/contact/static_compliance.h"
#include "core/dynamics/net_state.h"
#include "core/forces/loads.h"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace esm {

/// The hold of a hand on a patch of nodes, as by a finger or a jaw: a spring-damper from each of them to its
/// place on the hand, which is where it was when the hand closed.
///
///     node i  o--/\/\/--o  h + o_i       on the hand:  F = sum k_i (p_i - h - o_i) + c_i (v_i - vh)
///             p_i, v_i
///
/// The hand is a pad, the same on every mesh: its stiffness for an area falls smoothly to nothing (gripShare),
///
///     k_i = share_i min(8 S a_i / radius^2, 2 S_i) ,
///
/// S_i the sum of stiffness that holds node i in the net, S its mean over the patch, a_i the node's cell. All
/// together they are far stiffer than the tissue is against them: the middle follows the hand nearly as if it were
/// prescribed, and explicit steps get shorter by less than a third. The pull, the sum, is limited (see
/// LimitedPull), and so is what the patch bears to keep its shape.
class ToolGrip {
public:
  /// Takes hold of what lies around the node, as it is now: by half at `radius` [m] from it, 0: the node alone.
  /// @pre node in range. @param target  for the node [m].
  ToolGrip(const SpringNet& net, const Eigen::Matrix3Xd& position, Index node, double radius,
           const Eigen::Vector3d& target, double maxForce);

  /// Takes the stiffness anew after the net's parameters have changed: anywhere, or around some nodes.
  void adapt(const SpringNet& net);
  void adapt(const SpringNet& net, std::span<const Index> nodes, NodeLinks& links);
  void moveTo(const Eigen::Vector3d& target, const Eigen::Vector3d& velocity); ///< at once; non-finite: stays
  /// Evenly, over the coming `time` [s] > 0: a hand that leaped from frame to frame would make waves, which cost
  /// steps and are no part of its motion.
  void leadTo(const Eigen::Vector3d& target, double time);
  void endLead(double time); ///< after as much of it [s]

  Index node() const noexcept { return m_node; }
  const Eigen::Vector3d& target() const noexcept { return m_target; }
  double stiffness() const noexcept { return m_stiffness; } ///< of all springs, at its largest [N/m]
  /// What the hand holds: the nodes, `node` first, weighted by their springs.
  const NodeCombination& point() const noexcept { return m_point; }

  /// The springs for the coming frame: with the limit's force at the state's distance, if that is far. Valid
  /// until the next call.
  std::span<const ToolSpring> springs(const NetState& state);
  /// Force on the hand [N], norm <= maxForce.
  Eigen::Vector3d forceOnHand(const NetState& state) const;

  /// How the force on the hand answers motions of the hand: the tool's springs in series with what the net
  /// opposes in the long run, and the tool's damping by the share of the motion that the springs take.
  /// @param compliance  of the net at point() [m/N], see StaticCompliance. `sequence` is the caller's.
  ContactModel contactModel(const NetState& state, const Eigen::Matrix3d& compliance) const;

private:
  void takeHold(const SpringNet& net);
  struct Held {
    Index node = kNoIndex;
    double share = 0.0;                               ///< of a whole hold, see gripShare() [1]
    double area = 0.0;                                ///< of its cell [m^2]
    Eigen::Vector3d offset = Eigen::Vector3d::Zero(); ///< from the hand's target [m]
    double stiffness = 0.0, viscosity = 0.0;          ///< [N/m], [N s/m]
  };
  struct Lead {
    Eigen::Vector3d apart; ///< of the patch from the hand, in the mean of the springs [m]
    LimitedPull pull;
    double bond = 1.0; ///< of what pulls the nodes to their places in the patch, that is allowed
    bool isLimited() const noexcept { return pull.isLimited || bond < 1.0; }
  };
  Eigen::Vector3d apart(const Held& held, const NetState& state) const;
  Lead lead(const NetState& state) const;
  ToolSpring spring(const Held& held, const Lead& lead, const NetState& state) const;
  bool pullsAlike(const Lead& led, const NetState& state) const;

  Index m_node;
  Eigen::Vector3d m_target;
  Eigen::Vector3d m_targetVelocity = Eigen::Vector3d::Zero();
  Eigen::Vector3d m_goal = Eigen::Vector3d::Zero(); ///< of the lead [m]
  double m_leadTime = 0.0;                          ///< [s]; 0: not led
  double m_radius, m_maxForce;                      ///< [m], [N]
  double m_stiffness = 0.0, m_viscosity = 0.0;      ///< sums
  NodeHolds m_holds;
  std::vector<Held> m_held;
  NodeCombination m_point;
  std::vector<ToolSpring> m_springs;
};

/// Stiffness of a tool's spring with a compliant point behind it: T (I + C T)^-1, symmetric and positive
/// semidefinite for such T [N/m] and C [m/N].
Eigen::Matrix3d inSeries(const Eigen::Matrix3d& tool, const Eigen::Matrix3d& compliance);

} // namespace esm
