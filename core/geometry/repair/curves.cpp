// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/geometry/repair/sheets.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace esm {

namespace {

using Freedom = HalfEdgeMesh::Freedom;

constexpr double kCreaseCosine = 0.766; // 40 degrees between the normals
constexpr double kCornerCosine = 0.5;   // 60 degrees between the directions of a curve

/// The curves of a surface: which edges belong to them, and where they turn.
class Curves {
public:
  Curves(HalfEdgeMesh& surface, double edgeLength, WorkControl* control)
    : m_surface(surface), m_edgeLength(edgeLength), m_control(control)
  {}

  bool mark()
  {
    std::vector<Index> creases = findCreases();
    if (stopWanted(m_control)) return false;
    const bool isRough = !creases.empty() && areRoughness(creases);
    if (isRough) creases.clear();
    for (const Index h : creases) m_surface.isCurve[at(h)] = m_surface.isCurve[at(m_surface.twinOf(h))] = 1;
    for (Index h = 0; h < m_surface.halfEdges(); ++h)
      if (m_surface.twinOf(h) == kNoIndex) m_surface.isCurve[at(h)] = 1;
    giveFreedom();
    if (!stopWanted(m_control)) fixCorners();
    return isRough;
  }

private:
  double length(Index h) const
  {
    return (m_surface.position[at(m_surface.to(h))] - m_surface.position[at(m_surface.from(h))]).norm();
  }

  std::vector<Index> findCreases() const
  {
    std::vector<Eigen::Vector3d> normals(m_surface.corner.size() / 3);
    for (std::size_t t = 0; t < normals.size() && !stopWantedAt(t, normals.size(), m_control); ++t)
      normals[t] = m_surface.areaVector(static_cast<Index>(t)).stableNormalized();
    std::vector<Index> creases;
    for (Index h = 0; h < m_surface.halfEdges(); ++h) {
      if (stopWantedAt(at(h), at(m_surface.halfEdges()), m_control)) break;
      const Index other = m_surface.twinOf(h);
      if (other == kNoIndex || other > h) continue;
      const Eigen::Vector3d &here = normals[at(h / 3)], &there = normals[at(other / 3)];
      if (here.dot(there) < kCreaseCosine && here.squaredNorm() > 0.0 && there.squaredNorm() > 0.0)
        creases.push_back(h);
    }
    return creases;
  }

  /// Creases shape a surface if they run on for an edge length and leave room between each other, or if the
  /// new edges are no longer than the creases' own. Stairs of voxels and noise do neither.
  bool areRoughness(const std::vector<Index>& creases) const
  {
    double total = 0.0, area = 0.0;
    std::vector<std::uint8_t> count(m_surface.position.size(), 0);
    for (const Index h : creases) {
      total += length(h);
      for (const Index v : {m_surface.from(h), m_surface.to(h)})
        count[at(v)] = static_cast<std::uint8_t>(std::min(count[at(v)] + 1, 255));
    }
    for (Index t = 0; t < m_surface.halfEdges() / 3; ++t) area += 0.5 * m_surface.areaVector(t).norm();
    double ends = 0.0; // of chains
    for (const std::uint8_t n : count)
      if (n != 0 && n != 2) ends += n;
    if (m_edgeLength <= 2.0 * total / static_cast<double>(creases.size())) return false;
    const double chains = std::max(1.0, 0.5 * ends);
    return total < chains * m_edgeLength || total * m_edgeLength > 2.0 * area;
  }

  void giveFreedom()
  {
    std::vector<std::uint8_t> count(m_surface.position.size(), 0);
    for (Index h = 0; h < m_surface.halfEdges(); ++h) {
      if (!m_surface.isCurve[at(h)] || !m_surface.isLead(h)) continue;
      for (const Index v : {m_surface.from(h), m_surface.to(h)})
        count[at(v)] = static_cast<std::uint8_t>(std::min(count[at(v)] + 1, 3));
    }
    for (std::size_t v = 0; v < count.size(); ++v) {
      Freedom& freedom = m_surface.freedom[v];
      if (freedom == Freedom::Surface && count[v] > 0)
        freedom = count[v] == 2 ? Freedom::Curve : Freedom::None;
    }
  }

  /// The neighbour along the curve on which one came from `before`; kNoIndex at its end.
  Index onward(Index vertex, Index before) const
  {
    Index found = kNoIndex;
    m_surface.forNeighbours(vertex, [&](Index neighbour, Index h) {
      if (neighbour != before && m_surface.isCurve[at(h)]) found = neighbour;
    });
    return found;
  }
  /// The point half an edge length further on, or where the curve ends; calls `visit` for what lies between.
  template <class Visit>
  Eigen::Vector3d lookAlong(Index vertex, Index neighbour, const Visit& visit) const
  {
    const Eigen::Vector3d& start = m_surface.position[at(vertex)];
    Index before = vertex, here = neighbour;
    visit(here);
    while (m_surface.freedom[at(here)] == Freedom::Curve && here != vertex &&
           (m_surface.position[at(here)] - start).norm() < 0.5 * m_edgeLength) {
      const Index further = onward(here, before);
      if (further == kNoIndex) break;
      before = here;
      here = further;
      visit(here);
    }
    return m_surface.position[at(here)];
  }
  /// Cosine of the angle by which the curve turns at `vertex`, seen from half an edge length away.
  template <class Visit>
  double turn(Index vertex, const Visit& visit) const
  {
    Index ends[2] = {kNoIndex, kNoIndex};
    m_surface.forNeighbours(vertex, [&](Index neighbour, Index h) {
      if (m_surface.isCurve[at(h)]) ends[ends[0] == kNoIndex ? 0 : 1] = neighbour;
    });
    const Eigen::Vector3d& middle = m_surface.position[at(vertex)];
    const Eigen::Vector3d in = middle - lookAlong(vertex, ends[0], visit),
                          out = lookAlong(vertex, ends[1], visit) - middle;
    const double lengths = in.norm() * out.norm();
    return lengths > 0.0 ? in.dot(out) / lengths : 1.0;
  }

  /// Around a corner all vertices of a fine curve see a turn; the sharpest of them is the corner.
  void fixCorners()
  {
    std::vector<Index> candidates;
    std::vector<double> turns(m_surface.position.size(), 2.0);
    for (Index v = 0; v < m_surface.vertices(); ++v) {
      if (v % 64 == 0 && stopWanted(m_control)) return; // a look along a long curve takes a while
      if (m_surface.freedom[at(v)] != Freedom::Curve) continue;
      turns[at(v)] = turn(v, [](Index) {});
      if (turns[at(v)] < kCornerCosine) candidates.push_back(v);
    }
    std::vector<Index> corners;
    for (const Index v : candidates) {
      if (stopWanted(m_control)) return;
      bool isSharpest = true;
      turn(v, [&](Index other) {
        const double there = turns[at(other)], here = turns[at(v)];
        if (other != v && (there < here || (there == here && other < v))) isSharpest = false;
      });
      if (isSharpest) corners.push_back(v);
    }
    for (const Index v : corners) m_surface.freedom[at(v)] = Freedom::None;
  }

  HalfEdgeMesh& m_surface;
  double m_edgeLength;
  WorkControl* m_control;
};

} // namespace

bool markCurves(HalfEdgeMesh& surface, double edgeLength, WorkControl* control)
{
  return Curves(surface, edgeLength, control).mark();
}

} // namespace esm
