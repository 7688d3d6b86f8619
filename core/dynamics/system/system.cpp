// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/system/system.h"

#include "core/base/assert.h"
#include "core/forces/spring_pass.h"

namespace esm {

System::System(const SpringNet& net, const Loads& loads) : m_schedule(loads, net.restPosition, net.fixed)
{
  setParameters(net, loads.gravity);
}

void System::setParameters(const SpringNet& net, const Eigen::Vector3d& gravity)
{
  m_forces = ForceModel(net, gravity);
  m_mass.assign(net.mass.begin(), net.mass.end());
  m_totalMass = net.mass.sum();
  m_fixed = net.fixed;
  m_inverseMass.resize(m_mass.size());
  for (std::size_t i = 0; i < m_mass.size(); ++i) m_inverseMass[i] = m_fixed[i] ? 0.0 : 1.0 / m_mass[i];
  updateConstraints();
}

std::int64_t System::setParameters(const ParameterPatch& patch, const SpringNet& net,
                                   const Eigen::Vector3d& gravity)
{
  const std::int64_t looked = m_forces.setParameters(patch, net, gravity);
  if (patch.nodes.empty()) return looked;
  for (const ParameterPatch::Node& node : patch.nodes) {
    const auto i = static_cast<std::size_t>(node.node);
    m_mass[i] = node.mass;
    m_inverseMass[i] = m_fixed[i] ? 0.0 : 1.0 / node.mass;
  }
  m_totalMass = net.mass.sum();
  updateConstraints();
  return looked;
}

bool System::updateConstraints() noexcept
{
  bool changed = false;
  for (const LoadSchedule::PrescribedNode& node : m_schedule.prescribedNodes()) {
    const auto i = static_cast<std::size_t>(node.node);
    const double inverse = m_schedule.isActive(node) ? 0.0 : 1.0 / m_mass[i];
    changed = changed || inverse != m_inverseMass[i];
    m_inverseMass[i] = inverse;
  }
  return changed;
}

double System::setTools(std::span<const ToolSpring> tools, const NodeArray& x, double time)
{
  const double before = toolEnergy(x);
  m_tools.assign(tools.begin(), tools.end());
  m_toolsSetAt = time;
  return toolEnergy(x) - before;
}

bool System::enter(MotionState& state, bool silent)
{
  const bool counts = !silent && m_schedule.anyMotion();
  // Of moved nodes alone: beside what the others have their difference would be lost in rounding.
  const auto kinetic = [&] {
    double energy = 0.0;
    for (const LoadSchedule::PrescribedNode& node : m_schedule.prescribedNodes()) {
      const auto i = static_cast<std::size_t>(node.node);
      energy += 0.5 * m_mass[i] * dot(state.v[i], state.v[i]);
    }
    return energy;
  };
  const double kineticBefore = counts ? kinetic() : 0.0, storedBefore = counts ? storedEnergy(state.x) : 0.0;
  m_schedule.enter(state.time);
  place(state.time, state.x, state.v);
  const bool changed = updateConstraints();
  // A corner of a motion is a blow, a jump is a stretch in no time: the support does both.
  if (counts) state.work += (kinetic() - kineticBefore) + (storedEnergy(state.x) - storedBefore);
  return changed;
}

Rates System::evaluate(double t, NodeArray& x, NodeArray& v, NodeArray& force, Lanes* damper,
                       const NodeSweep& before, const Lateness& late) noexcept
{
  const bool placesFirst = m_schedule.movesAnyNow(); // then the springs wait for these places
  if (placesFirst && before) sweepNodes(before);
  place(t, x, v);
  Rates rates;
  rates.heat = m_forces.computeForces(x.data(), v.data(), force.data(), damper, m_workers,
                                      placesFirst ? NodeSweep{} : before, late);
  springsEvaluated += m_forces.activeSprings();
  if (m_frame != nullptr) advanceNodes(force.size(), 1.0, force.data(), m_frame, force.data());
  rates.work = addLoads(t, v, force);
  for (std::size_t i = 0; i < m_tools.size(); ++i) {
    const ToolSpring& tool = m_tools[i];
    const auto node = static_cast<std::size_t>(tool.node);
    const Eigen::Vector3d slip = tool.targetVelocity - toVector(v[node]);
    force[node] += toLanes(toolForce(i, x, v));
    rates.heat += tool.viscosity * slip.squaredNorm();
    rates.work += tool.viscosity * slip.dot(tool.targetVelocity);
  }
  rates.loads = rates.work;
  for (const LoadSchedule::PrescribedNode& node : m_schedule.prescribedNodes())
    if (m_schedule.isActive(node)) {
      const auto i = static_cast<std::size_t>(node.node);
      rates.work -= dot(force[i], v[i]);
    }
  return rates;
}

double System::addLoads(double t, const NodeArray& v, NodeArray& force) const noexcept
{
  double power = m_schedule.addForces(t, v.data(), force.data());
  for (const ToolSpring& tool : m_tools) {
    if (!tool.isLed()) continue;
    const auto node = static_cast<std::size_t>(tool.node);
    const Lanes lead = toLanes(leadOf(tool, t));
    force[node] += lead;
    power += dot(lead, v[node]);
  }
  return power;
}

ESM_CPU_CLONES void advanceNodes(std::size_t count, double s, const Lanes* from, const Lanes* rate,
                                 Lanes* to) noexcept
{
  for (std::size_t i = 0; i < count; ++i) to[i] = from[i] + rate[i] * s;
}

ESM_CPU_CLONES void slopesTo(std::size_t count, double rate, const double* inverseMass, const Lanes* from,
                             const Lanes* to, Lanes* slope) noexcept
{
  const Lanes zero = {0, 0, 0, 0};
  for (std::size_t i = 0; i < count; ++i) slope[i] = inverseMass[i] > 0.0 ? (to[i] - from[i]) * rate : zero;
}

ESM_CPU_CLONES void scaleNodes(std::size_t count, const double* factor, const Lanes* from, Lanes* to) noexcept
{
  for (std::size_t i = 0; i < count; ++i) to[i] = from[i] * factor[i];
}

ESM_CPU_CLONES double sumOfSquares(const NodeArray& a) noexcept
{
  const auto take = [values = a.data()](std::size_t i, Lanes& to) noexcept { to += values[i] * values[i]; };
  Lanes sum;
  sumOver(a.size(), take, sum);
  return sumLanes(sum);
}

ESM_CPU_CLONES double sumOfSquares(const NodeArray& a, const NodeArray& b) noexcept
{
  const auto take = [from = a.data(), to = b.data()](std::size_t i, Lanes& sum) noexcept {
    const Lanes d = from[i] - to[i];
    sum += d * d;
  };
  Lanes sum;
  sumOver(a.size(), take, sum);
  return sumLanes(sum);
}

double sumOfProducts(const NodeArray& a, const NodeArray& b) noexcept
{
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += dot(a[i], b[i]);
  return sum;
}

ESM_CPU_CLONES double takeOff(std::size_t count, double factor, const Lanes* x, Lanes* y,
                              const Lanes* z) noexcept
{
  const auto take = [=](std::size_t i, Lanes& to) noexcept {
    y[i] -= x[i] * factor;
    to += y[i] * z[i];
  };
  Lanes sum;
  sumOver(count, take, sum);
  return sumLanes(sum);
}

void System::toAccelerations(NodeArray& force) const noexcept
{
  sweepNodes([&](std::size_t first, std::size_t count) noexcept {
    scaleNodes(count, m_inverseMass.data() + first, force.data() + first, force.data() + first);
  });
}

double System::loadPower(double t, const NodeArray& v) const noexcept
{
  double power = m_schedule.power(t, v.data());
  for (const ToolSpring& tool : m_tools) {
    const Eigen::Vector3d velocity = toVector(v[static_cast<std::size_t>(tool.node)]);
    power += tool.viscosity * (tool.targetVelocity - velocity).dot(tool.targetVelocity);
    if (tool.isLed()) power += leadOf(tool, t).dot(velocity);
  }
  return power;
}

void System::addDamping(const Lanes* damper, const NodeArray& v, NodeArray& force,
                        const NodeSweep& before) noexcept
{
  m_forces.addDamping(damper, v.data(), force.data(), m_workers, before);
  springsEvaluated += (m_forces.activeSprings() + 1) / 2; // half the cost of evaluate()
  for (const ToolSpring& tool : m_tools) {
    const auto node = static_cast<std::size_t>(tool.node);
    force[node] -= v[node] * tool.viscosity;
  }
}

double System::kineticEnergy(const NodeArray& v) const noexcept
{
  double energy = 0.0;
  for (std::size_t i = 0; i < v.size(); ++i) energy += 0.5 * m_mass[i] * dot(v[i], v[i]);
  return energy;
}

double System::toolEnergy(const NodeArray& x) const noexcept
{
  double energy = 0.0;
  for (const ToolSpring& tool : m_tools)
    energy +=
      0.5 * tool.stiffness * (tool.target - toVector(x[static_cast<std::size_t>(tool.node)])).squaredNorm();
  return energy;
}

double System::elasticEnergy(const NodeArray& x) const noexcept
{
  return m_forces.elasticEnergy(x.data(), m_workers) + toolEnergy(x);
}

double System::weightEnergy(const NodeArray& x) const noexcept
{
  if (m_frame == nullptr) return m_forces.gravityEnergy(x.data());
  double energy = 0.0; // of what is left of the weight: both apart could hide the springs by rounding
  for (std::size_t i = 0; i < x.size(); ++i) energy -= dot(m_forces.weight(i) + m_frame[i], x[i]);
  return energy;
}

double System::storedEnergy(const NodeArray& x) const noexcept
{
  return elasticEnergy(x) + weightEnergy(x);
}

Eigen::Vector3d System::toolForce(std::size_t tool, const NodeArray& x, const NodeArray& v) const noexcept
{
  ESM_ASSERT(tool < m_tools.size());
  const ToolSpring& spring = m_tools[tool];
  const auto node = static_cast<std::size_t>(spring.node);
  return spring.stiffness * (spring.target - toVector(x[node])) +
         spring.viscosity * (spring.targetVelocity - toVector(v[node]));
}

Eigen::Vector3d System::toolForce(std::size_t tool, double t, const NodeArray& x,
                                  const NodeArray& v) const noexcept
{
  const Eigen::Vector3d force = toolForce(tool, x, v);
  return m_tools[tool].isLed() ? Eigen::Vector3d(force + leadOf(m_tools[tool], t)) : force;
}

double System::ledToolEnergy(double t, const NodeArray& x) const noexcept
{
  double energy = 0.0;
  for (const ToolSpring& tool : m_tools) {
    if (!tool.isLed()) continue;
    const Eigen::Vector3d way = (t - m_toolsSetAt) * tool.targetVelocity;
    const Eigen::Vector3d middle = tool.target + 0.5 * way - toVector(x[static_cast<std::size_t>(tool.node)]);
    energy += tool.stiffness * way.dot(middle);
  }
  return energy;
}

} // namespace esm
