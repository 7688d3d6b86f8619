// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/append_net.h"

#include "core/base/assert.h"

#include <algorithm>

namespace esm {

namespace {

template <class Columns>
void appendColumns(Columns& to, const Columns& from)
{
  const Eigen::Index before = to.cols();
  to.conservativeResize(Eigen::NoChange, before + from.cols());
  to.rightCols(from.cols()) = from;
}

void appendValues(Eigen::ArrayXd& to, const Eigen::ArrayXd& from)
{
  const Eigen::Index before = to.size();
  to.conservativeResize(before + from.size());
  to.tail(from.size()) = from;
}

template <class T>
void appendList(std::vector<T>& to, const std::vector<T>& from)
{
  to.insert(to.end(), from.begin(), from.end());
}

template <class Id>
void appendIds(std::vector<Id>& ids, std::size_t count)
{
  Index next = 0;
  for (const Id id : ids) next = std::max(next, static_cast<Index>(id) + 1);
  for (std::size_t i = 0; i < count; ++i) ids.push_back(Id{next++});
}

} // namespace

void appendNet(SpringNet& net, const SpringNet& added)
{
  ESM_ASSERT(added.anchors.count() == 0 && added.tables.empty());
  const Index offset = net.nodeCount();

  appendColumns(net.restPosition, added.restPosition);
  if (net.initialVelocity.cols() > 0) {
    const Eigen::Index before = net.initialVelocity.cols();
    net.initialVelocity.conservativeResize(Eigen::NoChange, before + added.nodeCount());
    net.initialVelocity.rightCols(added.nodeCount()).setZero();
  }
  appendValues(net.mass, added.mass);
  if (net.massDamping.size() > 0) appendValues(net.massDamping, Eigen::ArrayXd::Zero(added.nodeCount()));
  appendList(net.fixed, added.fixed);
  appendIds(net.nodeId, static_cast<std::size_t>(added.nodeCount()));

  appendColumns<SegmentMatrix>(net.ends, (added.ends.array() + offset).matrix());
  appendValues(net.restLength, added.restLength);
  appendValues(net.stiffness, added.stiffness);
  appendValues(net.viscosity, added.viscosity);
  appendList(net.law, added.law);
  appendValues(net.lawParameter, added.lawParameter);
  appendList(net.tensionOnly, added.tensionOnly);
  appendList(net.kind, added.kind);
  appendIds(net.springId, static_cast<std::size_t>(added.springCount()));
  appendColumns<TriangleMatrix>(net.triangles, (added.triangles.array() + offset).matrix());
}

} // namespace esm
