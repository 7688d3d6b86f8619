// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/grouped.h"
#include "core/dynamics/bounds/spectral_radius.h"
#include "core/dynamics/system/system.h"
#include "core/forces/spring_matrix.h"

namespace esm {

/// Upper bounds of the fastest motion that the net can make now: every mode obeys s'' + g s' + w2 s = 0 with
/// w2 <= stiffness and g <= damping.
struct FastestMode {
  double stiffness = 0.0; ///< of M^-1 K [1/s^2]
  double damping = 0.0;   ///< of M^-1 D [1/s]
  /// How fast anything can decay [1/s]: real roots s of the modes are in [-decay, 0]. <= damping, since
  /// stiffness holds up what a damper brakes: half of it at critical damping.
  double decay = 0.0;
  /// Part of `stiffness` that lends no damping (tension across the springs, springs without dampers) [1/s^2];
  /// to the rest every mode owes g >= leastDamping w2.
  double undamped = 0.0;
  double leastDamping = 0.0; ///< smallest c/k of the springs and anchors that are not in `undamped` [s]
  /// The same for a share of what is owed, g >= share leastDamping (w2 - undampedByShare): with less of it a
  /// little more is undamped [1/s^2], but the fastest mode owes no more than it has. No share: 1.
  double owedShare = 1.0, undampedByShare = 0.0;
  Index node = kNoIndex;        ///< who sets the larger of the two rates
  double springStiffness = 0.0; ///< sum over that node's springs, anchors and tools [N/m]
};

/// Of a step that is stable now, how much is taken when stages and predictions are chosen: room for what the
/// net's motion does to the limits until the next look; 0.95 was seen to fail.
inline constexpr double kRoomForMotion = 0.88;

/// Finds FastestMode from the springs' tangents at the present positions.
///
/// With B the matrix of spring directions, the axial part of M^-1 K has the eigenvalues of the S x S matrix
/// G(e, f) = sqrt(k_e k_f) u_e.u_f (+-1/m of the shared node); Gershgorin's row sums of |G| are a bound that
/// sees the directions, about 2/3 of the row sums over nodes in a triangle net. The part of the tension
/// across the springs, anchors, tools and mass damping are added with their row sums over nodes, the pressure
/// of a closed surface with its one eigenvalue. The smaller
/// of this and the plain row sums over nodes counts. Cost: a few force passes.
///
/// Such sums are 30 to 100 % above the true eigenvalues. So these are measured by Lanczos' iteration now and
/// then (after prepare(), and when the sums have moved by a tenth), and in between they follow the sums.
///
/// For r = -s of a real root, r^2 M - r D + K is singular: r is at most the largest eigenvalue of
/// M^-1 (D - K/q) for any q >= r. From q = `damping` on, that gives bounds that fall towards the fastest
/// root. What dampers leave over is the largest eigenvalue of M^-1 (K - D/leastDamping), of which the row
/// sums know only that it is no more than what the springs without dampers and the tensions make at a node.
class StepBound {
public:
  /// After any change of springs. What that takes is left to the next compute(), which may never come.
  /// @param findsDecay  else FastestMode::decay stays at what it cannot exceed, `damping`.
  void prepare(bool findsDecay = true) noexcept;
  FastestMode compute(const System& system, const NodeArray& x, const NodeArray& v);
  /// What is known stays; the next compute() allocates.
  void freeRoom();

private:
  void layOut(const System& system);
  void makeRoom(const System& system);
  void sumNodes(const System& system);
  void sumSprings(const System& system);
  void sumPairs(std::span<const std::uint32_t> springs, double inverseMass);
  void sumHub(std::span<const std::uint32_t> springs, const std::vector<double>& weight, double inverseMass,
              std::vector<double>& rows) const;
  void sumPressure(const System& system, const NodeArray& x);
  void weighDamping(const System& system, FastestMode& mode);
  void sharpen(const System& system, FastestMode& mode);
  /// What a product is taken with, D times the first plus K times the second.
  struct Blend {
    double damping, stiffness;
  };
  double measure(const System& system, Blend blend);
  double measureDecay(const System& system, const FastestMode& mode);
  double measureUndamped(const System& system, const FastestMode& mode, double share);
  void measureShares(const System& system, const FastestMode& mode);

  Grouped<std::uint32_t> m_springsOf; ///< active springs by node
  std::vector<SpringTangent> m_tangents;
  std::vector<double> m_rootStiffness, m_rootViscosity; ///< per active spring
  std::vector<double> m_rowStiffness, m_rowViscosity;   ///< per active spring
  struct NodeSums {
    double axial = 0.0, lateral = 0.0, viscous = 0.0; ///< row sums over springs, over the node's mass
    double stiffness = 0.0, damping = 0.0;            ///< the diagonal alone: anchors, tools, mass damping
    double total = 0.0;                               ///< [N/m]
  };
  std::vector<NodeSums> m_nodes;
  std::vector<double> m_undamped; ///< per node [1/s^2]
  // What is being measured: R (springs) R + diagonal, R the roots of the inverse masses.
  SpringMatrix m_springs;
  std::vector<double> m_rootInverseMass, m_diagonal;
  NodeArray m_scaled; ///< R z
  /// sqrt(K/V0) M^-1/2 dV/dx of each pressure body, N entries each.
  std::vector<NodeArray> m_pressure;
  double m_pressureStiffness = 0.0; ///< sum of their squares [1/s^2]
  std::vector<double> m_turning;    ///< N, bound of what turns with a pressed surface [N/m]; empty without
  Lanczos m_lanczos;
  struct Sharpness { ///< measured over row sums, and the row sums that it was measured at; 0: not yet
    double ratio = 1.0, at = 0.0;
  };
  Sharpness m_stiffnessSharpness, m_dampingSharpness;
  // Of the damping and of the sums of what is undamped, measured when one of those was.
  double m_decayShare = 0.0, m_undampedShare = 1.0;
  double m_owedShare = 1.0, m_undampedByShare = 1.0; ///< the latter in sums, too
  bool m_findsDecay = true;
  bool m_isLaidOut = false;
  int m_sinceMeasured = 0; ///< calls of compute()
};

} // namespace esm
