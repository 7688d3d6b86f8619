// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/bounds/step_bound.h"

#include <array>

namespace esm {

/// The explicit treatment of viscosity in s stages. One step takes the velocity of a mode with damping rate g
/// from v to P(h g) v, where exp(-h g) would be exact. P is a shifted and damped Chebyshev polynomial T_s, so
/// that stages pay quadratically (van der Houwen and Sommeijer 1980; Verwer, Hundsdorfer and Sommeijer 1990):
///
///     order 1   P(z) = T_s(w0 - w1 z)/T_s(w0),   |P| <= 0.54 up to z ~ 1.4 s^2
///                                                (2, 5.7, 12.6, 22 for 1, 2, 3, 4 stages)
///     order 2   P(z) = a + b T_s(w0 - w1 z),     -1/3 < P < 1 up to z ~ 2/3 (s^2 - 1)
///                                                (2, 5.2, 9.8 for 2, 3, 4 stages)
///
/// One stage of order 1 is the plain explicit Euler step. With order 1 slow modes lose up to half of h g of
/// their damping, with order 2 about (h g)^2/6.
///
///     d_1 = a,   d_j = mu_j d_{j-1} + nu_j d_{j-2} + push_j a - kick_j h M^-1 D d_{j-1},   v <- v + d_s
///
/// with a = h M^-1 F(x, v), d_0 = 0, mu_2 = 0 and nu_3 = 0: as the first difference is a multiple of a, its
/// factor stands in what follows from it, and sweeps over the nodes need not hold it. So stage 2 takes a, and
/// stage 3 takes a and d_2.
class ChebyshevDamping {
public:
  static constexpr int kMostStages = 8;

  /// @pre 1 <= stages <= kMostStages; order 1 or 2, order 2 with at least two stages.
  /// @param inPhase  the kicks hold Stoermer's second difference, see stableStep(). The stages are the same.
  ChebyshevDamping(int stages, int order, bool inPhase = false);

  int stages() const noexcept { return m_stages; }
  struct Stage {
    double mu, nu, push, kick;
  };
  const Stage& stage(int j) const noexcept { return m_stage[static_cast<std::size_t>(j)]; } ///< 2 <= j <= s
  double value(double z) const noexcept;                                                    ///< P(z)

  /// The largest step [s] such that this one and all smaller ones are stable, for every net within the
  /// bounds.
  ///
  /// With Z = h M^-1 D a leapfrog step is x' = x + h v', v' = P(Z) v - (1 - P(Z))/Z h M^-1 K x. In f(Z) =
  /// Z/(1 - P), all symmetric, it reads f (x'' - x') - f P (x' - x) + h^2 M^-1 K x' = 0, which is stable if
  /// h^2 M^-1 K < 2 (1 + P) f; the matrices need not commute. M^-1 K is at most `stiffness`, at most
  /// `undamped` + M^-1 D/leastDamping, and at most the like with `owedShare`, so at most any mean of two of
  /// them: one mean that is below for all eigenvalues of Z is enough. So steps may exceed 2/w where the
  /// fastest modes are the best damped, as they are in tissue.
  ///
  /// With the second difference of the forces F in the kick, F + (F - 2 F' + F'')/12, a mode that changes its
  /// sign at every step meets 4/3 F, damping included: the same without matrices then reads
  /// h^2 w2 < 3 f - 2 Z. That is where the limit was for dampers in proportion to the springs, whatever their
  /// strength and the stages (by the recurrence's roots), and for all nets that were tried.
  double stableStep(const FastestMode& mode) const noexcept;
  /// What viscosity alone would allow [s].
  double viscousLimit(double damping) const noexcept { return m_reach / damping; }

private:
  static constexpr std::size_t kSamples = 48; ///< of the damping rates, to look at stability

  /// M^-1 K <= rest + perDamping M^-1 D
  struct StiffnessBound {
    double rest, perDamping; ///< [1/s^2], [1/s]
  };
  bool isStable(double h, const FastestMode& mode) const noexcept;
  bool isStable(double h, double damping, const StiffnessBound& one,
                const StiffnessBound& other) const noexcept;
  double rateOf(std::size_t sample) const noexcept
  {
    return m_reach * static_cast<double>(sample) / kSamples;
  }
  double roomAt(double z) const noexcept;
  void sampleRoom() noexcept;

  int m_stages;
  double m_alternating = 1.0;         ///< what a force counts in the kick that changes its sign at every step
  double m_w0 = 1.0, m_w1 = 1.0;      ///< w0, w1
  double m_base = 0.0, m_swing = 1.0; ///< P = base + swing T_s
  double m_reach = 2.0;               ///< |P| < 1 up to here
  std::array<Stage, kMostStages + 1> m_stage{};
  std::array<double, kSamples> m_room{}; ///< roomAt(rateOf(i)), up to m_reach
};

} // namespace esm
