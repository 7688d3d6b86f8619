// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/append_net.h"

#include "core/base/assert.h"
#include "core/net/net_edit.h"
#include "core/tissue/derivation_places.h"

#include <algorithm>

namespace esm {

namespace {

/// Arrays that may be absent: there from now on if the other net has them.
void prepare(Eigen::ArrayXd& values, const Eigen::ArrayXd& other, Index count)
{
  if (values.size() == 0 && other.size() > 0) values.setZero(count);
}

void putAtEnd(Eigen::ArrayXd& to, const Eigen::ArrayXd& from)
{
  if (from.size() > 0) to.tail(from.size()) = from;
}

template <class T>
void putAtEnd(std::vector<T>& to, const std::vector<T>& from)
{
  std::copy(from.begin(), from.end(), to.end() - static_cast<std::ptrdiff_t>(from.size()));
}

void appendAnchors(AnchorSet& anchors, const AnchorSet& added, Index offset)
{
  if (added.count() == 0) return;
  prepare(anchors.bandLength, added.bandLength, anchors.count());
  const Index count = anchors.count() + added.count();
  for (const Index node : added.node) anchors.node.push_back(node + offset);
  anchors.point.conservativeResize(Eigen::NoChange, count);
  anchors.point.rightCols(added.count()) = added.point;
  for (Eigen::ArrayXd* values : {&anchors.stiffness, &anchors.viscosity, &anchors.bandLength})
    if (values->size() > 0) values->conservativeResize(count);
  putAtEnd(anchors.stiffness, added.stiffness);
  putAtEnd(anchors.viscosity, added.viscosity);
  putAtEnd(anchors.bandLength, added.bandLength);
}

/// Springs that another material has made get sections which make them as stiff under this one.
void takeOver(const NetMaterial& material, SpringNet& added, double thickness)
{
  DerivationPlaces places(added);
  places.setThickness(thickness, added);
  added.section = places.perModulus * added.restLength / material.modulusScale;
}

} // namespace

void appendNet(SpringNet& net, const SpringNet& addedAsItIs, double thickness)
{
  SpringNet added = addedAsItIs;
  if (added.material != net.material) takeOver(net.material, added, thickness);
  ESM_ASSERT(added.tables.empty());
  const Index offset = net.nodeCount();
  prepare(net.volume, added.volume, offset);
  prepare(net.section, added.section, net.springCount());
  if (net.supportNode.empty() && !added.supportNode.empty())
    net.supportNode.assign(static_cast<std::size_t>(offset), 0);
  growNet(net, added.nodeCount(), added.springCount());

  net.restPosition.rightCols(added.nodeCount()) = added.restPosition;
  putAtEnd(net.mass, added.mass);
  putAtEnd(net.fixed, added.fixed);
  putAtEnd(net.volume, added.volume);
  putAtEnd(net.supportNode, added.supportNode);

  net.ends.rightCols(added.springCount()) = added.ends.array() + offset;
  putAtEnd(net.restLength, added.restLength);
  putAtEnd(net.stiffness, added.stiffness);
  putAtEnd(net.viscosity, added.viscosity);
  putAtEnd(net.law, added.law);
  putAtEnd(net.lawParameter, added.lawParameter);
  putAtEnd(net.tensionOnly, added.tensionOnly);
  putAtEnd(net.kind, added.kind);
  putAtEnd(net.section, added.section);

  appendAnchors(net.anchors, added.anchors, offset);
  for (PressureBody body : added.pressure) {
    body.triangles.array() += offset;
    net.pressure.push_back(std::move(body));
  }
  const Eigen::Index triangles = net.triangles.cols();
  net.triangles.conservativeResize(Eigen::NoChange, triangles + added.triangles.cols());
  net.triangles.rightCols(added.triangles.cols()) = added.triangles.array() + offset;
}

} // namespace esm
