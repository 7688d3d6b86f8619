// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/rest/sub_net.h"

#include "core/net/net_builder.h"

#include <algorithm>
#include <iterator>

namespace esm {

void SubNetCutter::prepare(const SpringNet& net)
{
  const auto nodes = static_cast<std::size_t>(net.nodeCount());
  m_place.assign(nodes, kNoIndex);
  m_last.clear();
  m_firstAnchor.assign(nodes + 1, 0);
  for (const Index node : net.anchors.node) ++m_firstAnchor[static_cast<std::size_t>(node) + 1];
  for (std::size_t i = 0; i < nodes; ++i) m_firstAnchor[i + 1] += m_firstAnchor[i];
  m_anchors.resize(net.anchors.node.size());
  std::vector<std::size_t> next(m_firstAnchor.begin(), m_firstAnchor.end() - 1);
  for (Index k = 0; k < net.anchors.count(); ++k)
    m_anchors[next[static_cast<std::size_t>(net.anchors.node[static_cast<std::size_t>(k)])]++] = k;
}

SubNet SubNetCutter::cut(const SpringNet& net, const Loads& loads, const ActiveRegion& region)
{
  for (const Index node : m_last) m_place[static_cast<std::size_t>(node)] = kNoIndex;
  SubNet part;
  std::merge(region.awake().begin(), region.awake().end(), region.rim().begin(), region.rim().end(),
             std::back_inserter(part.nodes));
  for (std::size_t i = 0; i < part.nodes.size(); ++i)
    m_place[static_cast<std::size_t>(part.nodes[i])] = static_cast<Index>(i);
  m_last = part.nodes;
  cutSprings(net, region, part);
  const bool drags = net.massDamping.size() > 0;
  if (drags) part.net.massDamping.resize(part.net.nodeCount());
  for (Index i = 0; i < part.net.nodeCount(); ++i) {
    const Index node = part.nodes[static_cast<std::size_t>(i)];
    part.net.restPosition.col(i) = net.restPosition.col(node);
    part.net.mass[i] = net.mass[node];
    if (drags) part.net.massDamping[i] = net.massDamping[node];
    part.net.fixed[static_cast<std::size_t>(i)] = region.isAwake(node) ? 0 : 1;
  }
  cutAnchors(net, region, part);
  part.loads = loadsOnPart(loads, [this](Index node) { return placeOf(node); });
  return part;
}

void SubNetCutter::cutSprings(const SpringNet& net, const ActiveRegion& region, SubNet& part) const
{
  for (const Index node : region.awake())
    for (const Index spring : region.springsOf(node)) {
      const Index other = region.otherEnd(spring, node);
      if (!region.isAwake(other) || node < other) part.springs.push_back(spring);
    }
  std::sort(part.springs.begin(), part.springs.end());
  resizeNet(part.net, static_cast<Index>(part.nodes.size()), static_cast<Index>(part.springs.size()));
  for (Index s = 0; s < part.net.springCount(); ++s) {
    const auto to = static_cast<std::size_t>(s);
    const Index from = part.springs[to];
    const auto place = static_cast<std::size_t>(from);
    part.net.ends(0, s) = placeOf(net.ends(0, from));
    part.net.ends(1, s) = placeOf(net.ends(1, from));
    part.net.restLength[s] = net.restLength[from];
    part.net.stiffness[s] = net.stiffness[from];
    part.net.viscosity[s] = net.viscosity[from];
    part.net.law[to] = net.law[place];
    part.net.lawParameter[s] = net.lawParameter[from];
    part.net.tensionOnly[to] = net.tensionOnly[place];
  }
  part.net.tables = net.tables;
}

void SubNetCutter::cutAnchors(const SpringNet& net, const ActiveRegion& region, SubNet& part) const
{
  std::vector<Index> anchors;
  for (const Index node : region.awake()) {
    const auto i = static_cast<std::size_t>(node);
    anchors.insert(anchors.end(), m_anchors.begin() + static_cast<std::ptrdiff_t>(m_firstAnchor[i]),
                   m_anchors.begin() + static_cast<std::ptrdiff_t>(m_firstAnchor[i + 1]));
  }
  AnchorSet& set = part.net.anchors;
  const auto count = static_cast<Eigen::Index>(anchors.size());
  set.node.resize(anchors.size());
  set.point.resize(3, count);
  set.stiffness.resize(count);
  set.viscosity.resize(count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const Index from = anchors[static_cast<std::size_t>(k)];
    set.node[static_cast<std::size_t>(k)] = placeOf(net.anchors.node[static_cast<std::size_t>(from)]);
    set.point.col(k) = net.anchors.point.col(from);
    set.stiffness[k] = net.anchors.stiffness[from];
    set.viscosity[k] = net.anchors.viscosity[from];
  }
}

} // namespace esm
