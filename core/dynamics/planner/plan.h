// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/planner/weighing.h"

#include <cstdint>

namespace esm {

/// Equal steps, no longer than `step`, that make up `length` [s]; one too many for no rounding error.
double wholeSteps(double length, double step) noexcept;

/// How a stretch is to be done.
struct Plan {
  double length = 0.0;      ///< of the stretch [s]
  double step = 0.0;        ///< wanted; the stretch is divided evenly into no longer ones [s]
  double count = 1.0;       ///< steps of that length
  bool isChecked = false;   ///< done twice
  bool isUnchecked = false; ///< nobody measures its error now or later: it only has to stay bounded
  bool isFromAbove = false; ///< a check whose first run takes larger steps instead of smaller ones
  std::int64_t steps = 1;   ///< of the first run
  std::int64_t finer = 1;   ///< of the second one of a check
  double work = 0.0;        ///< of the wanted steps [spring evaluations]
};

/// The method's steps over `length` seconds.
/// @param isCheckDue  by CheckRhythm
/// @param isFirst  the stretch has not been tried before
Plan plan(const Policy& policy, const Observation& now, Knowledge& known, MethodFacts& facts,
          const Choice& choice, double length, bool isCheckDue, bool isFirst);

/// Length of a stretch that is checked [s].
double longestCheck(const Policy& policy, const Observation& now, Knowledge& known, MethodFacts& facts,
                    const Choice& choice);

} // namespace esm
