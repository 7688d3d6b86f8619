// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/methods/integrator.h"
#include "core/dynamics/methods/verlet_sweeps.h"

#include <cmath>
#include <utility>

namespace esm {
namespace {

/// Velocity Verlet with one force pass per step:
///
///     w = v + h/2 a,   x' = x + h w,   p' = v + h a + c (p - v),   a' = f(x', p')/m,   v' = w + h/2 a'
///
/// The viscous force needs the velocity at the end of the step before it is known, so it takes the prediction
/// p'. Its error is O(h^2), enough for second order. The last term of p' carries over a share c of the
/// former prediction's error: that widens the limit for viscosity from h g < 1 to h g < 1 + c and leaves the
/// one for stiffness, h w < 2; between the two the limit is h^2 w^2 / 4 + h g / (1 + c) < 1. As errors of the
/// prediction grow with 1/(1 - c), a step carries no more than its length asks for, at most two thirds.
class Verlet final : public Integrator {
public:
  void prepare(const System& /*system*/) override
  {
    m_started = m_hasRoom = false; // it is often weighed only
  }
  void restart() noexcept override { m_started = false; }
  int order() const noexcept override { return 2; }
  void tune(const System& /*system*/, const FastestMode& mode) noexcept override { m_mode = mode; }
  double stepCost(const System& system, double /*h*/) override
  {
    return system.forces().passCost() + 0.8 * static_cast<double>(system.nodeCount()); // sweeps, measured
  }

  double stableStep(const FastestMode& mode) const noexcept override
  {
    // Positive root of (K/4) h^2 + G/(1 + c) h - 1 = 0, in the form that bears K = 0.
    const double linear = mode.damping / (1.0 + kMostCarry);
    return 2.0 / (linear + std::sqrt(linear * linear + mode.stiffness));
  }

  StepResult run(System& system, MotionState& state, double end, std::int64_t steps,
                 StepReport& report) override
  {
    const double begin = state.time, h = (end - begin) / static_cast<double>(steps);
    const double* inverseMass = system.inverseMass().data();
    const Prediction how{h, carryFor(h)};
    if (!std::exchange(m_hasRoom, true))
      for (NodeArray* array : {&m_a, &m_p, &m_x, &m_v, &m_force})
        array->assign(system.nodeCount(), Lanes{0, 0, 0, 0});
    if (!m_started) start(system, state);
    m_x = state.x; // same size: no allocation
    m_v = state.v;
    double work = 0.0, heat = 0.0;
    for (std::int64_t i = 1; i <= steps; ++i) {
      const double t = i == steps ? end : begin + static_cast<double>(i) * h;
      const auto sweep = [&, isFirst = i == 1](std::size_t f, std::size_t n) noexcept {
        if (isFirst)
          predictNodes(how, n, m_a.data() + f, m_x.data() + f, m_v.data() + f, m_p.data() + f);
        else
          correctAndPredictNodes(how, n, inverseMass + f, m_force.data() + f, m_x.data() + f, m_v.data() + f,
                                 m_p.data() + f);
      };
      const Rates rates = system.evaluate(t, m_x, m_p, m_force, nullptr, sweep);
      work += 0.5 * (m_rates.work + rates.work);
      heat += 0.5 * (m_rates.heat + rates.heat);
      m_rates = rates;
    }
    system.sweepNodes([&](std::size_t f, std::size_t n) noexcept {
      correctNodes(h, n, inverseMass + f, m_force.data() + f, m_a.data() + f, m_v.data() + f);
    });
    report.steps += steps;
    m_started = allFinite(m_x, m_v);
    if (!m_started) return StepResult::NonFinite;
    state.advanceTo(end, m_x, m_v, h * work, h * heat);
    return StepResult::Done;
  }

private:
  /// The least that is stable at h, with room for what the net's motion does to the limits until the next
  /// look.
  double carryFor(double h) const noexcept
  {
    return leastCarry(m_mode.stiffness, m_mode.damping, h / kRoomForMotion);
  }

  void start(System& system, MotionState& state) noexcept
  {
    m_rates = system.evaluate(state.time, state.x, state.v, m_a);
    m_p = state.v; // same size: no allocation
    system.toAccelerations(m_a);
    m_started = true;
  }

  NodeArray m_a, m_p; ///< acceleration and predicted velocity at the state
  NodeArray m_x, m_v, m_force;
  FastestMode m_mode; ///< at the last tune()
  Rates m_rates;
  bool m_started = false, m_hasRoom = false;
};

} // namespace

std::unique_ptr<Integrator> makeVerlet()
{
  return std::make_unique<Verlet>();
}

} // namespace esm
