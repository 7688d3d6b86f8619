// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// The part of StepDriver that says in words which method runs and why, and what helps where none does.
#include "core/base/text_number.h"
#include "core/dynamics/planner/step_driver.h"

#include <cmath>

namespace esm {
namespace {

std::string microseconds(double seconds)
{
  return formatDouble(seconds * 1e6, 3) + " us";
}

} // namespace

Index StepDriver::nameOf(Index node) const noexcept
{
  const Index place = m_places.empty() ? node : m_places[static_cast<std::size_t>(node)];
  return m_names.empty() ? place : m_names[static_cast<std::size_t>(place)];
}

void StepDriver::sayToleranceGivenUp()
{
  explain();
  m_why += "; the tolerance would cost too many steps and may not hold";
}

void StepDriver::sayRough(Method method, const char* why)
{
  explain();
  m_name = integratorTable()[method].name;
  m_why += why;
}

void StepDriver::explain()
{
  m_name = integratorTable()[m_method].name;
  const double step = explicitLimit();
  const bool bounded = std::isfinite(step) && m_stiffest.node != kNoIndex;
  const std::string need = bounded ? "springs at node " + std::to_string(m_stiffest.node) + " (" +
                                       formatDouble(m_mode.springStiffness, 3) + " N/m on " +
                                       formatDouble(m_stiffest.mass, 3) + " kg) need explicit steps of " +
                                       microseconds(step)
                                   : "no spring limits the step";
  if (!m_auto)
    m_why = m_name + " as asked; " + need;
  else if (m_toleranceGivenUp)
    m_why = need + "; the engine went implicit and stays bounded, but the tolerance may not hold";
  else if (m_method == m_implicit)
    m_why = need + "; the engine went implicit";
  else if (m_candidates[m_method].role == MethodRole::Local)
    m_why = need + "; they take them alone, and the rest its own";
  else if (m_method != m_leapfrog)
    m_why = need + "; the tolerance asks for order " + std::to_string(current().order());
  else
    m_why = need + "; explicit steps are cheapest";
}

void StepDriver::giveUp(const System& system, Run failure, StepReport& report)
{
  const std::string place =
    m_stiffest.node == kNoIndex ? "" : " (stiffest at node " + std::to_string(m_stiffest.node) + ")";
  if (failure == Run::Limit) {
    report.stepLimit = true;
    if (system.isInterrupted()) {
      report.interrupted = true;
      m_limitText = "the time allowed was over before the end of the interval; allow more of it or a larger "
                    "tolerance" +
                    place;
      return comeDown();
    }
    const bool isOfSteps = m_maxSteps > 0 && report.steps >= m_maxSteps;
    m_limitText = (isOfSteps ? "the work limit of " + std::to_string(m_maxSteps) +
                                 " steps was reached before the end of the interval; allow more steps"
                             : "the work limit of " + formatDouble(m_settings.workLimit, 3) +
                                 " force passes for each sixtieth of a second was reached; allow more work") +
                  " or a larger tolerance" + place;
  } else if (failure == Run::NonFinite) {
    report.nonFinite = true;
    m_why = std::string("numbers became infinite") + place + "; the last good state is kept: " +
            (m_settings.fixedStep > 0.0 ? "take a smaller fixed step, at most " +
                                            microseconds(explicitStep(m_mode)) + ", or automatic steps"
                                        : "lower the stiffness or the loads, or raise the masses");
  } else {
    report.notConverged = true;
    m_why = "the " + m_name + " solver found no step small enough" + place +
            "; the last good state is kept: lower the stiffness or the loads, or take a larger tolerance";
  }
}

} // namespace esm
