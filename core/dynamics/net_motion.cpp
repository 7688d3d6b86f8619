// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/net_motion.h"

#include "core/base/assert.h"
#include "core/forces/few_springs.h"

#include <algorithm>
#include <utility>

namespace esm {
namespace {

Energies differenceOf(const Energies& a, const Energies& b) noexcept
{
  return {a.kinetic - b.kinetic, a.elastic - b.elastic, a.gravity - b.gravity};
}

} // namespace

NetMotion::NetMotion(SpringNet net, Loads loads, const SolverSettings& settings, std::vector<Index> names)
  : m_body{std::move(net), std::move(loads), {}, {}},
    m_driver(settings, m_body, std::move(names)),
    m_threads(settings.threads)
{
  reset();
}

void NetMotion::reset()
{
  const SpringNet& net = m_body.net;
  m_body.system = System(net, m_body.loads);
  engageWorkers();
  const auto count = static_cast<std::size_t>(net.nodeCount());
  MotionState& motion = m_body.motion;
  motion = MotionState{};
  motion.x.resize(count);
  motion.v.assign(count, Lanes{0, 0, 0, 0});
  copyNodes(net.restPosition, motion.x);
  if (net.initialVelocity.cols() == net.nodeCount()) copyNodes(net.initialVelocity, motion.v);
  for (std::size_t i = 0; i < count; ++i)
    if (net.fixed[i]) motion.v[i] = Lanes{0, 0, 0, 0};
  m_body.system.enter(motion, true);
  m_force.resize(count);
  m_forceIsCurrent = false;
  m_initial = storedNow();
  m_driver.begin();
}

/// Where the net is large enough.
void NetMotion::engageWorkers()
{
  const bool pays = m_threads > 1 && m_body.system.forces().isDivided();
  if (pays && !m_workers) m_workers = std::make_unique<WorkerPool>(m_threads);
  m_body.system.setWorkers(pays ? m_workers.get() : nullptr);
}

// === Motion

StepReport NetMotion::advance(double interval, const Budget& budget)
{
  if (m_growth) m_growth->remember(m_body.motion);
  const StepReport report = m_driver.advance(interval, budget);
  if (m_growth && report.good()) lookAtGrowth(report);
  m_forceIsCurrent = false;
  return report;
}

void NetMotion::watchGrowth()
{
  m_growth = std::make_unique<GrowthWatch>();
  m_growth->begin(m_body.net, m_body.loads);
}

void NetMotion::lookAtGrowth(const StepReport& report)
{
  const double springs = std::max(static_cast<double>(m_body.system.forces().activeSprings()), 1.0);
  m_growth->pay(static_cast<double>(report.springsEvaluated) / springs);
  if (m_growth->isFollowing())
    m_growth->carryOn(m_body.motion);
  else if (m_growth->lookIsDue() && m_growth->look(m_body.system, m_body.motion))
    m_growth->setMode(m_driver.fastestMode());
}

void NetMotion::publish(NetState& state, std::span<const Index> places)
{
  const MotionState& motion = m_body.motion;
  const auto take = [&](Index node) {
    const auto i = static_cast<std::size_t>(node);
    const Index place = places.empty() ? node : places[i];
    state.position.col(place) = toVector(motion.x[i]);
    state.velocity.col(place) = toVector(motion.v[i]);
  };
  const bool all = std::exchange(m_isBetween, false) || m_driver.allMoved();
  if (!all)
    for (const Index node : m_driver.moved()) take(node);
  else if (!places.empty())
    for (Index node = 0; node < m_body.net.nodeCount(); ++node) take(node);
  else {
    copyNodes(motion.x, state.position);
    copyNodes(motion.v, state.velocity);
  }
  m_driver.clearMoved();
}

void NetMotion::publishBetween(NetState& state, std::span<const Index> places, double time)
{
  const MotionState& motion = m_body.motion;
  const double length = motion.time - state.time, s = (time - state.time) / length, r = 1.0 - s;
  for (std::size_t i = 0; i < motion.x.size(); ++i) {
    const Index place = places.empty() ? static_cast<Index>(i) : places[i];
    const Eigen::Vector3d x0 = state.position.col(place), v0 = state.velocity.col(place),
                          x1 = toVector(motion.x[i]), v1 = toVector(motion.v[i]);
    state.position.col(place) = x0 + s * s * (3.0 - 2.0 * s) * (x1 - x0) + length * s * r * (r * v0 - s * v1);
    state.velocity.col(place) =
      6.0 * s * r / length * (x1 - x0) + r * (1.0 - 3.0 * s) * v0 + s * (3.0 * s - 2.0) * v1;
  }
  m_isBetween = true;
}

// === Parameters and tools

void NetMotion::setParameters(SpringNet net)
{
  m_driver.closeLoss();
  const ParameterChange change = changeBetween(m_body.net, net);
  m_body.net = std::move(net);
  const Energies before = storedNow();
  m_body.system.setParameters(m_body.net, m_body.loads.gravity);
  engageWorkers();
  for (std::size_t i = 0; i < m_body.motion.v.size(); ++i)
    if (m_body.net.fixed[i]) m_body.motion.v[i] = Lanes{0, 0, 0, 0};
  m_initial += differenceOf(storedNow(), before);
  m_driver.parametersChanged(change);
  m_forceIsCurrent = false;
}

ParameterChange NetMotion::setParameters(const ParameterPatch& patch)
{
  m_driver.closeLoss();
  ParameterChange change = changeBy(patch, m_body.net);
  const Energies before = energiesOf(patch);
  patch.applyTo(m_body.net);
  change.springsSeen += m_body.system.setParameters(patch, m_body.net, m_body.loads.gravity);
  engageWorkers();
  change.energies = differenceOf(energiesOf(patch), before);
  m_initial += change.energies;
  m_driver.parametersChanged(change);
  m_forceIsCurrent = false;
  return change;
}

void NetMotion::setTools(std::span<const ToolSpring> tools)
{
  for ([[maybe_unused]] const ToolSpring& tool : tools)
    ESM_ASSERT(tool.node >= 0 && tool.node < m_body.net.nodeCount());
  if (tools.empty() && m_body.system.tools().empty()) return; // nothing has changed
  m_formerTools = m_body.system.tools();                      // a hand moves every frame: no allocation
  // The hand stretches the tool springs.
  m_body.motion.work += m_body.system.setTools(tools, m_body.motion.x, m_body.motion.time);
  m_driver.toolsChanged(m_formerTools);
  m_formerTools.reserve(tools.size());
  m_forceIsCurrent = false;
}

// === Energies

Energies NetMotion::storedNow() const
{
  const System& system = m_body.system;
  return {system.kineticEnergy(m_body.motion.v), system.elasticEnergy(m_body.motion.x),
          system.forces().gravityEnergy(m_body.motion.x.data())};
}

/// What storedNow() and the work lack of tools that have moved since they were set.
double NetMotion::ledToolEnergy() const noexcept
{
  return m_body.system.ledToolEnergy(m_body.motion.time, m_body.motion.x);
}

/// Of what the patch names alone, with the numbers of now.
Energies NetMotion::energiesOf(const ParameterPatch& patch) const
{
  const SpringNet& net = m_body.net;
  const NodeArray& x = m_body.motion.x;
  Energies sum;
  for (const ParameterPatch::Node& node : patch.nodes) {
    const auto i = static_cast<std::size_t>(node.node);
    sum.kinetic += 0.5 * net.mass[node.node] * dot(m_body.motion.v[i], m_body.motion.v[i]);
    sum.gravity -= net.mass[node.node] * m_body.loads.gravity.dot(toVector(x[i]));
  }
  std::vector<Index> springs;
  for (const ParameterPatch::Spring& spring : patch.springs) springs.push_back(spring.spring);
  sum.elastic = FewSprings(net, springs).energy(x.data());
  const auto addAnchor = [&](Index k) {
    const auto i = static_cast<std::size_t>(net.anchors.node[static_cast<std::size_t>(k)]);
    const Eigen::Vector3d away = toVector(x[i]) - net.anchors.point.col(k);
    sum.elastic += 0.5 * net.anchors.stiffness[k] * away.squaredNorm();
  };
  if (patch.anchorSet)
    for (Index k = 0; k < net.anchors.count(); ++k) addAnchor(k);
  else
    for (const ParameterPatch::Anchor& anchor : patch.anchors) addAnchor(anchor.anchor);
  if (!patch.bulkModuli.empty()) sum.elastic += m_body.system.forces().pressure().energy(x.data());
  return sum;
}

Energies NetMotion::energies() const
{
  Energies energies = storedNow();
  energies.elastic += ledToolEnergy();
  return energies;
}

double NetMotion::externalWork() const
{
  return m_body.motion.work + ledToolEnergy();
}

EnergyReport NetMotion::energyReport()
{
  m_driver.closeLoss();
  const MotionState& motion = m_body.motion;
  return {m_initial, energies(), externalWork(), motion.heat, motion.loss, motion.restored};
}

// === Forces

Eigen::Vector3d NetMotion::reaction(Index node)
{
  const auto i = static_cast<std::size_t>(node);
  if (m_body.system.isFree(i)) return Eigen::Vector3d::Zero();
  if (!m_forceIsCurrent) {
    MotionState& motion = m_body.motion;
    const std::int64_t counted = m_body.system.springsEvaluated;
    // Prescribed nodes are in their place already.
    m_body.system.evaluate(motion.time, motion.x, motion.v, m_force);
    m_body.system.springsEvaluated = counted;
    m_forceIsCurrent = true;
  }
  return -toVector(m_force[i]);
}

Eigen::Vector3d NetMotion::toolForce(std::size_t tool) const
{
  const MotionState& motion = m_body.motion;
  return m_body.system.toolForce(tool, motion.time, motion.x, motion.v);
}

void NetMotion::springTensions(std::span<double> tension) const
{
  const System& system = m_body.system;
  system.forces().springTensions(m_body.motion.x.data(), m_body.motion.v.data(), tension.data(),
                                 system.workers());
}

void NetMotion::springTensions(std::span<const Index> springs, std::span<double> tension) const
{
  FewSprings(m_body.net, springs).tensions(m_body.motion.x.data(), m_body.motion.v.data(), tension.data());
}

} // namespace esm
