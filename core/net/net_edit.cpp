// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/net/net_edit.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace esm {

namespace {

void appendValues(Eigen::ArrayXd& array, Index count, double value)
{
  const Eigen::Index before = array.size();
  array.conservativeResize(before + count);
  array.tail(count).setConstant(value);
}

template <class Matrix>
void appendColumns(Matrix& matrix, Index count)
{
  const Eigen::Index before = matrix.cols();
  matrix.conservativeResize(Eigen::NoChange, before + count);
  matrix.rightCols(count).setZero();
}

template <class Id>
void appendIds(std::vector<Id>& ids, Index count)
{
  Index next = 0;
  for (const Id id : ids) next = std::max(next, static_cast<Index>(id) + 1);
  for (Index i = 0; i < count; ++i) ids.push_back(Id{next++});
}

/// The places that stay, ascending.
std::vector<Index> staying(const std::vector<std::uint8_t>& gone)
{
  std::vector<Index> stay;
  for (std::size_t i = 0; i < gone.size(); ++i)
    if (!gone[i]) stay.push_back(static_cast<Index>(i));
  return stay;
}

template <class List>
List only(const List& list, const std::vector<Index>& stay)
{
  List kept;
  if (list.size() == 0) return kept; // absent
  kept.resize(static_cast<decltype(list.size())>(stay.size()));
  for (std::size_t i = 0; i < stay.size(); ++i)
    kept[static_cast<decltype(list.size())>(i)] = list[static_cast<decltype(list.size())>(stay[i])];
  return kept;
}

template <class Matrix>
Matrix onlyColumns(const Matrix& matrix, const std::vector<Index>& stay)
{
  Matrix kept(matrix.rows(), matrix.cols() == 0 ? 0 : static_cast<Eigen::Index>(stay.size()));
  for (Eigen::Index i = 0; i < kept.cols(); ++i) kept.col(i) = matrix.col(stay[static_cast<std::size_t>(i)]);
  return kept;
}

AnchorSet onlyAnchors(const AnchorSet& anchors, const std::vector<Index>& stay)
{
  return {only(anchors.node, stay), onlyColumns(anchors.point, stay), only(anchors.stiffness, stay),
          only(anchors.viscosity, stay), only(anchors.bandLength, stay)};
}

} // namespace

void keepAnchors(AnchorSet& anchors, const std::vector<Index>& stay)
{
  anchors = onlyAnchors(anchors, stay);
}

void growNet(SpringNet& net, Index nodes, Index springs)
{
  appendColumns(net.restPosition, nodes);
  if (net.initialVelocity.cols() > 0) appendColumns(net.initialVelocity, nodes);
  appendValues(net.mass, nodes, 1.0);
  if (net.massDamping.size() > 0) appendValues(net.massDamping, nodes, 0.0);
  net.fixed.resize(net.fixed.size() + static_cast<std::size_t>(nodes), 0);
  appendIds(net.nodeId, nodes);
  if (net.volume.size() > 0) appendValues(net.volume, nodes, 0.0);
  if (!net.supportNode.empty())
    net.supportNode.resize(net.supportNode.size() + static_cast<std::size_t>(nodes), 0);

  const std::size_t count = net.law.size() + static_cast<std::size_t>(springs);
  appendColumns(net.ends, springs);
  for (Eigen::ArrayXd* array : {&net.restLength, &net.stiffness, &net.viscosity, &net.lawParameter})
    appendValues(*array, springs, 0.0);
  net.law.resize(count, SpringLaw::Linear);
  net.tensionOnly.resize(count, 0);
  net.kind.resize(count, SpringKind::Edge);
  appendIds(net.springId, springs);
  if (net.section.size() > 0) appendValues(net.section, springs, 0.0);
}

std::vector<Index> shrinkNet(SpringNet& net, const NetCut& cut)
{
  std::vector<Index> newOf;
  net = remainingNet(net, cut, &newOf);
  return newOf;
}

SpringNet remainingNet(const SpringNet& net, const NetCut& cut, std::vector<Index>* newOfNode)
{
  const std::vector<Index> nodes = staying(cut.node);
  std::vector<Index> newOf(cut.node.size(), kNoIndex);
  for (std::size_t i = 0; i < nodes.size(); ++i)
    newOf[static_cast<std::size_t>(nodes[i])] = static_cast<Index>(i);
  const auto placeOf = [&newOf](Index node) { return newOf[static_cast<std::size_t>(node)]; };
  const auto isGone = [&placeOf](Index node) { return placeOf(node) == kNoIndex; };

  std::vector<Index> springs, anchors, triangles;
  for (Index s = 0; s < net.springCount(); ++s)
    if (!cut.spring[static_cast<std::size_t>(s)] && !isGone(net.ends(0, s)) && !isGone(net.ends(1, s)))
      springs.push_back(s);
  for (Index a = 0; a < net.anchors.count(); ++a)
    if (!isGone(net.anchors.node[static_cast<std::size_t>(a)])) anchors.push_back(a);
  for (Index t = 0; t < net.triangleCount(); ++t)
    if (!net.triangles.col(t).unaryExpr(isGone).any()) triangles.push_back(t);

  SpringNet left;
  left.restPosition = onlyColumns(net.restPosition, nodes);
  left.initialVelocity = onlyColumns(net.initialVelocity, nodes);
  left.mass = only(net.mass, nodes);
  left.massDamping = only(net.massDamping, nodes);
  left.fixed = only(net.fixed, nodes);
  left.nodeId = only(net.nodeId, nodes);
  left.volume = only(net.volume, nodes);
  left.supportNode = only(net.supportNode, nodes);

  left.ends = onlyColumns(net.ends, springs).unaryExpr(placeOf);
  left.restLength = only(net.restLength, springs);
  left.stiffness = only(net.stiffness, springs);
  left.viscosity = only(net.viscosity, springs);
  left.law = only(net.law, springs);
  left.lawParameter = only(net.lawParameter, springs);
  left.tensionOnly = only(net.tensionOnly, springs);
  left.kind = only(net.kind, springs);
  left.springId = only(net.springId, springs);
  left.section = only(net.section, springs);
  left.tables = net.tables;

  left.anchors = onlyAnchors(net.anchors, anchors);
  for (Index& node : left.anchors.node) node = placeOf(node);
  left.triangles = onlyColumns(net.triangles, triangles).unaryExpr(placeOf);
  left.material = net.material;
  for (const PressureBody& body : net.pressure)
    if (!body.triangles.unaryExpr(isGone).any())
      left.pressure.push_back({body.triangles.unaryExpr(placeOf), body.bulkModulus});
  if (newOfNode != nullptr) *newOfNode = std::move(newOf);
  return left;
}

} // namespace esm
