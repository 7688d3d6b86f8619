// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/methods/integrator.h"
#include "core/dynamics/system/implicit_matrix.h"
#include "core/dynamics/system/step_loss.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace esm {
namespace {

constexpr double kOtherStep = 0.25; ///< a factor serves for steps that differ by so much
// Of the residual left by dv. The last two count from what the factor left when it was new.
constexpr double kMostFresh = 0.4; ///< granted to a new factor at most
constexpr double kMuch = 0.1;      ///< a new factor for the next step
constexpr double kTooMuch = 0.2;   ///< a new factor for this step already

/// Linearised implicit Euler (Baraff and Witkin 1998): one linear system a step, solved directly, no
/// iteration:
///
///     (M + h D + h^2 K) dv = h F(t', x + h v, v),   v' = v + dv,   x' = x + h v'
///
/// with K convex, so that the step exists whatever the net does. First order for any matrix in place of this
/// one, so a factor serves as long as it solves the implicit equation about as well as a new one would: what
/// dv leaves of the residual tells. Strongly damped, bounded at any step, and no step takes more than one
/// factor: the method for frames that must not take longer than this.
class LinearizedEuler final : public Integrator {
public:
  void prepare(const System& system) override
  {
    for (NodeArray* array : {&m_x, &m_v, &m_force}) array->assign(system.nodeCount(), Lanes{0, 0, 0, 0});
    m_matrix.prepare(system, true);
    m_loss.prepare(system);
    m_factoredStep = 0.0;
  }
  void restart() noexcept override { m_loss.restart(); }
  void constraintsChanged(const System& system) override
  {
    m_matrix.constraintsChanged(system);
    m_loss.restart();
    m_factoredStep = 0.0;
  }
  int order() const noexcept override { return 1; }
  bool findsLoss() const noexcept override { return true; }
  double stableStep(const FastestMode&) const noexcept override
  {
    return std::numeric_limits<double>::infinity();
  }
  double stepCost(const System& system, double /*h*/) override
  {
    return static_cast<double>(2 * system.forces().activeSprings()) + m_meanFactors * m_matrix.factorCost() +
           m_matrix.solveCost();
  }

  StepResult step(System& system, MotionState& state, double h, double end, StepReport& report) override
  {
    ++report.steps;
    const std::int64_t factorsBefore = report.factorizations;
    const bool isOld = m_factoredStep > 0.0 && std::abs(m_factoredStep - h) < kOtherStep * h;
    if (!isOld && !refactor(system, state, h, end, report)) return failure();
    Rates rates;
    double left = solve(system, state, h, end, rates);
    const bool isTooOld = isOld && !(left <= m_freshLeft + kTooMuch);
    if (isTooOld) {
      if (!refactor(system, state, h, end, report)) return failure();
      left = solve(system, state, h, end, rates);
    }
    if (!allFinite(m_x, m_v)) return StepResult::NonFinite;
    if (!isOld || isTooOld) m_freshLeft = std::min(left, kMostFresh);
    if (!(left <= m_freshLeft + kMuch)) m_factoredStep = 0.0;
    const double work = h * rates.work, heat = h * rates.heat;
    const double lost = m_loss.find(system, state, m_x, m_v, work, heat);
    state.advanceTo(end, m_x, m_v, work, heat, lost);
    m_meanFactors += 0.1 * (static_cast<double>(report.factorizations - factorsBefore) - m_meanFactors);
    return StepResult::Done;
  }

private:
  StepResult failure() const noexcept
  {
    return allFinite(m_x, m_force) ? StepResult::NotConverged : StepResult::NonFinite;
  }

  /// h F at the end of the step with unchanged velocities, into m_force. @return its norm over the root of
  /// the masses.
  double predict(System& system, const MotionState& state, double h, double end) noexcept
  {
    m_v = state.v; // same size: no allocation
    advanceNodes(m_x.size(), h, state.x.data(), m_v.data(), m_x.data());
    system.evaluate(end, m_x, m_v, m_force);
    double sum = 0.0;
    for (std::size_t i = 0; i < m_x.size(); ++i) {
      m_force[i] *= h;
      sum += system.inverseMass()[i] * dot(m_force[i], m_force[i]);
    }
    return std::sqrt(sum);
  }

  bool refactor(System& system, const MotionState& state, double h, double end, StepReport& report)
  {
    predict(system, state, h, end);
    ++report.factorizations;
    m_factoredStep = h;
    if (m_matrix.freeCount() == 0 ||
        m_matrix.factor(system, m_x, m_v, ImplicitMatrix::Shares::ofStep(h), true))
      return true;
    m_factoredStep = 0.0;
    return false;
  }

  /// The step into m_x and m_v. @return the share of the implicit equation's residual that is left.
  double solve(System& system, const MotionState& state, double h, double end, Rates& rates)
  {
    const double before = predict(system, state, h, end);
    m_matrix.solve(m_force);
    for (std::size_t i = 0; i < m_x.size(); ++i) {
      if (!system.isFree(i)) continue;
      m_v[i] += m_force[i];
      m_x[i] = state.x[i] + m_v[i] * h;
    }
    rates = system.evaluate(end, m_x, m_v, m_force);
    double sum = 0.0;
    for (std::size_t i = 0; i < m_x.size(); ++i) {
      const Lanes residual = m_force[i] * h - (m_v[i] - state.v[i]) * system.mass()[i];
      sum += system.inverseMass()[i] * dot(residual, residual);
    }
    return before > 0.0 ? std::sqrt(sum) / before : 0.0;
  }

  NodeArray m_x, m_v, m_force;
  ImplicitMatrix m_matrix;
  StepLoss m_loss;
  double m_factoredStep = 0.0; ///< [s], 0: no factor
  double m_freshLeft = 0.0;    ///< of the residual, by the first step of a factor
  double m_meanFactors = 1.0;  ///< per step, running mean
};

} // namespace

std::unique_ptr<Integrator> makeLinearized()
{
  return std::make_unique<LinearizedEuler>();
}

} // namespace esm
