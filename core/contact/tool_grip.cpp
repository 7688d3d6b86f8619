// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/contact/tool_grip.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

/// Of the pad to the net [1]: at 4 the middle stays 8 % behind a hand that has pulled 10 mm, at 8 it is 3 %.
constexpr double kPadRatio = 8.0;
constexpr double kMostRatio = 2.0;        ///< of a node's spring to what holds it in the net [1]
constexpr double kPadDamping = 0.5;       ///< of a node's mass on its spring, at least [1]
constexpr double kLeastGrip = 20.0;       ///< [N/m]: 5 cm of mouse way pull with 1 N even on loose nodes
constexpr double kLeastForceLimit = 1e-6; ///< [N]
constexpr double kSameForce = 0.02;       ///< of the limit: as much may a pull at the limit be off [1]

} // namespace

Eigen::Matrix3d inSeries(const Eigen::Matrix3d& tool, const Eigen::Matrix3d& compliance)
{
  const Eigen::Matrix3d product =
    tool * (Eigen::Matrix3d::Identity() + compliance * tool).partialPivLu().inverse();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen;
  eigen.computeDirect(0.5 * (product + product.transpose()));
  return eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0.0).asDiagonal() *
         eigen.eigenvectors().transpose();
}

ToolGrip::ToolGrip(const SpringNet& net, const Eigen::Matrix3Xd& position, Index node, double radius,
                   const Eigen::Vector3d& target, double maxForce)
  : m_node(node),
    m_target(target.allFinite() ? target : Eigen::Vector3d(position.col(node))),
    m_radius(std::isfinite(radius) ? std::max(radius, 0.0) : 0.0),
    m_maxForce(std::isfinite(maxForce) ? std::max(maxForce, kLeastForceLimit) : kLeastForceLimit),
    m_holds(net)
{
  std::vector<PatchNode> patch;
  PatchFinder(net).find(position, node, m_radius, patch);
  for (const PatchNode& found : patch)
    if (found.node == node || !net.fixed[static_cast<std::size_t>(found.node)])
      m_held.push_back({found.node, found.share, found.area, position.col(found.node) - position.col(node)});
  takeHold(net);
}

void ToolGrip::adapt(const SpringNet& net)
{
  m_holds = NodeHolds(net);
  takeHold(net);
}

void ToolGrip::adapt(const SpringNet& net, std::span<const Index> nodes, NodeLinks& links)
{
  m_holds.adapt(net, nodes, links);
  takeHold(net);
}

void ToolGrip::takeHold(const SpringNet& net)
{
  double cells = 0.0, mean = 0.0;
  for (const Held& held : m_held) {
    cells += held.share * held.area;
    mean += held.share * held.area * m_holds.at(held.node).stiffness;
  }
  mean /= cells;
  m_stiffness = m_viscosity = 0.0;
  for (Held& held : m_held) {
    const double pad = kPadRatio * mean * held.area, most = kMostRatio * m_holds.at(held.node).stiffness;
    held.stiffness = held.share * (pad < most * m_radius * m_radius ? pad / (m_radius * m_radius) : most);
    m_stiffness += held.stiffness;
  }
  const double more = std::max(0.0, kLeastGrip - m_stiffness) / cells;
  m_stiffness = 0.0;
  m_point.node.clear();
  m_point.weight.clear();
  for (Held& held : m_held) {
    held.stiffness += more * held.share * held.area;
    // As damped as the node's own springs are: methods that know dampers slow the fast modes by them.
    const NodeHold& own = m_holds.at(held.node);
    const double relaxation = own.stiffness > 0.0 ? own.viscosity / own.stiffness : 0.0;
    held.viscosity = std::max(relaxation * held.stiffness,
                              2.0 * kPadDamping * std::sqrt(held.stiffness * net.mass[held.node]));
    m_stiffness += held.stiffness;
    m_viscosity += held.viscosity;
  }
  for (const Held& held : m_held) {
    m_point.node.push_back(held.node);
    m_point.weight.push_back(held.stiffness / m_stiffness);
  }
  m_springs.clear();
}

void ToolGrip::moveTo(const Eigen::Vector3d& target, const Eigen::Vector3d& velocity)
{
  if (!target.allFinite() || !velocity.allFinite()) return;
  m_target = target;
  m_targetVelocity = velocity;
  m_leadTime = 0.0;
}

void ToolGrip::leadTo(const Eigen::Vector3d& target, double time)
{
  if (!target.allFinite()) return moveTo(m_target, Eigen::Vector3d::Zero());
  moveTo(m_target, (target - m_target) / time);
  m_goal = target;
  m_leadTime = time;
}

void ToolGrip::endLead(double time)
{
  if (m_leadTime == 0.0) return;
  const bool isWhole = time >= m_leadTime * (1.0 - 1e-9);
  m_target = isWhole ? m_goal : Eigen::Vector3d(m_target + time * m_targetVelocity);
  m_leadTime = 0.0;
}

Eigen::Vector3d ToolGrip::apart(const Held& held, const NetState& state) const
{
  return m_target + held.offset - state.position.col(held.node);
}

ToolGrip::Lead ToolGrip::lead(const NetState& state) const
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Held& held : m_held) sum += held.stiffness * apart(held, state);
  const Eigen::Vector3d mean = sum / m_stiffness;
  Lead lead{mean, limitedPull(mean, m_stiffness, m_maxForce)};
  double shaping = 0.0; // forces that add up to nothing on the hand [N]
  for (const Held& held : m_held) shaping += held.stiffness * (apart(held, state) - mean).norm();
  shaping *= lead.pull.softness;
  if (shaping > m_maxForce) lead.bond = m_maxForce / shaping;
  return lead;
}

ToolSpring ToolGrip::spring(const Held& held, const Lead& lead, const NetState& state) const
{
  // In reach the spring ends at the target itself, to the last bit: a hand at rest is none that moves.
  Eigen::Vector3d end = m_target + held.offset;
  if (lead.isLimited())
    end = state.position.col(held.node) + lead.pull.offset + lead.bond * (apart(held, state) - lead.apart);
  return {held.node, end, m_targetVelocity, lead.pull.softness * held.stiffness,
          lead.pull.softness * held.viscosity};
}

std::span<const ToolSpring> ToolGrip::springs(const NetState& state)
{
  const Lead led = lead(state);
  if (!led.isLimited() || !pullsAlike(led, state)) {
    m_springs.clear();
    for (const Held& held : m_held) m_springs.push_back(spring(held, led, state));
  }
  for (ToolSpring& spring : m_springs) {
    spring.targetVelocity = m_targetVelocity;
    spring.moves = m_leadTime > 0.0 && !led.isLimited(); // at the limit the pull stays what it is
  }
  return m_springs;
}

/// Whether the last springs still pull as those of now would, and with no more than the limit: ends that follow
/// the tissue's every creep would never let it come to rest.
bool ToolGrip::pullsAlike(const Lead& led, const NetState& state) const
{
  if (m_springs.empty()) return false;
  double off = 0.0;
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < m_held.size(); ++i) {
    const ToolSpring &last = m_springs[i], now = spring(m_held[i], led, state);
    if (last.stiffness != now.stiffness) return false;
    off += now.stiffness * (last.target - now.target).norm();
    force += last.stiffness * (last.target - state.position.col(last.node));
  }
  return off <= kSameForce * m_maxForce && force.norm() <= m_maxForce;
}

Eigen::Vector3d ToolGrip::forceOnHand(const NetState& state) const
{
  const Lead led = lead(state);
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
  for (const Held& held : m_held) {
    const ToolSpring tool = spring(held, led, state);
    force += tool.stiffness * (state.position.col(held.node) - tool.target) +
             tool.viscosity * (state.velocity.col(held.node) - m_targetVelocity);
  }
  return limitedForce(force, m_maxForce);
}

ContactModel ToolGrip::contactModel(const NetState& state, const Eigen::Matrix3d& compliance) const
{
  ContactModel model;
  model.time = state.time;
  model.active = true;
  model.position = m_target;
  model.stiffness = inSeries(pullStiffness(lead(state).apart, m_stiffness, m_maxForce), compliance);
  model.viscosity = m_viscosity / m_stiffness * model.stiffness;
  // The servo adds -viscosity * (velocity of the hand) itself.
  model.force = forceOnHand(state) + model.viscosity * m_targetVelocity;
  return model;
}

} // namespace esm
