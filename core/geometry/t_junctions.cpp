// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/geometry/t_junctions.h"

#include "core/geometry/repair/frame.h"
#include "core/geometry/repair/nearest_point.h"

#include <algorithm>
#include <cstdint>
#include <tuple>

namespace esm {

namespace {

constexpr double kDefaultTolerance =
  1e-5; // of the diagonal: single precision and six digits of text round to less

/// The edges on which something may lie, spatially ordered, as triangles without area.
struct LooseEdges {
  std::vector<Index> edge;
  TriangleMatrix ends;
};

class Junctions {
public:
  Junctions(const Mesh& mesh, const EdgeTable& edges, const Frame& frame)
    : m_mesh(mesh), m_edges(edges), m_position(3, mesh.position.cols()), m_isLoose(at(mesh.vertexCount()), 0)
  {
    for (Index v = 0; v < mesh.vertexCount(); ++v) m_position.col(v) = frame.in(mesh.position.col(v));
    // Loose are vertices on borders, and ends of lines.
    for (Index e = 0; e < static_cast<Index>(edges.ends.cols()); ++e)
      if (isLoose(e)) m_isLoose[at(edges.ends(0, e))] = m_isLoose[at(edges.ends(1, e))] = 1;
    findApexes();
  }

  std::vector<TJunction> find(double tolerance, WorkControl* control) const
  {
    const LooseEdges loose = looseEdges();
    const NearestPoint nearest(m_position, loose.ends);
    std::vector<TJunction> junctions;
    for (Index v = 0; v < m_mesh.vertexCount(); ++v) {
      if (stopWantedAt(at(v), m_isLoose.size(), control)) return {};
      if (!m_isLoose[at(v)] || !m_position.col(v).allFinite()) continue;
      const auto found = nearest.find(m_position.col(v), tolerance,
                                      [&](Index i) { return liesOn(v, loose.edge[at(i)], tolerance); });
      if (found.triangle == kNoIndex) continue;
      const Index e = loose.edge[at(found.triangle)];
      junctions.push_back({v, e, {m_edges.ends(0, e), m_edges.ends(1, e)}, along(v, e)});
    }
    std::sort(junctions.begin(), junctions.end(), [](const TJunction& a, const TJunction& b) {
      return std::tie(a.edge, a.along, a.vertex) < std::tie(b.edge, b.along, b.vertex);
    });
    return junctions;
  }

private:
  bool isLoose(Index e) const { return e >= m_edges.surfaceEdges || m_edges.triangleCount[at(e)] == 1; }

  /// For border edges the third corner of their triangle: it lies near if the triangle is thin, and is
  /// joined.
  void findApexes()
  {
    m_apex.assign(at(m_edges.surfaceEdges), kNoIndex);
    for (Index side = 0; side < static_cast<Index>(m_edges.edgeOfSide.size()); ++side)
      if (const Index e = m_edges.edgeOfSide[at(side)]; e != kNoIndex)
        m_apex[at(e)] = m_mesh.triangles.data()[side % 3 == 0 ? side + 2 : side - 1];
  }

  LooseEdges looseEdges() const
  {
    LooseEdges loose;
    std::vector<Index> corners;
    for (Index e = 0; e < static_cast<Index>(m_edges.ends.cols()); ++e) {
      const Index a = m_edges.ends(0, e), b = m_edges.ends(1, e);
      if (!isLoose(e) || !m_position.col(a).allFinite() || !m_position.col(b).allFinite()) continue;
      loose.edge.push_back(e);
      corners.insert(corners.end(), {a, b, b});
    }
    const auto count = static_cast<Eigen::Index>(loose.edge.size());
    const TriangleMatrix unordered = Eigen::Map<TriangleMatrix>(corners.data(), 3, count);
    const std::vector<Index> order = spatialOrder(m_position, unordered);
    loose.ends.resize(3, count);
    std::vector<Index> edge(loose.edge.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
      loose.ends.col(static_cast<Eigen::Index>(i)) = unordered.col(order[i]);
      edge[i] = loose.edge[at(order[i])];
    }
    loose.edge = std::move(edge);
    return loose;
  }

  double along(Index v, Index e) const
  {
    const Eigen::Vector3d a = m_position.col(m_edges.ends(0, e)),
                          side = m_position.col(m_edges.ends(1, e)) - a;
    return (m_position.col(v) - a).dot(side) / side.squaredNorm();
  }
  /// On the middle of the edge: off its ends, and no corner of its triangle.
  bool liesOn(Index v, Index e, double tolerance) const
  {
    const Index a = m_edges.ends(0, e), b = m_edges.ends(1, e);
    if (v == a || v == b) return false;
    if (e < m_edges.surfaceEdges && m_apex[at(e)] == v) return false;
    return (m_position.col(v) - m_position.col(a)).norm() > 2.0 * tolerance &&
           (m_position.col(v) - m_position.col(b)).norm() > 2.0 * tolerance;
  }

  const Mesh& m_mesh;
  const EdgeTable& m_edges;
  Eigen::Matrix3Xd m_position; ///< in the frame
  std::vector<std::uint8_t> m_isLoose;
  std::vector<Index> m_apex;
};

} // namespace

std::vector<TJunction> findTJunctions(const Mesh& mesh, const EdgeTable& edges, double tolerance,
                                      WorkControl* control)
{
  const Frame frame(mesh.position);
  const double reach = tolerance > 0.0 ? tolerance * frame.scale : kDefaultTolerance * frame.diagonal;
  if (!(frame.diagonal > 0.0)) return {};
  return Junctions(mesh, edges, frame).find(std::min(reach, frame.diagonal), control);
}

} // namespace esm
