// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/methods/integrator.h"
#include "core/dynamics/system/diagonal.h"
#include "core/dynamics/system/implicit_matrix.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace esm {
namespace {

constexpr int kMostIterations = 200;
constexpr int kMostKicks = 8;            ///< off saddles
constexpr double kSmallestShift = 1e-10; ///< of the mass that keeps what nothing holds from drifting [1]
constexpr double kLargestShift = 1e-2;
constexpr double kArmijo = 1e-4;
constexpr double kSlowDescent = 0.25; ///< an iteration that leaves more of the force asks for a new factor
constexpr double kLongestMove = 0.1;  ///< of the net's extent, RMS over nodes, in one iteration
constexpr double kRounding = 1e-13;   ///< relative, of sums over a net

/// The propagation of the first network model (ESM paper 1999, section 3.1): in each interval of time the net
/// first goes to a minimum of its energy under the loads and prescribed positions of the interval's end, then
/// time advances. No inertia, no viscosity: the velocities are 0 afterwards. Newton's method on the energy
///
///     E(x) = springs + anchors + tools - sum (m g + f).x
///
/// with a line search, so that the energy never rises; where the stiffness matrix is not positive definite,
/// with the convex part of it; off a saddle along a direction of negative curvature.
///
/// The supports move first, then the loads act with their final values while the net gives way. So the work
/// is never less than what the net stores; the rest, and all kinetic energy, is heat.
class Relax final : public Integrator {
public:
  void prepare(const System& system) override
  {
    for (NodeArray* array : {&m_x, &m_v, &m_trial, &m_rest, &m_load, &m_force, &m_change})
      array->assign(system.nodeCount(), Lanes{0, 0, 0, 0});
    m_matrix.prepare(system);
  }
  void restart() noexcept override {}
  void constraintsChanged(const System& system) override { m_matrix.constraintsChanged(system); }
  int order() const noexcept override { return 1; }
  bool findsLoss() const noexcept override { return true; }
  bool isUncontrolled() const noexcept override { return true; }
  double stableStep(const FastestMode&) const noexcept override
  {
    return std::numeric_limits<double>::infinity();
  }
  void setSolveTolerance(double tolerance, bool) noexcept override { m_tolerance = tolerance; }
  double stepCost(const System& system, double /*h*/) override
  {
    const auto springs = static_cast<double>(system.forces().activeSprings());
    return 4.0 * (m_matrix.factorCost() + m_matrix.solveCost() + 10.0 * springs); // the energy is slow
  }

  StepResult step(System& system, MotionState& state, double, double end, StepReport& report) override
  {
    ++report.steps;
    const double before = system.storedEnergy(state.x);
    m_x = state.x; // same size: no allocation
    m_v = m_rest;
    system.place(end, m_x, m_v);
    findLoads(system, end);
    const double moved = system.storedEnergy(m_x);
    const double potential = loadEnergy(system, m_x);
    if (const StepResult result = minimize(system, report); result != StepResult::Done) return result;
    if (!allFinite(m_x, m_rest)) return StepResult::NonFinite;
    const double after = system.storedEnergy(m_x);
    const double loads = potential - loadEnergy(system, m_x);
    const double work = (moved - before) + loads;
    state.work += work;
    state.heat += (work - (after - before)) + system.kineticEnergy(state.v);
    std::swap(state.x, m_x);
    state.v = m_rest;
    state.time = end;
    return StepResult::Done;
  }

private:
  /// Forces at t that do not depend on where the nodes are: of the loads, without the net's own and the
  /// tools'.
  void findLoads(System& system, double t)
  {
    system.evaluate(t, m_x, m_v, m_load); // places the prescribed nodes, with their velocity
    system.forces().computeForces(m_x.data(), m_v.data(), m_force.data());
    system.springsEvaluated += system.forces().activeSprings();
    for (std::size_t i = 0; i < m_load.size(); ++i) m_load[i] -= m_force[i];
    for (std::size_t i = 0; i < system.tools().size(); ++i)
      m_load[static_cast<std::size_t>(system.tools()[i].node)] -= toLanes(system.toolForce(i, m_x, m_v));
  }

  /// - f.x of the loads on free nodes [J]; on held ones the support answers.
  double loadEnergy(const System& system, const NodeArray& x) const noexcept
  {
    double energy = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i)
      if (system.isFree(i)) energy -= dot(m_load[i], x[i]);
    return energy;
  }

  double energy(const System& system, const NodeArray& x) const noexcept
  {
    return system.storedEnergy(x) + loadEnergy(system, x);
  }

  /// Forces on the free nodes at rest at x into m_force. @return their norm [N].
  double findForces(System& system, const NodeArray& x) noexcept
  {
    system.forces().computeForces(x.data(), m_rest.data(), m_force.data());
    system.springsEvaluated += system.forces().activeSprings();
    for (const ToolSpring& tool : system.tools()) {
      const auto node = static_cast<std::size_t>(tool.node);
      m_force[node] += (toLanes(tool.target) - x[node]) * tool.stiffness;
    }
    double sum = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      m_force[i] = system.isFree(i) ? m_force[i] + m_load[i] : Lanes{0, 0, 0, 0};
      sum += dot(m_force[i], m_force[i]);
    }
    return std::sqrt(sum);
  }

  /// The stiffness matrix at m_x; its convex part if the true one is not positive definite.
  bool factor(System& system, bool convex, StepReport& report)
  {
    const auto make = [&](bool isConvex, double shift) {
      ++report.factorizations;
      const ImplicitMatrix::Shares shares{shift * m_rate, 0.0, 1.0};
      return m_matrix.factor(system, m_x, m_rest, shares, isConvex);
    };
    m_isTrue = false;
    if (!convex) {
      m_isTrue = make(false, kSmallestShift) && m_matrix.negativePivots() == 0;
      if (m_isTrue) return true;
    }
    for (double shift = 1e-6; shift <= kLargestShift;
         shift *= 100.0) // what is slack or floats has no stiffness
      if (make(true, shift) && m_matrix.negativePivots() == 0) return true;
    return false;
  }

  StepResult minimize(System& system, StepReport& report)
  {
    if (m_matrix.freeCount() == 0) return StepResult::Done;
    m_rate = fastestRate(system);
    const double longest = kLongestMove * extentOf(m_x);
    double norm = findForces(system, m_x), height = energy(system, m_x);
    bool isFactored = false, convex = false;
    int kicks = 0;
    for (int iteration = 0; iteration < kMostIterations; ++iteration) {
      if (!std::isfinite(norm) || !std::isfinite(height)) return StepResult::NonFinite;
      if (!isFactored && !factor(system, convex, report)) return StepResult::NotConverged;
      ++report.newtonIterations;
      const bool isFresh = !isFactored;
      const double move = findChange(longest);
      if (norm == 0.0 || move <= m_tolerance) { // at rest; but on a saddle?
        for (std::size_t i = 0; i < m_x.size(); ++i) m_x[i] += m_change[i];
        if (m_isTrue || kicks >= kMostKicks || !kickOffSaddle(system, longest, report))
          return StepResult::Done;
        ++kicks;
        norm = findForces(system, m_x);
        height = energy(system, m_x);
        isFactored = convex = false;
        continue;
      }
      const double last = norm;
      if (!lineSearch(system, height, norm)) {
        norm = findForces(system, m_x);
        if (isFresh && (!m_isTrue || move <= 1e3 * m_tolerance))
          return move <= 1e6 * m_tolerance ? StepResult::Done : StepResult::NotConverged;
        convex = isFresh;
        isFactored = false;
        continue;
      }
      std::swap(m_x, m_trial);
      isFactored = norm < kSlowDescent * last;
      convex = false;
    }
    return StepResult::NotConverged;
  }

  /// Newton's change at m_x, from m_force. @return its length [m], RMS over nodes, at most `longest`.
  double findChange(double longest)
  {
    m_change = m_force;
    m_matrix.solve(m_change);
    return shorten(longest);
  }

  double shorten(double longest) noexcept
  {
    double sum = 0.0;
    for (const Lanes& change : m_change) sum += dot(change, change);
    double move = std::sqrt(sum / static_cast<double>(m_matrix.freeCount()));
    if (move > longest) {
      for (Lanes& change : m_change) change *= longest / move;
      move = longest;
    }
    return move;
  }

  /// Goes along m_change until the energy has fallen enough; where the fall is lost in rounding, until the
  /// slope has (Hager and Zhang 2005). New position in m_trial, its energy and force norm in the arguments.
  bool lineSearch(System& system, double& height, double& norm) noexcept
  {
    const auto slopeNow = [&] {
      double slope = 0.0;
      for (std::size_t i = 0; i < m_change.size(); ++i) slope -= dot(m_force[i], m_change[i]);
      return slope;
    };
    const double slope = slopeNow();
    if (!(slope < 0.0)) return false;
    const double rounding = kRounding * (std::abs(height) + 1e-300);
    for (double fraction = 1.0; fraction > 1e-9; fraction *= 0.5) {
      advanceNodes(m_x.size(), fraction, m_x.data(), m_change.data(), m_trial.data());
      const double next = energy(system, m_trial);
      if (!(next <= height + rounding)) continue;
      const double nextNorm = findForces(system, m_trial);
      const bool falls = next <= height + kArmijo * fraction * slope;
      if (!falls && !(std::abs(slopeNow()) <= 0.9 * std::abs(slope))) continue;
      height = next;
      norm = nextNorm;
      return true;
    }
    return false;
  }

  /// At a point of balance: whether it is a saddle; if so, m_x leaves it downhill.
  bool kickOffSaddle(System& system, double longest, StepReport& report)
  {
    const ImplicitMatrix::Shares shares{kSmallestShift * m_rate, 0.0, 1.0};
    ++report.factorizations;
    if (!m_matrix.factor(system, m_x, m_rest, shares, false) || !m_matrix.negativeDirection(m_change))
      return false;
    shorten(longest);
    const double height = energy(system, m_x);
    for (double fraction = 1.0; fraction > 1e-6; fraction *= 0.25)
      for (const double way : {fraction, -fraction}) {
        advanceNodes(m_x.size(), way, m_x.data(), m_change.data(), m_trial.data());
        if (!(energy(system, m_trial) < height - kRounding * std::abs(height))) continue;
        std::swap(m_x, m_trial);
        return true;
      }
    return false;
  }

  /// Largest stiffness over mass of a node [1/s^2], about: what shifts are measured by.
  double fastestRate(const System& system) { return m_matrix.stiffestRate(system, m_x, m_rest); }

  static double extentOf(const NodeArray& x) noexcept
  {
    const double extent = std::sqrt(squareOfDiagonal(x));
    return extent > 0.0 ? extent : 1.0;
  }

  NodeArray m_x, m_v, m_trial, m_load, m_force, m_change;
  NodeArray m_rest; ///< zeros: nothing moves
  ImplicitMatrix m_matrix;
  double m_tolerance = 1e-9; ///< [m], RMS over nodes
  double m_rate = 1.0;       ///< [1/s^2]
  bool m_isTrue = false;     ///< the factor is that of the true matrix, which is positive definite
};

} // namespace

std::unique_ptr<Integrator> makeRelax()
{
  return std::make_unique<Relax>();
}

} // namespace esm
