// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/planner/bound_watch.h"
#include "core/dynamics/planner/check_rhythm.h"
#include "core/dynamics/planner/energy_guard.h"
#include "core/dynamics/planner/error_gauge.h"
#include "core/dynamics/planner/loss_book.h"
#include "core/dynamics/planner/method_set.h"
#include "core/dynamics/planner/step_reasons.h"
#include "core/dynamics/planner/stepper.h"
#include "core/dynamics/planner/weighing.h"
#include "core/dynamics/solver_settings.h"

namespace esm {

/// What was asked for.
struct Request {
  SolverSettings settings;
  double firstTolerance = 0.0, firstEffort = 0.0; ///< before setAccuracy()
  bool isAuto = false;
};

/// Whether a clock has to be kept, and by what.
struct TimeKeeping {
  bool isByBlocks = false;   ///< the clock wants them now
  bool handLeads = false;    ///< tools that move hold the net, see ToolSpring
  bool blocksSuffice = true; ///< for their motion, as far as checks have told
  int refuge = 0,
      refugeTerm = 0; ///< stretches of what cannot fail still to come; how many there were last time
  bool isLedByBlocks() const noexcept { return handLeads && blocksSuffice; }
  /// Failing is not paid for every time: after the first failure one stretch, then two, four, ...
  void flee(int longest) noexcept;
};

/// The parts that the ways of doing a stretch share (ControlledSteps, RoughSteps), and what they all do with them.
/// `start` is the state at the start of the present stretch.
/// @note One thread. @pre attach() before anything else
struct StepControl {
  StepControl(SolverSettings settings, std::vector<Index> nodeNames);
  StepControl(const StepControl&) = delete;
  StepControl& operator=(const StepControl&) = delete;

  const Policy policy;
  Request request;
  System* system = nullptr; ///< not owned
  MethodSet methods;
  Knowledge known;
  Choice choice;
  BoundWatch bound;
  ErrorGauge gauge;
  Stepper stepper;
  EnergyGuard energy;
  LossBook loss;
  CheckRhythm rhythm;
  TimeKeeping time;
  StepReasons reasons;
  MotionState start;

  void attach(System& to) noexcept;
  Integrator& current() noexcept { return methods.at(choice.method); }
  bool isImplicit() const noexcept { return choice.method == methods.implicit(); }
  double springs() const noexcept { return static_cast<double>(system->forces().activeSprings()); }

  Observation observe() const;
  /// Asks a Weighing of what is observed now.
  template <typename Question>
  auto weigh(Question question)
  {
    const Observation now = observe();
    return question(Weighing(policy, now, known, methods));
  }
  double controlledStep(double length);
  double effort() const noexcept; ///< [spring evaluations a frame]

  void look(const MotionState& state); ///< at the bound
  void lookIfDue(const MotionState& state);
  /// After a change, now or once somebody needs it.
  void replaceBound(const MotionState& state, bool now);
  /// Whether a look could change anything: not while blocks take what a hand leads, nor where plain steps would cost so
  /// much more than they may that no motion brings them back.
  bool doesBoundMatter() const noexcept;
  void weighSteps();  ///< by the bound at hand
  void weighEffort(); ///< what steps the effort pays for
  void weighLeastCost();
  void use(Method method);
  void choose(); ///< before anything has been measured
  void reconsider(std::optional<Method> proven = std::nullopt);
  void explain();

  bool mayTakeBlocks() const noexcept;
  bool takesBlocks() const noexcept { return time.isByBlocks || time.refuge > 0; }

  void beginStretch(const MotionState& state);
  Run run(MotionState& state, double end, std::int64_t steps, StepReport& report);
  /// Error that a stretch may add [m]. The parts of an onset share what one stretch would have.
  double budget(const MotionState& state, double length);
  double expectedError(const MotionState& state) const; ///< that the stretch up to here has added [m]
  EnergyBalance energyBalance(const MotionState& state) { return energy.balance(*system, start, state); }
  bool energyAppeared(const EnergyBalance& balance, double share) noexcept;
  bool energyAppeared(const MotionState& state, double share)
  {
    return energyAppeared(energyBalance(state), share);
  }
  /// Whether so much more work is beyond what `auto` may spend on the stretch.
  bool isTooDear(double work) const noexcept;
  double closeLoss(const MotionState& state);
  void bookLoss(MotionState& state, Method method, double step);
  /// The stretch is done. @param error  that it has added [m] @param beyond  see ErrorGauge
  void keep(const MotionState& state, double error, double beyond = 0.0);
  void giveUp(Run failure, StepReport& report);
  void findBodies(const MotionState& state);
};

} // namespace esm
