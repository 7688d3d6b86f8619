// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/implicit_matrix.h"
#include "core/dynamics/integrator.h"
#include "core/dynamics/own_energy.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace esm {
namespace {

constexpr int kIterations = 8;     ///< of a step at most, each with a factor
constexpr double kEnough = 1e-3;   ///< an iteration that gains less of what all have gained is the last
constexpr double kAtBottom = 1e-8; ///< of the potential, above its rounding
constexpr int kMostPulls = 8;      ///< back to the start, see step()
constexpr double kShortest = 1.0 / 4096.0; ///< of a Newton step [1]

/// Implicit Euler as a descent: the method that cannot fail. The step y of implicit Euler is where the
/// incremental potential is least (Kane, Marsden, Ortiz and West 2000; Gast et al. 2015),
///
///     P(y) = sum m/(2 h^2) |y - x - h v|^2 + V(y) - f.(y - x) + h/2 R(y, w),   w = (y - x)/h
///
/// V springs, anchors, tools and weight, f the loads, R the power of all dampers. Newton's method with the
/// convex matrix starts at y = x, and a line search sees to it that P falls. So whatever y it stops at, P(y)
/// <= P(x), which says that
///
///     V(y) - f.(y - x) + sum m/2 |w - v|^2 <= V(x) + sum m/2 |v|^2:
///
/// what is stored came from somewhere, whatever the net, the step and the number of iterations (where
/// supports or tools move dampers, step() checks it). The new velocity w is shortened if kinetic energy would
/// be more than what is left. Strongly damped, first order. The supports move first, then the net follows.
class Descent final : public Integrator {
public:
  void prepare(const System& system) override
  {
    for (NodeArray* array : {&m_x, &m_y, &m_trial, &m_w, &m_force, &m_change, &m_still})
      array->assign(system.nodeCount(), Lanes{0, 0, 0, 0});
    m_matrix.prepare(system, true);
  }
  void restart() noexcept override {}
  void constraintsChanged(const System& system) override { m_matrix.constraintsChanged(system); }
  bool isUncontrolled() const noexcept override { return true; }
  int order() const noexcept override { return 1; }
  bool findsLoss() const noexcept override { return true; }
  double stableStep(const FastestMode&) const noexcept override
  {
    return std::numeric_limits<double>::infinity();
  }
  double stepCost(const System& system, double /*h*/) override
  {
    const auto springs = static_cast<double>(system.forces().activeSprings());
    return 0.5 * kIterations * (m_matrix.factorCost() + m_matrix.solveCost() + 6.0 * springs);
  }

  StepResult step(System& system, MotionState& state, double h, double end, StepReport& report) override
  {
    ++report.steps;
    const double before = system.storedEnergy(state.x), own = ownEnergy(system, state);
    m_x = state.x; // same size: no allocation
    m_w = state.v;
    system.place(end, m_x, m_w);
    const double moved = system.storedEnergy(m_x);
    if (!std::isfinite(before) || !std::isfinite(moved)) return StepResult::NonFinite;
    const Goal goal{state.v, h, end};
    m_y = m_x;
    Sums sums = descend(system, goal, own, report);
    if (!std::isfinite(sums.stored)) return StepResult::NonFinite;
    double work = 0.0, left = 0.0;
    int pull = 0;
    for (;; ++pull) {
      if (!allFinite(m_y, m_w)) return StepResult::NonFinite;
      work = sums.loadWork + h * (sums.heatPower + viscousPower(system));
      left = freeKinetic(system, state.v) + moved - sums.stored + work;
      if (left >= 0.0 || pull > kMostPulls) break;
      // A moving support or tool worked through its dampers less than the descent took: not so far.
      for (std::size_t i = 0; i < m_y.size(); ++i)
        m_y[i] = pull < kMostPulls ? m_x[i] + (m_y[i] - m_x[i]) * 0.25 : m_x[i];
      sums = look(system, goal, m_y);
    }
    report.rough = report.rough || !m_isDone || pull > 0;
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
    state.advanceTo(end, m_y, m_w, work, heat);
    state.settle(std::max(-appeared, 0.0), heat, ownEnergy(system, state));
    return StepResult::Done;
  }

private:
  struct Goal {
    const NodeArray& v; ///< at the start
    double h, end;
  };
  struct Sums {
    double potential = 0.0; ///< P [J]
    double stored = 0.0;    ///< V [J]
    double loadWork = 0.0;  ///< f.(y - x) [J]
    double heatPower = 0.0; ///< [W]
  };

  /// P and its parts at y; sets m_w to the velocity that leads there, m_force to - h dP/dy of the free nodes.
  Sums look(System& system, const Goal& goal, NodeArray& y) noexcept
  {
    Sums sums;
    slopesTo(y.size(), 1.0 / goal.h, system.inverseMass().data(), m_x.data(), y.data(), m_w.data());
    // The sum of f w; what it leaves in m_force is overwritten.
    sums.loadWork = goal.h * system.schedule().addForces(goal.end, m_w.data(), m_force.data());
    const Rates rates = system.evaluate(goal.end, y, m_w, m_force); // places the supports
    sums.heatPower = rates.heat;
    sums.stored = system.storedEnergy(y);
    double inertia = 0.0;
    for (std::size_t i = 0; i < y.size(); ++i) {
      if (!system.isFree(i)) {
        m_force[i] = Lanes{0, 0, 0, 0};
        continue;
      }
      const Lanes jump = m_w[i] - goal.v[i];
      inertia += 0.5 * system.mass()[i] * dot(jump, jump);
      m_force[i] = m_force[i] * goal.h - jump * system.mass()[i];
    }
    sums.potential = inertia + sums.stored - sums.loadWork + 0.5 * goal.h * sums.heatPower;
    return sums;
  }

  /// Power [W] of all viscous forces on the free nodes at y and w. What the dampers turn into heat beyond
  /// what they take from the nodes, moving supports and tools have put in.
  double viscousPower(System& system) noexcept
  {
    system.forces().computeForces(m_y.data(), m_w.data(), m_force.data());
    system.forces().computeForces(m_y.data(), m_still.data(), m_trial.data());
    system.springsEvaluated += 2 * system.forces().activeSprings();
    double power = 0.0;
    for (std::size_t i = 0; i < m_w.size(); ++i)
      if (system.isFree(i)) power += dot(m_force[i] - m_trial[i], m_w[i]);
    for (const ToolSpring& tool : system.tools()) {
      const auto i = static_cast<std::size_t>(tool.node);
      if (system.isFree(i)) power += tool.viscosity * dot(toLanes(tool.targetVelocity) - m_w[i], m_w[i]);
    }
    return power;
  }

  /// @param own  that the net had before supports moved: more than that is left of a jump
  Sums descend(System& system, const Goal& goal, double own, StepReport& report)
  {
    Sums best = look(system, goal, m_y);
    m_isDone = m_matrix.freeCount() == 0;
    if (m_isDone) return best;
    double gained = 0.0;
    for (int iteration = 0; iteration < kIterations; ++iteration) {
      ++report.newtonIterations;
      ++report.factorizations;
      if (!m_matrix.factor(system, m_y, m_w, ImplicitMatrix::Shares::ofStep(goal.h), true)) break;
      m_change = m_force; // same size: no allocation
      m_matrix.solve(m_change);
      double promised = 0.0; // [J]
      for (std::size_t i = 0; i < m_change.size(); ++i) promised += dot(m_force[i], m_change[i]);
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
        // Loads past all reason: to stay where it is would hide them.
        const double size = std::abs(best.potential) + std::abs(best.stored) + std::abs(best.loadWork);
        m_isDone = promised <= kAtBottom * size; // else it is stuck where its model does not hold
        if (!beyond || iteration > 0) break;
        best.stored = std::numeric_limits<double>::infinity();
        return best;
      }
      gained += gain;
      const double left = std::max(system.elasticEnergy(m_y), 0.0);
      const bool isFalling = gain > left && left > own; // from where a jump has put it
      m_isDone = gain <= kEnough * gained && !isFalling;
      if (m_isDone) return best; // m_w is that of y
    }
    return look(system, goal, m_y);
  }

  NodeArray m_x; ///< at the start, supports moved [m]
  NodeArray m_y, m_trial, m_w, m_force, m_change;
  NodeArray m_still;    ///< 0
  bool m_isDone = true; ///< the last descent got where it no longer gains much
  ImplicitMatrix m_matrix;
};

} // namespace

std::unique_ptr<Integrator> makeDescent()
{
  return std::make_unique<Descent>();
}

} // namespace esm
