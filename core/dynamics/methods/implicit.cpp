// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/methods/implicit_guess.h"
#include "core/dynamics/methods/implicit_stage.h"
#include "core/dynamics/methods/integrator.h"
#include "core/dynamics/system/step_loss.h"

#include <array>
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
// Of the three slopes: what the step has less the method of third order of the same stages (Hosea and
// Shampine 1996, section 3).
const std::array<double, 3> kLocalError{(4.0 * kOuter - 1.0) / 3.0, -1.0 / 3.0, 2.0 * kDiagonal / 3.0};

/// to = from + s (one + other)
ESM_CPU_CLONES void advanceByBoth(std::size_t count, double s, const Lanes* from, const Lanes* one,
                                  const Lanes* other, Lanes* to) noexcept
{
  for (std::size_t i = 0; i < count; ++i) to[i] = from[i] + (one[i] + other[i]) * s;
}

/// @return sum over the nodes of the square of the step's error, over the step's length [m^2/s^2]
ESM_CPU_CLONES double localErrorOf(std::size_t count, const Lanes* first, const Lanes* middle,
                                   const Lanes* last) noexcept
{
  const auto [ofFirst, ofMiddle, ofLast] = kLocalError;
  Lanes sum = {0, 0, 0, 0};
  for (std::size_t i = 0; i < count; ++i) {
    const Lanes error = first[i] * ofFirst + middle[i] * ofMiddle + last[i] * ofLast;
    sum += error * error;
  }
  return sumLanes(sum);
}

class TrBdf2 final : public Integrator {
public:
  void prepare(const System& system) override
  {
    m_hasRoom = false; // it is often weighed only
    m_stage.prepare(system);
    m_loss.prepare(system);
    m_started = false;
  }
  void restart() noexcept override { m_started = false; }
  void constraintsChanged(const System& system) override
  {
    m_stage.constraintsChanged(system);
    m_started = false;
  }
  int order() const noexcept override { return 2; }
  bool findsLoss() const noexcept override { return true; }
  double takeLocalError() noexcept override { return std::exchange(m_localError, 0.0); }
  double stableStep(const FastestMode&) const noexcept override
  {
    return std::numeric_limits<double>::infinity();
  }
  void setSolveTolerance(double tolerance, bool rough) noexcept override
  {
    m_stage.setTolerance(tolerance, rough);
  }
  double stepCost(const System& system, double /*h*/) override { return 2.0 * m_stage.cost(system); }

  StepResult step(System& system, MotionState& state, double h, double end, StepReport& report) override
  {
    ++report.steps;
    if (!m_started) start(system, state);
    const double share = kDiagonal * h;
    Rates rates[3] = {m_rates, {}, {}};
    const bool isFirst = m_lastStep == 0.0;
    m_guessMiddle.set((1.0 - kMiddle) * m_lastStep, kMiddle * h, isFirst);
    m_guessMiddle.make(m_middleV, m_middleA, state.v, m_a, m_v);
    const std::size_t count = state.x.size();
    const double* const inverseMass = system.inverseMass().data();
    advanceNodes(count, share, state.x.data(), state.v.data(), m_startX.data());
    advanceNodes(count, share, state.v.data(), m_a.data(), m_startV.data());
    StepResult result =
      m_stage.solve(system, state.time + kMiddle * h, share, m_startX, m_startV, m_v, m_x, rates[1], report);
    if (result != StepResult::Done) return result;
    m_guessMiddle.judge(m_middleV, m_middleA, state.v, m_a, m_v);
    m_middleV = m_v; // same size: no allocation
    slopesTo(count, 1.0 / share, inverseMass, m_startV.data(), m_v.data(), m_middleA.data());
    advanceByBoth(count, kOuter * h, state.x.data(), state.v.data(), m_v.data(), m_startX.data());
    advanceByBoth(count, kOuter * h, state.v.data(), m_a.data(), m_middleA.data(), m_startV.data());
    m_guessEnd.set(kMiddle * h, (1.0 - kMiddle) * h, isFirst);
    m_guessEnd.make(state.v, m_a, m_middleV, m_middleA, m_v);
    result = m_stage.solve(system, end, share, m_startX, m_startV, m_v, m_x, rates[2], report);
    if (result != StepResult::Done) return result;
    m_guessEnd.judge(state.v, m_a, m_middleV, m_middleA, m_v);
    slopesTo(count, 1.0 / share, inverseMass, m_startV.data(), m_v.data(), m_a.data());
    m_localError += h * std::sqrt(localErrorOf(count, state.v.data(), m_middleV.data(), m_v.data()));
    const double work = h * (kOuter * (rates[0].work + rates[1].work) + kDiagonal * rates[2].work),
                 heat = h * (kOuter * (rates[0].heat + rates[1].heat) + kDiagonal * rates[2].heat);
    const double lost = m_loss.find(system, state, m_x, m_v, work, heat);
    state.advanceTo(end, m_x, m_v, work, heat, lost);
    m_rates = rates[2];
    m_lastStep = h;
    return StepResult::Done;
  }

private:
  void start(System& system, MotionState& state)
  {
    if (!std::exchange(m_hasRoom, true))
      for (NodeArray* array : {&m_a, &m_middleV, &m_middleA, &m_x, &m_v, &m_startX, &m_startV})
        array->assign(system.nodeCount(), Lanes{0, 0, 0, 0});
    m_rates = system.evaluate(state.time, state.x, state.v, m_a);
    system.toAccelerations(m_a);
    m_loss.restart();
    m_started = true;
    m_lastStep = 0.0;
  }

  NodeArray m_a, m_middleV, m_middleA; ///< acceleration at the state; velocity, acceleration at the middle
  NodeArray m_x, m_v, m_startX, m_startV;
  Rates m_rates;
  ImplicitStage m_stage;
  StepLoss m_loss;
  StageGuess m_guessMiddle, m_guessEnd;
  double m_localError = 0.0; ///< since takeLocalError() [m]
  double m_lastStep = 0.0;   ///< [s], 0: the first step
  bool m_started = false, m_hasRoom = false;
};

} // namespace

std::unique_ptr<Integrator> makeImplicit()
{
  return std::make_unique<TrBdf2>();
}

} // namespace esm
