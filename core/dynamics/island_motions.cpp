// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/dynamics/island_motions.h"

#include "core/net/net_edit.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <mutex>
#include <numeric>
#include <utility>

namespace esm {
namespace {

constexpr std::size_t kMostIslands = 64; ///< each takes room and some microseconds a frame
/// Springs of an island from which on a thread of its own is worth while.
constexpr Index kWorthAThread = 1000;

} // namespace

IslandMotions::IslandMotions(SpringNet net, Loads loads, const SolverSettings& settings)
  : m_tolerance(settings.tolerance), m_effort(settings.effort), m_keepsTime(settings.keepsTime)
{
  std::vector<NetIsland> places = findIslands(net, kMostIslands);
  m_islands.resize(std::max<std::size_t>(places.size(), 1));
  if (isOne()) {
    m_islands.front().motion = std::make_unique<NetMotion>(std::move(net), std::move(loads), settings);
    return;
  }
  for (std::size_t k = 0; k < places.size(); ++k) m_islands[k].places = std::move(places[k]);
  m_net = std::move(net);
  m_loads = std::move(loads);
  split(settings);
}

void IslandMotions::split(const SolverSettings& settings)
{
  m_nodes.resize(at(m_net.nodeCount()));
  m_springs.resize(at(m_net.springCount()));
  for (std::size_t k = 0; k < m_islands.size(); ++k) {
    const NetIsland& places = m_islands[k].places;
    for (std::size_t i = 0; i < places.nodes.size(); ++i)
      m_nodes[at(places.nodes[i])] = {k, static_cast<Index>(i)};
    for (std::size_t i = 0; i < places.springs.size(); ++i)
      m_springs[at(places.springs[i])] = {k, static_cast<Index>(i)};
  }
  std::vector<Index> bodies(m_islands.size(), 0);
  for (const PressureBody& body : m_net.pressure) {
    const std::size_t island = m_nodes[at(body.triangles(0, 0))].island;
    m_pressure.push_back({island, bodies[island]++});
  }
  m_anchors = placesOf(m_net.anchors);

  // Threads go to islands, or, where one is most of the net, into its passes.
  Index largest = 0;
  std::size_t worthy = 0;
  for (const Island& island : m_islands) {
    const auto springs = static_cast<Index>(island.places.springs.size());
    largest = std::max(largest, springs);
    if (springs >= kWorthAThread) ++worthy;
  }
  SolverSettings own = settings;
  if (2 * largest <= m_net.springCount() && worthy > 1 && settings.threads > 1) {
    own.threads = 1;
    m_workers = std::make_unique<WorkerPool>(std::min(settings.threads, static_cast<int>(worthy)));
  }
  for (std::size_t k = 0; k < m_islands.size(); ++k) {
    Island& island = m_islands[k];
    const auto placeOf = [&](Index node) {
      const Place place = m_nodes[at(node)];
      return place.island == k ? place.place : kNoIndex;
    };
    island.effort = settings.effort;
    island.motion = std::make_unique<NetMotion>(islandNet(m_net, island.places),
                                                loadsOnPart(m_loads, placeOf), own, island.places.nodes);
  }
}

std::vector<IslandMotions::Place> IslandMotions::placesOf(const AnchorSet& set) const
{
  std::vector<Place> places;
  std::vector<Index> count(m_islands.size(), 0);
  for (const Index node : set.node) {
    const std::size_t island = m_nodes[at(node)].island;
    places.push_back({island, count[island]++});
  }
  return places;
}

// === Motion

void IslandMotions::reset()
{
  for (Island& island : m_islands) {
    island.motion->reset();
    island.last = {};
    island.tools.clear();
  }
  m_tools.clear();
  m_time = 0.0;
  m_leading = 0;
}

StepReport IslandMotions::advance(double interval, const Budget& budget)
{
  if (isOne()) {
    const StepReport report = m_islands.front().motion->advance(interval, budget);
    m_time = m_islands.front().motion->time();
    return report;
  }
  std::mutex asking;
  Budget asked = budget;
  if (m_workers && budget.isSpent)
    asked.isSpent = [&] {
      const std::scoped_lock lock(asking);
      return budget.isSpent();
    };
  return advanceAll(
    interval, [&](std::size_t) { return asked; }, nullptr, nullptr);
}

StepReport IslandMotions::advance(double interval, const Budget& budget, logged::Advance& record)
{
  std::mutex asking;
  record = {interval, budget.steps, budget.isSpent != nullptr, {}, 0.0, 0};
  record.parts.assign(m_islands.size(), {});
  std::vector<std::int64_t> granted(m_islands.size(), 0);
  const auto budgetOf = [&](std::size_t k) {
    Budget asked = budget;
    if (budget.isSpent)
      asked.isSpent = [&, k] {
        const std::scoped_lock lock(asking);
        const bool isSpent = budget.isSpent();
        std::int64_t& grants = record.parts[k].grants;
        if (isSpent)
          grants = std::min(grants, granted[k]);
        else
          ++granted[k];
        return isSpent;
      };
    return asked;
  };
  return advanceAll(interval, budgetOf, &record, nullptr);
}

StepReport IslandMotions::advanceAgain(const logged::Advance& former, logged::Advance& record)
{
  record = {former.interval, former.steps, former.isAsked, {}, 0.0, 0};
  record.parts.assign(m_islands.size(), {});
  std::vector<std::int64_t> granted(m_islands.size(), 0);
  const auto budgetOf = [&](std::size_t k) {
    Budget asked{former.steps, {}};
    if (former.isAsked)
      asked.isSpent = [&, k] {
        if (granted[k] == former.parts[k].grants) return true;
        ++granted[k];
        return false;
      };
    record.parts[k].grants = former.parts[k].grants;
    return asked;
  };
  return advanceAll(former.interval, budgetOf, &record, &former);
}

StepReport IslandMotions::advanceAll(double interval, const BudgetOf& budgetOf, logged::Advance* record,
                                     const logged::Advance* former)
{
  if (m_keepsTime && !isOne()) shareEffort();
  const double begin = m_time;
  std::vector<std::size_t> order(m_islands.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t k) { return m_islands[k].motion->time(); });
  for (Island& island : m_islands) {
    const std::int64_t awake = island.last.nodesAwake; // of one that is ahead, and waits
    island.last = {};
    island.last.nodesAwake = awake;
  }
  const auto move = [&](std::size_t k) {
    if (former && !former->parts[k].isMoved) return;
    Island& island = m_islands[k];
    if (record) {
      record->parts[k].isMoved = true;
      island.motion->record(&record->parts[k].stretches);
    }
    island.last = advanceOne(island, interval, budgetOf(k));
    if (record) island.motion->record(nullptr);
  };
  if (m_workers) {
    std::vector<std::exception_ptr> troubles(order.size());
    m_workers->forEach(order.size(), [&](std::size_t i) noexcept {
      try {
        move(order[i]);
      } catch (...) {
        troubles[i] = std::current_exception();
      }
    });
    for (const std::exception_ptr& trouble : troubles)
      if (trouble) std::rethrow_exception(trouble);
  } else {
    for (const std::size_t k : order) {
      move(k);
      if (m_islands[k].last.interrupted && !former) break;
    }
  }
  return sumUp(begin);
}

/// From wherever it is. Where that is in step but for rounding, by the very interval of the call, as it would be alone.
StepReport IslandMotions::advanceOne(Island& island, double interval, const Budget& budget)
{
  const double ahead = island.motion->time() - m_time, rounding = 1e-9 * interval;
  if (ahead >= interval - rounding) return island.last;
  return island.motion->advance(std::abs(ahead) <= rounding ? interval : interval - ahead, budget);
}

StepReport IslandMotions::sumUp(double begin)
{
  StepReport sum;
  std::int64_t most = 0;
  m_time = std::numeric_limits<double>::infinity();
  std::size_t failed = m_islands.size(), busiest = m_leading;
  for (std::size_t k = 0; k < m_islands.size(); ++k) {
    const StepReport& report = m_islands[k].last;
    sum.join(report);
    m_time = std::min(m_time, m_islands[k].motion->time());
    if (!report.good() && failed == m_islands.size()) failed = k;
    if (report.springsEvaluated > most) {
      most = report.springsEvaluated;
      busiest = k;
    }
  }
  m_leading = failed < m_islands.size() ? failed : busiest;
  sum.simulatedTime = m_time - begin;
  return sum;
}

/// By the springs of those that are awake, or are going to be.
void IslandMotions::shareEffort()
{
  const auto isBusy = [](const Island& island) {
    return island.last.nodesAwake > 0 || !island.tools.empty();
  };
  double busy = 0.0;
  for (const Island& island : m_islands)
    if (isBusy(island)) busy += static_cast<double>(island.places.springs.size());
  for (Island& island : m_islands) {
    const auto springs = static_cast<double>(island.places.springs.size());
    const double effort = isBusy(island) && springs > 0.0 ? m_effort * springs / busy : m_effort;
    if (effort == island.effort) continue;
    island.effort = effort;
    island.motion->setAccuracy(m_tolerance, effort);
  }
}

void IslandMotions::setAccuracy(double tolerance, double effort)
{
  m_tolerance = tolerance;
  m_effort = effort;
  for (Island& island : m_islands) {
    island.effort = effort;
    island.motion->setAccuracy(tolerance, effort);
  }
}

void IslandMotions::setTools(std::span<const ToolSpring> tools)
{
  if (isOne()) return m_islands.front().motion->setTools(tools);
  for (Island& island : m_islands) {
    island.hasNewTools = !island.tools.empty();
    island.tools.clear();
  }
  m_tools.clear();
  for (const ToolSpring& tool : tools) {
    const Place place = m_nodes[at(tool.node)];
    Island& island = m_islands[place.island];
    m_tools.push_back({place.island, static_cast<Index>(island.tools.size())});
    island.tools.push_back(tool);
    island.tools.back().node = place.place;
    island.hasNewTools = true;
  }
  for (Island& island : m_islands)
    if (island.hasNewTools) island.motion->setTools(island.tools);
}

void IslandMotions::publish(NetState& state)
{
  constexpr double kRounding = 1e-11; // of times that are the same [s]
  for (Island& island : m_islands)
    if (island.motion->time() - m_time > kRounding)
      island.motion->publishBetween(state, island.places.nodes, m_time);
    else
      island.motion->publish(state, island.places.nodes);
  state.time = m_time;
}

// === Parameters

void IslandMotions::setParameters(SpringNet net)
{
  if (isOne()) return m_islands.front().motion->setParameters(std::move(net));
  m_net = std::move(net);
  m_anchors = placesOf(m_net.anchors);
  for (Island& island : m_islands) island.motion->setParameters(islandNet(m_net, island.places));
}

ParameterChange IslandMotions::setParameters(const ParameterPatch& patch)
{
  if (isOne()) return m_islands.front().motion->setParameters(patch);
  const std::vector<ParameterPatch> patches = split(patch);
  patch.applyTo(m_net);
  if (patch.anchorSet) m_anchors = placesOf(m_net.anchors);
  ParameterChange sum;
  for (std::size_t k = 0; k < m_islands.size(); ++k) {
    if (patches[k].isEmpty()) continue;
    const NetIsland& places = m_islands[k].places;
    const ParameterChange change = m_islands[k].motion->setParameters(patches[k]);
    sum.everything = sum.everything || change.everything;
    sum.otherFixed = sum.otherFixed || change.otherFixed;
    sum.otherAnchors = sum.otherAnchors || change.otherAnchors;
    for (const Index node : change.nodes) sum.nodes.push_back(places.nodes[at(node)]);
    for (const Index spring : change.springs) sum.springs.push_back(places.springs[at(spring)]);
    sum.energies += change.energies;
    sum.springsSeen += change.springsSeen;
  }
  std::ranges::sort(sum.nodes);
  std::ranges::sort(sum.springs);
  if (sum.everything) sum.nodes.clear();
  return sum;
}

std::vector<ParameterPatch> IslandMotions::split(const ParameterPatch& patch) const
{
  std::vector<ParameterPatch> patches(m_islands.size());
  for (ParameterPatch::Spring spring : patch.springs) {
    const Place place = m_springs[at(spring.spring)];
    spring.spring = place.place;
    patches[place.island].springs.push_back(spring);
  }
  for (ParameterPatch::Node node : patch.nodes) {
    const Place place = m_nodes[at(node.node)];
    node.node = place.place;
    patches[place.island].nodes.push_back(node);
  }
  std::vector<Place> anchors;
  if (patch.anchorSet) {
    anchors = placesOf(*patch.anchorSet);
    std::vector<std::vector<Index>> own(m_islands.size());
    for (std::size_t k = 0; k < anchors.size(); ++k) own[anchors[k].island].push_back(static_cast<Index>(k));
    for (std::size_t k = 0; k < m_islands.size(); ++k) {
      if (own[k].empty() && m_islands[k].motion->net().anchors.count() == 0) continue;
      AnchorSet set = *patch.anchorSet;
      keepAnchors(set, own[k]);
      for (Index& node : set.node) node = m_nodes[at(node)].place;
      patches[k].anchorSet = std::move(set);
    }
  }
  for (ParameterPatch::Anchor anchor : patch.anchors) {
    const Place place = (patch.anchorSet ? anchors : m_anchors)[at(anchor.anchor)];
    anchor.anchor = place.place;
    patches[place.island].anchors.push_back(anchor);
  }
  for (std::size_t body = 0; body < patch.bulkModuli.size(); ++body)
    patches[m_pressure[body].island].bulkModuli.push_back(patch.bulkModuli[body]);
  return patches;
}

// === What they know

Energies IslandMotions::energies() const
{
  Energies sum;
  for (const Island& island : m_islands) sum += island.motion->energies();
  return sum;
}

std::vector<EnergyReport> IslandMotions::energyReports() const
{
  std::vector<EnergyReport> reports;
  for (const Island& island : m_islands) reports.push_back(island.motion->energyReport());
  return reports;
}

void IslandMotions::watchGrowth()
{
  for (Island& island : m_islands) island.motion->watchGrowth();
}

const GrowthWatch* IslandMotions::largestGrowth() const noexcept
{
  const GrowthWatch* largest = nullptr;
  for (const Island& island : m_islands) {
    const GrowthWatch* growth = island.motion->growth();
    if (growth != nullptr && (largest == nullptr || growth->largest() > largest->largest())) largest = growth;
  }
  return largest;
}

/// Over the whole net: a pass over an island is a part of one.
double IslandMotions::growthPasses() const noexcept
{
  double sum = 0.0;
  const double springs = std::max(static_cast<double>(net().springCount()), 1.0);
  for (const Island& island : m_islands)
    if (const GrowthWatch* growth = island.motion->growth(); growth != nullptr)
      sum += growth->spent() * (isOne() ? 1.0 : static_cast<double>(island.places.springs.size()) / springs);
  return sum;
}

double IslandMotions::livingError() const noexcept
{
  if (isOne()) return m_islands.front().motion->livingError();
  double square = 0.0;
  for (const Island& island : m_islands) {
    const double error = island.motion->livingError();
    square += error * error * static_cast<double>(island.places.nodes.size());
  }
  return std::sqrt(square / static_cast<double>(m_net.nodeCount()));
}

Eigen::Vector3d IslandMotions::reaction(Index node) const
{
  const Place place = placeOfNode(node);
  return m_islands[place.island].motion->reaction(place.place);
}

Eigen::Vector3d IslandMotions::toolForce(std::size_t tool) const
{
  if (isOne()) return m_islands.front().motion->toolForce(tool);
  const Place& place = m_tools[tool];
  return m_islands[place.island].motion->toolForce(at(place.place));
}

void IslandMotions::springTensions(std::span<double> tension) const
{
  if (isOne()) return m_islands.front().motion->springTensions(tension);
  std::vector<double> own;
  for (const Island& island : m_islands) {
    const std::vector<Index>& springs = island.places.springs;
    own.resize(springs.size());
    island.motion->springTensions(own);
    for (std::size_t i = 0; i < springs.size(); ++i) tension[at(springs[i])] = own[i];
  }
}

void IslandMotions::springTensions(std::span<const Index> springs, std::span<double> tension) const
{
  if (isOne()) return m_islands.front().motion->springTensions(springs, tension);
  std::vector<std::vector<Index>> asked(m_islands.size());
  for (const Index spring : springs) {
    const Place place = m_springs[at(spring)];
    asked[place.island].push_back(place.place);
  }
  std::vector<double> own;
  for (std::size_t k = 0; k < m_islands.size(); ++k) {
    if (asked[k].empty()) continue;
    const Island& island = m_islands[k];
    own.resize(island.places.springs.size());
    island.motion->springTensions(asked[k], own);
    for (const Index place : asked[k]) tension[at(island.places.springs[at(place)])] = own[at(place)];
  }
}

IslandMotions::Stiffest IslandMotions::stiffest() const
{
  Stiffest stiffest{std::numeric_limits<double>::infinity(), kNoIndex};
  for (const Island& island : m_islands) {
    const FastestMode mode = island.motion->fastestMode();
    const double step = island.motion->explicitStep(mode);
    if (step < stiffest.step || stiffest.node == kNoIndex)
      stiffest = {step, isOne() || mode.node == kNoIndex ? mode.node : island.places.nodes[at(mode.node)]};
  }
  return stiffest;
}

} // namespace esm
