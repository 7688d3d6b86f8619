// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/tolerance_check.h"

#include "core/base/text_number.h"

#include <cmath>
#include <limits>
#include <utility>

namespace esm {
namespace {

constexpr double kFiner = 0.1; ///< the tolerance of a run over that of the one before
/// Of the tolerance, that two runs may be apart: the finer one errs, too. Of 31 runs of the bench's scenes
/// that miss theirs all but one are further apart (that one is of a net that snaps through).
constexpr double kMargin = 0.8;
constexpr double kMoreEffort = 10.0; ///< of a run over the one before: it may take as long as it needs
constexpr int kMostRuns = 5;
/// Where rounding is what runs differ by.
constexpr double kLeastTolerance = 1e-12;

} // namespace

ToleranceCheck::ToleranceCheck(SolverSettings asked) : m_asked(std::move(asked)), m_settings(m_asked) {}

void ToleranceCheck::add(const NetState& state)
{
  if (m_frame == 0) m_start = state.position;
  if (m_runs == 0) {
    m_former.push_back(state.position);
  } else if (m_frame < m_former.size()) {
    Eigen::Matrix3Xd& former = m_former[m_frame];
    const double apart = (state.position - former).squaredNorm();
    m_apart += apart;
    m_displacement += (state.position - m_start).squaredNorm();
    if (apart > m_worst) {
      m_worst = apart;
      m_worstTime = state.time;
    }
    former = state.position;
  }
  ++m_frame;
}

ToleranceCheck::Next ToleranceCheck::endRun(const StepReport& report)
{
  const double tolerance = m_settings.tolerance;
  ++m_runs;
  m_failed = !report.good();
  m_rough = report.rough;
  if (m_runs > 1) {
    m_finerTolerance = tolerance;
    m_error.reset();
    if (m_failed || m_rough) return end(Next::TakeFormer, false, m_resultTolerance);
    const double ratio =
      m_displacement > 0.0 ? m_apart / m_displacement : std::numeric_limits<double>::infinity();
    m_error = m_apart == 0.0 ? 0.0 : std::sqrt(ratio);
    if (isNamed()) return end(Next::TakeFormer, *m_error <= m_asked.tolerance, m_resultTolerance);
    if (*m_error <= kMargin * m_asked.tolerance) return end(Next::TakeFormer, true, m_resultTolerance);
  }
  m_resultTolerance = tolerance;
  const double next = kFiner * tolerance;
  if (m_failed || m_runs == kMostRuns || next < kLeastTolerance) return end(Next::TakeThis, false, tolerance);
  m_settings.solver = "auto";
  m_settings.fixedStep = 0.0;
  m_settings.tolerance = next;
  m_settings.effort *= kMoreEffort;
  m_frame = 0;
  m_apart = m_displacement = m_worst = m_worstTime = 0.0;
  return Next::RunAgain;
}

/// Whether the user has chosen how to step: then that is the result, however far off.
bool ToleranceCheck::isNamed() const noexcept
{
  return m_asked.solver != "auto" || m_asked.fixedStep > 0.0;
}

ToleranceCheck::Next ToleranceCheck::end(Next next, bool kept, double tolerance) noexcept
{
  m_kept = kept;
  m_resultTolerance = tolerance;
  m_former.clear();
  return next;
}

std::string ToleranceCheck::why() const
{
  const std::string finer = "a run with a tolerance of " + formatDouble(m_finerTolerance, 3);
  if (m_runs < 2)
    return m_failed ? "the run itself failed" : "no run can be finer: rounding would be what they differ by";
  if (m_failed) return finer + " failed";
  if (m_rough) return finer + " gave it up, as it would cost too much";
  const std::string apart = formatDouble(*m_error, 3), where = "t = " + formatDouble(m_worstTime, 3) + " s";
  if (m_kept) return "the motion is within " + apart + " of " + finer;
  if (isNamed()) return "the motion is " + apart + " away from " + finer + ", most of all at " + where;
  return "at " + where + " the motion depends on the smallest errors: " + finer +
         " and the one before are still " + apart + " apart";
}

double ToleranceCheck::memory(double frames, double nodes) noexcept
{
  return frames * nodes * 3.0 * sizeof(double);
}

} // namespace esm
