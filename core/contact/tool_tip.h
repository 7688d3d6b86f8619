// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/grouped.h"
#include "core/base/hand_over.h"
#include "core/contact/press_area.h"
#include "core/contact/static_compliance.h"
#include "core/dynamics/net_state.h"
#include "core/geometry/deforming_surface.h"
#include "core/net/node_links.h"

#include <span>
#include <vector>

namespace esm {

/// A ball on the end of an instrument that presses on the surface of the net.
///
///        proxy (    )  touches from outside, is what the screen shows
///     ______\__ c  _/______  surface; c the point of contact on it, n the normal
///            \  |  /
///             ( h )          hand: where the device is, may be deep inside
///
/// A god-object (Zilles and Salisbury 1995): the proxy stays outside whatever the hand does, a spring pulls
/// the tissue towards where the hand would have it, h - r n, and the hand back by the same force.
///
/// It pulls not one point but the area around it (see PressAreaFinder), by its mean: a force on one point is a
/// needle, deeper the finer the mesh. The mean lies under the contact point on a curved organ at rest, by as much
/// as it did then it counts as higher along the normal. So the force begins where the ball meets the surface, and
/// presses alike on every mesh; in the middle of the area the tissue may give way by a third more than the mean.
///
/// The normal is the area's, too. The contact point sticks while the drag is within the friction cone and slides along the surface beyond it
/// (Harwin and Melder 2002). Contact begins where the hand's way first meets the surface, so thin walls are
/// not jumped through, and ends when the hand comes out again.
/// @note One thread.
class ToolTip {
public:
  static constexpr double kFriction = 0.1;     ///< of wet tissue [1]
  static constexpr double kFollowTime = 0.005; ///< that tissue takes to come after a hand [s]
  static constexpr double kReach = 0.03;       ///< so near the surface a contact is expected [m]

  /// @param radius [m] >= 0; @param maxForce on the hand [N].
  ToolTip(const SpringNet& net, double radius, double maxForce);

  void adapt(const SpringNet& net); ///< other parameters, anywhere
  /// Around these nodes.
  void adapt(const SpringNet& net, std::span<const Index> nodes, NodeLinks& links);
  void setMaxForce(double newtons) noexcept;
  void moveTo(const Eigen::Vector3d& hand, const Eigen::Vector3d& velocity); ///< non-finite: stays
  void letGo() noexcept; ///< of the surface; the hand counts as outside where it is next

  /// Finds, follows or ends the contact on the surface as it is now. A hand that has come out lets go only
  /// after kFollowTime of simulated time: tissue let go of at once would snap back into the ball before the
  /// next frame holds it; so it follows the hand, without force on it, until it stays behind by itself.
  void update(const NetState& state);
  bool isLed() const noexcept { return m_hasLast; } ///< by the last update(), to where hand() is
  bool touches() const noexcept { return m_touches && !m_wasOut; }
  bool pulls() const noexcept { return m_touches; } ///< touches, or tissue still follows a hand that came out
  bool isNear() const noexcept { return m_touches || m_near.triangle != kNoIndex; }
  /// From the ball to the surface, kReach at most; 0 while it pulls [m].
  double gap() const noexcept;
  /// The area that is pressed, as one point: around the contact or the point next to the ball. @pre isNear()
  const NodeCombination& point() const noexcept { return m_area.nodes; }

  const Eigen::Vector3d& hand() const noexcept { return m_hand; }
  double radius() const noexcept { return m_radius; }
  Eigen::Vector3d proxy() const noexcept; ///< centre of the ball as shown [m]

  /// What pulls the surface in the coming frame: a spring on each node of the area, all by the same way, each
  /// with its share. Valid until the next call. @pre pulls()
  std::span<const ToolSpring> springs(const NetState& state);
  Eigen::Vector3d forceOnHand(const NetState& state) const; ///< [N]; zero without contact
  /// @param compliance  of the net at point() [m/N]. `sequence` is the caller's.
  ContactModel contactModel(const NetState& state, const Eigen::Matrix3d& compliance) const;

private:
  ToolTip(const SpringNet& net, const EdgeTable& edges, double radius, double maxForce);
  Eigen::Vector3d faceNormal(Index triangle) const;
  Eigen::Vector3d nodeNormal(Index node) const;
  Eigen::Vector3d normalAt(const SurfacePoint& point) const;
  Eigen::Vector3d restNormalAt(const SurfacePoint& point) const;
  void look(const SurfacePoint& point, double side);
  SurfacePoint slideTo(const Eigen::Vector3d& goal, const SurfacePoint& from) const;
  void search();
  void begin(const SurfacePoint& point, double side);
  void follow();
  void hold(double time);
  bool isOut();
  void place();
  bool isUnhooked() const;
  /// Of what the hand leads from the contact point: how much less or more the tissue has given way there [m].
  Eigen::Vector3d aside() const { return m_led - m_place; }
  Eigen::Vector3d pull() const; ///< from what is pressed to where the hand would have it [m]
  double stiffness() const noexcept;
  double viscosity(double stiffness) const noexcept;
  Eigen::Vector3d surfaceVelocity(const NetState& state) const;

  DeformingSurface m_surface;
  Eigen::Matrix3Xd m_rest;       ///< positions at t = 0 [m]
  Eigen::Matrix3Xd m_restNormal; ///< of the nodes, then
  bool m_isClosed = false;
  Grouped<Index> m_trianglesOf;      ///< by nodes
  std::vector<double> m_own, m_mass; ///< by nodes: stiffness around [N/m], [kg]
  PressAreaFinder m_finder;

  double m_radius, m_maxForce;
  Eigen::Vector3d m_hand = Eigen::Vector3d::Zero(), m_velocity = Eigen::Vector3d::Zero();
  Eigen::Vector3d m_last = Eigen::Vector3d::Zero(); ///< hand at the last update
  bool m_hasLast = false, m_touches = false, m_wasOut = false;
  double m_outSince = 0.0; ///< simulated, if m_wasOut [s]
  double m_side = 1.0;     ///< -1: touched from behind, on open surfaces
  double m_lastSide = 0.0; ///< of the surface that the hand was on, while it was near; 0: not known
  SurfacePoint m_contact, m_near;
  Eigen::Vector3d m_normal = Eigen::Vector3d::Zero(); ///< at m_contact or m_near, towards the tip
  Eigen::Vector3d m_place = Eigen::Vector3d::Zero();  ///< of it [m]
  SurfacePoint m_areaAt;                              ///< where m_area lies
  PressedArea m_area;
  Eigen::Vector3d m_led = Eigen::Vector3d::Zero(); ///< of the area, what the hand leads [m]
  double m_lift = 0.0; ///< of the proxy over m_place; less than the radius in a fold that is narrower [m]
  std::vector<ToolSpring> m_springs;
};

} // namespace esm
