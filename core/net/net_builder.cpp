// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/net/net_builder.h"

#include "core/base/large_pages.h"
#include "core/geometry/distance.h"
#include "core/geometry/edge_table.h"
#include "core/geometry/first_appearance.h"
#include "core/geometry/four_at_a_time.h"
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

/// The nodes of resizeNet() but for their places.
void resizeNodeProperties(SpringNet& net, Index nodes)
{
  const auto count = static_cast<std::size_t>(nodes);
  net.mass.setOnes(nodes);
  net.fixed.assign(count, 0);
  net.nodeId.resize(count);
  for (Index i = 0; i < nodes; ++i) net.nodeId[static_cast<std::size_t>(i)] = NodeId{i};
}

/// The springs of resizeNet() but for their ends and rest lengths.
void resizeSpringProperties(SpringNet& net, Index springs)
{
  const auto count = static_cast<std::size_t>(springs);
  for (Eigen::ArrayXd* values : {&net.stiffness, &net.viscosity, &net.lawParameter})
    setZero(*values, springs, 1);
  net.law = largeVector(count, SpringLaw::Linear);
  net.tensionOnly = largeVector(count, std::uint8_t{0});
  net.kind = largeVector(count, SpringKind::Edge);
  reserveLarge(net.springId, count);
  for (Index s = 0; s < springs; ++s) net.springId.push_back(SpringId{s});
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

/// Keeps the columns of `matrix` for which `isKept` holds.
template <class Matrix, class IsKept>
void keepColumns(Matrix& matrix, const IsKept& isKept)
{
  Index kept = 0;
  const auto count = static_cast<Index>(matrix.cols());
  for (Index i = 0; i < count; ++i) {
    if (!isKept(i)) continue;
    if (kept < i) matrix.col(kept) = matrix.col(i);
    ++kept;
  }
  if (kept < count) matrix.conservativeResize(Eigen::NoChange, kept);
}

/// Sets the lengths of edges as long as they are usual ones, see measureUsual().
bool measureAllUsual(const Eigen::Matrix3Xd& position, const SegmentMatrix& ends, Eigen::ArrayXd& length,
                     WorkControl* control)
{
  const auto count = static_cast<std::size_t>(ends.cols());
  for (std::size_t e = 0; e < count; e += kItemsPerLook) {
    if (stopWantedAt(e, count, control)) return false;
    const std::size_t end = std::min(e + kItemsPerLook, count);
    if (!measureUsual(position, ends, static_cast<Index>(e), static_cast<Index>(end), length)) return false;
  }
  return true;
}

/// Edges that can be springs: finite ends, apart from each other. The others go, from `length` and
/// `surfaceEdges`, too.
Status keepPossible(const Eigen::Matrix3Xd& position, SegmentMatrix& ends, Index& surfaceEdges,
                    Eigen::ArrayXd& length, WorkControl* control)
{
  const auto count = static_cast<Index>(ends.cols());
  Index kept = 0, surface = 0;
  for (Index e = 0; e < count; ++e) {
    if (stopWantedAt(static_cast<std::size_t>(e), static_cast<std::size_t>(count), control))
      return cancelledError();
    const Eigen::Vector2<Index> end = ends.col(e);
    const double between = distance(position.col(end[0]), position.col(end[1]));
    if (!std::isfinite(between)) {
      if (!position.col(end[0]).allFinite() || !position.col(end[1]).allFinite()) continue;
      return Error{ErrorCode::InvalidValue, "vertices " + std::to_string(end[0]) + " and " +
                                              std::to_string(end[1]) +
                                              " are further apart than a number can hold"};
    }
    if (!(between > 0.0)) continue;
    ends.col(kept) = end;
    length[kept++] = between;
    if (e < surfaceEdges) surface = kept;
  }
  surfaceEdges = surface;
  ends.conservativeResize(Eigen::NoChange, kept);
  length.conservativeResize(kept);
  return {};
}

/// Makes springs of the unique edges that can be some; their ends are vertices.
/// @param edgeEnds, surfaceEdges of EdgeList
/// @param nodeOf becomes 0 for vertices that carry a spring
Status addSprings(const Mesh& mesh, SegmentMatrix&& edgeEnds, Index surfaceEdges, std::vector<Index>& nodeOf,
                  SpringNet& net, WorkControl* control)
{
  net.ends = std::move(edgeEnds);
  net.restLength.resize(net.ends.cols());
  useLargePages(net.restLength);
  if (!measureAllUsual(mesh.position, net.ends, net.restLength, control)) {
    if (stopWanted(control)) return cancelledError();
    if (Status good = keepPossible(mesh.position, net.ends, surfaceEdges, net.restLength, control); !good)
      return good;
  }
  const auto springs = static_cast<Index>(net.ends.cols());
  if (springs == 0)
    return Error{ErrorCode::EmptyResult, "the mesh has no edge or line of positive length, so no spring"};
  for (const Index vertex : net.ends.reshaped()) nodeOf[static_cast<std::size_t>(vertex)] = 0;
  resizeSpringProperties(net, springs);
  std::fill(net.kind.begin() + surfaceEdges, net.kind.end(), SpringKind::Line);
  return {};
}

/// Numbers the vertices that carry a spring, in their own order; the others keep kNoIndex. Renumbers the
/// springs.
void addNodes(Eigen::Matrix3Xd&& position, std::vector<Index>& nodeOf, SpringNet& net)
{
  Index nodes = 0;
  for (Index& node : nodeOf)
    if (node != kNoIndex) node = nodes++;
  resizeNodeProperties(net, nodes);
  net.restPosition = std::move(position);
  if (nodes == static_cast<Index>(nodeOf.size())) return; // as a rule: every vertex is the node of its number
  keepColumns(net.restPosition, [&](Index v) { return nodeOf[static_cast<std::size_t>(v)] != kNoIndex; });
  for (Index& node : net.ends.reshaped()) node = nodeOf[static_cast<std::size_t>(node)];
}

/// The triangles over three distinct nodes, each set of corners once.
/// @param thin, repeated of EdgeList
void addSurface(TriangleMatrix&& triangles, const EdgeList& edges, const std::vector<Index>& nodeOf,
                SpringNet& net)
{
  net.triangles = std::move(triangles);
  const bool isRenumbered = net.nodeCount() < static_cast<Index>(nodeOf.size());
  if (edges.thin.empty() && edges.repeated.empty() && !isRenumbered) return; // as a rule
  if (isRenumbered)
    for (Index& corner : net.triangles.reshaped()) corner = nodeOf[static_cast<std::size_t>(corner)];
  auto thin = edges.thin.begin(), repeated = edges.repeated.begin();
  const auto isNext = [](auto& next, const std::vector<Index>& list, Index t) {
    const bool is = next != list.end() && *next == t;
    if (is) ++next;
    return is;
  };
  keepColumns(net.triangles, [&](Index t) {
    const bool isThin = isNext(thin, edges.thin, t), isRepeated = isNext(repeated, edges.repeated, t);
    return !isThin && !isRepeated && net.triangles.col(t).minCoeff() != kNoIndex;
  });
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
  setZero(net.restPosition, 3, nodes);
  resizeNodeProperties(net, nodes);
  setZero(net.ends, 2, springs);
  setZero(net.restLength, springs, 1);
  resizeSpringProperties(net, springs);
}

Result<SpringNet> buildNet(Mesh mesh, std::vector<Index>* nodeOfVertex, WorkControl* control,
                           std::optional<EdgeList> edges)
{
  if (!edges || mesh.tetrahedronCount() > 0) {
    if (Status good = checkIndices(mesh.triangles, mesh.vertexCount(), "triangle"); !good)
      return good.error();
    if (Status good = checkIndices(mesh.segments, mesh.vertexCount(), "line"); !good) return good.error();
    if (mesh.tetrahedronCount() > 0) return buildSolidNet(mesh, nodeOfVertex, control);
    edges = listEdges(mesh, control);
    if (stopWanted(control)) return cancelledError();
  }
  SpringNet net;
  std::vector<Index> nodeOf = largeVector(static_cast<std::size_t>(mesh.vertexCount()), kNoIndex);
  if (Status good = addSprings(mesh, std::move(edges->ends), edges->surfaceEdges, nodeOf, net, control);
      !good)
    return good.error();
  addNodes(std::move(mesh.position), nodeOf, net);
  addSurface(std::move(mesh.triangles), *edges, nodeOf, net);
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
  const Index* const springOfSide = first.data() + springs;
  for (Index t = 0; t < net.triangleCount(); ++t) {
    const double whole = triangleArea(net, t);
    const bool isRegular = net.material.edges == EdgeFormula::Regular;
    for (Index c = 0; c < 3; ++c) {
      const Index spring = springOfSide[3 * std::ptrdiff_t{t} + c];
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
