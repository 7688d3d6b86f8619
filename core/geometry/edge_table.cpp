// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/geometry/edge_table.h"

#include "core/base/assert.h"
#include "core/base/large_pages.h"
#include "core/geometry/edge_buckets.h"
#include "core/geometry/first_appearance.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace esm {

namespace {

constexpr int kTetrahedronEdges[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};

bool hasEqualCorners(const Index* corner)
{
  return corner[0] == corner[1] || corner[1] == corner[2] || corner[2] == corner[0];
}

/// The smallest corner of a triangle and the two others, whatever their order.
std::pair<Index, std::uint64_t> triangleKey(const Index* corner)
{
  const auto [low, high] = std::minmax({corner[0], corner[1], corner[2]});
  // The middle one is what the sum has left; 64 bits, for the sum of three may pass 2^31.
  const std::int64_t middle = std::int64_t{corner[0]} + corner[1] + corner[2] - low - high;
  return {low, (static_cast<std::uint64_t>(middle) << 32) | static_cast<std::uint64_t>(high)};
}

/// Whether most triangles share a corner with the next one, as in files that were not shuffled.
bool followsSurface(const Mesh& mesh)
{
  constexpr Index kSamples = 1000;
  const Index step = std::max(1, mesh.triangleCount() / kSamples);
  Index samples = 0, neighbours = 0;
  for (Index t = 0; t < mesh.triangleCount() - 1; t += step, ++samples) {
    const Index* const corner = mesh.triangles.data() + 3 * std::ptrdiff_t{t};
    neighbours += std::find_first_of(corner, corner + 3, corner + 3, corner + 6) != corner + 3;
  }
  return 2 * neighbours > samples;
}

/// Walks through a mesh side by side and numbers the edges as they come.
template <bool isOrdered>
class EdgeWalk {
public:
  EdgeWalk(const Mesh& mesh, WorkControl* control)
    : m_mesh(mesh), m_control(control), m_buckets(mesh.vertexCount())
  {
    // Room for the worst; most of it is never touched.
    const Eigen::Index sides = Eigen::Index{3} * mesh.triangleCount() + mesh.segmentCount() +
                               Eigen::Index{6} * mesh.tetrahedronCount();
    m_list.ends.resize(2, sides);
    m_list.triangleCount.resize(sides);
    m_pioneers.resize(mesh.triangleCount());
    useLargePages(m_list.ends);
    useLargePages(m_list.triangleCount);
    useLargePages(m_pioneers);
  }

  /// @param takeSides called for each triangle: takeSides(edges of its three sides, or kNoIndex)
  template <class TakeSides>
  EdgeList run(const TakeSides& takeSides)
  {
    if (!walkTriangles(takeSides)) return {};
    m_list.surfaceEdges = m_edges;
    for (Index s = 0; s < m_mesh.segmentCount(); ++s) {
      if (isStopped(s, m_mesh.segmentCount())) return {};
      addUnused(m_mesh.segments(0, s), m_mesh.segments(1, s));
    }
    for (Index t = 0; t < m_mesh.tetrahedronCount(); ++t) {
      if (isStopped(t, m_mesh.tetrahedronCount())) return {};
      const Index* const corner = m_mesh.tetrahedra.data() + 4 * std::ptrdiff_t{t};
      for (const auto& [a, b] : kTetrahedronEdges) addUnused(corner[a], corner[b]);
    }
    if (!compareDoubtful()) return {};
    m_list.ends.conservativeResize(Eigen::NoChange, m_edges);
    m_list.triangleCount.conservativeResize(m_edges);
    return std::move(m_list);
  }

private:
  using Users = std::uint8_t; // of EdgeList::triangleCount

  bool isStopped(Index item, Index items) const
  {
    return stopWantedAt(static_cast<std::size_t>(item), static_cast<std::size_t>(items), m_control);
  }

  /// The number of the edge between a != b. Everything is written as if it were new, so that nothing depends
  /// on a guess of the processor; what is not new is written over by the next one.
  Index add(Index a, Index b)
  {
    const Index low = std::min(a, b), high = std::max(a, b);
    const Index edge = m_buckets.findOrAdd(low, high, m_edges);
    Index* const end = m_list.ends.data() + 2 * std::ptrdiff_t{m_edges};
    end[0] = low;
    end[1] = high;
    return edge;
  }
  Index addForTriangle(Index a, Index b)
  {
    const Index edge = add(a, b);
    Users& users = m_list.triangleCount[edge];
    if (edge == m_edges) {
      ++m_edges;
      users = 1;
    } else if (users < EdgeList::kMany) {
      m_isCrowded = m_isCrowded || users >= 2;
      ++users;
    }
    return edge;
  }
  /// Of no triangle, unless it was there before.
  void addUnused(Index a, Index b)
  {
    if (a == b || add(a, b) != m_edges) return;
    m_list.triangleCount[m_edges++] = 0;
  }

  template <class TakeSides>
  bool walkTriangles(const TakeSides& takeSides)
  {
    // Triangles without order miss the caches with every side; their buckets are fetched some triangles
    // ahead.
    constexpr Index kAhead = 16;
    const Index count = m_mesh.triangleCount();
    const Index* corner = m_mesh.triangles.data();
    for (Index t = 0; t < count; ++t, corner += 3) {
      if (isStopped(t, count)) return false;
      if (!isOrdered && t + kAhead < count) {
        const Index* const later = corner + 3 * kAhead;
        m_buckets.foresee(std::min(later[0], later[1]));
        m_buckets.foresee(std::min(later[1], later[2]));
        m_buckets.foresee(std::min(later[2], later[0]));
      }
      if (hasEqualCorners(corner)) {
        addThin(corner, takeSides);
        m_list.thin.push_back(t);
        continue;
      }
      const Index before = m_edges;
      const Index edge[3] = {addForTriangle(corner[0], corner[1]), addForTriangle(corner[1], corner[2]),
                             addForTriangle(corner[2], corner[0])};
      takeSides(edge);
      // Triangles over the same vertices share their three edges. If an earlier one was the first user of all
      // three, they are numbered in a row; if not, some edge has a third user, see compareDoubtful().
      m_pioneers[m_pioneerCount] = before;
      m_pioneerCount += m_edges - before == 3;
      const Index low = std::min(std::min(edge[0], edge[1]), edge[2]);
      const Index high = std::max(std::max(edge[0], edge[1]), edge[2]);
      if (high < before && high - low == 2) {
        const Index* const first = m_pioneers.data();
        if (std::binary_search(first, first + m_pioneerCount, low)) m_list.repeated.push_back(t);
      }
    }
    return true;
  }

  /// A triangle with equal corners: at most one edge, which counts it once.
  template <class TakeSides>
  void addThin(const Index* corner, const TakeSides& takeSides)
  {
    Index edge[3] = {kNoIndex, kNoIndex, kNoIndex}, only = kNoIndex;
    for (int k = 0; k < 3; ++k) {
      const Index a = corner[k], b = corner[(k + 1) % 3];
      if (a == b) continue;
      if (only == kNoIndex) only = addForTriangle(a, b);
      edge[k] = only;
    }
    takeSides(edge);
  }

  /// Looks for repeated triangles among those at edges with more than two users, and those with equal
  /// corners.
  bool compareDoubtful()
  {
    const Index count = m_mesh.triangleCount();
    std::vector<Index> doubtful = m_list.thin;
    if (m_isCrowded) {
      doubtful.clear();
      for (Index t = 0; t < count; ++t) {
        if (isStopped(t, count)) return false;
        const Index* const corner = m_mesh.triangles.data() + 3 * std::ptrdiff_t{t};
        const auto isCrowded = [&](Index a, Index b) {
          return m_list.triangleCount[m_buckets.findOrAdd(std::min(a, b), std::max(a, b), kNoIndex)] > 2;
        };
        if (hasEqualCorners(corner) || isCrowded(corner[0], corner[1]) || isCrowded(corner[1], corner[2]) ||
            isCrowded(corner[2], corner[0]))
          doubtful.push_back(t);
      }
    }
    if (doubtful.empty()) return true;
    const auto keyOf = [&](Index i) {
      return triangleKey(m_mesh.triangles.data() + 3 * std::ptrdiff_t{doubtful[static_cast<std::size_t>(i)]});
    };
    const std::vector<Index> first = firstAppearances<std::uint64_t>(static_cast<Index>(doubtful.size()),
                                                                     m_mesh.vertexCount(), keyOf, m_control);
    std::vector<Index>& repeated = m_list.repeated;
    for (std::size_t i = 0; i < first.size(); ++i)
      if (first[i] != static_cast<Index>(i)) repeated.push_back(doubtful[i]);
    std::sort(repeated.begin(), repeated.end());
    repeated.erase(std::unique(repeated.begin(), repeated.end()), repeated.end());
    return !stopWanted(m_control);
  }

  const Mesh& m_mesh;
  WorkControl* m_control;
  EdgeBuckets<isOrdered ? 4 : 8> m_buckets; // half a line of the cache or a whole one
  EdgeList m_list;
  Index m_edges = 0;
  bool m_isCrowded = false;
  Eigen::Array<Index, Eigen::Dynamic, 1> m_pioneers; ///< first edges of triangles with three new ones
  Index m_pioneerCount = 0;
};

template <class TakeSides>
EdgeList walkEdges(const Mesh& mesh, WorkControl* control, const TakeSides& takeSides)
{
  ESM_ASSERT(3 * std::int64_t{mesh.triangleCount()} + mesh.segmentCount() +
               6 * std::int64_t{mesh.tetrahedronCount()} <
             kMostSides);
  return followsSurface(mesh) ? EdgeWalk<true>(mesh, control).run(takeSides)
                              : EdgeWalk<false>(mesh, control).run(takeSides);
}

} // namespace

EdgeList listEdges(const Mesh& mesh, WorkControl* control)
{
  return walkEdges(mesh, control, [](const Index(&)[3]) {});
}

EdgeTable findEdges(const Mesh& mesh, WorkControl* control)
{
  EdgeTable table;
  reserveLarge(table.edgeOfSide, 3 * static_cast<std::size_t>(mesh.triangleCount()));
  static_cast<EdgeList&>(table) = walkEdges(mesh, control, [&table](const Index(&edge)[3]) {
    table.edgeOfSide.insert(table.edgeOfSide.end(), edge, edge + 3);
  });
  if (stopWanted(control)) return {};
  return table;
}

} // namespace esm
