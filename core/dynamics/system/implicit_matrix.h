// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/dynamics/system/system.h"
#include "core/linear/block_cholesky.h"
#include "core/linear/low_rank.h"
#include "core/linear/preconditioned_cg.h"

namespace esm {

/// The matrix of an implicit step over the free nodes, and its Cholesky factor:
///
///     A = m M + s D + q K,   D = - dF/dv,   K = - sym dF/dx
///
/// D and K are sums of 3 x 3 blocks (SpringTangent, anchors, tools, mass damping), both symmetric. The
/// pattern is laid out and analysed once; afterwards nothing allocates. Pressure, which joins all nodes of a
/// body, comes as a column of its own beside the blocks (LowRankUpdate); one more solve for each factor.
///
/// In a net of more than kManyNodes nodes systems are solved by conjugate gradients, to a thousandth, which
/// is enough for Newton's method; once they have cost as much as a factor would have, the factor is made
/// after all, and from then on, if memory allows.
class ImplicitMatrix {
public:
  /// How much of each part goes in. A step of implicit share s [s] has mass 1, s, s^2.
  struct Shares {
    double mass = 1.0, viscosity = 0.0, stiffness = 0.0;
    static Shares ofStep(double s) noexcept { return {1.0, s, s * s}; }
  };

  static constexpr std::size_t kManyNodes = 40000;
  /// @param mayIterate  whether conjugate gradients may stand in for a factor.
  void prepare(const System& system, bool mayIterate = false);
  /// Nodes have become free or held; the layout is made anew only if one was held when it was made.
  void constraintsChanged(const System& system);

  /// Fills in the numbers at x, v and factors. With `convex`, softening, pressed and turning springs lend no
  /// negative stiffness, so that A is positive definite whatever the net does. The true A leads faster to a
  /// solution, even where a net that buckles makes it indefinite; the convex one is the safeguard.
  /// @return whether the factor exists.
  bool factor(const System& system, const NodeArray& x, const NodeArray& v, const Shares& shares,
              bool convex);
  /// vector = A^-1 vector; an entry per node of the net, those of held nodes become 0.
  void solve(NodeArray& vector);
  /// product = A vector with the numbers of the last factor(), held nodes left out.
  void multiply(const NodeArray& vector, NodeArray& product) const noexcept;
  /// A direction d with d.A d < 0, of the last factor(). @return false if there is none.
  bool negativeDirection(NodeArray& direction) noexcept;
  /// Largest stiffness over mass of a free node at x, v [1/s^2], the trace of its block over 3 m.
  double stiffestRate(const System& system, const NodeArray& x, const NodeArray& v);

  std::size_t freeCount() const noexcept { return m_free.size(); }
  /// Of the last factor(); 0: positive definite, as far as known.
  std::int64_t negativePivots() const noexcept
  {
    return m_isIterative ? m_metNegative : m_cholesky.negativePivots() - m_negativesGone;
  }
  /// Costs in spring evaluations of the force pass.
  double factorCost() const noexcept;
  double solveCost() const noexcept;

private:
  void layOut(const System& system);
  bool isLaidOut(const System& system) const noexcept;
  void makeRoom();
  void fill(const System& system, const NodeArray& x, const NodeArray& v, const Shares& shares, bool convex);
  void addSprings(const System& system, const Shares& shares, bool convex) noexcept;
  void fillPressure(const System& system, const NodeArray& x, const Shares& shares);
  void solveBlocks();
  void giveUpIterating();
  void scatter(NodeArray& vector) const noexcept;

  std::vector<Index> m_blockOf; ///< node -> block, kNoIndex if held when laid out
  std::vector<Index> m_nodeOf;  ///< block -> node
  std::vector<Index> m_free;    ///< blocks whose nodes are free now
  std::vector<Index> m_pairOf;  ///< active spring -> pair, kNoIndex unless both ends have blocks
  std::vector<NodePair> m_pairs;
  std::vector<std::uint8_t> m_isFree; ///< by block
  NodeBlocks m_diagonal, m_coupling;
  std::vector<SpringTangent> m_tangents;
  NodeArray m_vector; ///< by blocks
  struct PressureColumn {
    NodeArray gradient; ///< g by blocks, 0 at held nodes [m^2]
    NodeArray solved;   ///< (A without pressure)^-1 g
    double stiffness;   ///< of g g^T
  };
  std::vector<PressureColumn> m_pressure; ///< one per body
  LowRankUpdate m_update;
  std::int64_t m_negativesGone = 0; ///< by the pressure
  BlockCholesky m_cholesky;
  PreconditionedCg m_gradients;
  bool m_hasRoom = false; ///< for the numbers: from the first factor() on, many only ask for costs
  bool m_mayIterate = false, m_isIterative = false, m_isTooLarge = false;
  double m_spent = 0.0;           ///< on gradients since they were last judged [spring evaluations]
  std::int64_t m_metNegative = 0; ///< 1: the gradients met negative curvature
  double m_meanIterations = 20.0; ///< of the gradients, running mean
  std::size_t m_springs = 0;
};

} // namespace esm
