// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/methods/incremental_descent.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace esm {
namespace {

constexpr double kAtBottom = 1e-8;         ///< of the potential, above its rounding
constexpr int kMostPulls = 8;              ///< back to the start, see step()
constexpr double kShortest = 1.0 / 4096.0; ///< of a Newton step [1]

/// Of the nodes that nobody holds or moves [J]: what supports carry is theirs.
double freeKinetic(const System& system, const NodeArray& v) noexcept
{
  double energy = 0.0;
  for (std::size_t i = 0; i < v.size(); ++i)
    if (system.isFree(i)) energy += 0.5 * system.mass()[i] * dot(v[i], v[i]);
  return energy;
}

} // namespace

void IncrementalDescent::prepare(const System& system)
{
  for (NodeArray* array : {&m_x, &m_y, &m_trial, &m_w, &m_force, &m_change})
    array->assign(system.nodeCount(), Lanes{0, 0, 0, 0});
  m_damper.assign(system.forces().damperSize(), Lanes{0, 0, 0, 0});
  layOut(system);
}

double IncrementalDescent::stableStep(const FastestMode&) const noexcept
{
  return std::numeric_limits<double>::infinity();
}

double IncrementalDescent::stepCost(const System& system, double /*h*/)
{
  const auto springs = static_cast<double>(system.forces().activeSprings());
  return m_effort.usual * (matrixCost(system) + 6.0 * springs);
}

StepResult IncrementalDescent::run(System& system, MotionState& state, double end, std::int64_t steps,
                                   StepReport& report)
{
  const double begin = state.time, h = (end - begin) / static_cast<double>(steps), limit = system.workLimit;
  StepResult result = StepResult::Done;
  for (std::int64_t i = 1; i <= steps && result == StepResult::Done; ++i) {
    const double stepEnd = i == steps ? end : begin + static_cast<double>(i) * h;
    if (i < steps) system.workLimit = system.shareOfWork(limit, steps - i + 1);
    result = Integrator::run(system, state, stepEnd, 1, report);
    system.workLimit = limit;
  }
  return result;
}

StepResult IncrementalDescent::step(System& system, MotionState& state, double h, double end,
                                    StepReport& report)
{
  ++report.steps;
  m_x = state.x; // same size: no allocation
  m_w = state.v;
  system.place(end, m_x, m_w);
  const Goal goal{state.v, h, end};
  const double elastic = system.elasticEnergy(state.x), before = elastic + system.weightEnergy(state.x);
  const double freely = freeKinetic(system, state.v), own = freely + std::max(elastic, 0.0);
  const double moved = system.schedule().movesAnyNow() ? system.storedEnergy(m_x) : before;
  if (!std::isfinite(before) || !std::isfinite(moved)) return StepResult::NonFinite;
  Sums sums = descend(system, goal, start(system, goal, freely + moved), own, report);
  if (!std::isfinite(sums.stored)) return StepResult::NonFinite;
  double work = 0.0, left = 0.0;
  int pull = 0;
  for (;; ++pull) {
    if (!allFinite(m_y, m_w)) return StepResult::NonFinite;
    work = sums.loadWork + h * (sums.heatPower + dragPower(system, sums));
    left = freely + moved - sums.stored + work;
    if (left >= 0.0 || pull > kMostPulls) break;
    // A moving support or tool worked through its dampers less than the descent took: not so far.
    for (std::size_t i = 0; i < m_y.size(); ++i)
      m_y[i] = pull < kMostPulls ? m_x[i] + (m_y[i] - m_x[i]) * 0.25 : m_x[i];
    sums = look(system, goal, m_y);
  }
  report.rough = report.rough || !m_isDone || pull > 0;
  // The trapezoidal rule, of next order, would have gone by the mean of both velocities.
  m_localError += 0.5 * h * std::sqrt(sumOfSquares(m_w, goal.v)) + m_unsolved;
  const double kinetic = freeKinetic(system, m_w);
  if (kinetic > left) {
    const double share = std::sqrt(std::max(left, 0.0) / kinetic);
    for (std::size_t i = 0; i < m_w.size(); ++i)
      if (system.isFree(i)) m_w[i] *= share;
  }
  const double heat = h * sums.heatPower;
  const double kineticBefore = system.kineticEnergy(state.v), kineticLeft = system.kineticEnergy(m_w);
  // Energy that has come without the loads' work supports have put in.
  const double appeared = (sums.stored - before) + (kineticLeft - kineticBefore) + heat - work;
  if (appeared > 0.0) state.loan.lend(appeared, own);
  state.settle(std::max(-appeared, 0.0), heat, kineticLeft + std::max(sums.elastic, 0.0));
  state.advanceTo(end, m_y, m_w, work, heat);
  return StepResult::Done;
}

/// P and its parts at y; sets m_w to the velocity that leads there, m_force to - h dP/dy of the free nodes.
IncrementalDescent::Sums IncrementalDescent::look(System& system, const Goal& goal, NodeArray& y) noexcept
{
  Sums sums;
  system.sweepNodes([&](std::size_t first, std::size_t count) noexcept {
    slopesTo(count, 1.0 / goal.h, system.inverseMass().data() + first, m_x.data() + first, y.data() + first,
             m_w.data() + first);
  });
  // The sum of f w; what it leaves in m_force is overwritten.
  sums.loadWork = goal.h * system.addLoads(goal.end, m_w, m_force);
  const Rates rates = system.evaluate(goal.end, y, m_w, m_force, m_damper.data()); // places the supports
  sums.heatPower = rates.heat;
  sums.elastic = system.elasticEnergy(y);
  sums.stored = sums.elastic + system.weightEnergy(y);
  const double inertia = system.sumNodes([&](std::size_t first, std::size_t count) noexcept {
    double sum = 0.0;
    for (std::size_t i = first; i < first + count; ++i) {
      if (!system.isFree(i)) {
        m_force[i] = Lanes{0, 0, 0, 0};
        continue;
      }
      const Lanes jump = m_w[i] - goal.v[i];
      sum += 0.5 * system.mass()[i] * dot(jump, jump);
      m_force[i] = m_force[i] * goal.h - jump * system.mass()[i];
    }
    return sum;
  });
  sums.potential = inertia + sums.stored - sums.loadWork + 0.5 * goal.h * sums.heatPower;
  return sums;
}

/// Power [W] of all viscous forces on the free nodes at y and w, of which this was the last look. What the
/// dampers turn into heat beyond what they take from the nodes, moving supports and tools have put in.
double IncrementalDescent::dragPower(System& system, const Sums& sums) noexcept
{
  const auto leads = [](const ToolSpring& tool) { return !tool.targetVelocity.isZero(0.0); };
  if (!system.schedule().movesAnyNow() && std::ranges::none_of(system.tools(), leads)) return -sums.heatPower;
  std::fill(m_trial.begin(), m_trial.end(), Lanes{0, 0, 0, 0});
  system.addDamping(m_damper.data(), m_w, m_trial);
  const std::vector<double>& own = system.forces().nodeViscosity();
  double power = 0.0;
  for (std::size_t i = 0; i < m_w.size(); ++i)
    if (system.isFree(i))
      power += dot(m_trial[i], m_w[i]) - (own.empty() ? 0.0 : own[i] * dot(m_w[i], m_w[i]));
  for (const ToolSpring& tool : system.tools()) {
    const auto i = static_cast<std::size_t>(tool.node);
    if (system.isFree(i)) power += tool.viscosity * dot(toLanes(tool.targetVelocity), m_w[i]);
  }
  return power;
}

/// The first y: where the velocity leads, if P is less there than at rest; else at rest.
/// @param atRest  P there without the dampers that supports move, which is no more than P [J]
IncrementalDescent::Sums IncrementalDescent::start(System& system, const Goal& goal, double atRest) noexcept
{
  if (m_effort.coasts) {
    for (std::size_t i = 0; i < m_y.size(); ++i)
      m_y[i] = system.isFree(i) ? m_x[i] + goal.v[i] * goal.h : m_x[i];
    const Sums sums = look(system, goal, m_y);
    if (sums.potential <= atRest) return sums;
  }
  m_y = m_x; // same size: no allocation
  return look(system, goal, m_y);
}

/// @param own  that the net had before supports moved: more than that is left of a jump
IncrementalDescent::Sums IncrementalDescent::descend(System& system, const Goal& goal, Sums best, double own,
                                                     StepReport& report)
{
  const auto isFree = [](double inverseMass) { return inverseMass > 0.0; };
  m_isDone = std::ranges::none_of(system.inverseMass(), isFree);
  if (m_isDone) return best;
  double gained = 0.0;
  for (int iteration = 0; iteration < m_effort.iterations; ++iteration) {
    if (iteration > 0 && system.isExhausted()) break;
    m_isDone = sumOfSquares(m_force) == 0.0; // a net at rest, which a hand has just touched
    if (m_isDone) {
      m_unsolved = 0.0;
      break;
    }
    ++report.newtonIterations;
    if (!setMatrix(system, m_y, m_w, goal.h, report)) break;
    m_change = m_force; // same size: no allocation
    const double part = solve(system, m_change, iteration == 0 ? &goal.v : nullptr);
    m_unsolved = std::sqrt(part) * goal.h * std::sqrt(sumOfSquares(m_change));
    const double promised = sumOfProducts(m_force, m_change); // of which a model of second order keeps half
    bool found = false, beyond = false;
    double gain = 0.0;
    for (double fraction = 1.0; fraction >= kShortest && !found; fraction *= 0.25) {
      advanceNodes(m_y.size(), fraction * goal.h, m_y.data(), m_change.data(), m_trial.data());
      const Sums next = look(system, goal, m_trial);
      found = next.potential < best.potential;
      beyond = beyond || !std::isfinite(next.potential);
      if (!found) continue;
      gain = best.potential - next.potential;
      best = next;
      std::swap(m_y, m_trial);
    }
    if (!found) {
      const double size = std::abs(best.potential) + std::abs(best.stored) + std::abs(best.loadWork);
      m_isDone = promised <= kAtBottom * size; // else it is stuck where its model does not hold
      // Loads past all reason: to stay where it is would hide them.
      if (!beyond || iteration > 0) return look(system, goal, m_y);
      best.stored = std::numeric_limits<double>::infinity();
      return best;
    }
    gained += gain;
    const double left = std::max(best.elastic, 0.0);
    const bool isFalling = gain > left && left > own; // from where a jump has put it
    const bool isAsForetold = std::abs(gain - 0.5 * promised) <= m_effort.asForetold * 0.5 * promised;
    m_isDone = (isAsForetold || gain <= m_effort.enough * gained) && !isFalling;
    if (m_isDone) break;
  }
  return best; // and m_w is that of y
}

} // namespace esm
