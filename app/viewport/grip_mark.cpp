// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/viewport/grip_mark.h"

#include "core/contact/node_patch.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>

namespace esm {

namespace {

constexpr double kLeastShare = 0.02; ///< a node that is held at all is seen [1]

} // namespace

void GripMark::setNet(std::shared_ptr<const SpringNet> net)
{
  m_net = std::move(net);
  m_met.clear();
  hold({}, kNoIndex, {});
}

bool GripMark::setRadius(double metres)
{
  if (metres == m_radius) return false;
  m_radius = metres;
  return true;
}

const Grouped<Index>& GripMark::triangles() const
{
  if (m_met.empty()) {
    m_met.assign(static_cast<std::size_t>(m_net->nodeCount()), 0);
    m_triangles.build(m_met.size(), [this](const auto& add) {
      for (Index t = 0; t < m_net->triangleCount(); ++t)
        for (int k = 0; k < 3; ++k) add(m_net->triangles(k, t), t);
    });
  }
  return m_triangles;
}

/// From node to node within the radius, along triangles. Those at the rim are cut, each by the first of its nodes
/// that lie within.
GripMark::Outline GripMark::outline(const Eigen::Matrix3Xd& position, Index node) const
{
  Outline places;
  if (!m_net || node < 0 || node >= m_net->nodeCount() || !(m_radius > 0.0)) return places;
  const Grouped<Index>& trianglesOf = triangles();
  const auto distance = [&](Index other) { return (position.col(other) - position.col(node)).norm(); };
  std::vector<Index> within{node};
  m_met[static_cast<std::size_t>(node)] = 1;
  for (std::size_t i = 0; i < within.size(); ++i)
    for (const Index t : trianglesOf[static_cast<std::size_t>(within[i])]) {
      std::array<Index, 3> corners{m_net->triangles(0, t), m_net->triangles(1, t), m_net->triangles(2, t)};
      const auto outer =
        std::partition(corners.begin(), corners.end(), [&](Index c) { return distance(c) < m_radius; });
      for (auto corner = corners.begin(); corner != outer; ++corner)
        if (std::uint8_t& met = m_met[static_cast<std::size_t>(*corner)]; !met) {
          met = 1;
          within.push_back(*corner);
        }
      if (outer == corners.end() || within[i] != *std::min_element(corners.begin(), outer)) continue;
      const Index lone = outer - corners.begin() == 1 ? corners[0] : corners[2];
      for (const Index other : corners) {
        if (other == lone) continue;
        const double from = distance(lone), to = distance(other);
        places.push_back({lone, other, to != from ? (m_radius - from) / (to - from) : 0.5, t});
      }
    }
  for (const Index met : within) m_met[static_cast<std::size_t>(met)] = 0;
  return places;
}

Eigen::Vector3d GripMark::normal(const Eigen::Matrix3Xd& position, Index node) const
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  if (!m_net || node < 0 || node >= m_net->nodeCount()) return sum;
  for (const Index t : triangles()[static_cast<std::size_t>(node)]) {
    const Eigen::Vector3d a = position.col(m_net->triangles(0, t));
    sum += (position.col(m_net->triangles(1, t)) - a).cross(position.col(m_net->triangles(2, t)) - a);
  }
  return sum;
}

void GripMark::hold(const Eigen::Matrix3Xd& position, Index middle, const std::vector<Index>& nodes)
{
  m_middle = middle;
  m_held = nodes;
  m_shares.clear();
  m_heldOutline.clear();
  if (nodes.empty()) return;
  for (const Index node : nodes) {
    const double distance = (position.col(node) - position.col(middle)).norm();
    m_shares.push_back(m_radius > 0.0 ? std::max(gripShare(distance / m_radius), kLeastShare) : 1.0);
  }
  m_heldOutline = outline(position, middle);
}

} // namespace esm
