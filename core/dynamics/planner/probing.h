// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/planner/plan.h"
#include "core/dynamics/planner/step_control.h"

namespace esm {

/// The two runs of a check, of which the second one goes on to be the motion.
struct CheckEnds {
  NodeArray x, v;                           ///< end of the first one
  double heat = 0.0;                        ///< that it has found the dampers to take [J]
  double coarseWork = 0.0, finerWork = 0.0; ///< of the two [spring evaluations]
  /// Early in the stretch. No steps: none was taken.
  struct Look {
    NodeArray x;            ///< of the first run
    std::int64_t steps = 0; ///< of it up to here, an even number
    double time = 0.0;
    double share = 1.0; ///< of the stretch
    double error = 0.0; ///< how far the second run was from it [m]
  };
  Look look;
};

/// How far an end of a stretch is off, as far as that goes on to count.
/// The part that adds up of an error which a look has seen grow within the stretch.
double addingUp(const StepControl& control, const CheckEnds& ends, Method method, const NodeArray& otherX,
                const NodeArray& otherV, const MotionState& state);
/// ErrorGauge::swing(), counted as work.
double swing(StepControl& control, double distance, const NodeArray& otherV, const MotionState& state);

/// After a check, by the end that it has kept: does another method err little enough there, and cost less? It takes the
/// same stretch once: a change on a mere guess would cost more than such a look does.
class Probing {
public:
  Probing(StepControl& control, const CheckEnds& ends) noexcept : m_control(control), m_ends(ends) {}

  void makeRoom(const MotionState& state) { m_state = state; }
  /// @param allowed  error of the stretch, by the method that runs [m]
  std::optional<Method> probe(const MotionState& state, double allowed, StepReport& report);

private:
  std::optional<Method> probeBest(const MotionState& state, double allowed, StepReport& report);
  std::optional<Method> probeNext(const MotionState& state, double allowed, StepReport& report);
  bool tryOut(Method method, double step, const MotionState& state, double allowed, StepReport& report);
  StepResult run(Integrator& integrator, const MotionState& state, std::int64_t steps, double& early,
                 StepReport& report);

  StepControl& m_control;
  const CheckEnds& m_ends;
  MotionState m_state; ///< the same stretch by another method
};

} // namespace esm
