// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/runtime/ball_press.h"

#include "core/runtime/limited_pull.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace esm {

namespace {

constexpr double kLeastStiffness = 20.0; ///< of all together, on the loosest tissue [N/m]
/// Of the three nodes of a point, see holdOfNodes(): softer, and a hand would be deep in the tissue before this gives
/// way. Nets with edges longer than a ball are small.
constexpr double kPointRate = 3.0;
constexpr double kNotCovered = -std::numeric_limits<double>::infinity();

/// How much higher a node is than the ball's surface is there, both over the lowest; along the normal.
double riseOver(const Eigen::Vector3d& position, const BallContact& contact)
{
  const Eigen::Vector3d from = position - contact.place;
  const double height = contact.normal.dot(from), room = contact.radius * contact.radius;
  const double aside = (from - height * contact.normal).squaredNorm();
  return aside < room ? height - contact.radius + std::sqrt(room - aside) : kNotCovered;
}

} // namespace

void BallPress::adapt(const SpringNet& net)
{
  m_hold = holdOfNodes(net);
  m_firmHold = holdOfNodes(net, kPointRate);
}

void BallPress::collect(const Eigen::Matrix3Xd& position, std::span<const Index> covered)
{
  m_pressed.clear();
  const auto add = [&](Index node, double rise, const NodeHold& hold, double share) {
    m_pressed.push_back({node, rise, share * hold.stiffness, share * hold.viscosity});
  };
  for (int k = 0; k < 3; ++k) {
    const Index node = m_contact.corner[static_cast<std::size_t>(k)];
    const double weight = m_contact.weight[k], rise = riseOver(position.col(node), m_contact);
    const NodeHold &hold = m_hold[static_cast<std::size_t>(node)],
                   &firm = m_firmHold[static_cast<std::size_t>(node)];
    if (!m_holds && hold.stiffness * (m_depth + rise) > firm.stiffness * weight * m_depth)
      add(node, rise, hold, 1.0);
    else if (weight > 0.0)
      add(node, 0.0, firm, weight);
  }
  for (const Index node : covered) {
    if (std::find(m_contact.corner.begin(), m_contact.corner.end(), node) != m_contact.corner.end()) continue;
    const double rise = riseOver(position.col(node), m_contact);
    if (m_holds ? std::isfinite(rise) : m_depth + rise > 0.0)
      add(node, rise, m_hold[static_cast<std::size_t>(node)], 1.0);
  }
  std::sort(m_pressed.begin(), m_pressed.end(),
            [](const Pressed& a, const Pressed& b) { return a.node < b.node; });
}

double BallPress::way(const Pressed& node, double depth) const noexcept
{
  return m_holds ? depth + node.rise : std::max(0.0, depth + node.rise);
}

double BallPress::push(double depth) const noexcept
{
  double sum = 0.0;
  for (const Pressed& node : m_pressed) sum += node.stiffness * way(node, depth);
  return sum;
}

void BallPress::press(const Eigen::Matrix3Xd& position, const BallContact& contact,
                      std::span<const Index> covered, bool holds, double maxForce)
{
  m_contact = contact;
  m_holds = holds;
  m_depth = m_drawn = -contact.normal.dot(contact.pull);
  collect(position, covered);
  m_stiffness = m_viscosity = 0.0;
  for (const Pressed& node : m_pressed) {
    m_stiffness += node.stiffness;
    m_viscosity += node.viscosity;
  }
  if (const double more = kLeastStiffness - m_stiffness; more > 0.0) { // the same for each, on loose tissue
    for (Pressed& node : m_pressed) node.stiffness += more / static_cast<double>(m_pressed.size());
    m_stiffness = kLeastStiffness;
  }
  m_point.node.clear();
  m_point.weight.clear();
  for (const Pressed& node : m_pressed) {
    m_point.node.push_back(node.node);
    m_point.weight.push_back(node.stiffness / m_stiffness);
  }
  const double mean = push(m_depth) / m_stiffness;
  m_apart =
    m_depth > 0.0 ? Eigen::Vector3d(mean / m_depth * contact.pull) : Eigen::Vector3d(-mean * contact.normal);
  const LimitedPull limited = limitedPull(m_apart, m_stiffness, maxForce);
  m_softness = limited.softness;
  m_shrink = 1.0;
  if (!limited.isLimited) return;
  const double wanted = limited.offset.norm() / m_apart.norm() * std::abs(mean) * m_stiffness;
  if (m_depth > 0.0 && !holds)
    drawBack(wanted);
  else
    m_shrink = wanted / std::abs(push(m_depth));
}

/// To where it pushes with what is wanted, no less; nothing is pushed where all of the ball is above the surface.
void BallPress::drawBack(double wanted)
{
  double low = 0.0, high = m_depth;
  for (const Pressed& node : m_pressed) low = std::min(low, -node.rise);
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = 0.5 * (low + high);
    (push(middle) > wanted ? high : low) = middle;
  }
  m_drawn = low;
}

ToolSpring BallPress::spring(const Pressed& node, const NetState& state,
                             const Eigen::Vector3d& velocity) const
{
  const Eigen::Vector3d &normal = m_contact.normal, &pull = m_contact.pull;
  // The direction of the whole pull is each node's, so that friction's cone holds for the sum.
  const double down = m_shrink * way(node, m_drawn), drag = m_depth > 0.0 ? down / m_depth : 0.0;
  const Eigen::Vector3d own = state.velocity.col(node.node);
  return {node.node, state.position.col(node.node) - down * normal + drag * (pull + m_depth * normal),
          // Along the surface the damper moves with it: drag is friction's.
          own + normal.dot(velocity - own) * normal, m_softness * node.stiffness,
          m_softness * node.viscosity};
}

std::span<const ToolSpring> BallPress::springs(const NetState& state, const Eigen::Vector3d& velocity)
{
  m_springs.clear();
  for (const Pressed& node : m_pressed) m_springs.push_back(spring(node, state, velocity));
  return m_springs;
}

Eigen::Vector3d BallPress::forceOnHand(const NetState& state, const Eigen::Vector3d& velocity) const
{
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
  for (const Pressed& node : m_pressed) {
    const ToolSpring tool = spring(node, state, velocity);
    force += tool.stiffness * (state.position.col(node.node) - tool.target) +
             tool.viscosity * (state.velocity.col(node.node) - tool.targetVelocity);
  }
  return force;
}

} // namespace esm
