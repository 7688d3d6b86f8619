// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/step_report.h"

#include <algorithm>

namespace esm {

void StepReport::add(const StepReport& next) noexcept
{
  steps += next.steps;
  rejectedSteps += next.rejectedSteps;
  springsEvaluated += next.springsEvaluated;
  factorizations += next.factorizations;
  newtonIterations += next.newtonIterations;
  if (next.smallestStep > 0.0)
    smallestStep = smallestStep > 0.0 ? std::min(smallestStep, next.smallestStep) : next.smallestStep;
  nodesAwake = next.nodesAwake;
  largestForce = next.largestForce;
  simulatedTime += next.simulatedTime;
  nonFinite = nonFinite || next.nonFinite;
  notConverged = notConverged || next.notConverged;
  rough = rough || next.rough;
  stepLimit = stepLimit || next.stepLimit;
  interrupted = interrupted || next.interrupted;
}

} // namespace esm
