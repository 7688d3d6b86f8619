// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/net/net_builder.h"

#include "core/geometry/distance.h"
#include "core/geometry/edge_table.h"
#include "core/geometry/first_appearance.h"
#include "core/net/solid_net.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace esm {

namespace {

template <class Indices>
Status checkIndices(const Indices& indices, Index vertexCount, const char* what)
{
  for (Eigen::Index column = 0; column < indices.cols(); ++column)
    for (Eigen::Index row = 0; row < indices.rows(); ++row)
      if (const Index vertex = indices(row, column); vertex < 0 || vertex >= vertexCount)
        return Error{ErrorCode::InvalidValue, std::string(what) + " " + std::to_string(column) +
                                                " uses vertex " + std::to_string(vertex) +
                                                ", but the mesh has " + std::to_string(vertexCount) +
                                                " vertices"};
  return {};
}

struct Spring {
  Index a, b; ///< vertices
  double length;
  SpringKind kind;
};

/// The unique edges that can be springs: finite ends, apart from each other.
Result<std::vector<Spring>> findSprings(const Mesh& mesh, const EdgeTable& edges)
{
  std::vector<Spring> springs;
  springs.reserve(static_cast<std::size_t>(edges.ends.cols()));
  for (Index e = 0; e < static_cast<Index>(edges.ends.cols()); ++e) {
    const Index a = edges.ends(0, e), b = edges.ends(1, e);
    if (!mesh.position.col(a).allFinite() || !mesh.position.col(b).allFinite()) continue;
    const double length = distance(mesh.position.col(a), mesh.position.col(b));
    if (!std::isfinite(length))
      return Error{ErrorCode::InvalidValue, "vertices " + std::to_string(a) + " and " + std::to_string(b) +
                                              " are further apart than a number can hold"};
    if (length > 0.0)
      springs.push_back({a, b, length, e < edges.surfaceEdges ? SpringKind::Edge : SpringKind::Line});
  }
  if (springs.empty())
    return Error{ErrorCode::EmptyResult, "the mesh has no edge or line of positive length, so no spring"};
  return springs;
}

/// Numbers the vertices that carry a spring, in their own order; kNoIndex for the others.
std::vector<Index> numberNodes(const std::vector<Spring>& springs, Index vertexCount, Index& nodes)
{
  std::vector<Index> nodeOf(static_cast<std::size_t>(vertexCount), kNoIndex);
  for (const Spring& spring : springs)
    nodeOf[static_cast<std::size_t>(spring.a)] = nodeOf[static_cast<std::size_t>(spring.b)] = 0;
  nodes = 0;
  for (Index& node : nodeOf)
    if (node != kNoIndex) node = nodes++;
  return nodeOf;
}

/// The triangles over three distinct nodes, each set of corners once.
TriangleMatrix surfaceOf(const Mesh& mesh, const std::vector<Index>& nodeOf, WorkControl* control)
{
  const std::vector<Index> same = firstSameTriangle(mesh.triangles, mesh.vertexCount(), control);
  if (stopWanted(control)) return {};
  TriangleMatrix surface(3, mesh.triangleCount());
  Index count = 0;
  for (Index t = 0; t < mesh.triangleCount(); ++t) {
    Eigen::Matrix<Index, 3, 1> corner;
    for (int k = 0; k < 3; ++k) corner[k] = nodeOf[static_cast<std::size_t>(mesh.triangles(k, t))];
    const bool whole = corner.minCoeff() != kNoIndex && corner[0] != corner[1] && corner[1] != corner[2] &&
                       corner[2] != corner[0];
    if (whole && same[static_cast<std::size_t>(t)] == t) surface.col(count++) = corner;
  }
  surface.conservativeResize(Eigen::NoChange, count);
  return surface;
}

constexpr double kRegularArea = 0.4330127018922193; ///< of an equilateral triangle over L^2: sqrt(3)/4

double triangleArea(const SpringNet& net, Index triangle)
{
  const Eigen::Vector3d a = net.restPosition.col(net.triangles(0, triangle));
  const Eigen::Vector3d u = net.restPosition.col(net.triangles(1, triangle)) - a;
  const Eigen::Vector3d v = net.restPosition.col(net.triangles(2, triangle)) - a;
  return 0.5 * u.cross(v).norm();
}

Result<SpringNet> buildSolidNet(const Mesh& mesh, std::vector<Index>* nodeOfVertex, WorkControl* control)
{
  if (Status good = checkIndices(mesh.tetrahedra, mesh.vertexCount(), "tetrahedron"); !good)
    return good.error();
  std::vector<Index> nodeOf;
  Result<SpringNet> net = buildNet(withoutTetrahedra(mesh), &nodeOf, control);
  if (!net) return net.error();
  addSolidShares(mesh.position, mesh.tetrahedra, nodeOf, *net);
  if (nodeOfVertex) *nodeOfVertex = std::move(nodeOf);
  return net;
}

} // namespace

void resizeNet(SpringNet& net, Index nodes, Index springs)
{
  net = SpringNet{};
  const auto nodeCount = static_cast<std::size_t>(nodes), springCount = static_cast<std::size_t>(springs);
  net.restPosition.setZero(3, nodes);
  net.mass.setOnes(nodes);
  net.fixed.assign(nodeCount, 0);
  net.nodeId.resize(nodeCount);
  for (Index i = 0; i < nodes; ++i) net.nodeId[static_cast<std::size_t>(i)] = NodeId{i};

  net.ends.setZero(2, springs);
  net.restLength.setZero(springs);
  net.stiffness.setZero(springs);
  net.viscosity.setZero(springs);
  net.law.assign(springCount, SpringLaw::Linear);
  net.lawParameter.setZero(springs);
  net.tensionOnly.assign(springCount, 0);
  net.kind.assign(springCount, SpringKind::Edge);
  net.springId.resize(springCount);
  for (Index s = 0; s < springs; ++s) net.springId[static_cast<std::size_t>(s)] = SpringId{s};
}

Result<SpringNet> buildNet(const Mesh& mesh, std::vector<Index>* nodeOfVertex, WorkControl* control)
{
  if (Status good = checkIndices(mesh.triangles, mesh.vertexCount(), "triangle"); !good) return good.error();
  if (Status good = checkIndices(mesh.segments, mesh.vertexCount(), "line"); !good) return good.error();

  if (mesh.tetrahedronCount() > 0) return buildSolidNet(mesh, nodeOfVertex, control);

  const EdgeTable edges = findEdges(mesh, control);
  if (stopWanted(control)) return cancelledError();
  const Result<std::vector<Spring>> springs = findSprings(mesh, edges);
  if (!springs) return springs.error();
  Index nodes = 0;
  std::vector<Index> nodeOf = numberNodes(*springs, mesh.vertexCount(), nodes);

  SpringNet net;
  resizeNet(net, nodes, static_cast<Index>(springs->size()));
  for (Index v = 0; v < mesh.vertexCount(); ++v)
    if (const Index node = nodeOf[static_cast<std::size_t>(v)]; node != kNoIndex)
      net.restPosition.col(node) = mesh.position.col(v);
  for (Index s = 0; s < net.springCount(); ++s) {
    const Spring& spring = (*springs)[static_cast<std::size_t>(s)];
    net.ends(0, s) = nodeOf[static_cast<std::size_t>(spring.a)];
    net.ends(1, s) = nodeOf[static_cast<std::size_t>(spring.b)];
    net.restLength[s] = spring.length;
    net.kind[static_cast<std::size_t>(s)] = spring.kind;
  }
  net.triangles = surfaceOf(mesh, nodeOf, control);
  if (stopWanted(control)) return cancelledError();
  if (nodeOfVertex) *nodeOfVertex = std::move(nodeOf);
  return net;
}

Eigen::ArrayXd nodeDualAreas(const SpringNet& net)
{
  Eigen::ArrayXd area = Eigen::ArrayXd::Zero(net.nodeCount());
  for (Index t = 0; t < net.triangleCount(); ++t) {
    const double third = triangleArea(net, t) / 3.0;
    for (int k = 0; k < 3; ++k) area[net.triangles(k, t)] += third;
  }
  return area;
}

Eigen::ArrayXd edgeTriangleAreas(const SpringNet& net)
{
  // Springs and triangle sides meet in one list of node pairs; springs come first, so the first item with
  // a pair is the spring over it, if there is one.
  const Index springs = net.springCount();
  const auto keyOf = [&](Index item) {
    Index a, b;
    if (item < springs) {
      a = net.ends(0, item);
      b = net.ends(1, item);
    } else {
      const Index side = item - springs;
      a = net.triangles(side % 3, side / 3);
      b = net.triangles((side + 1) % 3, side / 3);
    }
    return std::pair{std::min(a, b), std::max(a, b)};
  };
  const std::vector<Index> first =
    firstAppearances<Index>(springs + 3 * net.triangleCount(), net.nodeCount(), keyOf);

  Eigen::ArrayXd area = Eigen::ArrayXd::Zero(springs);
  for (Index t = 0; t < net.triangleCount(); ++t) {
    const double whole = triangleArea(net, t);
    const bool isRegular = net.material.edges == EdgeFormula::Regular;
    for (Index c = 0; c < 3; ++c) {
      const Index spring = first[static_cast<std::size_t>(springs + 3 * t + c)];
      if (spring < springs)
        area[spring] += isRegular ? kRegularArea * net.restLength[spring] * net.restLength[spring] : whole;
    }
  }
  // Several springs over the same two nodes share them alike.
  for (Index s = 0; s < springs; ++s) area[s] = area[first[static_cast<std::size_t>(s)]];
  for (Index s = 0; s < springs; ++s)
    if (net.kind[static_cast<std::size_t>(s)] == SpringKind::Line) area[s] = 0.0;
  return area;
}

} // namespace esm
