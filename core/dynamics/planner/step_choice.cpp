// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT

// The part of StepDriver that chooses the method.
#include "core/dynamics/planner/step_driver.h"
#include "core/dynamics/system/diagonal.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace esm {
namespace {

/// Implicit steps per frame to begin with; measured from then on. Nets with stiffness over six decades take
/// 25 and more. With 4 tubes and uteri of a hundred and a thousand times their stiffness went implicit at
/// first, where explicit steps cost a third of it. But 4 where they only have to stay bounded.
constexpr double kImplicitGuess = 16.0, kBoundedGuess = 4.0;

/// Of what plain steps cost: local ones must be that cheap. They err as much as they may, plain ones at their
/// limit of stability a hundred times less: for a twentieth saved in three frames a stiff net that snaps
/// through ended at fourteen times a tolerance of 1e-3.
constexpr double kLocalGain = 0.6;
/// After an event: what implicit steps cost in it tells little of what they cost later [s].
constexpr double kOnsetOfImplicit = 1.9 * kFrame;
/// Of what explicit steps cost at their limit: implicit ones are left where they cost more, within that time
/// and after it. Without the first a tube of a thousand times its stiffness that was let go took 440,000 of
/// them in a frame, 1.8 million force passes, where `stoermer` takes 55,000.
constexpr double kMostInOnset = 8.0, kMostAfterOnset = 1.5;

/// A length that positions are small or large against [m]: the net's diagonal, or how far its anchors pull.
double extentOf(const System& system, const NodeArray& x)
{
  double square = squareOfDiagonal(x);
  for (const ForceModel::Anchor& anchor : system.forces().anchors()) {
    const Lanes reach = anchor.point - x[static_cast<std::size_t>(anchor.node)];
    square = std::max(square, dot(reach, reach));
  }
  return square > 0.0 && std::isfinite(square) ? std::sqrt(square) : 1.0;
}

} // namespace

StepDriver::StepDriver(SolverSettings settings, std::vector<Index> names)
  : m_settings(std::move(settings)),
    m_firstTolerance(m_settings.tolerance),
    m_firstEffort(m_settings.effort),
    m_names(std::move(names))
{
  m_auto = m_settings.solver == "auto";
  const std::span<const IntegratorEntry> table = integratorTable();
  for (const IntegratorEntry& entry : table) {
    const Method place = m_candidates.size();
    if (entry.name == "leapfrog") m_leapfrog = place;
    if (entry.name == "descent") m_descent = place;
    if (entry.name == "block-descent") m_blocks = place;
    if (entry.role == MethodRole::Implicit) m_implicit = place;
    if (entry.name == m_settings.solver) m_method = place;
    m_candidates.push_back(
      {{}, entry.make(), entry.role, entry.typicalError, entry.offset, entry.typicalErrorOfWaves});
    const auto twin = std::ranges::find(table, entry.sharperTwin, &IntegratorEntry::name);
    if (twin != table.end()) m_candidates.back().sharper = static_cast<Method>(twin - table.begin());
  }
  m_onset.known.resize(m_candidates.size());
}

void StepDriver::begin(System& system, const MotionState& state)
{
  m_places.clear();
  m_start = state;
  m_startEnergies.reset();
  if (system.nodeCount() <= System::kLarge) { // room for later
    m_coarse = m_coarseV = m_look.x = state.x;
    m_probe = state;
  }
  const bool isDriven = !system.schedule().isEmpty() || !system.tools().empty();
  m_gauge.begin(state.x, extentOf(system, state.x), m_settings.duration, isDriven);
  const Lanes weight = system.nodeCount() > 0 ? system.forces().weight(0) : Lanes{0, 0, 0, 0};
  const bool staysPushed = !system.tools().empty() || dot(weight, weight) > 0.0;
  m_gauge.expectQuiet(staysPushed ? kInfinity : system.schedule().endOfBlows());
  if (m_auto) m_method = m_leapfrog; // a run after reset() is like the first one
  parametersChanged(system, state);
  // What a look at the bound needs of a large net is a quarter of all its memory, and it may never move.
  if (system.nodeCount() > System::kLarge) m_bound.freeRoom();
}

void StepDriver::parametersChanged(System& system, const MotionState& state)
{
  for (Candidate& candidate : m_candidates) candidate.prepared = false;
  m_untilCheck = 0;
  m_checkGap = 1;
  m_checkedError = m_checkedPower = m_errorOverLocal = 0.0;
  m_checkedTime = state.time;
  m_growing = 1.0;
  m_settled = m_descents = m_descentTerm = 0;
  m_grown = 0.0;
  m_onset.longest = 0.0;
  m_toleranceGivenUp = m_roughAtCheck = false;
  m_floorStep = 0.0;
  findBodies(system, state);
  m_bound.prepare(asksForDecay());
  m_loss.prepare(system);
  m_unseen.isOpen = false;
  setBound(system, state);
  guessSteps();
  choose(system, state);
}

/// Accurate steps before anything has been measured.
void StepDriver::guessSteps()
{
  for (Candidate& candidate : m_candidates) {
    candidate.accurateStep = kFrame / kImplicitGuess;
    candidate.cheapStep = kInfinity;
    candidate.estimate = 0.0;
    candidate.isMeasured = false;
    candidate.untilProbe = 0;
    candidate.probeGap = 1;
    if (isExplicit(candidate)) guessStep(candidate);
  }
}

void StepDriver::guessStep(Candidate& candidate) const noexcept
{
  const bool areWaves = candidate.typicalErrorOfWaves > 0.0 && !isDamped();
  const double typical = areWaves ? candidate.typicalErrorOfWaves : candidate.typicalError;
  const double gain = m_settings.tolerance / (typical * m_gauge.typicalShare());
  candidate.accurateStep = candidate.estimate =
    candidate.integrator->stableStep(m_mode) * std::pow(gain, 1.0 / candidate.integrator->order());
}

/// The guess, unless more is known to do.
void StepDriver::guessStepAtLeast(Candidate& candidate) const noexcept
{
  const Knowledge known = candidate;
  guessStep(candidate);
  if (candidate.accurateStep < known.accurateStep) static_cast<Knowledge&>(candidate) = known;
}

void StepDriver::findBodies(const System& system, const MotionState& state)
{
  m_bodies.find(system);
  m_bodies.begin(system, state);
}

void StepDriver::restart(const System& system, const MotionState& state)
{
  forget();
  findBodies(system, state);
}

void StepDriver::forget() noexcept
{
  for (Candidate& candidate : m_candidates)
    if (candidate.prepared) candidate.integrator->restart();
}

void StepDriver::toolsChanged(System& system, const MotionState& state, bool sameNodes)
{
  m_unseen.isOpen = false; // under other forces
  if (!system.tools().empty()) {
    m_gauge.markDriven();
    m_gauge.expectQuiet(kInfinity);
  }
  followHand(system);
  if (sameNodes) { // a moving hand: the checks go on in their rhythm
    for (Candidate& candidate : m_candidates)
      if (candidate.prepared) candidate.integrator->toolsMoved();
    return;
  }
  forget();
  findBodies(system, state);
  replaceBound(system, state, boundMatters(system));
  m_untilCheck = 0;
  m_checkGap = 1;
}

void StepDriver::partChanged(System& system, const MotionState& state, NetPart part)
{
  m_gauge.setPart(part.rest, part.wholeCount, part.squareElsewhere);
  m_places = std::move(part.nodes);
  m_onset.longest = 0.0;
  m_grown = 0.0; // what a larger part had gained could be more than all that this one has
  for (Candidate& candidate : m_candidates) candidate.prepared = false;
  findBodies(system, state);
  m_bound.prepare(asksForDecay());
  m_loss.prepare(system);
  m_unseen.isOpen = false;
  replaceBound(system, state, !m_byBlocks);
  giveToleranceUp(system, m_toleranceGivenUp && toleranceIsTooDear(system));
  if (!m_byBlocks) layOut(m_method, system); // nothing is, after another cut
  explain();
}

void StepDriver::setAccuracy(const System& system, double tolerance, double effort)
{
  const double change = tolerance / m_settings.tolerance;
  m_settings.tolerance = tolerance;
  m_settings.effort = effort;
  if (m_settings.keepsTime) weighLeastCost(system);
  m_onset.longest = 0.0;
  for (Candidate& candidate : m_candidates) { // what the error's order says, until the next check
    if (!candidate.integrator) continue;
    weighEffort(system, candidate);
    const double gain = std::pow(change, 1.0 / candidate.integrator->order());
    candidate.accurateStep *= gain;
    candidate.estimate *= gain;
  }
  m_untilCheck = 0;
  m_checkGap = 1;
  m_settled = 0;
  m_roughAtCheck = false;
  if (m_auto && competes(m_candidates[m_method]) && !isPayable(m_method, system)) {
    use(cheapestExplicit(system, 1.0));
    explain();
  }
  if (!m_toleranceGivenUp) return;
  giveToleranceUp(system, false); // the floor is of the former effort
  giveToleranceUp(system, toleranceIsTooDear(system));
  explain();
}

/// Unless that is done.
void StepDriver::layOut(Method method, const System& system)
{
  Candidate& candidate = m_candidates[method];
  if (candidate.prepared) return;
  candidate.integrator->prepare(system);
  candidate.prepared = true;
}

void StepDriver::use(Method method)
{
  m_method = method;
  m_candidates[method].isMeasured = false; // a guess that fails says nothing about the others
  current().restart();
  m_untilCheck = 0;
  m_checkGap = 1;
}

/// Whether Integrator::asksForDecay() holds for any method that may run.
bool StepDriver::asksForDecay() const noexcept
{
  if (!m_auto) return m_candidates[m_method].integrator->asksForDecay();
  return std::any_of(m_candidates.begin(), m_candidates.end(), [](const Candidate& candidate) {
    return competes(candidate) && candidate.integrator->asksForDecay();
  });
}

/// Whether its twin could take the same step, hardly dearer, and would err no more.
bool StepDriver::isOutdone(Method method) const noexcept
{
  const Candidate& candidate = m_candidates[method];
  return candidate.sharper && std::min(stableStep(candidate), candidate.accurateStep) <=
                                stableStep(m_candidates[*candidate.sharper]);
}

/// What has been measured of one of two twins bounds what is known of the other.
void StepDriver::tellTwins(Method measured) noexcept
{
  const Candidate& here = m_candidates[measured];
  for (Method method = 0; method < m_candidates.size(); ++method) {
    Candidate& other = m_candidates[method];
    if (here.sharper == method) other.accurateStep = std::max(other.accurateStep, here.accurateStep);
    if (other.sharper == measured && here.accurateStep < stableStep(here))
      other.accurateStep = std::min(other.accurateStep, here.accurateStep);
  }
}

/// Among those that compete.
/// @param patience  the present one's cost counts as this share of it: a change must pay
StepDriver::Method StepDriver::cheapestExplicit(const System& system, double patience)
{
  Method best = m_leapfrog;
  double least = kInfinity;
  for (Method method = 0; method < m_candidates.size(); ++method) {
    Candidate& candidate = m_candidates[method];
    const bool isLocal = candidate.role == MethodRole::Local;
    if (!competes(candidate) || isOutdone(method) || (isLocal && !isHeldUp() && !m_fewHoldAll)) continue;
    if (isLocal && !candidate.prepared) {
      layOut(method, system); // its classes tell its step
      if (!candidate.isMeasured) guessStep(candidate);
    }
    if (!isPayable(method, system)) continue;
    const double needed =
      cost(method, system) * (method == m_method ? patience : 1.0) / (isLocal ? kLocalGain : 1.0);
    if (needed >= least) continue;
    least = needed;
    best = method;
  }
  return best;
}

/// The method that would be cheapest at its stability limit, and cheap enough to change to, of those whose
/// turn it is and whose errors, by what is known or guessed, leave a hope.
/// @param step  receives the smallest with which it would be cheap enough [s]
std::optional<StepDriver::Method> StepDriver::worthAProbe(System& system, double& step)
{
  constexpr double kGain = 0.7;      // of the present cost: below the patience of reconsider()
  constexpr double kTwinGain = 0.85; // the same for longer steps of its twin, at coarse tolerances
  constexpr double kHope = 20.0;     // of the budget: guesses are that far off
  constexpr double kChance = 0.3;    // that a probe succeeds
  const double present = cost(m_method, system);
  double least = kInfinity;
  std::optional<Method> best;
  for (Method method = 0; method < m_candidates.size(); ++method) {
    Candidate& candidate = m_candidates[method];
    if (candidate.role != MethodRole::Explicit || method == m_method || candidate.untilProbe > 0) continue;
    const bool isTwin = candidate.sharper == m_method && m_settings.tolerance >= kLooseTolerance;
    if (isOutdone(method) && !isTwin) continue;
    const double atLimit = costAtLimit(method, system), stable = std::min(stableStep(candidate), kFrame);
    const double wanted = (isTwin ? kTwinGain : kGain) * present;
    if (atLimit >= std::min(least, wanted) ||
        !paysOff(kChance * (present - atLimit), checkLength() / kFrame * atLimit))
      continue;
    const double longer = isTwin ? stableStep(m_candidates[m_method]) : 0.0; // else it is outdone
    const double tried =
      std::min(stable, std::max({stable * atLimit / wanted, candidate.accurateStep, longer}));
    if (std::pow(tried / candidate.accurateStep, candidate.integrator->order()) > kHope) continue;
    least = atLimit;
    best = method;
    step = tried;
  }
  return best;
}

void StepDriver::choose(System& system, const MotionState&)
{
  if (m_auto) {
    m_method = cheapestExplicit(system, 1.0);
    m_toleranceGivenUp = false;
    // Laying out the implicit matrix costs some hundred force passes: not for a net that is soft anyway.
    if (isHeldUp() && !m_byBlocks &&
        (toleranceIsTooDear(system) || caution() * cost(m_method, system) > 2.0 * cost(m_implicit, system)))
      m_method = m_implicit;
    giveToleranceUp(system, m_method == m_implicit && toleranceIsTooDear(system));
    if (m_toleranceGivenUp) m_candidates[m_implicit].accurateStep = kFrame / kBoundedGuess;
  }
  use(m_method);
  explain();
}

/// Of what the present method costs, below which another one must be. What a jerk asks for is soon over in a
/// damped net: at coarse tolerances nobody changes for a little then.
double StepDriver::patience() const noexcept
{
  const bool isJerk =
    m_settings.tolerance >= kLooseTolerance && m_gauge.scale().calm <= kLatestOnset && m_onset.longest <= 0.0;
  return isJerk && isDamped() ? 0.7 : 0.9;
}

/// After a check: would another method have done it for less?
/// @param proven  one that has been probed and found good
void StepDriver::reconsider(System& system, std::optional<Method> proven)
{
  if (!m_auto || (--m_settled > 0 && !proven)) return;
  const Method before = m_method;
  const bool tooDear = toleranceIsTooDear(system);
  if (before == m_implicit) {
    const Method other = cheapestExplicit(system, patience());
    const bool isOnset = m_settings.tolerance >= kLooseTolerance && m_gauge.scale().calm < kOnsetOfImplicit;
    const double most = (isOnset ? kMostInOnset : kMostAfterOnset) * caution();
    if (!tooDear && cost(m_implicit, system) > most * costAtLimit(other, system)) m_method = other;
  } else {
    const Method other = proven ? *proven : cheapestExplicit(system, patience());
    const double price =
      proven ? 0.0 : (1.0 + kFiner) * checkLength() / kFrame * cost(other, system); // of its check
    const bool isTwin = m_candidates[before].sharper == other && isOutdone(before);
    if (isTwin || paysOff(cost(before, system) - cost(other, system), price)) m_method = other;
    const double accurate = m_candidates[before].accurateStep, stable = explicitLimit();
    if (before == m_leapfrog && isHeldUp() && accurate > 4.0 * stable) {
      m_candidates[m_implicit].accurateStep = std::min(kFrame, 0.5 * accurate); // like orders, like errors
      if (tooDear || caution() * cost(before, system) > 3.0 * cost(m_implicit, system)) m_method = m_implicit;
    }
  }
  giveToleranceUp(system, tooDear && m_method == m_implicit);
  if (m_method == before) return;
  use(m_method);
  m_settled = kSettling;
  if (proven == m_method) { // it need not prove itself twice
    m_candidates[m_method].isMeasured = true;
    m_untilCheck = m_checkGap = 2;
  }
  explain();
}

void StepDriver::giveToleranceUp(const System& system, bool yes)
{
  if (yes && !m_toleranceGivenUp) {
    const double affordable = effort(system) / m_candidates[m_implicit].integrator->stepCost(system, kFrame);
    m_floorStep = kFrame / std::clamp(affordable, 1.0, 64.0);
  }
  m_toleranceGivenUp = yes;
}

double StepDriver::floorStep() const noexcept
{
  if (!m_auto) return 0.0;
  if (m_method == m_implicit) return m_toleranceGivenUp ? m_floorStep : 0.0;
  return m_candidates[m_method].affordableStep;
}

} // namespace esm
