// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/geometry/mesh_report.h"

#include "core/geometry/distance.h"
#include "core/geometry/edge_table.h"
#include "core/geometry/triangle_shape.h"
#include "core/geometry/union_find.h"

#include <Eigen/Geometry>

#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

namespace esm {

namespace {

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
  UnionFind parts(report.nodes);
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

void examineFaces(const Mesh& mesh, const EdgeTable& edges, MeshReport& report, WorkControl* control)
{
  report.triangles = mesh.triangleCount();
  report.segments = mesh.segmentCount();
  report.duplicateFaces = static_cast<Index>(repeatedTriangles(mesh, edges, control).size());
  for (Index t = 0; t < report.triangles; ++t)
    if (isDegenerate(mesh, t)) ++report.degenerateFaces;
}

} // namespace

MeshReport examine(const Mesh& mesh, WorkControl* control)
{
  const EdgeTable edges = findEdges(mesh, control);
  return stopWanted(control) ? MeshReport{} : examine(mesh, edges, control);
}

MeshReport examine(const Mesh& mesh, const EdgeTable& edges, WorkControl* control)
{
  MeshReport report;
  std::vector<std::uint8_t> isFinite;
  examineVertices(mesh, isFinite, report);
  examineSprings(mesh, edges, isFinite, report);
  examineFaces(mesh, edges, report, control);
  return report;
}

} // namespace esm
