// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/methods/runge_kutta.h"
#include "core/forces/spring_pass.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace esm {

const RungeKuttaTableau kClassicalRungeKutta = {
  4,
  4,
  false,
  6.5,
  {0.0, 0.5, 0.5, 1.0},
  {{{0.5}, {0.0, 0.5}, {0.0, 0.0, 1.0}, {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6}}}};

const RungeKuttaTableau kDormandPrince = {
  7,
  5,
  true,
  11.5,
  {0.0, 1.0 / 5, 3.0 / 10, 4.0 / 5, 8.0 / 9, 1.0, 1.0},
  {{{1.0 / 5},
    {3.0 / 40, 9.0 / 40},
    {44.0 / 45, -56.0 / 15, 32.0 / 9},
    {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
    {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656},
    {35.0 / 384, 0.0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84},
    {35.0 / 384, 0.0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84, 0.0}}}};

namespace {

/// One row of sums: to = start + h (w_0 k_0 + ...). As x' = v, a stage's position needs no velocities of the
/// stages before (Nystroem's form): x_i = x + c_i h v + h^2 sum_k (A^2)_ik a_k.
struct Sums {
  double drift, h; ///< [s]
  RungeKuttaTableau::Row velocity, position;
  std::array<const Lanes*, RungeKuttaTableau::kMostStages> force; ///< of the stages
  const double* inverseMass;
};

template <int terms>
ESM_INLINE void combineTerms(std::size_t first, std::size_t count, const Sums& given, const Lanes* x,
                             const Lanes* v, Lanes* toX, Lanes* toV) noexcept
{
  const Sums row = given; // as ESM_CPU_CLONES says
  const double h = row.h, square = h * h;
  for (std::size_t i = first; i < first + count; ++i) {
    Lanes sumX = row.force[0][i] * row.position[0], sumV = row.force[0][i] * row.velocity[0];
    for (std::size_t j = 1; j < terms; ++j) {
      sumX += row.force[j][i] * row.position[j];
      sumV += row.force[j][i] * row.velocity[j];
    }
    toX[i] = x[i] + v[i] * row.drift + sumX * (square * row.inverseMass[i]);
    toV[i] = v[i] + sumV * (h * row.inverseMass[i]);
  }
}

ESM_CPU_CLONES void combine(int terms, std::size_t first, std::size_t count, const Sums& row, const Lanes* x,
                            const Lanes* v, Lanes* toX, Lanes* toV) noexcept
{
  switch (terms) {
  case 1:
    return combineTerms<1>(first, count, row, x, v, toX, toV);
  case 2:
    return combineTerms<2>(first, count, row, x, v, toX, toV);
  case 3:
    return combineTerms<3>(first, count, row, x, v, toX, toV);
  case 4:
    return combineTerms<4>(first, count, row, x, v, toX, toV);
  case 5:
    return combineTerms<5>(first, count, row, x, v, toX, toV);
  default:
    return combineTerms<6>(first, count, row, x, v, toX, toV);
  }
}

/// The stable region holds the half disc |h s| < 2.7 left of the imaginary axis.
double stableStepOfFourthOrder(const FastestMode& mode) noexcept
{
  return 2.7 / std::max(std::sqrt(mode.stiffness), mode.decay);
}

/// The stable region reaches to -3.3 on the real axis. It leaves the imaginary one at 1.0 but holds lightly
/// damped modes up to 2.4 well enough: so only what has no damper must keep to 1.
double stableStepOfFifthOrder(const FastestMode& mode) noexcept
{
  const double undamped = mode.leastDamping > 0.0 ? mode.undamped : mode.stiffness;
  const double rate =
    std::max(std::sqrt(mode.stiffness) / 2.4, std::sqrt(std::min(undamped, mode.stiffness)));
  return 1.0 / std::max({rate, mode.decay / 3.2, 1e-300});
}

} // namespace

RungeKutta::RungeKutta(const RungeKuttaTableau& tableau) : m_tableau(tableau)
{
  for (std::size_t i = 0; i < stages(); ++i)
    for (std::size_t j = 1; j <= i; ++j)
      for (std::size_t k = 0; k < j; ++k) m_squared[i][k] += tableau.weight[i][j] * tableau.weight[j - 1][k];
}

void RungeKutta::prepare(const System& system)
{
  m_force.resize(stages());
  for (NodeArray& array : m_force) array.assign(system.nodeCount(), Lanes{0, 0, 0, 0});
  m_x = m_v = m_force[0];
  m_started = false;
}

double RungeKutta::stepCost(const System& system, double /*h*/)
{
  return static_cast<double>(rows()) * system.forces().passCost() +
         system.sweepCost(m_tableau.cost, 1.6 * m_tableau.cost);
}

double RungeKutta::stableStep(const FastestMode& mode) const noexcept
{
  return m_tableau.firstIsLast ? stableStepOfFifthOrder(mode) : stableStepOfFourthOrder(mode);
}

StepResult RungeKutta::step(System& system, MotionState& state, double h, double end, StepReport& report)
{
  if (!m_started) m_rates = system.evaluate(state.time, state.x, state.v, m_force[0]);
  const auto& last = m_tableau.weight[stages() - 1];
  Rates sum{last[0] * m_rates.work, last[0] * m_rates.heat}, rates;
  for (std::size_t i = 0; i < rows(); ++i) {
    sumRow(i, h, system, state);
    if (i + 1 == stages()) break;
    const double node = m_tableau.node[i + 1], t = node < 1.0 ? state.time + node * h : end;
    rates = system.evaluate(t, m_x, m_v, m_force[i + 1]);
    sum.work += last[i + 1] * rates.work;
    sum.heat += last[i + 1] * rates.heat;
  }
  if (!m_tableau.firstIsLast) system.place(end, m_x, m_v);
  ++report.steps;
  if (!allFinite(m_x, m_v)) return StepResult::NonFinite;
  m_started = m_tableau.firstIsLast;
  if (m_started) {
    std::swap(m_force.front(), m_force.back());
    m_rates = rates;
  }
  state.advanceTo(end, m_x, m_v, h * sum.work, h * sum.heat);
  return StepResult::Done;
}

void RungeKutta::sumRow(std::size_t i, double h, const System& system, const MotionState& state) noexcept
{
  Sums row{i + 1 < stages() ? m_tableau.node[i + 1] * h : h,
           h,
           m_tableau.weight[i],
           m_squared[i],
           {},
           system.inverseMass().data()};
  for (std::size_t j = 0; j <= i; ++j) row.force[j] = m_force[j].data();
  system.sweepNodes([&](std::size_t first, std::size_t count) noexcept {
    combine(static_cast<int>(i) + 1, first, count, row, state.x.data(), state.v.data(), m_x.data(),
            m_v.data());
  });
}

std::unique_ptr<Integrator> makeRungeKutta4()
{
  return std::make_unique<RungeKutta>(kClassicalRungeKutta);
}

std::unique_ptr<Integrator> makeDormandPrince()
{
  return std::make_unique<RungeKutta>(kDormandPrince);
}

} // namespace esm
