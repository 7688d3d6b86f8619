// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/net/outward_surface.h"

#include "core/base/grouped.h"
#include "core/geometry/edge_table.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

/// Whether the side from a to b runs along the triangle's own sense.
bool runsAlong(const TriangleMatrix& triangles, Index triangle, Index a, Index b)
{
  for (int k = 0; k < 3; ++k)
    if (triangles(k, triangle) == a && triangles((k + 1) % 3, triangle) == b) return true;
  return false;
}

} // namespace

OutwardSurface::OutwardSurface(const SpringNet& net, WorkControl* control)
  : m_position(net.restPosition),
    m_triangles(net.triangles),
    m_part(static_cast<std::size_t>(net.triangleCount()), kNoIndex),
    m_tree(net.restPosition, net.triangles, control)
{
  if (stopWanted(control)) return;
  joinParts(control);
  if (!stopWanted(control)) turnOutwards(control);
}

/// Spreads from triangle to triangle over shared edges, and turns each as the one that it was reached from.
void OutwardSurface::joinParts(WorkControl* control)
{
  Mesh mesh;
  mesh.position = m_position;
  mesh.triangles = m_triangles;
  const EdgeTable edges = findEdges(mesh, control);
  if (stopWanted(control)) return;
  const auto count = static_cast<Index>(m_triangles.cols());
  Grouped<Index> trianglesOf;
  trianglesOf.build(static_cast<std::size_t>(edges.ends.cols()), [&](const auto& add) {
    for (Index t = 0; t < count; ++t)
      for (Index c = 0; c < 3; ++c)
        if (const Index edge = edges.edgeOfSide[static_cast<std::size_t>(3 * t + c)]; edge != kNoIndex)
          add(edge, t);
  });
  std::vector<Index> queue;
  for (Index seed = 0; seed < count && !stopWanted(control); ++seed) {
    if (m_part[static_cast<std::size_t>(seed)] != kNoIndex) continue;
    const auto part = static_cast<Index>(m_parts.size());
    m_parts.push_back({true, true, false, 0.0});
    queue.assign(1, seed);
    m_part[static_cast<std::size_t>(seed)] = part;
    for (std::size_t next = 0; next < queue.size(); ++next) {
      const Index from = queue[next];
      for (Index c = 0; c < 3; ++c) {
        const Index edge = edges.edgeOfSide[static_cast<std::size_t>(3 * from + c)];
        if (edge == kNoIndex) continue;
        const auto around = trianglesOf[static_cast<std::size_t>(edge)];
        if (around.size() != 2) m_parts.back().isClosed = false;
        if (around.size() > 2) m_parts.back().isOriented = false;
        const Index a = edges.ends(0, edge), b = edges.ends(1, edge);
        for (const Index to : around) {
          if (to == from) continue;
          const bool sameSense = runsAlong(m_triangles, from, a, b) == runsAlong(m_triangles, to, a, b);
          Index& owner = m_part[static_cast<std::size_t>(to)];
          if (owner == kNoIndex) {
            if (sameSense) std::swap(m_triangles(1, to), m_triangles(2, to));
            owner = part;
            queue.push_back(to);
          } else if (sameSense && around.size() == 2) {
            m_parts.back().isOriented = false;
          }
        }
      }
    }
  }
}

void OutwardSurface::turnOutwards(WorkControl* control)
{
  const auto count = static_cast<Index>(m_triangles.cols());
  std::vector<Eigen::Vector3d> centre(m_parts.size(), Eigen::Vector3d::Zero());
  std::vector<double> corners(m_parts.size(), 0.0);
  std::vector<Index> first(m_parts.size(), kNoIndex);
  for (Index t = 0; t < count; ++t) {
    const auto p = static_cast<std::size_t>(partOf(t));
    if (first[p] == kNoIndex) first[p] = t;
    for (int k = 0; k < 3; ++k) centre[p] += m_position.col(m_triangles(k, t));
    corners[p] += 3.0;
  }
  for (std::size_t p = 0; p < m_parts.size(); ++p) centre[p] /= corners[p];
  for (Index t = 0; t < count; ++t) {
    const auto p = static_cast<std::size_t>(partOf(t));
    const Eigen::Vector3d a = m_position.col(m_triangles(0, t)) - centre[p];
    m_parts[p].volume += a.dot(triangleNormal(t)) / 6.0;
  }
  std::vector<std::uint8_t> turn(m_parts.size(), 0);
  for (std::size_t p = 0; p < m_parts.size() && !stopWanted(control); ++p) {
    Part& part = m_parts[p];
    if (part.isClosed && m_parts.size() > 1) {
      // As often odd as it lies inside others, for the ray leaves each of these an odd number of times.
      const auto isOther = [&](Index t) {
        return static_cast<std::size_t>(partOf(t)) != p &&
               m_parts[static_cast<std::size_t>(partOf(t))].isClosed;
      };
      part.isCavity = m_tree.crossings(m_position.col(m_triangles(0, first[p])), kObliqueDirection,
                                       [&](Index t) { return !isOther(t); }) %
                        2 ==
                      1;
    }
    turn[p] = (part.volume < 0.0) != part.isCavity ? 1 : 0;
    part.volume = part.isCavity ? -std::abs(part.volume) : std::abs(part.volume);
  }
  for (Index t = 0; t < count; ++t)
    if (turn[static_cast<std::size_t>(partOf(t))]) std::swap(m_triangles(1, t), m_triangles(2, t));
}

bool OutwardSurface::isClosed() const noexcept
{
  return !m_parts.empty() &&
         std::all_of(m_parts.begin(), m_parts.end(), [](const Part& part) { return part.isClosed; });
}

double OutwardSurface::volume() const noexcept
{
  double sum = 0.0;
  for (const Part& part : m_parts)
    if (part.isClosed) sum += part.volume;
  return sum;
}

Eigen::Vector3d OutwardSurface::triangleNormal(Index triangle) const
{
  const Eigen::Vector3d a = m_position.col(m_triangles(0, triangle));
  const Eigen::Vector3d u = m_position.col(m_triangles(1, triangle)) - a,
                        v = m_position.col(m_triangles(2, triangle)) - a;
  return u.cross(v);
}

Eigen::Matrix3Xd OutwardSurface::nodeNormals() const
{
  Eigen::Matrix3Xd normals = Eigen::Matrix3Xd::Zero(3, m_position.cols());
  for (Index t = 0; t < static_cast<Index>(m_triangles.cols()); ++t) {
    const Eigen::Vector3d normal = triangleNormal(t).normalized(); // 0 stays 0
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d here = m_position.col(m_triangles(k, t));
      const Eigen::Vector3d u = m_position.col(m_triangles((k + 1) % 3, t)) - here,
                            v = m_position.col(m_triangles((k + 2) % 3, t)) - here;
      normals.col(m_triangles(k, t)) += std::atan2(u.cross(v).norm(), u.dot(v)) * normal;
    }
  }
  normals.colwise().normalize();
  return normals;
}

} // namespace esm
