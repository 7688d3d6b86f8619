// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "core/forces/load_schedule.h"

#include <algorithm>
#include <cmath>

namespace esm {
namespace {

Status checkCurve(const VectorCurve& curve, const std::string& where)
{
  if (curve.time.empty()) return invalidValue(where + " has no times; give at least one");
  if (curve.value.cols() != static_cast<Eigen::Index>(curve.time.size()))
    return invalidValue(where + " has " + std::to_string(curve.time.size()) + " times but " +
                        std::to_string(curve.value.cols()) + " values; give one value for each time");
  if (!curve.value.allFinite()) return invalidValue(where + " holds a value that is not a finite number");
  for (std::size_t i = 0; i < curve.time.size(); ++i) {
    if (!std::isfinite(curve.time[i]))
      return invalidValue(where + " holds a time that is not a finite number");
    if (i > 0 && curve.time[i] < curve.time[i - 1])
      return invalidValue(where + ": time " + std::to_string(i) +
                          " is before the one that precedes it; sort the times");
  }
  return {};
}

Status checkNodes(const std::vector<Index>& list, Index nodes, const std::string& where)
{
  for (const Index node : list)
    if (node < 0 || node >= nodes)
      return invalidValue(where + " names node " + std::to_string(node) + ", but the net has nodes 0 to " +
                          std::to_string(nodes - 1));
  return {};
}

/// Adds a force to each of `count` nodes, and their velocities up.
ESM_CPU_CLONES void addToAll(std::size_t count, const Lanes* v, const Lanes& value, Lanes* force,
                             Lanes& sum) noexcept
{
  const Lanes each = value;
  const auto take = [=](std::size_t i, Lanes& to) noexcept {
    force[i] += each;
    to += v[i];
  };
  sumOver(count, take, sum);
}

ESM_CPU_CLONES void sumOfAll(std::size_t count, const Lanes* v, Lanes& sum) noexcept
{
  sumOver(
    count, [=](std::size_t i, Lanes& to) noexcept { to += v[i]; }, sum);
}

/// When nothing is left of the forces [s]; infinity if that is never, or there are none.
double endOf(const std::vector<NodalForce>& forces) noexcept
{
  constexpr double kNever = std::numeric_limits<double>::infinity();
  double end = -kNever;
  for (const NodalForce& force : forces) {
    Eigen::Index last = force.force.value.cols(); // from which on all values are zero
    while (last > 0 && force.force.value.col(last - 1).isZero(0.0)) --last;
    if (last == force.force.value.cols()) return kNever;
    if (last > 0) end = std::max(end, force.force.time[static_cast<std::size_t>(last)]);
  }
  return end > -kNever ? end : kNever;
}

} // namespace

Status checkLoads(const Loads& loads, Index nodes)
{
  if (!loads.gravity.allFinite()) return invalidValue("gravity is not a finite vector");
  for (std::size_t i = 0; i < loads.forces.size(); ++i) {
    const std::string where = "nodal force " + std::to_string(i);
    if (Status status = checkNodes(loads.forces[i].nodes, nodes, where); !status) return status;
    if (Status status = checkCurve(loads.forces[i].force, where); !status) return status;
  }
  std::vector<std::size_t> motionOf(static_cast<std::size_t>(nodes), loads.motions.size());
  for (std::size_t i = 0; i < loads.motions.size(); ++i) {
    const PrescribedMotion& motion = loads.motions[i];
    const std::string where = "motion " + std::to_string(i);
    if (Status status = checkNodes(motion.nodes, nodes, where); !status) return status;
    if (Status status = checkCurve(motion.displacement, where); !status) return status;
    if (motion.release && std::isnan(*motion.release))
      return invalidValue(where + ": the release time is not a number");
    for (const Index node : motion.nodes) {
      std::size_t& former = motionOf[static_cast<std::size_t>(node)];
      if (former < loads.motions.size() && former != i)
        return invalidValue("node " + std::to_string(node) + " is in motions " + std::to_string(former) +
                            " and " + std::to_string(i) + "; only one may move it");
      former = i;
    }
  }
  return {};
}

LoadSchedule::LoadSchedule(const Loads& loads, const Eigen::Matrix3Xd& start,
                           const std::vector<std::uint8_t>& fixed)
{
  for (const NodalForce& force : loads.forces) {
    Force& made = m_forces.emplace_back();
    made.force = force.force;
    for (const Index node : force.nodes) {
      const auto place = static_cast<std::size_t>(node);
      if (made.nodes.empty() || place != made.nodes.back().first + made.nodes.back().count)
        made.nodes.push_back({place, 0});
      ++made.nodes.back().count;
    }
    m_events.insert(m_events.end(), force.force.time.begin(), force.force.time.end());
  }
  std::vector<std::uint8_t> taken = fixed;
  for (const PrescribedMotion& motion : loads.motions) {
    Motion compiled;
    compiled.displacement = motion.displacement;
    if (motion.release) compiled.release = *motion.release;
    m_events.insert(m_events.end(), motion.displacement.time.begin(), motion.displacement.time.end());
    if (motion.release) m_events.push_back(*motion.release);
    for (const Index node : motion.nodes) {
      if (std::exchange(taken[static_cast<std::size_t>(node)], std::uint8_t{1})) continue;
      m_nodes.push_back({node, m_motions.size(), toLanes(start.col(node))});
    }
    m_motions.push_back(std::move(compiled));
  }
  if (loads.motions.empty()) m_endOfBlows = endOf(loads.forces);
  std::sort(m_events.begin(), m_events.end());
  m_events.erase(std::unique(m_events.begin(), m_events.end()), m_events.end());
}

void LoadSchedule::enter(double t) noexcept
{
  m_begin = t;
  for (Motion& motion : m_motions) {
    motion.active = t < motion.release;
    motion.line = {toLanes(motion.displacement.at(t)), toLanes(motion.displacement.slopeAt(t))};
  }
  for (Force& force : m_forces) {
    const Eigen::Vector3d value = force.force.at(t), slope = force.force.slopeAt(t);
    force.line = {toLanes(value), toLanes(slope)};
    force.absent = value.isZero(0.0) && slope.isZero(0.0);
  }
}

double LoadSchedule::nextEvent(double t) const noexcept
{
  const auto next = std::upper_bound(m_events.begin(), m_events.end(), t);
  return next == m_events.end() ? std::numeric_limits<double>::infinity() : *next;
}

double LoadSchedule::nextRelease() const noexcept
{
  double next = std::numeric_limits<double>::infinity();
  for (const Motion& motion : m_motions)
    if (motion.active) next = std::min(next, motion.release);
  return next;
}

bool LoadSchedule::movesAnyNow() const noexcept
{
  return std::any_of(m_motions.begin(), m_motions.end(), [](const Motion& motion) { return motion.active; });
}

void LoadSchedule::place(double t, Lanes* x, Lanes* v) const noexcept
{
  for (const PrescribedNode& node : m_nodes) {
    const Motion& motion = m_motions[node.motion];
    if (!motion.active) continue;
    x[node.node] = node.start + (motion.line.value + motion.line.slope * (t - m_begin));
    v[node.node] = motion.line.slope;
  }
}

/// @param visit  visit(run, force on each of its nodes, sum): sets the sum of their velocities.
/// @return the power of all nodal forces [W]
template <class Visit>
double LoadSchedule::forEachRun(double t, const Visit& visit) const noexcept
{
  double power = 0.0;
  for (const Force& load : m_forces) {
    if (load.absent) continue;
    const Lanes value = load.line.value + load.line.slope * (t - m_begin);
    Lanes sum;
    for (const NodeRun& run : load.nodes) {
      visit(run, value, sum);
      power += dot(value, sum);
    }
  }
  return power;
}

double LoadSchedule::addForces(double t, const Lanes* v, Lanes* force) const noexcept
{
  return forEachRun(t, [&](const NodeRun& run, const Lanes& value, Lanes& sum) noexcept {
    addToAll(run.count, v + run.first, value, force + run.first, sum);
  });
}

double LoadSchedule::power(double t, const Lanes* v) const noexcept
{
  return forEachRun(t, [&](const NodeRun& run, const Lanes&, Lanes& sum) noexcept {
    sumOfAll(run.count, v + run.first, sum);
  });
}

} // namespace esm
