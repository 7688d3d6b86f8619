// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/rest/equilibrium.h"

#include "core/dynamics/planner/policy.h"

#include <cmath>
#include <limits>

namespace esm {
namespace {

constexpr double kNowhere = std::numeric_limits<double>::infinity();

} // namespace

void Equilibrium::forget() noexcept
{
  m_isLaidOut = m_hasFactor = m_gradientsFail = m_isKnown = false;
}

/// The pressure of a body couples all of its nodes, which only the factor knows.
bool Equilibrium::takesFactor(const System& system) const noexcept
{
  return m_gradientsFail || !system.forces().pressure().isEmpty();
}

double Equilibrium::layoutCost(const System& system) const noexcept
{
  return system.nodeCount() <= m_policy->mostNodes
           ? m_policy->layoutCost * static_cast<double>(system.nodeCount())
           : kNowhere;
}

double Equilibrium::solveCost(const System& system) const noexcept
{
  return takesFactor(system) ? m_matrix.solveCost()
                             : m_policy->gradientsCost * static_cast<double>(system.forces().activeSprings());
}

double Equilibrium::stepCost(const System& system) const noexcept
{
  const double before = takesFactor(system)
                          ? m_matrix.factorCost()
                          : m_policy->gradientsLayout * static_cast<double>(system.forces().activeSprings());
  return before + solveCost(system);
}

void Equilibrium::layOut(const System& system)
{
  if (m_isLaidOut) return;
  m_matrix.prepare(system);
  m_isLaidOut = true;
}

double Equilibrium::forcesAt(System& system, double time, NodeArray& x, NodeArray& force, StepReport& report)
{
  const std::int64_t before = system.springsEvaluated;
  m_still.assign(x.size(), Lanes{0, 0, 0, 0});
  force.resize(x.size());
  system.evaluate(time, x, m_still, force);
  report.springsEvaluated += system.springsEvaluated - before;
  for (std::size_t i = 0; i < x.size(); ++i)
    if (!system.isFree(i)) force[i] = Lanes{0, 0, 0, 0};
  return std::sqrt(sumOfSquares(force));
}

/// The same net under the same loads has the same forces, to the last bit.
bool Equilibrium::holds(System& system, double time, StepReport& report)
{
  m_isKnown = m_isKnown && m_place.size() == system.nodeCount() &&
              forcesAt(system, time, m_place, m_next, report) <= m_force;
  return m_isKnown;
}

bool Equilibrium::solve(System& system, NodeArray& vector)
{
  m_spent += solveCost(system);
  if (takesFactor(system)) {
    if (!m_hasFactor) return false; // the place was found by gradients, which have failed since
    m_matrix.solve(vector);
    return true;
  }
  const StiffnessCg::Result result = m_gradients.solve(system, vector, m_iterations);
  m_gradientsFail = result == StiffnessCg::Result::TooSlow;
  return result == StiffnessCg::Result::Solved;
}

/// K at the place. @return whether it is positive definite, as far as known.
bool Equilibrium::takeStiffness(System& system, bool convex, StepReport& report)
{
  m_isConvex = convex;
  m_spent += stepCost(system) - solveCost(system);
  if (!takesFactor(system)) {
    m_gradients.prepare(system, m_place, m_policy->inertia);
    if (!m_gradients.givesWay(system)) return true;
    m_gradientsFail = system.nodeCount() <= m_policy->mostNodes;
    return false;
  }
  layOut(system);
  m_matrix.constraintsChanged(system);
  ++report.factorizations;
  m_hasFactor = m_matrix.factor(system, m_place, m_still, {m_policy->inertia, 0.0, 1.0}, convex);
  return m_hasFactor && m_matrix.negativePivots() == 0;
}

/// m_step, by the stiffness at the place. @return false where there is none.
bool Equilibrium::prepareStep(System& system, double time, StepReport& report)
{
  m_force = forcesAt(system, time, m_place, m_step, report);
  if (takesFactor(system) != m_byFactor) return false; // what that costs is another question
  if (!takeStiffness(system, false, report)) {
    if (!m_byFactor || m_spent > m_affordable || !takeStiffness(system, true, report)) return false;
  }
  if (!solve(system, m_step)) return false;
  m_length = std::sqrt(sumOfSquares(m_step));
  return std::isfinite(m_length);
}

double Equilibrium::squareOfWay(const NodeArray& from) const noexcept
{
  double sum = 0.0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    const Lanes way = m_place[i] - from[i];
    sum += dot(way, way);
  }
  return sum;
}

/// Adds m_step to the place, or as much of it as leaves a shorter one, which it then is.
Equilibrium::Outcome Equilibrium::takeStep(System& system, const MotionState& motion, const Aim& aim,
                                           StepReport& report)
{
  m_base = m_place;
  const double length = m_length;
  for (std::size_t i = 0; i < m_place.size(); ++i) m_place[i] += m_step[i];
  m_force = forcesAt(system, motion.time, m_place, m_next, report);
  const double left = m_firstForce > 0.0 ? m_force / m_firstForce : 0.0; // of the way, about
  if (left <= m_policy->left && left * left * squareOfWay(motion.x) <= aim.close) return Outcome::IsThere;
  if (!solve(system, m_next)) return Outcome::Fails;
  const double next = std::sqrt(sumOfSquares(m_next));
  if (next <= m_policy->shorter * length) {
    m_step.swap(m_next);
    m_length = next;
    if (next > m_policy->left * length) return Outcome::Turns;
    return length * length <= aim.close && left <= 1.0 ? Outcome::IsThere : Outcome::GoesOn;
  }
  // Springs have turned: they pull in other directions than the stiffness knows.
  if (m_spent > m_affordable) return Outcome::Fails;
  if (prepareStep(system, motion.time, report) && !m_isConvex && m_length <= m_policy->longer * length)
    return Outcome::GoesOn;
  m_place = m_base;
  return prepareStep(system, motion.time, report) ? takePart(system, motion.time, report) : Outcome::Fails;
}

/// The same with a half of the step or less. @pre the place is m_base.
Equilibrium::Outcome Equilibrium::takePart(System& system, double time, StepReport& report)
{
  for (double part = 0.5; part >= m_policy->leastPart; part *= 0.5) {
    advanceNodes(m_place.size(), part, m_base.data(), m_step.data(), m_place.data());
    m_force = forcesAt(system, time, m_place, m_next, report);
    if (!solve(system, m_next)) return Outcome::Fails;
    if (std::sqrt(sumOfSquares(m_next)) <= (1.0 - (1.0 - m_policy->shorter) * part) * m_length)
      return Outcome::Turns;
  }
  return Outcome::Fails;
}

double Equilibrium::find(System& system, const MotionState& motion, const Aim& aim, StepReport& report)
{
  m_isKnown = false;
  m_byFactor = takesFactor(system);
  m_affordable = aim.affordable;
  m_iterations = aim.iterations;
  m_spent = 0.0;
  m_place = motion.x;
  if (!prepareStep(system, motion.time, report)) return kNowhere;
  m_firstForce = m_force;
  double square = m_length * m_length;
  for (int steps = 0; square <= aim.far; ++steps) {
    if (steps == m_policy->mostSteps || (steps > 0 && m_spent > m_affordable)) return kNowhere;
    const Outcome outcome = takeStep(system, motion, aim, report);
    if (outcome == Outcome::Fails) return kNowhere;
    square = squareOfWay(motion.x);
    if (outcome == Outcome::IsThere) {
      m_isKnown = !m_isConvex || takeStiffness(system, false, report);
      return m_isKnown ? square : kNowhere;
    }
    if (outcome == Outcome::Turns && !prepareStep(system, motion.time, report)) return kNowhere;
  }
  return std::isfinite(square) ? square : kNowhere;
}

} // namespace esm
