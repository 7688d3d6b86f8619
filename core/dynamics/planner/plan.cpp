// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/planner/plan.h"

#include "core/dynamics/system/frame.h"

#include <cmath>

namespace esm {
namespace {

/// Whether a check may compare this step with a larger one instead of a smaller one, for less than half the
/// work beyond that of the stretch. Not the first check of a method, which may need the smaller one; not
/// below fourth order, where errors at half of the limit are not yet of their order; nor where dampers are weak
/// (sheets took 4 % more at 1e-6).
bool hasRoomAbove(const Policy& policy, const Observation& now, const MethodKnowledge& known,
                  const MethodTraits& traits, double step, double stable) noexcept
{
  return traits.isExplicit() && known.isMeasured && traits.order >= policy.checks.enoughOrder &&
         now.isDamped && !now.isOnset && step == known.accurateStep && policy.checks.finer * step <= stable;
}

} // namespace

double wholeSteps(double length, double step) noexcept
{
  return std::ceil(length / step * (1.0 - 1e-9));
}

Plan plan(const Policy& policy, const Observation& now, Knowledge& known, MethodFacts& facts,
          const Choice& choice, double length, bool isCheckDue, bool isFirst)
{
  const Weighing weighing(policy, now, known, facts);
  Plan plan;
  plan.length = length;
  plan.step = weighing.controlledStep(choice, length);
  plan.count = wholeSteps(length, plan.step);
  plan.work = plan.count * facts.stepCost(choice.method, plan.step);
  plan.isUnchecked = choice.isToleranceGivenUp && choice.method == facts.implicit();
  plan.isChecked = !plan.isUnchecked && isCheckDue;
  plan.isFromAbove = plan.isChecked && isFirst &&
                     hasRoomAbove(policy, now, known.of(choice.method), facts.traits(choice.method),
                                  plan.step, weighing.stableStep(choice.method));
  if (!(plan.count < policy.steps.mostSteps)) return plan;
  const double finer = policy.checks.finer;
  plan.steps = static_cast<std::int64_t>(plan.isFromAbove ? std::ceil(plan.count / finer) : plan.count);
  plan.finer = static_cast<std::int64_t>(plan.isFromAbove ? plan.count : std::ceil(finer * plan.count));
  return plan;
}

double longestCheck(const Policy& policy, const Observation& now, Knowledge& known, MethodFacts& facts,
                    const Choice& choice)
{
  const Weighing weighing(policy, now, known, facts);
  const double length = weighing.checkLength();
  return weighing.controlledStep(choice, kFrame) < length / policy.checks.manySteps ? length : kFrame;
}

} // namespace esm
