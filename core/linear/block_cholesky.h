// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/budget.h"
#include "core/forces/node_array.h"

#include <cstdint>
#include <limits>
#include <vector>

namespace esm {

/// A 3 x 3 block of a matrix over nodes, by columns; the fourth lanes are 0.
struct NodeBlock {
  Lanes column[3] = {{0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}};
};
using NodeBlocks = std::vector<NodeBlock, CacheLineAllocator<NodeBlock>>;

/// Two nodes that a matrix couples.
struct NodePair {
  Index a = kNoIndex, b = kNoIndex;
};

/// Order of elimination that keeps the factor small: by nested dissection of the graph (cut where fewest
/// nodes lie between two halves, the cut goes last, and so on inside) or by approximate minimum degree,
/// whichever gives less work. @return node eliminated at each place. Any thread, deterministic.
std::vector<Index> eliminationOrder(Index nodes, const std::vector<NodePair>& pairs);

/// Cholesky factor of a sparse symmetric matrix of 3 x 3 blocks, P A P^T = L S L^T, with S = +-1.
///
/// Multifrontal (Duff and Reid 1983): columns with nearly the same pattern are gathered in supernodes; each
/// is a dense front that its children's updates are added to, is factored by dense kernels, and passes its
/// own update to its parent. All that depends on the pattern alone is done once by analyze(), so that
/// factor(), but for its first call, and solve() neither search nor allocate. Sums run in a fixed order, lane by lane: equal input
/// gives equal bits on every CPU.
///
/// A negative pivot is taken as it is, without exchange: for a matrix that is indefinite the factor may be
/// inexact, and negativePivots() tells.
class BlockCholesky {
public:
  /// Lays out the factor of a matrix with a diagonal block for each node and one for each pair (a pair may
  /// come more than once: its blocks add up). Allocates. @pre a != b, both in [0, nodes).
  /// @return false if the factor would hold more than `mostNumbers`; nothing is laid out then.
  bool analyze(Index nodes, const std::vector<NodePair>& pairs,
               std::size_t mostNumbers = std::numeric_limits<std::size_t>::max());

  /// @param diagonal  a block per node, symmetric.
  /// @param coupling  a block per pair of analyze(), symmetric, stands at (a, b) and at (b, a).
  /// @return false if a pivot is 0 or not finite: there is no factor then.
  /// @param interruption  asked between fronts; null: nobody. Who says yes leaves no factor.
  bool factor(const NodeBlock* diagonal, const NodeBlock* coupling, Interruption* interruption = nullptr);
  /// vector = A^-1 vector; an entry per node. @pre factor() was true.
  void solve(Lanes* vector) noexcept;

  /// A vector d with d.A d = -1, for what has lost its balance. @return false if no pivot is negative.
  bool negativeDirection(Lanes* vector) noexcept;

  Index nodeCount() const noexcept { return static_cast<Index>(m_nodeAt.size()); }
  /// Multiplications of one factor() and of one solve().
  double factorWork() const noexcept { return m_factorWork; }
  double solveWork() const noexcept { return m_solveWork; }
  /// Of the last factor(); 0 tells that the matrix was positive definite, up to rounding.
  std::int64_t negativePivots() const noexcept { return m_negativePivots; }
  std::size_t supernodeCount() const noexcept { return m_fronts.size(); }

private:
  using Numbers = std::vector<double, CacheLineAllocator<double>>;

  /// A supernode. Its panel holds `width` columns of `lead` rows: the triangle (rows up to `inner`, a
  /// multiple of 4 >= width), then the rows below, three for each of `rowCount` nodes. The update has the
  /// rows below squared, `outer` (a multiple of 4) apart.
  struct Front {
    Index firstColumn = 0; ///< place in the order of its first node
    Index columnCount = 0; ///< nodes
    Index rowCount = 0;    ///< nodes below the triangle
    Index width = 0;       ///< 3 columnCount
    Index inner = 0, outer = 0, lead = 0;
    std::size_t panel = 0;                      ///< first number in m_panels
    std::size_t update = 0;                     ///< first number in m_updates
    std::size_t firstRow = 0;                   ///< in m_rows
    std::size_t firstRun = 0, runCount = 0;     ///< in m_runs: how its rows lie in the parent's front
    std::size_t firstChild = 0, childCount = 0; ///< in m_children
  };
  /// `count` rows from `from` on in a child's update are rows from `to` on in the parent's panel.
  struct Run {
    Index from = 0, to = 0, count = 0;
  };
  struct Place { ///< of a coupling block: its corner in m_panels, and the rows between two of its columns
    std::size_t corner = 0;
    Index lead = 0;
  };
  struct Structure; ///< what analyze() works with

  std::size_t layOut(const Structure& structure);
  void layOutUpdates();
  void placeBlocks(const Structure& structure, const std::vector<NodePair>& pairs);
  void addUpdate(const Front& child, const Front& parent) noexcept;
  bool factorPanel(const Front& front) noexcept;
  void solveUpwards(double* x) noexcept;
  void solveDownwards(double* x) noexcept;

  std::vector<Front> m_fronts; ///< children before parents
  std::vector<Index> m_rows, m_children;
  std::vector<Run> m_runs;
  std::vector<Index> m_nodeAt; ///< place in the order -> node
  std::vector<Place> m_diagonal, m_coupling;
  Numbers m_panels, m_updates; ///< from the first factor() on: many only ask for its cost
  std::size_t m_panelNumbers = 0, m_updateNumbers = 0;
  Numbers m_signed;      ///< a panel with its columns times S
  Numbers m_sign;        ///< S by columns
  Numbers m_vector;      ///< 3 per node, in the order of elimination
  Numbers m_frontVector; ///< of the tallest front
  double m_factorWork = 0.0, m_solveWork = 0.0;
  std::int64_t m_negativePivots = 0;
};

} // namespace esm
