// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/geometry/repair/close_t_junctions.h"

#include "core/geometry/edge_table.h"
#include "core/geometry/repair/loop_triangulation.h"
#include "core/geometry/t_junctions.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace esm {

namespace {

/// One round: each loose vertex is tied to one edge.
class Closing {
public:
  Closing(Mesh& mesh, const EdgeTable& edges, const std::vector<TJunction>& junctions)
    : m_mesh(mesh),
      m_edges(edges),
      m_junctions(junctions),
      m_start(static_cast<std::size_t>(edges.ends.cols()) + 1, 0)
  {
    for (const TJunction& junction : junctions) ++m_start[at(junction.edge) + 1];
    for (std::size_t e = 1; e < m_start.size(); ++e) m_start[e] += m_start[e - 1];
  }

  /// @return how many vertices are tied now.
  Index run(WorkControl* control)
  {
    m_isTied.assign(m_junctions.size(), 0);
    for (Index t = 0; t < m_mesh.triangleCount(); ++t) {
      if (stopWantedAt(at(t), at(m_mesh.triangleCount()), control)) return 0;
      splitTriangle(t);
    }
    splitSegments();
    const auto count = static_cast<Eigen::Index>(m_triangles.size() / 3);
    m_mesh.triangles = Eigen::Map<const TriangleMatrix>(m_triangles.data(), 3, count);
    return static_cast<Index>(std::count(m_isTied.begin(), m_isTied.end(), 1));
  }

private:
  /// Calls `visit(junction)` along the edge from vertex `from` on.
  template <class Visit>
  void along(Index edge, Index from, const Visit& visit) const
  {
    const Index begin = m_start[at(edge)], end = m_start[at(edge) + 1];
    const bool isForward = m_edges.ends(0, edge) == from;
    for (Index i = begin; i < end; ++i) visit(isForward ? i : begin + end - 1 - i);
  }
  void splitTriangle(Index t)
  {
    const std::array<Index, 3> corners{m_mesh.triangles(0, t), m_mesh.triangles(1, t),
                                       m_mesh.triangles(2, t)};
    m_loop.clear();
    m_side.clear();
    m_used.clear();
    for (int k = 0; k < 3; ++k) {
      m_loop.push_back(corners[static_cast<std::size_t>(k)]);
      m_side.push_back(-1);
      const Index edge = m_edges.edgeOfSide[at(3 * t + k)];
      if (edge == kNoIndex) continue;
      along(edge, m_loop.back(), [&](Index i) {
        const Index vertex = m_junctions[at(i)].vertex;
        if (std::find(corners.begin(), corners.end(), vertex) != corners.end()) return;
        m_loop.push_back(vertex);
        m_side.push_back(k);
        m_used.push_back(i);
      });
    }
    if (m_loop.size() > 3 && triangulate()) {
      for (const Index i : m_used) m_isTied[at(i)] = 1;
      return;
    }
    m_triangles.insert(m_triangles.end(), corners.begin(), corners.end());
  }
  /// Vertices on one side are on one line, up to the tolerance: no triangle joins three of them.
  bool triangulate()
  {
    std::vector<Eigen::Vector3d> points;
    for (const Index v : m_loop) points.push_back(m_mesh.position.col(v));
    const auto n = static_cast<Index>(points.size());
    std::vector<Index> cornerPlaces;
    for (Index i = 0; i < n; ++i)
      if (m_side[at(i)] < 0) cornerPlaces.push_back(i);
    const auto isOnSide = [&](Index i, int k) {
      return m_side[at(i)] == k || i == cornerPlaces[static_cast<std::size_t>(k)] ||
             i == cornerPlaces[static_cast<std::size_t>((k + 1) % 3)];
    };
    const auto triangles = triangulateLoop(points, [&](Index i, Index j) {
      for (int k = 0; k < 3; ++k)
        if (isOnSide(i, k) && isOnSide(j, k)) return false;
      return true;
    });
    for (const auto& triangle : triangles)
      for (const Index place : triangle) m_triangles.push_back(m_loop[at(place)]);
    return !triangles.empty();
  }
  /// Segments over an edge of triangles go the same way.
  void splitSegments()
  {
    if (m_mesh.segmentCount() == 0) return;
    std::vector<Index> segments;
    std::vector<std::array<Index, 3>> byEnds; // low, high, edge
    for (Index e = 0; e < static_cast<Index>(m_edges.ends.cols()); ++e)
      if (m_start[at(e) + 1] > m_start[at(e)]) byEnds.push_back({m_edges.ends(0, e), m_edges.ends(1, e), e});
    std::sort(byEnds.begin(), byEnds.end());
    for (Index s = 0; s < m_mesh.segmentCount(); ++s) {
      const Index a = m_mesh.segments(0, s), b = m_mesh.segments(1, s);
      segments.push_back(a);
      const std::array<Index, 3> key{std::min(a, b), std::max(a, b), 0};
      const auto found = std::lower_bound(byEnds.begin(), byEnds.end(), key);
      if (found != byEnds.end() && (*found)[0] == key[0] && (*found)[1] == key[1])
        along((*found)[2], a, [&](Index i) {
          m_isTied[at(i)] = 1;
          segments.insert(segments.end(), 2, m_junctions[at(i)].vertex);
        });
      segments.push_back(b);
    }
    m_mesh.segments =
      Eigen::Map<const SegmentMatrix>(segments.data(), 2, static_cast<Eigen::Index>(segments.size() / 2));
  }

  Mesh& m_mesh;
  const EdgeTable& m_edges;
  const std::vector<TJunction>& m_junctions; ///< by edge
  std::vector<Index> m_start;                ///< by edge: its first junction
  std::vector<std::uint8_t> m_isTied;
  std::vector<Index> m_triangles; ///< new corners
  std::vector<Index> m_loop, m_used;
  std::vector<int> m_side; ///< by place in the loop: on which side of the triangle; -1: a corner
};

} // namespace

Status closeTJunctions(Mesh& mesh, double tolerance, RepairReport& report, WorkControl* control)
{
  constexpr int kMostRounds = 8; // a vertex may lie on several edges, one is split per round
  Index tied = 0;
  for (int round = 0; round < kMostRounds; ++round) {
    const EdgeTable edges = findEdges(mesh, control);
    if (stopWanted(control)) return cancelledError();
    const std::vector<TJunction> junctions = findTJunctions(mesh, edges, tolerance, control);
    if (stopWanted(control)) return cancelledError();
    const Index now = junctions.empty() ? 0 : Closing(mesh, edges, junctions).run(control);
    if (stopWanted(control)) return cancelledError();
    if (now == 0) break;
    tied += now;
  }
  report.closedTJunctions += tied;
  return {};
}

} // namespace esm
