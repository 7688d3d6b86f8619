// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/tolerance_check.h"

#include "core/base/text_number.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace esm {
namespace {

constexpr double kFiner = 0.1; ///< the tolerance of a run over that of the one before
/// Of the tolerance, that two runs may be apart: the finer one errs, too. Of 31 runs of the bench's scenes
/// that miss theirs all but one are further apart (that one is of a net that snaps through).
constexpr double kMargin = 0.8;
constexpr double kMoreEffort = 10.0; ///< of finer runs over what was asked for
constexpr int kMostRuns = 6;
/// Over those of the run that may be the result: less would not be finer.
constexpr double kMoreSteps = 1.25, kMostFrames = 0.6;
/// Below it rounding is what runs differ by, and steps get small without end.
constexpr double kLeastTolerance = 0.9e-10;

} // namespace

ToleranceCheck::ToleranceCheck(SolverSettings asked) : m_asked(std::move(asked)), m_settings(m_asked) {}

void ToleranceCheck::start(const NetState& state)
{
  m_start = state.position;
  m_steps.clear();
  m_apart = m_displacement = 0.0;
}

void ToleranceCheck::add(const NetState& state, const StepReport& frame)
{
  const std::size_t number = m_steps.size();
  m_steps.push_back(frame.steps);
  if (m_runs == 0) {
    m_former.push_back(state.position);
    return;
  }
  if (number >= m_former.size()) return;
  Eigen::Matrix3Xd& former = m_former[number];
  const double apart = (state.position - former).squaredNorm();
  m_apart += apart;
  m_displacement += (state.position - m_start).squaredNorm();
  if (apart > m_worst) {
    m_worst = apart;
    m_worstTime = state.time;
  }
  former = state.position;
}

ToleranceCheck::Next ToleranceCheck::endRun(const StepReport& report)
{
  ++m_runs;
  m_failed = !report.good();
  m_rough = report.rough;
  if (m_runs > 1)
    if (const Next next = judge(); next != Next::RunAgain) return next;
  m_resultTolerance = m_settings.tolerance;
  m_resultSteps = m_steps;
  if (m_failed || !refine()) return end(Next::TakeThis, false);
  m_error.reset();
  m_worst = 0.0;
  return Next::RunAgain;
}

/// What the run that has just ended says of the one that may be the result; RunAgain: that is not good
/// enough.
ToleranceCheck::Next ToleranceCheck::judge()
{
  const double margin = isNamed() ? 1.0 : kMargin;
  const auto isKept = [&] { return m_error && *m_error <= margin * m_asked.tolerance; };
  if (m_failed || m_rough) return end(Next::TakeFormer, isKept()); // as far as a run before has told
  m_finerTolerance = m_settings.tolerance;
  const double ratio =
    m_displacement > 0.0 ? m_apart / m_displacement : std::numeric_limits<double>::infinity();
  m_error = m_error.value_or(0.0) + (m_apart == 0.0 ? 0.0 : std::sqrt(ratio));
  if (!isKept()) return isNamed() ? end(Next::TakeFormer, false) : Next::RunAgain;
  if (isFiner() || !refine()) return end(Next::TakeFormer, true);
  return Next::MeasureAgain;
}

/// Whether this run took more steps than the one that may be the result, in most frames in which that moved:
/// frames with a check take more than their neighbours.
bool ToleranceCheck::isFiner() const noexcept
{
  std::size_t moving = 0, finer = 0;
  for (std::size_t frame = 0; frame < std::min(m_steps.size(), m_resultSteps.size()); ++frame) {
    if (m_resultSteps[frame] == 0) continue;
    ++moving;
    if (static_cast<double>(m_steps[frame]) >= kMoreSteps * static_cast<double>(m_resultSteps[frame]))
      ++finer;
  }
  return static_cast<double>(finer) >= kMostFrames * static_cast<double>(moving);
}

/// Settings for a finer run. @return false: there is none
bool ToleranceCheck::refine()
{
  const double next = kFiner * m_settings.tolerance;
  if (m_runs == kMostRuns || next < kLeastTolerance) return false;
  m_settings.solver = "auto";
  m_settings.fixedStep = 0.0;
  m_settings.tolerance = next;
  m_settings.effort = kMoreEffort * m_asked.effort;
  return true;
}

/// Whether the user has chosen how to step: then that is the result, however far off.
bool ToleranceCheck::isNamed() const noexcept
{
  return m_asked.solver != "auto" || m_asked.fixedStep > 0.0;
}

ToleranceCheck::Next ToleranceCheck::end(Next next, bool kept) noexcept
{
  m_kept = kept;
  m_former.clear();
  return next;
}

std::string ToleranceCheck::why() const
{
  const auto runWith = [](double tolerance) {
    return "a run with a tolerance of " + formatDouble(tolerance, 3);
  };
  const std::string finer = runWith(m_finerTolerance), apart = formatDouble(m_error.value_or(0.0), 3);
  if (m_kept) return "the motion is within " + apart + " of " + finer;
  if (m_runs < 2)
    return m_failed ? "the run itself failed" : "no run can be finer: rounding would be what they differ by";
  if (m_failed) return runWith(m_settings.tolerance) + " failed";
  if (m_rough) return runWith(m_settings.tolerance) + " gave it up, as it would cost too much";
  const std::string where = "t = " + formatDouble(m_worstTime, 3) + " s";
  if (isNamed()) return "the motion is " + apart + " away from " + finer + ", most of all at " + where;
  return "at " + where + " the motion depends on the smallest errors: " + finer +
         " and the one before are still " + apart + " apart";
}

double ToleranceCheck::memory(double frames, double nodes) noexcept
{
  return frames * nodes * 3.0 * sizeof(double);
}

} // namespace esm
