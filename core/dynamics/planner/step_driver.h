// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/planner/controlled_steps.h"
#include "core/dynamics/planner/rough_steps.h"
#include "core/dynamics/planner/step_control.h"

#include <vector>

namespace esm {

/// Says that a System is a part of a net whose other nodes rest: errors are still measured over the whole.
struct NetPart {
  std::vector<Index> nodes;     ///< place of each node in the whole net; empty: the system is the whole net
  NodeArray rest;               ///< their positions at t = 0 [m]
  std::size_t wholeCount = 0;   ///< nodes of the whole net
  double squareElsewhere = 0.0; ///< sum of squared displacements of the nodes outside [m^2]
};

/// Chooses method and step, and takes the steps. docs/DYNAMICS.md has a picture of it.
///
/// Time is cut at the loads' events, and between them into stretches of at most a frame (1/60 s) with equal
/// steps. The step is the smaller of what is stable (BoundWatch) and what is accurate. Accuracy is measured,
/// not estimated from single steps: now and then a stretch is done twice, the second time with two thirds of
/// the step, and the distance of the two ends tells the error (ControlledSteps). Single steps say much about fast
/// modes whose error dies out before the next frame; whole stretches say what a frame shows.
/// How much error a stretch may add is told by ErrorGauge, which also takes a look at the two runs early in
/// the stretch: it tells whether errors add up. After a check other methods that could be far cheaper are
/// probed: each takes the stretch once, and its distance from the kept end tells its error (Probing).
///
/// `auto` compares costs (Weighing): explicit steps at their limit against implicit ones at the accurate step. If even
/// explicit steps would be too many, it goes implicit with a smallest step and says that the tolerance may
/// not hold: bounded rather than exact. Where implicit steps find no solution either, gain energy, or the
/// attempts have cost some times the effort, a few steps of descent take the stretch: they cannot fail (RoughSteps).
class StepDriver {
public:
  static constexpr double kInfinity = Stepper::kInfinity;
  /// @param names  by which why() calls the nodes of the whole net; empty: their places.
  explicit StepDriver(SolverSettings settings, std::vector<Index> names = {});
  StepDriver(const StepDriver&) = delete;
  StepDriver& operator=(const StepDriver&) = delete;

  /// After creation and reset.
  void begin(System& system, const MotionState& state);
  /// Parameters or masses have changed.
  void parametersChanged(System& system, const MotionState& state);
  /// Tools have come, moved or gone.
  void toolsChanged(System& system, const MotionState& state, bool sameNodes);
  /// The state has been changed from outside.
  void restart(System& system, const MotionState& state);
  /// The next calls are about this part of the net, in motion as before: what was learned stays.
  void partChanged(System& system, const MotionState& state, NetPart part);
  /// Another accuracy from the next stretch on. The motion, what was learned and what was prepared stay.
  void setAccuracy(System& system, double tolerance, double effort);
  const Policy& policy() const noexcept { return m_control.policy; }
  /// For a caller that takes an advance() back.
  const ErrorScale& errorScale() const noexcept { return m_control.gauge.scale(); }
  void setErrorScale(const ErrorScale& scale) noexcept { m_control.gauge.setScale(scale); }
  double knownEnd(double time) const noexcept { return m_control.gauge.knownEnd(time); } ///< see ErrorGauge

  /// @param mostWork  that may be done [spring evaluations]; the report's stepLimit says that it was
  StepReport advance(System& system, MotionState& state, double interval, std::int64_t maxSteps,
                     double mostWork = kInfinity);
  /// What advance() keeps is added to it, until the next call; null: nothing is written down.
  void record(std::vector<Stretch>* stretches) noexcept { m_control.stepper.record(stretches); }
  /// Of the last advance() [spring evaluations]; a step is a force pass at least.
  double workDone(const System& system, const StepReport& report) const noexcept
  {
    return Stepper::workDone(system, report);
  }

  /// What the method has lost up to `state` and not booked yet [J]; from now on it is booked. To be called
  /// before the net changes.
  double closeLoss(System& system, const MotionState& state);

  /// Where the net is stiffest now, and the largest explicit step there.
  FastestMode fastestMode(const System& system, const MotionState& state) const;
  double explicitStep(const FastestMode& mode) const noexcept;
  /// Whether Integrator::asksForDecay() holds for any method that may run.
  bool asksForDecay() const noexcept;

  /// Whether a stretch is one step now, however short.
  bool takesBlocks() const noexcept { return m_control.takesBlocks(); }
  /// Whether the last check has found more error than the tolerance allows.
  bool isRough() const noexcept { return m_control.rhythm.isRough() || m_control.choice.isToleranceGivenUp; }
  const std::string& solverName() const noexcept { return m_control.reasons.name(); }
  const std::string& why() const noexcept { return m_control.reasons.why(); }

private:
  bool stretch(MotionState& state, double end, StepReport& report);
  bool stretchFixed(MotionState& state, double end, StepReport& report);
  bool stretchAlone(MotionState& state, double end, StepReport& report);
  void enterEvent(MotionState& state);

  StepControl m_control;
  ControlledSteps m_controlled;
  RoughSteps m_rough;
};

} // namespace esm
