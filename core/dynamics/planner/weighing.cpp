// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/planner/weighing.h"

#include "core/dynamics/system/frame.h"

#include <algorithm>
#include <cmath>

namespace esm {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

} // namespace

double Weighing::stableStep(Method method) const noexcept
{
  return esm::stableStep(m_policy, m_facts, method);
}

bool Weighing::isHeldUp() const noexcept
{
  return kFrame / explicitLimit() > m_policy.choice.manySteps;
}

double Weighing::checkLength() const noexcept
{
  return std::isfinite(m_now.timeLeft) ? m_policy.checks.lengthToEnd : m_policy.checks.length;
}

/// Spring evaluations per frame at the step that the method can take now, as far as known. Where accurate
/// steps would cost more than the effort, those that it pays for, times what these err too much: who fails
/// the least counts, not who would need the least to succeed. A uterus under a tool was left to `chebyshev`,
/// which erred sixty times what plain steps did.
double Weighing::cost(Method method)
{
  if (method == m_facts.implicit()) m_facts.layOut(method);
  const MethodKnowledge& known = m_known.of(method);
  const double stable = std::min(stableStep(method), kFrame);
  const double accurate = std::min({stable, known.accurateStep, known.cheapStep});
  const double step = std::max(accurate, std::min(known.affordableStep, stable)); // 0 for implicit ones
  const double share = std::pow(step / accurate, m_facts.traits(method).order);
  return m_facts.stepCost(method, step) * std::ceil(kFrame / step) * share;
}

/// The same at the largest stable step, whatever it errs.
double Weighing::costAtLimit(Method method)
{
  const double stable = std::min(stableStep(method), kFrame);
  return m_facts.stepCost(method, stable) * std::ceil(kFrame / stable);
}

/// Whether a frame of it could be checked for the effort, or costs no more than plain steps do. Else nobody
/// would ever learn that another one does for less: at coarse tolerances, where that is likely, and once less
/// has been asked for than at first, because the clock could not be kept, it is not taken. A pulled uterus
/// stayed with `stoermer` at a tolerance of 0.2, at a third of the speed.
bool Weighing::isPayable(Method method)
{
  if ((!isLoose() && !m_now.asksForLess) || method == m_facts.plain()) return true;
  return costAtLimit(method) <= std::max(m_now.effort, costAtLimit(m_facts.plain()));
}

/// Nets whose stiff part holds up explicit steps multiply errors a hundredfold when they snap through, and no
/// check before sees it. Explicit steps at their limit err a hundred times less in the slow motion than they
/// may, implicit ones as much as they may. So the former count for less than they cost by this factor, and
/// themselves spend only this part of the budget (at 1e-6 `verlet` spent a third of it and ended at eight
/// times the tolerance): second order at its limit is that good down to 1e-5, higher orders below.
double Weighing::caution() const noexcept
{
  return std::min(1.0,
                  std::pow(m_now.tolerance / m_policy.choice.looseTolerance, m_policy.choice.cautionPower));
}

/// Of the budget, what a method may spend; where dampers hardly brake waves, errors outlive the motion that
/// they were measured against. Implicit steps, which take over in nets that snap through, leave a part of it
/// for what a snap makes of their errors: of 132 runs of 33 such nets 11 miss their tolerance instead of 17,
/// for a fifth more work at 1e-2.
double Weighing::spendable(Method method) const noexcept
{
  const Policy::Choice& policy = m_policy.choice;
  if (!m_facts.traits(method).isExplicit())
    return isHeldUp()
             ? std::min(1.0, std::pow(m_now.tolerance / policy.sparingTolerance, policy.sparingPower))
             : 1.0;
  if (m_now.isAuto && isHeldUp() && !m_now.fewHoldAll) return caution();
  return m_now.isDamped ? 1.0 : m_now.lastingShare;
}

/// Whether what is saved in each frame until the end of the run, if that is known, makes up for a price; both
/// in spring evaluations.
bool Weighing::paysOff(double saving, double price) const noexcept
{
  return saving * m_now.timeLeft / kFrame >= price;
}

/// Whether its twin could take the same step, hardly dearer, and would err no more.
bool Weighing::isOutdone(Method method) const noexcept
{
  const std::optional<Method> sharper = m_facts.traits(method).sharper;
  return sharper && std::min(stableStep(method), m_known.of(method).accurateStep) <= stableStep(*sharper);
}

double Weighing::plainCost()
{
  const double steps = std::ceil(kFrame / explicitLimit());
  return steps * m_facts.stepCost(m_facts.plain(), explicitLimit());
}

/// To ask for less would only lead to methods that cost more.
double Weighing::leastCost()
{
  const double plain = plainCost();
  if (!m_now.isAuto || m_now.isByBlocks || !isHeldUp()) return plain;
  m_facts.layOut(m_facts.implicit());
  return std::min(plain, m_facts.stepCost(m_facts.implicit(), kFrame));
}

/// By one pass for each step at the limit of plain ones, or by local steps where a few nodes set that limit.
bool Weighing::isToleranceTooDear()
{
  double least = m_now.springs * kFrame / explicitLimit();
  for (Method method = 0; m_now.fewHoldAll && method < m_facts.count(); ++method)
    if (m_facts.traits(method).role == MethodRole::Local && m_facts.isLaidOut(method))
      least = std::min(least, cost(method));
  return least > m_now.effort && least > m_policy.choice.tooDear * m_now.leastCost;
}

/// The smallest step of an explicit method that a frame's effort pays for [s]. One may cost some force passes (stages
/// for dampers): to count it as one made steps at the effort's limit too dear, and left a net to descent for them.
double Weighing::affordableStep(Method method)
{
  const bool isPlain = m_facts.traits(method).role != MethodRole::Local; // whose costs are known at once
  const double cost =
    isPlain ? m_facts.stepCost(method, std::min(stableStep(method), kFrame)) : m_now.springs;
  return kFrame * cost / m_now.affordable;
}

Method Weighing::cheapestExplicit(Method present, double patience)
{
  Method best = m_facts.plain();
  double least = kInfinity;
  for (Method method = 0; method < m_facts.count(); ++method) {
    const MethodTraits& traits = m_facts.traits(method);
    const bool isLocal = traits.role == MethodRole::Local;
    if (!traits.competes() || isOutdone(method) || (isLocal && !isHeldUp() && !m_now.fewHoldAll)) continue;
    if (isLocal && !m_facts.isLaidOut(method)) {
      m_facts.layOut(method); // its classes tell its step
      if (!m_known.of(method).isMeasured) m_known.guess(method, m_facts, expectation());
    }
    if (!isPayable(method)) continue;
    const double needed =
      cost(method) * (method == present ? patience : 1.0) / (isLocal ? m_policy.choice.localGain : 1.0);
    if (needed >= least) continue;
    least = needed;
    best = method;
  }
  return best;
}

std::optional<Weighing::Proposal> Weighing::worthAProbe(Method present)
{
  const Policy::Probes& policy = m_policy.probes;
  const double now = cost(present);
  double least = kInfinity;
  std::optional<Proposal> best;
  for (Method method = 0; method < m_facts.count(); ++method) {
    const MethodTraits& traits = m_facts.traits(method);
    const MethodKnowledge& known = m_known.of(method);
    if (traits.role != MethodRole::Explicit || method == present || known.untilProbe > 0) continue;
    const bool isTwin = traits.sharper == present && isLoose();
    if (isOutdone(method) && !isTwin) continue;
    const double atLimit = costAtLimit(method), stable = std::min(stableStep(method), kFrame);
    const double wanted = (isTwin ? policy.twinGain : policy.gain) * now;
    if (atLimit >= std::min(least, wanted) ||
        !paysOff(policy.chance * (now - atLimit), checkLength() / kFrame * atLimit))
      continue;
    const double longer = isTwin ? stableStep(present) : 0.0; // else it is outdone
    const double tried = std::min(stable, std::max({stable * atLimit / wanted, known.accurateStep, longer}));
    if (std::pow(tried / known.accurateStep, traits.order) > policy.hope) continue;
    least = atLimit;
    best = {method, tried};
  }
  return best;
}

Choice Weighing::first()
{
  const Policy::Choice& policy = m_policy.choice;
  const Method implicit = m_facts.implicit();
  Choice choice{cheapestExplicit(m_facts.plain(), 1.0)};
  // Laying out the implicit matrix costs some hundred force passes: not for a net that is soft anyway.
  if (isHeldUp() && !m_now.isByBlocks &&
      (isToleranceTooDear() ||
       caution() * cost(choice.method) > policy.implicitCheaperAtFirst * cost(implicit)))
    choice.method = implicit;
  giveUpTolerance(choice, choice.method == implicit && isToleranceTooDear());
  if (choice.isToleranceGivenUp) m_known.of(implicit).accurateStep = kFrame / policy.boundedGuess;
  return choice;
}

Choice Weighing::reconsider(Choice choice, std::optional<Method> proven)
{
  const Policy::Choice& policy = m_policy.choice;
  const Method before = choice.method, implicit = m_facts.implicit();
  const bool tooDear = isToleranceTooDear();
  if (before == implicit) {
    const Method other = cheapestExplicit(before, m_policy.choice.patience);
    const bool isOnset = isLoose() && m_now.calm < policy.onsetOfImplicit;
    const double most = (isOnset ? policy.mostInOnset : policy.mostAfterOnset) * caution();
    if (!tooDear && cost(implicit) > most * costAtLimit(other)) choice.method = other;
  } else {
    const Method other = proven ? *proven : cheapestExplicit(before, m_policy.choice.patience);
    const double price =
      proven ? 0.0 : (1.0 + m_policy.checks.finer) * checkLength() / kFrame * cost(other); // of its check
    const bool isTwin = m_facts.traits(before).sharper == other && isOutdone(before);
    if (isTwin || paysOff(cost(before) - cost(other), price)) choice.method = other;
    const double accurate = m_known.of(before).accurateStep, stable = explicitLimit();
    if (before == m_facts.plain() && isHeldUp() && accurate > policy.implicitBeyond * stable) {
      m_known.of(implicit).accurateStep = std::min(kFrame, 0.5 * accurate); // like orders, like errors
      if (tooDear || caution() * cost(before) > policy.implicitCheaper * cost(implicit))
        choice.method = implicit;
    }
  }
  giveUpTolerance(choice, tooDear && choice.method == implicit);
  return choice;
}

void Weighing::giveUpTolerance(Choice& choice, bool isGivenUp)
{
  if (isGivenUp && !choice.isToleranceGivenUp) {
    const double affordable = m_now.affordable / m_facts.stepCost(m_facts.implicit(), kFrame);
    choice.floorStep = kFrame / std::clamp(affordable, 1.0, m_policy.choice.mostFloorSteps);
  }
  choice.isToleranceGivenUp = isGivenUp;
}

double Weighing::floorStep(const Choice& choice) const noexcept
{
  if (!m_now.isAuto) return 0.0;
  if (choice.method == m_facts.implicit()) return choice.isToleranceGivenUp ? choice.floorStep : 0.0;
  return m_known.of(choice.method).affordableStep;
}

double Weighing::controlledStep(const Choice& choice, double length) const noexcept
{
  const MethodKnowledge& known = m_known.of(choice.method);
  const double wanted = std::min(known.accurateStep, known.cheapStep);
  return std::min({stableStep(choice.method), std::max(wanted, floorStep(choice)), length});
}

} // namespace esm
