// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/geometry/mesh_report.h"

#include "core/geometry/distance.h"
#include "core/geometry/edge_table.h"
#include "core/geometry/four_at_a_time.h"
#include "core/geometry/union_find.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

namespace esm {

namespace {

/// Returns which vertices a spring uses.
std::vector<std::uint8_t> examineParts(const Mesh& mesh, const EdgeList& edges, MeshReport& report,
                                       WorkControl* control)
{
  const Index vertices = mesh.vertexCount();
  report.springs = static_cast<Index>(edges.ends.cols());
  UnionFind parts(vertices);
  const Index* const ends = edges.ends.data();
  Index joins = 0;
  for (Index e = 0; e < report.springs; ++e) {
    if (stopWantedAt(static_cast<std::size_t>(e), static_cast<std::size_t>(report.springs), control))
      return {};
    joins += parts.join(ends[2 * std::ptrdiff_t{e}], ends[2 * std::ptrdiff_t{e} + 1]);
  }
  // Only a vertex that nothing uses is still a part of its own.
  std::vector<std::uint8_t> isUsed(static_cast<std::size_t>(vertices), 0);
  for (Index v = 0; v < vertices; ++v)
    if (const Index root = parts.root(v); root != v)
      isUsed[static_cast<std::size_t>(root)] = isUsed[static_cast<std::size_t>(v)] = 1;
  report.nodes = std::accumulate(isUsed.begin(), isUsed.end(), Index{0});
  report.isolatedVertices = vertices - report.nodes;
  report.components = report.nodes - joins; // each join makes two parts one
  return isUsed;
}

/// The box around the nodes alone.
void shrinkBox(const Mesh& mesh, const std::vector<std::uint8_t>& isUsed, MeshReport& report)
{
  if (report.isolatedVertices == 0 || report.nodes == 0) return;
  Mesh nodes;
  nodes.position.resize(3, report.nodes);
  Index count = 0;
  for (Index v = 0; v < mesh.vertexCount(); ++v)
    if (isUsed[static_cast<std::size_t>(v)] != 0) nodes.position.col(count++) = mesh.position.col(v);
  const VertexBox box = boxOf(nodes);
  report.boxMin = box.low;
  report.boxMax = box.high;
}

void examineFaces(const Mesh& mesh, const EdgeList& edges, MeshReport& report, WorkControl* control)
{
  report.triangles = mesh.triangleCount();
  report.segments = mesh.segmentCount();
  report.boundaryEdges = static_cast<Index>((edges.triangleCount == 1).count());
  report.nonManifoldEdges = static_cast<Index>((edges.triangleCount > 2).count());
  report.duplicateFaces = static_cast<Index>(edges.repeated.size());
  const auto count = static_cast<std::size_t>(report.triangles);
  for (std::size_t t = 0; t < count; t += kItemsPerLook) {
    if (stopWantedAt(t, count, control)) return;
    const std::size_t end = std::min(t + kItemsPerLook, count);
    report.degenerateFaces += countDegenerate(mesh, static_cast<Index>(t), static_cast<Index>(end));
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
  const VertexBox box = boxOf(mesh);
  report.boxMin = box.low;
  report.boxMax = box.high;
  report.nonFiniteVertices = box.nonFinite;
  report.finite = box.nonFinite == 0;
  const std::vector<std::uint8_t> isUsed = examineParts(mesh, edges, report, control);
  if (stopWanted(control)) return report;
  shrinkBox(mesh, isUsed, report);
  examineFaces(mesh, edges, report, control);
  return report;
}

VertexBox boxOf(const Mesh& mesh)
{
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  VertexBox box;
  // Not as vectors: the compiler keeps numbers in registers, and vectors of three in memory.
  double low[3] = {kInfinity, kInfinity, kInfinity}, high[3] = {-kInfinity, -kInfinity, -kInfinity};
  const double* p = mesh.position.data();
  for (Index v = 0; v < mesh.vertexCount(); ++v, p += 3) {
    if (!((p[0] - p[0]) + (p[1] - p[1]) + (p[2] - p[2]) == 0.0)) { // NaN for all that is not finite
      ++box.nonFinite;
      continue;
    }
    for (int k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], p[k]);
      high[k] = std::max(high[k], p[k]);
    }
  }
  if (box.nonFinite < mesh.vertexCount()) {
    box.low = Eigen::Vector3d(low[0], low[1], low[2]);
    box.high = Eigen::Vector3d(high[0], high[1], high[2]);
  }
  return box;
}

double sumRestLength(const Mesh& mesh, const EdgeList& edges)
{
  double sum = 0.0;
  for (const auto& ends : edges.ends.colwise()) {
    const Eigen::Vector3d a = mesh.position.col(ends[0]), b = mesh.position.col(ends[1]);
    if (a.allFinite() && b.allFinite()) sum += distance(a, b);
  }
  return sum;
}

} // namespace esm
