// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/geometry/orientation.h"

#include "core/geometry/triangle_shape.h"

#include <Eigen/Geometry>

#include <cmath>

namespace esm {

namespace {

/// The sides (3 t + corner) over an edge: the first two, and how many there are.
struct Sides {
  Index first = kNoIndex, second = kNoIndex;
  Index count = 0;
};

std::vector<Sides> sidesOfEdges(const Mesh& mesh, const EdgeTable& edges, WorkControl* control)
{
  std::vector<Sides> sides(static_cast<std::size_t>(edges.surfaceEdges));
  for (Index t = 0; t < mesh.triangleCount(); ++t) {
    if (stopWantedAt(static_cast<std::size_t>(t), static_cast<std::size_t>(mesh.triangleCount()), control))
      return sides;
    if (hasEqualCorners(mesh, t)) continue;
    for (Index side = 3 * t; side < 3 * t + 3; ++side) {
      Sides& of = sides[static_cast<std::size_t>(edges.edgeOfSide[static_cast<std::size_t>(side)])];
      if (of.count == 0) of.first = side;
      if (of.count == 1) of.second = side;
      ++of.count;
    }
  }
  return sides;
}

/// Walks over the edges from triangle to triangle, and turns each as its neighbour wants it.
class PatchWalk {
public:
  PatchWalk(const Mesh& mesh, const EdgeTable& edges, Orientation& out, WorkControl* control)
    : m_mesh(mesh),
      m_edges(edges),
      m_sides(sidesOfEdges(mesh, edges, control)),
      m_out(out),
      m_control(control)
  {
    const auto triangles = static_cast<std::size_t>(mesh.triangleCount());
    out.patchOf.assign(triangles, kNoIndex);
    out.isTurned.assign(triangles, 0);
  }

  void walkAll()
  {
    for (Index t = 0; t < m_mesh.triangleCount() && !stopWanted(m_control); ++t)
      if (m_out.patchOf[static_cast<std::size_t>(t)] == kNoIndex && !hasEqualCorners(m_mesh, t)) walkFrom(t);
  }

private:
  void walkFrom(Index seed)
  {
    const Index number = static_cast<Index>(m_out.patches.size());
    SurfacePatch patch{seed, 0, true, 0.0};
    m_members.assign(1, seed);
    m_out.patchOf[static_cast<std::size_t>(seed)] = number;
    Index turned = 0;
    for (std::size_t i = 0; i < m_members.size(); ++i) {
      if (stopWantedAt(i, static_cast<std::size_t>(m_mesh.triangleCount()), m_control)) return;
      const Index t = m_members[i];
      turned += m_out.isTurned[static_cast<std::size_t>(t)];
      for (Index side = 3 * t; side < 3 * t + 3; ++side) patch.isClosed &= cross(side, number);
    }
    patch.triangles = static_cast<Index>(m_members.size());
    if (2 * turned > patch.triangles) // the seed was one of the few
      for (const Index t : m_members) m_out.isTurned[static_cast<std::size_t>(t)] ^= 1;
    if (patch.isClosed) patch.volume = volume();
    patch.isClosed &= std::isfinite(patch.volume);
    m_out.patches.push_back(patch);
  }

  /// @return whether there is a neighbour over this side.
  bool cross(Index side, Index number)
  {
    const Index edge = m_edges.edgeOfSide[static_cast<std::size_t>(side)];
    const Sides& sides = m_sides[static_cast<std::size_t>(edge)];
    if (sides.count != 2) return false;
    const Index other = sides.first == side ? sides.second : sides.first;
    const auto here = static_cast<std::size_t>(side / 3), there = static_cast<std::size_t>(other / 3);
    // Neighbours that agree run along their edge in opposite directions.
    const bool isOpposed = start(side) == start(other);
    const auto wanted = static_cast<std::uint8_t>(m_out.isTurned[here] ^ (isOpposed ? 1 : 0));
    if (m_out.patchOf[there] == kNoIndex) {
      m_out.patchOf[there] = number;
      m_out.isTurned[there] = wanted;
      m_members.push_back(other / 3);
    } else if (m_out.isTurned[there] != wanted && side < other) { // said once, from one of its two sides
      m_out.unorientable.push_back(edge);
    }
    return true;
  }

  Index start(Index side) const { return m_mesh.triangles.data()[side]; }

  double volume() const
  {
    const Eigen::Vector3d origin = m_mesh.position.col(m_mesh.triangles(0, m_members.front()));
    double sixfold = 0.0;
    for (const Index t : m_members) {
      const Eigen::Vector3d a = m_mesh.position.col(m_mesh.triangles(0, t)) - origin;
      const double part = a.dot(areaVector(m_mesh, t));
      sixfold += m_out.isTurned[static_cast<std::size_t>(t)] ? -part : part;
    }
    return sixfold / 6.0;
  }

  const Mesh& m_mesh;
  const EdgeTable& m_edges;
  std::vector<Sides> m_sides;
  Orientation& m_out;
  WorkControl* m_control;
  std::vector<Index> m_members; ///< triangles of the present patch
};

} // namespace

Orientation findOrientation(const Mesh& mesh, const EdgeTable& edges, WorkControl* control)
{
  Orientation orientation;
  PatchWalk(mesh, edges, orientation, control).walkAll();
  return orientation;
}

} // namespace esm
