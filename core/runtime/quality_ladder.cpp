// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/runtime/quality_ladder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace esm {

namespace {

constexpr double kHeavyLoad = 0.9, kVeryHeavyLoad = 2.0, kLightLoad = 0.5;
constexpr int kHeavyFrames = 6;                         ///< too many
constexpr double kUnjudgedTime = 0.13;                  ///< after a change
constexpr double kPatience = 1.0, kMostPatience = 60.0; ///< lightness before the way up
constexpr double kRelapse = 3.0;                        ///< down again so soon: up was too early
constexpr double kToleranceFactor = 5.0, kEffortFactor = 4.0;
constexpr int kEffortRungs = 2;

constexpr std::array<std::string_view, 3> kMeasureNames = {"tolerance", "effort", "slow-motion"};

} // namespace

std::vector<QualityMeasure> QualityPlan::usualOrder()
{
  return {QualityMeasure::Tolerance, QualityMeasure::Effort, QualityMeasure::SlowMotion};
}

QualityPlan QualityPlan::clockOnly()
{
  return {{QualityMeasure::SlowMotion}, 0.0, 0.0, std::numeric_limits<double>::infinity()};
}

std::string formatQualityOrder(const std::vector<QualityMeasure>& order)
{
  std::string text;
  for (const QualityMeasure measure : order) {
    if (!text.empty()) text += ',';
    text += kMeasureNames[static_cast<std::size_t>(measure)];
  }
  return text;
}

Result<std::vector<QualityMeasure>> parseQualityOrder(std::string_view text)
{
  std::vector<QualityMeasure> order;
  while (!text.empty()) {
    const std::string_view word = text.substr(0, text.find(','));
    text.remove_prefix(std::min(word.size() + 1, text.size()));
    const auto found = std::find(kMeasureNames.begin(), kMeasureNames.end(), word);
    const auto measure = static_cast<QualityMeasure>(found - kMeasureNames.begin());
    if (found == kMeasureNames.end() || std::find(order.begin(), order.end(), measure) != order.end())
      return Error{ErrorCode::InvalidValue, "\"" + std::string(word) +
                                              "\" is no measure, or the second of its kind; give tolerance, "
                                              "effort and slow-motion in any order"};
    order.push_back(measure);
  }
  return order;
}

QualityLadder::QualityLadder(QualityPlan plan) : m_plan(std::move(plan))
{
  build();
}

void QualityLadder::setPlan(QualityPlan plan)
{
  m_plan = std::move(plan);
  build();
}

void QualityLadder::start(const SolverSettings& wanted)
{
  m_wantedTolerance = wanted.tolerance;
  m_wantedEffort = wanted.effort;
  m_fixedStep = wanted.fixedStep > 0.0;
  build();
}

void QualityLadder::build()
{
  Rung rung{QualityMeasure::SlowMotion, std::max(m_wantedTolerance, m_plan.finest),
            std::min(m_wantedEffort, m_plan.effort)};
  m_rungs = {rung};
  for (const QualityMeasure measure : m_plan.order) {
    if (measure == QualityMeasure::SlowMotion || m_fixedStep) break;
    rung.measure = measure;
    if (measure == QualityMeasure::Effort)
      for (int i = 0; i < kEffortRungs; ++i) {
        rung.effort /= kEffortFactor;
        m_rungs.push_back(rung);
      }
    else
      while (rung.tolerance < m_plan.coarsest) {
        const double next = kToleranceFactor * rung.tolerance;
        rung.tolerance = 1.5 * next > m_plan.coarsest ? m_plan.coarsest : next; // no tiny last step
        m_rungs.push_back(rung);
      }
  }
  rung.measure = QualityMeasure::SlowMotion;
  m_rungs.push_back(rung);
  m_rung = 0;
  m_unjudged = kUnjudgedTime;
  m_heavy = 0;
  m_light = 0.0;
  m_patience = kPatience;
  m_sinceRise = kRelapse;
  m_formerRung = 0;
  m_inMotion = 0.0;
}

bool QualityLadder::endFrame(double took, double period, bool isAtRest) noexcept
{
  const double load = took / period;
  if (!(load >= 0.0) || !std::isfinite(load)) return false;
  const double passed = std::max(took, period);
  m_sinceRise += passed;
  m_inMotion = isAtRest ? 0.0 : m_inMotion + passed;
  if (m_inMotion > kRelapse) m_formerRung = 0; // and it is good
  if (m_unjudged > 0.0) return m_unjudged -= passed, false;
  if (isAtRest && load < kLightLoad) return endRestingFrame(passed);
  m_heavy = load > kHeavyLoad ? m_heavy + (load > kVeryHeavyLoad ? 2 : 1) : std::max(m_heavy - 1, 0);
  // From slow motion back to the clock is no change of accuracy: no room is needed for a dearer rung.
  const double light = accuracyRises() ? kLightLoad : kHeavyLoad;
  m_light = load < light ? m_light + passed : std::max(m_light - 4.0 * passed, 0.0);
  if (m_heavy >= kHeavyFrames && m_rung + 1 < m_rungs.size()) {
    if (std::exchange(m_sinceRise, kRelapse) < kRelapse)
      m_patience = std::min(2.0 * m_patience, kMostPatience);
    return moveTo(std::max(m_rung + 1, std::exchange(m_formerRung, 0)));
  }
  m_heavy = std::min(m_heavy, kHeavyFrames);
  if (m_rung == 0 || m_light < (accuracyRises() ? m_patience : kPatience)) return false;
  if (accuracyRises()) {
    if (m_sinceRise > 4.0 * m_patience) m_patience = kPatience; // the last way up was long good
    m_sinceRise = 0.0;
  }
  return moveTo(m_rung - 1);
}

/// However often a motion was too dear: a rest is no trial, and asks for no patience.
bool QualityLadder::endRestingFrame(double passed) noexcept
{
  m_heavy = 0;
  m_light += passed;
  if (m_rung == 0 || m_light < kPatience) return false;
  m_formerRung = std::max(m_formerRung, m_rung);
  return moveTo(m_rung - 1);
}

bool QualityLadder::accuracyRises() const noexcept
{
  return m_rung > 0 && m_rung + 1 < m_rungs.size();
}

bool QualityLadder::moveTo(std::size_t rung) noexcept
{
  m_rung = rung;
  m_unjudged = kUnjudgedTime;
  m_heavy = 0;
  m_light = 0.0;
  return true;
}

QualityState QualityLadder::state() const noexcept
{
  return {m_rung,
          m_rungs.size() - 1,
          m_rungs[m_rung].measure,
          m_rungs[0].tolerance,
          m_rungs[m_rung].tolerance,
          m_rungs[m_rung].effort};
}

} // namespace esm
