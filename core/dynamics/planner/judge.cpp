// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/planner/judge.h"

#include <algorithm>

namespace esm {
namespace {

Verdict judgeFirst(const Trial& trial) noexcept
{
  if (!trial.isDue) return Verdict::KeepUnseen;
  return trial.isCheckPayable ? Verdict::Again : Verdict::KeepUnaffordable;
}

Verdict judgeCheck(const Policy& policy, const Trial& trial) noexcept
{
  const bool isFine = trial.error <= std::max(trial.allowed, policy.checks.once * trial.unspent);
  // Below the floor a rough answer is taken, but not one that runs away.
  const bool atFloor = trial.step <= trial.floorStep && trial.coarseError <= trial.mostRough;
  if (trial.isSane && isFine) return Verdict::Keep;
  if (trial.isSane && (atFloor || trial.isLast)) return Verdict::KeepRough;
  const bool isOnset = trial.share > policy.onset.error && trial.count >= policy.onset.parts;
  return trial.mayBeginOnset && isOnset ? Verdict::Shorter : Verdict::Smaller;
}

} // namespace

Verdict judge(const Policy& policy, const Trial& trial) noexcept
{
  if (trial.result == Run::Limit) return Verdict::Stop;
  const bool isDone = trial.result == Run::Done;
  if (!trial.isSecond && !isDone && trial.isAuto && (trial.isUnchecked || trial.isExhausted))
    return Verdict::Descend;
  if (isDone && trial.isSecond) return judgeCheck(policy, trial);
  if (isDone && !trial.hasGained) return judgeFirst(trial);
  return trial.isOverdrawn ? Verdict::Descend : Verdict::Retreat;
}

} // namespace esm
