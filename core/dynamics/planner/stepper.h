// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/methods/integrator.h"
#include "core/dynamics/motion_log.h"
#include "core/dynamics/planner/free_bodies.h"
#include "core/dynamics/planner/judge.h"

#include <limits>
#include <string_view>
#include <vector>

namespace esm {

/// Lets a method run within the limits of work, leaves free bodies where they belong, and writes down what is kept.
class Stepper {
public:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();

  /// @param maxSteps  of one call; 0: any number
  /// @param mostWork  that may be done [spring evaluations]
  void beginCall(std::int64_t maxSteps, double mostWork) noexcept;
  double mostWork() const noexcept { return m_mostWork; }
  std::int64_t maxSteps() const noexcept { return m_maxSteps; }
  /// Of the present call [spring evaluations]; a step is a force pass at least.
  static double workDone(const System& system, const StepReport& report) noexcept;
  bool isSpent(const System& system, const StepReport& report) const noexcept;

  /// A method, and what it is called in the log.
  struct Runner {
    Integrator* integrator;
    std::string_view name;
    bool isImplicit; ///< a step of it counts as one pass for what its looks at the bound cost
  };
  /// `steps` equal steps from state.time to `end`.
  Run run(const Runner& runner, System& system, MotionState& state, double end, std::int64_t steps,
          StepReport& report);
  /// A run that may be called away goes in pieces, each of which ends in a good state.
  static StepResult runInPieces(Integrator& method, System& system, MotionState& state, double end,
                                std::int64_t steps, StepReport& report);
  double takePasses() noexcept; ///< of runs since the last call [force passes]

  FreeBodies& bodies() noexcept { return m_bodies; }
  /// What is run is added to it, until the next call; null: nothing is written down.
  void record(std::vector<Stretch>* stretches) noexcept { m_stretches = stretches; }
  std::vector<Stretch> recorded() const { return m_stretches ? *m_stretches : std::vector<Stretch>(); }
  void putBack(const std::vector<Stretch>& stretches)
  {
    if (m_stretches) *m_stretches = stretches;
  }

private:
  std::int64_t stepsLeft(Integrator& method, const System& system, double step,
                         const StepReport& report) const;
  StepResult runInFrames(Integrator& method, System& system, MotionState& state, double end,
                         std::int64_t steps, StepReport& report);
  void note(double begin, double end, std::int64_t steps, std::string_view method);

  FreeBodies m_bodies;
  std::int64_t m_maxSteps = 0;
  double m_mostWork = kInfinity;
  double m_passes = 0.0;
  std::vector<Stretch>* m_stretches = nullptr; ///< not owned
};

} // namespace esm
