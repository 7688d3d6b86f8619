// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/bounds/step_bound.h"
#include "core/dynamics/step_report.h"
#include "core/dynamics/system/system.h"

#include <memory>
#include <span>
#include <string_view>

namespace esm {

enum class StepResult { Done, NonFinite, NotConverged };

/// One way to move a system through one step. Keeps only what speeds up the next step; the motion itself is
/// in MotionState, so that methods can be exchanged between two steps without a jump.
///
/// What a step owes to those around it (runge_kutta.cpp is the plainest explicit method to learn it from,
/// linearized.cpp the plainest implicit one):
/// - Forces at a time come from System::evaluate(), which counts springs and puts prescribed nodes to their
///   place; System::toAccelerations() makes accelerations of them, 0 where a support holds. At the end of the
///   step System::place() puts prescribed nodes to theirs once more, if no evaluate() there has done it.
/// - Work and heat are the powers that evaluate() returns, summed with the weights that the forces have in
///   the step: only so does the balance of energy have the order of the method.
/// - StepReport::steps counts every step, one that fails, too; factors and iterations are counted by who makes
///   them. All else in the report is the planner's.
/// - The new state is made in buffers of the method's own; if allFinite() denies, the result is NonFinite, else
///   MotionState::advanceTo() exchanges the arrays and adds the energies.
/// - Sweeps over the nodes go through System::sweepNodes(), so that threads share them with the same bits.
class Integrator {
public:
  virtual ~Integrator() = default;

  /// Sizes all buffers; after any change of net, constraints or tools. May allocate, step() of the explicit
  /// methods does not.
  virtual void prepare(const System& system) = 0;
  /// The state, the loads' lines or the parameters have changed from outside: forget the last step.
  virtual void restart() noexcept = 0;
  /// The state will be taken back to this time perhaps, to be run from once more with another step: what a
  /// check does. Copies what rewind() needs, if anything.
  virtual void mark(double /*time*/) {}
  /// The state is again what it was then; what was known there still holds. Like restart() if nothing is.
  virtual void rewind(double /*time*/) noexcept { restart(); }
  /// The tools have moved, but hold the same nodes as before: what a hand does in every frame.
  virtual void toolsMoved() noexcept { restart(); }
  /// Nodes have become free or held.
  virtual void constraintsChanged(const System& /*system*/) { restart(); }
  /// From state.time to `end` = state.time + h, no event in between. If the result is not Done, `state` is
  /// untouched. After tune().
  /// The default is a run of one step, for methods that take all their steps in run().
  virtual StepResult step(System& system, MotionState& state, double /*h*/, double end, StepReport& report)
  {
    return run(system, state, end, 1, report);
  }

  /// `steps` equal steps to `end`, no event in between, for methods that do better than one by one; the
  /// default takes them one by one, and where an implicit solver finds no solution, in up to 256 parts each.
  /// If the result is not Done, `state` is at the last good step. A method has its own of step() or of run().
  virtual StepResult run(System& system, MotionState& state, double end, std::int64_t steps,
                         StepReport& report);
  /// The bounds of the motion have changed.
  virtual void tune(const System& /*system*/, const FastestMode& /*mode*/) noexcept {}

  virtual int order() const noexcept = 0;
  /// Whether it adds to MotionState::loss by itself.
  virtual bool findsLoss() const noexcept { return false; }
  /// What the steps since the last call have erred in place, each by itself: the sum of their distances from
  /// what a method of next order, which is at hand without a pass more, makes of them [m, roots of sums of
  /// squares over the nodes]. 0 from a method that knows none.
  virtual double takeLocalError() noexcept { return 0.0; }
  /// Whether it takes one step per stretch whatever the tolerance: its result is an equilibrium, or rough by
  /// intent.
  virtual bool isUncontrolled() const noexcept { return false; }
  /// Whether it books what supports lend (SupportLoan) by itself.
  virtual bool keepsLoan() const noexcept { return false; }
  /// Whether it brakes what a free body does as one, so that it is best run in the body's frame of reference.
  virtual bool brakesBodies() const noexcept { return false; }
  /// Largest stable step for such motions [s]; infinity for an implicit method. The planner keeps a margin of
  /// a twentieth. Where no step is stable, as without dampers by most methods of Runge-Kutta's kind, the one
  /// by which the fastest motion grows by some 1e-4 of itself: slower than the checks of the tolerance mend.
  virtual double stableStep(const FastestMode& mode) const noexcept = 0;
  /// Whether stableStep() looks at FastestMode::decay, of which to know more than `damping` takes half of
  /// what a look at the bounds costs.
  virtual bool asksForDecay() const noexcept { return false; }
  /// How exactly an implicit method must solve for positions [m]; `rough`: a few iterations that gain are
  /// enough, the state only has to stay bounded.
  virtual void setSolveTolerance(double /*tolerance*/, bool /*rough*/) noexcept {}
  /// Cost of a step of length `h` [s] in spring evaluations: passes times ForceModel::passCost(), and
  /// System::sweepCost() of all that is done with the nodes besides.
  virtual double stepCost(const System& system, double h) = 0;
};

/// What a method is to the planner (StepDriver): one of those that `auto` weighs against each other, or one that
/// only runs when asked for by name. The tests that go over all methods choose them by it, too.
enum class MethodRole {
  Explicit, ///< competes by cost
  Local,    ///< the same with local steps: laid out and weighed only where few springs or nodes hold up many
  ExplicitByName, ///< by name; explicit, so its steps come from stableStep() and the checks of the tolerance
  Implicit,       ///< the one that serves where the explicit ones are all too slow; there is only one
  ByName          ///< by name; any other: implicit, damping or rough
};

/// A line of the table of methods: adding one is adding one file and one line in methods.inc.
struct IntegratorEntry {
  std::string_view name, description; ///< unique; one line for `esm solvers`
  std::unique_ptr<Integrator> (*make)();
  MethodRole role;
  /// Error (docs/FILE_FORMAT.md) that an explicit method makes at its largest stable step on tissue-like nets
  /// of some hundreds of nodes that have just been pulled: the planner's guess before it has measured for
  /// itself. Set by the force passes of `auto` on ninety scenes; of a method by name it only chooses the
  /// first steps, and a power of ten is enough.
  double typicalError = 0.0;
  /// Of an error across the motion, the share that does not add up where dampers are stronger than springs,
  /// measured; see addingUp() of the planner.
  double offset = 0.0;
  /// The typical error where springs are stronger than dampers, 0 if it is the same.
  double typicalErrorOfWaves = 0.0;
  /// Its twin, which takes the same steps for hardly more and errs no more in any of them; empty if none.
  std::string_view sharperTwin = {};
};
std::span<const IntegratorEntry> integratorTable() noexcept;
std::unique_ptr<Integrator> makeIntegrator(std::string_view name); ///< null for an unknown name

/// Part of `multirate`: velocity Verlet, a few stiff nodes by the trapezoidal rule.
std::unique_ptr<Integrator> makeFewImplicit();

/// Whether all numbers are finite.
bool allFinite(const NodeArray& x, const NodeArray& v) noexcept;

} // namespace esm
