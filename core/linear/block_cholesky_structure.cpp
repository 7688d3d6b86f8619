// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/linear/block_cholesky_structure.h"

#include "core/base/assert.h"

#include <algorithm>

namespace esm {
namespace {

Index roundedUp(Index rows)
{
  return (rows + 3) / 4 * 4;
}

// Time of a front on the machine that the kernels were tuned on [ns]: a fixed share, one per node of its
// columns, one per number moved, one per multiplication. Ratios are what counts.
constexpr double kPerFront = 150.0, kPerColumn = 20.0, kPerNumber = 0.35, kPerProduct = 0.14;

double frontProducts(double columns, double rows)
{
  const double w = 3.0 * columns, r = 3.0 * rows;
  return w * (w * w / 6.0 + 0.5 * w * r + 0.5 * r * r);
}

double frontTime(double columns, double rows)
{
  const double w = 3.0 * columns, r = 3.0 * rows;
  return kPerFront + kPerColumn * columns + kPerNumber * (w * (w + r) + r * r) +
         kPerProduct * frontProducts(columns, rows);
}

/// Children before parents, the children of each in rising order. @return old place at each new one.
std::vector<Index> postOrder(const std::vector<Index>& parent)
{
  std::vector<std::vector<Index>> children(parent.size());
  std::vector<Index> stack, order;
  for (std::size_t i = parent.size(); i-- > 0;)
    (parent[i] == kNoIndex ? stack : children[at(parent[i])]).push_back(static_cast<Index>(i));
  while (!stack.empty()) { // a node stays until its children, pushed over it, are done
    const Index node = stack.back();
    std::vector<Index>& below = children[at(node)];
    if (below.empty()) {
      order.push_back(node);
      stack.pop_back();
    } else {
      stack.insert(stack.end(), below.begin(), below.end());
      below.clear();
    }
  }
  return order;
}

} // namespace

NodeGraph::NodeGraph(Index nodes, const std::vector<NodePair>& pairs) : m_first(at(nodes) + 1, 0)
{
  std::vector<NodePair> both;
  both.reserve(2 * pairs.size());
  for (const NodePair& pair : pairs) {
    ESM_ASSERT(pair.a != pair.b && pair.a >= 0 && pair.b >= 0 && pair.a < nodes && pair.b < nodes);
    both.push_back(pair);
    both.push_back({pair.b, pair.a});
  }
  const auto key = [](const NodePair& pair) { return (static_cast<std::int64_t>(pair.a) << 32) + pair.b; };
  std::sort(both.begin(), both.end(), [&](const auto& l, const auto& r) { return key(l) < key(r); });
  for (std::size_t i = 0; i < both.size(); ++i) {
    if (i > 0 && key(both[i]) == key(both[i - 1])) continue;
    m_neighbours.push_back(both[i].b);
    m_first[at(both[i].a) + 1] = m_neighbours.size();
  }
  for (std::size_t i = 1; i < m_first.size(); ++i) m_first[i] = std::max(m_first[i], m_first[i - 1]);
}

EliminationTree::EliminationTree(const NodeGraph& graph, const std::vector<Index>& order)
  : nodeAt(order), placeOf(order.size()), parent(order.size(), kNoIndex), length(order.size(), 1)
{
  const auto count = static_cast<Index>(order.size());
  for (Index k = 0; k < count; ++k) placeOf[at(nodeAt[at(k)])] = k;
  findParents(graph);
  countColumns(graph);
}

void EliminationTree::findParents(const NodeGraph& graph)
{
  std::vector<Index> ancestor(parent.size(), kNoIndex);
  for (Index k = 0; k < static_cast<Index>(parent.size()); ++k)
    for (const Index node : graph.neighbours(nodeAt[at(k)]))
      for (Index i = placeOf[at(node)]; i < k && i != kNoIndex;) { // to the root, shortening the path
        const Index next = ancestor[at(i)];
        ancestor[at(i)] = k;
        if (next == kNoIndex) parent[at(i)] = k;
        i = next;
      }
}

/// Row k of the factor holds the places on the tree's paths from k's earlier neighbours up to k.
void EliminationTree::countColumns(const NodeGraph& graph)
{
  std::vector<Index> lastRow(parent.size(), kNoIndex);
  for (Index k = 0; k < static_cast<Index>(parent.size()); ++k)
    for (const Index node : graph.neighbours(nodeAt[at(k)]))
      for (Index i = placeOf[at(node)]; i != kNoIndex && i < k && lastRow[at(i)] != k; i = parent[at(i)]) {
        ++length[at(i)];
        lastRow[at(i)] = k;
      }
}

double EliminationTree::work() const noexcept
{
  double sum = 0.0;
  for (const Index nodes : length) sum += static_cast<double>(nodes) * static_cast<double>(nodes);
  return sum;
}

/// Supernodes in post-order over the final order of elimination.
struct BlockCholesky::Structure {
  struct Supernode {
    Index first = 0, columns = 0, parent = kNoIndex;
    std::vector<Index> rows; ///< places below its columns, rising
  };
  Structure(Index nodes, const std::vector<NodePair>& pairs);
  void merge(const EliminationTree& tree);
  void findRows(const NodeGraph& graph);

  std::vector<Index> nodeAt, placeOf, supernodeOf; ///< the last by place
  std::vector<Supernode> supernodes;
};

BlockCholesky::Structure::Structure(Index nodes, const std::vector<NodePair>& pairs)
{
  const NodeGraph graph(nodes, pairs);
  const EliminationTree given(graph, eliminationOrder(nodes, pairs));
  std::vector<Index> order = postOrder(given.parent);
  for (Index& place : order) place = given.nodeAt[at(place)];
  merge(EliminationTree(graph, order));
  findRows(graph);
}

/// Columns whose pattern is the next one's are one supernode from the start; then a child joins its parent
/// where the zeros that this makes cost less time than a front of its own.
void BlockCholesky::Structure::merge(const EliminationTree& tree)
{
  struct Group {
    std::vector<Index> places;
    double columns = 0.0, rows = 0.0;
    Index parent = kNoIndex;
    std::vector<Index> children;
    bool alive = true;
  };
  std::vector<Group> groups;
  std::vector<Index> groupOf(tree.parent.size());
  for (std::size_t k = 0; k < tree.parent.size(); ++k) {
    const auto place = static_cast<Index>(k);
    const bool joins = k > 0 && tree.parent[k - 1] == place && tree.length[k - 1] == tree.length[k] + 1;
    if (!joins) groups.emplace_back();
    groups.back().places.push_back(place);
    groups.back().columns += 1.0;
    groups.back().rows = tree.length[k] - 1;
    groupOf[k] = static_cast<Index>(groups.size() - 1);
  }
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const Index up = tree.parent[at(groups[g].places.back())];
    if (up == kNoIndex) continue;
    groups[g].parent = groupOf[at(up)];
    groups[at(groups[g].parent)].children.push_back(static_cast<Index>(g));
  }
  for (std::size_t g = 0; g < groups.size(); ++g) { // children come first
    Group& group = groups[g];
    for (;;) {
      double bestGain = 0.0;
      Index best = kNoIndex;
      for (const Index c : group.children) {
        const Group& child = groups[at(c)];
        const double gain = frontTime(child.columns, child.rows) + frontTime(group.columns, group.rows) -
                            frontTime(child.columns + group.columns, group.rows);
        if (gain > bestGain) {
          bestGain = gain;
          best = c;
        }
      }
      if (best == kNoIndex) break;
      Group& child = groups[at(best)];
      child.alive = false;
      group.columns += child.columns;
      group.places.insert(group.places.end(), child.places.begin(), child.places.end());
      std::erase(group.children, best);
      for (const Index c : child.children) {
        groups[at(c)].parent = static_cast<Index>(g);
        group.children.push_back(c);
      }
      child.children.clear();
    }
    std::sort(group.places.begin(), group.places.end());
  }
  std::vector<Index> compact(groups.size(), kNoIndex), parent;
  std::vector<std::size_t> alive;
  for (std::size_t g = 0; g < groups.size(); ++g)
    if (groups[g].alive) {
      compact[g] = static_cast<Index>(alive.size());
      alive.push_back(g);
    }
  for (const std::size_t g : alive)
    parent.push_back(groups[g].parent == kNoIndex ? kNoIndex : compact[at(groups[g].parent)]);
  const std::vector<Index> order = postOrder(parent);
  std::vector<Index> newPlace(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) newPlace[at(order[i])] = static_cast<Index>(i);
  for (const Index s : order) {
    const Group& group = groups[alive[at(s)]];
    Supernode supernode;
    supernode.first = static_cast<Index>(nodeAt.size());
    supernode.columns = static_cast<Index>(group.places.size());
    supernode.parent = parent[at(s)] == kNoIndex ? kNoIndex : newPlace[at(parent[at(s)])];
    for (const Index place : group.places) {
      nodeAt.push_back(tree.nodeAt[at(place)]);
      supernodeOf.push_back(static_cast<Index>(supernodes.size()));
    }
    supernodes.push_back(std::move(supernode));
  }
  placeOf.resize(nodeAt.size());
  for (std::size_t k = 0; k < nodeAt.size(); ++k) placeOf[at(nodeAt[k])] = static_cast<Index>(k);
}

void BlockCholesky::Structure::findRows(const NodeGraph& graph)
{
  std::vector<Index> mark(nodeAt.size(), kNoIndex);
  std::vector<std::vector<Index>> children(supernodes.size());
  for (std::size_t s = 0; s < supernodes.size(); ++s) { // post-order: the children are complete
    Supernode& supernode = supernodes[s];
    const Index end = supernode.first + supernode.columns;
    const auto add = [&](Index place) {
      if (place < end || mark[at(place)] == static_cast<Index>(s)) return;
      mark[at(place)] = static_cast<Index>(s);
      supernode.rows.push_back(place);
    };
    for (Index place = supernode.first; place < end; ++place)
      for (const Index node : graph.neighbours(nodeAt[at(place)])) add(placeOf[at(node)]);
    for (const Index child : children[s])
      for (const Index row : supernodes[at(child)].rows) add(row);
    std::sort(supernode.rows.begin(), supernode.rows.end());
    if (supernode.parent != kNoIndex) children[at(supernode.parent)].push_back(static_cast<Index>(s));
  }
}

bool BlockCholesky::analyze(Index nodes, const std::vector<NodePair>& pairs, std::size_t mostNumbers)
{
  *this = BlockCholesky();
  if (nodes == 0) return true;
  const Structure structure(nodes, pairs);
  m_nodeAt = structure.nodeAt;
  const std::size_t numbers = layOut(structure);
  if (numbers > mostNumbers) {
    *this = BlockCholesky();
    return false;
  }
  m_panelNumbers = numbers;
  layOutUpdates();
  placeBlocks(structure, pairs);
  return true;
}

/// @return numbers in all panels.
std::size_t BlockCholesky::layOut(const Structure& structure)
{
  std::size_t panels = 0;
  Index tallest = 0, largest = 0;
  std::vector<std::vector<Index>> children(structure.supernodes.size());
  for (std::size_t s = 0; s < structure.supernodes.size(); ++s)
    if (const Index parent = structure.supernodes[s].parent; parent != kNoIndex)
      children[at(parent)].push_back(static_cast<Index>(s));
  for (std::size_t s = 0; s < structure.supernodes.size(); ++s) {
    const Structure::Supernode& supernode = structure.supernodes[s];
    Front front;
    front.firstColumn = supernode.first;
    front.columnCount = supernode.columns;
    front.rowCount = static_cast<Index>(supernode.rows.size());
    front.width = 3 * front.columnCount;
    front.inner = roundedUp(front.width);
    front.outer = roundedUp(3 * front.rowCount);
    front.lead = front.inner + front.outer;
    front.panel = panels;
    panels += at(front.width) * at(front.lead);
    front.firstRow = m_rows.size();
    m_rows.insert(m_rows.end(), supernode.rows.begin(), supernode.rows.end());
    front.firstChild = m_children.size();
    front.childCount = children[s].size();
    m_children.insert(m_children.end(), children[s].begin(), children[s].end());
    tallest = std::max(tallest, front.lead);
    largest = std::max(largest, front.lead * front.width);
    m_factorWork += frontProducts(front.columnCount, front.rowCount);
    m_solveWork += static_cast<double>(front.width) * static_cast<double>(front.width + 6 * front.rowCount);
    m_fronts.push_back(front);
  }
  m_signed.assign(at(largest), 0.0);
  m_sign.assign(3 * m_nodeAt.size(), 1.0);
  m_vector.assign(3 * m_nodeAt.size(), 0.0);
  m_frontVector.assign(at(tallest), 0.0);
  for (std::size_t s = 0; s < m_fronts.size(); ++s) {
    Front& front = m_fronts[s];
    front.firstRun = m_runs.size();
    if (front.rowCount == 0) continue;
    const Front& parent = m_fronts[at(structure.supernodes[s].parent)];
    const std::vector<Index>& above = structure.supernodes[at(structure.supernodes[s].parent)].rows;
    for (Index i = 0; i < front.rowCount; ++i) {
      const Index row = m_rows[front.firstRow + at(i)];
      const bool inTriangle = row < parent.firstColumn + parent.columnCount;
      const auto below = std::lower_bound(above.begin(), above.end(), row) - above.begin();
      const Index to =
        inTriangle ? 3 * (row - parent.firstColumn) : parent.inner + 3 * static_cast<Index>(below);
      const bool goesOn =
        m_runs.size() > front.firstRun && to != parent.inner && m_runs.back().to + m_runs.back().count == to;
      if (!goesOn) m_runs.push_back({3 * i, to, 0});
      m_runs.back().count += 3;
    }
    front.runCount = m_runs.size() - front.firstRun;
  }
  return panels;
}

/// Updates live from their front's turn to their parent's; each takes the first gap that is wide enough. A hub
/// has as many updates as neighbours: so those at the bottom that leave no gap are not looked at again, and
/// who goes is looked for among the latest first.
void BlockCholesky::layOutUpdates()
{
  struct Block {
    std::size_t begin, end, front;
  };
  std::vector<Block> live; // by begin
  std::size_t top = 0, packed = 0;
  for (std::size_t s = 0; s < m_fronts.size(); ++s) {
    Front& front = m_fronts[s];
    const std::size_t size = at(front.outer) * at(front.outer);
    std::size_t begin = packed > 0 ? live[packed - 1].end : 0;
    for (; packed < live.size() && live[packed].begin == begin; ++packed) begin = live[packed].end;
    auto place = live.begin() + static_cast<std::ptrdiff_t>(packed);
    for (; place != live.end() && place->begin < begin + size; ++place) begin = place->end;
    front.update = begin;
    if (size > 0) live.insert(place, {begin, begin + size, s});
    top = std::max(top, begin + size);
    for (std::size_t c = front.childCount; c-- > 0;) {
      const auto child = at(m_children[front.firstChild + c]);
      const auto gone =
        std::find_if(live.rbegin(), live.rend(), [&](const Block& block) { return block.front == child; });
      const auto next = live.erase(std::next(gone).base());
      packed = std::min(packed, static_cast<std::size_t>(next - live.begin()));
    }
  }
  m_updateNumbers = top;
}

void BlockCholesky::placeBlocks(const Structure& structure, const std::vector<NodePair>& pairs)
{
  const auto placeIn = [&](Index row, Index column) {
    const auto s = at(structure.supernodeOf[at(column)]);
    const Front& front = m_fronts[s];
    const std::vector<Index>& rows = structure.supernodes[s].rows;
    const auto below = std::lower_bound(rows.begin(), rows.end(), row) - rows.begin();
    const Index inPanel = row < front.firstColumn + front.columnCount
                            ? 3 * (row - front.firstColumn)
                            : front.inner + 3 * static_cast<Index>(below);
    return Place{front.panel + at(3 * (column - front.firstColumn)) * at(front.lead) + at(inPanel),
                 front.lead};
  };
  for (const Index place : structure.placeOf) m_diagonal.push_back(placeIn(place, place));
  for (const NodePair& pair : pairs) {
    const Index a = structure.placeOf[at(pair.a)], b = structure.placeOf[at(pair.b)];
    m_coupling.push_back(placeIn(std::max(a, b), std::min(a, b)));
  }
}

} // namespace esm
