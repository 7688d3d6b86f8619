// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/geometry/near_vertices.h"

#include "core/geometry/distance.h"
#include "core/geometry/weld.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace esm {

namespace {

constexpr double kFloatSteps = 1e-6;  ///< of the largest coordinate: eight steps of float32 there
constexpr double kShareOfEdge = 1e-3; ///< of such an edge, far below what a mesh has on purpose

/// Rounded up to one digit, as one would type it.
double roundedUp(double value)
{
  const double decade = std::pow(10.0, std::floor(std::log10(value)));
  return std::ceil(value / decade) * decade;
}

} // namespace

NearVertices findNearVertices(const Mesh& mesh, const EdgeList& edges, NearWhere where, WorkControl* control)
{
  NearVertices near;
  std::vector<Index> open; // where it is looked: by default ends of edges of less than two triangles
  double length = 0.0, largest = 0.0;
  for (Eigen::Index e = 0; e < edges.ends.cols(); ++e) {
    if (where == NearWhere::Open && e < edges.surfaceEdges && edges.triangleCount[e] != 1) continue;
    const Eigen::Vector3d a = mesh.position.col(edges.ends(0, e)), b = mesh.position.col(edges.ends(1, e));
    if (!a.allFinite() || !b.allFinite()) continue;
    open.insert(open.end(), {edges.ends(0, e), edges.ends(1, e)});
    length += distance(a, b);
    largest = std::max({largest, a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff()});
  }
  const double tolerance = std::min(
    kFloatSteps * largest, kShareOfEdge * length / (0.5 * static_cast<double>(open.size()) + 1e-300));
  if (open.empty() || !(tolerance > 0.0) || stopWanted(control)) return near;
  std::sort(open.begin(), open.end());
  open.erase(std::unique(open.begin(), open.end()), open.end());
  Mesh ends;
  ends.position = mesh.position(Eigen::all, open);
  const Index before = ends.vertexCount();
  near.tolerance = roundedUp(tolerance);
  weldVertices(ends, near.tolerance, control);
  near.count = before - ends.vertexCount();
  return near;
}

} // namespace esm
