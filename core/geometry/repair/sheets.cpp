// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/geometry/repair/sheets.h"

#include "core/geometry/edge_table.h"
#include "core/geometry/orientation.h"

#include <utility>

namespace esm {

namespace {

using Freedom = HalfEdgeMesh::Freedom;

/// Makes neighbours of half-edges over the same edge; what cannot be joined becomes a rigid border.
class Stitcher {
public:
  Stitcher(const Mesh& mesh, Sheets& sheets, WorkControl* control)
    : m_mesh(mesh), m_edges(findEdges(mesh, control)), m_surface(sheets.surface), m_control(control)
  {}

  void stitch()
  {
    if (stopWanted(m_control)) return;
    const Orientation orientation = findOrientation(m_mesh, m_edges, m_control);
    if (stopWanted(m_control)) return;
    const auto halfEdges = static_cast<std::size_t>(m_mesh.triangles.size());
    m_surface.corner.resize(halfEdges);
    m_surface.twin.assign(halfEdges, kNoIndex);
    m_surface.isCurve.assign(halfEdges, 0);
    m_surface.isRigid.assign(halfEdges, 0);
    std::vector<Index> waiting(at(m_edges.surfaceEdges), kNoIndex);
    Index h = 0;
    for (Index t = 0; t < m_mesh.triangleCount(); ++t) {
      if (stopWantedAt(at(t), at(m_mesh.triangleCount()), m_control)) return;
      const bool isTurned = orientation.isTurned[at(t)] != 0;
      for (int k = 0; k < 3; ++k, ++h) {
        m_surface.corner[at(h)] = m_mesh.triangles(isTurned ? (3 - k) % 3 : k, t);
        const Index edge = m_edges.edgeOfSide[at(3 * t + (isTurned ? 2 - k : k))];
        join(h, edge, waiting[at(edge)]);
      }
    }
    cutSeams(waiting);
  }

private:
  void join(Index h, Index edge, Index& waiting)
  {
    if (m_edges.triangleCount[at(edge)] > 2) {
      m_surface.isRigid[at(h)] = 1;
    } else if (waiting == kNoIndex) {
      waiting = h;
    } else {
      m_surface.twin[at(h)] = waiting;
      m_surface.twin[at(waiting)] = h;
    }
  }
  /// Neighbours that run along their edge in the same direction stay apart. Only now are all corners known.
  void cutSeams(const std::vector<Index>& waiting)
  {
    for (const Index h : waiting) {
      if (h == kNoIndex) continue;
      const Index other = m_surface.twinOf(h);
      if (other == kNoIndex || m_surface.from(h) != m_surface.from(other)) continue;
      m_surface.twin[at(h)] = m_surface.twin[at(other)] = kNoIndex;
      m_surface.isRigid[at(h)] = m_surface.isRigid[at(other)] = 1;
    }
    m_surface.isSeam.assign(at(m_mesh.vertexCount()), 0);
    for (Index h = 0; h < m_surface.halfEdges(); ++h)
      if (m_surface.isRigid[at(h)])
        m_surface.isSeam[at(m_surface.from(h))] = m_surface.isSeam[at(m_surface.to(h))] = 1;
  }

  const Mesh& m_mesh;
  const EdgeTable m_edges;
  HalfEdgeMesh& m_surface;
  WorkControl* m_control;
};

/// Every fan of triangles beyond a vertex' first one gets a copy of the vertex.
void separateFans(Sheets& sheets, WorkControl* control)
{
  HalfEdgeMesh& surface = sheets.surface;
  std::vector<std::uint8_t> isSeen(surface.corner.size(), 0), isTaken(surface.position.size(), 0);
  for (Index h = 0; h < surface.halfEdges(); ++h) {
    if (stopWantedAt(at(h), at(surface.halfEdges()), control)) return;
    if (isSeen[at(h)]) continue;
    const Index original = surface.from(h);
    Index vertex = original;
    if (isTaken[at(original)]) {
      vertex = surface.vertices();
      surface.position.push_back(Eigen::Vector3d(surface.position[at(original)]));
      surface.isSeam.push_back(1);
      surface.isSeam[at(original)] = 1;
      sheets.origin.push_back(original);
    }
    isTaken[at(original)] = 1;
    Index first = h; // clockwise to the border, if there is one
    while (surface.twinOf(first) != kNoIndex) {
      first = HalfEdgeMesh::next(surface.twinOf(first));
      if (first == h) break;
    }
    Index out = first;
    do {
      isSeen[at(out)] = 1;
      surface.corner[at(out)] = vertex;
      out = surface.twinOf(HalfEdgeMesh::previous(out));
    } while (out != kNoIndex && out != first);
  }
}

} // namespace

Sheets cutToSheets(const Mesh& mesh, const std::vector<std::uint8_t>& isPinned, WorkControl* control)
{
  Sheets sheets;
  HalfEdgeMesh& surface = sheets.surface;
  surface.position.reserve(at(mesh.vertexCount()));
  sheets.origin.reserve(at(mesh.vertexCount()));
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    surface.position.push_back(mesh.position.col(v));
    sheets.origin.push_back(v);
  }
  Stitcher(mesh, sheets, control).stitch();
  if (stopWanted(control)) return sheets;
  separateFans(sheets, control);
  if (stopWanted(control)) return sheets;
  surface.freedom.resize(surface.position.size());
  for (std::size_t v = 0; v < surface.freedom.size(); ++v)
    surface.freedom[v] =
      surface.isSeam[v] || isPinned[at(sheets.origin[v])] ? Freedom::None : Freedom::Surface;
  surface.setFirstOut();
  return sheets;
}

} // namespace esm
