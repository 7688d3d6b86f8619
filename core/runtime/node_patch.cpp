// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/runtime/node_patch.h"

#include <algorithm>

namespace esm {

PatchFinder::PatchFinder(const SpringNet& net) : m_met(static_cast<std::size_t>(net.nodeCount()), 0)
{
  std::vector<std::uint8_t> isSurface(m_met.size(), 0);
  for (const Index node : net.triangles.reshaped()) isSurface[static_cast<std::size_t>(node)] = 1;
  m_neighbours.build(m_met.size(), [&](const auto& add) {
    for (Index t = 0; t < net.triangleCount(); ++t)
      for (int k = 0; k < 3; ++k) {
        add(net.triangles(k, t), net.triangles((k + 1) % 3, t));
        add(net.triangles(k, t), net.triangles((k + 2) % 3, t));
      }
    for (Index s = 0; s < net.springCount(); ++s)
      for (int end = 0; end < 2; ++end)
        if (!isSurface[static_cast<std::size_t>(net.ends(end, s))])
          add(net.ends(end, s), net.ends(1 - end, s));
  });
}

/// From the node to where its neighbours' cells begin, in the mean [m].
double PatchFinder::halfCell(const Eigen::Matrix3Xd& position, Index node) const
{
  double sum = 0.0;
  for (const Index next : neighbours(node)) sum += (position.col(next) - position.col(node)).norm();
  const auto count = neighbours(node).size();
  return count > 0 ? 0.5 * sum / static_cast<double>(count) : 0.0;
}

void PatchFinder::find(const Eigen::Matrix3Xd& position, std::span<const Index> first,
                       const Eigen::Vector3d& centre, double radius, std::vector<PatchNode>& nodes)
{
  nodes.clear();
  const auto meet = [&](Index node, bool isFirst) {
    std::uint8_t& met = m_met[static_cast<std::size_t>(node)];
    if (met) return;
    const double half = halfCell(position, node), inside = radius - (position.col(node) - centre).norm();
    double share = half > 0.0 ? std::clamp(0.5 * (inside / half + 1.0), 0.0, 1.0) : double(inside >= 0.0);
    if (isFirst && half >= radius) share = 1.0;
    if (!isFirst && !(share > 0.0)) return;
    met = 1;
    nodes.push_back({node, share});
  };
  for (const Index node : first) meet(node, true);
  for (std::size_t i = 0; i < nodes.size(); ++i)
    for (const Index next : neighbours(nodes[i].node)) meet(next, false);
  for (const PatchNode& met : nodes) m_met[static_cast<std::size_t>(met.node)] = 0;
}

} // namespace esm
