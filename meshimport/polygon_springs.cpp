// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "meshimport/polygon_springs.h"

#include "core/geometry/pair_key.h"
#include "core/net/net_edit.h"

#include <algorithm>
#include <cstdint>
#include <unordered_map>

namespace esm {

namespace {

/// What lies over a pair of nodes that a cut joins.
struct Uses {
  Index cuts = 0, sides = 0;
  bool line = false;
  bool nothingElse() const { return !line && sides <= 2 * cuts; }
};

/// Calls use(key) for each pair of vertices that are nodes.
template <class Use>
void forPairs(const SegmentMatrix& pairs, const std::vector<Index>& nodeOfVertex, const Use& use)
{
  for (const auto& pair : pairs.colwise()) {
    const Index a = nodeOfVertex[static_cast<std::size_t>(pair[0])];
    const Index b = nodeOfVertex[static_cast<std::size_t>(pair[1])];
    if (a != kNoIndex && b != kNoIndex) use(pairKey(a, b));
  }
}

} // namespace

void followDiagonals(Mesh& mesh, const Mesh& original, const std::vector<Index>& vertexOf)
{
  mesh.diagonals.resize(2, original.diagonals.cols());
  Eigen::Index count = 0;
  for (const auto& pair : original.diagonals.colwise()) {
    const Index a = vertexOf[static_cast<std::size_t>(pair[0])];
    const Index b = vertexOf[static_cast<std::size_t>(pair[1])];
    if (a != kNoIndex && b != kNoIndex) mesh.diagonals.col(count++) << a, b;
  }
  mesh.diagonals.conservativeResize(Eigen::NoChange, count);
}

void dropDiagonals(SpringNet& net, const Mesh& mesh, const std::vector<Index>& nodeOfVertex)
{
  std::unordered_map<std::uint64_t, Uses> uses;
  const auto ifCut = [&](std::uint64_t key, const auto& change) {
    if (const auto found = uses.find(key); found != uses.end()) change(found->second);
  };
  forPairs(mesh.diagonals, nodeOfVertex, [&](std::uint64_t key) { ++uses[key].cuts; });
  if (uses.empty()) return;
  forPairs(mesh.segments, nodeOfVertex,
           [&](std::uint64_t key) { ifCut(key, [](Uses& use) { use.line = true; }); });
  for (int k = 0; k < 3; ++k) {
    SegmentMatrix sides(2, mesh.triangleCount());
    sides.row(0) = mesh.triangles.row(k);
    sides.row(1) = mesh.triangles.row((k + 1) % 3);
    forPairs(sides, nodeOfVertex, [&](std::uint64_t key) { ifCut(key, [](Uses& use) { ++use.sides; }); });
  }

  NetCut cut;
  cut.node.assign(static_cast<std::size_t>(net.nodeCount()), 0);
  cut.spring.assign(static_cast<std::size_t>(net.springCount()), 0);
  for (Index s = 0; s < net.springCount(); ++s)
    ifCut(pairKey(net.ends(0, s), net.ends(1, s)), [&](const Uses& use) {
      if (use.nothingElse()) cut.spring[static_cast<std::size_t>(s)] = 1;
    });
  shrinkNet(net, cut);
  for (std::size_t s = 0; s < net.springId.size(); ++s) net.springId[s] = SpringId{static_cast<Index>(s)};
}

} // namespace esm
