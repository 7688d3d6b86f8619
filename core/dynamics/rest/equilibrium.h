// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/planner/policy.h"
#include "core/dynamics/step_report.h"
#include "core/dynamics/system/implicit_matrix.h"
#include "core/dynamics/system/stiffness_cg.h"

namespace esm {

/// Where a net that moves little would be in balance: looked for once, and known as long as it is balance.
///
/// Newton's steps are d = K^-1 F, with F the forces on nodes that stand still and K the tangent stiffness.
/// They turn springs, and a stiff one that has turned pulls along its length as hard as before although the
/// goal is near. So steps are judged by lengths, not by forces: the next one by the same stiffness must be
/// shorter (natural monotonicity: Deuflhard, Newton Methods for Nonlinear Problems, 2004, 3.3). As long as
/// each is at most half as long as the one before, one stiffness does for all of them. Where the next is
/// longer, the stiffness after the step may still show the way, as it knows how springs have turned; else a
/// half, a quarter or an eighth of the step is taken. Where the net gives way, its convex stiffness shows the
/// way; at the goal K itself must be positive definite, or a breath moves the net away.
///
/// Conjugate gradients solve (StiffnessCg), for less than a frame costs; where these take too long, or where
/// pressure acts, a factor does, if the net is not too large for one.
/// @note One thread. Allocates when a net is laid out.
class Equilibrium {
public:
  explicit Equilibrium(const Policy& policy = kPolicy) noexcept
    : m_policy(&policy.balance), m_iterations(policy.balance.iterations)
  {}

  void forget() noexcept; ///< other parameters, or another net

  struct Aim {
    double close = 0.0;      ///< sum of squares that the place may be off by [m^2]
    double far = 0.0;        ///< the search ends where it is further away, sum of squares [m^2]
    double affordable = 0.0; ///< after the first step [spring evaluations]
    int iterations = kPolicy.balance.iterations; ///< of gradients, for each solution
  };
  /// From where the net is. @pre no load moves.
  /// @return sum of squares of the way there, as far as it is known [m^2]; infinity where nothing is: the net
  /// gives way, or bends too much. isKnown() says whether the place was found.
  double find(System& system, const MotionState& motion, const Aim& aim, StepReport& report);
  bool isKnown() const noexcept { return m_isKnown; }
  const NodeArray& place() const noexcept { return m_place; }
  /// Whether the place that is known still is in balance, by a force pass; else it is known no longer.
  bool holds(System& system, double time, StepReport& report);
  void drop() noexcept { m_isKnown = false; } ///< it is not where the net goes
  /// vector = K^-1 vector, by the stiffness near the place; an entry per node, those of held nodes become 0.
  /// @pre isKnown(). @return false where that cannot be told.
  bool solve(System& system, NodeArray& vector);
  /// Forces on nodes at x that stand still, 0 where a support holds [N]. @return their norm [N].
  double forcesAt(System& system, double time, NodeArray& x, NodeArray& force, StepReport& report);

  /// Whether a factor solves, not gradients.
  bool takesFactor(const System& system) const noexcept;
  void layOut(const System& system); ///< the factor, unless that is done
  bool isLaidOut() const noexcept { return m_isLaidOut; }
  /// In spring evaluations. Infinity: too large a net for a factor.
  double layoutCost(const System& system) const noexcept;
  /// Of the first of Newton's steps, and of a further solution, in spring evaluations; of a factor once it is
  /// laid out.
  double stepCost(const System& system) const noexcept;
  double solveCost(const System& system) const noexcept;

private:
  enum class Outcome { IsThere, GoesOn, Turns, Fails };

  bool prepareStep(System& system, double time, StepReport& report);
  bool takeStiffness(System& system, bool convex, StepReport& report);
  Outcome takeStep(System& system, const MotionState& motion, const Aim& aim, StepReport& report);
  Outcome takePart(System& system, double time, StepReport& report);
  double squareOfWay(const NodeArray& from) const noexcept;

  ImplicitMatrix m_matrix;
  StiffnessCg m_gradients;
  bool m_hasFactor = false; ///< of the last takeStiffness()
  bool m_isLaidOut = false;
  bool m_gradientsFail = false; ///< they took too long once
  bool m_byFactor = false;      ///< the present search
  bool m_isConvex = false;      ///< the stiffness at hand
  bool m_isKnown = false;
  const Policy::Balance* m_policy;
  int m_iterations;
  double m_spent = 0.0;      ///< by the present search [spring evaluations]
  double m_affordable = 0.0; ///< of it, see Aim
  double m_firstForce = 0.0; ///< where that began [N]
  double m_force = 0.0;      ///< at the place [N]
  double m_length = 0.0;     ///< of m_step [m]
  NodeArray m_place, m_base, m_step, m_next, m_still;
};

} // namespace esm
