// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// The part of StepDriver that weighs what steps cost, and what they may.
#include "core/dynamics/planner/step_driver.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace esm {
namespace {

/// Explicit steps per frame beyond which it pays to lay out the other ways and weigh them.
constexpr double kManySteps = 500.0;
/// Below, implicit steps spend less than their budget where explicit ones are held up.
constexpr double kSparingTolerance = 0.1;

} // namespace

/// Spring evaluations per frame at the step that the method can take now, as far as known. Where accurate
/// steps would cost more than the effort, those that it pays for, times what these err too much: who fails
/// the least counts, not who would need the least to succeed. A uterus under a tool was left to `chebyshev`,
/// which erred sixty times what plain steps did.
double StepDriver::cost(Method method, const System& system)
{
  if (method == m_implicit) layOut(method, system);
  Candidate& candidate = m_candidates[method];
  const double stable = std::min(stableStep(candidate), kFrame);
  const double accurate = std::min({stable, candidate.accurateStep, candidate.cheapStep});
  const double step = std::max(accurate, std::min(candidate.affordableStep, stable)); // 0 for implicit ones
  const double share = std::pow(step / accurate, candidate.integrator->order());
  return candidate.integrator->stepCost(system, step) * std::ceil(kFrame / step) * share;
}

/// The same at the largest stable step, whatever it errs.
double StepDriver::costAtLimit(Method method, const System& system)
{
  Candidate& candidate = m_candidates[method];
  const double stable = std::min(stableStep(candidate), kFrame);
  return candidate.integrator->stepCost(system, stable) * std::ceil(kFrame / stable);
}

/// For a frame, that the work limit bears, too. What a tolerance may ask for is told by the former alone: it
/// may be had by other steps for less.
double StepDriver::effort(const System& system) const noexcept
{
  const auto springs = static_cast<double>(std::max<std::int64_t>(system.forces().activeSprings(), 1));
  return m_settings.workLimit > 0.0 ? std::min(m_settings.effort, m_settings.workLimit * springs)
                                    : m_settings.effort;
}

/// Whether a frame of it could be checked for the effort, or costs no more than plain steps do. Else nobody
/// would ever learn that another one does for less: at coarse tolerances, where that is likely, and once less
/// has been asked for than at first, because the clock could not be kept, it is not taken. A pulled uterus
/// stayed with `stoermer` at a tolerance of 0.2, at a third of the speed.
bool StepDriver::isPayable(Method method, const System& system)
{
  const bool isLess = m_settings.tolerance > m_firstTolerance || m_settings.effort < m_firstEffort;
  if ((m_settings.tolerance < kLooseTolerance && !isLess) || method == m_leapfrog) return true;
  return costAtLimit(method, system) <= std::max(m_settings.effort, costAtLimit(m_leapfrog, system));
}

/// Nets whose stiff part holds up explicit steps multiply errors a hundredfold when they snap through, and no
/// check before sees it. Explicit steps at their limit err a hundred times less in the slow motion than they
/// may, implicit ones as much as they may. So the former count for less than they cost by this factor, and
/// themselves spend only this part of the budget (at 1e-6 `verlet` spent a third of it and ended at eight
/// times the tolerance): second order at its limit is that good down to 1e-5, higher orders below. With a
/// power of 0.4 two of twelve stiff nets at 1e-3 were left to implicit steps, one ended at 7.3 times that.
double StepDriver::caution() const noexcept
{
  return std::min(1.0, std::pow(m_settings.tolerance / kLooseTolerance, 0.6));
}

/// Of the budget, what a method may spend; where dampers hardly brake waves, errors outlive the motion that
/// they were measured against. Implicit steps, which take over in nets that snap through, leave a part of it
/// for what a snap makes of their errors: of 132 runs of 33 such nets 11 miss their tolerance instead of 17,
/// for a fifth more work at 1e-2.
double StepDriver::spendable(const Candidate& candidate) const noexcept
{
  if (!isExplicit(candidate))
    return isHeldUp() ? std::min(1.0, std::pow(m_settings.tolerance / kSparingTolerance, 0.3)) : 1.0;
  if (m_auto && isHeldUp() && !m_fewHoldAll) return caution();
  return isDamped() ? 1.0 : m_gauge.lastingShare(m_settings.tolerance, m_start.time);
}

/// The largest step that one force pass can take [s].
double StepDriver::explicitLimit() const noexcept
{
  return m_candidates[m_leapfrog].integrator->stableStep(m_mode);
}

/// Whether explicit steps are so many that other ways are worth weighing.
bool StepDriver::isHeldUp() const noexcept
{
  return kFrame / explicitLimit() > kManySteps;
}

/// Whether dampers brake the fastest waves more than springs throw them.
bool StepDriver::isDamped() const noexcept
{
  return m_mode.damping * m_mode.damping > m_mode.stiffness;
}

/// Whether what is saved in each frame until the end of the run, if that is known, makes up for a price; both
/// in spring evaluations.
bool StepDriver::paysOff(double saving, double price) const noexcept
{
  return saving * (knownEnd(m_start.time) - m_start.time) / kFrame >= price;
}

/// A small net's factor costs less than a frame, and implicit steps err less: but not than what a hand leads, which
/// hardly swings.
bool StepDriver::mayTakeBlocks(const System& system) const noexcept
{
  constexpr std::size_t kFewNodes = 500;
  return m_auto && m_settings.keepsTime && (isLedByBlocks() || system.nodeCount() > kFewNodes);
}

/// What a net that keeps time is moved by depends on what plain steps cost, of which the rest is a multiple. Where a
/// hand leads it, blocks cost less whatever these do, as long as their error is within the tolerance.
bool StepDriver::wantsBlocks(const System& system, double plainCost) const noexcept
{
  constexpr double kBack = 0.7; // of the effort, below which plain steps return
  if (!mayTakeBlocks(system)) return false;
  return isLedByBlocks() || plainCost > (m_byBlocks ? kBack : 1.0) * effort(system);
}

/// Whether what blocks are told to err is no more than may be.
bool StepDriver::areBlocksWithin() const noexcept
{
  const ErrorScale& scale = m_gauge.scale();
  return scale.beyond <= m_settings.tolerance * scale.displacement;
}

/// What moves the net keeps leading it while it stays, until it lets go.
void StepDriver::followHand(const System& system)
{
  const std::vector<ToolSpring>& tools = system.tools();
  const auto moves = [](const ToolSpring& tool) { return tool.isLed(); };
  const bool leads = !tools.empty() && (m_handLeads || std::any_of(tools.begin(), tools.end(), moves));
  if (std::exchange(m_handLeads, leads) == leads || !m_settings.keepsTime) return;
  m_blocksSuffice = m_settings.tolerance >= kLooseTolerance;
  m_untilRoughCheck = m_roughCheckGap > kRoughCheckGap ? m_roughCheckGap : kSecondBlock;
  weighLeastCost(system);
}

/// The time was over before the frame was: the next one, two, four, ... stretches take what always gets on.
void StepDriver::comeDown() noexcept
{
  if (!m_auto || !m_settings.keepsTime || m_byBlocks) return;
  m_descentTerm = std::clamp(2 * m_descentTerm, 1, kLongestDescent);
  m_descents = m_descentTerm;
}

/// What a frame costs at least: plain steps at their limit or, where these are many, one implicit step. To
/// ask for less would only lead to methods that cost more.
void StepDriver::weighLeastCost(const System& system)
{
  const double steps = std::ceil(kFrame / explicitLimit());
  m_leastCost = steps * m_candidates[m_leapfrog].integrator->stepCost(system, explicitLimit());
  m_byBlocks = wantsBlocks(system, m_leastCost);
  if (!m_auto || m_byBlocks || !isHeldUp()) return;
  layOut(m_implicit, system);
  m_leastCost = std::min(m_leastCost, m_candidates[m_implicit].integrator->stepCost(system, kFrame));
}

/// By one pass for each step at the limit of plain ones, or by local steps where a few nodes set that limit.
bool StepDriver::toleranceIsTooDear(const System& system)
{
  const auto springs = static_cast<double>(system.forces().activeSprings());
  double least = springs * kFrame / explicitLimit();
  for (Method method = 0; m_fewHoldAll && method < m_candidates.size(); ++method)
    if (m_candidates[method].role == MethodRole::Local && m_candidates[method].prepared)
      least = std::min(least, cost(method, system));
  return least > m_settings.effort && least > 1.5 * m_leastCost;
}

/// The smallest steps that a frame's effort pays for. One may cost some force passes (stages for dampers): to
/// count it as one made steps at the effort's limit too dear, and left a net to descent for them.
void StepDriver::weighEffort(const System& system, Candidate& candidate) const
{
  if (!isExplicit(candidate)) return;
  const bool isPlain = candidate.role != MethodRole::Local; // whose costs are known before it is laid out
  const double cost = isPlain
                        ? candidate.integrator->stepCost(system, std::min(stableStep(candidate), kFrame))
                        : static_cast<double>(system.forces().activeSprings());
  candidate.affordableStep = kFrame * cost / effort(system);
}

/// Of a step, in force passes; an implicit one counts as one.
double StepDriver::passesOf(const System& system, double step)
{
  return m_method == m_implicit
           ? 1.0
           : current().stepCost(system, step) / std::max(system.forces().passCost(), 1.0);
}

} // namespace esm
