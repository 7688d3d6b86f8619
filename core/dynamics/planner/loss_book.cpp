// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/planner/loss_book.h"

#include <algorithm>
#include <utility>

namespace esm {

void LossBook::prepare(const System& system)
{
  m_loss.prepare(system);
  m_unseen.isOpen = false;
}

/// While supports have lent something the balance tells: beside a jump's energy no quadrature sees what is left of it.
void LossBook::bookLoan(const System& system, const MotionState& start, MotionState& state,
                        EnergyGuard& energy)
{
  m_unseen.isOpen = false; // Descent has closed what was before
  const EnergyBalance balance = energy.balance(system, start, state);
  const double lost = (state.restored - start.restored) - balance.gained - balance.heat;
  state.loss = start.loss + std::min(lost, 0.0);
  state.settle(std::max(lost, 0.0), balance.heat,
               system.kineticEnergy(state.v) + std::max(system.elasticEnergy(state.x), 0.0));
}

void LossBook::book(const System& system, const MotionState& start, MotionState& state,
                    Integrator& integrator, double step, EnergyGuard& energy, double tolerance)
{
  if (state.loan.isOpen() && !integrator.keepsLoan()) return bookLoan(system, start, state, energy);
  if (integrator.findsLoss()) {
    state.loss += close(system, start, tolerance);
    return;
  }
  if (!m_unseen.isOpen) m_unseen.start = start; // same size: no allocation
  m_unseen.isOpen = true;
  const double springs = std::max(static_cast<double>(system.forces().activeSprings()), 1.0);
  m_unseen.passes += (state.time - start.time) / step * integrator.stepCost(system, step) / springs;
  if (m_unseen.passes >= m_policy->energy.lossLook) state.loss += close(system, state, tolerance);
}

double LossBook::close(const System& system, const MotionState& state, double tolerance)
{
  const MotionState& start = m_unseen.start;
  const bool isBehind = start.x.size() == state.x.size() && start.time < state.time;
  if (!std::exchange(m_unseen.isOpen, false) || !isBehind) return 0.0;
  m_unseen.passes = 0.0;
  m_loss.restart();
  const double given = (state.work - start.work) + (state.restored - start.restored);
  return m_loss.find(system, start, state.x, state.v, given, state.heat - start.heat,
                     std::min(m_policy->energy.lossPrecision * tolerance, m_policy->energy.mostLossError));
}

} // namespace esm
