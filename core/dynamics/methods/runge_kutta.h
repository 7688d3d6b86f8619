// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/methods/integrator.h"

#include <array>

namespace esm {

/// An explicit Runge-Kutta method. Row i holds the weights of the slopes 0..i in stage i + 1, the last row
/// those in the result.
struct RungeKuttaTableau {
  static constexpr int kMostStages = 7;
  using Row = std::array<double, kMostStages>;

  int stages, order;
  bool firstIsLast; ///< the result is the last stage, whose slope opens the next step
  double cost;      ///< of the sweeps over nodes, in springs per node, measured
  Row node;
  std::array<Row, kMostStages> weight;
};

extern const RungeKuttaTableau kClassicalRungeKutta; ///< fourth order, four stages
extern const RungeKuttaTableau
  kDormandPrince; ///< RK5(4)7M (J. Comput. Appl. Math. 6, 1980), without its estimate

/// Work and heat go through the same quadrature as the motion.
class RungeKutta final : public Integrator {
public:
  explicit RungeKutta(const RungeKuttaTableau& tableau); ///< kept by reference

  void prepare(const System& system) override;
  void restart() noexcept override { m_started = false; }
  int order() const noexcept override { return m_tableau.order; }
  double stepCost(const System& system, double h) override;
  double stableStep(const FastestMode& mode) const noexcept override;
  bool asksForDecay() const noexcept override { return true; }
  StepResult step(System& system, MotionState& state, double h, double end, StepReport& report) override;

  /// Of the last step of a method whose first slope is not the last one of the step before: forces [N] and
  /// powers at its start. The array may be exchanged for another of its size.
  NodeArray& firstForce() noexcept { return m_force.front(); }
  const Rates& firstRates() const noexcept { return m_rates; }

private:
  using Row = RungeKuttaTableau::Row;

  std::size_t stages() const noexcept { return static_cast<std::size_t>(m_tableau.stages); }
  /// Sums, and with that new evaluations, per step.
  std::size_t rows() const noexcept { return m_tableau.firstIsLast ? stages() - 1 : stages(); }
  void sumRow(std::size_t i, double h, const System& system, const MotionState& state) noexcept;

  const RungeKuttaTableau& m_tableau;
  std::array<Row, RungeKuttaTableau::kMostStages> m_squared{}; ///< weights of the forces in positions
  std::vector<NodeArray> m_force;                              ///< at the stages [N]
  NodeArray m_x, m_v;
  Rates m_rates; ///< at the first stage
  bool m_started = false;
};

} // namespace esm
