// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/step_report.h"

#include <algorithm>

namespace esm {

void StepReport::join(const StepReport& beside) noexcept
{
  steps += beside.steps;
  rejectedSteps += beside.rejectedSteps;
  springsEvaluated += beside.springsEvaluated;
  factorizations += beside.factorizations;
  newtonIterations += beside.newtonIterations;
  nodesAwake += beside.nodesAwake;
  if (beside.smallestStep > 0.0)
    smallestStep = smallestStep > 0.0 ? std::min(smallestStep, beside.smallestStep) : beside.smallestStep;
  largestForce = std::max(largestForce, beside.largestForce);
  nonFinite = nonFinite || beside.nonFinite;
  notConverged = notConverged || beside.notConverged;
  rough = rough || beside.rough;
  stepLimit = stepLimit || beside.stepLimit;
  interrupted = interrupted || beside.interrupted;
}

void StepReport::add(const StepReport& next) noexcept
{
  join(next);
  nodesAwake = next.nodesAwake;
  largestForce = next.largestForce;
  simulatedTime += next.simulatedTime;
}

} // namespace esm
