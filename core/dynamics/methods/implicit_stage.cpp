// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/methods/implicit_stage.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace esm {
namespace {

constexpr int kMaxIterations = 25;
/// Where only boundedness counts, a stage is solved after so many iterations, if they left so much of its
/// residual.
constexpr int kRoughIterations = 4;
constexpr double kRoughResidual = 0.1;
constexpr int kMostLeaps = 3;            ///< see leap()
constexpr double kSlow = 0.5;            ///< an iteration that leaves more may ask for a new factor
constexpr double kHopeless = 0.95;       ///< the same, asks at once
constexpr double kFreshIterations = 2.0; ///< that a new factor needs, too
constexpr double kRoughSlow = 0.8;       ///< the same where only boundedness counts
constexpr double kOtherShare = 0.25;     ///< a factor serves for s that differ by so much
constexpr double kSmoothing = 0.1;       ///< of the running means

/// F becomes s F - M (v - v0), 0 where a support holds. @return the sum of its squares over the masses.
ESM_CPU_CLONES double toResidual(std::size_t count, double s, const double* mass, const double* inverseMass,
                                 const Lanes* v, const Lanes* startV, Lanes* force) noexcept
{
  const Lanes zero = {0, 0, 0, 0};
  Lanes sum = zero;
  for (std::size_t i = 0; i < count; ++i) {
    const double inverse = inverseMass[i];
    const Lanes right = force[i] * s - (v[i] - startV[i]) * mass[i];
    sum += right * right * inverse;
    force[i] = inverse > 0.0 ? right : zero;
  }
  return sumLanes(sum);
}

} // namespace

void ImplicitStage::prepare(const System& system)
{
  m_hasRoom = false;
  m_pairs.clearAll();
  m_matrix.prepare(system, true);
  m_factoredShare = 0.0;
  m_meanIterations = 2.0;
  m_meanFactors = 0.1;
}

void ImplicitStage::makeRoom(const System& system)
{
  if (std::exchange(m_hasRoom, true)) return;
  for (NodeArray* array : {&m_force, &m_change, &m_trial, &m_before})
    array->assign(system.nodeCount(), Lanes{0, 0, 0, 0});
}

void ImplicitStage::constraintsChanged(const System& system)
{
  m_matrix.constraintsChanged(system);
  m_factoredShare = 0.0;
}

double ImplicitStage::cost(const System& system) const noexcept
{
  return static_cast<double>(system.forces().activeSprings()) + m_meanFactors * m_matrix.factorCost() +
         m_meanIterations * iterationCost(system);
}

double ImplicitStage::iterationCost(const System& system) const noexcept
{
  return static_cast<double>(system.forces().activeSprings()) +
         2.0 * static_cast<double>(system.nodeCount()) + m_matrix.solveCost();
}

/// Whether a new factor would cost less than to go on with the old one: each iteration leaves the share
/// `left` of the last change `move` [m].
bool ImplicitStage::isTooSlow(const System& system, double move, double left) const noexcept
{
  if (m_rough) return left > kRoughSlow;
  if (left <= kSlow) return false;
  if (!(left < kHopeless)) return true;
  double still = -kFreshIterations;
  for (move *= left; move > m_tolerance; move *= left) still += 1.0;
  return still * iterationCost(system) > m_matrix.factorCost();
}

/// r = M (v - startV) - s F(startX + s v, v) of the free nodes into m_force, with a minus; x follows v.
/// @return its norm over the root of the masses.
double ImplicitStage::residual(const Problem& problem, NodeArray& v, NodeArray& x, Rates& rates) noexcept
{
  System& system = problem.system;
  advanceNodes(v.size(), problem.s, problem.startX.data(), v.data(), x.data());
  rates = system.evaluate(problem.t, x, v, m_force);
  return std::sqrt(toResidual(v.size(), problem.s, system.mass().data(), system.inverseMass().data(),
                              v.data(), problem.startV.data(), m_force.data()));
}

bool ImplicitStage::refactor(const Problem& problem, const NodeArray& x, const NodeArray& v, bool convex,
                             StepReport& report)
{
  m_factoredShare = problem.s;
  m_factorIsFresh = true;
  m_factorIsConvex = convex;
  m_pairs.clear();
  m_freshIterations = 0;
  m_excess = 0.0;
  ++report.factorizations;
  problem.system.solverWork += m_matrix.factorCost();
  if (m_matrix.factor(problem.system, x, v, ImplicitMatrix::Shares::ofStep(problem.s), convex)) return true;
  m_factoredShare = 0.0;
  return !convex && refactor(problem, x, v, true, report);
}

/// m_change from the residual in m_force. @return its length [m], RMS over nodes.
double ImplicitStage::findChange(const Problem& problem)
{
  m_change = m_before = m_force; // same size: no allocation
  if (std::exchange(m_pairShare, problem.s) != problem.s) m_pairs.clear();
  m_pairs.fold(m_change);
  m_matrix.solve(m_change);
  const double ratio = problem.s / m_factoredShare;
  // Of a factor for another s, modes that inertia rules want all of the change, those that stiffness rules
  // 1/ratio^2 of it: halfway between.
  const double scale = m_factoredShare == problem.s ? 1.0 : 2.0 / (1.0 + ratio * ratio);
  if (scale != 1.0)
    for (Lanes& change : m_change) change *= scale;
  m_pairs.unfold(m_change);
  Lanes sum = {0, 0, 0, 0};
  for (const Lanes& change : m_change) sum += change * change;
  m_move = problem.s * std::sqrt(sumLanes(sum) / static_cast<double>(m_matrix.freeCount()));
  return m_move;
}

/// Takes the whole change although the residual grows: over the jump in force of a spring that leaves
/// length zero or a thread that tightens no descent leads. @return the new norm.
double ImplicitStage::leap(const Problem& problem, NodeArray& v, NodeArray& x, Rates& rates)
{
  residual(problem, v, x, rates);
  findChange(problem);
  for (std::size_t i = 0; i < v.size(); ++i) v[i] += m_change[i];
  m_factorIsFresh = false;
  return residual(problem, v, x, rates);
}

/// Tries v + fraction * change with fraction 1, 1/2, ...; the trial velocity is in m_trial, its residual in
/// m_force. @return the trial's residual norm.
double ImplicitStage::tryChange(const Problem& problem, double norm, const NodeArray& v, NodeArray& x,
                                double& fraction, Rates& rates) noexcept
{
  double next = norm;
  const double least = m_factorIsFresh ? 1e-3 : 0.2; // an old factor's direction deserves no long search
  for (fraction = 1.0; fraction > least; fraction *= 0.5) {
    for (std::size_t i = 0; i < v.size(); ++i) m_trial[i] = v[i] + m_change[i] * fraction;
    next = residual(problem, m_trial, x, rates);
    if (next < (1.0 - 1e-4 * fraction) * norm) return next;
    if (fraction == 1.0 && m_move <= m_tolerance) return next; // rounding
  }
  return next;
}

StepResult ImplicitStage::solve(System& system, double t, double s, const NodeArray& startX,
                                const NodeArray& startV, NodeArray& v, NodeArray& x, Rates& rates,
                                StepReport& report)
{
  makeRoom(system);
  const Problem problem{system, t, s, startX, startV};
  double norm = residual(problem, v, x, rates);
  if (m_matrix.freeCount() == 0) return std::isfinite(norm) ? StepResult::Done : StepResult::NonFinite;
  const double first = norm;
  m_factorIsFresh = false;
  int leaps = 0, factors = 0;
  bool wantConvex = false;
  if (m_excess * iterationCost(system) > m_matrix.factorCost()) m_factoredShare = 0.0;
  for (int iteration = 0; iteration < kMaxIterations; ++iteration) {
    if (!std::isfinite(norm)) return StepResult::NonFinite;
    if (system.isExhausted()) return StepResult::NotConverged;
    if (norm == 0.0) return StepResult::Done;
    if (!(std::abs(m_factoredShare - s) < kOtherShare * s)) {
      ++factors;
      if (!refactor(problem, x, v, wantConvex || m_rough, report)) return StepResult::NotConverged;
    }
    ++report.newtonIterations;
    const double move = findChange(problem);
    if (!std::isfinite(move)) return StepResult::NonFinite;
    double fraction = 1.0;
    const double next = tryChange(problem, norm, v, x, fraction, rates);
    const bool gained = next < norm;
    if (gained) {
      std::swap(v, m_trial);
      if (move > m_tolerance) m_pairs.add(m_change, fraction, m_before, m_force); // else rounding would teach
    }
    const double left = next / norm; // of the error, if the next iteration is like this one
    if (fraction == 1.0 && (move <= m_tolerance || (left < 0.5 && move * left <= 0.5 * m_tolerance))) {
      if (!gained) residual(problem, v, x, rates); // only rounding was left to gain
      learn(s, iteration + 1, factors);
      return StepResult::Done;
    }
    if (m_rough && next <= kRoughResidual * first && iteration + 1 >= kRoughIterations)
      return StepResult::Done;
    const bool slow = !gained || isTooSlow(system, move, left);
    if (gained) {
      norm = next;
      // A short step along the true matrix, which is indefinite: the convex one leads out of the saddle.
      wantConvex = fraction < 0.3 && m_matrix.negativePivots() > 0;
      m_factorIsFresh = false;
    } else if (!m_factorIsFresh || !m_factorIsConvex) {
      wantConvex = m_factorIsFresh;
      norm = residual(problem, v, x, rates); // back to the best point
    } else if (move <= 1e3 * m_tolerance) {  // at the bottom of rounding
      residual(problem, v, x, rates);
      return StepResult::Done;
    } else if (leaps < kMostLeaps) {
      ++leaps;
      wantConvex = false;
      norm = leap(problem, v, x, rates);
    } else {
      return StepResult::NotConverged;
    }
    if (slow) m_factoredShare = 0.0; // the matrix has become too old
  }
  return StepResult::NotConverged;
}

/// Books the iterations of a stage.
void ImplicitStage::learn(double s, int iterations, int factors) noexcept
{
  m_meanIterations += kSmoothing * (iterations - m_meanIterations);
  m_meanFactors += kSmoothing * (factors - m_meanFactors);
  if (m_freshIterations == 0 && m_factoredShare == s)
    m_freshIterations = iterations;
  else
    m_excess += std::max(0, iterations - m_freshIterations);
}

} // namespace esm
