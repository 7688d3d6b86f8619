// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/integrator.h"
#include "core/forces/spring_pass.h"

#include <cmath>
#include <utility>

namespace esm {
namespace {

/// half = v + h/2 a, x' = x + h half, p' = (v + 2 p)/3 + h a
ESM_CPU_CLONES void predict(double h, std::size_t first, std::size_t count, const Lanes* x, const Lanes* v,
                            const Lanes* a, const Lanes* p, Lanes* nextX, Lanes* half, Lanes* nextP) noexcept
{
  const Lanes third = Lanes{0, 0, 0, 0} + 1.0 / 3.0;
  for (std::size_t i = first; i < first + count; ++i) {
    half[i] = v[i] + a[i] * (0.5 * h);
    nextX[i] = x[i] + half[i] * h;
    nextP[i] = (v[i] + p[i] + p[i]) * third + a[i] * h;
  }
}

/// a = F/m, v' = half + h/2 a
ESM_CPU_CLONES void correct(double h, std::size_t first, std::size_t count, const double* inverseMass,
                            Lanes* force, Lanes* half) noexcept
{
  for (std::size_t i = first; i < first + count; ++i) {
    force[i] *= inverseMass[i];
    half[i] += force[i] * (0.5 * h);
  }
}

/// Velocity Verlet with one force pass per step:
///
///     w = v + h/2 a,   x' = x + h w,   p' = v + h a + (2/3)(p - v),   a' = f(x', p')/m,   v' = w + h/2 a'
///
/// The viscous force needs the velocity at the end of the step before it is known, so it takes the prediction
/// p'. Its error is O(h^2), enough for second order. The last term of p' carries over two thirds of the
/// former prediction's error: that widens the limit for viscosity from h g < 1 to h g < 5/3 and leaves the
/// one for stiffness, h w < 2; between the two the limit is h^2 w^2 / 4 + 3/5 h g < 1.
class Verlet final : public Integrator {
public:
  void prepare(const System& system) override
  {
    for (NodeArray* array : {&m_a, &m_p, &m_nextX, &m_nextV, &m_nextP, &m_force})
      array->assign(system.nodeCount(), Lanes{0, 0, 0, 0});
    m_started = false;
  }
  void restart() noexcept override { m_started = false; }
  int order() const noexcept override { return 2; }
  double stepCost(const System& system, double /*h*/) override
  {
    return system.forces().passCost() + 1.6 * static_cast<double>(system.nodeCount()); // sweeps, measured
  }

  double stableStep(const FastestMode& mode) const noexcept override
  {
    // Positive root of (K/4) h^2 + (3/5 G) h - 1 = 0, in the form that bears K = 0.
    const double linear = 0.6 * mode.damping;
    return 2.0 / (linear + std::sqrt(linear * linear + mode.stiffness));
  }

  StepResult step(System& system, MotionState& state, double h, double end, StepReport& report) override
  {
    const std::vector<double>& inverseMass = system.inverseMass();
    if (!m_started) start(system, state);
    system.sweepNodes([&](std::size_t first, std::size_t count) noexcept {
      predict(h, first, count, state.x.data(), state.v.data(), m_a.data(), m_p.data(), m_nextX.data(),
              m_nextV.data(), m_nextP.data());
    });
    const Rates rates = system.evaluate(end, m_nextX, m_nextP, m_force);
    system.sweepNodes([&](std::size_t first, std::size_t count) noexcept {
      correct(h, first, count, inverseMass.data(), m_force.data(), m_nextV.data());
    });
    ++report.steps;
    if (!allFinite(m_nextX, m_nextV)) return StepResult::NonFinite;
    std::swap(m_p, m_nextP);
    std::swap(m_a, m_force);
    state.advanceTo(end, m_nextX, m_nextV, 0.5 * h * (m_rates.work + rates.work),
                    0.5 * h * (m_rates.heat + rates.heat));
    m_rates = rates;
    return StepResult::Done;
  }

private:
  void start(System& system, MotionState& state) noexcept
  {
    m_rates = system.evaluate(state.time, state.x, state.v, m_a);
    m_p = state.v; // same size: no allocation
    system.toAccelerations(m_a);
    m_started = true;
  }

  NodeArray m_a, m_p; ///< acceleration and predicted velocity at the state
  NodeArray m_nextX, m_nextV, m_nextP, m_force;
  Rates m_rates;
  bool m_started = false;
};

} // namespace

std::unique_ptr<Integrator> makeVerlet()
{
  return std::make_unique<Verlet>();
}

} // namespace esm
