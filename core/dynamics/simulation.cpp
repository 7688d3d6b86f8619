// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/simulation.h"

#include "core/base/assert.h"
#include "core/dynamics/island_motions.h"
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

/// More than there are processors only wait for each other.
int usefulThreads(const SolverSettings& settings) noexcept
{
  const auto processors = static_cast<int>(std::thread::hardware_concurrency()); // 0 = unknown
  return processors > 0 ? std::min(settings.threads, processors) : settings.threads;
}

} // namespace

struct Simulation::Impl {
  Impl(SpringNet net, Loads loads, const SolverSettings& settings)
    : islands(std::move(net), std::move(loads), settings)
  {
    state.position.resize(3, islands.net().nodeCount());
    state.velocity.resize(3, islands.net().nodeCount());
    islands.publish(state);
  }

  IslandMotions islands;
  NetState state;
};

Result<Simulation> Simulation::create(SpringNet net, Loads loads, SolverSettings settings)
{
  if (Status status = checkNet(net); !status) return status.error();
  if (Status status = checkLoads(loads, net.nodeCount()); !status) return status.error();
  if (Status status = checkSettings(settings); !status) return status.error();
  settings.threads = usefulThreads(settings);
  return Simulation(std::make_unique<Impl>(std::move(net), std::move(loads), settings));
}

Simulation::Simulation(std::unique_ptr<Impl> impl) : m_impl(std::move(impl)) {}
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;
Simulation::~Simulation() = default;

StepReport Simulation::advance(double interval, const Budget& budget)
{
  if (!(interval > 0.0) || !std::isfinite(interval)) return {};
  const StepReport report = m_impl->islands.advance(interval, budget);
  m_impl->islands.publish(m_impl->state);
  return report;
}

void Simulation::reset()
{
  m_impl->islands.reset();
  m_impl->islands.publish(m_impl->state);
}

Status Simulation::setParameters(SpringNet net)
{
  const SpringNet& before = this->net();
  if (net.nodeCount() != before.nodeCount() || net.springCount() != before.springCount() ||
      net.ends != before.ends)
    return Error{ErrorCode::InvalidValue,
                 "the new parameters are for a net of other springs; start a new simulation with it"};
  if (Status status = checkNet(net); !status) return status.error();
  m_impl->islands.setParameters(std::move(net));
  m_impl->islands.publish(m_impl->state);
  return {};
}

Result<ParameterChange> Simulation::setParameters(const ParameterPatch& patch)
{
  if (Status status = checkPatch(patch, net()); !status) return status.error();
  ParameterChange change = m_impl->islands.setParameters(patch);
  m_impl->islands.publish(m_impl->state);
  return change;
}

Status Simulation::setAccuracy(double tolerance, double effort)
{
  if (!(tolerance > 0.0) || !std::isfinite(tolerance) || !(effort > 0.0) || !std::isfinite(effort))
    return Error{ErrorCode::InvalidValue, "the tolerance and the effort must be positive numbers"};
  m_impl->islands.setAccuracy(tolerance, effort);
  return {};
}

void Simulation::setTools(std::span<const ToolSpring> tools)
{
  m_impl->islands.setTools(tools);
}

const SpringNet& Simulation::net() const noexcept
{
  return m_impl->islands.net();
}

const Loads& Simulation::loads() const noexcept
{
  return m_impl->islands.loads();
}

const NetState& Simulation::state() const noexcept
{
  return m_impl->state;
}

std::size_t Simulation::islandCount() const noexcept
{
  return m_impl->islands.count();
}

Eigen::Vector3d Simulation::momentum() const
{
  return m_impl->state.velocity * net().mass.matrix();
}

Eigen::Vector3d Simulation::angularMomentum() const
{
  const NetState& state = m_impl->state;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (Index i = 0; i < net().nodeCount(); ++i)
    sum +=
      net().mass[i] * Eigen::Vector3d(state.position.col(i)).cross(Eigen::Vector3d(state.velocity.col(i)));
  return sum;
}

Energies Simulation::energies() const
{
  return m_impl->islands.energies();
}

double Simulation::externalWork() const
{
  return m_impl->islands.sum(&NetMotion::externalWork);
}

double Simulation::dissipatedEnergy() const
{
  return m_impl->islands.sum(&NetMotion::dissipatedEnergy);
}

EnergyReport Simulation::energyReport() const
{
  EnergyReport sum;
  for (const EnergyReport& island : islandEnergies()) sum += island;
  return sum;
}

std::vector<EnergyReport> Simulation::islandEnergies() const
{
  return m_impl->islands.energyReports();
}

Eigen::Vector3d Simulation::reaction(Index node) const
{
  ESM_ASSERT(node >= 0 && node < net().nodeCount());
  return m_impl->islands.reaction(node);
}

void Simulation::watchGrowth()
{
  m_impl->islands.watchGrowth();
}

double Simulation::livingError() const noexcept
{
  return m_impl->islands.livingError();
}

double Simulation::errorGrowth() const noexcept
{
  const GrowthWatch* growth = m_impl->islands.largestGrowth();
  return growth ? growth->largest() : 1.0;
}

double Simulation::errorGrowthTime() const noexcept
{
  const GrowthWatch* growth = m_impl->islands.largestGrowth();
  return growth ? growth->time() : 0.0;
}

double Simulation::errorGrowthPasses() const noexcept
{
  return m_impl->islands.growthPasses();
}

Eigen::Vector3d Simulation::toolForce(std::size_t tool) const
{
  return m_impl->islands.toolForce(tool);
}

void Simulation::springTensions(Eigen::Ref<Eigen::ArrayXd> tension) const
{
  ESM_ASSERT(tension.size() == net().springCount());
  m_impl->islands.springTensions({tension.data(), static_cast<std::size_t>(tension.size())});
}

void Simulation::springTensions(std::span<const Index> springs, Eigen::Ref<Eigen::ArrayXd> tension) const
{
  ESM_ASSERT(tension.size() == net().springCount());
  m_impl->islands.springTensions(springs, {tension.data(), static_cast<std::size_t>(tension.size())});
}

double Simulation::stableStep() const
{
  return m_impl->islands.stiffest().step;
}

Index Simulation::stiffestNode() const
{
  return m_impl->islands.stiffest().node;
}

const std::string& Simulation::solverName() const noexcept
{
  return m_impl->islands.leading().solverName();
}

const std::string& Simulation::why() const noexcept
{
  return m_impl->islands.leading().why();
}

} // namespace esm
