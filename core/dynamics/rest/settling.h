// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/rest/equilibrium.h"
#include "core/dynamics/step_report.h"
#include "core/dynamics/system/stiffness_cg.h"

#include <limits>

namespace esm {

/// What may be missed where a motion is ended before its time.
///
/// Errors are means over time (docs/FILE_FORMAT.md), and what is missed fades as the motion would have. An
/// amplitude A that fades as exp(-t/tau) adds A^2 tau/2 to the integral of the squared error, which is at
/// most A^2 / (1 + 2 T/tau) of its mean at any time after a motion of length T, and at most a third more at
/// the end of a run of length T.
struct SettlingBudget {
  double square = 0.0; ///< sum of squared displacements over the nodes, if they were missed for good [m^2]
  double since = 0.0;  ///< T, of the motion over which `square` is the mean [s]
  double fading = 0.0; ///< time in which its amplitudes fade, by its kinetic energy [s]
  double power = 0.0;  ///< of the dampers lately; 0: unknown [W]
  double erring = 0.0; ///< sum of squares by which the net is off its true motion already [m^2]

  /// The sum of squares that may be missed [m^2]: never more than sixteen times `square`, since an eye sees
  /// the jump, not its mean.
  double squareAt(double fadingTime) const noexcept;
};

/// Takes a net the last part of its way to rest in one go.
///
/// Near its goal a net swings about it, or creeps towards it. With d the way to the equilibrium, K the
/// tangent stiffness and M the masses, what the velocities carry the net beyond it has y = K^-1 M v with |v|
/// |y| >= the sum of squares of that part of the amplitude (one mode: equal). Over a swing the two take
/// turns, so that half of their sum is missed in the mean; a net that creeps, or stands at its turning point,
/// misses d^2 at least. So these two tell how far the net can still get, however slow its slowest mode;
/// speeds and accelerations at single nodes do not, as a slow sway hides behind them. The equilibrium is
/// looked for when the net is near enough, and known from then on, so that d costs next to nothing and y a
/// solution. Most looks before find that it is too early: so bounds from below come first, by b.K^-1 b <= |b|
/// |K^-1 b| for both.
/// @note One thread. Allocates when a net is laid out.
class Settling {
public:
  explicit Settling(const Policy& policy = kPolicy) noexcept
    : m_policy(&policy), m_equilibrium(policy), m_iterations(policy.balance.iterations)
  {}

  void begin() noexcept;  ///< after creation and reset of the net
  void forget() noexcept; ///< other parameters, or another net
  /// The net has moved at this cost [spring evaluations].
  void countWork(std::int64_t springs) noexcept { m_work += static_cast<double>(springs); }
  /// settle() where it is worth a try. While no equilibrium is known that is seldom: glance() leaves a hope,
  /// the first attempt costs no more than what has been done until then, others a third of the work since the
  /// last one (all of it when the net was nearly there), and they come when the net is as slow as it should
  /// be by what that one found, and that had time to fade; or after some time. Nobody should wait for them
  /// longer than some frames, and nobody sees these, since nothing moves much.
  /// @param effort  see SolverSettings
  /// @return whether the net is at rest now. @pre no load moves.
  bool settleIfDue(System& system, MotionState& motion, const SettlingBudget& budget, double effort,
                   StepReport& report);
  /// Moves the net into balance and takes its velocity, if no more than the budget is missed by that, nor at
  /// a single node more than five times the mean; its energy becomes heat. A net that creeps takes amplitude
  /// over speed to its goal, and one whose springs hold much of its energy takes as long as the dampers need
  /// for all of it, if that is longer than it takes to fade. Nothing is done if more is missed, if no
  /// equilibrium is found (what nothing holds is held by its inertia over ten seconds), or if the net has not
  /// the energy to get there.
  /// @pre no load moves.
  /// @return what is missed, a sum of squares, over what may be; infinity where it cannot be told; done if
  /// <= 1.
  double settle(System& system, MotionState& motion, const SettlingBudget& budget, StepReport& report);

  /// A bound from below of what settle() returns, for some tens of products with the stiffness.
  double glance(System& system, MotionState& motion, const SettlingBudget& budget, StepReport& report);

private:
  double shareOfWay(const MotionState& motion, const SettlingBudget& budget, const NodeArray* swing);
  double patience() const noexcept;
  bool mayGlance(const System& system) const noexcept;
  bool mayAttempt(const System& system, double effort) const noexcept;
  bool isDue(const System& system, const MotionState& motion, double speed, double effort);
  double attempt(System& system, MotionState& motion, const SettlingBudget& budget, double effort,
                 StepReport& report);
  double attemptCost(const System& system) const noexcept; ///< of one settle() [spring evaluations]
  Equilibrium::Aim aimOf(const SettlingBudget& budget) const noexcept;

  const Policy* m_policy;
  Equilibrium m_equilibrium;
  StiffnessCg m_glances;
  int m_iterations;                                              ///< of gradients, for each solution
  double m_affordable = std::numeric_limits<double>::infinity(); ///< of a search [spring evaluations]
  bool m_isNear = false;                                         ///< at the last attempt
  double m_dueSpeed = 0.0;                                       ///< below which the next attempt comes [m/s]
  double m_dueTime = 0.0;                                        ///< and before which none comes [s]
  int m_looksLeft = 0;                                           ///< or after so many looks
  double m_work = 0.0;         ///< since the last attempt [spring evaluations]
  double m_workAtGlance = 0.0; ///< m_work when glance() was asked last
  NodeArray m_force;
  NodeArray m_way, m_swing; ///< d, y; M v while looking
};

} // namespace esm
