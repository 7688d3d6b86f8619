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
void keepOnly(List& list, const std::vector<Index>& stay)
{
  if (list.size() == 0) return; // absent
  for (std::size_t i = 0; i < stay.size(); ++i)
    list[static_cast<decltype(list.size())>(i)] = list[static_cast<decltype(list.size())>(stay[i])];
  if constexpr (requires { list.conservativeResize(0); })
    list.conservativeResize(static_cast<Eigen::Index>(stay.size()));
  else
    list.resize(stay.size());
}

template <class Matrix>
void keepColumns(Matrix& matrix, const std::vector<Index>& stay)
{
  if (matrix.cols() == 0) return;
  for (std::size_t i = 0; i < stay.size(); ++i)
    matrix.col(static_cast<Eigen::Index>(i)) = matrix.col(stay[i]).eval();
  matrix.conservativeResize(Eigen::NoChange, static_cast<Eigen::Index>(stay.size()));
}

} // namespace

void keepAnchors(AnchorSet& anchors, const std::vector<Index>& stay)
{
  keepOnly(anchors.node, stay);
  keepColumns(anchors.point, stay);
  for (Eigen::ArrayXd* array : {&anchors.stiffness, &anchors.viscosity, &anchors.bandLength})
    keepOnly(*array, stay);
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
  const std::vector<Index> nodes = staying(cut.node);
  std::vector<Index> newOf(cut.node.size(), kNoIndex);
  for (std::size_t i = 0; i < nodes.size(); ++i)
    newOf[static_cast<std::size_t>(nodes[i])] = static_cast<Index>(i);
  const auto newOfNode = [&newOf](Index node) { return newOf[static_cast<std::size_t>(node)]; };
  const auto isGone = [&newOfNode](Index node) { return newOfNode(node) == kNoIndex; };

  std::vector<std::uint8_t> spring = cut.spring, anchor(net.anchors.node.size(), 0),
                            triangle(static_cast<std::size_t>(net.triangleCount()), 0);
  for (Index s = 0; s < net.springCount(); ++s)
    if (isGone(net.ends(0, s)) || isGone(net.ends(1, s))) spring[static_cast<std::size_t>(s)] = 1;
  for (std::size_t a = 0; a < anchor.size(); ++a) anchor[a] = isGone(net.anchors.node[a]);
  for (Index t = 0; t < net.triangleCount(); ++t)
    for (int k = 0; k < 3; ++k)
      if (isGone(net.triangles(k, t))) triangle[static_cast<std::size_t>(t)] = 1;

  keepColumns(net.restPosition, nodes);
  keepColumns(net.initialVelocity, nodes);
  keepOnly(net.mass, nodes);
  keepOnly(net.massDamping, nodes);
  keepOnly(net.fixed, nodes);
  keepOnly(net.nodeId, nodes);
  keepOnly(net.volume, nodes);
  keepOnly(net.supportNode, nodes);

  const std::vector<Index> springs = staying(spring);
  keepColumns(net.ends, springs);
  for (Eigen::ArrayXd* array :
       {&net.restLength, &net.stiffness, &net.viscosity, &net.lawParameter, &net.section})
    keepOnly(*array, springs);
  keepOnly(net.law, springs);
  keepOnly(net.tensionOnly, springs);
  keepOnly(net.kind, springs);
  keepOnly(net.springId, springs);

  keepAnchors(net.anchors, staying(anchor));
  keepColumns(net.triangles, staying(triangle));
  std::erase_if(net.pressure,
                [&isGone](const PressureBody& body) { return body.triangles.unaryExpr(isGone).any(); });

  net.ends = net.ends.unaryExpr(newOfNode);
  net.triangles = net.triangles.unaryExpr(newOfNode);
  for (Index& node : net.anchors.node) node = newOfNode(node);
  for (PressureBody& body : net.pressure) body.triangles = body.triangles.unaryExpr(newOfNode);
  return newOf;
}

} // namespace esm
