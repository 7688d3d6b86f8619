// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/grouped.h"
#include "core/dynamics/system/system.h"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace esm {

/// The parts of a net that nothing holds: springs and pressure join their nodes, and none of these is fixed,
/// moved, anchored, held by a tool or braked. What acts between nodes cancels out, so the centre of mass of
/// each goes by weight and nodal forces alone, along a polynomial of time from one event to the next. Steps
/// that err, or give up, have no say in that: keep() puts the centres where they belong.
/// @note One thread. Allocates in find() only.
class FreeBodies {
public:
  /// Which parts are free now, by springs, tools and constraints; begin() must follow.
  void find(const System& system);
  /// The motion goes on from here, under the lines that the loads follow now.
  void begin(const System& system, const MotionState& state);
  /// After System::enter() at an event that leaves the bodies as they are.
  void enter(const System& system, double time);

  bool isEmpty() const noexcept { return m_bodies.empty(); }
  std::size_t count() const noexcept { return m_bodies.size(); }
  /// Of a node; kNoIndex if something holds it.
  Index bodyOf(Index node) const noexcept { return m_bodyOf[static_cast<std::size_t>(node)]; }
  std::span<const Index> nodesOf(std::size_t body) const noexcept { return m_nodes[body]; }
  bool isHeavy(std::size_t body) const noexcept
  {
    return dot(m_bodies[body].weight, m_bodies[body].weight) > 0.0;
  }

  /// Moves each body as one to where its centre of mass belongs, if that or its velocity is off by more than
  /// rounding and a ten-thousandth of a millionth of the motion: of what its nodes run in the stretch of this
  /// length [s] up to here, or of how far they have come since begin(), whichever is less. (What trembles runs
  /// far and comes nowhere.)
  /// What that changes of its energy, and all that a frame of reference gives back, is EnergySums::restored.
  /// @return whether any was moved
  bool keep(const System& system, MotionState& state, double length) noexcept;

  /// Goes over to a frame of reference for each body that begins with its centre of mass and accelerates as
  /// that will at `end`, where implicit Euler looks at the forces: no energy is to be had by going anywhere.
  /// What happens within the body is the same there, and what a rough step loses is none of the centre's
  /// motion. Left again, a body that no load acts on gets back the spin that it has lost, as far as the step
  /// has lost the energy for it.
  void enterFrame(System& system, MotionState& state, double end) noexcept;
  void leaveFrame(System& system, MotionState& state) noexcept;

  /// How a body moves as one.
  struct RigidMotion {
    bool isDriven = false; ///< loads push or turn it
    double speed = 0.0;    ///< of its centre of mass [m/s]
    double turning = 0.0;  ///< of its nodes about that, by the angular momentum [m/s]; 0 if pushed
  };
  RigidMotion rigidMotion(const System& system, const MotionState& state, std::size_t body) const noexcept;

private:
  struct Body {
    double mass = 0.0;                        ///< [kg]
    Lanes weight = {0, 0, 0, 0};              ///< [N]
    Lanes x = {0, 0, 0, 0}, v = {0, 0, 0, 0}; ///< of the centre of mass at m_begin
    Lanes load = {0, 0, 0, 0};                ///< sum of nodal forces then [N]
    Lanes slope = {0, 0, 0, 0};               ///< of that [N/s]
    double loads = 0.0;                       ///< sum of their sizes [N]
    double way = 0.0;                         ///< of its nodes since begin(), RMS, the largest so far [m]
    Lanes frameX = {0, 0, 0, 0}, frameV = {0, 0, 0, 0};     ///< where it belonged when the frame was entered
    Lanes enteredX = {0, 0, 0, 0}, enteredV = {0, 0, 0, 0}; ///< where it was then
    Lanes frameA = {0, 0, 0, 0};                            ///< acceleration of the frame
    Eigen::Vector3d turn = Eigen::Vector3d::Zero();         ///< that it is to get back [1/s]
    Eigen::Vector3d spin = Eigen::Vector3d::Zero();         ///< about the centre then [kg m^2/s]
  };
  struct Centre {
    Lanes x, v;
  };
  Centre centreAt(const Body& body, double time) const noexcept;
  Centre centreOf(const System& system, const MotionState& state, std::size_t body,
                  Lanes& squares) const noexcept;
  double wayOf(const System& system, const MotionState& state, std::size_t body) const noexcept;
  void takeLoads(const System& system, double time) noexcept;
  bool putInPlace(const System& system, MotionState& state, std::size_t index, double length) noexcept;
  /// Angular momentum about the centre [kg m^2/s], and the inertia [kg m^2].
  struct Spin {
    Eigen::Vector3d momentum = Eigen::Vector3d::Zero();
    Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
  };
  Spin spinOf(const System& system, const MotionState& state, std::size_t body) const noexcept;
  void restoreSpins(const System& system, MotionState& state) noexcept;
  void bookFrame(const System& system, MotionState& state, std::size_t index,
                 const Centre& to) const noexcept;
  static double energyOf(const System& system, const MotionState& state) noexcept;

  std::vector<Body> m_bodies;
  Grouped<Index> m_nodes;      ///< by body
  std::vector<Index> m_bodyOf; ///< N
  NodeArray m_first;           ///< N, positions at begin() [m]
  double m_begin = 0.0, m_frameBegin = 0.0;
  double m_frameEnergy = 0.0; ///< then, less what was worked, and with the heat [J]
  NodeArray m_frameForce;     ///< N [N]
};

} // namespace esm
