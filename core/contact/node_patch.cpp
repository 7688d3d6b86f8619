// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/contact/node_patch.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace esm {

namespace {

constexpr double kLeastCell = 1e-12; ///< of nodes that lie upon their neighbours [m^2]

} // namespace

double gripShare(double distance) noexcept
{
  const double t = std::clamp(1.5 - distance, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

PatchFinder::PatchFinder(const SpringNet& net)
  : m_isSurface(static_cast<std::size_t>(net.nodeCount()), 0), m_met(m_isSurface.size(), 0)
{
  for (const Index node : net.triangles.reshaped()) m_isSurface[static_cast<std::size_t>(node)] = 1;
  m_neighbours.build(m_met.size(), [&](const auto& add) {
    for (Index t = 0; t < net.triangleCount(); ++t)
      for (int k = 0; k < 3; ++k) {
        add(net.triangles(k, t), net.triangles((k + 1) % 3, t));
        add(net.triangles(k, t), net.triangles((k + 2) % 3, t));
      }
    for (Index s = 0; s < net.springCount(); ++s)
      for (int end = 0; end < 2; ++end)
        if (!m_isSurface[static_cast<std::size_t>(net.ends(end, s))])
          add(net.ends(end, s), net.ends(1 - end, s));
  });
}

double PatchFinder::cell(const Eigen::Matrix3Xd& position, Index node) const
{
  const auto next = neighbours(node);
  const auto way = [&](std::size_t i) -> Eigen::Vector3d {
    return position.col(next[i]) - position.col(node);
  };
  double sum = 0.0;
  if (m_isSurface[static_cast<std::size_t>(node)])
    for (std::size_t i = 0; i < next.size(); i += 2) sum += way(i).cross(way(i + 1)).norm() / 6.0;
  else if (!next.empty()) {
    for (std::size_t i = 0; i < next.size(); ++i) sum += way(i).norm() / static_cast<double>(next.size());
    sum *= sum;
  }
  return std::max(sum, kLeastCell);
}

void PatchFinder::find(const Eigen::Matrix3Xd& position, Index node, double radius,
                       std::vector<PatchNode>& nodes)
{
  nodes.assign(1, {node, 1.0, cell(position, node)});
  m_met[static_cast<std::size_t>(node)] = 1;
  for (std::size_t i = 0; i < nodes.size() && radius > 0.0; ++i)
    for (const Index next : neighbours(nodes[i].node)) {
      std::uint8_t& met = m_met[static_cast<std::size_t>(next)];
      const double share = met ? 0.0 : gripShare((position.col(next) - position.col(node)).norm() / radius);
      if (!(share > 0.0)) continue;
      met = 1;
      nodes.push_back({next, share, cell(position, next)});
    }
  for (const PatchNode& met : nodes) m_met[static_cast<std::size_t>(met.node)] = 0;
}

} // namespace esm
