// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/methods/incremental_descent.h"
#include "core/dynamics/methods/step_gradients.h"

namespace esm {
namespace {

/// Directions of an iteration. Few, as springs that stiffen make the matrix true of short ways only: to look
/// at them anew brings more than to solve for long with what no longer holds.
constexpr int kFewSweeps = 8;
constexpr int kMostSweeps = 30;      ///< of the last one that the work limit leaves room for
constexpr double kLooks = 3.0;       ///< passes of an iteration besides matrix and directions
constexpr double kLeastGain = 3e-4;  ///< see StepGradients::solve()
constexpr double kUsualSweeps = 8.0; ///< for stepCost(), before any were seen

/// The interactive method: every node descends by its own 3 x 3 block, all at once, in conjugate directions.
/// Nothing is factored, so that a step of a frame costs some tens of force passes whatever the net, and can
/// be stopped between any two of them.
class BlockDescent final : public IncrementalDescent {
public:
  BlockDescent() noexcept : IncrementalDescent({6, 2.0, 0.02, 0.1, true}) {}

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
    const auto springs = static_cast<double>(system.forces().activeSprings());
    constexpr double kAnother =
      StepGradients::kPerSet + 2 * kFewSweeps * StepGradients::kPerIteration + kLooks;
    const bool isLast = system.workLimit - system.workDone() < kAnother * springs;
    const StepGradients::Solved solved =
      m_gradients.solve(system, vector, first, kLeastGain, isLast ? kMostSweeps : kFewSweeps);
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
