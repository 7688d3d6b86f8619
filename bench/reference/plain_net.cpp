// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "bench/reference/plain_net.h"

#include <algorithm>
#include <cmath>

namespace esm::bench {

PlainNet::PlainNet(const SpringNet& net, const Loads& loads) : m_loads(loads)
{
  m_nodes.resize(static_cast<std::size_t>(net.nodeCount()));
  for (Index i = 0; i < net.nodeCount(); ++i) {
    Node& node = m_nodes[static_cast<std::size_t>(i)];
    node.start = node.x = net.restPosition.col(i);
    node.v.setZero();
    if (net.initialVelocity.cols() > 0) node.v = net.initialVelocity.col(i);
    node.mass = net.mass[i];
    if (net.massDamping.size() > 0) node.drag = net.massDamping[i] * net.mass[i];
    node.fixed = net.fixed[static_cast<std::size_t>(i)] != 0;
    if (node.fixed) node.v.setZero();
  }
  for (std::size_t m = 0; m < loads.motions.size(); ++m)
    for (const Index node : loads.motions[m].nodes)
      m_nodes[static_cast<std::size_t>(node)].motion = static_cast<int>(m);
  for (Index s = 0; s < net.springCount(); ++s)
    m_springs.push_back({net.ends(0, s), net.ends(1, s), net.stiffness[s], net.viscosity[s],
                         net.restLength[s], net.lawParameter[s], net.law[static_cast<std::size_t>(s)],
                         net.tensionOnly[static_cast<std::size_t>(s)] != 0});
  for (Index i = 0; i < net.anchors.count(); ++i)
    m_anchors.push_back({net.anchors.node[static_cast<std::size_t>(i)], net.anchors.point.col(i),
                         net.anchors.stiffness[i], net.anchors.viscosity[i]});
  place(0.0, 0.0);
}

bool PlainNet::held(const Node& node, double t) const
{
  if (node.fixed || node.motion < 0) return node.fixed;
  const PrescribedMotion& motion = m_loads.motions[static_cast<std::size_t>(node.motion)];
  return !motion.release || t < *motion.release - 1e-9;
}

/// Held nodes to their place at t; who is held is asked at `holdTime`, within the step.
void PlainNet::place(double t, double holdTime)
{
  for (Node& node : m_nodes) {
    if (node.motion < 0 || !held(node, holdTime)) continue;
    const VectorCurve& curve = m_loads.motions[static_cast<std::size_t>(node.motion)].displacement;
    node.x = node.start + curve.at(t);
    node.v = curve.slopeAt(holdTime);
  }
}

void PlainNet::computeForces(double t)
{
  for (Node& node : m_nodes) node.force = node.mass * m_loads.gravity - node.drag * node.v;
  for (const NodalForce& load : m_loads.forces)
    for (const Index node : load.nodes) m_nodes[static_cast<std::size_t>(node)].force += load.force.at(t);
  for (const Anchor& anchor : m_anchors) {
    Node& node = m_nodes[static_cast<std::size_t>(anchor.node)];
    node.force -= anchor.k * (node.x - anchor.point) + anchor.c * node.v;
  }
  for (const Spring& spring : m_springs) {
    Node& a = m_nodes[static_cast<std::size_t>(spring.a)];
    Node& b = m_nodes[static_cast<std::size_t>(spring.b)];
    const Eigen::Vector3d d = b.x - a.x;
    const double length = d.norm();
    if (length == 0.0) continue;
    const double e = length - spring.length;
    if (spring.tensionOnly && e <= 0.0) continue;
    double tension = spring.k * e;
    if (spring.law == SpringLaw::Cubic) tension *= 1.0 + spring.parameter * std::pow(e / spring.length, 2);
    if (spring.law == SpringLaw::Exponential && spring.parameter != 0.0)
      tension =
        spring.k * spring.length / spring.parameter * (std::exp(spring.parameter * e / spring.length) - 1.0);
    tension += spring.c * (b.v - a.v).dot(d) / length;
    a.force += tension / length * d;
    b.force -= tension / length * d;
  }
}

void PlainNet::stepSymplecticEuler(double h)
{
  computeForces(m_time);
  for (Node& node : m_nodes) {
    if (node.fixed) continue;
    if (!held(node, m_time)) node.v += h / node.mass * node.force;
    node.x += h * node.v;
  }
  const double before = m_time;
  m_time = static_cast<double>(++m_steps) * h;
  place(m_time, before);
}

void PlainNet::stepRungeKutta4(double h)
{
  const double t = m_time;
  std::vector<Node> start = m_nodes, sum = m_nodes;
  const double reach[4] = {0.0, 0.5 * h, 0.5 * h, h}, weight[4] = {h / 6, h / 3, h / 3, h / 6};
  for (int stage = 0; stage < 4; ++stage) {
    place(t + reach[stage], t);
    computeForces(t + reach[stage]);
    for (std::size_t i = 0; i < m_nodes.size(); ++i) {
      Node& node = m_nodes[i];
      if (held(node, t)) continue;
      const Eigen::Vector3d a = node.force / node.mass, v = node.v;
      sum[i].x += weight[stage] * v;
      sum[i].v += weight[stage] * a;
      if (stage == 3) continue;
      node.x = start[i].x + reach[stage + 1] * v;
      node.v = start[i].v + reach[stage + 1] * a;
    }
  }
  m_nodes = sum;
  m_time = static_cast<double>(++m_steps) * h;
  place(m_time, t);
}

void PlainNet::positions(Eigen::Matrix3Xd& x) const
{
  x.resize(3, static_cast<Eigen::Index>(m_nodes.size()));
  for (std::size_t i = 0; i < m_nodes.size(); ++i) x.col(static_cast<Eigen::Index>(i)) = m_nodes[i].x;
}

} // namespace esm::bench
