// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/geometry/repair/fill_holes.h"

#include "core/geometry/boundary_loops.h"
#include "core/geometry/edge_table.h"
#include "core/geometry/pair_key.h"
#include "core/geometry/repair/frame.h"
#include "core/geometry/repair/loop_triangulation.h"
#include "core/geometry/repair/remesher.h"
#include "core/geometry/repair/sheets.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstdint>
#include <set>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

namespace esm {

namespace {

/// The edges between border vertices: a patch must not make one of them again.
class KnownEdges {
public:
  KnownEdges(const EdgeTable& edges, Index vertexCount)
  {
    std::vector<std::uint8_t> isOnBorder(at(vertexCount), 0);
    for (Index e = 0; e < edges.surfaceEdges; ++e)
      if (edges.triangleCount[at(e)] == 1)
        isOnBorder[at(edges.ends(0, e))] = isOnBorder[at(edges.ends(1, e))] = 1;
    for (Index e = 0; e < edges.surfaceEdges; ++e)
      if (isOnBorder[at(edges.ends(0, e))] && isOnBorder[at(edges.ends(1, e))])
        add(edges.ends(0, e), edges.ends(1, e));
  }
  void add(Index a, Index b) { m_keys.insert(pairKey(a, b)); }
  bool has(Index a, Index b) const { return m_keys.count(pairKey(a, b)) != 0; }

private:
  std::unordered_set<std::uint64_t> m_keys; // asked only, never walked through
};

/// A patch over one hole: its first vertices are those of the rim, in order.
class Patch {
public:
  explicit Patch(std::vector<Eigen::Vector3d> rim) : m_rim(std::move(rim))
  {
    double length = 0.0;
    for (std::size_t i = 0; i < m_rim.size(); ++i)
      length += (m_rim[i] - m_rim[i == 0 ? m_rim.size() - 1 : i - 1]).norm();
    m_edgeLength = length / static_cast<double>(m_rim.size());
  }

  /// @return false if the rim encloses no area.
  template <class IsAllowed>
  bool lay(const IsAllowed& isAllowed)
  {
    const auto triangles = triangulateLoop(m_rim, isAllowed);
    m_mesh.position.resize(3, static_cast<Eigen::Index>(m_rim.size()));
    for (std::size_t i = 0; i < m_rim.size(); ++i)
      m_mesh.position.col(static_cast<Eigen::Index>(i)) = m_rim[i];
    if (triangles.empty()) return layRoundMiddle();
    m_mesh.triangles.resize(3, static_cast<Eigen::Index>(triangles.size()));
    for (std::size_t t = 0; t < triangles.size(); ++t)
      m_mesh.triangles.col(static_cast<Eigen::Index>(t)) << triangles[t][0], triangles[t][1], triangles[t][2];
    return true;
  }

  /// Vertices as dense as on the rim, drawn tight.
  void refine(WorkControl* control)
  {
    constexpr int kRounds = 6;
    std::vector<std::uint8_t> isPinned(at(m_mesh.vertexCount()), 0);
    std::fill_n(isPinned.begin(), m_rim.size(), std::uint8_t{1});
    m_surface = cutToSheets(m_mesh, isPinned, control).surface;
    if (stopWanted(control)) return;
    for (std::size_t i = 0; i < m_rim.size(); ++i)
      m_surface.isSeam[i] = 1; // no new edge between two of the rim
    for (Index h = 0; h < m_surface.halfEdges(); ++h)
      if (m_surface.twinOf(h) == kNoIndex) m_surface.isRigid[at(h)] = m_surface.isCurve[at(h)] = 1;
    Remesher remesher(m_surface, {}, control);
    for (int round = 0; round < kRounds; ++round) remesher.improve(m_edgeLength);
  }
  const HalfEdgeMesh& surface() const { return m_surface; }

private:
  bool layRoundMiddle()
  {
    const auto n = static_cast<Index>(m_rim.size());
    const Eigen::Vector3d middle = m_mesh.position.rowwise().mean();
    m_mesh.position.conservativeResize(Eigen::NoChange, n + 1);
    m_mesh.position.col(n) = middle;
    m_mesh.triangles.resize(3, n);
    for (Index i = 0; i < n; ++i) {
      m_mesh.triangles.col(i) << i, (i + 1) % n, n;
      const Eigen::Vector3d u = m_rim[at(i)] - middle, v = m_rim[at((i + 1) % n)] - middle;
      if (!(u.cross(v).norm() > 1e-6 * u.norm() * v.norm())) return false;
    }
    return true;
  }

  std::vector<Eigen::Vector3d> m_rim;
  double m_edgeLength = 0.0;
  Mesh m_mesh;
  HalfEdgeMesh m_surface;
};

class HoleFilling {
public:
  HoleFilling(Mesh& mesh, WorkControl* control)
    : m_mesh(mesh),
      m_edges(findEdges(mesh, control)),
      m_known(m_edges, mesh.vertexCount()),
      m_frame(mesh.position)
  {}

  const EdgeTable& edges() const { return m_edges; }

  /// @return whether there is a patch now.
  bool fill(const BoundaryLoop& loop, WorkControl* control)
  {
    std::vector<Eigen::Vector3d> rim;
    for (const Index v : loop.vertices) {
      rim.push_back(m_frame.in(m_mesh.position.col(v)));
      if (!rim.back().allFinite()) return false;
    }
    Patch patch(std::move(rim));
    const auto isNew = [&](Index i, Index j) {
      return !m_known.has(loop.vertices[at(i)], loop.vertices[at(j)]);
    };
    if (!patch.lay(isNew)) return false;
    patch.refine(control);
    if (stopWanted(control)) return false;
    add(patch.surface(), loop);
    return true;
  }
  void finish()
  {
    const Eigen::Index vertices = m_mesh.position.cols(), triangles = m_mesh.triangles.cols();
    m_mesh.position.conservativeResize(Eigen::NoChange,
                                       vertices + static_cast<Eigen::Index>(m_vertices.size()));
    for (std::size_t i = 0; i < m_vertices.size(); ++i)
      m_mesh.position.col(vertices + static_cast<Eigen::Index>(i)) = m_vertices[i];
    m_mesh.triangles.conservativeResize(Eigen::NoChange,
                                        triangles + static_cast<Eigen::Index>(m_triangles.size()));
    for (std::size_t t = 0; t < m_triangles.size(); ++t)
      m_mesh.triangles.col(triangles + static_cast<Eigen::Index>(t)) << m_triangles[t][0], m_triangles[t][1],
        m_triangles[t][2];
  }
  Index triangles() const { return static_cast<Index>(m_triangles.size()); }

private:
  /// The rim runs with the surface at its left, so the patch at the other side has to be turned.
  void add(const HalfEdgeMesh& patch, const BoundaryLoop& loop)
  {
    std::vector<Index> placeOf(patch.position.size(), kNoIndex);
    for (std::size_t v = 0; v < placeOf.size(); ++v) {
      if (v < loop.vertices.size()) {
        placeOf[v] = loop.vertices[v];
      } else if (patch.firstOut[v] != kNoIndex) {
        placeOf[v] = m_mesh.vertexCount() + static_cast<Index>(m_vertices.size());
        m_vertices.push_back(m_frame.out(patch.position[v]));
      }
    }
    for (Index h = 0; h < patch.halfEdges(); h += 3) {
      if (!patch.isLive(h)) continue;
      const Index a = placeOf[at(patch.from(h))], b = placeOf[at(patch.to(h))],
                  c = placeOf[at(patch.apex(h))];
      m_triangles.push_back({b, a, c});
      m_known.add(a, b);
      m_known.add(b, c);
      m_known.add(c, a);
    }
  }

  Mesh& m_mesh;
  const EdgeTable m_edges;
  KnownEdges m_known;
  const Frame m_frame;
  std::vector<Eigen::Vector3d> m_vertices;
  std::vector<std::array<Index, 3>> m_triangles;
};

/// Triangles on their own: their rim is no hole.
class LoneTriangles {
public:
  LoneTriangles(const Mesh& mesh, const EdgeTable& edges)
  {
    for (Index t = 0; t < mesh.triangleCount(); ++t) {
      bool isLone = true;
      for (Index side = 3 * t; side < 3 * t + 3; ++side) {
        const Index e = edges.edgeOfSide[at(side)];
        isLone = isLone && e != kNoIndex && edges.triangleCount[at(e)] == 1;
      }
      if (isLone) m_corners.insert(key({mesh.triangles(0, t), mesh.triangles(1, t), mesh.triangles(2, t)}));
    }
  }
  bool has(const BoundaryLoop& loop) const
  {
    return loop.vertices.size() == 3 &&
           m_corners.count(key({loop.vertices[0], loop.vertices[1], loop.vertices[2]})) != 0;
  }

private:
  static std::array<Index, 3> key(std::array<Index, 3> corners)
  {
    std::sort(corners.begin(), corners.end());
    return corners;
  }
  std::set<std::array<Index, 3>> m_corners;
};

} // namespace

Status fillHoles(Mesh& mesh, Index mostEdges, double longest, RepairReport& report, WorkControl* control)
{
  HoleFilling filling(mesh, control);
  if (stopWanted(control)) return cancelledError();
  const std::vector<BoundaryLoop> loops = findBoundaryLoops(mesh, filling.edges());
  const LoneTriangles lone(mesh, filling.edges());
  Index left = 0;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    if (stopWanted(control)) return cancelledError();
    tellDone(control, static_cast<double>(i) / static_cast<double>(loops.size()));
    const BoundaryLoop& loop = loops[i];
    const bool isWished = loop.isClosed && loop.edges() >= 3 && loop.edges() <= mostEdges &&
                          (longest == 0.0 || loop.length <= longest) && !lone.has(loop);
    if (isWished && filling.fill(loop, control))
      ++report.filledHoles;
    else
      ++left;
  }
  if (stopWanted(control)) return cancelledError();
  report.patchTriangles = filling.triangles();
  if (report.filledHoles > 0) {
    filling.finish();
    report.notes.push_back("filled " + std::to_string(report.filledHoles) + " holes with " +
                           std::to_string(report.patchTriangles) + " triangles");
  }
  if (left > 0)
    report.notes.push_back("left " + std::to_string(left) +
                           " borders open: they are larger than asked for, or not closed, or without area");
  return {};
}

} // namespace esm
