// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/simulation.h"
#include "tests/support/stress_nets.h"

#include <map>
#include <string>

namespace esm::test {

/// What a case did at its worst.
struct StressResult {
  bool created = false, finite = true;
  int badFrames = 0; ///< that StepReport called not good; the case ends there
  bool limited = false;
  double balance = 0.0;     ///< see runStress()
  double frameGrowth = 0.0; ///< the same over one frame
  double frameCost = 0.0;   ///< spring evaluations of the dearest frame, over the effort
  StepReport sum;
  std::string solver, why; ///< at the end
  std::string broken;      ///< a promise that was not kept; empty if all were
};

/// Plays the case. After each frame it is checked that all numbers are finite, that the state is the one of
/// before if the report is not good, and how much energy has appeared:
///
///     (kinetic + elastic + gravity) - (what it was) - (work of loads, tools and parameter changes)
///
/// over the most energy that was about so far: what moves, what is stretched, what falls and what has been
/// worked. Heat only takes away, so in exact arithmetic this is never positive.
StressResult runStress(const StressCase& story, const SolverSettings& settings);

/// The worst of many cases.
struct StressSummary {
  int cases = 0, badFrames = 0;
  double growth = 0.0; ///< of `balance` and `frameGrowth`
  double frameCost = 0.0;
  std::map<std::string, int> solvers; ///< how often each was in charge at the end
};

/// Plays the cases of the seeds first ... last - 1. A case that leaves the numbers, gains more than `growth`,
/// costs more than `cost` efforts in a frame or breaks its word is a failure of the test, with its seed.
StressSummary sweepStress(std::uint32_t first, std::uint32_t last, const SolverSettings& settings,
                          double growth, double cost);

} // namespace esm::test
