// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/linear/block_cholesky_structure.h"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <numeric>

namespace esm {
namespace {

constexpr std::size_t kLeaf = 8;       ///< sets of so few nodes are not cut further
constexpr std::size_t kLandmarks = 4;  ///< nodes far from each other, whose distances serve as coordinates
constexpr double kMostUneven = 0.65;   ///< largest share of the larger side
constexpr int kSweeps = 6;             ///< over a separator, to make it smaller
constexpr std::size_t kFewNodes = 100; ///< sets below it are cut with fewer trials

/// Nested dissection (George 1973) of a graph without coordinates. Distances (in springs) from a few nodes at
/// the rim of a set stand in for them: their differences grow across the set, so that the nodes at the median
/// of a difference form a straight cut. Of several such cuts the smallest is taken after local improvement in
/// the manner of Fiduccia and Mattheyses (1982).
class Dissection {
public:
  explicit Dissection(const NodeGraph& graph)
    : m_graph(graph), m_set(graph.nodeCount(), 0), m_side(graph.nodeCount(), 0), m_key(graph.nodeCount(), 0)
  {
    for (auto& distance : m_distance) distance.assign(graph.nodeCount(), -1);
  }

  std::vector<Index> order()
  {
    std::vector<Index> all(m_graph.nodeCount());
    std::iota(all.begin(), all.end(), 0);
    m_order.reserve(all.size());
    orderSet(std::move(all), 0);
    return std::move(m_order);
  }

private:
  using Set = std::vector<Index>;

  bool isMember(Index node, Index set) const { return m_set[static_cast<std::size_t>(node)] == set; }

  static void forget(const Set& members, std::vector<Index>& distance)
  {
    for (const Index node : members) distance[static_cast<std::size_t>(node)] = -1;
  }

  /// Distances from `start` within its set; @return the nodes reached, by distance.
  Set distances(Index start, Index set, const Set& members, std::vector<Index>& distance)
  {
    forget(members, distance);
    return spread(start, set, distance);
  }

  /// The same over nodes that have no distance yet.
  Set spread(Index start, Index set, std::vector<Index>& distance)
  {
    Set reached{start};
    distance[static_cast<std::size_t>(start)] = 0;
    for (std::size_t next = 0; next < reached.size(); ++next) {
      const Index here = distance[static_cast<std::size_t>(reached[next])];
      for (const Index other : m_graph.neighbours(reached[next]))
        if (isMember(other, set) && distance[static_cast<std::size_t>(other)] < 0) {
          distance[static_cast<std::size_t>(other)] = here + 1;
          reached.push_back(other);
        }
    }
    return reached;
  }

  /// Appends the nodes of a set, component by component.
  void orderSet(Set members, Index set)
  {
    if (members.size() <= kLeaf) {
      m_order.insert(m_order.end(), members.begin(), members.end());
      return;
    }
    std::vector<Set> components;
    std::size_t found = 0;
    forget(members, m_distance[0]); // once: a hub leaves as many components as it has neighbours
    for (const Index node : members) {
      if (!isMember(node, set)) continue; // in an earlier component
      Set component = spread(node, set, m_distance[0]);
      found += component.size();
      if (found == members.size() && components.empty()) return cut(component, set);
      const Index label = ++m_lastSet;
      for (const Index part : component) m_set[static_cast<std::size_t>(part)] = label;
      components.push_back(std::move(component));
    }
    for (Set& component : components)
      if (component.size() <= kLeaf)
        m_order.insert(m_order.end(), component.begin(), component.end());
      else
        cut(component, m_set[static_cast<std::size_t>(component.front())]);
  }

  /// Cuts a connected set and orders both sides, then the cut. @param members  breadth first.
  void cut(const Set& members, Index set)
  {
    const std::size_t landmarks = members.size() < kFewNodes ? kLandmarks - 1 : kLandmarks;
    Index start = members.back();
    for (std::size_t i = 0; i < landmarks; ++i) {
      distances(start, set, members, m_distance[i]);
      std::int64_t farthest = -1;
      for (const Index node : members) { // next: farthest from all so far
        std::int64_t nearest = std::numeric_limits<Index>::max();
        for (std::size_t j = 0; j <= i; ++j)
          nearest = std::min<std::int64_t>(nearest, m_distance[j][static_cast<std::size_t>(node)]);
        if (nearest > farthest) {
          farthest = nearest;
          start = node;
        }
      }
    }
    double bestValue = std::numeric_limits<double>::infinity();
    std::vector<std::int8_t> best;
    for (std::size_t i = 0; i < landmarks; ++i)
      for (std::size_t j = i + 1; j <= landmarks; ++j) { // j == landmarks: the distance alone
        if (j == landmarks && i > 0) continue;
        for (const Index node : members) {
          const auto n = static_cast<std::size_t>(node);
          m_key[n] = m_distance[i][n] - (j < landmarks ? m_distance[j][n] : 0);
        }
        split(members, set);
        const double value = improve(members, set);
        if (value >= bestValue) continue;
        bestValue = value;
        best.clear();
        for (const Index node : members) best.push_back(m_side[static_cast<std::size_t>(node)]);
      }
    std::array<Set, 3> parts;
    for (std::size_t i = 0; i < members.size(); ++i)
      parts[static_cast<std::size_t>(best[i])].push_back(members[i]);
    if (parts[0].empty() || parts[1].empty()) { // no cut: a clique, or nearly
      m_order.insert(m_order.end(), members.begin(), members.end());
      return;
    }
    for (std::size_t side : {0u, 1u}) {
      const Index label = ++m_lastSet;
      for (const Index node : parts[side]) m_set[static_cast<std::size_t>(node)] = label;
      orderSet(std::move(parts[side]), label);
    }
    m_order.insert(m_order.end(), parts[2].begin(), parts[2].end());
  }

  /// Halves by key; the nodes of the first half with a neighbour in the second are the separator (side 2).
  void split(const Set& members, Index set)
  {
    m_sorted = members;
    std::sort(m_sorted.begin(), m_sorted.end(), [&](Index a, Index b) {
      const Index keyA = m_key[static_cast<std::size_t>(a)], keyB = m_key[static_cast<std::size_t>(b)];
      return keyA != keyB ? keyA < keyB : a < b;
    });
    // The border between two keys that is nearest to the middle, if there is one near, is straighter.
    std::size_t middle = m_sorted.size() / 2;
    const auto keyAt = [&](std::size_t i) { return m_key[static_cast<std::size_t>(m_sorted[i])]; };
    for (std::size_t away = 0; away < m_sorted.size() / 8; ++away) {
      if (keyAt(middle + away) != keyAt(middle + away - 1)) {
        middle += away;
        break;
      }
      if (keyAt(middle - away) != keyAt(middle - away - 1)) {
        middle -= away;
        break;
      }
    }
    for (std::size_t i = 0; i < m_sorted.size(); ++i)
      m_side[static_cast<std::size_t>(m_sorted[i])] = i < middle ? 0 : 1;
    for (std::size_t i = 0; i < middle; ++i)
      if (countOn(m_sorted[i], set, 1) > 0) m_side[static_cast<std::size_t>(m_sorted[i])] = 2;
  }

  std::int64_t countOn(Index node, Index set, std::int8_t side) const
  {
    std::int64_t count = 0;
    for (const Index other : m_graph.neighbours(node))
      count += isMember(other, set) && m_side[static_cast<std::size_t>(other)] == side;
    return count;
  }

  /// Moves nodes out of the separator where that makes it smaller, or the halves more even at no price.
  /// @return size of the separator, raised where the halves are uneven.
  double improve(const Set& members, Index set)
  {
    std::array<std::int64_t, 3> size{};
    for (const Index node : members) ++size[static_cast<std::size_t>(m_side[static_cast<std::size_t>(node)])];
    const double most = kMostUneven * static_cast<double>(members.size());
    bool moved = true;
    for (int sweep = 0; sweep < kSweeps && moved; ++sweep) {
      moved = false;
      for (const Index node : members) {
        if (m_side[static_cast<std::size_t>(node)] != 2) continue;
        const std::array<std::int64_t, 2> pulls{countOn(node, set, 1), countOn(node, set, 0)};
        const std::size_t smaller = size[0] <= size[1] ? 0 : 1;
        std::size_t to = pulls[smaller] <= pulls[1 - smaller] ? smaller : 1 - smaller;
        const std::int64_t gain = 1 - pulls[to];
        if (gain < 0 || (gain == 0 && size[to] + 1 > size[1 - to] - pulls[to])) continue;
        if (static_cast<double>(size[to] + 1) > most) continue;
        m_side[static_cast<std::size_t>(node)] = static_cast<std::int8_t>(to);
        const auto from = static_cast<std::int8_t>(1 - to);
        for (const Index other : m_graph.neighbours(node))
          if (isMember(other, set) && m_side[static_cast<std::size_t>(other)] == from)
            m_side[static_cast<std::size_t>(other)] = 2;
        ++size[to];
        size[1 - to] -= pulls[to];
        size[2] -= gain;
        moved = true;
      }
    }
    const double uneven =
      static_cast<double>(std::abs(size[0] - size[1])) / static_cast<double>(members.size());
    return static_cast<double>(size[2]) * (1.0 + uneven);
  }

  const NodeGraph& m_graph;
  std::vector<Index> m_set;        ///< label of the set that a node is in
  std::vector<std::int8_t> m_side; ///< 0, 1, or 2 for the separator
  std::vector<Index> m_key;
  std::array<std::vector<Index>, kLandmarks> m_distance;
  Set m_sorted, m_order;
  Index m_lastSet = 0;
};

std::vector<Index> minimumDegreeOrder(const NodeGraph& graph)
{
  const auto count = static_cast<Eigen::Index>(graph.nodeCount());
  Eigen::SparseMatrix<double> pattern(count, count);
  std::vector<Eigen::Triplet<double>> entries;
  for (Index i = 0; i < count; ++i) {
    entries.emplace_back(i, i, 1.0);
    for (const Index j : graph.neighbours(i)) entries.emplace_back(i, j, 1.0);
  }
  pattern.setFromTriplets(entries.begin(), entries.end());
  Eigen::AMDOrdering<int>::PermutationType permutation;
  Eigen::AMDOrdering<int>()(pattern, permutation);
  return {permutation.indices().begin(), permutation.indices().end()};
}

} // namespace

std::vector<Index> eliminationOrder(Index nodes, const std::vector<NodePair>& pairs)
{
  const NodeGraph graph(nodes, pairs);
  std::vector<Index> dissected = Dissection(graph).order();
  std::vector<Index> minimum = minimumDegreeOrder(graph);
  return EliminationTree(graph, dissected).work() <= EliminationTree(graph, minimum).work() ? dissected
                                                                                            : minimum;
}

} // namespace esm
