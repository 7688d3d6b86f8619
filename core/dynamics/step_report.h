// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace esm {

/// What one Simulation::advance() cost and whether it went well. Counters start at 0 with each call;
/// add() sums calls up, join() what parts of the net did in the same call.
struct StepReport {
  std::int64_t steps = 0;         ///< substeps taken (those of failed attempts included)
  std::int64_t rejectedSteps = 0; ///< of failed attempts, and of methods that were only probed
  std::int64_t springsEvaluated =
    0; ///< spring force evaluations, the unit of cost; viscous forces alone count half
  std::int64_t factorizations = 0;
  std::int64_t newtonIterations = 0;
  std::int64_t nodesAwake = 0; ///< at the end; the others rest and cost nothing
  double smallestStep = 0.0;   ///< [s], 0 before the first step
  double largestForce = 0.0;   ///< largest spring tension at the end [N]
  double simulatedTime = 0.0;  ///< advanced by [s]
  bool nonFinite = false;      ///< a NaN or infinity was caught; the state is the last good one
  bool notConverged = false;   ///< a solver gave up; the state is the last good one
  bool rough = false;          ///< bounded, but the tolerance was given up to save work
  bool stepLimit = false;      ///< the budget or the work limit was spent before the end of the interval
  bool interrupted = false;    ///< then: by Budget::isSpent

  bool good() const noexcept { return !nonFinite && !notConverged && !stepLimit; }
  bool nothingMoved() const noexcept { return steps == 0 && nodesAwake == 0; } ///< all rested throughout
  void add(const StepReport& next) noexcept;
  void join(const StepReport& beside) noexcept; ///< but for simulatedTime, which stays
};

} // namespace esm
