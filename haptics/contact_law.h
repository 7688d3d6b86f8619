// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/hand_over.h"
#include "haptics/haptic_device.h"

#include <Eigen/Core>

#include <cstdint>

namespace esm {

/// The force that the tissue exerts on the hand, each tick, from models that come at the simulation's pace.
///
/// A model is a plane, F = c - K x - C v, that a touched surface cuts off where it would pull (see
/// ContactModel). The newest one counts at once; what it would make the force jump by is taken back within a
/// quarter of the time between models. K and C are first capped to what the device can render without
/// oscillating: 2 (b + B) / (T + 2 tau) is where a held spring begins to gain energy (b own damping, B added
/// damping, T tick, tau delay). T is the mean tick plus twice its deviation, tau the age of positions, both
/// as measured; half of that stiffness leaves room for what was not.
///
/// Where the tissue's parameters or the scale have changed, the jump is taken back over 100 ms instead: an
/// edit under the hand is felt as tissue that hardens.
///
/// Presence fades in over 50 ms when a contact begins and out when it ends. What comes after an ended contact,
/// or from another scene, is taken once the old one has faded out.
///
/// An answer that takes longer than 100 ms is late. The last plane then holds, F = c - K x - C v at the hand
/// as it is now: K is positive semidefinite and C takes, so a plane that stays gives nothing that the hand
/// did not put in. It holds until one of these, then fades out once, and the scene counts as silent:
///
///     1 s without an answer               a dead simulation is not a wall: no force after 1.05 s
///     the hand 10 mm from where the plane was made for, pressing on it
///                                         farther off another tissue may be, or the same one stiffer
///     endHold()                           the energy guard saw what a plane cannot give
///     no spring in it (100 ms)            a bare force says nothing about how the tissue gives way
///
/// A silent scene is heard again after five answers in a row that are not late; another scene at once.
/// @note Threads: servo only. Never allocates or throws.
class ContactLaw {
public:
  static constexpr double kLateAfter = 0.1;   ///< without an answer [s]
  static constexpr double kLongestHold = 1.0; ///< the same [s]
  static constexpr double kTrustedWay = 0.01; ///< of the hand, with a plane that is late [m]
  static constexpr int kTimelyAnswers = 5;    ///< in a row that end a silence
  static constexpr double kFadeTime = 0.05;   ///< [s]
  static constexpr double kEditTime = 0.1;    ///< [s]
  static constexpr double kStabilityShare = 0.5;

  explicit ContactLaw(const DeviceProfile& profile) noexcept;

  /// Takes a model if its sequence is new.
  /// @param scale  force felt over force of the tissue [1]; stiffness is capped after it.
  /// @return false for one with a NaN, an infinity or a number beyond 1e9; it is not taken.
  bool take(const ContactModel& model, double now, double scale = 1.0) noexcept;

  /// Advances fading and blending by `dt` [s] and evaluates. Not limited: that is ForceLimiter's.
  /// @param age  of the position [s].
  Eigen::Vector3d force(double now, double dt, const Eigen::Vector3d& position,
                        const Eigen::Vector3d& velocity, double age = 0.0) noexcept;

  void forget() noexcept; ///< ends the contact at once; a model that was already seen does not come back
  void endHold() noexcept { m_stale = m_stale || m_holds; } ///< what is held is not passive

  bool present() const noexcept { return m_active && !m_stale && !m_leaves; }
  bool holds() const noexcept { return m_holds; } ///< by a plane that is late, as of the last force()
  bool late() const noexcept { return m_holds || m_timely < kTimelyAnswers; } ///< now, or of late
  /// The scene that was there has faded out for lateness, or is about to.
  bool stale() const noexcept { return m_stale; }
  /// Number of the scene whose tissue is felt or could be at any time; 0: none, or it is silent or fades out.
  std::uint64_t scene() const noexcept { return m_stale || m_sceneLeaves ? 0 : m_scene; }
  bool begins() const noexcept { return m_begins; } ///< with the last force() the contact came out of nothing
  double size() const noexcept { return m_size; }   ///< of the last force, without presence [N]
  double presence() const noexcept { return m_presence; } ///< 0 ... 1
  /// What the springs of the last force() hold, the energy that they may give back, without presence [J].
  double stored() const noexcept { return m_stored; }
  /// Largest stiffness [N/m] that goes with an added damping [N s/m].
  double stiffnessCap(double damping) const noexcept;

private:
  struct Plane {
    Eigen::Vector3d constant = Eigen::Vector3d::Zero();   ///< [N]
    Eigen::Matrix3d stiffness = Eigen::Matrix3d::Zero();  ///< [N/m]
    Eigen::Matrix3d compliance = Eigen::Matrix3d::Zero(); ///< inverse of it, 0 where it is slack [m/N]
    Eigen::Matrix3d viscosity = Eigen::Matrix3d::Zero();  ///< [N s/m]
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    Eigen::Vector3d place = Eigen::Vector3d::Zero(); ///< that it was made for [m]
    double friction = 0.0;
  };
  Plane planeOf(const ContactModel& model, double scale) const noexcept;
  void hear(const ContactModel& model, double now) noexcept;
  void hold(double now, const Eigen::Vector3d& position, const Eigen::Vector3d& force) noexcept;
  void measure(double dt, double age) noexcept;

  double m_maxStiffness, m_maxDamping, m_ownDamping, m_leastDelay;
  double m_delay, m_tick, m_unevenness = 0.0; ///< as measured, smoothed [s]
  Plane m_plane;
  Eigen::Vector3d m_jump = Eigen::Vector3d::Zero();  ///< that the newest plane would have made [N]
  Eigen::Vector3d m_shown = Eigen::Vector3d::Zero(); ///< last force, without presence [N]
  bool m_isNew = false;
  double m_blendLeft = 0.0;       ///< until nothing is left of m_jump [s]
  double m_interval = 1.0 / 60.0; ///< between models, smoothed [s]
  double m_arrival = 0.0;         ///< of the newest model, taken or not [s]
  double m_gap = 0.0;             ///< between it and the one before [s]
  int m_timely = kTimelyAnswers;  ///< answers in a row, no more are counted
  double m_editLeft = 0.0;        ///< of kEditTime [s]
  double m_scale = 1.0;
  std::uint64_t m_heard = 0, m_sequence = 0, m_scene = 0, m_edition = 0;
  double m_presence = 0.0, m_stored = 0.0, m_size = 0.0;
  bool m_active = false, m_holds = false, m_stale = false, m_begins = false;
  bool m_leaves = false, m_sceneLeaves = false; ///< fades out before what has come already is taken
};

} // namespace esm
