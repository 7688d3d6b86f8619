// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/methods/integrator.h"

#include <utility>

namespace esm {

/// Implicit Euler as a descent: a step that cannot fail. The step y of implicit Euler is where the
/// incremental potential is least (Kane, Marsden, Ortiz and West 2000; Gast et al. 2015),
///
///     P(y) = sum m/(2 h^2) |y - x - h v|^2 + V(y) - f.(y - x) + h/2 R(y, w),   w = (y - x)/h
///
/// V springs, anchors, tools and weight, f the loads, R the power of all dampers. Newton's method with the
/// convex matrix, solved in whatever way, gives directions, and a line search sees to it that P falls. So
/// whatever y it stops at, P(y) <= P(x), which says that
///
///     V(y) - f.(y - x) + sum m/2 |w - v|^2 <= V(x) + sum m/2 |v|^2:
///
/// what is stored came from somewhere, whatever the net, the step and the number of iterations (where
/// supports or tools move dampers, step() checks it). The new velocity w is shortened if kinetic energy would
/// be more than what is left. Strongly damped, first order. The supports move first, then the net follows.
class IncrementalDescent : public Integrator {
public:
  void prepare(const System& system) final;
  void restart() noexcept final {}
  void constraintsChanged(const System& system) final { constrain(system); }
  int order() const noexcept final { return 1; }
  bool isUncontrolled() const noexcept final { return true; }
  bool findsLoss() const noexcept final { return true; }
  bool keepsLoan() const noexcept final { return true; }
  bool brakesBodies() const noexcept final { return true; }
  double takeLocalError() noexcept final { return std::exchange(m_localError, 0.0); }
  double stableStep(const FastestMode& mode) const noexcept final;
  double stepCost(const System& system, double h) final;
  StepResult step(System& system, MotionState& state, double h, double end, StepReport& report) final;
  /// Each step has its share of what the work limit leaves, so that none is left without.
  StepResult run(System& system, MotionState& state, double end, std::int64_t steps,
                 StepReport& report) final;

protected:
  struct Effort {
    int iterations; ///< of a step at most
    double usual;   ///< iterations, for stepCost()
    double enough;  ///< an iteration that gains less of what all have gained is the last
    /// And so is one that gains what the matrix foretells, to within this share.
    double asForetold;
    bool coasts; ///< begins where the velocity leads, if that is lower
  };
  explicit IncrementalDescent(Effort effort) noexcept : m_effort(effort) {}

private:
  virtual void layOut(const System& system) = 0;
  virtual void constrain(const System& system) = 0;
  /// The matrix M + h D + h^2 K at y, w, without negative stiffness. @return whether it can be solved with.
  virtual bool setMatrix(System& system, const NodeArray& y, const NodeArray& w, double h,
                         StepReport& report) = 0;
  /// vector = its inverse times vector, or what points the same way; 0 at held nodes.
  /// @param first  a direction that is likely, or null
  /// @return the share that may be left of what the inverse itself would lower the potential by [1]
  virtual double solve(System& system, NodeArray& vector, const NodeArray* first) = 0;
  virtual double matrixCost(const System& system) const noexcept = 0; ///< both [spring evaluations]

  struct Goal {
    const NodeArray& v; ///< at the start
    double h, end;
  };
  struct Sums {
    double potential = 0.0; ///< P [J]
    double stored = 0.0;    ///< V [J]
    double elastic = 0.0;   ///< of that [J]
    double loadWork = 0.0;  ///< f.(y - x) [J]
    double heatPower = 0.0; ///< [W]
  };
  Sums look(System& system, const Goal& goal, NodeArray& y) noexcept;
  double dragPower(System& system, const Sums& sums) noexcept;
  Sums start(System& system, const Goal& goal, double atRest) noexcept;
  Sums descend(System& system, const Goal& goal, Sums best, double own, StepReport& report);

  Effort m_effort;
  NodeArray m_x; ///< at the start, supports moved [m]
  NodeArray m_y, m_trial, m_w, m_force, m_change;
  NodeArray m_damper;        ///< of the last look
  double m_unsolved = 0.0;   ///< of the last descent, see solve() [m]
  double m_localError = 0.0; ///< since takeLocalError() [m]
  bool m_isDone = true;      ///< the last descent got where it no longer gains much
};

} // namespace esm
