// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/quality/hinges.h"

#include "core/base/grouped.h"
#include "core/geometry/edge_table.h"
#include "core/geometry/union_find.h"

#include <Eigen/Dense>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <map>

namespace esm {

namespace {

/// Whether the net without `gone` falls apart, into pieces of at least `leastPart` nodes, where it hung
/// together.
bool splits(const SpringNet& net, const std::vector<Index>& gone, Index leastPart)
{
  std::vector<std::uint8_t> isGone(static_cast<std::size_t>(net.nodeCount()), 0);
  for (const Index node : gone) isGone[static_cast<std::size_t>(node)] = 1;
  UnionFind whole(net.nodeCount()), rest(net.nodeCount());
  for (Index s = 0; s < net.springCount(); ++s) {
    const Index a = net.ends(0, s), b = net.ends(1, s);
    whole.join(a, b);
    if (!isGone[static_cast<std::size_t>(a)] && !isGone[static_cast<std::size_t>(b)]) rest.join(a, b);
  }
  const Index part = whole.root(gone.front());
  std::map<Index, Index> sizes;
  for (Index node = 0; node < net.nodeCount(); ++node)
    if (!isGone[static_cast<std::size_t>(node)] && whole.root(node) == part) ++sizes[rest.root(node)];
  return std::count_if(sizes.begin(), sizes.end(),
                       [&](const auto& size) { return size.second >= leastPart; }) > 1;
}

bool isStraight(const SpringNet& net, const std::vector<Index>& nodes)
{
  Eigen::Matrix3Xd away(3, static_cast<Eigen::Index>(nodes.size()));
  for (std::size_t i = 0; i < nodes.size(); ++i)
    away.col(static_cast<Eigen::Index>(i)) = net.restPosition.col(nodes[i]);
  away.colwise() -= Eigen::Vector3d(away.rowwise().mean());
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(Eigen::Matrix3d(away * away.transpose()));
  return solver.eigenvalues()[1] <= 1e-6 * solver.eigenvalues()[2];
}

} // namespace

std::vector<Index> hingeNodes(const SpringNet& net, Index leastPart)
{
  const auto nodes = static_cast<std::size_t>(net.nodeCount());
  Grouped<Index> neighbours;
  neighbours.build(nodes, [&](const auto& add) {
    for (Index s = 0; s < net.springCount(); ++s) {
      add(net.ends(0, s), net.ends(1, s));
      add(net.ends(1, s), net.ends(0, s));
    }
  });
  // Depth-first search with a stack of our own: nets are deeper than the call stack.
  std::vector<Index> order(nodes, 0), low(nodes, 0), parent(nodes, kNoIndex), size(nodes, 1),
    root(nodes, kNoIndex);
  std::vector<std::size_t> next(nodes, 0);
  struct Piece {
    Index node, size, root; ///< what hangs at `node` alone
  };
  std::vector<Piece> pieces;
  Index clock = 0;
  for (std::size_t seed = 0; seed < nodes; ++seed) {
    if (order[seed] != 0) continue;
    std::vector<Index> stack = {static_cast<Index>(seed)};
    order[seed] = low[seed] = ++clock;
    while (!stack.empty()) {
      const Index node = stack.back();
      const auto n = static_cast<std::size_t>(node);
      root[n] = static_cast<Index>(seed);
      const auto around = neighbours[n];
      if (next[n] < around.size()) {
        const Index to = around[next[n]++];
        const auto t = static_cast<std::size_t>(to);
        if (order[t] == 0) {
          parent[t] = node;
          order[t] = low[t] = ++clock;
          stack.push_back(to);
        } else if (to != parent[n]) {
          low[n] = std::min(low[n], order[t]);
        }
        continue;
      }
      stack.pop_back();
      if (stack.empty()) continue;
      const auto p = static_cast<std::size_t>(parent[n]);
      low[p] = std::min(low[p], low[n]);
      size[p] += size[n];
      if (low[n] >= order[p]) pieces.push_back({parent[n], size[n], static_cast<Index>(seed)});
    }
  }
  // A node is a hinge if two or more pieces at it are large; what does not hang below it is one more piece.
  std::map<Index, std::pair<Index, Index>> large; // node -> large pieces, nodes in all pieces
  for (const Piece& piece : pieces) {
    auto& [count, sum] = large[piece.node];
    count += piece.size >= leastPart ? 1 : 0;
    sum += piece.size;
  }
  std::vector<Index> hinges;
  for (const auto& [node, parts] : large) {
    const Index others =
      size[static_cast<std::size_t>(root[static_cast<std::size_t>(node)])] - 1 - parts.second;
    if (parts.first + (others >= leastPart ? 1 : 0) > 1) hinges.push_back(node);
  }
  return hinges;
}

std::vector<std::vector<Index>> hingeLines(const SpringNet& net, Index leastPart)
{
  Mesh mesh;
  mesh.position = net.restPosition;
  mesh.triangles = net.triangles;
  const EdgeTable edges = findEdges(mesh);
  UnionFind rows(net.nodeCount());
  std::vector<std::uint8_t> isOn(static_cast<std::size_t>(net.nodeCount()), 0);
  for (Index e = 0; e < static_cast<Index>(edges.ends.cols()); ++e) {
    if (edges.triangleCount[static_cast<std::size_t>(e)] <= 2) continue;
    const Index a = edges.ends(0, e), b = edges.ends(1, e);
    rows.join(a, b);
    isOn[static_cast<std::size_t>(a)] = isOn[static_cast<std::size_t>(b)] = 1;
  }
  std::map<Index, std::vector<Index>> byRow;
  for (Index node = 0; node < net.nodeCount(); ++node)
    if (isOn[static_cast<std::size_t>(node)]) byRow[rows.root(node)].push_back(node);
  constexpr std::size_t kMostRows = 50; // each is a walk through the net
  std::vector<std::vector<Index>> lines;
  for (auto& [first, nodes] : byRow) {
    if (lines.size() == kMostRows) break;
    if (isStraight(net, nodes) && splits(net, nodes, leastPart)) lines.push_back(std::move(nodes));
  }
  return lines;
}

std::vector<Index> flatNodes(const SpringNet& net, double share)
{
  std::vector<Eigen::Matrix3d> block(static_cast<std::size_t>(net.nodeCount()), Eigen::Matrix3d::Zero());
  for (Index s = 0; s < net.springCount(); ++s) {
    const Eigen::Vector3d u =
      (net.restPosition.col(net.ends(1, s)) - net.restPosition.col(net.ends(0, s))).normalized();
    for (int end = 0; end < 2; ++end)
      block[static_cast<std::size_t>(net.ends(end, s))] += net.stiffness[s] * u * u.transpose();
  }
  for (Index i = 0; i < net.anchors.count(); ++i)
    block[static_cast<std::size_t>(net.anchors.node[static_cast<std::size_t>(i)])].diagonal().array() +=
      net.anchors.stiffness[i];
  std::vector<Index> flat;
  for (Index node = 0; node < net.nodeCount(); ++node) {
    if (net.fixed[static_cast<std::size_t>(node)]) continue;
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
    solver.compute(block[static_cast<std::size_t>(node)], Eigen::EigenvaluesOnly);
    if (!(solver.eigenvalues()[0] > share * solver.eigenvalues()[2])) flat.push_back(node);
  }
  return flat;
}

} // namespace esm
