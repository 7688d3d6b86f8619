// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/support/push_test.h"

#include "core/dynamics/implicit_matrix.h"
#include "core/support/linear_net.h"
#include "core/support/outward_surface.h"
#include "core/support/poke.h"

#include <cmath>
#include <limits>

namespace esm {

namespace {

constexpr double kDeepestPush = 0.3; ///< of the way to the opposite wall
constexpr int kPushSteps = 10;
constexpr int kMostPushIterations = 25;
constexpr double kMostPushFactor = 1e7;  ///< spring evaluations, about a tenth of a second
constexpr double kPushBalanced = 1e-6;   ///< of the force
constexpr double kLongestPushMove = 0.5; ///< of the step's wished dent, RMS over nodes, in one iteration
constexpr double kPushBed = 1e-2; ///< of the patch's stiffness, over all nodes, where nothing holds the net

/// Where the surface lies opposite a node.
struct Opposite {
  Eigen::Vector3d inwards = Eigen::Vector3d::Zero(), place = Eigen::Vector3d::Zero();
  double distance = 0.0; ///< 0: nowhere
};

Opposite oppositeOf(const SpringNet& net, Index node, WorkControl* control)
{
  Opposite opposite;
  if (net.triangleCount() == 0) return opposite;
  const OutwardSurface surface(net, control);
  if (stopWanted(control)) return opposite;
  opposite.inwards = -surface.nodeNormals().col(node);
  if (!(opposite.inwards.squaredNorm() > 0.5)) return opposite;
  const auto isOwn = [&](Index t) { return (surface.triangles().col(t).array() == node).any(); };
  const RayHit hit = surface.tree().firstHit(net.restPosition.col(node), opposite.inwards, 0.0,
                                             std::numeric_limits<double>::infinity(), isOwn);
  if (hit.triangle == kNoIndex) return opposite;
  opposite.distance = hit.distance;
  opposite.place = net.restPosition.col(node) + hit.distance * opposite.inwards;
  return opposite;
}

/// The net in balance with a force that grows.
class Pushed {
public:
  Pushed(const SpringNet& net, const Eigen::Matrix3Xd& unitForce) : m_system(net, {})
  {
    const std::size_t nodes = m_system.nodeCount();
    for (NodeArray* array : {&m_x, &m_rest, &m_force, &m_unit}) array->assign(nodes, Lanes{0, 0, 0, 0});
    MotionState state;
    state.x = state.v = m_rest;
    for (std::size_t i = 0; i < nodes; ++i) {
      m_x[i] = toLanes(net.restPosition.col(static_cast<Eigen::Index>(i)));
      m_unit[i] = toLanes(unitForce.col(static_cast<Eigen::Index>(i)));
    }
    state.x = m_x;
    m_system.enter(state, true);
    m_start = m_x;
    m_matrix.prepare(m_system);
  }

  double factorCost() const { return m_matrix.factorCost(); }

  /// @return whether there is a stable balance near where the net was.
  bool balance(double force, double longest, WorkControl* control)
  {
    const ImplicitMatrix::Shares shares{1e-10 * rate(), 0.0, 1.0};
    for (int iteration = 0; iteration < kMostPushIterations && !stopWanted(control); ++iteration) {
      const double left = findForces(force);
      if (!std::isfinite(left) || !m_matrix.factor(m_system, m_x, m_rest, shares, false)) return false;
      if (left <= kPushBalanced * force) return m_matrix.negativePivots() == 0;
      m_matrix.solve(m_force);
      move(longest);
    }
    return false;
  }

  /// Of the patch, weighted as the force [m].
  double depth() const
  {
    double sum = 0.0;
    for (std::size_t i = 0; i < m_x.size(); ++i) sum += dot(m_unit[i], m_x[i] - m_start[i]);
    return sum;
  }

private:
  double rate() { return m_rate > 0.0 ? m_rate : m_rate = m_matrix.stiffestRate(m_system, m_x, m_rest); }

  /// What is out of balance into m_force. @return its norm [N]
  double findForces(double force)
  {
    m_system.forces().computeForces(m_x.data(), m_rest.data(), m_force.data());
    double sum = 0.0;
    for (std::size_t i = 0; i < m_x.size(); ++i) {
      m_force[i] = m_system.isFree(i) ? m_force[i] + m_unit[i] * force : Lanes{0, 0, 0, 0};
      sum += dot(m_force[i], m_force[i]);
    }
    return std::sqrt(sum);
  }

  void move(double longest)
  {
    double sum = 0.0;
    for (const Lanes& change : m_force) sum += dot(change, change);
    const double length = std::sqrt(sum / static_cast<double>(m_matrix.freeCount()));
    const double share = length > longest ? longest / length : 1.0;
    for (std::size_t i = 0; i < m_x.size(); ++i) m_x[i] += m_force[i] * share;
  }

  System m_system;
  NodeArray m_x, m_start, m_rest, m_force, m_unit;
  ImplicitMatrix m_matrix;
  double m_rate = 0.0;
};

/// A soft bed for what nothing holds.
void addBed(SpringNet& net, double stiffness)
{
  const Index nodes = net.nodeCount(), before = net.anchors.count();
  for (Index node = 0; node < nodes; ++node) net.anchors.node.push_back(node);
  net.anchors.point.conservativeResize(3, before + nodes);
  net.anchors.point.rightCols(nodes) = net.restPosition;
  for (Eigen::ArrayXd* array : {&net.anchors.stiffness, &net.anchors.viscosity}) {
    array->conservativeResize(before + nodes);
    array->tail(nodes).setZero();
  }
  net.anchors.stiffness.tail(nodes).setConstant(stiffness / nodes);
  if (net.anchors.bandLength.size() > 0) {
    net.anchors.bandLength.conservativeResize(before + nodes);
    net.anchors.bandLength.tail(nodes).setZero();
  }
}

} // namespace

PushTest pushUntilItSnaps(const SpringNet& net, Index node, double radius, double compliance,
                          WorkControl* control)
{
  PushTest test;
  const Opposite opposite = oppositeOf(net, node, control);
  if (!(opposite.distance > 0.0) || !(compliance > 0.0) || stopWanted(control)) return test;
  SpringNet held = net;
  Eigen::Matrix3Xd unit = pokePatch(net, net.restPosition.col(node), opposite.inwards, radius);
  const RigidMotions rigid(net, true);
  if (rigid.isLoose(rigid.partOf(node))) {
    unit += pokePatch(net, opposite.place, -opposite.inwards, radius);
    rigid.removeFromForce(unit); // else it would turn on its soft bed
    addBed(held, kPushBed / compliance);
  }
  Pushed pushed(held, unit);
  if (pushed.factorCost() > kMostPushFactor) return test;
  const double most = kDeepestPush * opposite.distance / compliance;
  const double longest = kLongestPushMove * kDeepestPush * opposite.distance / kPushSteps;
  test.isDone = true;
  test.way = opposite.distance;
  for (int step = 1; step <= kPushSteps; ++step) {
    test.snaps = !pushed.balance(most * step / kPushSteps, longest, control);
    if (stopWanted(control)) return {};
    if (test.snaps) break;
    test.force = most * step / kPushSteps;
    test.depth = pushed.depth();
  }
  return test;
}

} // namespace esm
