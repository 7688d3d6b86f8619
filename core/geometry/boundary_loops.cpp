// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/geometry/boundary_loops.h"

#include "core/geometry/distance.h"

#include <algorithm>
#include <cstdint>

namespace esm {

namespace {

/// Walks along borders. When the path comes to a vertex that lies on it, the round is cut off as a loop.
class BorderWalk {
public:
  BorderWalk(const Mesh& mesh, const EdgeTable& edges)
    : m_mesh(mesh), m_place(at(mesh.vertexCount()), kNoIndex)
  {
    findBorder(edges);
    sortByVertex();
  }

  std::vector<BoundaryLoop> walkAll()
  {
    for (Index e = 0; e < static_cast<Index>(m_border.size()); ++e)
      if (!m_isUsed[at(e)]) walkFrom(e);
    return std::move(m_loops);
  }

private:
  struct BorderEdge {
    Index from, to; ///< as its triangle runs
  };

  void findBorder(const EdgeTable& edges)
  {
    std::vector<std::uint8_t> isSeen(at(edges.surfaceEdges), 0);
    for (Index side = 0; side < static_cast<Index>(edges.edgeOfSide.size()); ++side) {
      const Index e = edges.edgeOfSide[at(side)];
      if (e == kNoIndex || edges.triangleCount[at(e)] != 1 || isSeen[at(e)]) continue;
      isSeen[at(e)] = 1;
      const Index* corner = m_mesh.triangles.data();
      m_border.push_back({corner[side], corner[side % 3 == 2 ? side - 2 : side + 1]});
    }
    m_isUsed.assign(m_border.size(), 0);
  }
  void sortByVertex()
  {
    m_start.assign(at(m_mesh.vertexCount()) + 1, 0);
    for (const BorderEdge& edge : m_border) {
      ++m_start[at(edge.from) + 1];
      ++m_start[at(edge.to) + 1];
    }
    for (std::size_t v = 1; v < m_start.size(); ++v) m_start[v] += m_start[v - 1];
    m_edgesAt.resize(2 * m_border.size());
    std::vector<Index> next(m_start.begin(), m_start.end() - 1);
    for (Index e = 0; e < static_cast<Index>(m_border.size()); ++e) {
      m_edgesAt[at(next[at(m_border[at(e)].from)]++)] = e;
      m_edgesAt[at(next[at(m_border[at(e)].to)]++)] = e;
    }
  }

  /// An unused border edge at the vertex, one that starts there if there is one; kNoIndex: none.
  Index onward(Index vertex) const
  {
    Index any = kNoIndex;
    for (Index i = m_start[at(vertex)]; i < m_start[at(vertex) + 1]; ++i) {
      const Index e = m_edgesAt[at(i)];
      if (m_isUsed[at(e)]) continue;
      if (m_border[at(e)].from == vertex) return e;
      if (any == kNoIndex) any = e;
    }
    return any;
  }
  void walkFrom(Index first)
  {
    m_path.assign(1, m_border[at(first)].from);
    m_place[at(m_path.front())] = 0;
    for (Index e = first; e != kNoIndex; e = onward(m_path.back())) {
      m_isUsed[at(e)] = 1;
      const Index here = m_path.back();
      const Index there = m_border[at(e)].from == here ? m_border[at(e)].to : m_border[at(e)].from;
      if (m_place[at(there)] == kNoIndex) {
        m_place[at(there)] = static_cast<Index>(m_path.size());
        m_path.push_back(there);
      } else {
        cutOff(at(m_place[at(there)]), true);
      }
    }
    if (m_path.size() > 1) cutOff(0, false);
    for (const Index v : m_path) m_place[at(v)] = kNoIndex;
  }
  /// The path from place `begin` on becomes a loop; its first vertex stays on the path.
  void cutOff(std::size_t begin, bool isClosed)
  {
    BoundaryLoop loop;
    loop.isClosed = isClosed;
    loop.vertices.assign(m_path.begin() + static_cast<std::ptrdiff_t>(begin), m_path.end());
    for (std::size_t i = isClosed ? 0 : 1; i < loop.vertices.size(); ++i) {
      const Index before = i == 0 ? loop.vertices.back() : loop.vertices[i - 1];
      loop.length += distance(m_mesh.position.col(before), m_mesh.position.col(loop.vertices[i]));
    }
    for (std::size_t i = begin + 1; i < m_path.size(); ++i) m_place[at(m_path[i])] = kNoIndex;
    m_path.resize(begin + 1);
    m_loops.push_back(std::move(loop));
  }

  const Mesh& m_mesh;
  std::vector<BorderEdge> m_border;
  std::vector<std::uint8_t> m_isUsed;
  std::vector<Index> m_start, m_edgesAt; ///< border edges by vertex
  std::vector<Index> m_path, m_place;    ///< m_place: by vertex, where on the path, or kNoIndex
  std::vector<BoundaryLoop> m_loops;
};

} // namespace

std::vector<BoundaryLoop> findBoundaryLoops(const Mesh& mesh, const EdgeTable& edges)
{
  return BorderWalk(mesh, edges).walkAll();
}

} // namespace esm
