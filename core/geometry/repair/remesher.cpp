// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/geometry/repair/remesher.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

using Freedom = HalfEdgeMesh::Freedom;

constexpr double kTooShort = 0.8, kTooLong = 4.0 / 3.0; // of the wished length: Botsch and Kobbelt

} // namespace

double Remesher::squaredLength(Index h) const
{
  return (m_mesh.position[at(m_mesh.to(h))] - m_mesh.position[at(m_mesh.from(h))]).squaredNorm();
}

bool Remesher::mayVanish(Index h, Index gone) const
{
  const Freedom freedom = m_mesh.freedom[at(gone)];
  return freedom == Freedom::Surface || (freedom == Freedom::Curve && m_mesh.isCurve[at(h)]);
}

/// No triangle that stays may turn away from where it looked, become a needle, or get an edge too long.
bool Remesher::keepsShape(Index gone, Index kept, double longest) const
{
  const Eigen::Vector3d& target = m_mesh.position[at(kept)];
  bool fits = true;
  m_mesh.forOut(
    gone,
    [&](Index h) {
      const Index b = m_mesh.to(h), c = m_mesh.apex(h);
      if (b == kept || c == kept || !fits) return;
      const Eigen::Vector3d &pb = m_mesh.position[at(b)], &pc = m_mesh.position[at(c)];
      const Eigen::Vector3d opposite = pc - pb, toB = pb - target;
      const Eigen::Vector3d before = opposite.cross(m_mesh.position[at(gone)] - pb);
      const Eigen::Vector3d after = opposite.cross(-toB);
      const double reach = toB.squaredNorm(), area = after.squaredNorm();
      fits = reach <= longest * longest && (target - pc).squaredNorm() <= longest * longest &&
             area > 1e-4 * opposite.squaredNorm() * reach;
      const double turn = before.dot(after);
      fits = fits &&
             (turn > 0.0 ? turn * turn > 0.04 * before.squaredNorm() * area : (before.array() == 0.0).all());
    },
    [](Index) {});
  return fits;
}

bool Remesher::tryCollapse(Index h, double longest)
{
  if (m_mesh.isRigid[at(h)]) return false;
  const Index ends[2] = {m_mesh.from(h), m_mesh.to(h)};
  for (const int k : {0, 1}) {
    const Index gone = ends[k], kept = ends[1 - k];
    if (!mayVanish(h, gone) || !m_mesh.canCollapse(h, gone) || !keepsShape(gone, kept, longest)) continue;
    m_mesh.collapse(h, gone);
    return true;
  }
  return false;
}

Remesher::Remesher(HalfEdgeMesh& mesh, const Shape& shape, WorkControl* control)
  : m_mesh(mesh), m_shape(shape), m_control(control), m_hints(mesh.position.size(), kNoIndex)
{}

void Remesher::reduce(double edgeLength)
{
  double mean = 0.0;
  Index edges = 0;
  for (Index h = 0; h < m_mesh.halfEdges(); ++h)
    if (m_mesh.isLead(h)) {
      mean += std::sqrt(squaredLength(h));
      ++edges;
    }
  if (edges == 0) return;
  mean /= edges;
  double level = edgeLength;
  while (level > 2.0 * mean) level *= 0.5;
  for (; level <= edgeLength && !isStopped(); level *= 2.0)
    collapseShort(kTooShort * level, kTooLong * level);
}

void Remesher::collapseShort(double shortest, double longest)
{
  for (Index h = 0; h < m_mesh.halfEdges(); ++h) {
    if (h % 4096 == 0 && isStopped()) return;
    if (m_mesh.isLead(h) && squaredLength(h) < shortest * shortest) tryCollapse(h, longest);
  }
}

void Remesher::splitLong(double longest)
{
  constexpr int kMostSweeps = 40; // each halves the longest edges: lengths may differ by 2^40
  for (int sweep = 0; sweep < kMostSweeps && !isStopped(); ++sweep) {
    m_candidates.clear();
    for (Index h = 0; h < m_mesh.halfEdges(); ++h)
      if (m_mesh.isLead(h) && !m_mesh.isRigid[at(h)])
        if (const double squared = squaredLength(h); squared > longest * longest)
          m_candidates.push_back({squared, h});
    if (m_candidates.empty()) return;
    std::stable_sort(m_candidates.begin(), m_candidates.end(), [](const Candidate& a, const Candidate& b) {
      return a.squaredLength > b.squaredLength;
    });
    // Only those that are among the longest of this sweep: halves of others may turn out shorter by then.
    const double least = std::max(longest * longest, 0.25 * m_candidates.front().squaredLength);
    for (const Candidate& candidate : m_candidates) {
      if (candidate.squaredLength < least) break;
      const Index h = candidate.halfEdge;
      if (squaredLength(h) < least) continue;
      const Eigen::Vector3d middle =
        0.5 * (m_mesh.position[at(m_mesh.from(h))] + m_mesh.position[at(m_mesh.to(h))]);
      const Index added = m_mesh.split(h, middle);
      m_hints.push_back(kNoIndex);
      moveTo(added, onShape(added, middle));
    }
  }
}

bool Remesher::flipKeepsShape(Index h) const
{
  const Index o = m_mesh.twinOf(h);
  const Eigen::Vector3d &u = m_mesh.position[at(m_mesh.from(h))], &x = m_mesh.position[at(m_mesh.to(h))],
                        &a = m_mesh.position[at(m_mesh.apex(h))], &b = m_mesh.position[at(m_mesh.apex(o))];
  const Eigen::Vector3d before = (x - u).cross(a - u) + (u - x).cross(b - x);
  const Eigen::Vector3d first = (u - a).cross(b - a), second = (x - b).cross(a - b);
  const double diagonal = (b - a).squaredNorm();
  const auto fits = [&](const Eigen::Vector3d& now, double side) {
    const double turn = before.dot(now), area = now.squaredNorm();
    return turn > 0.0 && turn * turn > 0.5 * before.squaredNorm() * area && area > 1e-3 * diagonal * side;
  };
  return fits(first, (u - a).squaredNorm()) && fits(second, (x - b).squaredNorm());
}

void Remesher::flipToRegular()
{
  std::vector<Index> valence(m_mesh.position.size(), 0);
  std::vector<std::uint8_t> isOnBorder(m_mesh.position.size(), 0);
  for (Index h = 0; h < m_mesh.halfEdges(); ++h) {
    if (!m_mesh.isLead(h)) continue;
    for (const Index v : {m_mesh.from(h), m_mesh.to(h)}) {
      ++valence[at(v)];
      if (m_mesh.twinOf(h) == kNoIndex) isOnBorder[at(v)] = 1;
    }
  }
  const auto excess = [&](Index v, Index change) {
    const Index wished = isOnBorder[at(v)] ? 4 : 6, away = valence[at(v)] + change - wished;
    return away * away;
  };
  for (Index h = 0; h < m_mesh.halfEdges(); ++h) {
    if (h % 4096 == 0 && isStopped()) return;
    if (!m_mesh.isLead(h) || m_mesh.twinOf(h) == kNoIndex) continue;
    const Index u = m_mesh.from(h), x = m_mesh.to(h), a = m_mesh.apex(h), b = m_mesh.apex(m_mesh.twinOf(h));
    const Index gain = excess(u, 0) + excess(x, 0) + excess(a, 0) + excess(b, 0) - excess(u, -1) -
                       excess(x, -1) - excess(a, 1) - excess(b, 1);
    if (gain <= 0 || !m_mesh.canFlip(h) || !flipKeepsShape(h)) continue;
    m_mesh.flip(h);
    --valence[at(u)];
    --valence[at(x)];
    ++valence[at(a)];
    ++valence[at(b)];
  }
}

Eigen::Vector3d Remesher::normalAt(Index vertex) const
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  m_mesh.forTriangles(vertex, [&](Index h) { sum += m_mesh.areaVector(h / 3); });
  return sum.stableNormalized();
}

/// Within the tangent plane; along the curve for points on curves.
Eigen::Vector3d Remesher::middleOfNeighbours(Index vertex) const
{
  const bool isCurve = m_mesh.freedom[at(vertex)] == Freedom::Curve;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double weights = 0.0;
  m_mesh.forNeighbours(vertex, [&](Index neighbour, Index h) {
    if (isCurve && !m_mesh.isCurve[at(h)]) return;
    sum += m_mesh.position[at(neighbour)];
    weights += 1.0;
  });
  const Eigen::Vector3d& here = m_mesh.position[at(vertex)];
  if (weights == 0.0) return here;
  const Eigen::Vector3d step = sum / weights - here;
  if (isCurve || !m_shape.surface) return here + step;
  const Eigen::Vector3d normal = normalAt(vertex);
  return here + step - normal.dot(step) * normal;
}

/// The far wall of a thin sheet is not the surface that is meant: triangles that look the other way than the
/// vertex do not count.
Eigen::Vector3d Remesher::onShape(Index vertex, const Eigen::Vector3d& target)
{
  constexpr double kAnyDistance = 1e100;
  const bool isCurve = m_mesh.freedom[at(vertex)] != Freedom::Surface;
  const NearestPoint* shape = isCurve ? m_shape.curves : m_shape.surface;
  if (!shape) return target;
  const Eigen::Vector3d normal = isCurve ? Eigen::Vector3d::Zero() : normalAt(vertex);
  const auto found = shape->find(
    target, kAnyDistance, [&](Index t) { return shape->areaVector(t).dot(normal) >= 0.0; },
    m_hints[at(vertex)]);
  m_hints[at(vertex)] = found.triangle;
  return found.point;
}

/// Moves, unless a triangle would fold over or lose its area.
void Remesher::moveTo(Index vertex, const Eigen::Vector3d& target)
{
  Eigen::Vector3d& here = m_mesh.position[at(vertex)];
  bool fits = target.allFinite();
  m_mesh.forTriangles(vertex, [&](Index h) {
    if (!fits) return;
    const Eigen::Vector3d &b = m_mesh.position[at(m_mesh.to(h))], &c = m_mesh.position[at(m_mesh.apex(h))];
    const Eigen::Vector3d before = (b - here).cross(c - here), after = (b - target).cross(c - target);
    const double turn = before.dot(after), was = before.squaredNorm(), is = after.squaredNorm();
    const bool isNeedle = is < was && is < 1e-6 * (b - target).squaredNorm() * (c - target).squaredNorm();
    fits = was == 0.0 || (turn > 0.0 && turn * turn > 0.25 * was * is && !isNeedle);
  });
  if (fits) here = target;
}

void Remesher::relax()
{
  for (Index v = 0; v < m_mesh.vertices(); ++v) {
    if (v % 1024 == 0 && isStopped()) return;
    if (m_mesh.firstOut[at(v)] == kNoIndex || m_mesh.freedom[at(v)] == Freedom::None) continue;
    if (m_mesh.freedom[at(v)] == Freedom::Curve && !m_shape.curves) continue;
    moveTo(v, onShape(v, middleOfNeighbours(v)));
  }
}

void Remesher::improve(double edgeLength)
{
  splitLong(kTooLong * edgeLength);
  collapseShort(kTooShort * edgeLength, kTooLong * edgeLength);
  flipToRegular();
  relax();
}

void Remesher::collapseTo(Index most)
{
  constexpr int kMostSweeps = 20;
  for (int sweep = 0; sweep < kMostSweeps && m_mesh.liveTriangles > most && !isStopped(); ++sweep) {
    m_candidates.clear();
    double longest = 0.0;
    for (Index h = 0; h < m_mesh.halfEdges(); ++h)
      if (m_mesh.isLead(h)) {
        m_candidates.push_back({squaredLength(h), h});
        longest = std::max(longest, m_candidates.back().squaredLength);
      }
    std::stable_sort(m_candidates.begin(), m_candidates.end(), [](const Candidate& a, const Candidate& b) {
      return a.squaredLength < b.squaredLength;
    });
    const Index before = m_mesh.liveTriangles;
    for (const Candidate& candidate : m_candidates) {
      if (m_mesh.liveTriangles <= most) return;
      if (m_mesh.isLead(candidate.halfEdge) && squaredLength(candidate.halfEdge) == candidate.squaredLength)
        tryCollapse(candidate.halfEdge, 1.2 * std::sqrt(longest));
    }
    if (m_mesh.liveTriangles == before) return;
  }
}

} // namespace esm
