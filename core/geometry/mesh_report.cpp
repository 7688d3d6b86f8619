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

/// @return per vertex whether it is finite
std::vector<std::uint8_t> examineVertices(const Mesh& mesh, MeshReport& report)
{
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  report.nodes = mesh.vertexCount();
  std::vector<std::uint8_t> isFinite(static_cast<std::size_t>(report.nodes));
  Eigen::Array3d low = Eigen::Array3d::Constant(kInfinity), high = Eigen::Array3d::Constant(-kInfinity);
  for (Index v = 0; v < report.nodes; ++v) {
    const Eigen::Array3d p = mesh.position.col(v);
    const bool good = (p - p == 0.0).all(); // NaN for all that is not finite
    isFinite[static_cast<std::size_t>(v)] = good;
    if (!good) {
      ++report.nonFiniteVertices;
      continue;
    }
    low = low.min(p);
    high = high.max(p);
  }
  if (report.nonFiniteVertices < report.nodes) {
    report.boxMin = low;
    report.boxMax = high;
  }
  report.finite = report.nonFiniteVertices == 0;
  return isFinite;
}

void examineSprings(const Mesh& mesh, const EdgeList& edges, const std::vector<std::uint8_t>& isFinite,
                    MeshReport& report, WorkControl* control)
{
  report.springs = static_cast<Index>(edges.ends.cols());
  UnionFind parts(report.nodes);
  Index joins = 0, boundary = 0, nonManifold = 0;
  double sum = 0.0;
  for (Index e = 0; e < report.springs; ++e) {
    if (stopWantedAt(static_cast<std::size_t>(e), static_cast<std::size_t>(report.springs), control)) return;
    const Index a = edges.ends(0, e), b = edges.ends(1, e);
    joins += parts.join(a, b);
    const Index triangles = edges.triangleCount[e];
    boundary += triangles == 1;
    nonManifold += triangles > 2;
    if (report.finite || (isFinite[static_cast<std::size_t>(a)] && isFinite[static_cast<std::size_t>(b)]))
      sum += distance(mesh.position.col(a), mesh.position.col(b));
  }
  report.sumRestLength = sum;
  report.boundaryEdges = boundary;
  report.nonManifoldEdges = nonManifold;
  // Only a vertex that nothing uses is still a part of its own.
  std::vector<std::uint8_t> isUsed(isFinite.size(), 0);
  for (Index v = 0; v < report.nodes; ++v)
    if (const Index root = parts.root(v); root != v)
      isUsed[static_cast<std::size_t>(root)] = isUsed[static_cast<std::size_t>(v)] = 1;
  const Index inUse = std::accumulate(isUsed.begin(), isUsed.end(), Index{0});
  report.isolatedVertices = report.nodes - inUse;
  report.components = inUse - joins; // each join makes two parts one
}

void examineFaces(const Mesh& mesh, const EdgeList& edges, MeshReport& report, WorkControl* control)
{
  report.triangles = mesh.triangleCount();
  report.segments = mesh.segmentCount();
  report.duplicateFaces = static_cast<Index>(edges.repeated.size());
  for (Index t = 0; t < report.triangles; ++t) {
    if (stopWantedAt(static_cast<std::size_t>(t), static_cast<std::size_t>(report.triangles), control))
      return;
    if (isDegenerate(mesh, t)) ++report.degenerateFaces;
  }
}

} // namespace

MeshReport examine(const Mesh& mesh, WorkControl* control)
{
  const EdgeList edges = listEdges(mesh, control);
  return stopWanted(control) ? MeshReport{} : examine(mesh, edges, control);
}

MeshReport examine(const Mesh& mesh, const EdgeList& edges, WorkControl* control)
{
  MeshReport report;
  const std::vector<std::uint8_t> isFinite = examineVertices(mesh, report);
  examineSprings(mesh, edges, isFinite, report, control);
  if (stopWanted(control)) return report;
  examineFaces(mesh, edges, report, control);
  return report;
}

} // namespace esm
