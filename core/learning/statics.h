// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/system/implicit_matrix.h"

#include <cstdint>
#include <limits>

namespace esm::learning {

/// What a computation has cost, in what costs most: a factorisation, and a solution by a factor at hand.
struct StaticsCost {
  std::int64_t factorizations = 0, solves = 0;
  StaticsCost& operator+=(const StaticsCost& other) noexcept
  {
    factorizations += other.factorizations;
    solves += other.solves;
    return *this;
  }
};

struct StaticsLimits {
  double force = 1e-12; ///< that may be left, over what pulls at the nodes [1]
  int steps = 60;       ///< of Newton's method
  /// That a free node may go from its place at rest [m]; further off the net has snapped.
  double farthest = std::numeric_limits<double>::infinity();
};

enum class StaticsOutcome : std::uint8_t {
  Balanced, ///< all forces cancel, and the net goes back there when it is pushed
  Snapped,  ///< too far away, too many steps, or a balance that a breath destroys
  Loose     ///< nothing holds the net, or a part of it: no stiffness matrix has a factor
};

struct StaticAnswer {
  StaticsOutcome outcome = StaticsOutcome::Loose;
  double force = 0.0;              ///< left, over what pulls at the nodes [1]
  double farthest = 0.0;           ///< way of a free node from its place at rest [m]
  int steps = 0;                   ///< of Newton's method
  std::int64_t negativePivots = 0; ///< of the stiffness at the place; 0: stable
  StaticsCost cost;                ///< of this answer, with the factor at the place
};

/// Where a net rests under loads: F(x) = 0 on the free nodes, by Newton's method with the exact stiffness
///
///     K = - dF/dx  (springs of all laws, anchors),   x += K^-1 F,
///
/// as far along each step as the energy falls; where K is not positive definite, with its convex part. The
/// factor of K at the place stays at hand, for derivatives (StaticSlopes).
///
/// Prescribed and fixed nodes stand where the loads have them at `time`. Viscosity and mass do not matter,
/// weight does. Pressure bodies are not known here: see check().
/// @note One thread at a time; objects of their own run beside each other.
class Statics {
public:
  /// Whether such nets can be computed. Errors: Unsupported (pressure bodies), InvalidValue (nothing holds it).
  static Status check(const SpringNet& net, const Loads& loads);

  /// @pre check(). @param time of the loads [s].
  Statics(const SpringNet& net, const Loads& loads, double time = 0.0);
  /// Other numbers for the springs and anchors of the same net; the place stays as a start.
  void setParameters(const SpringNet& net);

  /// Goes from place(), which is at rest at first, to balance. Unless that is reached, the place is undefined:
  /// set it before the next call.
  StaticAnswer solve(const StaticsLimits& limits = {});
  const NodeArray& place() const noexcept { return m_x; } ///< N [m]
  void setPlace(const NodeArray& place);
  void goToRest();

  /// change = K^-1 F at place(): where a soft push from there would lead. @return false without a factor.
  bool firstStep(NodeArray& change);
  /// vector = K^-1 vector by the factor at hand, N entries; those of held nodes become 0. @pre Balanced.
  void solveTangent(NodeArray& vector);
  /// Forces on free nodes at place(), 0 where held [N].
  const NodeArray& forces() const noexcept { return m_force; }

  const System& system() const noexcept { return m_system; }
  bool isFree(Index node) const noexcept { return m_system.isFree(at(node)); }
  const StaticsCost& cost() const noexcept { return m_cost; } ///< since the beginning

private:
  double findForces();
  double pullAtNodes();
  double energy(const NodeArray& x) const noexcept;
  double farthest() const noexcept;
  bool factor(bool convex, double shift);
  bool findStep();
  bool takeStep(double& norm);
  bool isRounding() const noexcept;

  System m_system;
  ImplicitMatrix m_matrix;
  Eigen::Vector3d m_gravity;
  double m_time;
  NodeArray m_rest, m_x, m_base, m_still, m_force, m_step, m_vector;
  std::vector<double> m_tension, m_pull;
  StaticsCost m_cost;
};

} // namespace esm::learning
