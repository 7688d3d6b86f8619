// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "bench/runs.h"

#include <array>
#include <functional>
#include <vector>

namespace esm::bench {

inline constexpr std::array<double, 5> kTargets = {1e-1, 1e-2, 1e-3, 1e-4, 1e-6};

/// Least seconds so far for each of kTargets; infinity where nobody came so far.
struct Front {
  std::array<double, kTargets.size()> seconds;
  Front() { seconds.fill(1e30); }
  void add(const Row& row);
};

/// How long to go on with a method that cannot win any more.
struct Patience {
  double factor = 2.5;  ///< of the front's time at the errors that the method has not reached yet
  double cap = 20.0;    ///< seconds of one run
  double finest = 1.04; ///< the first stable number of steps is found to within this factor
};

/// Runs a method of fixed steps: finds the first number of steps per frame that holds (error below 1/2), then
/// goes up in quarter octaves until 1e-6 is reached or patience ends.
std::vector<Row> sweepSteps(const std::function<Row(int, double)>& run, int guess, Front& front,
                            const Patience& patience);
/// Runs an adaptive method over tolerances, three to a decade.
std::vector<Row> sweepTolerances(const std::function<Row(double, double)>& run, Front& front,
                                 const Patience& patience, double ratio = 2.1544346900318838);

/// Where the best row for an error has fixed steps, looks for fewer steps that still do, to within 4 %, and
/// appends what it tried.
void refineWinners(std::vector<Row>& rows, const std::function<Row(const Row& like, int steps)>& run);

} // namespace esm::bench
