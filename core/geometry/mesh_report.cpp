// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/geometry/mesh_report.h"

#include "core/geometry/distance.h"
#include "core/geometry/edge_table.h"

#include <Eigen/Geometry>

#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

namespace esm {

namespace {

/// Union-find with path halving over vertices.
class Parts {
public:
  explicit Parts(Index count) : m_parent(static_cast<std::size_t>(count))
  {
    std::iota(m_parent.begin(), m_parent.end(), 0);
  }
  /// Whether the two were apart until now.
  bool join(Index a, Index b)
  {
    a = root(a);
    b = root(b);
    if (a == b) return false;
    at(std::max(a, b)) = std::min(a, b);
    return true;
  }

private:
  Index& at(Index i) { return m_parent[static_cast<std::size_t>(i)]; }
  Index root(Index i)
  {
    while (at(i) != i) i = at(i) = at(at(i));
    return i;
  }
  std::vector<Index> m_parent;
};

void examineVertices(const Mesh& mesh, std::vector<std::uint8_t>& isFinite, MeshReport& report)
{
  report.nodes = mesh.vertexCount();
  isFinite.resize(static_cast<std::size_t>(report.nodes));
  bool any = false;
  for (Index v = 0; v < report.nodes; ++v) {
    const Eigen::Vector3d p = mesh.position.col(v);
    const bool good = p.allFinite();
    isFinite[static_cast<std::size_t>(v)] = good;
    if (!good) {
      ++report.nonFiniteVertices;
    } else {
      report.boxMin = any ? report.boxMin.cwiseMin(p) : p;
      report.boxMax = any ? report.boxMax.cwiseMax(p) : p;
      any = true;
    }
  }
  report.finite = report.nonFiniteVertices == 0;
}

void examineSprings(const Mesh& mesh, const EdgeTable& edges, const std::vector<std::uint8_t>& isFinite,
                    MeshReport& report)
{
  report.springs = static_cast<Index>(edges.ends.cols());
  std::vector<std::uint8_t> used(isFinite.size(), 0);
  Parts parts(report.nodes);
  Index joins = 0;
  for (Index e = 0; e < report.springs; ++e) {
    const Index a = edges.ends(0, e), b = edges.ends(1, e);
    used[static_cast<std::size_t>(a)] = used[static_cast<std::size_t>(b)] = 1;
    if (parts.join(a, b)) ++joins;
    const Index triangles = edges.triangleCount[static_cast<std::size_t>(e)];
    if (triangles == 1) ++report.boundaryEdges;
    if (triangles > 2) ++report.nonManifoldEdges;
    if (isFinite[static_cast<std::size_t>(a)] && isFinite[static_cast<std::size_t>(b)])
      report.sumRestLength += distance(mesh.position.col(a), mesh.position.col(b));
  }
  const Index inUse = std::accumulate(used.begin(), used.end(), Index{0});
  report.isolatedVertices = report.nodes - inUse;
  report.components = inUse - joins; // each join makes two parts one
}

/// Zero area up to the rounding of the cross product itself; a needle that is thin but real is none.
bool isDegenerate(const Mesh& mesh, Index triangle)
{
  const Index a = mesh.triangles(0, triangle), b = mesh.triangles(1, triangle),
              c = mesh.triangles(2, triangle);
  if (a == b || b == c || c == a) return true;
  const Eigen::Vector3d u = mesh.position.col(b) - mesh.position.col(a);
  const Eigen::Vector3d v = mesh.position.col(c) - mesh.position.col(a);
  const double scale = u.cwiseAbs().maxCoeff() * v.cwiseAbs().maxCoeff();
  return u.cross(v).cwiseAbs().maxCoeff() <= 16 * std::numeric_limits<double>::epsilon() * scale;
}

void examineFaces(const Mesh& mesh, MeshReport& report, WorkControl* control)
{
  report.triangles = mesh.triangleCount();
  report.segments = mesh.segmentCount();
  const std::vector<Index> same = firstSameTriangle(mesh.triangles, mesh.vertexCount(), control);
  if (stopWanted(control)) return;
  for (Index t = 0; t < report.triangles; ++t) {
    if (isDegenerate(mesh, t)) ++report.degenerateFaces;
    if (same[static_cast<std::size_t>(t)] != t) ++report.duplicateFaces;
  }
}

} // namespace

MeshReport examine(const Mesh& mesh, WorkControl* control)
{
  MeshReport report;
  std::vector<std::uint8_t> isFinite;
  examineVertices(mesh, isFinite, report);
  const EdgeTable edges = findEdges(mesh, control);
  if (stopWanted(control)) return report;
  examineSprings(mesh, edges, isFinite, report);
  examineFaces(mesh, report, control);
  return report;
}

} // namespace esm
