// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/methods/incremental_descent.h"
#include "core/dynamics/methods/step_gradients.h"

namespace esm {
namespace {

constexpr int kMostSweeps = 30;       ///< of an iteration
constexpr double kLeastGain = 3e-4;   ///< see StepGradients::solve()
constexpr double kUsualSweeps = 15.0; ///< for stepCost(), before any were seen

/// The interactive method: every node descends by its own 3 x 3 block, all at once, in conjugate directions.
/// Nothing is factored, so that a step of a frame costs some tens of force passes whatever the net, and can
/// be stopped between any two of them.
class BlockDescent final : public IncrementalDescent {
public:
  BlockDescent() noexcept : IncrementalDescent({2, 0.02, 0.25, true}) {}

private:
  void layOut(const System& system) override { m_gradients.prepare(system); }
  void constrain(const System& /*system*/) override {}
  bool setMatrix(System& system, const NodeArray& y, const NodeArray& w, double h,
                 StepReport& /*report*/) override
  {
    system.solverWork += StepGradients::kPerSet * static_cast<double>(system.forces().activeSprings());
    return m_gradients.set(system, y, w, h);
  }
  double solve(System& system, NodeArray& vector, const NodeArray* first) override
  {
    const StepGradients::Solved solved = m_gradients.solve(system, vector, first, kLeastGain, kMostSweeps);
    m_sweeps += 0.1 * (solved.iterations - m_sweeps);
    return solved.left;
  }
  double matrixCost(const System& system) const noexcept override
  {
    return (StepGradients::kPerSet + m_sweeps * StepGradients::kPerIteration) *
           static_cast<double>(system.forces().activeSprings());
  }

  StepGradients m_gradients;
  double m_sweeps = kUsualSweeps; ///< running mean
};

} // namespace

std::unique_ptr<Integrator> makeBlockDescent()
{
  return std::make_unique<BlockDescent>();
}

} // namespace esm
