// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/simulation.h"

#include "core/base/assert.h"
#include "core/dynamics/growth_watch.h"
#include "core/dynamics/region_driver.h"
#include "core/forces/few_springs.h"
#include "core/net/net_builder.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <thread>
#include <utility>

namespace esm {
namespace {

Status checkSettings(const SolverSettings& settings)
{
  const auto invalid = [](std::string detail) { return Error{ErrorCode::InvalidValue, std::move(detail)}; };
  std::string names = "auto";
  bool known = settings.solver == "auto";
  for (const IntegratorEntry& entry : integratorTable()) {
    known = known || entry.name == settings.solver;
    names += ", " + std::string(entry.name);
  }
  if (!known) return invalid("there is no solver '" + settings.solver + "'; choose one of " + names);
  if (!(settings.tolerance > 0.0) || !std::isfinite(settings.tolerance))
    return invalid("the tolerance must be a positive number, such as 1e-3");
  if (!(settings.fixedStep >= 0.0) || !std::isfinite(settings.fixedStep))
    return invalid("the fixed step must be a positive time in seconds, or 0 for automatic steps");
  if (!(settings.workLimit >= 0.0) || !std::isfinite(settings.workLimit))
    return invalid("the work limit must be a positive number of force passes, or 0 for none");
  if (settings.threads < 1) return invalid("the number of threads must be at least 1");
  return {};
}

Energies differenceOf(const Energies& a, const Energies& b) noexcept
{
  return {a.kinetic - b.kinetic, a.elastic - b.elastic, a.gravity - b.gravity};
}

/// More than there are processors only wait for each other.
int usefulThreads(const SolverSettings& settings) noexcept
{
  const auto processors = static_cast<int>(std::thread::hardware_concurrency()); // 0 = unknown
  return processors > 0 ? std::min(settings.threads, processors) : settings.threads;
}

} // namespace

struct Simulation::Impl {
  Impl(SpringNet net, Loads loads, const SolverSettings& settings)
    : body{std::move(net), std::move(loads), {}, {}}, driver(settings, body), threads(usefulThreads(settings))
  {
    reset();
  }

  void reset()
  {
    const SpringNet& net = body.net;
    body.system = System(net, body.loads);
    engageWorkers();
    const auto count = static_cast<std::size_t>(net.nodeCount());
    MotionState& motion = body.motion;
    motion = MotionState{};
    motion.x.resize(count);
    motion.v.assign(count, Lanes{0, 0, 0, 0});
    copyNodes(net.restPosition, motion.x);
    if (net.initialVelocity.cols() == net.nodeCount()) copyNodes(net.initialVelocity, motion.v);
    for (std::size_t i = 0; i < count; ++i)
      if (net.fixed[i]) motion.v[i] = Lanes{0, 0, 0, 0};
    body.system.enter(motion, true);
    state.position.resize(3, net.nodeCount());
    state.velocity.resize(3, net.nodeCount());
    force.resize(count);
    initial = energies();
    driver.begin();
    publish();
  }

  Energies energies() const
  {
    const System& system = body.system;
    return {system.kineticEnergy(body.motion.v), system.elasticEnergy(body.motion.x),
            system.forces().gravityEnergy(body.motion.x.data())};
  }

  /// What energies() and the work lack of tools that have moved since they were set.
  double ledToolEnergy() const noexcept { return body.system.ledToolEnergy(body.motion.time, body.motion.x); }

  /// Of what the patch names alone, with the numbers of now.
  Energies energiesOf(const ParameterPatch& patch) const
  {
    const SpringNet& net = body.net;
    const NodeArray& x = body.motion.x;
    Energies sum;
    for (const ParameterPatch::Node& node : patch.nodes) {
      const auto i = static_cast<std::size_t>(node.node);
      sum.kinetic += 0.5 * net.mass[node.node] * dot(body.motion.v[i], body.motion.v[i]);
      sum.gravity -= net.mass[node.node] * body.loads.gravity.dot(toVector(x[i]));
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
    if (!patch.bulkModuli.empty()) sum.elastic += body.system.forces().pressure().energy(x.data());
    return sum;
  }

  void addToInitial(const Energies& change) noexcept
  {
    initial.kinetic += change.kinetic;
    initial.elastic += change.elastic;
    initial.gravity += change.gravity;
  }

  void watchGrowth(const StepReport& report)
  {
    const double springs = std::max(static_cast<double>(body.system.forces().activeSprings()), 1.0);
    growth->pay(static_cast<double>(report.springsEvaluated) / springs);
    if (growth->isFollowing())
      growth->carryOn(body.motion);
    else if (growth->lookIsDue() && growth->look(body.system, body.motion))
      growth->setMode(driver.fastestMode());
  }

  /// Where the net is large enough.
  void engageWorkers()
  {
    const bool pays = threads > 1 && body.system.forces().isDivided();
    if (pays && !workers) workers = std::make_unique<WorkerPool>(threads);
    body.system.setWorkers(pays ? workers.get() : nullptr);
  }

  /// What has moved to `state`.
  void publish()
  {
    if (driver.allMoved()) {
      copyNodes(body.motion.x, state.position);
      copyNodes(body.motion.v, state.velocity);
    } else {
      for (const Index node : driver.moved()) {
        state.position.col(node) = toVector(body.motion.x[static_cast<std::size_t>(node)]);
        state.velocity.col(node) = toVector(body.motion.v[static_cast<std::size_t>(node)]);
      }
    }
    driver.clearMoved();
    state.time = body.motion.time;
    forceIsCurrent = false;
  }

  const NodeArray& currentForce()
  {
    if (forceIsCurrent) return force;
    MotionState& motion = body.motion;
    const std::int64_t counted = body.system.springsEvaluated;
    // Prescribed nodes are in their place already.
    body.system.evaluate(motion.time, motion.x, motion.v, force);
    body.system.springsEvaluated = counted;
    forceIsCurrent = true;
    return force;
  }

  Body body;
  RegionDriver driver;
  int threads;                         ///< that may be used
  std::unique_ptr<WorkerPool> workers; ///< null until a net asks for them
  NetState state;
  std::vector<ToolSpring> formerTools;
  std::unique_ptr<GrowthWatch> growth; ///< null until somebody asks
  Energies initial;                    ///< at t = 0, and what new parameters have changed since
  NodeArray force;                     ///< at the state, when asked for
  bool forceIsCurrent = false;
};

Result<Simulation> Simulation::create(SpringNet net, Loads loads, SolverSettings settings)
{
  if (Status status = checkNet(net); !status) return status.error();
  if (Status status = checkLoads(loads, net.nodeCount()); !status) return status.error();
  if (Status status = checkSettings(settings); !status) return status.error();
  return Simulation(std::make_unique<Impl>(std::move(net), std::move(loads), std::move(settings)));
}

Simulation::Simulation(std::unique_ptr<Impl> impl) : m_impl(std::move(impl)) {}
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;
Simulation::~Simulation() = default;

StepReport Simulation::advance(double interval, const Budget& budget)
{
  if (!(interval > 0.0) || !std::isfinite(interval)) return {};
  Impl& impl = *m_impl;
  MotionState& motion = impl.body.motion;
  if (impl.growth) impl.growth->remember(motion);
  const StepReport report = impl.driver.advance(interval, budget);
  if (impl.growth && report.good()) impl.watchGrowth(report);
  m_impl->publish();
  return report;
}

void Simulation::reset()
{
  m_impl->reset();
}

Status Simulation::setParameters(SpringNet net)
{
  Impl& impl = *m_impl;
  if (net.nodeCount() != impl.body.net.nodeCount() || net.springCount() != impl.body.net.springCount() ||
      net.ends != impl.body.net.ends)
    return Error{ErrorCode::InvalidValue,
                 "the new parameters are for a net of other springs; start a new simulation with it"};
  if (Status status = checkNet(net); !status) return status.error();
  impl.driver.closeLoss();
  const ParameterChange change = changeBetween(impl.body.net, net);
  impl.body.net = std::move(net);
  const Energies energiesBefore = impl.energies();
  impl.body.system.setParameters(impl.body.net, impl.body.loads.gravity);
  impl.engageWorkers();
  for (std::size_t i = 0; i < impl.body.motion.v.size(); ++i)
    if (impl.body.net.fixed[i]) impl.body.motion.v[i] = Lanes{0, 0, 0, 0};
  impl.addToInitial(differenceOf(impl.energies(), energiesBefore));
  impl.driver.parametersChanged(change);
  impl.publish();
  return {};
}

Result<ParameterChange> Simulation::setParameters(const ParameterPatch& patch)
{
  Impl& impl = *m_impl;
  Body& body = impl.body;
  if (Status status = checkPatch(patch, body.net); !status) return status.error();
  impl.driver.closeLoss();
  ParameterChange change = changeBy(patch, body.net);
  const Energies energiesBefore = impl.energiesOf(patch);
  patch.applyTo(body.net);
  change.springsSeen += body.system.setParameters(patch, body.net, body.loads.gravity);
  impl.engageWorkers();
  change.energies = differenceOf(impl.energiesOf(patch), energiesBefore);
  impl.addToInitial(change.energies);
  impl.driver.parametersChanged(change);
  impl.publish();
  return change;
}

Status Simulation::setAccuracy(double tolerance, double effort)
{
  if (!(tolerance > 0.0) || !std::isfinite(tolerance) || !(effort > 0.0) || !std::isfinite(effort))
    return Error{ErrorCode::InvalidValue, "the tolerance and the effort must be positive numbers"};
  m_impl->driver.setAccuracy(tolerance, effort);
  return {};
}

void Simulation::setTools(std::span<const ToolSpring> tools)
{
  Impl& impl = *m_impl;
  for ([[maybe_unused]] const ToolSpring& tool : tools)
    ESM_ASSERT(tool.node >= 0 && tool.node < impl.body.net.nodeCount());
  impl.formerTools = impl.body.system.tools(); // a hand moves every frame: no allocation
  // The hand stretches the tool springs.
  impl.body.motion.work += impl.body.system.setTools(tools, impl.body.motion.x, impl.body.motion.time);
  impl.driver.toolsChanged(impl.formerTools);
  impl.formerTools.reserve(tools.size());
  impl.forceIsCurrent = false;
}

const SpringNet& Simulation::net() const noexcept
{
  return m_impl->body.net;
}

const Loads& Simulation::loads() const noexcept
{
  return m_impl->body.loads;
}

const NetState& Simulation::state() const noexcept
{
  return m_impl->state;
}

Eigen::Vector3d Simulation::momentum() const
{
  return m_impl->state.velocity * m_impl->body.net.mass.matrix();
}

Eigen::Vector3d Simulation::angularMomentum() const
{
  const NetState& state = m_impl->state;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (Index i = 0; i < m_impl->body.net.nodeCount(); ++i)
    sum += m_impl->body.net.mass[i] *
           Eigen::Vector3d(state.position.col(i)).cross(Eigen::Vector3d(state.velocity.col(i)));
  return sum;
}

Energies Simulation::energies() const
{
  Energies energies = m_impl->energies();
  energies.elastic += m_impl->ledToolEnergy();
  return energies;
}

double Simulation::externalWork() const
{
  return m_impl->body.motion.work + m_impl->ledToolEnergy();
}

double Simulation::dissipatedEnergy() const
{
  return m_impl->body.motion.heat;
}

EnergyReport Simulation::energyReport() const
{
  m_impl->driver.closeLoss();
  const MotionState& motion = m_impl->body.motion;
  return {m_impl->initial, energies(), externalWork(), motion.heat, motion.loss, motion.restored};
}

Eigen::Vector3d Simulation::reaction(Index node) const
{
  ESM_ASSERT(node >= 0 && node < m_impl->body.net.nodeCount());
  const auto i = static_cast<std::size_t>(node);
  if (m_impl->body.system.isFree(i)) return Eigen::Vector3d::Zero();
  return -toVector(m_impl->currentForce()[i]);
}

void Simulation::watchGrowth()
{
  m_impl->growth = std::make_unique<GrowthWatch>();
  m_impl->growth->begin(m_impl->body.net, m_impl->body.loads);
}

double Simulation::livingError() const noexcept
{
  return m_impl->driver.livingError();
}

double Simulation::errorGrowth() const noexcept
{
  return m_impl->growth ? m_impl->growth->largest() : 1.0;
}

double Simulation::errorGrowthTime() const noexcept
{
  return m_impl->growth ? m_impl->growth->time() : 0.0;
}

double Simulation::errorGrowthPasses() const noexcept
{
  return m_impl->growth ? m_impl->growth->spent() : 0.0;
}

Eigen::Vector3d Simulation::toolForce(std::size_t tool) const
{
  const MotionState& motion = m_impl->body.motion;
  return m_impl->body.system.toolForce(tool, motion.time, motion.x, motion.v);
}

void Simulation::springTensions(Eigen::Ref<Eigen::ArrayXd> tension) const
{
  ESM_ASSERT(tension.size() == m_impl->body.net.springCount());
  const System& system = m_impl->body.system;
  system.forces().springTensions(m_impl->body.motion.x.data(), m_impl->body.motion.v.data(), tension.data(),
                                 system.workers());
}

void Simulation::springTensions(std::span<const Index> springs, Eigen::Ref<Eigen::ArrayXd> tension) const
{
  const Body& body = m_impl->body;
  ESM_ASSERT(tension.size() == body.net.springCount());
  FewSprings(body.net, springs).tensions(body.motion.x.data(), body.motion.v.data(), tension.data());
}

double Simulation::stableStep() const
{
  return m_impl->driver.explicitStep(m_impl->driver.fastestMode());
}

Index Simulation::stiffestNode() const
{
  return m_impl->driver.fastestMode().node;
}

const std::string& Simulation::solverName() const noexcept
{
  return m_impl->driver.solverName();
}

const std::string& Simulation::why() const noexcept
{
  return m_impl->driver.why();
}

std::vector<SolverInfo> solverNames()
{
  std::vector<SolverInfo> names;
  for (const IntegratorEntry& entry : integratorTable())
    names.push_back({std::string(entry.name), std::string(entry.description)});
  return names;
}

} // namespace esm
