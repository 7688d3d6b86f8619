// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/net/net_builder.h"

#include "core/base/large_pages.h"
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

/// A fresh rows x columns array of zeros.
template <class Array>
void setZero(Array& array, Eigen::Index rows, Eigen::Index columns)
{
  array.resize(rows, columns);
  zeroInLargePages(array);
}

/// The nodes of resizeNet().
void resizeNodes(SpringNet& net, Index nodes)
{
  const auto count = static_cast<std::size_t>(nodes);
  setZero(net.restPosition, 3, nodes);
  net.mass.setOnes(nodes);
  net.fixed.assign(count, 0);
  net.nodeId.resize(count);
  for (Index i = 0; i < nodes; ++i) net.nodeId[static_cast<std::size_t>(i)] = NodeId{i};
}

/// Drops the springs from number `count` on.
void keepFirstSprings(SpringNet& net, Index count)
{
  net.ends.conservativeResize(Eigen::NoChange, count);
  for (Eigen::ArrayXd* values : {&net.restLength, &net.stiffness, &net.viscosity, &net.lawParameter})
    values->conservativeResize(count);
  const auto size = static_cast<std::size_t>(count);
  net.law.resize(size);
  net.tensionOnly.resize(size);
  net.kind.resize(size);
  net.springId.resize(size);
}

template <class Indices>
Status checkIndices(const Indices& indices, Index vertexCount, const char* what)
{
  if (indices.size() == 0 || (indices.minCoeff() >= 0 && indices.maxCoeff() < vertexCount)) return {};
  for (Eigen::Index column = 0; column < indices.cols(); ++column)
    for (Eigen::Index row = 0; row < indices.rows(); ++row)
      if (const Index vertex = indices(row, column); vertex < 0 || vertex >= vertexCount)
        return Error{ErrorCode::InvalidValue, std::string(what) + " " + std::to_string(column) +
                                                " uses vertex " + std::to_string(vertex) +
                                                ", but the mesh has " + std::to_string(vertexCount) +
                                                " vertices"};
  return {};
}

/// Puts the unique edges that can be springs (finite ends, apart from each other) into the net; ends are
/// vertices.
Status addSprings(const Mesh& mesh, const EdgeTable& edges, SpringNet& net, WorkControl* control)
{
  const Index candidates = static_cast<Index>(edges.ends.cols());
  resizeNet(net, 0, candidates);
  Index springs = 0, surface = 0;
  for (Index e = 0; e < candidates; ++e) {
    if (stopWantedAt(static_cast<std::size_t>(e), static_cast<std::size_t>(candidates), control))
      return cancelledError();
    const Index a = edges.ends(0, e), b = edges.ends(1, e);
    const double length = distance(mesh.position.col(a), mesh.position.col(b));
    if (!std::isfinite(length)) {
      if (!mesh.position.col(a).allFinite() || !mesh.position.col(b).allFinite()) continue;
      return Error{ErrorCode::InvalidValue, "vertices " + std::to_string(a) + " and " + std::to_string(b) +
                                              " are further apart than a number can hold"};
    }
    if (!(length > 0.0)) continue;
    net.ends(0, springs) = a;
    net.ends(1, springs) = b;
    net.restLength[springs++] = length;
    if (e < edges.surfaceEdges) surface = springs;
  }
  if (springs == 0)
    return Error{ErrorCode::EmptyResult, "the mesh has no edge or line of positive length, so no spring"};
  std::fill(net.kind.begin() + surface, net.kind.end(), SpringKind::Line);
  if (springs < candidates) keepFirstSprings(net, springs);
  return {};
}

/// Numbers the vertices that carry a spring, in their own order; kNoIndex for the others. Renumbers the
/// springs.
std::vector<Index> addNodes(const Mesh& mesh, SpringNet& net)
{
  std::vector<Index> nodeOf(static_cast<std::size_t>(mesh.vertexCount()), kNoIndex);
  Index* const ends = net.ends.data();
  for (Eigen::Index i = 0; i < net.ends.size(); ++i) nodeOf[static_cast<std::size_t>(ends[i])] = 0;
  Index nodes = 0;
  for (Index& node : nodeOf)
    if (node != kNoIndex) node = nodes++;

  resizeNodes(net, nodes);
  if (nodes == mesh.vertexCount()) { // as a rule: every vertex is the node of its own number
    net.restPosition = mesh.position;
    return nodeOf;
  }
  for (Eigen::Index i = 0; i < net.ends.size(); ++i) ends[i] = nodeOf[static_cast<std::size_t>(ends[i])];
  for (Index v = 0; v < mesh.vertexCount(); ++v)
    if (const Index node = nodeOf[static_cast<std::size_t>(v)]; node != kNoIndex)
      net.restPosition.col(node) = mesh.position.col(v);
  return nodeOf;
}

/// The triangles over three distinct nodes, each set of corners once.
TriangleMatrix surfaceOf(const Mesh& mesh, const EdgeTable& edges, const std::vector<Index>& nodeOf,
                         Index nodes, WorkControl* control)
{
  TriangleMatrix surface(3, mesh.triangleCount());
  useLargePages(surface);
  const bool isRenumbered = nodes < mesh.vertexCount();
  auto nextRepeated = edges.repeated.begin();
  Index count = 0;
  for (Index t = 0; t < mesh.triangleCount(); ++t) {
    if (stopWantedAt(static_cast<std::size_t>(t), static_cast<std::size_t>(mesh.triangleCount()), control))
      break;
    if (nextRepeated != edges.repeated.end() && *nextRepeated == t) {
      ++nextRepeated;
      continue;
    }
    const Index* const vertex = mesh.triangles.data() + 3 * std::ptrdiff_t{t};
    Index corner[3] = {vertex[0], vertex[1], vertex[2]};
    if (isRenumbered)
      for (Index& node : corner) node = nodeOf[static_cast<std::size_t>(node)];
    if (corner[0] == corner[1] || corner[1] == corner[2] || corner[2] == corner[0]) continue;
    if (isRenumbered && std::min({corner[0], corner[1], corner[2]}) == kNoIndex) continue;
    std::copy_n(corner, 3, surface.data() + 3 * std::ptrdiff_t{count++});
  }
  if (count < mesh.triangleCount()) surface.conservativeResize(Eigen::NoChange, count);
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
  resizeNodes(net, nodes);

  const auto count = static_cast<std::size_t>(springs);
  setZero(net.ends, 2, springs);
  for (Eigen::ArrayXd* values : {&net.restLength, &net.stiffness, &net.viscosity, &net.lawParameter})
    setZero(*values, springs, 1);
  net.law = largeVector(count, SpringLaw::Linear);
  net.tensionOnly = largeVector(count, std::uint8_t{0});
  net.kind = largeVector(count, SpringKind::Edge);
  reserveLarge(net.springId, count);
  for (Index s = 0; s < springs; ++s) net.springId.push_back(SpringId{s});
}

Result<SpringNet> buildNet(const Mesh& mesh, std::vector<Index>* nodeOfVertex, WorkControl* control,
                           const EdgeTable* known)
{
  if (Status good = checkIndices(mesh.triangles, mesh.vertexCount(), "triangle"); !good) return good.error();
  if (Status good = checkIndices(mesh.segments, mesh.vertexCount(), "line"); !good) return good.error();

  if (mesh.tetrahedronCount() > 0) return buildSolidNet(mesh, nodeOfVertex, control);

  EdgeTable found;
  if (!known) found = findEdges(mesh, control);
  if (stopWanted(control)) return cancelledError();
  const EdgeTable& edges = known ? *known : found;
  SpringNet net;
  if (Status good = addSprings(mesh, edges, net, control); !good) return good.error();
  std::vector<Index> nodeOf = addNodes(mesh, net);
  net.triangles = surfaceOf(mesh, edges, nodeOf, net.nodeCount(), control);
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
