// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/planner/step_control.h"

namespace esm {

/// Does stretches whose tolerance is given up, by damped steps that gain no energy, whose error is told: by blocks for
/// whoever keeps time with a clock, by descent where no step is both good and affordable.
class RoughSteps {
public:
  explicit RoughSteps(StepControl& control) noexcept
    : m_control(control),
      m_overLocal(control.policy.rough.guessedError),
      m_checkGap(control.policy.rough.checkGap),
      m_untilCheck(control.policy.rough.secondBlock)
  {}

  /// What always succeeds. @return whether it has; if not, the report says why
  bool stretch(MotionState& state, double end, StepReport& report);
  /// What moves the net keeps leading it while it stays, until it lets go.
  void followHand();

private:
  Run byDescent(MotionState& state, double end, StepReport& report);
  Run byBlocks(MotionState& state, double end, StepReport& report);
  void check(std::int64_t steps, double affordable, double lost, MotionState& state, double end,
             const ErrorScale& scale, StepReport& report);
  Run run(Method method, MotionState& state, double end, std::int64_t steps, StepReport& report);
  void learn(double error, double local) noexcept;
  double error() const noexcept;
  bool areBlocksWithin() const noexcept;
  void say(Method method, const char* why);

  StepControl& m_control;
  double m_local = 0.0;                             ///< error of the last stretch by its steps themselves [m]
  double m_overLocal;                               ///< its error over that [1]
  double m_unsweptOverLocal = 0.0, m_unswept = 0.0; ///< what the last check found beyond [1], [m]
  std::int64_t m_checkedSteps = 0;                  ///< of a stretch, by the last check
  int m_checkGap;                                   ///< stretches; longer where the last check was broken off
  int m_untilCheck;                                 ///< stretches by blocks
};

} // namespace esm
