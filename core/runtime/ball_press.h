// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/simulation.h"
#include "core/runtime/node_hold.h"
#include "core/runtime/static_compliance.h"

#include <Eigen/Core>

#include <array>
#include <span>
#include <vector>

namespace esm {

/// Where a ball presses: its contact point on a triangle, and from there the way to where the hand would have it.
struct BallContact {
  std::array<Index, 3> corner{kNoIndex, kNoIndex, kNoIndex};
  Eigen::Vector3d weight = Eigen::Vector3d::Zero(); ///< of the corners
  Eigen::Vector3d place = Eigen::Vector3d::Zero();  ///< [m]
  Eigen::Vector3d normal = Eigen::Vector3d::Zero(); ///< unit, towards the ball
  Eigen::Vector3d pull = Eigen::Vector3d::Zero();   ///< [m]
  double radius = 0.0;                              ///< [m]
};

/// The push of a ball on all that it covers.
///
///         ( h )      d    depth of the contact point below the ball's lowest
///     _    \_/    _  d_i  of node i below the ball's surface, along the normal
///      \_ _c_ _ _/
///
/// Each covered node has a spring (see holdOfNodes()) that pushes it by d_i. The corners of the contact's triangle
/// are pushed as one point by d at least, each with its weight of a firmer spring, so that a mesh coarser than the
/// ball is pressed, too. Drag along the surface is shared as the push is. If all is more than the limit, the ball is drawn back until it is not.
class BallPress {
public:
  explicit BallPress(const SpringNet& net) { adapt(net); }
  void adapt(const SpringNet& net);

  /// @param covered  nodes that the ball may touch. @param holds  it keeps them, too, where it is above them.
  void press(const Eigen::Matrix3Xd& position, const BallContact& contact, std::span<const Index> covered,
             bool holds, double maxForce);

  /// @param velocity  of the hand: the nodes are damped against it along the normal only. Valid until the next
  /// call.
  std::span<const ToolSpring> springs(const NetState& state, const Eigen::Vector3d& velocity);
  Eigen::Vector3d forceOnHand(const NetState& state, const Eigen::Vector3d& velocity) const; ///< of these [N]

  /// How all springs together answer motions of the hand: stiffness below the limit, damping, and the point that
  /// they press on. That is where the hand would have it, but for apart().
  double stiffness() const noexcept { return m_stiffness; } ///< [N/m]
  double viscosity() const noexcept { return m_viscosity; } ///< [N s/m]
  const Eigen::Vector3d& apart() const noexcept { return m_apart; }
  const NodeCombination& point() const noexcept { return m_point; }
  /// Pressed ones, the triangle's corners among them.
  std::span<const Index> nodes() const noexcept { return m_point.node; }

private:
  struct Pressed {
    Index node;
    double rise; ///< over the contact point, less what the ball's surface rises there [m]
    double stiffness, viscosity;
  };
  void collect(const Eigen::Matrix3Xd& position, std::span<const Index> covered);
  void drawBack(double wanted);
  double way(const Pressed& node, double depth) const noexcept; ///< along the normal [m]
  double push(double depth) const noexcept;                     ///< of all, along the normal [N]
  ToolSpring spring(const Pressed& node, const NetState& state, const Eigen::Vector3d& velocity) const;

  std::vector<NodeHold> m_hold, m_firmHold; ///< of covered nodes, of the corners as one point
  std::vector<Pressed> m_pressed;           ///< by node
  BallContact m_contact;
  double m_depth = 0.0;    ///< of the contact point [m]
  double m_drawn = 0.0;    ///< the same, of the ball drawn back
  double m_softness = 1.0; ///< see LimitedPull
  double m_shrink = 1.0;   ///< of what holds without pressing, for the limit
  bool m_holds = false;
  double m_stiffness = 0.0, m_viscosity = 0.0;
  Eigen::Vector3d m_apart = Eigen::Vector3d::Zero(); ///< mean [m]
  NodeCombination m_point;
  std::vector<ToolSpring> m_springs;
};

} // namespace esm
