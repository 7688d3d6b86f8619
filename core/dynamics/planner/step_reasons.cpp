// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/planner/step_reasons.h"

#include "core/base/text_number.h"

#include <cmath>

namespace esm {
namespace {

std::string microseconds(double seconds)
{
  return formatDouble(seconds * 1e6, 3) + " us";
}

std::string placeOf(const BoundWatch& bound)
{
  const Index node = bound.stiffest().node;
  return node == kNoIndex ? "" : " (stiffest at node " + std::to_string(node) + ")";
}

} // namespace

void StepReasons::setName(Method method)
{
  m_name = integratorTable()[method].name;
}

void StepReasons::explain(const Choice& choice, bool isAuto, const MethodFacts& facts,
                          const BoundWatch& bound, double explicitStep)
{
  const Method method = choice.method;
  setName(method);
  const BoundWatch::Stiffest& stiffest = bound.stiffest();
  const bool isBounded = std::isfinite(explicitStep) && stiffest.node != kNoIndex;
  const std::string need = isBounded ? "springs at node " + std::to_string(stiffest.node) + " (" +
                                         formatDouble(bound.mode().springStiffness, 3) + " N/m on " +
                                         formatDouble(stiffest.mass, 3) + " kg) need explicit steps of " +
                                         microseconds(explicitStep)
                                     : "no spring limits the step";
  if (!isAuto)
    m_why = m_name + " as asked; " + need;
  else if (choice.isToleranceGivenUp)
    m_why = need + "; the engine went implicit and stays bounded, but the tolerance may not hold";
  else if (method == facts.implicit())
    m_why = need + "; the engine went implicit";
  else if (facts.traits(method).role == MethodRole::Local)
    m_why = need + "; they take them alone, and the rest its own";
  else if (method != facts.plain())
    m_why = need + "; the tolerance asks for order " + formatDouble(facts.traits(method).order, 3);
  else
    m_why = need + "; explicit steps are cheapest";
}

void StepReasons::sayInterrupted(const BoundWatch& bound)
{
  m_limitText =
    "the time allowed was over before the end of the interval; allow more of it or a larger tolerance" +
    placeOf(bound);
}

void StepReasons::sayStepLimit(std::int64_t steps, const BoundWatch& bound)
{
  m_limitText = "the work limit of " + std::to_string(steps) +
                " steps was reached before the end of the interval; allow more steps or a larger tolerance" +
                placeOf(bound);
}

void StepReasons::sayWorkLimit(double passes, const BoundWatch& bound)
{
  m_limitText =
    "the work limit of " + formatDouble(passes, 3) +
    " force passes for each sixtieth of a second was reached; allow more work or a larger tolerance" +
    placeOf(bound);
}

void StepReasons::sayNonFinite(double fixedStep, const BoundWatch& bound)
{
  m_why = "numbers became infinite" + placeOf(bound) + "; the last good state is kept: " +
          (fixedStep > 0.0
             ? "take a smaller fixed step, at most " + microseconds(fixedStep) + ", or automatic steps"
             : "lower the stiffness or the loads, or raise the masses");
}

void StepReasons::sayNotConverged(const BoundWatch& bound)
{
  m_why = "the " + m_name + " solver found no step small enough" + placeOf(bound) +
          "; the last good state is kept: lower the stiffness or the loads, or take a larger tolerance";
}

} // namespace esm
