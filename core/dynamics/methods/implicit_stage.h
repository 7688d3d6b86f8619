// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/methods/integrator.h"
#include "core/dynamics/methods/secant_pairs.h"
#include "core/dynamics/system/implicit_matrix.h"

namespace esm {

/// Solves the equation that the stages of all implicit methods come down to, for v of the free nodes:
///
///     M (v - startV) = s F(t, x, v),   x = startX + s v
///
/// by Newton's method with an old factor. A factor is kept over stages, steps and moderate changes of s as
/// long as it pays: what the iterations beyond those of a fresh factor have cost is added up, and when it
/// reaches the price of a factor, a new one is made; so it is where what is still to come would cost more.
/// SecantPairs keep the old one useful. How much of the error an iteration leaves is seen from
/// the residual that follows it, so that no last iteration is spent on finding out that none was needed.
class ImplicitStage {
public:
  void prepare(const System& system);
  void constraintsChanged(const System& system);
  void setTolerance(double tolerance, bool rough) noexcept
  {
    m_tolerance = tolerance;
    m_rough = rough;
  }

  /// @param v  in: a guess; out: the solution. Held nodes are put to their place at t.
  /// @param x  out: startX + s v.
  /// @param rates  out: powers at the solution.
  StepResult solve(System& system, double t, double s, const NodeArray& startX, const NodeArray& startV,
                   NodeArray& v, NodeArray& x, Rates& rates, StepReport& report);

  /// Of one stage, averaged over what the last stages took [spring evaluations].
  double cost(const System& system) const noexcept;

private:
  void makeRoom(const System& system);
  struct Problem {
    System& system;
    double t, s;
    const NodeArray& startX;
    const NodeArray& startV;
  };
  double residual(const Problem& problem, NodeArray& v, NodeArray& x, Rates& rates) noexcept;
  bool refactor(const Problem& problem, const NodeArray& x, const NodeArray& v, bool convex,
                StepReport& report);
  double findChange(const Problem& problem);
  double tryChange(const Problem& problem, double norm, const NodeArray& v, NodeArray& x, double& fraction,
                   Rates& rates) noexcept;
  double leap(const Problem& problem, NodeArray& v, NodeArray& x, Rates& rates);
  double iterationCost(const System& system) const noexcept;
  bool isTooSlow(const System& system, double move, double left) const noexcept;
  void learn(double s, int iterations, int factors) noexcept;

  ImplicitMatrix m_matrix;
  SecantPairs m_pairs;                  ///< since the last factor, of steps with s = m_pairShare
  double m_pairShare = 0.0;             ///< [s]
  NodeArray m_force, m_change, m_trial; ///< residual with a minus; A^-1 of it; velocities tried
  NodeArray m_before;                   ///< the residual that m_change answers
  bool m_hasRoom = false;               ///< these arrays are there: from the first solve() on
  double m_tolerance = 1e-9;            ///< [m]
  double m_move = 0.0;                  ///< length of m_change in position [m], RMS over nodes
  bool m_rough = false;                 ///< a few iterations that gain are enough
  double m_factoredShare = 0.0;         ///< s of the factor at hand, 0 = none
  bool m_factorIsFresh = false;         ///< made at the present iterate
  bool m_factorIsConvex = false;
  int m_freshIterations = 0;                          ///< of the first stage after a factorization
  double m_excess = 0.0;                              ///< iterations beyond them since [1]
  double m_meanIterations = 2.0, m_meanFactors = 0.1; ///< per stage, running means
};

} // namespace esm
