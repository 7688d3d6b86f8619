// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/methods/incremental_descent.h"
#include "core/dynamics/system/implicit_matrix.h"

namespace esm {
namespace {

/// With a factor for each iteration: the refuge where everything else fails.
class Descent final : public IncrementalDescent {
public:
  Descent() noexcept : IncrementalDescent({8, 4.0, 1e-3, 0.0, false}) {}

private:
  void layOut(const System& system) override { m_matrix.prepare(system, true); }
  void constrain(const System& system) override { m_matrix.constraintsChanged(system); }
  bool setMatrix(System& system, const NodeArray& y, const NodeArray& w, double h,
                 StepReport& report) override
  {
    ++report.factorizations;
    return m_matrix.factor(system, y, w, ImplicitMatrix::Shares::ofStep(h), true);
  }
  double solve(System& /*system*/, NodeArray& vector, const NodeArray* /*first*/) override
  {
    m_matrix.solve(vector);
    return 0.0;
  }
  double matrixCost(const System& /*system*/) const noexcept override
  {
    return m_matrix.factorCost() + m_matrix.solveCost();
  }

  ImplicitMatrix m_matrix;
};

} // namespace

std::unique_ptr<Integrator> makeDescent()
{
  return std::make_unique<Descent>();
}

} // namespace esm
