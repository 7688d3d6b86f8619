// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/simulation.h"

#include "core/base/assert.h"
#include "core/base/hash.h"
#include "core/base/text_number.h"
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

void sign(logged::Advance& record, const NetState& state)
{
  const auto bytes = [](const Eigen::Matrix3Xd& values) {
    return static_cast<std::size_t>(values.size()) * sizeof(double);
  };
  record.time = state.time;
  record.state = hashBytes(state.position.data(), bytes(state.position));
  record.state = hashBytes(state.velocity.data(), bytes(state.velocity), record.state);
}

std::string textOf(const Stretch& stretch)
{
  return std::to_string(stretch.steps) + " steps of " + stretch.method + " from " +
         formatDouble(stretch.begin, 17) + " to " + formatDouble(stretch.end, 17) + " s";
}

/// The first thing that came out otherwise; empty: nothing.
std::string differenceBetween(const logged::Advance& former, const logged::Advance& now)
{
  for (std::size_t k = 0; k < former.parts.size(); ++k) {
    const auto &then = former.parts[k].stretches, &again = now.parts[k].stretches;
    const auto [a, b] = std::ranges::mismatch(then, again);
    if (a == then.end() && b == again.end()) continue;
    const auto text = [](auto at, const auto& all) { return at == all.end() ? "nothing" : textOf(*at); };
    return "part " + std::to_string(k + 1) + " took " + text(b, again) + ", the log says " + text(a, then);
  }
  if (former.time != now.time)
    return "it came to " + formatDouble(now.time, 17) + " s, the log to " + formatDouble(former.time, 17) +
           " s";
  if (former.state != now.state)
    return "places or velocities at " + formatDouble(now.time, 9) +
           " s differ, though the steps are the same";
  return {};
}

Error isOfAnotherNet(const std::string& why)
{
  return Error{ErrorCode::InvalidValue, "the log is of another net: " + why};
}

template <class... Case>
struct Cases : Case... {
  using Case::operator()...;
};
template <class... Case>
Cases(Case...) -> Cases<Case...>;

} // namespace

struct Simulation::Impl {
  Impl(SpringNet net, Loads loads, const SolverSettings& settings)
    : islands(std::move(net), std::move(loads), settings)
  {
    state.position.resize(3, islands.net().nodeCount());
    state.velocity.resize(3, islands.net().nodeCount());
    islands.publish(state);
  }

  void publish() { islands.publish(state); }
  template <class Entry>
  void write(Entry entry)
  {
    if (log) log->emplace_back(std::move(entry));
  }

  IslandMotions islands;
  NetState state;
  MotionLog* log = nullptr;
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
  if (!m_impl->log) {
    const StepReport report = m_impl->islands.advance(interval, budget);
    m_impl->publish();
    return report;
  }
  logged::Advance record;
  const StepReport report = m_impl->islands.advance(interval, budget, record);
  m_impl->publish();
  sign(record, m_impl->state);
  m_impl->write(std::move(record));
  return report;
}

void Simulation::reset()
{
  m_impl->islands.reset();
  m_impl->publish();
  m_impl->write(logged::Reset{});
}

Status Simulation::setParameters(SpringNet net)
{
  const SpringNet& before = this->net();
  if (net.nodeCount() != before.nodeCount() || net.springCount() != before.springCount() ||
      net.ends != before.ends)
    return Error{ErrorCode::InvalidValue,
                 "the new parameters are for a net of other springs; start a new simulation with it"};
  if (Status status = checkNet(net); !status) return status.error();
  if (m_impl->log) m_impl->write(logged::Net{net});
  m_impl->islands.setParameters(std::move(net));
  m_impl->publish();
  return {};
}

Result<ParameterChange> Simulation::setParameters(const ParameterPatch& patch)
{
  if (Status status = checkPatch(patch, net()); !status) return status.error();
  ParameterChange change = m_impl->islands.setParameters(patch);
  m_impl->publish();
  if (m_impl->log) m_impl->write(logged::Patch{patch});
  return change;
}

Status Simulation::setAccuracy(double tolerance, double effort)
{
  if (!(tolerance > 0.0) || !std::isfinite(tolerance) || !(effort > 0.0) || !std::isfinite(effort))
    return Error{ErrorCode::InvalidValue, "the tolerance and the effort must be positive numbers"};
  m_impl->islands.setAccuracy(tolerance, effort);
  m_impl->write(logged::Accuracy{tolerance, effort});
  return {};
}

void Simulation::setTools(std::span<const ToolSpring> tools)
{
  m_impl->islands.setTools(tools);
  if (m_impl->log) m_impl->write(logged::Tools{{tools.begin(), tools.end()}});
}

void Simulation::record(MotionLog* log) noexcept
{
  m_impl->log = log;
}

Result<std::string> Simulation::replay(const LogEntry& entry)
{
  const auto done = [](const Status& status) -> Result<std::string> {
    if (!status) return status.error();
    return std::string();
  };
  const auto visitor =
    Cases{[&](const logged::Advance& former) { return replayAdvance(former); },
          [&](const logged::Tools& tools) -> Result<std::string> {
            for (const ToolSpring& tool : tools.springs)
              if (tool.node < 0 || tool.node >= net().nodeCount())
                return isOfAnotherNet("a tool holds an absent node");
            setTools(tools.springs);
            return std::string();
          },
          [&](const logged::Patch& patch) -> Result<std::string> {
            const Result<ParameterChange> change = setParameters(patch.patch);
            return change ? done({}) : done(change.error());
          },
          [&](const logged::Net& other) { return done(setParameters(other.net)); },
          [&](const logged::Accuracy& wanted) { return done(setAccuracy(wanted.tolerance, wanted.effort)); },
          [&](const logged::Reset&) {
            reset();
            return done({});
          },
          [&](const logged::GrowthWatch&) {
            watchGrowth();
            return done({});
          }};
  return std::visit(visitor, entry);
}

Result<std::string> Simulation::replayAdvance(const logged::Advance& former)
{
  if (former.parts.size() != islandCount())
    return isOfAnotherNet("the log knows " + std::to_string(former.parts.size()) +
                          " parts that move on their own, the net has " + std::to_string(islandCount()));
  if (!(former.interval > 0.0) || !std::isfinite(former.interval)) return std::string();
  logged::Advance record;
  m_impl->islands.advanceAgain(former, record);
  m_impl->publish();
  sign(record, m_impl->state);
  std::string difference = differenceBetween(former, record);
  m_impl->write(std::move(record));
  return difference;
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
  m_impl->write(logged::GrowthWatch{});
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
