// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/integrator.h"
#include "core/forces/spring_pass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace esm {
namespace {

constexpr int kStages = 6;
// Dormand and Prince (1980), RK5(4)7M; the seventh stage is the first one of the next step.
constexpr double kNode[kStages + 1] = {0.0, 1.0 / 5, 3.0 / 10, 4.0 / 5, 8.0 / 9, 1.0, 1.0};
constexpr double kWeights[kStages][kStages] = {
  {1.0 / 5},
  {3.0 / 40, 9.0 / 40},
  {44.0 / 45, -56.0 / 15, 32.0 / 9},
  {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
  {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656},
  {35.0 / 384, 0.0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84}};

/// The weights of the accelerations in the positions: as x' = v, a stage's position needs no velocities of
/// the stages before (Nystroem's form): x_i = x + c_i h v + h^2 sum_k (A^2)_ik a_k.
struct SquaredWeights {
  double weight[kStages][kStages] = {};
  constexpr SquaredWeights()
  {
    for (int i = 0; i < kStages; ++i)
      for (int j = 1; j <= i; ++j)
        for (int k = 0; k < j; ++k) weight[i][k] += kWeights[i][j] * kWeights[j - 1][k];
  }
};
constexpr SquaredWeights kSquared;

/// toX = x + reach v + h^2 (q_0 a_0 + ...), toV = v + h (w_0 a_0 + ...), in one sweep; a_j = F_j/m.
ESM_CPU_CLONES void combine(std::size_t count, int stages, const double* w, const double* q, double reach,
                            double h, const Lanes* const* a, const Lanes* x, const Lanes* v, Lanes* toX,
                            Lanes* toV) noexcept
{
  for (std::size_t i = 0; i < count; ++i) {
    Lanes sumX = a[0][i] * q[0], sumV = a[0][i] * w[0];
    for (int j = 1; j < stages; ++j) {
      sumX += a[j][i] * q[j];
      sumV += a[j][i] * w[j];
    }
    toX[i] = x[i] + v[i] * reach + sumX * (h * h);
    toV[i] = v[i] + sumV * h;
  }
}

/// The explicit Runge-Kutta method of fifth order by Dormand and Prince, six force passes per step: the
/// seventh stage opens the next step. Work and heat go through the same quadrature.
class DormandPrince final : public Integrator {
public:
  void prepare(const System& system) override
  {
    for (NodeArray& array : m_a) array.assign(system.nodeCount(), Lanes{0, 0, 0, 0});
    m_x = m_v = m_a[0];
    m_started = false;
  }
  void restart() noexcept override { m_started = false; }
  int order() const noexcept override { return 5; }
  double stepCost(const System& system) override
  {
    return 6.0 * system.forces().passCost() +
           9.8 * static_cast<double>(system.nodeCount()); // sweeps, measured
  }

  /// The stable region reaches to -3.3 on the real axis. It leaves the imaginary one at 1.0 but holds lightly
  /// damped modes up to 2.4 well enough: so only what has no damper must keep to 1.
  double stableStep(const FastestMode& mode) const noexcept override
  {
    const double undamped = mode.leastDamping > 0.0 ? mode.undamped : mode.stiffness;
    const double rate =
      std::max(std::sqrt(mode.stiffness) / 2.4, std::sqrt(std::min(undamped, mode.stiffness)));
    return 1.0 / std::max({rate, mode.damping / 3.2, 1e-300});
  }

  StepResult step(System& system, MotionState& state, double h, double end, StepReport& report) override
  {
    const std::size_t count = state.x.size();
    std::array<const Lanes*, kStages + 1> a{};
    for (std::size_t j = 0; j <= kStages; ++j) a[j] = m_a[j].data();
    if (!m_started) {
      m_rates = system.evaluate(state.time, state.x, state.v, m_a[0]);
      system.toAccelerations(m_a[0]);
      m_started = true;
    }
    Rates sum{kWeights[kStages - 1][0] * m_rates.work, kWeights[kStages - 1][0] * m_rates.heat}, last;
    for (std::size_t j = 0; j < kStages; ++j) {
      combine(count, static_cast<int>(j) + 1, kWeights[j], kSquared.weight[j], kNode[j + 1] * h, h, a.data(),
              state.x.data(), state.v.data(), m_x.data(), m_v.data());
      const double t = j + 1 >= kStages - 1 ? end : state.time + kNode[j + 1] * h;
      last = system.evaluate(t, m_x, m_v, m_a[j + 1]);
      system.toAccelerations(m_a[j + 1]);
      const double weight = j + 1 < kStages ? kWeights[kStages - 1][j + 1] : 0.0;
      sum.work += weight * last.work;
      sum.heat += weight * last.heat;
    }
    ++report.steps;
    if (!allFinite(m_x, m_v)) return StepResult::NonFinite;
    std::swap(m_a[0], m_a[kStages]);
    m_rates = last;
    state.advanceTo(end, m_x, m_v, h * sum.work, h * sum.heat);
    return StepResult::Done;
  }

private:
  std::array<NodeArray, kStages + 1> m_a; ///< the stages' accelerations
  NodeArray m_x, m_v;
  Rates m_rates;
  bool m_started = false;
};

} // namespace

std::unique_ptr<Integrator> makeDormandPrince()
{
  return std::make_unique<DormandPrince>();
}

} // namespace esm
