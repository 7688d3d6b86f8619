// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "tests/support/free_centres.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace esm::test {
namespace {

constexpr double kLine = 1e-9; // of the motion
/// Of places: each of some thousand steps rounds each node once.
constexpr double kRounding = 64.0 * std::numeric_limits<double>::epsilon();

Eigen::Vector3d centre(const SpringNet& net, const std::vector<Index>& nodes, const Eigen::Matrix3Xd& values)
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double mass = 0.0;
  for (const Index node : nodes) {
    sum += net.mass[node] * values.col(node);
    mass += net.mass[node];
  }
  return sum / mass;
}

} // namespace

FreeCentres::FreeCentres(const SpringNet& net, const Loads& loads, const NetState& start)
  : m_net(net), m_loads(loads), m_partOf(static_cast<std::size_t>(net.nodeCount())), m_time(start.time)
{
  std::iota(m_partOf.begin(), m_partOf.end(), Index{0});
  for (bool changed = true; changed;) { // small nets: until the lowest number has gone everywhere
    changed = false;
    for (Index s = 0; s < net.springCount(); ++s) {
      if (net.stiffness[s] == 0.0 && net.viscosity[s] == 0.0) continue;
      Index &a = m_partOf[static_cast<std::size_t>(net.ends(0, s))],
            &b = m_partOf[static_cast<std::size_t>(net.ends(1, s))];
      changed = changed || a != b;
      a = b = std::min(a, b);
    }
  }
  m_parts.resize(m_partOf.size());
  for (Index i = 0; i < net.nodeCount(); ++i) {
    Part& part = m_parts[static_cast<std::size_t>(m_partOf[static_cast<std::size_t>(i)])];
    part.nodes.push_back(i);
    part.mass += net.mass[i];
    part.isHeld = part.isHeld || net.fixed[static_cast<std::size_t>(i)] != 0 ||
                  (net.massDamping.size() > 0 && net.massDamping[i] > 0.0);
  }
  for (Index k = 0; k < net.anchors.count(); ++k)
    if (net.anchors.stiffness[k] > 0.0 || net.anchors.viscosity[k] > 0.0)
      m_parts[static_cast<std::size_t>(
                m_partOf[static_cast<std::size_t>(net.anchors.node[static_cast<std::size_t>(k)])])]
        .isHeld = true;
  for (const NodalForce& force : loads.forces)
    m_corners.insert(m_corners.end(), force.force.time.begin(), force.force.time.end());
  std::sort(m_corners.begin(), m_corners.end());
  look(start);
}

bool FreeCentres::isMoved(const Part& part, double time) const
{
  for (const PrescribedMotion& motion : m_loads.motions)
    for (const Index node : motion.nodes)
      if (m_parts.data() + m_partOf[static_cast<std::size_t>(node)] == &part &&
          !(motion.release && *motion.release <= time + 1e-12))
        return true;
  return false;
}

/// By the lines that hold from `from` on.
Eigen::Vector3d FreeCentres::forceOn(const Part& part, double from, double at) const
{
  Eigen::Vector3d sum = part.mass * m_loads.gravity;
  for (const NodalForce& force : m_loads.forces)
    for (const Index node : force.nodes)
      if (m_parts.data() + m_partOf[static_cast<std::size_t>(node)] == &part)
        sum += force.force.at(from) + force.force.slopeAt(from) * (at - from);
  return sum;
}

void FreeCentres::fly(Part& part, double to) const
{
  for (double from = m_time; from < to;) {
    const auto corner = std::upper_bound(m_corners.begin(), m_corners.end(), from);
    const double end = corner == m_corners.end() ? to : std::min(to, *corner), t = end - from;
    const Eigen::Vector3d first = forceOn(part, from, from) / part.mass,
                          last = forceOn(part, from, end) / part.mass;
    part.x += t * part.v + t * t * (2.0 * first + last) / 6.0;
    part.v += t * (first + last) / 2.0;
    part.pulled += (sizeOfForcesOn(part, from, from) + sizeOfForcesOn(part, from, end)) / 2.0 * t;
    from = end;
  }
}

double FreeCentres::sizeOfForcesOn(const Part& part, double from, double at) const
{
  double sum = part.mass * m_loads.gravity.norm();
  for (const NodalForce& force : m_loads.forces)
    for (const Index node : force.nodes)
      if (m_parts.data() + m_partOf[static_cast<std::size_t>(node)] == &part)
        sum += (force.force.at(from) + force.force.slopeAt(from) * (at - from)).norm();
  return sum;
}

double FreeCentres::look(const NetState& state)
{
  double worst = 0.0;
  for (Part& part : m_parts) {
    if (part.nodes.empty()) continue;
    const bool flies = !part.isHeld && !isMoved(part, state.time);
    if (flies && part.isFlying) {
      fly(part, state.time);
      double size = 0.0;
      for (std::size_t k = 0; k < part.nodes.size(); ++k) {
        const auto at = state.position.col(part.nodes[k]);
        part.motion = std::max(part.motion, (at - part.from.col(static_cast<Index>(k))).norm());
        part.speed = std::max(part.speed, state.velocity.col(part.nodes[k]).norm());
        size = std::max(size, at.norm());
      }
      const double off = (centre(m_net, part.nodes, state.position) - part.x).norm(),
                   change = (centre(m_net, part.nodes, state.velocity) - part.v).norm();
      // Where forces all but cancel out, their sum is known to this speed.
      const double unknown = 4.0 * std::numeric_limits<double>::epsilon() * part.pulled / part.mass;
      const double place = kLine * part.motion + kRounding * size + unknown * (state.time - part.start);
      if (off > 0.0) worst = std::max(worst, off / place);
      if (change > 0.0) worst = std::max(worst, change / (kLine * part.speed + unknown));
    } else if (flies) {
      part.x = centre(m_net, part.nodes, state.position);
      part.v = centre(m_net, part.nodes, state.velocity);
      part.start = state.time;
      part.pulled = 0.0;
      part.from.resize(3, static_cast<Index>(part.nodes.size()));
      for (std::size_t k = 0; k < part.nodes.size(); ++k) {
        part.from.col(static_cast<Index>(k)) = state.position.col(part.nodes[k]);
        part.speed = std::max(part.speed, state.velocity.col(part.nodes[k]).norm());
      }
    }
    part.isFlying = flies;
  }
  m_time = state.time;
  return worst;
}

std::size_t FreeCentres::freeCount() const
{
  return static_cast<std::size_t>(
    std::count_if(m_parts.begin(), m_parts.end(), [](const Part& part) { return part.isFlying; }));
}

} // namespace esm::test
