// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/planner/policy.h"

namespace esm {

/// How a run of steps has ended.
enum class Run { Done, Limit, NonFinite, NotConverged };

/// What an attempt to do a stretch has come to, after its first run or after the second one of a check.
struct Trial {
  bool isSecond = false;
  Run result = Run::Done;
  bool isAuto = true;
  bool isOverdrawn = false; ///< nothing is left that may be spent on the stretch
  // After the first run:
  bool isUnchecked = false;    ///< nobody measures its error: it only has to stay bounded
  bool isExhausted = false;    ///< it was broken off for its work
  bool hasGained = false;      ///< energy without cause
  bool isDue = false;          ///< for a check
  bool isCheckPayable = false; ///< and that can be paid for
  // After the second one:
  bool isSane = true;       ///< energy has not come from nowhere
  bool isLast = false;      ///< another attempt could not be paid for
  double error = 0.0;       ///< of what would be kept [m]
  double allowed = 0.0;     ///< of it [m]
  double unspent = 0.0;     ///< that the motion may still add in all [m]
  double coarseError = 0.0; ///< of the first run [m]
  double mostRough = 0.0;   ///< of an answer at the smallest step [m]
  double step = 0.0;        ///< of the first run [s]
  double floorStep = 0.0;   ///< the smallest [s]
  double share = 0.0;       ///< of the budget, that the step for the next stretches would spend
  double count = 1.0;       ///< steps that were wanted
  bool mayBeginOnset = false;
};

enum class Verdict {
  Keep,             ///< its error is within the budget
  KeepRough,        ///< it is not, and no better one can be paid for: that is said
  KeepUnseen,       ///< nobody needs to look
  KeepUnaffordable, ///< somebody should, but it cannot be paid for: better than none
  Again,            ///< with finer steps, to measure the error
  Shorter,          ///< from the start, a part of the stretch: waves that die out soon
  Smaller,          ///< from the start, with the steps that the check asks for, or by another method
  Retreat,          ///< from the start, as the run has failed
  Descend,          ///< by what always succeeds
  Stop              ///< at the limit of work
};

/// What becomes of an attempt. Knows no net.
Verdict judge(const Policy& policy, const Trial& trial) noexcept;

} // namespace esm
