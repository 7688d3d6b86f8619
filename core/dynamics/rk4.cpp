// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/integrator.h"
#include "core/forces/spring_pass.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace esm {
namespace {

/// Adds a stage's slopes (v, F/m) to the sums and moves on to the next stage, `reach` from the start.
ESM_CPU_CLONES void advanceStage(std::size_t count, double weight, double reach, const double* inverseMass,
                                 const Lanes* force, const Lanes* startX, const Lanes* startV, Lanes* sumX,
                                 Lanes* sumV, Lanes* x, Lanes* v) noexcept
{
  for (std::size_t i = 0; i < count; ++i) {
    const Lanes a = force[i] * inverseMass[i];
    sumX[i] += v[i] * weight;
    sumV[i] += a * weight;
    x[i] = startX[i] + v[i] * reach;
    v[i] = startV[i] + a * reach;
  }
}

/// The classical Runge-Kutta method of fourth order for x' = v, v' = f(t, x, v)/m. Work and heat go through
/// the same quadrature.
class RungeKutta4 final : public Integrator {
public:
  void prepare(const System& system) override
  {
    for (NodeArray* array : {&m_x, &m_v, &m_force, &m_sumX, &m_sumV})
      array->assign(system.nodeCount(), Lanes{0, 0, 0, 0});
  }
  void restart() noexcept override {}
  int order() const noexcept override { return 4; }
  double stepCost(const System& system) override
  {
    return 4.0 * system.forces().passCost() +
           5.5 * static_cast<double>(system.nodeCount()); // sweeps, measured
  }

  /// The stable region holds the half disc |h s| < 2.7 left of the imaginary axis; a mode's roots s obey
  /// |s| <= max(w, g).
  double stableStep(const FastestMode& mode) const noexcept override
  {
    return 2.7 / std::max(std::sqrt(mode.stiffness), mode.damping);
  }

  StepResult step(System& system, MotionState& state, double h, double end, StepReport& report) override
  {
    constexpr double kNode[4] = {0.0, 0.5, 0.5, 1.0};
    constexpr double kWeight[4] = {1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0};
    const std::size_t count = state.x.size();
    m_x = state.x; // same size: no allocation
    m_v = state.v;
    m_sumX = state.x;
    m_sumV = state.v;
    Rates sum;
    for (int stage = 0; stage < 4; ++stage) {
      const double t = stage == 3 ? end : state.time + kNode[stage] * h;
      const Rates rates = system.evaluate(t, m_x, m_v, m_force);
      sum.work += kWeight[stage] * rates.work;
      sum.heat += kWeight[stage] * rates.heat;
      const double weight = kWeight[stage] * h, reach = stage < 3 ? kNode[stage + 1] * h : 0.0;
      advanceStage(count, weight, reach, system.inverseMass().data(), m_force.data(), state.x.data(),
                   state.v.data(), m_sumX.data(), m_sumV.data(), m_x.data(), m_v.data());
    }
    system.place(end, m_sumX, m_sumV);
    ++report.steps;
    if (!allFinite(m_sumX, m_sumV)) return StepResult::NonFinite;
    state.advanceTo(end, m_sumX, m_sumV, h * sum.work, h * sum.heat);
    return StepResult::Done;
  }

private:
  NodeArray m_x, m_v, m_force, m_sumX, m_sumV;
};

} // namespace

std::unique_ptr<Integrator> makeRungeKutta4()
{
  return std::make_unique<RungeKutta4>();
}

} // namespace esm
