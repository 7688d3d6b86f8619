// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/runtime/tool_grip.h"

#include "core/runtime/limited_pull.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

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

double stiffnessAround(const SpringNet& net, Index node)
{
  double own = 0.0;
  for (Index s = 0; s < net.springCount(); ++s)
    if (net.ends(0, s) == node || net.ends(1, s) == node) own += net.stiffness[s];
  for (Index a = 0; a < net.anchors.count(); ++a)
    if (net.anchors.node[static_cast<std::size_t>(a)] == node) own += net.anchors.stiffness[a];
  return own;
}

double toolStiffness(double own)
{
  return std::max(kStiffnessRatio * own, kLeastStiffness);
}

double toolViscosity(double stiffness, double mass)
{
  return 2.0 * kDampingRatio * std::sqrt(stiffness * mass);
}

ToolGrip::ToolGrip(const SpringNet& net, Index node, const Eigen::Vector3d& target, double maxForce)
  : m_node(node),
    m_target(isFinite(target) ? target : Eigen::Vector3d(net.restPosition.col(node))),
    m_maxForce(std::isfinite(maxForce) ? std::max(maxForce, kLeastForceLimit) : kLeastForceLimit)
{
  adapt(net);
}

void ToolGrip::adapt(const SpringNet& net)
{
  m_stiffness = toolStiffness(stiffnessAround(net, m_node));
  m_viscosity = toolViscosity(m_stiffness, net.mass[m_node]);
}

void ToolGrip::moveTo(const Eigen::Vector3d& target, const Eigen::Vector3d& velocity)
{
  if (!isFinite(target) || !isFinite(velocity)) return;
  m_target = target;
  m_targetVelocity = velocity;
}

ToolSpring ToolGrip::spring(const NetState& state) const
{
  const Eigen::Vector3d node = state.position.col(m_node);
  const LimitedPull pull = limitedPull(m_target - node, m_stiffness, m_maxForce);
  // In reach the spring ends at the target itself, to the last bit.
  return {m_node, pull.isLimited ? Eigen::Vector3d(node + pull.offset) : m_target, m_targetVelocity,
          pull.softness * m_stiffness, pull.softness * m_viscosity};
}

Eigen::Vector3d ToolGrip::forceOnHand(const NetState& state) const
{
  const ToolSpring tool = spring(state);
  const Eigen::Vector3d force = tool.stiffness * (state.position.col(m_node) - tool.target) +
                                tool.viscosity * (state.velocity.col(m_node) - m_targetVelocity);
  return limitedForce(force, m_maxForce);
}

ContactModel ToolGrip::contactModel(const NetState& state, const Eigen::Matrix3d& compliance) const
{
  const Eigen::Vector3d apart = m_target - state.position.col(m_node);
  ContactModel model;
  model.time = state.time;
  model.active = true;
  model.position = m_target;
  model.stiffness = inSeries(pullStiffness(apart, m_stiffness, m_maxForce), compliance);
  model.viscosity = m_viscosity / m_stiffness * model.stiffness;
  // The servo adds -viscosity * (velocity of the hand) itself.
  model.force = forceOnHand(state) + model.viscosity * m_targetVelocity;
  return model;
}

} // namespace esm
