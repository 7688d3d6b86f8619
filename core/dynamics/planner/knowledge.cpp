// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/planner/knowledge.h"

#include "core/dynamics/system/frame.h"

#include <algorithm>
#include <cmath>

namespace esm {
namespace {

/// To the step that would just spend the budget, of which the present one spends this share, over that.
double stepGain(const Policy::Checks& policy, double share, double order) noexcept
{
  const double room = order > policy.highOrder ? policy.roomOfHighOrder : policy.room;
  return share > 0.0 ? std::min(room * std::pow(share, -1.0 / order), policy.mostGain) : policy.mostGain;
}

/// Whether a step that spends this share of the budget stays as it is.
bool isKept(const Policy::Checks& policy, double share) noexcept
{
  return share >= policy.leastShareKept && share <= policy.mostShareKept;
}

} // namespace

double stableStep(const Policy& policy, const MethodFacts& facts, Method method) noexcept
{
  return policy.steps.shareOfStable * facts.limit(method);
}

double Knowledge::mostGrowth(double order) const noexcept
{
  return std::min(m_policy->checks.mostGrowth, std::pow(m_policy->checks.mostErrorGrowth, 1.0 / order));
}

void Knowledge::guessAll(const MethodFacts& facts, const Expectation& expected)
{
  for (Method method = 0; method < m_methods.size(); ++method) {
    MethodKnowledge& here = m_methods[method];
    static_cast<KnownSteps&>(here) = {};
    here.untilProbe = 0;
    here.probeGap = 1;
    here.accurateStep = kFrame / m_policy->choice.implicitGuess;
    if (facts.traits(method).isExplicit()) guess(method, facts, expected);
  }
}

void Knowledge::guess(Method method, const MethodFacts& facts, const Expectation& expected)
{
  const MethodTraits& traits = facts.traits(method);
  const bool areWaves = traits.typicalErrorOfWaves > 0.0 && !expected.isDamped;
  const double typical = areWaves ? traits.typicalErrorOfWaves : traits.typicalError;
  const double gain = expected.tolerance / (typical * expected.typicalShare);
  MethodKnowledge& here = m_methods[method];
  here.accurateStep = here.estimate = facts.limit(method) * std::pow(gain, 1.0 / traits.order);
}

void Knowledge::guessAtLeast(Method method, const MethodFacts& facts, const Expectation& expected)
{
  MethodKnowledge& here = m_methods[method];
  const KnownSteps known = here;
  guess(method, facts, expected);
  if (here.accurateStep < known.accurateStep) static_cast<KnownSteps&>(here) = known;
}

void Knowledge::rescale(const MethodFacts& facts, double change)
{
  for (Method method = 0; method < m_methods.size(); ++method) {
    const double gain = std::pow(change, 1.0 / facts.traits(method).order);
    m_methods[method].accurateStep *= gain;
    m_methods[method].estimate *= gain;
  }
}

/// What has been measured of one of two twins bounds what is known of the other.
void Knowledge::tellTwins(Method measured, const MethodFacts& facts) noexcept
{
  const MethodKnowledge& here = m_methods[measured];
  for (Method method = 0; method < m_methods.size(); ++method) {
    MethodKnowledge& other = m_methods[method];
    if (facts.traits(measured).sharper == method)
      other.accurateStep = std::max(other.accurateStep, here.accurateStep);
    if (facts.traits(method).sharper == measured &&
        here.accurateStep < stableStep(*m_policy, facts, measured))
      other.accurateStep = std::min(other.accurateStep, here.accurateStep);
  }
}

void Knowledge::learnOwn(Method method, const MethodFacts& facts, const Finding& found)
{
  const Policy::Checks& policy = m_policy->checks;
  const MethodTraits& traits = facts.traits(method);
  const double least = traits.isExplicit() ? m_policy->steps.mostShrinking : policy.mostImplicitShrinking;
  double& accurate = m_methods[method].accurateStep;
  accurate = found.step;
  if (!isKept(policy, found.share))
    accurate *= std::clamp(stepGain(policy, found.share, traits.order), least, mostGrowth(traits.order));
}

/// Methods of low order err in slower motion, which changes less: they gain little more than this one, although
/// their order promises it.
void Knowledge::learnOthers(Method method, const MethodFacts& facts, const Finding& found)
{
  const Policy::Checks& policy = m_policy->checks;
  const MethodTraits& traits = facts.traits(method);
  if (!traits.isExplicit()) return;
  MethodKnowledge& here = m_methods[method];
  const double estimate = found.step * stepGain(policy, found.share, traits.order);
  const double change = here.estimate > 0.0 ? estimate / here.estimate : 1.0;
  const double most = mostGrowth(traits.order), power = change > 1.0 ? policy.mostTransfer : 1.0;
  here.estimate = estimate;
  for (Method other = 0; other < m_methods.size(); ++other)
    if (other != method && facts.traits(other).isExplicit() &&
        (here.isMeasured || !m_methods[other].isMeasured))
      m_methods[other].accurateStep *=
        std::clamp(std::pow(change, std::min(power, traits.order / facts.traits(other).order)),
                   policy.leastTransfer, most);
  // Local steps only coarsen what velocity Verlet does: at their step no other explicit method errs more.
  if (traits.role == MethodRole::Local)
    for (Method other = 0; other < m_methods.size(); ++other)
      if (facts.traits(other).isExplicit())
        m_methods[other].accurateStep = std::max(m_methods[other].accurateStep, here.accurateStep);
  here.isMeasured = true;
  tellTwins(method, facts);
}

void Knowledge::learnProbe(Method method, const MethodFacts& facts, const Finding& found)
{
  const Policy::Checks& policy = m_policy->checks;
  MethodKnowledge& here = m_methods[method];
  const double gain = stepGain(policy, found.share, facts.traits(method).order);
  here.accurateStep = found.step;
  here.estimate = here.accurateStep * gain;
  if (!isKept(policy, found.share))
    here.accurateStep *= std::clamp(gain, m_policy->steps.mostShrinking, policy.mostGrowth);
  here.isMeasured = true;
  tellTwins(method, facts);
}

/// Newton's method takes more iterations for larger steps and more factors, until it fails.
void Knowledge::learnCost(Method method, const MethodFacts& facts, double step, double coarseWork,
                          double finerWork) noexcept
{
  if (facts.traits(method).isExplicit()) return;
  MethodKnowledge& here = m_methods[method];
  if (finerWork < m_policy->checks.cheaper * coarseWork)
    here.cheapStep = step / m_policy->checks.finer;
  else
    here.cheapStep *= m_policy->checks.ease;
}

void Knowledge::learnFailure(Method method, const MethodFacts& facts, double step) noexcept
{
  MethodKnowledge& here = m_methods[method];
  here.accurateStep = m_policy->steps.afterFailure * step;
  if (!facts.traits(method).isExplicit()) here.cheapStep = step;
}

void Knowledge::passCheck(double waited) noexcept
{
  for (MethodKnowledge& here : m_methods) {
    here.untilProbe -= static_cast<int>(waited);
    here.probedStep = 0.0;
  }
}

void Knowledge::endProbe(Method method, bool isProven) noexcept
{
  MethodKnowledge& here = m_methods[method];
  here.untilProbe = isProven ? 0 : here.probeGap;
  here.probeGap = isProven ? 1 : std::min(2 * here.probeGap, m_policy->probes.longestGap);
}

} // namespace esm
