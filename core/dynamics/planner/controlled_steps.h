// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/planner/plan.h"
#include "core/dynamics/planner/probing.h"
#include "core/dynamics/planner/step_control.h"

namespace esm {

/// Does stretches within the tolerance: plans one, runs it, now and then once more with finer steps, whose distance
/// tells the error, and lets judge() say what becomes of it. The second result is kept.
///
/// Where loads jump, fast waves start that die out soon. If the first stretch errs far too much, it is cut
/// into short ones that double (an onset), so that their small steps are not taken any longer than these waves
/// live.
class ControlledSteps {
public:
  explicit ControlledSteps(StepControl& control) : m_control(control), m_probing(control, m_ends)
  {
    m_onset.known.resize(control.methods.count());
  }

  void begin(const MotionState& state); ///< room for later
  void continueOnset();                 ///< before each stretch
  void rememberBeforeOnset();           ///< the same, once the bounds are known
  /// Longest stretch that is planned now [s].
  double longest(bool isByBlocks);
  double longestCheck();
  void spendOnset(double work) noexcept { m_onset.affordable -= work; }
  /// From `state` on to `end`, or less far where a check asks for a shorter stretch. @return how it went
  enum class Outcome { Done, Failed, NoneIsGood };
  Outcome stretch(MotionState& state, double end, StepReport& report);

private:
  /// The first moments after an event, while stretches are shorter than usual.
  struct Onset {
    Method method = 0;             ///< before it
    double affordable = 0.0;       ///< what is left of the first stretch's work [spring evaluations]
    std::vector<KnownSteps> known; ///< of each method before it: what is learned in it holds in it
  };
  void limitWork(double length);
  Run runFirst(const Plan& plan, MotionState& state, double end, StepReport& report);
  Run runAgain(const Plan& plan, MotionState& state, double end, StepReport& report);
  Run repeatExactly(const Plan& plan, double solve, MotionState& state, double end, StepReport& report);
  Trial tryOnce(const Plan& plan, MotionState& state, double end, StepReport& report);
  Trial check(const Plan& plan, MotionState& state, double end, StepReport& report);
  double errorOfFirst(const MotionState& state, double ratio);
  double shareOfHeat(const MotionState& state, double finer);
  void learn(const Plan& plan, const MotionState& state, Trial& trial);
  void keepChecked(const Plan& plan, Verdict verdict, const Trial& trial, MotionState& state,
                   StepReport& report);
  void keepUnchecked(const Plan& plan, Verdict verdict, MotionState& state, StepReport& report);
  bool isCheckDue(const MotionState& state);
  bool fallBackToPlain(double length);
  void stopAtLimit(MotionState& state, StepReport& report);
  void retreat(MotionState& state, int attempt, double length, StepReport& report);
  double retry(Verdict verdict, const Plan& plan, double left, StepReport& report);

  StepControl& m_control;
  CheckEnds m_ends;
  Probing m_probing;
  Onset m_onset;
};

} // namespace esm
