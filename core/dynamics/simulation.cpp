// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/simulation.h"

#include "core/base/assert.h"
#include "core/dynamics/step_driver.h"
#include "core/net/net_builder.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

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
  if (settings.threads < 1) return invalid("the number of threads must be at least 1");
  return {};
}

} // namespace

struct Simulation::Impl {
  Impl(SpringNet net_, Loads loads_, SolverSettings settings)
    : net(std::move(net_)), loads(std::move(loads_)), driver(std::move(settings))
  {
    reset();
  }

  void reset()
  {
    system = System(net, loads);
    const auto count = static_cast<std::size_t>(net.nodeCount());
    motion = MotionState{};
    motion.x.resize(count);
    motion.v.assign(count, Lanes{0, 0, 0, 0});
    copyNodes(net.restPosition, motion.x);
    if (net.initialVelocity.cols() == net.nodeCount()) copyNodes(net.initialVelocity, motion.v);
    for (std::size_t i = 0; i < count; ++i)
      if (net.fixed[i]) motion.v[i] = Lanes{0, 0, 0, 0};
    system.enter(motion, true);
    state.position.resize(3, net.nodeCount());
    state.velocity.resize(3, net.nodeCount());
    force.resize(count);
    driver.begin(system, motion);
    publish();
  }

  void publish()
  {
    copyNodes(motion.x, state.position);
    copyNodes(motion.v, state.velocity);
    state.time = motion.time;
    forceIsCurrent = false;
  }

  const NodeArray& currentForce()
  {
    if (forceIsCurrent) return force;
    const std::int64_t counted = system.springsEvaluated;
    system.evaluate(motion.time, motion.x, motion.v, force); // prescribed nodes are in their place already
    system.springsEvaluated = counted;
    forceIsCurrent = true;
    return force;
  }

  SpringNet net;
  Loads loads;
  StepDriver driver;
  System system;
  MotionState motion;
  NetState state;
  NodeArray force; ///< at the state, when asked for
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

StepReport Simulation::advance(double interval, std::int64_t maxSteps)
{
  if (!(interval > 0.0) || !std::isfinite(interval)) return {};
  const StepReport report = m_impl->driver.advance(m_impl->system, m_impl->motion, interval, maxSteps);
  m_impl->publish();
  return report;
}

void Simulation::reset()
{
  m_impl->reset();
}

Status Simulation::setParameters(const SpringNet& net)
{
  Impl& impl = *m_impl;
  if (net.nodeCount() != impl.net.nodeCount() || net.springCount() != impl.net.springCount() ||
      net.ends != impl.net.ends)
    return Error{ErrorCode::InvalidValue,
                 "the new parameters are for a net of other springs; start a new simulation with it"};
  if (Status status = checkNet(net); !status) return status.error();
  impl.net = net;
  impl.system.setParameters(impl.net, impl.loads.gravity);
  for (std::size_t i = 0; i < impl.motion.v.size(); ++i)
    if (impl.net.fixed[i]) impl.motion.v[i] = Lanes{0, 0, 0, 0};
  impl.driver.parametersChanged(impl.system, impl.motion);
  impl.publish();
  return {};
}

void Simulation::setTools(std::span<const ToolSpring> tools)
{
  Impl& impl = *m_impl;
  for ([[maybe_unused]] const ToolSpring& tool : tools)
    ESM_ASSERT(tool.node >= 0 && tool.node < impl.net.nodeCount());
  const auto& former = impl.system.tools();
  const bool sameNodes = std::equal(
    tools.begin(), tools.end(), former.begin(), former.end(), [](const ToolSpring& a, const ToolSpring& b) {
      return a.node == b.node && a.stiffness == b.stiffness && a.viscosity == b.viscosity;
    });
  impl.motion.work += impl.system.setTools(tools, impl.motion.x); // the hand stretches the tool springs
  impl.driver.toolsChanged(impl.system, impl.motion, sameNodes);
  impl.forceIsCurrent = false;
}

const SpringNet& Simulation::net() const noexcept
{
  return m_impl->net;
}

const Loads& Simulation::loads() const noexcept
{
  return m_impl->loads;
}

const NetState& Simulation::state() const noexcept
{
  return m_impl->state;
}

Eigen::Vector3d Simulation::momentum() const
{
  return m_impl->state.velocity * m_impl->net.mass.matrix();
}

Eigen::Vector3d Simulation::angularMomentum() const
{
  const NetState& state = m_impl->state;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (Index i = 0; i < m_impl->net.nodeCount(); ++i)
    sum += m_impl->net.mass[i] *
           Eigen::Vector3d(state.position.col(i)).cross(Eigen::Vector3d(state.velocity.col(i)));
  return sum;
}

Energies Simulation::energies() const
{
  const System& system = m_impl->system;
  return {system.kineticEnergy(m_impl->motion.v), system.elasticEnergy(m_impl->motion.x),
          system.forces().gravityEnergy(m_impl->motion.x.data())};
}

double Simulation::externalWork() const
{
  return m_impl->motion.work;
}

double Simulation::dissipatedEnergy() const
{
  return m_impl->motion.heat;
}

Eigen::Vector3d Simulation::reaction(Index node) const
{
  ESM_ASSERT(node >= 0 && node < m_impl->net.nodeCount());
  const auto i = static_cast<std::size_t>(node);
  if (m_impl->system.isFree(i)) return Eigen::Vector3d::Zero();
  return -toVector(m_impl->currentForce()[i]);
}

Eigen::Vector3d Simulation::toolForce(std::size_t tool) const
{
  return m_impl->system.toolForce(tool, m_impl->motion.x, m_impl->motion.v);
}

void Simulation::springTensions(Eigen::Ref<Eigen::ArrayXd> tension) const
{
  ESM_ASSERT(tension.size() == m_impl->net.springCount());
  m_impl->system.forces().springTensions(m_impl->motion.x.data(), m_impl->motion.v.data(), tension.data());
}

double Simulation::stableStep() const
{
  return m_impl->driver.explicitStep(m_impl->driver.fastestMode(m_impl->system, m_impl->motion));
}

Index Simulation::stiffestNode() const
{
  return m_impl->driver.fastestMode(m_impl->system, m_impl->motion).node;
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
