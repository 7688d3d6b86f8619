// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/runtime/tool_grip.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

constexpr double kStiffnessRatio = 3.0;   ///< tool spring over the node's own springs [1]
constexpr double kLeastStiffness = 20.0;  ///< [N/m]: 5 cm of mouse way pull with 1 N even on a loose node
constexpr double kDampingRatio = 0.5;     ///< of the node's mass on the tool spring [1]
constexpr double kLeastForceLimit = 1e-6; ///< [N]

bool isFinite(const Eigen::Vector3d& v)
{
  return v.allFinite();
}

/// Stiffness of two springs one behind the other: A (A + B)^-1 B. Both symmetric positive semidefinite, and
/// so is the result; directions in which both are slack stay slack.
Eigen::Matrix3d inSeries(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b)
{
  const double tiny = 1e-12 * (a.trace() + b.trace()) + 1e-30;
  const Eigen::Matrix3d sum = a + b + tiny * Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d product = a * sum.ldlt().solve(b);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(0.5 * (product + product.transpose()));
  return eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0.0).asDiagonal() *
         eigen.eigenvectors().transpose();
}

} // namespace

ToolGrip::ToolGrip(const SpringNet& net, Index node, const Eigen::Vector3d& target, double maxForce)
  : m_node(node),
    m_target(isFinite(target) ? target : Eigen::Vector3d(net.restPosition.col(node))),
    m_maxForce(std::isfinite(maxForce) ? std::max(maxForce, kLeastForceLimit) : kLeastForceLimit)
{
  adapt(net);
}

void ToolGrip::adapt(const SpringNet& net)
{
  m_springs = {};
  m_springs.tables = net.tables;
  m_anchors.clear();
  double own = 0.0;
  for (Index s = 0; s < net.springCount(); ++s) {
    if (net.ends(0, s) != m_node && net.ends(1, s) != m_node) continue;
    m_springs.spring.push_back(s);
    m_springs.restLength.push_back(net.restLength[s]);
    m_springs.stiffness.push_back(net.stiffness[s]);
    m_springs.parameter.push_back(net.lawParameter[s]);
    own += net.stiffness[s];
  }
  for (Index a = 0; a < net.anchors.count(); ++a) {
    if (net.anchors.node[static_cast<std::size_t>(a)] != m_node) continue;
    m_anchors.push_back(a);
    own += net.anchors.stiffness[a];
  }
  m_held = net.fixed[static_cast<std::size_t>(m_node)] != 0;
  m_stiffness = std::max(kStiffnessRatio * own, kLeastStiffness);
  m_viscosity = 2.0 * kDampingRatio * std::sqrt(m_stiffness * net.mass[m_node]);
}

void ToolGrip::moveTo(const Eigen::Vector3d& target, const Eigen::Vector3d& velocity)
{
  if (!isFinite(target) || !isFinite(velocity)) return;
  m_target = target;
  m_targetVelocity = velocity;
}

bool ToolGrip::isFar(const Eigen::Vector3d& nodePosition) const
{
  return m_stiffness * (m_target - nodePosition).norm() > m_maxForce;
}

ToolSpring ToolGrip::spring(const NetState& state) const
{
  const Eigen::Vector3d node = state.position.col(m_node);
  if (!isFar(node)) return {m_node, m_target, m_targetVelocity, m_stiffness, m_viscosity};
  const Eigen::Vector3d apart = m_target - node;
  const double distance = apart.norm();
  const double octaves = std::floor(std::log2(m_stiffness * distance / m_maxForce));
  const double soft = std::exp2(-octaves);
  const double reach = m_maxForce / (soft * m_stiffness);
  return {m_node, node + reach / distance * apart, m_targetVelocity, soft * m_stiffness, soft * m_viscosity};
}

Eigen::Vector3d ToolGrip::forceOnHand(const NetState& state) const
{
  const ToolSpring tool = spring(state);
  const Eigen::Vector3d force = tool.stiffness * (state.position.col(m_node) - tool.target) +
                                tool.viscosity * (state.velocity.col(m_node) - m_targetVelocity);
  const double norm = force.norm();
  return norm > m_maxForce ? Eigen::Vector3d(force * (m_maxForce / norm)) : force;
}

Eigen::Matrix3d ToolGrip::nodeStiffness(const SpringNet& net, const Eigen::Matrix3Xd& position) const
{
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < m_springs.spring.size(); ++i) {
    const Index s = m_springs.spring[i];
    const auto place = static_cast<std::size_t>(s);
    const Eigen::Vector3d along = position.col(net.ends(1, s)) - position.col(net.ends(0, s));
    const double length = along.norm();
    const double extension = length - net.restLength[s];
    if (length < kMinSpringLength || (net.tensionOnly[place] != 0 && extension <= 0.0)) continue;
    const SpringResponse response = springLawKernel(net.law[place]).respond(m_springs, i, extension);
    const Eigen::Matrix3d axial = along * along.transpose() / (length * length);
    sum += std::max(response.tangent, 0.0) * axial;
    sum += std::max(response.tension, 0.0) / length * (Eigen::Matrix3d::Identity() - axial);
  }
  for (const Index a : m_anchors) sum.diagonal().array() += net.anchors.stiffness[a];
  return sum;
}

ContactModel ToolGrip::contactModel(const SpringNet& net, const NetState& state) const
{
  const Eigen::Vector3d node = state.position.col(m_node);
  Eigen::Matrix3d tool = m_stiffness * Eigen::Matrix3d::Identity();
  if (isFar(node)) { // the pull keeps its size whatever the distance, and follows the hand's direction
    const Eigen::Vector3d direction = (m_target - node).normalized();
    tool = m_maxForce / (m_target - node).norm() *
           (Eigen::Matrix3d::Identity() - direction * direction.transpose());
  }

  ContactModel model;
  model.time = state.time;
  model.active = true;
  model.position = m_target;
  model.stiffness = m_held ? tool : inSeries(tool, nodeStiffness(net, state.position));
  model.viscosity = spring(state).viscosity * Eigen::Matrix3d::Identity();
  // The servo adds -viscosity * (velocity of the hand) itself.
  model.force = forceOnHand(state) + model.viscosity * m_targetVelocity;
  return model;
}

} // namespace esm
