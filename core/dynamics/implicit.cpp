// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/implicit_matrix.h"
#include "core/dynamics/integrator.h"

#include <cmath>
#include <limits>
#include <utility>

namespace esm {
namespace {

// TR-BDF2 (Bank et al. 1985) as a singly diagonal Runge-Kutta method (Hosea and Shampine 1996): a trapezoidal
// stage to t + g h, then BDF2 over both to t + h. Second order, A- and L-stable: what is too fast for the
// step is damped away instead of ringing. Both stages have the same matrix.
const double kMiddle = 2.0 - std::sqrt(2.0); // g
const double kDiagonal = 0.5 * kMiddle;      // implicit share of both stages
const double kOuter = 0.25 * std::sqrt(2.0); // share of the first two slopes in the last stage

constexpr int kMaxIterations = 25;
/// Where only boundedness counts, a stage is solved after so many iterations, if they left so much of its
/// residual.
constexpr int kRoughIterations = 4;
constexpr double kRoughResidual = 0.1;
constexpr int kMostLeaps = 3; ///< see leap()

class TrBdf2 final : public Integrator {
public:
  void prepare(const System& system) override
  {
    for (NodeArray* array : {&m_a, &m_middleA, &m_x, &m_v, &m_force, &m_startX, &m_startV, &m_trialV})
      array->assign(system.nodeCount(), Lanes{0, 0, 0, 0});
    m_matrix.prepare(system);
    m_right.resize(m_matrix.size());
    m_change.resize(m_matrix.size());
    m_factoredShare = 0.0;
    m_started = false;
  }
  void restart() noexcept override { m_started = false; }
  void constraintsChanged(const System& system) override { prepare(system); }
  int order() const noexcept override { return 2; }
  double stableStep(const FastestMode&) const noexcept override
  {
    return std::numeric_limits<double>::infinity();
  }
  void setSolveTolerance(double tolerance, bool rough) noexcept override
  {
    m_tolerance = tolerance;
    m_rough = rough;
  }

  /// Two stages of a few iterations; a factor serves about four steps, and its multiplications go six to the
  /// time of a spring (measured on the uterus sample: 6.5 ms a step, of a spring 8.5 ns).
  double stepCost(const System& system) override
  {
    const auto springs = static_cast<double>(system.forces().activeSprings());
    return 12.0 * springs + m_matrix.factorCost() / 24.0;
  }

  StepResult step(System& system, MotionState& state, double h, double end, StepReport& report) override
  {
    ++report.steps;
    if (!m_started) start(system, state);
    const double share = kDiagonal * h;
    Rates rates[3] = {m_rates, {}, {}};
    const std::size_t count = state.x.size();
    for (std::size_t i = 0; i < count; ++i) {
      m_startX[i] = state.x[i] + state.v[i] * share;
      m_startV[i] = state.v[i] + m_a[i] * share;
    }
    m_v = state.v;
    StepResult result = solve(system, state.time + kMiddle * h, share, rates[1], report);
    if (result != StepResult::Done) return result;
    for (std::size_t i = 0; i < count; ++i) {
      m_middleA[i] = system.isFree(i) ? (m_v[i] - m_startV[i]) * (1.0 / share) : Lanes{0, 0, 0, 0};
      m_startX[i] = state.x[i] + (state.v[i] + m_v[i]) * (kOuter * h);
      m_startV[i] = state.v[i] + (m_a[i] + m_middleA[i]) * (kOuter * h);
    }
    result = solve(system, end, share, rates[2], report);
    if (result != StepResult::Done) return result;
    for (std::size_t i = 0; i < count; ++i)
      m_a[i] = system.isFree(i) ? (m_v[i] - m_startV[i]) * (1.0 / share) : Lanes{0, 0, 0, 0};
    std::swap(state.x, m_x);
    std::swap(state.v, m_v);
    state.work += h * (kOuter * (rates[0].work + rates[1].work) + kDiagonal * rates[2].work);
    state.heat += h * (kOuter * (rates[0].heat + rates[1].heat) + kDiagonal * rates[2].heat);
    state.time = end;
    m_rates = rates[2];
    return StepResult::Done;
  }

private:
  void start(System& system, MotionState& state)
  {
    m_rates = system.evaluate(state.time, state.x, state.v, m_a);
    for (std::size_t i = 0; i < m_a.size(); ++i) m_a[i] *= system.inverseMass()[i];
    m_started = true;
  }

  /// Residual r = M (v - startV) - s F(startX + s v, v) of the free nodes into m_right, with a minus; m_x
  /// follows v. @return its norm over the root of the masses.
  double residual(System& system, double t, double s, NodeArray& v, Rates& rates)
  {
    for (std::size_t i = 0; i < v.size(); ++i) m_x[i] = m_startX[i] + v[i] * s;
    rates = system.evaluate(t, m_x, v, m_force);
    double sum = 0.0;
    for (std::size_t i = 0; i < v.size(); ++i) {
      const Index block = m_matrix.blockOf()[i];
      if (block == kNoIndex) continue;
      const Lanes right = m_force[i] * s - (v[i] - m_startV[i]) * system.mass()[i];
      m_right.segment<3>(3 * block) = toVector(right);
      sum += dot(right, right) * system.inverseMass()[i];
    }
    return std::sqrt(sum);
  }

  bool refactor(System& system, double s, bool convex, StepReport& report)
  {
    m_factoredShare = s;
    m_factorIsFresh = true;
    m_factorIsConvex = convex;
    ++report.factorizations;
    if (m_matrix.factor(system, m_x, m_v, s, convex)) return true;
    m_factoredShare = 0.0;
    return !convex && refactor(system, s, true, report);
  }

  /// Newton's method for one stage from the guess in m_v: an old factor serves as long as it gains, a line
  /// search on the residual keeps it from overshooting.
  StepResult solve(System& system, double t, double s, Rates& rates, StepReport& report)
  {
    double norm = residual(system, t, s, m_v, rates);
    if (m_matrix.size() == 0) return std::isfinite(norm) ? StepResult::Done : StepResult::NonFinite;
    const double first = norm;
    const double scale = s / std::sqrt(static_cast<double>(m_matrix.size()) / 3.0);
    m_factorIsFresh = false;
    int leaps = 0;
    bool wantConvex = false;
    for (int iteration = 0; iteration < kMaxIterations; ++iteration) {
      if (!std::isfinite(norm)) return StepResult::NonFinite;
      if (norm == 0.0) return StepResult::Done;
      const bool usable = std::abs(m_factoredShare - s) < 0.01 * s;
      if (!usable && !refactor(system, s, wantConvex || m_rough, report)) return StepResult::NotConverged;
      ++report.newtonIterations;
      m_matrix.solve(m_right, m_change);
      const double move = scale * m_change.norm(); // RMS over nodes [m]
      if (!std::isfinite(move)) return StepResult::NonFinite;
      double fraction = 1.0;
      const double next = lineSearch(system, t, s, norm, fraction, rates);
      const bool gained = next < norm;
      if (gained) std::swap(m_v, m_trialV);
      if (fraction == 1.0 && move <= m_tolerance) { // also when only rounding is left to gain
        if (!gained) norm = residual(system, t, s, m_v, rates);
        return StepResult::Done;
      }
      if (m_rough && next <= kRoughResidual * first && iteration + 1 >= kRoughIterations)
        return StepResult::Done;
      const bool slow = !gained || next > (m_rough ? 0.8 : 0.2) * norm;
      if (gained) {
        norm = next;
        m_factorIsFresh = wantConvex = false;
      } else if (!m_factorIsFresh || !m_factorIsConvex) {
        wantConvex = m_factorIsFresh;
        norm = residual(system, t, s, m_v, rates); // m_right and m_x back to the best point
      } else if (move <= 1e3 * m_tolerance) {      // at the bottom of rounding
        norm = residual(system, t, s, m_v, rates);
        return StepResult::Done;
      } else if (leaps < kMostLeaps) {
        ++leaps;
        wantConvex = false;
        norm = leap(system, t, s, rates);
      } else {
        return StepResult::NotConverged;
      }
      if (slow) m_factoredShare = 0.0; // the matrix has become too old
    }
    return StepResult::NotConverged;
  }

  /// Takes the whole change although the residual grows: over the jump in force of a spring that leaves
  /// length zero or a thread that tightens no descent leads. @return the new norm.
  double leap(System& system, double t, double s, Rates& rates)
  {
    residual(system, t, s, m_v, rates);
    m_matrix.solve(m_right, m_change);
    for (std::size_t i = 0; i < m_v.size(); ++i)
      if (const Index block = m_matrix.blockOf()[i]; block != kNoIndex)
        m_v[i] += toLanes(m_change.segment<3>(3 * block));
    m_factorIsFresh = false;
    return residual(system, t, s, m_v, rates);
  }

  /// Tries v + fraction * change with fraction 1, 1/2, ...; the trial velocity is in m_trialV, its residual
  /// in m_right. @return the trial's residual norm.
  double lineSearch(System& system, double t, double s, double norm, double& fraction, Rates& rates)
  {
    double next = norm;
    for (fraction = 1.0; fraction > 1e-3; fraction *= 0.5) {
      for (std::size_t i = 0; i < m_v.size(); ++i) {
        const Index block = m_matrix.blockOf()[i];
        m_trialV[i] = m_v[i];
        if (block != kNoIndex) m_trialV[i] += toLanes(m_change.segment<3>(3 * block)) * fraction;
      }
      next = residual(system, t, s, m_trialV, rates);
      const bool better = next < (1.0 - 1e-4 * fraction) * norm;
      if (better) return next;
      if (fraction == 1.0 && m_change.norm() * s <= m_tolerance) return next; // rounding
    }
    return next;
  }

  NodeArray m_a, m_middleA; ///< acceleration at the state, at the middle stage
  NodeArray m_x, m_v, m_force, m_startX, m_startV, m_trialV;
  Rates m_rates;
  ImplicitMatrix m_matrix;
  Eigen::VectorXd m_right, m_change;
  double m_tolerance = 1e-9;    ///< [m]
  bool m_rough = false;         ///< a few iterations that gain are enough
  double m_factoredShare = 0.0; ///< s of the factor at hand, 0 = none
  bool m_factorIsFresh = false; ///< made at the present iterate
  bool m_factorIsConvex = false;
  bool m_started = false;
};

} // namespace

std::unique_ptr<Integrator> makeImplicit()
{
  return std::make_unique<TrBdf2>();
}

} // namespace esm
